"""Summary of a batch: JSON, CSV, and a sheet of pictures with the worst first."""

from __future__ import annotations

import csv
import io
import json
from collections.abc import Sequence
from dataclasses import asdict, fields
from html import escape
from pathlib import Path
from typing import Any, Final
from urllib.parse import quote

from cloner.errors import printable
from cloner.project.atomic import write_text
from cloner.records.batches import FAILED, BatchRow
from cloner.report.policy import PAGE, policy

_STYLE: Final = """
:root { color-scheme: light dark; } body { font: 16px/1.4 system-ui, sans-serif; margin: 1.5rem; }
ul { display: grid; grid-template-columns: repeat(auto-fill, minmax(20rem, 1fr)); gap: 1rem; padding: 0; }
li { list-style: none; border: 1px solid #8884; border-radius: .5rem; padding: .6rem; }
li.failed { border-color: #c30; } img { width: 100%; height: 12rem; object-fit: contain; }
h2 { font-size: 1rem; margin: .2rem 0; overflow-wrap: anywhere; } p { margin: .2rem 0; overflow-wrap: anywhere; }
"""
_PICTURE: Final = "previews/three_quarter.jpg"


def write_summary(rows: Sequence[BatchRow], wanted: int, out: Path, name: str = "batch") -> tuple[Path, ...]:
    """Write ``<name>.json``, ``.csv`` and ``.html`` into a folder and return their paths.

    Raises
    ------
    ClonerError
        If the folder cannot be written to.
    """
    data: dict[str, Any] = {"format": 1, "visitors": wanted, "rows": [asdict(row) for row in rows]}
    texts = {
        "json": json.dumps(data, indent=1, ensure_ascii=False) + "\n",
        "csv": _table(rows),
        "html": _sheet(rows, wanted, out),
    }
    paths = tuple(out / f"{name}.{suffix}" for suffix in texts)
    for path, text in zip(paths, texts.values(), strict=True):
        write_text(path, text)
    return paths


def worst_first(rows: Sequence[BatchRow]) -> list[BatchRow]:
    """Return failed visitors, then the others by their worst overlap in a photo; unmeasured ones last."""
    return sorted(rows, key=lambda row: (row.status != FAILED, row.worst_iou is None, row.worst_iou or 0.0))


def _table(rows: Sequence[BatchRow]) -> str:
    stream = io.StringIO()
    writer = csv.writer(stream, lineterminator="\n")
    writer.writerow([field.name for field in fields(BatchRow)])
    for row in rows:
        writer.writerow([_cell(value) for value in asdict(row).values()])
    return stream.getvalue()


def _cell(value: object) -> object:
    """Return a value that no spreadsheet takes for a formula or a new row."""
    if not isinstance(value, str):
        return value
    text = printable(value)
    return f"'{text}" if text.lstrip()[:1] in tuple("=+-@") else text


def _sheet(rows: Sequence[BatchRow], wanted: int, out: Path) -> str:
    cards = "\n".join(_card(row, out) for row in worst_first(rows))
    failed = sum(row.status == FAILED for row in rows)
    return (
        '<!doctype html>\n<html lang="en"><head><meta charset="utf-8">'
        f"{policy(PAGE)}<title>Batch</title><style>{_STYLE}</style></head>\n"
        f"<body><h1>{len(rows)} of {wanted} visitors, {failed} failed</h1>\n"
        f"<ul>\n{cards}\n</ul></body></html>\n"
    )


def _card(row: BatchRow, out: Path) -> str:
    folder = quote(row.identifier)
    shown = (out / row.identifier / _PICTURE).is_file()
    picture = (
        f'<a href="{folder}/report.html"><img loading="lazy" src="{folder}/{_PICTURE}" alt=""></a>' if shown else ""
    )
    overlap = "" if row.worst_iou is None else f"<p>worst overlap with a photo {row.worst_iou:.3f}</p>"
    return (
        f'<li class="{row.status}">{picture}<h2>{escape(row.identifier)}</h2>'
        f"<p>{row.status}: {escape(row.message)}</p>{overlap}</li>"
    )
