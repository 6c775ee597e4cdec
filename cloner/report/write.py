"""Put a report into a result's folder."""

from __future__ import annotations

import json
from collections.abc import Mapping
from pathlib import Path
from typing import Any

from cloner.report.page import page


def write_report(report: Mapping[str, Any], folder: Path) -> tuple[Path, ...]:
    """Write ``report.json`` and ``report.html`` into a folder and return their paths."""
    told, shown = folder / "report.json", folder / "report.html"
    told.write_text(json.dumps(report, indent=1, ensure_ascii=False, allow_nan=False) + "\n", encoding="utf-8")
    shown.write_text(page(report), encoding="utf-8")
    return told, shown
