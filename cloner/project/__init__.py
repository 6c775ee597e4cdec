"""The project folder: photos, corrections, results; the only part that knows paths."""
