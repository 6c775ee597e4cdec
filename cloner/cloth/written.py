"""A dressed clone as a file: a GLB whose garment moves with the walk, a film that repeats, or a cache of points."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from pathlib import Path
from typing import Final

from cloner.cloth.caches import obj, pc2, usd
from cloner.cloth.dressing import WALK, Dressed, dressed, fabric_named, motion_of, pattern_of, pictures
from cloner.cloth.glb import glb
from cloner.cloth.wearer import FRAMES_PER_S
from cloner.errors import ClonerError
from cloner.exporters.files import write_bytes
from cloner.motion.rig import centred
from cloner.picture import clone_of
from cloner.pipeline import Progress, quiet
from cloner.project.atomic import safe_output
from cloner.vision.films import FORMATS as FILMS
from cloner.vision.films import write_film

PC2: Final = ".pc2"
WRITERS: Final[Mapping[str, Callable[[Dressed], bytes]]] = {".glb": glb, PC2: pc2, ".usdc": usd}


def dress_file(
    clone_path: Path,
    out: Path,
    *,
    garment: str,
    fabric: str,
    motion: str = WALK,
    length_cm: float | None = None,
    progress: Progress = quiet,
) -> tuple[str, ...]:
    """Put a garment on a clone, let it walk, and write the loop; return what to say of it.

    Parameters
    ----------
    clone_path : Path
    out : Path
        A .glb, a film (.gif, .webp, .mp4), or the garment's points alone: .pc2 (its mesh, .obj, beside it) or .usdc.
    garment : str
        One of `GARMENTS`, or a file of a garment (.json, .svg).
    fabric : str
    motion : str
        "walk", or a capture of a walk (.bvh).
    length_cm : float or None
        Of a named garment, from the ring or the natural waist down.
    progress : callable
        May raise Cancelled: nothing was written then.

    Raises
    ------
    ClonerError
        If something named does not exist, or cannot be worn or written.
    """
    kind = out.suffix.lower()
    if kind not in (*WRITERS, *FILMS):
        hint = f"Give --out a name that ends with {', '.join((*WRITERS, *FILMS))}"
        raise ClonerError(f"no dressed clone is written as {out.suffix or 'this'}", hint, out.name)
    safe_output(out)
    if kind == PC2:
        safe_output(out.with_suffix(".obj"))
    cloth = fabric_named(fabric)
    clone = centred(clone_of(clone_path))
    pattern, ring_level = pattern_of(clone, garment, length_cm)
    found = dressed(clone, pattern, ring_level, cloth, motion_of(clone, motion), progress=progress)
    progress("export", 0.97)
    if kind in WRITERS:
        write_bytes(out, WRITERS[kind](found))
        if kind == PC2:
            write_bytes(out.with_suffix(".obj"), obj(found))
    else:
        write_film(list(pictures(found)), FRAMES_PER_S, out)
    loop = found.loop
    return (
        f"loop of {len(loop.frames_m)} frames, {found.worn.cloth.count} vertices: gap {loop.gap_mm:.0f} mm "
        f"(median stretch {loop.median_mm:.0f}), closed by {loop.moved_mm:.0f} mm at most",
        str(out),
    )
