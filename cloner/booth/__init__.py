"""The booth's rules without its window: an event's folder, with one folder for every visitor."""
