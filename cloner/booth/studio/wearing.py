"""Dressing: a garment is placed on a clone, sewn, simulated in a walk and written; intermediate results are cached."""

from __future__ import annotations

from pathlib import Path
from typing import Final

import numpy as np

from cloner.bodies.undressed import undressed_clone
from cloner.bodies.written import sex_of
from cloner.booth.studio.values import Arranged, Draped, Outfit, Rgb
from cloner.booth.worker import Show, ignore
from cloner.cloth.clothed import check_folder, write_garments_as_result
from cloner.cloth.drafting.pattern import Pattern, bezier
from cloner.cloth.dressing import DressedClone, Dressing, Watch, find_fabric, find_motion, find_pattern
from cloner.cloth.simulation.fabrics import Fabric
from cloner.cloth.simulation.moving import SETTLE
from cloner.cloth.simulation.wearer import FRAMES_PER_S
from cloner.cloth.written import clean_up, write_dressed
from cloner.motion.limbs.rig import centre_joints
from cloner.picture import clone_file, load_clone_at
from cloner.pipeline import Progress
from cloner.records.arrays import Array
from cloner.records.clones import Clone

#: Places along an edge that is drawn.
_PLACES: Final = 16
#: What a dressed clone is written as in a result's folder.
FORMATS: Final = ("glb", "wrl")


class Wearing:
    """Jobs of the garments' window.

    Parameters
    ----------
    show : callable
        Takes a `Draped` for every frame of cloth that is simulated.
    """

    def __init__(self, show: Show = ignore) -> None:
        self._show = show
        self._below: tuple[tuple[Path, bool, int], Clone, Clone] | None = None
        self._dressing: tuple[Outfit, Dressing, Pattern] | None = None
        self._dressed: dict[Outfit, DressedClone] = {}

    def arrange(self, outfit: Outfit, progress: Progress) -> Arranged:
        """Cut a garment and place it around the clone; see `cloner.cloth.simulation.moving.place_garment`."""
        dressing, pattern = self._arranged(outfit, progress)
        still = np.zeros_like(dressing.worn.rotations[0])
        places = dressing.over_below(dressing.worn.start.places_m, SETTLE - 1)
        draped = self._draped(outfit, dressing, places, np.zeros(3), still)
        return Arranged(self._wearer(outfit, progress), _pieces(pattern), draped)

    def hang(self, outfit: Outfit, progress: Progress) -> None:
        """Sew the garment and let it settle; shows every frame."""
        dressing, _ = self._arranged(outfit, progress)
        dressing.settle(self._watch(outfit, dressing), progress=progress)

    def walk(self, outfit: Outfit, progress: Progress) -> tuple[Draped, float]:
        """Simulate the garment in a walk until a loop is found; return the loop and its frames per second. Shows every
        frame.
        """
        found = self._walked(outfit, progress)
        worn, loop = found.worn, found.below()
        shown = Draped(
            loop.loop_m.astype(np.float32), loop.faces.astype(np.int32), _parts(found.layers), worn.root_m,
            worn.rotations,
        )  # fmt: skip
        return shown, float(FRAMES_PER_S)

    def save_worn(self, outfit: Outfit, out: Path, progress: Progress) -> Path:
        """Write the clone in its garments; see `cloner.cloth.written.write_dressed`. Without a suffix: as a result."""
        if not out.suffix:
            check_folder(out, outfit.clone, FORMATS)
        found = self._walked(outfit, progress)
        progress("export", 0.0)
        if out.suffix:
            clean_up(out)
            write_dressed(found, out)
        else:
            plain = self._plain(outfit, progress)
            write_garments_as_result(found, plain, outfit.clone, out, _garments(outfit), FORMATS, progress)
        return out

    def _walked(self, outfit: Outfit, progress: Progress) -> DressedClone:
        """Return a garment's loop; the latest one, and what is worn below it, are cached."""
        self._wearer(outfit, progress)
        if outfit not in self._dressed:
            dressing, _ = self._arranged(outfit, progress)
            self._dressing = None  # it is walked with once
            found = dressing.simulate_walk(self._watch(outfit, dressing), progress=progress)
            self._dressed = {one: worn for one, worn in self._dressed.items() if one == outfit.under}
            self._dressed[outfit] = found
        return self._dressed[outfit]

    def _wearer(self, outfit: Outfit, progress: Progress) -> Clone:
        """Return the wearer, with joints in the middle of the limbs."""
        self._plain(outfit, progress)
        assert self._below is not None
        return self._below[2]

    def _plain(self, outfit: Outfit, progress: Progress) -> Clone:
        """Return the wearer, undressed if requested."""
        key = outfit.clone, outfit.bare, clone_file(outfit.clone).stat().st_mtime_ns
        if self._below is None or self._below[0] != key:
            progress("body", 0.0)
            clone = load_clone_at(outfit.clone)
            below = undressed_clone(clone, sex_of(clone)) if outfit.bare else clone
            self._below, self._dressing, self._dressed = (key, below, centre_joints(below)), None, {}
        return self._below[1]

    def _arranged(self, outfit: Outfit, progress: Progress) -> tuple[Dressing, Pattern]:
        """Return the garment's present state; placed anew if another one is requested."""
        clone = self._wearer(outfit, progress)
        if self._dressing is None or self._dressing[0] != outfit:
            under = None if outfit.under is None else self._walked(outfit.under, progress)
            progress("arrange", 0.3)
            pattern, ring = find_pattern(clone, outfit.garment, outfit.length_cm)
            fabric, motion = find_fabric(outfit.fabric), find_motion(clone, outfit.motion)
            self._dressing = outfit, Dressing(clone, pattern, ring, fabric, motion, under=under), pattern
        return self._dressing[1:]

    def _watch(self, outfit: Outfit, dressing: Dressing) -> Watch:
        return lambda places, root, turned: self._show(self._draped(outfit, dressing, places, root, turned))

    def _draped(self, outfit: Outfit, dressing: Dressing, places_m: Array, root_m: Array, rotations: Array) -> Draped:
        """Return one frame (N, 3) of all garments."""
        faces = dressing.worn.cloth.faces
        own = (len(faces), _rgb(find_fabric(outfit.fabric)))
        parts: tuple[tuple[int, Rgb], ...] = (own,)
        if outfit.under is not None:
            below = self._dressed[outfit.under]
            inner = below.below().faces
            faces = np.concatenate([inner, faces + int(inner.max()) + 1])
            parts = (*_parts(below.layers), own)
        return Draped(places_m[None].astype(np.float32), faces.astype(np.int32), parts, root_m[None], rotations[None])


def _garments(outfit: Outfit) -> list[str]:
    """Return the names of the worn garments, the innermost first."""
    return [*(_garments(outfit.under) if outfit.under is not None else ()), Path(outfit.garment).stem]


def _pieces(pattern: Pattern) -> tuple[Array, ...]:
    """Return the outlines (M, 2) of a garment's pieces, metres."""
    shares = np.linspace(0.0, 1.0, _PLACES, endpoint=False)
    return tuple(
        np.concatenate([bezier(np.asarray(edge), shares) for edge in segment.edges.values()])
        for segment in pattern.segments
    )


def _parts(layers: tuple[DressedClone, ...]) -> tuple[tuple[int, Rgb], ...]:
    return tuple((len(one.worn.cloth.faces), _rgb(one.fabric)) for one in layers)


def _rgb(fabric: Fabric) -> Rgb:
    red, green, blue = (value / 255.0 for value in fabric.rgb)
    return red, green, blue
