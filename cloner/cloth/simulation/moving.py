"""Simulation of a garment: placed, settled, moved into the walk, then cycle after cycle."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass, replace
from typing import Final

import numpy as np
from numpy.typing import NDArray

from cloner.cloth.drafting.cut import Cloth, triangulate
from cloner.cloth.drafting.pattern import Pattern
from cloner.cloth.drafting.sections import sections
from cloner.cloth.simulation import implicit
from cloner.cloth.simulation.core.host import ClothEngine, push_out_of_skin
from cloner.cloth.simulation.fabrics import Fabric
from cloner.cloth.simulation.implicit import System, make_system
from cloner.cloth.simulation.layered import Under, layered_collider
from cloner.cloth.simulation.placing import HeldBand, Ring, make_band, place_around, push_outside
from cloner.cloth.simulation.solver import FASTEST_M_S, THICK_M, LoopTarget, Sheet, State, make_engine, make_sheet, step
from cloner.cloth.simulation.wearer import FRAMES_PER_S, Wearer, cycle_frames, make_wearer, skin_interval
from cloner.cloth.simulation.wrapping import DEEP_M, PUSHES, wrap_around
from cloner.easing import smoothstep
from cloner.errors import ClonerError
from cloner.records.arrays import Array
from cloner.records.clones import Clone
from cloner.records.motions import Motion

Ints = NDArray[np.int64]

#: Small steps of the solver a frame. With 40, 80 and 160 the threads of a skirt are 3.8, 2.0 and 1.0 % too long (99th
#: percentile, median frame; triangles of 1.5 cm), those of a coat 8.4, 5.7 and 5.1, and a coat crosses itself in 2, 4
#: and no triangles of its worst frame.
SUBSTEPS: Final = 160
#: Frames of hanging still at rest, and of going from the rest pose to the walk's first frame.
SETTLE, BLEND = 24, 24
#: What hangs from a ring above this share of the stature covers the arms.
NECK: Final = 0.75
#: Times that threads are drawn to their lengths before a sewn garment is let go.
EASING: Final = 90
#: Of these, between two searches of what may meet.
SEARCHED: Final = 5
#: While the cloth settles no vertex moves faster, m/s, and speed that is kept between frames: folds that were laid
#: too near unfold without passing through each other (a coat crossed itself in 8 triangles, a circle skirt in 7).
GENTLE_M_S, CALM = 1.0, 0.6


@dataclass(frozen=True, slots=True, eq=False)
class Colliders:
    """What cloth collides with in a frame: points of skin (B, 3), then those of lower cloth; the held positions."""

    skin_m: Array
    held_m: Array


@dataclass(frozen=True, slots=True, eq=False)
class WornGarment:
    """A garment on a clone.

    Attributes
    ----------
    cloth : Cloth
    sheet : Sheet
    core : ClothEngine
        Its engine.
    body : Wearer
    band : HeldBand
    root_m, rotations : (F, 3) and (F, 94, 3)
        One cycle of the motion.
    speed_m_s : float
        At which the ground runs backwards: the air does as well.
    start : State
    under : Under or None
        What is worn below.
    system : System or None
        Its elements, if the source's integrator moves it; threads do else.
    """

    cloth: Cloth
    sheet: Sheet
    core: ClothEngine
    body: Wearer
    band: HeldBand
    root_m: Array
    rotations: Array
    speed_m_s: float
    start: State
    under: Under | None = None
    system: System | None = None

    def colliders(self, root_m: Array, rotations: Array, below_m: Array | None) -> Colliders:
        """Return the colliders in a pose, with the points (N, 3) of lower cloth."""
        skin_m = self.body.posed(root_m, rotations)
        return Colliders(
            skin_m if below_m is None else np.concatenate([skin_m, below_m]), self.band.posed(root_m, rotations)
        )

    def colliders_in(self, frame: int) -> Colliders:
        """Return the colliders in a frame of the walk, with lower cloth in its loop."""
        frame %= len(self.rotations)
        below_m = None if self.under is None else self.under.loop_m[frame]
        return self.colliders(self.root_m[frame], self.rotations[frame], below_m)

    def after(
        self, state: State, before: Colliders, now: Colliders, *, settles: bool = False, lead: LoopTarget | None = None
    ) -> State:
        """Return the cloth's state a frame later; while it settles, speeds are limited and there is no wind."""
        skin = skin_interval(self.body, before.skin_m, now.skin_m)
        wind = np.array([0.0, 0.0, 0.0 if settles else -self.speed_m_s])
        held = (before.held_m, now.held_m)
        if self.system is not None:
            return implicit.step(self.sheet, self.core, self.system, state, skin, held, 1.0 / FRAMES_PER_S, wind, lead)
        fastest = GENTLE_M_S if settles else FASTEST_M_S
        return step(self.core, self.sheet.fabric, state, skin, held, 1.0 / FRAMES_PER_S, SUBSTEPS, wind, lead, fastest)


def place_garment(
    clone: Clone,
    pattern: Pattern,
    ring: Ring | None,
    fabric: Fabric,
    motion: Motion,
    step_m: float,
    under: Under | None = None,
    *,
    elements: bool = False,
) -> WornGarment:
    """Return a garment placed around a clone at rest, not yet released; ``ring`` if it hangs from one.

    ``under`` is a garment that is worn already: the new one is placed over it. With ``elements`` the source's
    integrator moves it, else threads.

    Raises
    ------
    ClonerError
        If its pieces cannot be laid round the body.
    """
    cloth = triangulate(pattern, step_m)
    body = make_wearer(clone, whole=ring is None or float(ring.points_m[0, 1]) > NECK * clone.stature_m)
    met_m = clone.vertices_m[body.rows]
    if under is not None:
        body = layered_collider(body, under, SETTLE - 1)
        met_m = np.concatenate([clone.vertices_m[body.rows], under.at(SETTLE - 1)])
    if ring is None:
        places, held, held_m = wrap_around(pattern, cloth, sections(clone))
    else:
        places, held, held_m = place_around(pattern, cloth, ring)
        places = push_outside(places, met_m, held)
    if not np.isfinite(places).all():
        hint = "See docs/cloth.md for how a garment is drawn"
        raise ClonerError(f"the garment {pattern.name!r} cannot be laid round this body", hint, "--garment")
    now = skin_interval(body, met_m, met_m)
    if under is not None:
        places = push_out_of_skin(places, now, THICK_M, DEEP_M, PUSHES)  # what will be held as well
        held_m = places[held]
    root, rotations = cycle_frames(motion)
    tied = make_band(clone, held_m, body.rows)
    sheet = make_sheet(cloth, fabric, held)
    core = make_engine(sheet, len(met_m))
    if ring is None or under is not None:
        core.meet(now)
        places = _relaxed(core, held, places)
    state = State(places, np.zeros_like(places))
    system = make_system(cloth, fabric) if elements else None
    return WornGarment(cloth, sheet, core, body, tied, root, rotations, motion.speed_m_s, state, under, system)


def _relaxed(core: ClothEngine, held: Ints, places_m: Array) -> Array:
    """Return positions in which seam-stretched threads have their lengths again, outside the skin, without gravity."""
    out = core.arrays["place"]
    out[:], core.arrays["velocity"][:] = places_m, 0.0
    for number in range(EASING):
        core.call("hang")  # drawn back later in one step, it would fly
        core.call("limit", 1.0)  # what is short folds when it hangs
        if number % SEARCHED == 0:
            core.call("findPairs", 0.0)
        core.call("keepApart")
        if number % 3 == 2:
            core.call("findPlanes", 1.0, DEEP_M)
            core.call("keepOut", THICK_M, 0.0, 1.0, 0.0)
            out[held] = places_m[held]
    return np.array(out)


def simulate(worn: WornGarment, cycles: int, done: int = 0, state: State | None = None) -> Iterator[tuple[int, State]]:
    """Yield the cloth's state after every frame: negative numbers while it settles, then from 0 on.

    With ``done`` frames behind it, it goes on from the ``state`` after the last of them.
    """
    count = len(worn.rotations)
    poses = [(np.zeros(3), np.zeros_like(worn.rotations[0]))] * SETTLE
    for number in range(1, BLEND + 1):
        share = smoothstep(number / BLEND)
        poses.append((share * worn.root_m[0], share * worn.rotations[0]))
    put = len(poses)
    poses += [(worn.root_m[k % count], worn.rotations[k % count]) for k in range(1, cycles * count)]
    state = worn.start if state is None else state
    before = _colliders_at(worn, poses, max(done - 1, 0))
    for number in range(done, len(poses)):
        now = _colliders_at(worn, poses, number)
        state = worn.after(state, before, now, settles=number < SETTLE)
        if number < SETTLE:
            state = replace(state, speeds_m_s=CALM * state.speeds_m_s)
        before = now
        yield number - put + 1, state


def _colliders_at(worn: WornGarment, poses: Sequence[tuple[Array, Array]], number: int) -> Colliders:
    """Return the colliders in a frame counted from the beginning."""
    return worn.colliders(*poses[number], None if worn.under is None else worn.under.at(number))
