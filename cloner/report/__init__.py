"""What is told about a finished clone: ``report.json`` and ``report.html``."""
