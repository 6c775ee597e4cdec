"""Targets of a face added up stay a face: lids never pass each other or the eye, lips never cross, no jaw unhinges."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest

from cloner.evaluate.measures.face_motion import mixture_figures
from cloner.generic.face_grids import lip_gaps_m, mouth_grid
from cloner.generic.load import load_generic
from cloner.head.parts import place_eyes_and_mouth
from cloner.head.targets import face_targets
from cloner.motion.face.limits import limited
from kit.clones import toy_clone


@pytest.fixture(scope="module")
def clone():
    toy = toy_clone()
    rest = place_eyes_and_mouth(toy.vertices_m, toy.vertices_m, None)
    names, index, delta, start = face_targets(rest)
    return replace(toy, vertices_m=rest, morph_names=names, morph_index=index, morph_delta_m=delta, morph_start=start)


def held(clone, **weights: float) -> dict[str, float]:
    found = limited(clone, {name: np.array([0.0, weight]) for name, weight in weights.items()})
    assert all(values[0] == 0.0 for values in found.values())
    return {name: float(values[1]) for name, values in found.items()}


def both(name: str, weight: float) -> dict[str, float]:
    return {f"{name}Left": weight, f"{name}Right": weight}


def test_a_sound_face_is_left_as_it_is(clone) -> None:
    weights = {"jawOpen": 0.4, **both("mouthSmile", 0.6), **both("eyeBlink", 0.7), "browInnerUp": 1.0}
    assert held(clone, **weights) == pytest.approx(weights, abs=0.03)
    assert held(clone, jawOpen=1.0, mouthClose=1.0) == pytest.approx({"jawOpen": 1.0, "mouthClose": 1.0}, abs=0.02)


def test_names_that_the_clone_has_not_are_dropped(clone) -> None:
    assert limited(clone, {"growl": np.ones(3)}) == {}


@pytest.mark.parametrize("other", ["eyeLookUp", "eyeLookDown", "eyeWide", "eyeSquint", "cheekSquint"])
def test_a_blink_shuts_the_eye_whatever_else_the_lids_do(clone, other) -> None:
    weights = held(clone, **both("eyeBlink", 1.0), **both(other, 1.0))
    figures = mixture_figures(clone, weights)
    assert figures.lid_gap_left < (1.7 if other == "cheekSquint" else 0.25)
    assert figures.eye_through < 0.05
    before = mixture_figures(clone, {**both("eyeBlink", 1.0), **both(other, 1.0)})
    assert figures.lid_gap_left <= before.lid_gap_left + 0.1


def test_everything_at_once_is_still_a_face(clone) -> None:
    everything = {"jawOpen": 1.0, "viseme_aa": 1.0, "viseme_PP": 1.0, **both("mouthSmile", 1.0),
                  **both("eyeBlink", 1.0), **both("eyeSquint", 1.0), **both("cheekSquint", 1.0)}  # fmt: skip
    wild, tame = mixture_figures(clone, everything), mixture_figures(clone, held(clone, **everything))
    alone = mixture_figures(clone, {"jawOpen": 1.0})
    assert wild.lip_gap > 1.3 * alone.lip_gap
    assert tame.lip_gap < 1.1 * alone.lip_gap
    assert tame.eye_through < 0.05
    assert tame.teeth_through < 0.5
    assert tame.lid_gap_left < 1.7


def test_lips_do_not_cross(clone) -> None:
    grid, generic = mouth_grid(), load_generic()
    assert "mouthClose" in generic.arkit_names
    weights = held(clone, mouthClose=1.0, mouthShrugLower=1.0, mouthRollUpper=0.5)
    shape = clone.vertices_m.copy()
    for name, weight in weights.items():
        k = clone.morph_names.index(name)
        rows = slice(clone.morph_start[k], clone.morph_start[k + 1])
        shape[clone.morph_index[rows]] += weight * clone.morph_delta_m[rows]
    assert 1000.0 * lip_gaps_m(grid, shape[grid.rings]).min() > -1.5
    assert weights["mouthClose"] < 0.3
