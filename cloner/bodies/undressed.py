"""A clone without its clothes: the estimated body in its own skin, in neutral underwear."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace
from pathlib import Path
from typing import Final

import numpy as np

from cloner.bodies.bare import NAPE, bare_skin
from cloner.bodies.bared import paint_bare_skin
from cloner.bodies.carried import move_with_skin
from cloner.bodies.population import SEXES
from cloner.bodies.skin import regions
from cloner.bodies.under import body_under
from cloner.bodies.written import sex_of
from cloner.errors import ClonerError
from cloner.exporters.table import check_formats
from cloner.generic.features import named_features
from cloner.generic.load import load_generic
from cloner.picture import folder_name, load_clone_at
from cloner.pipeline import Progress, no_progress
from cloner.project.atomic import result_folder
from cloner.project.folder import safe_identifier
from cloner.records.bodies import BodyMesh
from cloner.records.clones import Clone
from cloner.records.regions import REGIONS
from cloner.report.derived import make_manifest, write_result
from cloner.stages.join import flat_soles

#: Nobody shorter is undressed: it may be a child.
SHORTEST_M: Final = 1.40
#: Skin painted as hair here is the person's own scalp.
_OWN: Final = ("hair", "eyes", "mouth")


def undress_folder(
    clone_path: Path,
    out: Path,
    identifier: str,
    *,
    sex: str = "",
    formats: Sequence[str],
    progress: Progress = no_progress,
) -> Path:
    """Write a clone without its clothes as a result of its own, which belongs to the same visitor; return its folder.

    Parameters
    ----------
    clone_path : Path
        A result's folder or its clone.npz.
    out : Path
        Receives a folder named by the identifier.
    identifier : str
        "" for the clone's folder's name and "-undressed".
    sex : str
        "f" or "m", "" where the clone's shape decides.
    formats : sequence of str
        Names of exporters.
    progress : callable
        May raise Cancelled; nothing is left behind.

    Raises
    ------
    ClonerError
        As :func:`undressed_clone`, or if something cannot be read or written.
    """
    check_formats(formats)
    if sex not in ("", *SEXES):
        raise ClonerError(f"the sex {sex!r} is not known", "Give --sex f or --sex m, or leave it out", "--sex")
    progress("body", 0.0)
    clone = load_clone_at(clone_path)
    sex = sex or sex_of(clone)
    name = safe_identifier(identifier or f"{folder_name(clone_path)}-undressed")
    with result_folder(out, name) as folder:
        bare = undressed_clone(clone, sex)
        progress("export", 0.6)
        write_result(bare, folder, f"Body {name}", formats, make_manifest(bare, "undressed", {"sex": sex}, clone_path))
    progress("done", 1.0)
    return out / name


def undressed_clone(clone: Clone, sex: str, seed: int = 0) -> Clone:
    """Return the clone barefoot and in underwear; head, hair, hands and whatever else was bare stay as photographed.

    Parameters
    ----------
    clone : Clone
    sex : str
        "f" or "m": women wear two pieces.
    seed : int

    Raises
    ------
    ClonerError
        If no consent is recorded, the person may be a child, or the clone tells nothing of its body.
    """
    if not clone.consent:
        hint = 'Write consent = "..." into person.toml and clone again'
        raise ClonerError("no consent to being shown is recorded", hint, "clone.npz")
    if clone.atlas.shine.size:
        raise ClonerError(
            "a statue has no clothes to take off", "Undress the clone, then make a statue of it", "clone.npz"
        )
    if clone.stature_m < SHORTEST_M:
        hint = f"Clones from {100 * SHORTEST_M:.0f} cm on can be"
        raise ClonerError(f"a clone of {100 * clone.stature_m:.0f} cm may be a child's and is not undressed", hint, "")
    if not clone.measures_mm:
        raise ClonerError("the clone has no measures of its body", "Clone the photos again", "clone.npz")
    generic, bare = load_generic(), bare_skin(clone)
    lift = np.array([0.0, clone.sole_m, 0.0])
    dressed = BodyMesh(clone.vertices_m - lift, clone.joints_m - lift)
    body = body_under(dressed, bare, clone.measures_mm, clone.stature_m, sex)
    vertices = flat_soles(generic, body.vertices_m, 0.0)
    skin = np.flatnonzero(generic.skin)
    shift = vertices - dressed.vertices_m
    shells = tuple(
        replace(shell, vertices_m=move_with_skin(shell.vertices_m - lift, dressed.vertices_m[skin], shift[skin]))
        for shell in clone.shells
        if shell.kind not in ("cloth", "scarf")
    )
    plain = regions(sex)
    own = np.isin(clone.triangle_regions, [REGIONS.index(name) for name in _OWN])
    own &= generic.head_blend[generic.triangles()[0]].min(axis=1) >= NAPE
    scalp = plain == REGIONS.index("hair")
    plain = np.where(own, clone.triangle_regions, np.where(scalp, REGIONS.index("skin"), plain)).astype(np.uint8)
    return replace(
        clone,
        vertices_m=vertices,
        joints_m=body.joints_m,
        atlas=paint_bare_skin(clone, bare, sex, np.random.default_rng(seed)),
        shells=shells,
        features_m=named_features(generic, vertices),
        views={},  # their cameras saw the person dressed
        sole_m=0.0,
        triangle_regions=plain,
        stamp=f"{clone.stamp}, undressed"[:400],
    )
