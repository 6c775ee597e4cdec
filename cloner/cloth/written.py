"""A dressed clone as a file: a GLB whose garment moves, a looping film, or a point cache."""

from __future__ import annotations

import functools
from collections.abc import Callable, Mapping, Sequence
from glob import escape
from pathlib import Path
from types import MappingProxyType
from typing import Final

from cloner.cloth.caches import obj, pc2, usd, vat
from cloner.cloth.clothed import check_folder, write_garments_as_result
from cloner.cloth.drafting.cut import triangulate
from cloner.cloth.drafting.pattern import Pattern
from cloner.cloth.dressing import (
    STEP_M,
    WALK,
    DressedClone,
    dress_clone,
    find_fabric,
    find_motion,
    find_pattern,
    pictures,
)
from cloner.cloth.glb import glb
from cloner.cloth.resumed import checkpoint_path
from cloner.cloth.simulation.fabrics import Fabric
from cloner.cloth.simulation.wearer import FRAMES_PER_S
from cloner.errors import ClonerError
from cloner.exporters.shared.files import write_bytes
from cloner.exporters.vat import PICTURE, REMAP, check_count
from cloner.motion.limbs.rig import centre_joints
from cloner.picture import load_clone_at
from cloner.pipeline import Progress, no_progress
from cloner.project.atomic import atomic_file, safe_output
from cloner.records.clones import Clone
from cloner.records.motions import Motion
from cloner.vision.photographs.films import FORMATS as FILMS
from cloner.vision.photographs.films import write_film

PC2: Final = ".pc2"
#: What is written, by the file's ending: contents by the ends of their names, the file's own first.
WRITERS: Final[Mapping[str, Callable[[DressedClone], Mapping[str, bytes]]]] = MappingProxyType(
    {
        ".glb": lambda found: {".glb": glb(found)},
        PC2: lambda found: {PC2: pc2(found), ".obj": obj(found)},
        ".usdc": lambda found: {".usdc": usd(found)},
        PICTURE: vat,
    }
)
#: Of these, what lies beside the file.
BESIDE: Final = MappingProxyType({PC2: (".obj",), PICTURE: (REMAP, ".glb")})
ENDINGS: Final = (*WRITERS, *FILMS)
#: Step of the triangles of what is written as a result: crowds show 4,000 triangles of it at most, metres.
FOLDER_STEP_M: Final = 0.022


def dress_file(
    clone_path: Path,
    out: Path,
    *,
    garment: str,
    fabric: str,
    motion: str = WALK,
    length_cm: float | None = None,
    over: Sequence[tuple[str, str]] = (),
    elements: bool = False,
    resume: bool = False,
    formats: Sequence[str] = (),
    progress: Progress = no_progress,
) -> tuple[str, ...]:
    """Dress a clone in a garment, simulate its walk, and write the loop; return a report.

    Parameters
    ----------
    clone_path : Path
    out : Path
        A .glb, a film, or the garment's points alone (.pc2, .usdc, .png). Without an ending: a result's folder.
    garment, fabric, motion : str
        One of `GARMENTS` or a file (.json, .svg); of `FABRICS` or a .toml; "walk" or a captured one (.bvh).
    length_cm : float or None
        Of a named garment, from its ring or the waist down.
    over : sequence of (str, str)
        Garments and fabrics worn over it.
    elements : bool
        Let the source's integrator move the cloth (`cloner.cloth.simulation.implicit`), not threads.
    resume : bool
        Keep frames beside ``out`` until it is written, and go on from those that the same call left.
    progress : callable
        May raise Cancelled.

    Raises
    ------
    ClonerError
        If something named does not exist, or cannot be worn or written.
    """
    if out.suffix:
        check_target(out)
    else:
        check_folder(out, clone_path, formats)
    fabrics = [find_fabric(name) for name in (fabric, *(name for _, name in over))]
    clone = centre_joints(plain := load_clone_at(clone_path))
    cuts = [find_pattern(clone, garment, length_cm), *(find_pattern(clone, name, None) for name, _ in over)]
    if out.suffix.lower() == PICTURE:
        check_count(len(triangulate(cuts[-1][0], STEP_M).flat_m), cuts[-1][0].name)
    step_m = STEP_M if out.suffix else FOLDER_STEP_M
    rests = [checkpoint_path(out, number) if resume else None for number in range(len(cuts))]
    found = _dress_layers(clone, cuts, fabrics, rests, find_motion(clone, motion), step_m, elements, progress)
    progress("export", 0.97)
    if out.suffix:
        write_dressed(found, out)
    else:
        write_garments_as_result(found, plain, clone_path, out, [one.name for one, _ in cuts], formats, progress)
    for rest in filter(None, rests):
        rest.unlink(missing_ok=True)
    return (*map(_report, found.layers), str(out))


def _dress_layers(
    clone: Clone,
    cuts: Sequence[tuple[Pattern, str | None]],
    fabrics: Sequence[Fabric],
    rests: Sequence[Path | None],
    walk: Motion,
    step_m: float,
    elements: bool,
    progress: Progress,
) -> DressedClone:
    """Return a clone in all its garments, the first one innermost."""
    found: DressedClone | None = None
    for number, ((pattern, ring_level), fabric, rest) in enumerate(zip(cuts, fabrics, rests, strict=True)):
        share = functools.partial(_share, progress, number, len(cuts))
        found = dress_clone(
            clone, pattern, ring_level, fabric, walk,
            step_m=step_m, under=found, elements=elements, resumed=rest, progress=share,
        )  # fmt: skip
    assert found is not None
    return found


def _report(one: DressedClone) -> str:
    """Return a report of a garment's loop."""
    loop = one.loop
    found = f"loop of {len(loop.frames_m)} frames, {one.worn.cloth.count} vertices: gap {loop.gap_mm:.0f} mm"
    return f"{found} (median stretch {loop.median_mm:.0f}), closed by {loop.moved_mm:.0f} mm at most"


def _share(progress: Progress, number: int, count: int, step: str, fraction: float) -> None:
    """Report progress over several garments."""
    progress(step, (number + fraction) / count)


def check_target(out: Path) -> None:
    """Refuse a file that a dressed clone cannot be written to, before any work.

    Raises
    ------
    ClonerError
        If its ending is not known, or the file exists.
    """
    kind = out.suffix.lower()
    if kind not in ENDINGS:
        hint = f"Give --out a name that ends with {', '.join(ENDINGS)}"
        raise ClonerError(f"no dressed clone is written as {out.suffix or 'this'}", hint, out.name)
    for path in (out, *_beside(out)):
        safe_output(path)


def _beside(out: Path) -> tuple[Path, ...]:
    """Return the files that are written beside a dressed clone."""
    return tuple(out.with_name(out.stem + end) for end in BESIDE.get(out.suffix.lower(), ()))


def write_dressed(found: DressedClone, out: Path) -> None:
    """Write a dressed clone in the format of the file's suffix.

    Raises
    ------
    ClonerError
        If it cannot be written.
    """
    check_target(out)
    kind = out.suffix.lower()
    if kind in WRITERS:
        for end, data in WRITERS[kind](found).items():
            write_bytes(out if end == kind else out.with_name(out.stem + end), data)
        return
    with atomic_file(out) as temporary:
        write_film(list(pictures(found)), FRAMES_PER_S, temporary)


def clean_up(out: Path) -> None:
    """Remove what a killed process left beside a dressed clone."""
    for path in (out, *_beside(out)):
        for rest in out.parent.glob(f".{escape(path.name)}.*"):
            rest.unlink(missing_ok=True)
