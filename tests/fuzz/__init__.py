"""Input that nobody thought of: by hypothesis in every run, by coverage or blind mutation for as long as asked."""
