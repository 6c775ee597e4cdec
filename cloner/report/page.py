"""The report as one small page for people; pictures lie beside it."""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from html import escape
from typing import Any, Final

from cloner.frames import ViewId
from cloner.report.details import details, folded, number, table_of, words_of
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
        details(report),
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
        text = text.replace(view, words_of(view))
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
    return folded("Points and outlines in the photos", key + _figures(found)) if found else ""


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
        words = escape(_CAPTIONS.get(stem, words_of(stem)))
        wide = ' class="wide"' if stem in _WIDE else ""
        picture = f'<a href="{escape(file)}"><img src="{escape(file)}" alt="{words}"></a>'
        figures.append(f"<figure{wide}>{picture}<figcaption>{words}</figcaption></figure>")
    return f'<div class="pictures">{"".join(figures)}</div>'


def _body(report: Mapping[str, Any]) -> str:
    measures = report["measures_mm"]
    rows = [_measure_row(name, measure) for name, measure in measures["values"].items()]
    girths = [row for row in rows if row[1].endswith("girth")]
    lengths = [row for row in rows if not row[1].endswith("girth")]
    head = ("", "name", "mm", "", "over clothes", "")
    sides = [
        f"{words_of(view)} shows the {side} side" for view, side in report["side_shown"].items() if side is not None
    ]
    shown = f"<p>{escape('; '.join(sides))}.</p>" if sides else ""
    paragraphs = "".join(f"<p>{escape(text)}</p>" for text in (*measures["clothes"]["words"], measures["note"]))
    tables = table_of(head, girths, caption="Girths") + folded(
        "Heights and lengths", table_of(head, lengths, caption="")
    )
    return f"<h2>Measures</h2>{tables}{paragraphs}{shown}"


def _measure_row(name: str, measure: Mapping[str, Any]) -> tuple[str, ...]:
    return (
        measure["words"],
        words_of(name),
        number(measure["value"]),
        "" if measure["plus_minus"] is None else f"± {measure['plus_minus']:.0f}",
        "" if measure["over_clothes"] is None else number(measure["over_clothes"]),
        "by tape" if measure["taped"] else "",
    )
