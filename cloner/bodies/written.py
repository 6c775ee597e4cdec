"""A body as a result folder, written atomically."""

from __future__ import annotations

import hashlib
import json
from collections.abc import Mapping, Sequence
from dataclasses import replace
from pathlib import Path
from typing import Final

from cloner.bodies.children import USUAL_AGE
from cloner.bodies.made import clone_of_measures, remeasured_clone
from cloner.bodies.ruler import read
from cloner.bodies.telling import GIRTHS, LENGTHS, BodySpecification, untold_mm
from cloner.errors import ClonerError
from cloner.exporters.table import check_formats
from cloner.generic.tape import load_tape_rules
from cloner.making import check_texture_size
from cloner.picture import load_clone_at
from cloner.pipeline import Progress, no_progress
from cloner.project.atomic import result_folder
from cloner.project.folder import safe_identifier
from cloner.project.results import RESULT_MARK
from cloner.project.stamps import stamp_text
from cloner.project.tape import read_tape
from cloner.records.clones import Clone
from cloner.report.derived import make_manifest, write_result

WHERE: Final = "--measure"


def body_folder(
    out: Path,
    identifier: str,
    *,
    sex: str,
    stature_cm: float | None,
    measures_cm: Mapping[str, float],
    formats: Sequence[str],
    texture_size: int,
    age_years: float = USUAL_AGE,
    source: Path | None = None,
    progress: Progress = no_progress,
) -> tuple[Path, tuple[str, ...]]:
    """Make a body of given measures, or change a clone's, and write it; return its folder and a report.

    Parameters
    ----------
    out : Path
        Receives a folder named by the identifier.
    identifier : str
    sex : str
        "f" or "m"; "" only where a clone is told new measures: then its own shape decides.
    stature_cm : float or None
        None only where a clone keeps its own.
    measures_cm : mapping of str to float
        By names of the measures' table, "_girth" may be left out.
    formats : sequence of str
        Names of exporters.
    texture_size : int
        Side of the texture of a new body, texels.
    age_years : float
        Below 18 a child's body.
    source : Path or None
        The clone that is told new measures.
    progress : callable
        May raise Cancelled; nothing is left behind.

    Raises
    ------
    ClonerError
        If nobody has these measures, or something cannot be read or written.
    """
    check_formats(formats)
    check_texture_size(texture_size)
    if stature_cm is None and source is None:
        raise ClonerError("the stature is missing", "Give --stature and as many measures as you know", "--stature")
    progress("body", 0.0)
    old = load_clone_at(source) if source is not None else None
    spec = _told(sex, stature_cm, measures_cm, age_years, old)
    with result_folder(out, safe_identifier(identifier)) as folder:
        clone = clone_of_measures(spec, texture_size) if old is None else remeasured_clone(old, spec)
        clone = replace(clone, stamp=_stamp(spec, identifier, texture_size, old))
        progress("export", 0.5)
        options = {"sex": spec.sex, "stature_m": round(spec.stature_m, 4), "age_years": spec.age_years}
        options["told_mm"] = dict(spec.mm)
        told_mm = {key: round(value, 1) for key, value in spec.mm.items()}
        manifest = make_manifest(clone, "body from measures", options, source) | {"told_mm": told_mm}
        write_result(clone, folder, f"Body {identifier}", formats, manifest)
    progress("done", 1.0)
    return out / safe_identifier(identifier), _said(clone, spec, old)


def _told(
    sex: str, stature_cm: float | None, measures_cm: Mapping[str, float], age_years: float, old: Clone | None
) -> BodySpecification:
    """Return the specification of a new body, or of a clone, which keeps its stature and sex by default."""
    stature_m = old.stature_m if stature_cm is None and old is not None else float(stature_cm or 0.0) / 100.0
    whose = sex or (sex_of(old) if old is not None else "")
    return BodySpecification(whose, stature_m, _tape(measures_cm, stature_m), age_years)


def _tape(measures_cm: Mapping[str, float], stature_m: float) -> dict[str, float]:
    if not 0.0 < stature_m < 10.0:
        raise ClonerError("the stature must be a length in centimetres", "For example --stature 168", "--stature")
    return dict(read_tape(measures_cm, stature_m, WHERE))


def sex_of(clone: Clone) -> str:
    """Return which of the two tables is nearer to a clone's shoulders and hips."""
    hip, chest = (clone.measures_mm.get(key, 0.0) for key in ("hip_girth", "underbust_girth"))
    return "m" if chest > 0.88 * hip > 0.0 else "f"


def _stamp(spec: BodySpecification, identifier: str, size: int, old: Clone | None) -> str:
    """Return the stamp of every file; a changed clone keeps the link to its visitor."""
    changed = ", ".join(f"{key.replace('_', ' ')} {value:.1f}" for key, value in spec.mm.items())
    if old is not None:
        return f"{old.stamp}, told {changed}"[:400]
    text = json.dumps([identifier, spec.sex, spec.age_years, spec.stature_m, dict(spec.mm)])
    return stamp_text(0, size, [hashlib.sha256(text.encode()).hexdigest()])


def _said(clone: Clone, spec: BodySpecification, old: Clone | None) -> tuple[str, ...]:
    """Return one line per given measure, and the unlikely ones among the others."""
    shown = read(clone.vertices_m, clone.joints_m, load_tape_rules(), tuple(spec.mm), clone.sole_m, seat=spec.seat).mm
    lines = [
        f"{key}: told {value / 10.0:.1f} cm, the mesh shows {shown[key] / 10.0:.1f}" for key, value in spec.mm.items()
    ]
    if old is None:
        usual = untold_mm(spec)
        for key in (*GIRTHS, *LENGTHS):
            if key in usual and abs(clone.measures_mm[key] - usual[key][0]) > 2.0 * usual[key][1]:
                lines.append(
                    f"note: {key} came out at {clone.measures_mm[key] / 10.0:.1f} cm, "
                    f"{usual[key][0] / 10.0:.1f} is usual with these measures; tell it too"
                )
    return tuple(lines)


__all__ = ["RESULT_MARK", "body_folder"]
