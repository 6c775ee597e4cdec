"""One file, one stage, one ``run``."""
