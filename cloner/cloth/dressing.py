"""Dressing of a clone: the garment is found or drafted, placed, simulated in a walk, and closed to a loop."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping
from dataclasses import dataclass, replace
from pathlib import Path
from typing import Final

import numpy as np
from numpy.typing import NDArray

from cloner.cloth.drafting.blocks import BLOCKS, draft_block
from cloner.cloth.drafting.freesewing import read_svg_garment
from cloner.cloth.drafting.garmentcode import read_garment
from cloner.cloth.drafting.pattern import Pattern
from cloner.cloth.drafting.sections import Sections, sections
from cloner.cloth.drafting.tailored import TAILORED, TROUSERS, draft_tailored
from cloner.cloth.resumed import read_checkpoint, simulation_digest, write_checkpoint
from cloner.cloth.simulation.fabrics import FABRICS, Fabric, read_fabric
from cloner.cloth.simulation.layered import Under
from cloner.cloth.simulation.loop import Loop, find_loop
from cloner.cloth.simulation.moving import BLEND, SETTLE, WornGarment, place_garment, simulate
from cloner.cloth.simulation.placing import Ring, body_ring
from cloner.errors import ClonerError
from cloner.generic.layers import Layer, clone_layers
from cloner.geometry.cameras.viewpoints import framing_camera
from cloner.geometry.meshes.wedges import vertex_normals
from cloner.motion.captures.bvh import read_bvh
from cloner.motion.captures.retarget import retarget
from cloner.motion.limbs.body import body_of
from cloner.motion.moves.cycle import walk_cycle
from cloner.motion.moves.own import own_motions
from cloner.pipeline import Progress, no_progress
from cloner.records.arrays import Array
from cloner.records.clones import Clone
from cloner.records.motions import Motion
from cloner.render import draw

#: Sees a frame: the points (N, 3) of all garments, the innermost first, the clone's root (3,) and rotations (94, 3).
Watch = Callable[[Array, Array, Array], None]

WALK: Final = "walk"
WAIST: Final = "natural_waist"
#: A skirt clears the hips from so far below the waist on, metres, with so much ease (4 cm of a metre: a usual block's);
#: above, it has no darts.
HIPS_M: Final = 0.12
HIP_EASE: Final = 1.04
#: Everything that is cut to measure by name.
GARMENTS: Final = (*BLOCKS, *TAILORED)
#: What a garment of one's own is read by.
FILES: Final[Mapping[str, Callable[[Path, Sections], Pattern]]] = {".json": read_garment, ".svg": read_svg_garment}
#: Cycles that are simulated to find a loop in (four more follow under feedback), the share of the time that they take,
#: and the step of the cloth's triangles: about 5,000 vertices in a skirt.
CYCLES: Final = 8
WALKED: Final = 0.6
STEP_M: Final = 0.0152
#: Lengths that a garment can have, metres, and trousers below their crotch.
LENGTHS_M: Final = (0.15, 1.2)
LEGS_M: Final = 0.10
SIZE_PX: Final = (480, 720)


def ignore_frame(places_m: Array, root_m: Array, rotations: Array) -> None:
    """Ignore a frame of cloth."""


@dataclass(frozen=True, slots=True, eq=False)
class DressedClone:
    """A clone and its garment in a closed loop.

    Attributes
    ----------
    put_m : (P, N, 3)
        The garment's points while it was put on, and in the walk's first cycle.
    under : DressedClone or None
        What is worn below it.
    """

    clone: Clone
    motion: Motion
    worn: WornGarment
    loop: Loop
    fabric: Fabric
    put_m: Array
    under: DressedClone | None = None

    @property
    def layers(self) -> tuple[DressedClone, ...]:
        """All worn garments, the innermost first."""
        return (*(() if self.under is None else self.under.layers), self)

    def below(self) -> Under:
        """Return all garments as the lower layers of another one."""
        starts = np.cumsum([0, *(one.worn.cloth.count for one in self.layers)])
        faces = [one.worn.cloth.faces + start for one, start in zip(self.layers, starts, strict=False)]
        put = np.concatenate([one.put_m for one in self.layers], axis=1)
        return Under(np.concatenate(faces), put, np.concatenate([one.loop.frames_m for one in self.layers], axis=1))


def dress_clone(
    clone: Clone,
    pattern: Pattern,
    ring_level: str | None,
    fabric: Fabric,
    motion: Motion,
    *,
    cycles: int = CYCLES,
    step_m: float = STEP_M,
    under: DressedClone | None = None,
    elements: bool = False,
    resumed: Path | None = None,
    progress: Progress = no_progress,
) -> DressedClone:
    """Return a clone with a garment that moves in a loop with a cyclic motion, hung from a ring if it has a level."""
    made = Dressing(
        clone, pattern, ring_level, fabric, motion,
        cycles=cycles, step_m=step_m, under=under, elements=elements, resumed=resumed,
    )  # fmt: skip
    return made.simulate_walk(progress=progress)


class Dressing:
    """A garment during dressing: placed around the clone, settled, walked with; each step continues the one before.

    Parameters
    ----------
    clone : Clone
    pattern : Pattern
    ring_level : str or None
        Level of the ring that it hangs from, if any.
    fabric : Fabric
    motion : Motion
        Cyclic.
    under : DressedClone or None
        What is worn below already, in the same motion.
    elements : bool
        Let the source's integrator move it (`cloner.cloth.simulation.implicit`), not threads.
    resumed : Path or None
        Where its frames are kept cycle by cycle; what the same garment kept there is not simulated again.
    """

    def __init__(
        self,
        clone: Clone,
        pattern: Pattern,
        ring_level: str | None,
        fabric: Fabric,
        motion: Motion,
        *,
        cycles: int = CYCLES,
        step_m: float = STEP_M,
        under: DressedClone | None = None,
        elements: bool = False,
        resumed: Path | None = None,
    ) -> None:
        ring = body_ring(clone, ring_level) if ring_level is not None else None
        below = None if under is None else under.below()
        self.worn = place_garment(clone, pattern, ring, fabric, motion, step_m, below, elements=elements)
        self._clone, self._fabric, self._motion, self._cycles, self._under = clone, fabric, motion, cycles, under
        self._frames: list[Array] = []
        self._resumed, state = resumed, None
        if resumed is not None:
            self._key = simulation_digest(self.worn, cycles)
            self._frames, state = read_checkpoint(resumed, self._key) or ([], None)
        self._moving = simulate(self.worn, cycles, len(self._frames), state)

    def settle(self, watch: Watch = ignore_frame, *, progress: Progress = no_progress) -> None:
        """Let the garment settle on the clone at rest; ``watch`` sees every frame."""
        while len(self._frames) < SETTLE:
            places = self._next()
            watch(self.over_below(places, len(self._frames) - 1), np.zeros(3), np.zeros_like(self.worn.rotations[0]))
            progress("sew", len(self._frames) / SETTLE)

    def simulate_walk(self, watch: Watch = ignore_frame, *, progress: Progress = no_progress) -> DressedClone:
        """Simulate the walk until a loop is found; ``watch`` sees every frame of the walk."""
        self.settle(progress=lambda _, __: progress("cloth", 0.0))
        put, count = SETTLE + BLEND - 1, len(self.worn.rotations)
        total = self._cycles * count
        while len(self._frames) < put + total:
            number, places = len(self._frames) - put, self._next()
            if number >= 0:
                all_m = self.over_below(places, number + put)
                watch(all_m, self.worn.root_m[number % count], self.worn.rotations[number % count])
            progress("cloth", WALKED * max(number, 0) / total)
        places = np.array(self._frames)
        loop = find_loop(self.worn, places[put:], lambda gone: progress("loop", WALKED + (1.0 - WALKED) * gone))
        shown = places[: put + count]
        return DressedClone(self._clone, self._motion, self.worn, loop, self._fabric, shown, self._under)

    def over_below(self, places_m: Array, frame: int) -> Array:
        """Return the points of the layers below in a frame, followed by this garment's."""
        under = self.worn.under
        return places_m if under is None else np.concatenate([under.at(frame), places_m])

    def _next(self) -> Array:
        state = next(self._moving)[1]
        self._frames.append(state.places_m)
        if self._resumed is not None and len(self._frames) % len(self.worn.rotations) == 0:
            write_checkpoint(self._resumed, self._key, self._clone.stamp, self._frames, state)
        return state.places_m


def find_fabric(name: str) -> Fabric:
    """Return a fabric by its name, or of a file (.toml).

    Raises
    ------
    ClonerError
        If there is none of that name, or the file is none.
    """
    if Path(name).suffix.lower() == ".toml":
        return read_fabric(Path(name))
    if name not in FABRICS:
        raise ClonerError(
            f"the fabric {name!r} is not known",
            f"The fabrics are {', '.join([*FABRICS, 'or a .toml file'])}",
            "--fabric",
        )
    return FABRICS[name]


def find_pattern(clone: Clone, garment: str, length_cm: float | None) -> tuple[Pattern, str | None]:
    """Return the pieces of a named garment or a file's, and the level of the ring they hang from, if any.

    Raises
    ------
    ClonerError
        If there is no such garment, the file is none, or it cannot be so long.
    """
    read = FILES.get(Path(garment).suffix.lower())
    if read is not None:
        pattern = read(Path(garment), sections(clone))
        return pattern, WAIST if pattern.from_ring else None
    if garment not in GARMENTS:
        hint = f"The garments are {', '.join(GARMENTS)}, or a .json or .svg file"
        raise ClonerError(f"the garment {garment!r} is not known", hint, "--garment")
    length = None if length_cm is None else length_cm / 100.0
    if garment in TAILORED:
        body = sections(clone)
        lowest = LEGS_M + body.waist_m - float(body.place("crotch")[1]) if garment == TROUSERS else LENGTHS_M[0]
        if length is not None:
            _check_length(garment, length, lowest, body.waist_m)
        return draft_tailored(garment, body, length), None
    block = BLOCKS[garment]
    ring: Ring = body_ring(clone, block.ring)
    high = float(ring.points_m[0, 1])
    length = block.share * high if length is None else length
    _check_length(garment, length, LENGTHS_M[0], high)
    least = _hip_clearance_rad(sections(clone), ring.girth_m) if block.ring == WAIST else 0.0
    return draft_block(block, ring.girth_m, length, least), block.ring


def _hip_clearance_rad(body: Sections, ring_m: float) -> float:
    """Return the sectors' least angle, radians, with which a garment hung from the waist clears the hips."""
    depths = np.arange(HIPS_M, body.waist_m - float(body.place("crotch")[1]), 0.02)
    return max(
        (HIP_EASE * body.girth("trunk", body.waist_m - float(depth)) - ring_m) / float(depth) for depth in depths
    )


def _check_length(garment: str, length: float, lowest: float, high: float) -> None:
    if not lowest <= length <= min(LENGTHS_M[1], high - 0.03):  # neither nan
        hint = f"{100 * lowest:.0f} to {100 * min(LENGTHS_M[1], high - 0.03):.0f} cm hang clear of the floor"
        raise ClonerError(f"a {garment} of {100 * length:g} cm cannot be cut", hint, "--length")


def find_motion(clone: Clone, motion: str) -> Motion:
    """Return the clone's own walk, or a captured one as a cycle.

    Raises
    ------
    ClonerError
        If it is neither.
    """
    if motion == WALK:
        return own_motions(clone)[0]
    path = Path(motion)
    if path.suffix.lower() != ".bvh":
        raise ClonerError(f"the motion {motion!r} is not known", "Give walk, or a captured walk (.bvh)", "--motion")
    body = body_of(clone)
    return walk_cycle(body, retarget(read_bvh(path), body, name=path.stem))


def pictures(found: DressedClone, turn_deg: float = 30.0) -> Iterator[NDArray[np.uint8]]:
    """Yield the loop's rendered pictures."""
    camera = framing_camera(found.clone.vertices_m, turn_deg, *SIZE_PX)
    for frame in range(len(found.loop.frames_m)):
        shown = [
            replace(layer, vertices_m=layer.vertices_m + found.worn.root_m[frame])
            for layer in clone_layers(found.clone, found.worn.rotations[frame])
        ]
        for one in found.layers:
            places, faces = one.loop.frames_m[frame], one.worn.cloth.faces.astype(np.int32)
            red, green, blue = (value / 255.0 for value in one.fabric.rgb)
            normals = vertex_normals(places, faces)
            shown.append(Layer(places, normals, faces, colour=(red, green, blue), two_sided=True))
        yield draw(shown, camera, shading="soft", background=(226, 228, 230))
