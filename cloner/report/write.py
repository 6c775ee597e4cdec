"""Put a report into a result's folder, as a page and as numbers."""

from __future__ import annotations

import json
from collections.abc import Mapping
from pathlib import Path
from typing import Any

from cloner.report.page import page


def write_report(report: Mapping[str, Any], folder: Path) -> Path:
    """Write ``report.json``, the manifest of a result, into its folder and return the path; the last file of all."""
    path = folder / "report.json"
    path.write_text(json.dumps(report, indent=1, ensure_ascii=False, allow_nan=False) + "\n", encoding="utf-8")
    return path


def write_page(report: Mapping[str, Any], folder: Path) -> Path:
    """Write ``report.html`` into a folder and return its path."""
    shown = folder / "report.html"
    shown.write_text(page(report), encoding="utf-8")
    return shown
