"""One person's way told as footings: steps whose length and pace follow the trajectory, turns, and acts between.

The trajectory says where somebody is ten times a second; a body gets there by steps. So it runs ahead or behind by
decimetres, and stays where it is while the trajectory creeps by less than a step.
"""

from __future__ import annotations

from dataclasses import dataclass, field
from typing import Final

import numpy as np
from numpy.typing import NDArray

from cloner.crowd.clones.clips import WALK_FRAMES
from cloner.crowd.staged.footing import BLEND_S, COLUMNS, FEELS, LEFT, LIFT_PARTS, MIDDLE, RIGHT, parts_of, turned_by
from cloner.crowd.staged.scene import IDLE
from cloner.records.arrays import Array

#: Who stands begins to walk when the trajectory is so far away, metres: the shortest two half steps make .3 m.
START_M: Final = 0.25
#: Where the trajectory rests one stays if it is no farther than this, metres: nobody turns about for half a step.
STAY_M: Final = 0.45
#: How far ahead the trajectory is looked at for pace, and beyond a step's end for its direction, seconds; taste.
AHEAD_S: Final = 0.9
BEYOND_S: Final = 0.35
#: Steps are not shorter than this share of the style's, nor is its pace slower or faster than these: a slower walk is
#: half in length and half in pace (walkers §4: both by the square root).
SHORTEST: Final = 0.5
#: Steps of this share and more are whole ones: a whole walk is smooth between its frames, a blended one shows frame
#: after frame. From .994 on ways that turn by .5 rad/s would count, whose feet twist between frames.
WHOLE: Final = 0.998
SLOWEST, FASTEST = 0.6, 1.7
#: So much faster than their walk people begin to run, and walk again; taste.
RUNS, WALKS = 1.4, 1.2
#: Walkers turn by this at most, radians a second, so that they keep up with ways that turn by 1.5; who is
#: more than the second off stops and turns first.
TURNS_RAD_S: Final = 2.0
ABOUT_RAD: Final = 1.6
#: Who begins to walk turns first on the spot when off by more than this, radians: what a step turns.
BEGIN_RAD: Final = 0.75
#: Who stands turns when off by more than the first, radians, by the second at most in one turn of so many seconds.
OFF_RAD: Final = 0.15
TURN_RAD: Final = 1.7
TURN_S: Final = 0.45
#: Who stands looks again after this time, seconds: the trajectory's own.
WAIT_S: Final = 0.1
#: So far beyond a footing's begin the trajectory is looked at, seconds: `AHEAD_S`, and the second after it.
SEEN_S: Final = 2.0
#: The trajectory has come to rest if it goes no farther than this in the second after the next half, metres.
REST_M: Final = 0.15


@dataclass(frozen=True, slots=True, eq=False)
class Track:
    """What one person is to do: (f,) times; (f, 2) x and z, metres; (f,) headings, clips while standing, walks."""

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


@dataclass(slots=True, eq=False)
class Walker:
    """One clone on the way.

    ``touches`` (K, WALK_FRAMES, 6) and ``clips`` (K, 2) are the clone's (`crowd.staged.footing.Acted`), ``scale`` the
    person's, ``phase`` that of the idle at first, 0..1, ``run`` the clip of running (-1: none).
    """

    track: Track
    touches: NDArray[np.float32]
    clips: NDArray[np.float32]
    scale: float
    phase: float
    now: float = 0.0
    at: Array = field(init=False)
    heading: float = field(init=False)
    clip: int = IDLE
    share: float = 0.0
    rows: list[list[float]] = field(default_factory=list)
    run: int = -1
    _still: float = 0.0
    _left: bool = True
    _idle: float = 0.0

    def __post_init__(self) -> None:
        self.now = float(self.track.times_s[0])
        self.at = self.track.place(self.now)
        self.heading = float(self.track.headings[0])

    def enter(self, now: float, place: Array, heading: float) -> None:
        """Stand at a place from a time on, as who was not there before."""
        self.now, self.at, self.heading = now, place, heading
        self.clip, self.share, self._left = IDLE, 0.0, True
        self.rows.clear()

    def footings(self) -> Array:
        """Return (n, COLUMNS) all footings from the track's begin to its end; none where that is the same."""
        end = float(self.track.times_s[-1])
        self._go_on(end)
        if self.rows:
            self.rows[-1][1] = max(self.rows[-1][1], end)
        return np.array(self.rows).reshape(-1, COLUMNS)

    def more(self, until: float) -> NDArray[np.float32]:
        """Return (n, COLUMNS) the footings that were added until a time, and the last one before if it goes on.

        The track is one that reaches `SEEN_S` beyond, or as far as there is any. Only the last footing is kept.
        """
        told = self.rows[-1][1] if self.rows else -1.0
        self._go_on(until)
        new = self.rows if not self.rows or self.rows[0][1] != told else self.rows[1:]
        found = np.array(new, np.float32).reshape(-1, COLUMNS)
        del self.rows[:-1]
        return found

    def _go_on(self, until: float) -> None:
        if not self.rows and self.now < until:
            self._stand(IDLE, WAIT_S)
        while self.now < until:
            if self.share:
                self._walk()
            else:
                self._wait()

    def _wait(self) -> None:
        """Go on from standing: begin to walk, turn, or do what is to be done."""
        gone = self.track.place(self.now + AHEAD_S / 2.0) - self.at
        far = self.track.place(self.now + AHEAD_S) - self.at
        row = self.track.row(self.now)
        moves = np.hypot(*(self.track.place(self.now + AHEAD_S) - self.track.place(self.now))) > REST_M
        if min(np.hypot(*gone), np.hypot(*far)) > (START_M if moves else STAY_M):
            turn = wrapped(np.arctan2(far[0], far[1]) - self.heading)
            if self.clip != IDLE:
                self._stand(IDLE, BLEND_S)
            elif abs(turn) > BEGIN_RAD:
                self._turn(turn)
            else:
                self._begin(self._gait(int(self.track.walks[row])))
            return
        turn = wrapped(self.track.headings[self.track.row(self.now + TURN_S)] - self.heading)
        if abs(turn) > OFF_RAD:
            self._stand(IDLE, BLEND_S) if self.clip != IDLE else self._turn(turn)
        else:
            self._stand(int(self.track.acts[self.track.row(self.now + BLEND_S)]), WAIT_S)

    def _stand(self, clip: int, seconds: float) -> None:
        """Stand and act for some time; the same goes on in the same footing."""
        feels = float(self.track.walks[self.track.row(self.now)])
        if self.rows and self.clip == clip and self.rows[-1][5] < 0.0 and self.rows[-1][FEELS] == feels:
            self.rows[-1][1] = self.now = self.now + seconds
            return
        if self.rows and self.clip != clip:
            seconds = max(seconds, BLEND_S)
        before, last = self._body(self.clip), self._frame(self.clip)
        x, z = self._body(clip)
        blended = float(self.clip) if self.rows and self.clip != clip else -1.0
        first = self._still if clip == IDLE else 0.0
        if not self.rows:
            first = self.phase
        self.rows.append([self.now, self.now + seconds, clip, blended, first, -1.0 - last, *before, x, z,
                          self.heading, self.heading, feels])  # fmt: skip
        self.now, self.clip = self.now + seconds, clip

    def _body(self, clip: int) -> Array:
        """Return (2,) where the body is in a clip that is done standing here; its feet are those of the idle."""
        feet = self.touches[clip, :1, :2].astype(np.float64) * self.scale
        return np.asarray(self.at - turned_by(np.array([self.heading]), feet)[0])

    def _frame(self, clip: int) -> float:
        """Return the frame that is shown now of what is done standing, and keep the idle's phase."""
        if not self.rows or self.rows[-1][5] >= 0.0:
            return 0.0
        count, seconds = self.clips[clip].astype(np.float64)
        phase = np.mod(self.rows[-1][4] + (self.now - self.rows[-1][0]) / seconds, 1.0)
        if clip == IDLE:
            self._still = float(phase)
        return float(min(int(phase * count), count - 1))

    def _turn(self, turn: float) -> None:
        """Turn on the spot, on the foot of the side to which it goes."""
        frame = (LEFT if turn > 0.0 else RIGHT) + MIDDLE
        turn = float(np.clip(turn, -TURN_RAD, TURN_RAD))
        walk = int(self.track.walks[self.track.row(self.now)])
        self._go(walk, frame, frame, TURN_S, (0.0, 0.0), turn)

    def _begin(self, walk: int) -> None:
        """Make the half step that begins to walk."""
        base = LEFT if self._left else RIGHT
        share, rate = self._pace(walk)
        frames = RIGHT - LEFT - MIDDLE
        self._go(walk, base + MIDDLE, base + RIGHT - LEFT, self._seconds(walk, LIFT_PARTS + frames, rate), (0.0, share),
                 self._towards(frames, walk, rate))  # fmt: skip

    def _walk(self) -> None:
        """Make another step, or the half step that ends walking, whichever ends nearer to where the track rests."""
        base = LEFT if self._left else RIGHT
        row = self.track.row(self.now)
        later = [self.track.place(self.now + AHEAD_S + more) for more in (0.0, 1.0)]
        turn = wrapped(self._way(self.now + AHEAD_S) - self.heading)
        walk = self._gait(int(self.track.walks[row]))
        stop = abs(turn) > ABOUT_RAD
        share, rate = self._pace(walk)
        share = 1.0 if walk != self.clip else share
        seconds = self._seconds(self.clip, RIGHT - LEFT, rate)
        turn = self._towards(RIGHT - LEFT, self.clip, rate)
        if not stop and np.hypot(*(later[1] - later[0])) < REST_M:
            halt = self._end_of(base, base + MIDDLE, (self.share, 0.0), 0.0)
            other = RIGHT if self._left else LEFT
            step = self._end_of(base, base + RIGHT - LEFT, (self.share, SHORTEST), turn) - self.at
            step = step + self._end_of(other, other + MIDDLE, (SHORTEST, 0.0), 0.0)
            stop = np.hypot(*(halt - later[1])) <= np.hypot(*(step - later[1]))
        if stop:
            seconds = self._seconds(self.clip, MIDDLE + LIFT_PARTS, max(rate, 0.8))
            self._go(self.clip, base, base + MIDDLE, seconds, (self.share, 0.0), 0.0)
        else:
            over = walk != self.clip and self.share == 1.0  # one goes over to another walk in whole steps alone
            self._go(walk if over else self.clip, base, base + RIGHT - LEFT, seconds, (self.share, share), turn,
                     before=self.clip if over else -1)  # fmt: skip

    def _end_of(self, first: int, last: int, shares: tuple[float, float], turn: float) -> Array:
        row = np.array([0.0, 1.0, self.clip, 0.0, first, last, *shares, *self.at, self.heading, self.heading + turn])
        return np.asarray(parts_of(row, self.touches, self.scale).places[-1])

    def _gait(self, walk: int) -> int:
        """Return the walk, or the run for whom it is too slow; who runs goes on until the walk is fast enough."""
        if self.run < 0:
            return walk
        own = float(np.hypot(*(self.track.place(self.now + AHEAD_S) - self.track.place(self.now)))) / AHEAD_S
        faster = own / (self._speed(walk) * self.scale)
        return self.run if faster > (WALKS if self.clip == self.run else RUNS) else walk

    def _go(
        self,
        clip: int,
        first: int,
        last: int,
        seconds: float,
        shares: tuple[float, float],
        turn: float,
        before: int = -1,
    ) -> None:
        """Add a footing of walking or turning, going over from the walk ``before`` if any, and be at its end."""
        if self.rows[-1][5] < 0.0:
            self._idle = self._frame(IDLE)
        idle = self._idle if before < 0 else -1.0 - before
        row = [self.now, self.now + seconds, clip, idle, first, last, *shares, *self.at,
               self.heading, self.heading + turn, self.track.walks[self.track.row(self.now)]]  # fmt: skip
        whole = np.array(row, np.float32)
        self.rows.append(row)
        self.at = parts_of(whole, self.touches, self.scale).places[-1]
        self.now, self.heading = self.now + seconds, wrapped(self.heading + turn)
        self.share, self.clip = shares[1], clip if shares[1] else IDLE
        if last > first:
            self._left = not self._left if last - first != MIDDLE else self._left

    def _pace(self, walk: int) -> tuple[float, float]:
        """Return how long steps are, as a share of the walk's, and how fast they follow one another."""
        needed = float(np.hypot(*(self.track.place(self.now + AHEAD_S) - self.at))) / AHEAD_S
        ratio = needed / (self._speed(walk) * self.scale)
        share = float(np.clip(np.sqrt(ratio), SHORTEST, 1.0))
        share = 1.0 if share > WHOLE else share
        return share, float(np.clip(ratio / share, SLOWEST, FASTEST))

    def _speed(self, walk: int) -> float:
        """Return the walk's own speed, metres a second."""
        own = self.touches[walk].astype(np.float64)
        return float((own[:, 1] - own[:, 3]).sum()) / float(self.clips[walk, 1])

    def _seconds(self, walk: int, frames: int, rate: float) -> float:
        return float(self.clips[walk, 1]) * frames / WALK_FRAMES / rate

    def _way(self, when: float) -> float:
        """Return the heading towards where the track is at a time; one's own when that is here."""
        away = self.track.place(when) - self.at
        return float(np.arctan2(away[0], away[1])) if np.hypot(*away) > START_M / 2.0 else self.heading

    def _towards(self, frames: int, walk: int, rate: float) -> float:
        """Return by how much a step turns, radians."""
        seconds = self._seconds(walk, frames, rate)
        most = TURNS_RAD_S * seconds
        return float(np.clip(wrapped(self._way(self.now + seconds + BEYOND_S) - self.heading), -most, most))


def wrapped(angle: float) -> float:
    """Return an angle in -pi..pi."""
    return float((angle + np.pi) % (2.0 * np.pi) - np.pi)
