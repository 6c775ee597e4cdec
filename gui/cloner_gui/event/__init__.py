"""The open event in the window: visitors, session, queue, photos on their way in, files on their way out."""
