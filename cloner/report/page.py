"""The report as one small page for people; pictures lie beside it."""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from html import escape
from typing import Any, Final

_STYLE: Final = """
:root { color-scheme: light dark; --line: #8884; --soft: #8881; --warn: #b60; }
body { font: 16px/1.5 system-ui, sans-serif; max-width: 62rem; margin: 2rem auto; padding: 0 1rem; }
h1 { margin-bottom: 0; } h2 { margin-top: 2.2rem; border-bottom: 1px solid var(--line); }
.lead { margin-top: .2rem; opacity: .8; }
table { border-collapse: collapse; margin: .6rem 0; } caption { text-align: left; opacity: .8; }
th, td { text-align: left; padding: .2rem .9rem .2rem 0; border-bottom: 1px solid var(--soft); vertical-align: top; }
td.n { text-align: right; font-variant-numeric: tabular-nums; }
.warnings li { border-left: 3px solid var(--warn); padding-left: .6rem; margin: .4rem 0; list-style: none; }
.pictures { display: flex; flex-wrap: wrap; gap: 1rem; align-items: flex-end; margin: .8rem 0; }
figure { margin: 0; } figure img { display: block; max-width: 100%; max-height: 24rem; border-radius: 4px; }
figcaption { font-size: .85rem; opacity: .8; } details { margin: .6rem 0; } summary { cursor: pointer; }
code { font-size: .85em; overflow-wrap: anywhere; }
"""
_PICTURES: Final = (".png", ".jpg")
#: Order in which people want to see them; what is not named comes last.
_FIRST: Final = ("_body_front", "_body_side", "_body_back", "three_quarter", "_face_front", "_face_side", "face")


def page(report: Mapping[str, Any]) -> str:
    """Return the HTML of a report; it loads nothing but the pictures beside it."""
    person = report["person"]
    title = person["name"] or person["identifier"]
    parts = [
        f"<h1>{escape(title)}</h1>",
        f'<p class="lead">{escape(_summary(report))}</p>',
        _warnings(report["warnings"]),
        _downloads(report["files"]),
        _pictures(report["files"]),
        _body(report),
        _agreement(report),
        _features(report["features"], report["outline_segments"]),
        _residuals(report["residuals"]),
        _timings(report["timings"], report["peak_mib"]),
        _origins(report),
    ]
    return (
        '<!doctype html>\n<html lang="en"><head><meta charset="utf-8">'
        '<meta name="viewport" content="width=device-width, initial-scale=1">'
        f"<title>{escape(title)} - Cloner</title><style>{_STYLE}</style></head>\n<body>\n"
        + "\n".join(part for part in parts if part)
        + "\n</body></html>\n"
    )


def _summary(report: Mapping[str, Any]) -> str:
    stature = report["stature"]
    height = f"{stature['value_m'] * 100:.1f} cm barefoot"
    if not stature["known"]:
        height += " (assumed: no height was given)"
    return f"{height}, cloned from {len(report['photos'])} photos in {report['timings']['seconds']:.0f} s"


def _warnings(warnings: Sequence[str]) -> str:
    if not warnings:
        return "<p>No warnings.</p>"
    items = "".join(f"<li>{escape(warning)}</li>" for warning in warnings)
    return f'<h2>Please note</h2><ul class="warnings">{items}</ul>'


def _downloads(files: Iterable[str]) -> str:
    links = [f'<a href="{escape(file)}">{escape(file)}</a>' for file in files if "/" not in file]
    return "<p>" + " · ".join(links) + "</p>" if links else ""


def _pictures(files: Iterable[str]) -> str:
    """Return the pictures of the clone, and folded below them those of what was found in the photos."""
    previews = [file for file in files if file.startswith("previews/") and file.endswith(_PICTURES)]
    previews.sort(key=_place)
    found = [file for file in previews if "overlay" in file]
    shown = [file for file in previews if file not in found]
    folded = (
        f"<details><summary>Points and outlines in the photos</summary>{_figures(found)}</details>" if found else ""
    )
    return f"<h2>Pictures</h2>{_figures(shown)}{folded}" if shown else ""


def _place(file: str) -> int:
    return next((place for place, word in enumerate(_FIRST) if word in file), len(_FIRST))


def _figures(files: Iterable[str]) -> str:
    figures = "".join(
        f'<figure><a href="{escape(file)}"><img src="{escape(file)}" alt="" loading="lazy"></a>'
        f"<figcaption>{escape(_words(file.rsplit('/', 1)[-1].rsplit('.', 1)[0]))}</figcaption></figure>"
        for file in files
    )
    return f'<div class="pictures">{figures}</div>'


def _body(report: Mapping[str, Any]) -> str:
    girths = report["girths_mm"]
    rows = [
        (_words(name), _number(girth["value"]), "" if girth["plus_minus"] is None else f"± {girth['plus_minus']:.0f}")
        for name, girth in girths["values"].items()
    ]
    sides = [f"{_words(view)} shows the {side} side" for view, side in report["side_shown"].items() if side is not None]
    shown = f"<p>{escape('; '.join(sides))}.</p>" if sides else ""
    note = f"<p>{escape(girths['note'])}</p>"
    return f"<h2>Measures</h2>{_table(('girth', 'mm', ''), rows, caption='')}{note}{shown}"


def _agreement(report: Mapping[str, Any]) -> str:
    rows = [
        (
            _words(view),
            f"{iou:.3f}",
            _number(report["outline_rms"][view]["px"]),
            _number(report["outline_rms"][view]["mm"]),
        )
        for view, iou in report["silhouette_iou"].items()
    ]
    caption = "The clone, seen through each photo's camera, against the outline found in that photo"
    return "<h2>Agreement with the photos</h2>" + _table(("photo", "overlap", "px", "mm"), rows, caption=caption)


def _features(features: Mapping[str, Any], segments: Mapping[str, Any]) -> str:
    parts = []
    for view, named in features.items():
        corrected = sum(point["source"] == "corrected" for point in named.values())
        rows = [
            (
                _words(name),
                _number(point["x_px"]),
                _number(point["y_px"]),
                f"{point['confidence']:.2f}",
                str(point["source"]),
            )
            for name, point in named.items()
        ]
        title = f"{_words(view)}: {len(named)} points, {corrected} corrected"
        table = _table(("point", "x px", "y px", "confidence", "source"), rows, caption="")
        parts.append(f"<details><summary>{escape(title)}</summary>{table}</details>")
    for view, pieces in segments.items():
        lines = [(str(piece["segment"]), str(piece["source"]), f"{piece['goodness']:.2f}") for piece in pieces]
        linked = sum(piece["source"] == "edges" for piece in pieces)
        title = f"{_words(view)}: {linked} of {len(pieces)} outline pieces from edges"
        table = _table(("piece", "source", "goodness"), lines, caption="")
        parts.append(f"<details><summary>{escape(title)}</summary>{table}</details>")
    return "<h2>Points and outlines</h2>" + "".join(parts) if parts else ""


def _residuals(residuals: Iterable[Mapping[str, Any]]) -> str:
    rows = [
        (each["stage"], _words(each["name"]), _words(each["view"] or "all"), _number(each["value"]), each["unit"])
        for each in residuals
    ]
    return "<h2>Residuals</h2>" + _table(("stage", "what", "photo", "value", "unit"), rows, caption="") if rows else ""


def _timings(timings: Mapping[str, Any], peak_mib: float) -> str:
    rows = [
        (stage["stage"], _number(stage["seconds"]), _number(stage["cpu_seconds"]), f"{stage['peak_mib']:.0f}")
        for stage in timings["stages"]
    ]
    rows.append(("all", _number(timings["seconds"]), _number(timings["cpu_seconds"]), f"{peak_mib:.0f}"))
    return "<h2>Time and memory</h2>" + _table(("stage", "s", "CPU s", "peak MiB"), rows, caption="")


def _origins(report: Mapping[str, Any]) -> str:
    libraries = _table(("part", "version"), list(report["versions"].items()), caption="")
    models = [(name, f"{digest[:16]}…") for name, digest in report["models"].items()]
    table = _table(("model file", "sha256"), models, caption="")
    return f"<details><summary>Versions and models</summary>{libraries}{table}</details>"


def _table(head: Sequence[str], rows: Iterable[Sequence[str]], *, caption: str) -> str:
    top = "".join(f"<th>{escape(cell)}</th>" for cell in head)
    body = "".join("<tr>" + "".join(_cell(cell) for cell in row) + "</tr>" for row in rows)
    told = f"<caption>{escape(caption)}</caption>" if caption else ""
    return f"<table>{told}<thead><tr>{top}</tr></thead><tbody>{body}</tbody></table>"


def _cell(text: str) -> str:
    numeric = text[:1].isdigit() or text[:1] in {"-", "±"}
    return f"<td{' class=n' if numeric else ''}>{escape(text)}</td>"


def _number(value: float) -> str:
    return f"{value:.0f}" if abs(value) >= 100 else f"{value:.1f}" if abs(value) >= 10 else f"{value:.2f}"


def _words(name: str) -> str:
    return name.replace("_", " ")
