"""A build guessed from a face: known people of the generic family, projected through a known lens."""

from __future__ import annotations

import numpy as np
import pytest

from cloner.body.portrait import Params, nearest_of_sex, portrait_shape
from cloner.detectors.face.face_net import load_face_net
from cloner.frames import ViewId
from cloner.generic.load import load_generic
from cloner.geometry.cameras.viewpoints import look_at
from cloner.head.modes import load_head_modes
from cloner.records.proposals import Proposal, Proposals
from cloner.records.views import Camera

SIZE = (1600, 1200)


def portrait(coefficients, *, stature_m=1.70, presence=1.0, noise_px=0.0, turn=0.0, own_m=0.0):
    """Return what the nets would say of a person of the family, photographed from 1.2 m with a 70 mm lens."""
    generic = load_generic()
    vertices, joints = generic.shape(np.asarray(coefficients), stature_m)
    vertices[generic.head_vertices] += own_m
    aim = np.array([0.0, 0.93 * stature_m, 0.0])
    eye = aim + 1.2 * np.array([np.sin(turn), 0.0, np.cos(turn)])
    camera = Camera(SIZE[1], SIZE[0], 70.0 / 36.0 * SIZE[0], look_at(eye, aim))
    face = camera.project(load_face_net().places.at(vertices))
    face += np.random.default_rng(5).normal(0.0, noise_px, face.shape) if noise_px else 0.0
    pose = np.zeros((33, 2))
    pose[[11, 12]] = camera.project(joints[[generic.joint("l_shoulder"), generic.joint("r_shoulder")]])
    blank = np.zeros(SIZE, dtype=np.uint8)
    seen = Proposal(ViewId.FACE_FRONT, pose, np.ones(33), face, np.zeros(468), presence, blank, blank)
    return Proposals({ViewId.FACE_FRONT: seen})


def sex(coefficients):
    """Return 0 (female) to 1 (male) by the family's own regression."""
    generic = load_generic()
    row = generic.phenotype_names.index("sex")
    share = generic.phenotype_from_shape[row, : len(coefficients)]
    return float(generic.phenotype_mean[row] + share @ coefficients)


def direction_of_sex():
    generic = load_generic()
    share = generic.phenotype_from_shape[generic.phenotype_names.index("sex"), : Params().shapes].astype(float)
    return share / np.linalg.norm(share)


@pytest.mark.parametrize("turn", [0.0, 0.06])
@pytest.mark.parametrize("sign", [-1.0, 1.0])
def test_the_sex_of_a_face_chooses_the_body(sign, turn):
    truth = 1.8 * sign * direction_of_sex()
    guess = portrait_shape(load_generic(), portrait(truth, noise_px=1.0, turn=turn))
    told = sign * (sex(guess) - sex(np.zeros(1)))
    assert 0.3 * 1.8 <= told / abs(sex(direction_of_sex()) - sex(np.zeros(1))) <= 1.3 * 1.8
    generic = load_generic()
    mean, _ = generic.shape(np.zeros(1), 1.70)
    wanted, _ = generic.shape(truth, 1.70)
    got, _ = generic.shape(guess, 1.70)
    below = generic.head_blend == 0.0
    apart = [np.linalg.norm(each[below] - wanted[below], axis=1).mean() for each in (mean, got)]
    assert apart[1] < 0.8 * apart[0], "nearer to the person's own body than the mean body is"


def test_a_told_sex_decides_and_changes_no_more_than_it_must():
    generic = load_generic()
    guess = portrait_shape(generic, portrait(1.8 * direction_of_sex(), noise_px=1.0))
    for told, number in (("f", 0.0), ("m", 1.0)):
        told_shape = nearest_of_sex(generic, guess, told)
        assert sex(told_shape) == pytest.approx(number)
        moved = told_shape - guess
        assert abs(moved @ direction_of_sex()) == pytest.approx(np.linalg.norm(moved))
    assert np.array_equal(nearest_of_sex(generic, guess, ""), guess)


def test_the_mean_face_has_the_mean_build_whatever_the_stature():
    for stature_m in (1.50, 1.95):
        guess = portrait_shape(load_generic(), portrait(np.zeros(1), stature_m=stature_m))
        assert np.abs(guess).max() < 0.25, stature_m


def test_what_a_face_has_of_its_own_is_no_build():
    generic, modes = load_generic(), load_head_modes()
    faces = modes.mean_m + 2.0 * modes.basis_m[:40]
    guesses = [portrait_shape(generic, portrait(np.zeros(1), own_m=face)) for face in faces]
    assert np.sqrt(np.mean(np.square(guesses))) < 0.1


def test_a_grimace_makes_no_caricature():
    guess = portrait_shape(load_generic(), portrait(np.zeros(1), noise_px=60.0))
    assert np.abs(guess).max() <= Params().max_sigmas


def test_without_a_face_the_build_is_the_mean():
    assert not portrait_shape(load_generic(), Proposals({})).any()
    assert not portrait_shape(load_generic(), portrait(np.ones(3), presence=0.0)).any()
