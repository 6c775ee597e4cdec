"""Tracks of people, ten times a second, in a page's frame, and the footings that the engine computes."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray

from cloner.behaviour.feet import Feet, Motions, compute_footings
from cloner.pipeline import Progress, no_progress
from cloner.records.arrays import Array


@dataclass(frozen=True, slots=True, eq=False)
class Track:
    """One person's task: (f,) times; (f, 2) x and z, metres; (f,) headings, clips while standing, walks."""

    times_s: Array
    places_m: Array
    headings: Array
    acts: NDArray[np.int64]
    walks: NDArray[np.int64]

    def place(self, now: float) -> Array:
        """Return (2,) x and z at a time."""
        return np.array([np.interp(now, self.times_s, self.places_m[:, axis]) for axis in (0, 1)])

    def row(self, now: float) -> int:
        """Return the last frame that is not later."""
        return min(max(int(np.searchsorted(self.times_s, now + 1e-9, side="right")) - 1, 0), len(self.times_s) - 1)


def footings_on_tracks(
    tracks: Sequence[Track], feet: Feet, progress: Progress = no_progress
) -> list[NDArray[np.float32]]:
    """Return everybody's footings, each (m, COLUMNS); who has no more track has gone."""
    frames, people = max(len(one.places_m) for one in tracks), len(tracks)
    place, facing = np.zeros((frames, people, 2)), np.zeros((frames, people, 2))
    present = np.zeros((frames, people), bool)
    acts, walks = (np.zeros((frames, people), np.int64) for _ in range(2))
    for who, one in enumerate(tracks):
        rows = slice(0, len(one.places_m))
        place[rows, who] = one.places_m * (1.0, -1.0)
        facing[rows, who] = np.stack([np.sin(one.headings), -np.cos(one.headings)], axis=1)
        present[rows, who], acts[rows, who], walks[rows, who] = True, one.acts, one.walks
    return compute_footings(Motions(place, facing, present, acts, walks), feet, progress)


def make_feet(
    touches: NDArray[np.float32], lengths: NDArray[np.float32], rows: NDArray[np.float32],
    clips: Sequence[Mapping[str, Any]], *, spare: int = 0,
) -> Feet:  # fmt: skip
    """Return the feet of a pack's people.

    Parameters
    ----------
    touches, lengths
        ``touches`` and ``clips`` of :class:`~cloner.crowd.staged.footing.Acted`.
    rows : (N, 5, 4), rows of those people
    clips : rows of the clones' clips in ``crowd.json``
    spare : int
        Looks that may come later.
    """
    names = [str(one["name"]) for one in clips]
    own = rows[:, 1].astype(np.float64)
    return Feet(
        touches, lengths, own[:, 2].astype(np.int64), own[:, 3], own[:, 1],
        still={str(one["name"]): k for k, one in enumerate(clips) if not one["speed_m_s"]},
        walks={name.removeprefix("walk_"): k for k, name in enumerate(names) if name.startswith("walk_")},
        run=names.index("run") if "run" in names else -1, spare=spare,
    )  # fmt: skip
