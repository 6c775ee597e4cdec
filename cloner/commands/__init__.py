"""The command line's commands: what each is asked and what it says; the work lies in the rooms."""
