"""Options of a crowd's pack."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from pathlib import Path
from typing import Final

from cloner.crowd.clones import stock
from cloner.crowd.clones.clips import WALK_FRAMES
from cloner.crowd.staged import scene
from cloner.errors import ClonerError
from cloner.motion.moves.acts import ACTS
from cloner.motion.moves.styles import STYLES
from cloner.records.clones import Clone

#: Captured walks that a clone's table has room for beside those of feelings and the acts.
MOST_WALKS: Final = stock.MOST_CLIPS - 3 - len(STYLES) - len(ACTS)


@dataclass(frozen=True, slots=True)
class PackOptions:
    """Options of ``cloner crowd``.

    Attributes
    ----------
    people : int
    views : int, 0 decides by the clones' breadth
    poses : int
    rings_deg : tuple of float, elevations of the impostors' rings
    looks : Path or None
    scene : str
    vat : bool
    walks : tuple of Path, captured walks besides the own one
    feelings : bool
        Walks of all feelings and what people do who stand, as scenarios want them.
    classic : bool
        Impostors as in the source: a texel a pixel, nearest view, no depth.
    compressed : bool
        Cards hold the page's textures in blocks: a third of the memory, less fine.
    mirror : bool
        Those whose sides look alike get impostors of one side, mirrored for the other.
    carved : callable or None
        Makes a statue of a clone: everybody can be one then.
    faces : bool
        Faces can move: they show feelings, and people may speak in films.
    """

    people: int = 5000
    views: int = 0
    poses: int = 16
    rings_deg: tuple[float, ...] = (5.0,)
    looks: Path | None = None
    scene: str = "plaza"
    vat: bool = False
    walks: tuple[Path, ...] = ()
    feelings: bool = False
    classic: bool = False
    compressed: bool = False
    mirror: bool = False
    carved: Callable[[Clone], Clone] | None = None
    faces: bool = False


def parse_rings(text: str) -> tuple[float, ...]:
    """Return the elevations in a list with commas, degrees.

    Raises
    ------
    ClonerError
        If one is no number.
    """
    try:
        return tuple(float(part) for part in text.split(","))
    except ValueError as error:
        raise ClonerError(f"{text!r} is no list of degrees", "Write it like 5,25,45", "--rings") from error


def check_options(wanted: PackOptions) -> None:
    """Refuse invalid options.

    Raises
    ------
    ClonerError
        If a number or name makes no sense.
    """
    if wanted.scene not in scene.SCENES:
        raise ClonerError(f"{wanted.scene!r} is no scene", f"Choose one of {', '.join(scene.SCENES)}", "--scene")
    limits = (("--people", wanted.people, 1, 200_000), ("--poses", wanted.poses, 1, WALK_FRAMES))
    for where, value, low, high in limits:
        if not low <= value <= high:
            raise ClonerError(f"{value} is outside {low} to {high}", "Choose another number", where)
    if WALK_FRAMES % wanted.poses:
        message = f"{wanted.poses} poses do not divide a cycle of {WALK_FRAMES} frames"
        raise ClonerError(message, "Give 8, 12, 16 or 24", "--poses")
    if wanted.views and (wanted.views % 2 or not 8 <= wanted.views <= 64):
        hint = "Give an even number from 8 to 64, so that front and back are exact"
        raise ClonerError(f"{wanted.views} views are not possible", hint, "--views")
    if not 1 <= len(wanted.rings_deg) <= 4 or not all(-30.0 <= ring <= 80.0 for ring in wanted.rings_deg):
        raise ClonerError("the rings are not possible", "Give one to four elevations from -30 to 80 degrees", "--rings")
    if len(wanted.walks) > MOST_WALKS:
        raise ClonerError("these are too many walks", f"Give at most {MOST_WALKS}", "--walk")
