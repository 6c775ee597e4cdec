"""The report as one small page for people; pictures lie beside it."""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from html import escape
from typing import Any, Final

from cloner.frames import ViewId
from cloner.report.policy import PAGE, policy
from cloner.report.viewer import FILE as VIEWER

_STYLE: Final = """
:root { color-scheme: light dark; --line: #8884; --soft: #8881; --warn: #c70; }
body { font: 16px/1.5 system-ui, sans-serif; max-width: 70rem; margin: 1.5rem auto; padding: 0 1rem; }
h1 { margin: 0; } h2 { margin: 2rem 0 .4rem; } .lead { margin: .1rem 0 1rem; opacity: .8; }
table { border-collapse: collapse; margin: .6rem 0; } caption { text-align: left; opacity: .8; padding-bottom: .3rem; }
th, td { text-align: left; padding: .2rem 1.2rem .2rem 0; border-bottom: 1px solid var(--soft); vertical-align: top; }
td.n { text-align: right; font-variant-numeric: tabular-nums; }
.notes { border-left: 4px solid var(--warn); background: var(--soft); padding: .5rem 1rem; margin: 1rem 0; }
.notes ul { margin: .2rem 0; padding-left: 1.2rem; } .notes p { margin: 0; }
.pictures { display: flex; flex-wrap: wrap; gap: 1rem; margin: 1rem 0; }
figure { margin: 0; max-width: 100%; } figure.wide { flex-basis: 100%; }
figure img { display: block; max-width: 100%; height: 20rem; object-fit: contain; }
figure.wide img { height: auto; max-height: 36rem; } figure img { object-position: left; }
iframe { width: 100%; height: 34rem; border: 1px solid var(--line); border-radius: .5rem; }
figcaption { font-size: .9rem; opacity: .8; } summary { cursor: pointer; padding: .4rem 0; font-weight: 600; }
details { border-bottom: 1px solid var(--line); } details details summary { font-weight: 400; }
details details { border: 0; margin-left: 1rem; } code { font-size: .85em; overflow-wrap: anywhere; }
"""
_PICTURES: Final = (".png", ".jpg")
#: What the pictures show, in the order in which people want to see them; those not named come last.
_CAPTIONS: Final = {
    "three_quarter": "The clone from four sides, softly lit",
    "face": "The face of the clone, unlit, as the photos show it",
    "beside_face_front": "Photo and clone: face, front",
    "beside_face_side": "Photo and clone: face, side",
    "beside_body_front": "Photo and clone: body, front",
    "beside_body_side": "Photo and clone: body, side",
    "beside_body_back": "Photo and clone: body, back",
    "head": "The head from the sides and behind",
}
_WIDE: Final = ("three_quarter", "face", "head")
#: What the downloads are for.
_FILES: Final = {
    "clone.glb": "for Blender, Unity, Unreal, web pages",
    VIEWER: "the clone to look at in any browser, alone in one file",
    "clone.wrl": "VRML97, one seamless skin that walks",
    "clone_hanim.wrl": "VRML97 with H-Anim 1.1",
    "clone.obj": "rest pose",
    "clone.ply": "rest pose",
    "clone.npz": "for cloner render",
    "report.json": "this page's numbers",
}


#: What the kinds of corrected points mean.
CORRECTIONS_CAPTION = (
    "outline: the skin was bent until the clone's outline passes through the point; pose: the limb was turned in this "
    "photo until the joint lies there, the body at rest stays; scale: head top and soles set the photo's scale."
)


def page(report: Mapping[str, Any]) -> str:
    """Return the HTML of a report; it loads nothing but the pictures and the viewer beside it."""
    person = report["person"]
    title = person["name"] or person["identifier"]
    parts = [
        f"<h1>Clone of {escape(title)}</h1>",
        f'<p class="lead">{escape(_summary(report))}</p>',
        _warnings(report["warnings"]),
        _viewer(report["files"]),
        _pictures(report["files"]),
        _downloads(report["files"]),
        _body(report),
        "<h2>Details</h2>",
        _overlays(report["files"]),
        _agreement(report),
        _corrections(report["corrections"]),
        _features(report["features"], report["outline_segments"]),
        _residuals(report["residuals"]),
        _timings(report["timings"], report["peak_mib"]),
        _origins(report),
    ]
    return (
        '<!doctype html>\n<html lang="en"><head><meta charset="utf-8">'
        '<meta name="viewport" content="width=device-width, initial-scale=1">'
        f"{policy(PAGE)}<title>Clone of {escape(title)}</title><style>{_STYLE}</style></head>\n<body>\n"
        + "\n".join(part for part in parts if part)
        + "\n</body></html>\n"
    )


def _summary(report: Mapping[str, Any]) -> str:
    stature = report["stature"]
    height = f"{stature['value_m'] * 100:.1f} cm barefoot"
    if not stature["known"]:
        height += " (assumed: no height was given)"
    count = len(report["photos"])
    photos = "one photo" if count == 1 else f"{count} photos"
    return f"{height} · cloned from {photos} in {report['timings']['seconds']:.0f} s"


def _warnings(warnings: Sequence[str]) -> str:
    if not warnings:
        return ""
    items = "".join(f"<li>{escape(_sentence(warning))}</li>" for warning in warnings)
    return f'<div class="notes"><p>Please note:</p><ul>{items}</ul></div>'


def _sentence(text: str) -> str:
    """Return a note as a sentence; stages write some of them as clauses, with the views' names."""
    for view in ViewId:
        text = text.replace(view, _words(view))
    return f"{text[:1].upper()}{text[1:]}{'' if text.endswith('.') else '.'}"


def _downloads(files: Iterable[str]) -> str:
    links = [
        f'<li><a href="{escape(file)}">{escape(file)}</a> {escape(_FILES[file])}</li>'
        for file in files
        if file in _FILES
    ]
    return f"<h2>Files</h2><ul>{''.join(links)}</ul>" if links else ""


def _viewer(files: Iterable[str]) -> str:
    """Return the frame in which the clone turns, if it was written as glTF."""
    if VIEWER not in files:
        return ""
    return f'<iframe src="{VIEWER}" title="The clone, to be turned by hand" loading="lazy"></iframe>'


def _pictures(files: Iterable[str]) -> str:
    """Return the pictures of the clone, alone and beside the photos."""
    shown = [file for file in _previews(files) if "overlay" not in file]
    return _figures(shown) if shown else ""


def _overlays(files: Iterable[str]) -> str:
    """Return the folded pictures of what was found in the photos."""
    found = [file for file in _previews(files) if "overlay" in file]
    key = (
        "<p>Green: the outline found in the photo. Magenta: the clone's outline. Circles: feature points, "
        "yellow where an operator placed them.</p>"
    )
    return _folded("Points and outlines in the photos", key + _figures(found)) if found else ""


def _previews(files: Iterable[str]) -> list[str]:
    found = [file for file in files if file.startswith("previews/") and file.endswith(_PICTURES)]
    order = list(_CAPTIONS)
    return sorted(found, key=lambda file: order.index(_stem(file)) if _stem(file) in order else len(order))


def _stem(file: str) -> str:
    return file.rsplit("/", 1)[-1].rsplit(".", 1)[0]


def _figures(files: Iterable[str]) -> str:
    figures = []
    for file in files:
        stem = _stem(file)
        words = escape(_CAPTIONS.get(stem, _words(stem)))
        wide = ' class="wide"' if stem in _WIDE else ""
        picture = f'<a href="{escape(file)}"><img src="{escape(file)}" alt="{words}"></a>'
        figures.append(f"<figure{wide}>{picture}<figcaption>{words}</figcaption></figure>")
    return f'<div class="pictures">{"".join(figures)}</div>'


def _folded(title: str, content: str) -> str:
    return f"<details><summary>{escape(title)}</summary>{content}</details>"


def _body(report: Mapping[str, Any]) -> str:
    measures = report["measures_mm"]
    rows = [_measure_row(name, measure) for name, measure in measures["values"].items()]
    girths = [row for row in rows if row[1].endswith("girth")]
    lengths = [row for row in rows if not row[1].endswith("girth")]
    head = ("", "name", "mm", "", "over clothes", "")
    sides = [f"{_words(view)} shows the {side} side" for view, side in report["side_shown"].items() if side is not None]
    shown = f"<p>{escape('; '.join(sides))}.</p>" if sides else ""
    told = "".join(f"<p>{escape(text)}</p>" for text in (*measures["clothes"]["words"], measures["note"]))
    tables = _table(head, girths, caption="Girths") + _folded("Heights and lengths", _table(head, lengths, caption=""))
    return f"<h2>Measures</h2>{tables}{told}{shown}"


def _measure_row(name: str, measure: Mapping[str, Any]) -> tuple[str, ...]:
    return (
        measure["words"],
        _words(name),
        _number(measure["value"]),
        "" if measure["plus_minus"] is None else f"± {measure['plus_minus']:.0f}",
        "" if measure["over_clothes"] is None else _number(measure["over_clothes"]),
        "by tape" if measure["taped"] else "",
    )


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
    table = _table(("photo", "overlap", "px", "mm"), rows, caption=caption)
    return _folded("Agreement with the photos", table) if rows else ""


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
    return _folded("Corrected points", _table(head, rows, caption=CORRECTIONS_CAPTION)) if rows else ""


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
        parts.append(_folded(title, table))
    for view, pieces in segments.items():
        lines = [
            (_words(piece["segment"]), _OUTLINE_SOURCES[piece["source"]], f"{piece['goodness']:.2f}")
            for piece in pieces
        ]
        linked = sum(piece["source"] == "edges" for piece in pieces)
        title = f"{_words(view)}: {linked} of {len(pieces)} outline pieces from edges"
        table = _table(("piece", "source", "goodness"), lines, caption="")
        parts.append(_folded(title, table))
    return _folded("Feature points and outline pieces", "".join(parts)) if parts else ""


def _residuals(residuals: Iterable[Mapping[str, Any]]) -> str:
    rows = [
        (each["stage"], _words(each["name"]), _words(each["view"] or "all"), _number(each["value"]), each["unit"])
        for each in residuals
    ]
    table = _table(("stage", "what", "photo", "value", "unit"), rows, caption="")
    return _folded("Residuals of every stage", table) if rows else ""


def _timings(timings: Mapping[str, Any], peak_mib: float) -> str:
    rows = [
        (stage["stage"], _number(stage["seconds"]), _number(stage["cpu_seconds"]), f"{stage['peak_mib']:.0f}")
        for stage in timings["stages"]
    ]
    rows.append(("all", _number(timings["seconds"]), _number(timings["cpu_seconds"]), f"{peak_mib:.0f}"))
    return _folded("Time and memory", _table(("stage", "s", "CPU s", "peak MiB"), rows, caption=""))


def _origins(report: Mapping[str, Any]) -> str:
    libraries = _table(("part", "version"), list(report["versions"].items()), caption="")
    models = [(name, f"{digest[:16]}…") for name, digest in report["models"].items()]
    table = _table(("model file", "sha256"), models, caption="")
    return _folded("Versions and models", libraries + table)


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
