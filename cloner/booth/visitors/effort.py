"""The operator's effort per visitor: seconds, clicks and drags, one row each, no names."""

from __future__ import annotations

import csv
import io
from collections.abc import Mapping
from pathlib import Path
from statistics import median
from typing import Final

from cloner.booth.visitors.visits import Visit

COLUMNS: Final = ("visitor", "started", "state", "seconds", "clicks", "drags", "clone_seconds")


def effort_rows(visits: Mapping[Path, Visit]) -> list[tuple[str, ...]]:
    """Return one row per visitor, with columns `COLUMNS`."""
    return [
        (
            folder.name,
            visit.started[:16].replace("T", " "),
            str(visit.state),
            f"{visit.seconds:.0f}",
            str(visit.clicks),
            str(visit.drags),
            f"{visit.clone_seconds:.0f}",
        )
        for folder, visit in visits.items()
    ]


def median_effort(visits: Mapping[Path, Visit]) -> tuple[float, float, float]:
    """Return the medians of seconds, clicks and drags; zeros without visitors."""
    seen = list(visits.values())
    if not seen:
        return 0.0, 0.0, 0.0
    return median(v.seconds for v in seen), median(v.clicks for v in seen), median(v.drags for v in seen)


def effort_csv(visits: Mapping[Path, Visit]) -> str:
    """Return the rows as CSV."""
    stream = io.StringIO()
    writer = csv.writer(stream, lineterminator="\n")
    writer.writerow(COLUMNS)
    writer.writerows(effort_rows(visits))
    return stream.getvalue()
