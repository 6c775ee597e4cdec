"""The open event in the window: visitors, session, queue, incoming photos, outgoing files."""
