"""How rooms sound: the time that Eyring's formula gives a room of even walls, and what is heard first."""

from __future__ import annotations

import io
import wave

import numpy as np
import pytest

from cloner.motion.face.sound import wav_bytes
from cloner.scenes.building.reading import parse_plan
from cloner.scenes.building.solids import Room, build_room
from cloner.scenes.lighting.echoes import (
    APART_M,
    RATE_HZ,
    SPEED_M_S,
    STEP_S,
    TAKES,
    energies,
    impulse_response,
    reverberation_s,
)


def box(look: str, roofed: bool = True) -> Room:
    """A closed room of 8 x 6 x 4 m, all of one look."""
    walls = "".join(
        f'[[wall]]\nfrom = {low}\nto = {high}\nhigh = 4\nlook = "{look}"\n'
        for low, high in (([-0.3, -0.3], [8.3, 0]), ([-0.3, 6], [8.3, 6.3]), ([-0.3, 0], [0, 6]), ([8, 0], [8.3, 6]))
    )
    roof = f'[[ceiling]]\nfrom = [-0.3, -0.3]\nto = [8.3, 6.3]\nat = 4\nlook = "{look}"\n' if roofed else ""
    return build_room(parse_plan(f'[[floor]]\nfrom = [0, 0]\nto = [8, 6]\nlook = "{look}"\n{walls}{roof}', "a box"))


@pytest.mark.parametrize("look", ["plaster", "timber", "earth"])
def test_a_closed_room_rings_as_long_as_eyring_says(look: str) -> None:
    volume, area = 8 * 6 * 4, 2 * (8 * 6 + 8 * 4 + 6 * 4)
    expected = 24.0 * np.log(10.0) / SPEED_M_S * volume / (-area * np.log(1.0 - TAKES[look]))
    found = reverberation_s(energies(box(look), np.array([2.0, 1.6, -2.0]), np.array([6.0, 1.6, -4.0])))
    assert found == pytest.approx(expected, rel=0.12)


def test_without_a_roof_it_rings_shorter() -> None:
    places = np.array([2.0, 1.6, -2.0]), np.array([6.0, 1.6, -4.0])
    assert reverberation_s(energies(box("plaster", roofed=False), *places)) < 0.4 * reverberation_s(
        energies(box("plaster"), *places)
    )


def test_what_comes_straight_is_heard_first_and_loudest() -> None:
    energy = energies(box("earth"), np.array([2.0, 1.6, -3.0]), np.array([5.43, 1.6, -3.0]))
    first = int(np.flatnonzero(energy)[0])
    assert first * STEP_S == pytest.approx(3.43 / SPEED_M_S, abs=STEP_S)
    assert energy.argmax() == first
    assert energy[first] == pytest.approx(1.0 / (4.0 * np.pi * 3.43**2))


def test_the_file_is_a_wav_of_its_samples() -> None:
    echo = impulse_response(box("timber"), np.array([4.0, 1.6, -3.0]), rays=300)
    assert np.abs(echo.samples).max() == pytest.approx(1.0)
    assert int(np.abs(echo.samples).argmax()) / RATE_HZ == pytest.approx(APART_M / SPEED_M_S, abs=STEP_S)
    with wave.open(io.BytesIO(wav_bytes(echo.samples, RATE_HZ))) as file:
        assert (file.getframerate(), file.getnchannels(), file.getsampwidth()) == (RATE_HZ, 1, 2)
        assert file.getnframes() == len(echo.samples)
