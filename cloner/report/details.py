"""The folded tables of the report's page."""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from html import escape
from typing import Any

#: What the kinds of corrected points mean.
CORRECTIONS_CAPTION = (
    "outline: the skin was bent until the clone's outline passes through the point; pose: the limb was turned in this "
    "photo until the joint lies there, the body at rest stays; scale: head top and soles set the photo's scale."
)


def details(report: Mapping[str, Any]) -> str:
    """Return the folded tables: agreement, corrected points, feature points, residuals, times, versions."""
    parts = (
        _agreement(report),
        _corrections(report["corrections"]),
        _features(report["features"], report["outline_segments"]),
        _residuals(report["residuals"]),
        _timings(report["timings"], report["peak_mib"]),
        _origins(report),
    )
    return "\n".join(part for part in parts if part)


def folded(title: str, content: str) -> str:
    """Return content that opens with a click on its title."""
    return f"<details><summary>{escape(title)}</summary>{content}</details>"


def _agreement(report: Mapping[str, Any]) -> str:
    rows = [
        (
            words_of(view),
            f"{iou:.3f}",
            number(report["outline_rms"][view]["px"]),
            number(report["outline_rms"][view]["mm"]),
        )
        for view, iou in report["silhouette_iou"].items()
    ]
    caption = "The clone, seen through each photo's camera, against the outline found in that photo"
    table = table_of(("photo", "overlap", "px", "mm"), rows, caption=caption)
    return folded("Agreement with the photos", table) if rows else ""


def _corrections(corrections: Sequence[Mapping[str, Any]]) -> str:
    """Return the table of corrected points, empty when nobody corrected any."""
    rows = [
        (
            c["view"],
            c["name"],
            c["kind"],
            f"{c['px_before']:.1f}",
            f"{c['px_after']:.1f}",
            f"{c['moved_mm']:.0f}",
            c["note"],
        )
        for c in corrections
    ]
    head = ("photo", "point", "kind", "px off before", "px off after", "moved mm", "note")
    return folded("Corrected points", table_of(head, rows, caption=CORRECTIONS_CAPTION)) if rows else ""


#: What won a piece of the outline.
_OUTLINE_SOURCES = {
    "edges": "edges linked in the photo",
    "mask": "border of the person mask: no convincing edges",
}


def _features(features: Mapping[str, Any], segments: Mapping[str, Any]) -> str:
    parts = []
    for view, named in features.items():
        corrected = sum(point["source"] == "corrected" for point in named.values())
        rows = [
            (
                words_of(name),
                number(point["x_px"]),
                number(point["y_px"]),
                f"{point['confidence']:.2f}",
                str(point["source"]),
            )
            for name, point in named.items()
        ]
        title = f"{words_of(view)}: {len(named)} points, {corrected} corrected"
        table = table_of(("point", "x px", "y px", "confidence", "source"), rows, caption="")
        parts.append(folded(title, table))
    for view, pieces in segments.items():
        lines = [
            (words_of(piece["segment"]), _OUTLINE_SOURCES[piece["source"]], f"{piece['goodness']:.2f}")
            for piece in pieces
        ]
        linked = sum(piece["source"] == "edges" for piece in pieces)
        title = f"{words_of(view)}: {linked} of {len(pieces)} outline pieces from edges"
        table = table_of(("piece", "source", "goodness"), lines, caption="")
        parts.append(folded(title, table))
    return folded("Feature points and outline pieces", "".join(parts)) if parts else ""


def _residuals(residuals: Iterable[Mapping[str, Any]]) -> str:
    rows = [
        (each["stage"], words_of(each["name"]), words_of(each["view"] or "all"), number(each["value"]), each["unit"])
        for each in residuals
    ]
    table = table_of(("stage", "what", "photo", "value", "unit"), rows, caption="")
    return folded("Residuals of every stage", table) if rows else ""


def _timings(timings: Mapping[str, Any], peak_mib: float) -> str:
    rows = [
        (stage["stage"], number(stage["seconds"]), number(stage["cpu_seconds"]), f"{stage['peak_mib']:.0f}")
        for stage in timings["stages"]
    ]
    rows.append(("all", number(timings["seconds"]), number(timings["cpu_seconds"]), f"{peak_mib:.0f}"))
    return folded("Time and memory", table_of(("stage", "s", "CPU s", "peak MiB"), rows, caption=""))


def _origins(report: Mapping[str, Any]) -> str:
    libraries = table_of(("part", "version"), list(report["versions"].items()), caption="")
    models = [(name, f"{digest[:16]}…") for name, digest in report["models"].items()]
    table = table_of(("model file", "sha256"), models, caption="")
    return folded("Versions and models", libraries + table)


def table_of(head: Sequence[str], rows: Iterable[Sequence[str]], *, caption: str) -> str:
    """Return a table; cells that begin with a digit stand at the right."""
    top = "".join(f"<th>{escape(cell)}</th>" for cell in head)
    body = "".join("<tr>" + "".join(_cell(cell) for cell in row) + "</tr>" for row in rows)
    caption_html = f"<caption>{escape(caption)}</caption>" if caption else ""
    return f"<table>{caption_html}<thead><tr>{top}</tr></thead><tbody>{body}</tbody></table>"


def _cell(text: str) -> str:
    numeric = text[:1].isdigit() or text[:1] in {"-", "±"}
    return f"<td{' class=n' if numeric else ''}>{escape(text)}</td>"


def number(value: float) -> str:
    """Return a figure with as many digits as matter."""
    return f"{value:.0f}" if abs(value) >= 100 else f"{value:.1f}" if abs(value) >= 10 else f"{value:.2f}"


def words_of(name: str) -> str:
    """Return a name as words."""
    return name.replace("_", " ")
