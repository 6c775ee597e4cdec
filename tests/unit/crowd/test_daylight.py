"""Numbers of a room's light: what the eye gets used to, and where the sun looks from."""

from __future__ import annotations

import numpy as np
import pytest

from cloner.crowd.staged.daylight import CAST_DEEP_M, CAST_M, CAST_PX, KEY, RoomLight, exposure, sun_clip
from cloner.crowd.staged.rooms import Probes

AHEAD = np.array([0.0, 0.0, -1.0])
EYE = np.array([1.0, 1.6, 1.0])
NO_SUN = {"sun_light": [0.0, 0.0, 0.0]}


def even(colour: tuple[float, float, float]) -> Probes:
    """Probes of one light everywhere."""
    light = np.zeros((2, 3, 3, 3, 4), np.float32)
    light[..., 0] = colour
    return Probes(np.zeros(3), np.array([0.5, 1.5]), 1.0, light, np.zeros((2, 3, 3), np.float32))


def test_light_that_shows_white_as_white_is_left_alone() -> None:
    assert exposure(even((KEY, KEY, KEY)), NO_SUN, EYE, AHEAD, RoomLight()) == pytest.approx((1.0, 1.0, 1.0))


def test_a_darker_room_is_lifted_but_stays_darker() -> None:
    gain = exposure(even((0.1, 0.1, 0.1)), NO_SUN, EYE, AHEAD, RoomLight())[0]
    assert 0.3 < 0.1 * gain < KEY


def test_a_colour_of_light_is_taken_half_away() -> None:
    warm = np.array([0.4, 0.2, 0.1])
    shown = warm * exposure(even((0.4, 0.2, 0.1)), NO_SUN, EYE, AHEAD, RoomLight())
    assert shown[0] / shown[2] == pytest.approx(2.0)  # of four


def test_a_night_is_seen_as_dark() -> None:
    day = exposure(even((0.5, 0.5, 0.5)), NO_SUN, EYE, AHEAD, RoomLight())[1]
    night = exposure(even((0.5, 0.5, 0.5)), NO_SUN, EYE, AHEAD, RoomLight(daylight=(0.01, 0.01, 0.01)))[1] * 0.01
    assert night < 0.1 * day
    more = exposure(even((0.5, 0.5, 0.5)), NO_SUN, EYE, AHEAD, RoomLight(stops=1.0))[1]
    assert more == pytest.approx(2.0 * day)


def test_what_lies_towards_the_sun_falls_on_one_point_of_its_picture_and_nearer() -> None:
    way = np.array([0.6, 0.64, -0.48])
    clip = sun_clip({"sun_way": way.tolist()}, EYE, AHEAD)
    floor = np.array([0.5, 0.0, -4.0, 1.0])
    above = floor + np.append(2.0 * way, 0.0)
    low, high = clip @ floor, clip @ above
    assert low[:2] == pytest.approx(high[:2], abs=1e-9)
    assert low[2] - high[2] == pytest.approx(2.0 / CAST_DEEP_M)
    aside = np.cross([0.0, 0.0, 1.0], way)
    aside /= np.linalg.norm(aside)
    assert (clip @ (floor + np.append(aside, 0.0)) - low)[0] == pytest.approx(1.0 / CAST_M)


def test_shadows_do_not_swim_with_the_eye() -> None:
    told = {"sun_way": [0.6, 0.64, -0.48]}
    first, other = sun_clip(told, EYE, AHEAD), sun_clip(told, EYE + (0.013, 0.0, 0.007), AHEAD)
    moved = (other - first)[:2, 3] * CAST_PX / 2.0
    assert moved == pytest.approx(np.round(moved), abs=1e-6)
