"""The commands of the command line: their options and messages; the work is done in the rooms."""
