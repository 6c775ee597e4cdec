"""Bodies of blobs as results, and the blobs of a body as an editable file."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace
from pathlib import Path
from typing import Final

import numpy as np

from cloner.bodies.carried import move_shells_with_skin
from cloner.bodies.made import clone_of_measures
from cloner.errors import ClonerError
from cloner.exporters.shared.files import write_bytes
from cloner.exporters.table import check_formats
from cloner.generic.features import named_features
from cloner.generic.load import load_generic
from cloner.generic.tape import load_tape_rules
from cloner.geometry.measurement.measuring import measures_mm
from cloner.making import check_texture_size
from cloner.picture import load_clone_at
from cloner.pipeline import Progress, no_progress
from cloner.project.atomic import result_folder, safe_output
from cloner.project.folder import safe_identifier
from cloner.project.stamps import stamp_text
from cloner.records.clones import Clone
from cloner.report.derived import make_manifest, write_result
from cloner.statues.blobs import Blob, field_of, read_blobs, written_blobs
from cloner.statues.carved import check_material, statue_of
from cloner.statues.envelope import Envelope, fit_to_blobs
from cloner.statues.photographed import USUAL
from cloner.statues.usual_blobs import usual_blobs

#: More of the skin that meets no blob is no body: share.
MOST_MISSED: Final = 0.5


def clone_of_blobs(clone: Clone, blobs: Sequence[Blob]) -> tuple[Clone, Envelope]:
    """Return the clone whose body is that of some blobs, its head, hands and feet attached, and how it went.

    Raises
    ------
    ClonerError
        If the blobs are none that a body can be laid on.
    """
    generic, rules = load_generic(), load_tape_rules()
    found = fit_to_blobs(clone.vertices_m, clone.joints_m, field_of(blobs, clone.joints_m))
    skin = np.flatnonzero(generic.skin)
    if found.missed > MOST_MISSED * found.asked:
        hint = "cloner statue blobs CLONE --out body.json writes blobs to begin with"
        raise ClonerError("the blobs lie nowhere near most of the body", hint, "blobs")
    shift = (found.vertices_m - clone.vertices_m)[skin]
    old, now = (
        measures_mm(points, clone.joints_m, rules, clone.sole_m) for points in (clone.vertices_m, found.vertices_m)
    )
    made = replace(
        clone,
        vertices_m=found.vertices_m,
        shells=move_shells_with_skin(clone.shells, clone.vertices_m[skin], shift),
        features_m=named_features(generic, found.vertices_m),
        views={},
        measures_mm={key: round(value + now[key] - old[key], 1) for key, value in clone.measures_mm.items()},
    )
    return made, found


def blob_folder(
    blobs: Path,
    out: Path,
    identifier: str,
    *,
    onto: Path | None = None,
    material: str = "",
    formats: Sequence[str],
    texture_size: int,
    progress: Progress = no_progress,
) -> tuple[Path, tuple[str, ...]]:
    """Make a body of blobs and write it as a result; return its folder and what to say of it.

    Parameters
    ----------
    blobs : Path
    out : Path
        Receives a folder named by the identifier.
    identifier : str
    onto : Path or None
        The clone whose head, hands, feet and skin it gets; None for the usual man.
    material : str
        It is cut from this in the end; "" leaves skin and clothes.
    formats : sequence of str
        Names of exporters.
    texture_size : int
        Of the usual man.
    progress : callable
        May raise Cancelled; nothing is left behind.

    Raises
    ------
    ClonerError
        If something cannot be read or written, or the blobs are no body.
    """
    check_formats(formats)
    check_texture_size(texture_size)
    if material:
        check_material(material)
    progress("body", 0.0)
    blob_list, name = read_blobs(blobs), safe_identifier(identifier)
    base = load_clone_at(onto) if onto is not None else clone_of_measures(USUAL, texture_size)
    made, found = clone_of_blobs(base, blob_list)
    stamp = base.stamp or stamp_text(0, texture_size)
    made = replace(made, stamp=f"{stamp}, {len(blob_list)} blobs"[:400])
    with result_folder(out, name) as folder:
        made = statue_of(made, material) if material else made
        progress("export", 0.6)
        options = {"blobs": len(blob_list), "material": material}
        write_result(made, folder, f"Body {name}", formats, make_manifest(made, "body of blobs", options, onto))
    progress("done", 1.0)
    off = 1000.0 * np.abs(found.off_m[np.isfinite(found.off_m)])
    lines = [f"{len(blob_list)} blobs: the skin lies {off.mean():.1f} mm from their surface on average"]
    if found.missed:
        lines.append(f"note: {found.missed} vertices met no blob and follow their neighbours")
    return out / name, tuple(lines)


def blobs_file(clone_path: Path, out: Path) -> str:
    """Write the blobs that make a clone's body as JSON; return what to say of them.

    Raises
    ------
    ClonerError
        If the clone cannot be read, or the file exists or cannot be written.
    """
    safe_output(out)
    clone = load_clone_at(clone_path)
    blobs = usual_blobs(clone.vertices_m, clone.joints_m)
    found = fit_to_blobs(clone.vertices_m, clone.joints_m, field_of(blobs, clone.joints_m))
    moved = np.linalg.norm(found.vertices_m - clone.vertices_m, axis=1)[np.isfinite(found.off_m)]
    write_bytes(out, written_blobs(blobs, clone.stamp).encode())
    return f"{len(blobs)} blobs: their body is {1000.0 * moved.mean():.1f} mm from the clone's on average"
