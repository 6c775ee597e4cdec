"""Every facial animation parameter moves its own feature, and the two compound ones are played."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest

from cloner.motion.face import faps
from kit.clones import toy_clone


@pytest.fixture(scope="module")
def clone():
    return toy_clone(1.70)


def played(clone, parameters: dict[int, float]) -> dict[str, float]:
    values, given = np.zeros((1, 68)), np.zeros((1, 68), dtype=bool)
    for number, value in parameters.items():
        values[0, number - 1], given[0, number - 1] = value, True
    return {name: float(w[0]) for name, w in faps.weights_of(clone, faps.FapStream(25.0, values, given)).items()}


def test_half_shut_lids_are_a_half_blink_and_nothing_else(clone) -> None:
    assert played(clone, {19: 512, 20: 512}) == pytest.approx({"eyeBlinkLeft": 0.5, "eyeBlinkRight": 0.5})


def test_lids_that_both_go_half_the_way_shut_the_eye_and_no_mouth_smiles(clone) -> None:
    shut = played(clone, {19: 512, 20: 512, 21: 512, 22: 512})
    assert shut == pytest.approx({"eyeBlinkLeft": 1.0, "eyeBlinkRight": 1.0})


def test_raised_mouth_corners_smile(clone) -> None:
    for corners in ((12, 13), (59, 60)):
        smiles = played(clone, dict.fromkeys(corners, 250))
        assert set(smiles) == {"mouthSmileLeft", "mouthSmileRight"}
        assert min(smiles.values()) > 0.25


REGION = {
    **dict.fromkeys((*range(3, 19), *range(51, 61)), ("mouth", "jaw")),
    **dict.fromkeys(range(19, 23), ("eyeBlink", "eyeWide", "eyeSquint")),
    **dict.fromkeys(range(31, 39), ("brow",)),
    **dict.fromkeys(range(39, 43), ("cheek",)),
    **dict.fromkeys(range(43, 48), ("tongue",)),
    **dict.fromkeys(range(61, 65), ("nose",)),
}


@pytest.mark.parametrize("number", sorted(REGION))
@pytest.mark.parametrize("value", [-200.0, 200.0])
def test_a_parameter_moves_its_own_part_of_the_face_alone(clone, number: int, value: float) -> None:
    assert all(name.startswith(REGION[number]) for name in played(clone, {number: value}))


def file_of(tmp_path: Path, mask: dict[int, int], numbers: str) -> Path:
    path = tmp_path / "one.fap"
    marks = " ".join("1" if number in mask else "0" for number in range(1, 69))
    path.write_text(f"2.1 one 25 1\n{marks}\n0 {numbers}\n")
    return path


@pytest.mark.parametrize("numbers", ["10 1 21", "10 1 21 0"])
def test_visemes_of_fap_1_are_blended_as_the_standard_says(clone, tmp_path: Path, numbers: str) -> None:
    """21 of 63 of viseme 10 (A:), the rest of viseme 1 (p, b, m)."""
    weights = faps.weights_of(clone, faps.read_fap(file_of(tmp_path, {1: 1}, numbers)))
    assert {name: values[0] for name, values in weights.items()} == pytest.approx(
        {"viseme_aa": 1 / 3, "viseme_PP": 2 / 3}
    )


@pytest.mark.parametrize("numbers", ["1 63 0 0 100", "1 63 0 0 0 0 100"])
def test_expressions_of_fap_2_come_with_what_else_a_frame_says(clone, tmp_path: Path, numbers: str) -> None:
    """Joy at full intensity, as the product's own expression has it, and a jaw a little open."""
    stream = faps.read_fap(file_of(tmp_path, {2: 1, 3: 1}, numbers))
    assert stream.values[0, 2] == 100.0
    weights = {name: values[0] for name, values in faps.weights_of(clone, stream).items()}
    assert weights["mouthSmileLeft"] == pytest.approx(0.8)
    assert 0.0 < weights["jawOpen"] < 0.3
