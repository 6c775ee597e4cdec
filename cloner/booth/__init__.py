"""A day at a booth: one folder for the event, one inside it for every visitor. All its rules, and no window."""
