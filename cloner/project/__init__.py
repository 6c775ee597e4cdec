"""The project folder: photos, corrections, results; the only room that knows paths."""
