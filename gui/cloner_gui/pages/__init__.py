"""One file per page: each reads the session and sends edits to it."""
