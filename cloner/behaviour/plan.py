"""A running scenario drawn from above: floors, obstacles, points, things, and people coloured by emotion."""

from __future__ import annotations

from collections.abc import Iterator
from typing import Final

import cv2
import numpy as np
from numpy.typing import NDArray

from cloner.behaviour.ground import BODY_M
from cloner.behaviour.model import Scenario
from cloner.behaviour.trajectories import Trajectories
from cloner.behaviour.walking import RATE_HZ

Pixels = NDArray[np.uint8]

#: Picture from above: longest side, pixels a metre at most, metres around the floor, a trail's frames; sRGB. Taste.
LONGEST_PX: Final = 1080
LARGEST_PX_PER_M: Final = 60.0
MARGIN_M: Final = 0.6
TRAIL_FRAMES: Final = 20
FLOOR, OUTSIDE, OBSTACLE, REGION, WORDS = (
    (238, 234, 226),
    (196, 190, 180),
    (128, 120, 110),
    (190, 205, 190),
    (90, 90, 90),
)
THING, AWAKE = (90, 110, 150), (200, 60, 40)
#: Colours of the emotions in the order of `model.EMOTIONS`, then of one's own; taste.
EMOTION_COLOURS: Final = ((70, 90, 150), (80, 150, 170), (120, 120, 120), (235, 170, 40), (225, 90, 160), (205, 35, 30),
                          (90, 160, 70), (140, 90, 190))  # fmt: skip
GROUP_COLOURS: Final = ((255, 255, 255), (20, 60, 200), (20, 140, 60), (0, 0, 0), (200, 0, 200), (0, 160, 160))
_SHIFT: Final = 4  # bits of a pixel's fraction that OpenCV draws


class Plan:
    """Draws one scenario."""

    def __init__(self, scenario: Scenario) -> None:
        corners = np.concatenate([np.array(one.corners) for one in scenario.floors])
        self._low, high = corners.min(axis=0) - MARGIN_M, corners.max(axis=0) + MARGIN_M
        size = high - self._low
        self._scale = min(LONGEST_PX / float(size.max()), LARGEST_PX_PER_M)
        self._height = round(float(size[1]) * self._scale) // 2 * 2
        self._scenario = scenario
        self._back = np.full((self._height, round(float(size[0]) * self._scale) // 2 * 2, 3), OUTSIDE, np.uint8)
        for shapes, colour in ((scenario.floors, FLOOR), (scenario.obstacles, OBSTACLE)):
            for shape in shapes:
                cv2.fillPoly(self._back, [self._px(np.array(shape.corners))], colour, cv2.LINE_AA, _SHIFT)
        for point in scenario.points:
            x, y, w, h = *point.at, point.size[0] / 2, point.size[1] / 2
            box = np.array([[x - w, y - h], [x + w, y - h], [x + w, y + h], [x - w, y + h]])
            cv2.polylines(self._back, [self._px(box)], True, REGION, 1, cv2.LINE_AA, _SHIFT)
            self._write(self._back, str(point.name), (x - w + 0.1, y + h - 0.35), WORDS)

    def _px(self, place: NDArray[np.float64]) -> NDArray[np.int32]:
        """Return pixels with their fraction; the plan's y goes up."""
        x = (place[..., 0] - self._low[0]) * self._scale
        y = self._height - (place[..., 1] - self._low[1]) * self._scale
        return np.asarray(np.rint(np.stack([x, y], axis=-1) * (1 << _SHIFT)).astype(np.int32))

    def _write(self, picture: Pixels, text: str, at: tuple[float, float], colour: tuple[int, int, int]) -> None:
        x, y = self._px(np.array(at)) >> _SHIFT
        shown = text.encode("ascii", "replace").decode()
        cv2.putText(picture, shown, (int(x), int(y)), cv2.FONT_HERSHEY_SIMPLEX, 0.4, colour, 1, cv2.LINE_AA)

    def draw(self, walk: Trajectories, frame: int) -> Pixels:
        """Return the picture (H, W, 3) of one frame: ticks show headings, rims groups, tails the last two seconds."""
        picture = self._back.copy()
        awake = {
            text.partition(" ")[0] for when, text in walk.told if when <= frame / RATE_HZ and text.endswith("awakens")
        }
        for thing in self._scenario.things:
            at = self._px(np.array(thing.at))
            colour = AWAKE if thing.name in awake else THING
            cv2.circle(picture, at.tolist(), round(0.35 * self._scale) << _SHIFT, colour, -1, cv2.LINE_AA, _SHIFT)
            self._write(picture, str(thing.name), (thing.at[0] - 0.4, thing.at[1] + 0.5), colour)
        here = np.flatnonzero(walk.present[frame])
        trail = walk.place[max(frame - TRAIL_FRAMES, 0) : frame + 1][:, here].transpose(1, 0, 2)
        if trail.shape[1] > 1:
            cv2.polylines(picture, list(self._px(trail)), False, (170, 165, 155), 1, cv2.LINE_AA, _SHIFT)
        radius = round(BODY_M * self._scale * (1 << _SHIFT))
        rims = {name: GROUP_COLOURS[k % len(GROUP_COLOURS)] for k, name in enumerate(dict.fromkeys(walk.groups))}
        for one in here:
            at = self._px(walk.place[frame, one]).tolist()
            tip = self._px(walk.place[frame, one] + walk.facing[frame, one] * BODY_M * 1.8).tolist()
            colour = EMOTION_COLOURS[int(walk.emotion[frame, one]) % len(EMOTION_COLOURS)]
            cv2.line(picture, at, tip, colour, max(round(self._scale / 20), 1), cv2.LINE_AA, _SHIFT)
            cv2.circle(picture, at, radius, colour, -1, cv2.LINE_AA, _SHIFT)
            cv2.circle(
                picture, at, radius, rims[walk.groups[one]], max(round(self._scale / 24), 1), cv2.LINE_AA, _SHIFT
            )
        self._write(
            picture,
            f"{frame / RATE_HZ:.1f} s   {len(here)} people",
            (self._low[0] + 0.2, self._low[1] + 0.15),
            (20, 20, 20),
        )
        return picture

    def film(self, walk: Trajectories) -> Iterator[Pixels]:
        """Yield every frame."""
        for frame in range(len(walk.place)):
            yield self.draw(walk, frame)
