"""One file a page: each reads the session and sends edits to it."""
