"""Footsteps: the engine reports bodies' motion as footings (`core/feet/`).

A footing is the time in which one foot carries; its numbers are those of `cloner.crowd.staged.footing`.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import Final

import numpy as np
from numpy.typing import NDArray

from cloner.behaviour.core.host import CrowdEngine
from cloner.behaviour.dice import Indices
from cloner.behaviour.ground import Mask
from cloner.behaviour.walking import RATE_HZ
from cloner.pipeline import Progress, no_progress
from cloner.records.arrays import Array

#: So far beyond a footing's begin the track is looked at, seconds: the pace's .9, and the second after it.
SEEN_S: Final = 2.0
#: Frames of a track that are kept: feet are never farther behind the bodies.
KEPT: Final = 80
#: While many are baked, footings are taken from the engine after so many frames.
_TAKEN: Final = 10
#: The clips of every clone that come first: the usual walk, and standing.
WALK, IDLE = 0, 1
#: Columns of a footing.
_COLUMNS: Final = 13

Rows = NDArray[np.float32]


@dataclass(frozen=True, slots=True, eq=False)
class Feet:
    """Feet of those who act.

    Attributes
    ----------
    touches : (L, K, 48, 6) float32
        For each clone's look and clip, as of `cloner.crowd.staged.footing.Acted`.
    clips : (L, K, 2) float32, frames and seconds of each clip
    look : (N,) which look each person has
    scale : (N,) each person's size over the clone's
    phase : (N,) of the idle at first, 0..1
    still : mapping
        The clip of each act that is done standing, by its name; others stand.
    walks : mapping
        The clip of each style of walking, by its name; others walk as usual.
    run : int
        The clip of running, -1 for none.
    spare : int
        Looks that may come later.
    """

    touches: Rows
    clips: Rows
    look: Indices
    scale: Array
    phase: Array
    still: Mapping[str, int]
    walks: Mapping[str, int]
    run: int = -1
    spare: int = 0

    def counts(self) -> dict[str, int]:
        """Return the counts that the engine needs."""
        looks, clips = self.clips.shape[:2]
        return {"looks": looks + self.spare, "clips": clips, "frames": KEPT}

    def fill(self, core: CrowdEngine, acts: Sequence[int], walks: Sequence[int]) -> None:
        """Write the feet and the clips of acts and emotions into a new engine."""
        arrays = core.arrays
        arrays["touches"][: len(self.touches)], arrays["clips"][: len(self.clips)] = self.touches, self.clips
        arrays["look_of"][:], arrays["scale"][:], arrays["start_phase"][:] = self.look, self.scale, self.phase
        arrays["act_clip"][:], arrays["walk_clip"][:] = acts, walks
        arrays["foot_numbers"][:] = 0, self.run


@dataclass(frozen=True, slots=True, eq=False)
class Motions:
    """What bodies do, ten times a second: (f, n) per frame and person.

    ``place`` (f, n, 2) metres on the plan and ``facing`` (f, n, 2); who is ``present``; ``acts`` the clip of what is
    done standing, ``walks`` that of the walk.
    """

    place: Array
    facing: Array
    present: Mask
    acts: Indices
    walks: Indices


def compute_footings(done: Motions, feet: Feet, progress: Progress = no_progress) -> list[Rows]:
    """Return everybody's footings of given motions, each (m, 13) float32, from the first frame to the last."""
    frames, people = done.present.shape
    kinds = feet.clips.shape[1]
    core = CrowdEngine(
        {"people": people, "rows": 1, "cols": 1, "emotions": kinds, "acts": kinds, **feet.counts()}, (0.0, 0.0)
    )
    feet.fill(core, range(kinds), range(kinds))
    arrays, found = core.arrays, [np.zeros((0, _COLUMNS), np.float32) for _ in range(people)]
    for frame in range(frames):
        arrays["place"][:], arrays["facing"][:] = done.place[frame], done.facing[frame]
        arrays["present"][:] = done.present[frame]
        arrays["posture"][:], arrays["emotion"][:] = done.acts[frame], done.walks[frame]
        core.call("watch")
        if frame % _TAKEN == 0:
            core.call("stride", frame / RATE_HZ - SEEN_S)
            _add(found, take_footings(core))
            progress("footings", frame / frames)
    core.call("halt")
    _add(found, take_footings(core))
    return found


def take_footings(core: CrowdEngine) -> dict[int, Rows]:
    """Take new footings from the engine: (m, 13) per person, in time; the last ones may become longer."""
    count = int(core.arrays["foot_numbers"][0])
    rows = core.arrays["footings"][:count].copy()
    core.arrays["foot_numbers"][0] = 0
    rows = rows[np.argsort(rows[:, 0], kind="stable")]
    people, starts = np.unique(rows[:, 0], return_index=True)
    ends = np.append(starts, count)[1:]
    return {int(who): _latest_versions(rows[k:end, 1:]) for who, k, end in zip(people, starts, ends, strict=True)}


def _latest_versions(rows: Rows) -> Rows:
    """Return footings without those that are reported again, extended."""
    return np.asarray(rows[np.append(rows[1:, 0] != rows[:-1, 0], True)])


def _add(found: list[Rows], new: Mapping[int, Rows]) -> None:
    for who, rows in new.items():
        kept = found[who][found[who][:, 0] < rows[0, 0]]
        found[who] = np.concatenate([kept, rows])
