"""Reports on a finished clone: ``report.json`` and ``report.html``."""
