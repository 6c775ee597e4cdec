"""Random faces move well: lids close on the eyeball, lips meet, teeth stay inside, ears and skull stay still."""

from __future__ import annotations

from dataclasses import asdict, replace

import numpy as np
import pytest

from cloner.evaluate.measures import face_motion
from cloner.evaluate.truths.baselines import generic_clone
from cloner.generic.face_grids import eye_grid, eyeball, mouth_grid
from cloner.generic.load import load_generic
from cloner.head.parts import place_eyes_and_mouth
from cloner.head.targets import face_targets
from cloner.motion.face.limits import limited
from kit.scripts import script

SEEDS = (2, 7)


def random_person(seed: int) -> np.ndarray:
    """A random person of the head benchmark, every second one bent out of the family, as the head stage seats it."""
    generic = load_generic()
    person, stature_m = script("head_people").random_face(generic, np.random.default_rng(seed), bent=bool(seed % 2))
    return place_eyes_and_mouth(generic.shape(np.zeros(1), stature_m)[0], person, None)


@pytest.fixture(scope="module", params=SEEDS)
def person(request):
    rest = random_person(request.param)
    names, index, delta, start = face_targets(rest)
    steps = {}
    for k, name in enumerate(names):
        rows = slice(start[k], start[k + 1])
        steps[name] = np.zeros_like(rest)
        steps[name][index[rows]] = delta[rows]
    return rest, steps


def packed(steps):
    """Targets as a clone keeps them: names, vertices, offsets, starts."""
    rows = {name: np.flatnonzero(step.any(axis=1)) for name, step in steps.items()}
    start = np.cumsum([0, *(len(own) for own in rows.values())]).astype(np.int32)
    delta = np.concatenate([steps[name][own] for name, own in rows.items()]).astype(np.float32)
    return tuple(rows), np.concatenate(list(rows.values())).astype(np.int32), delta, start


def test_at_rest_lids_lie_on_eyeballs_of_real_size_and_lips_meet(person) -> None:
    rest, _ = person
    figures = face_motion.face_figures(rest, rest)
    assert figures.eye_through < 0.0
    assert figures.lip_gap < 0.2
    assert figures.teeth_through < 0.1
    assert figures.teeth_shown < 0.1
    for side in ("left", "right"):
        ball, margin = eyeball(rest, side), rest[eye_grid(side).ring(0)]
        middle = np.abs(margin[:, 0] - ball.centre[0]) < 0.005
        away = 1000.0 * ball.outside(margin[middle])
        assert 0.5 < away.min()
        assert away.max() < 1.2, "as thick as a lid"


def test_all_targets_are_there_and_move_no_ear_no_skull_and_no_eye_through_a_lid(person) -> None:
    rest, steps = person
    generic = load_generic()
    assert tuple(steps) == (*generic.arkit_names, *generic.viseme_names)
    assert all(np.abs(step).max() > 0.001 for name, step in steps.items() if name != "viseme_sil")
    for name in ("browDownLeft", "cheekSquintLeft", "eyeBlinkLeft", "eyeBlinkRight", "eyeLookDownLeft", "eyeLookInLeft",
                 "eyeLookUpRight", "eyeSquintLeft", "eyeWideLeft", "mouthSmileLeft", "noseSneerRight", "jawOpen",
                 "mouthRollUpper", "viseme_aa", "viseme_O"):  # fmt: skip
        figures = face_motion.worst_along_path(rest, steps[name])
        assert figures.eye_through < 0.05, name
        assert figures.teeth_through < 0.5, name
        assert figures.tongue_through < 0.5, name
        assert figures.ears < 0.5, name
        assert figures.skull < 0.5, name


def test_a_blink_closes_the_lids_and_a_half_blink_half(person) -> None:
    rest, steps = person
    for side in ("Left", "Right"):
        opened, half, shut = (
            asdict(face_motion.face_figures(rest, rest + share * steps[f"eyeBlink{side}"]))[f"lid_gap_{side.lower()}"]
            for share in (0.0, 0.5, 1.0)
        )
        assert opened > 4.0
        assert 0.3 * opened < half < 0.7 * opened
        assert shut < 0.5


def test_lips_close_where_they_should_and_open_with_the_jaw(person) -> None:
    rest, steps = person
    for shape in (steps["viseme_PP"], steps["mouthPressLeft"], steps["jawOpen"] + steps["mouthClose"]):
        assert face_motion.face_figures(rest, rest + shape).lip_gap < 0.5
    opened = face_motion.face_figures(rest, rest + steps["jawOpen"])
    assert 20.0 < opened.lip_gap < 60.0
    assert 0.3 < opened.teeth_shown < 6.0


def test_teeth_and_tongue_move_whole_with_the_jaw(person) -> None:
    rest, steps = person
    generic, opened = load_generic(), steps["jawOpen"]
    assert not opened[generic.part("teeth_upper")].any()
    teeth = generic.part("teeth_lower")
    sides = rest[teeth][:, None] - rest[teeth][None]
    moved = rest[teeth] + opened[teeth]
    stretch = np.linalg.norm(moved[:, None] - moved[None], axis=2) - np.linalg.norm(sides, axis=2)
    assert np.abs(stretch).max() < 5e-4
    tip = generic.part("tongue")[rest[generic.part("tongue"), 2].argmax()]
    chin = opened[generic.feature("chin_front"), 1]
    assert 0.5 * chin > opened[tip, 1] > 1.6 * chin


def test_a_tongue_comes_out_over_the_lower_lip_and_through_no_lip(person) -> None:
    rest, steps = person
    generic, grid = load_generic(), mouth_grid()
    rows, out = generic.part("tongue"), rest + steps["tongueOut"]
    lower = out[grid.rings[grid.margin - 1 : grid.margin + 4][:, grid.lower]]
    assert 0.008 < out[rows, 2].max() - lower[..., 2].max() < 0.03, "it is seen from the front"
    tip = rows[out[rows, 2] > lower[..., 2].max()]
    assert np.ptp(out[tip, 0]) > 0.012, "as broad as a tongue, no thorn"
    assert face_motion.worst_along_path(rest, steps["tongueOut"]).tongue_through < 2.0


def test_the_tongue_passes_no_lip_in_a_sum(person) -> None:
    rest, steps = person
    names, index, delta, start = packed(steps)
    clone = replace(generic_clone(load_generic(), 1.7), vertices_m=rest, morph_names=names, morph_index=index,
                    morph_delta_m=delta, morph_start=start)  # fmt: skip
    for others, least, most in (
        ({"jawOpen": 1.0}, 0.7, 1.0),  # held back only as no sum opens the jaw farther than jawOpen
        ({"jawOpen": 1.0, "mouthClose": 1.0}, 0.0, 0.7),
        ({"viseme_PP": 1.0}, 0.0, 1.0),
        ({"mouthRollLower": 1.0}, 0.0, 1.0),
        ({"mouthSmileLeft": 1.0, "mouthSmileRight": 1.0}, 0.0, 1.0),
        ({"viseme_O": 1.0}, 0.0, 1.0),
        ({"mouthPucker": 1.0, "mouthShrugLower": 1.0}, 0.0, 1.0),
    ):
        held = limited(clone, {name: np.array([weight]) for name, weight in {"tongueOut": 1.0, **others}.items()})
        figures = face_motion.mixture_figures(clone, {name: float(values[0]) for name, values in held.items()})
        assert figures.tongue_through < 1.0, others
        assert least <= held["tongueOut"][0] <= most, others


def test_open_lips_are_ovals_and_no_wedges(person) -> None:
    rest, steps = person
    grid = mouth_grid()
    for name in ("jawOpen", "viseme_O", "viseme_aa", "mouthFunnel"):
        margin = (rest + steps[name])[grid.ring(0)]
        left, right = margin[grid.corners]
        across = np.abs(margin[:, 0] - (left[0] + right[0]) / 2.0) / ((left[0] - right[0]) / 2.0)
        depth = (left[1] + right[1]) / 2.0 - margin[:, 1]
        lower = grid.lower
        half = np.interp(0.6, np.sort(across[lower]), depth[lower][np.argsort(across[lower])])
        assert half > 0.75 * depth[lower].max(), f"{name}: a wedge has 0.4, an ellipse 0.8"


def test_a_gaze_turns_the_ball_about_its_centre_and_lids_follow_up_and_down(person) -> None:
    rest, steps = person
    generic = load_generic()
    rows = generic.part("eye_left")
    for name in ("eyeLookDownLeft", "eyeLookInLeft", "eyeLookUpLeft"):
        turned = rest[rows] + steps[name][rows]
        ball = eyeball(rest, "left")
        before, after = (np.linalg.norm(points - ball.centre, axis=1) for points in (rest[rows], turned))
        np.testing.assert_allclose(after, before, atol=1e-5)
    lid = eye_grid("left").ring(0)[0]
    assert steps["eyeLookDownLeft"][lid, 1] < -0.001
    assert steps["eyeLookUpLeft"][lid, 1] > 0.001


def test_targets_grow_with_the_face(person) -> None:
    rest, steps = person
    larger = face_targets(1.1 * rest)
    jaw = larger[0].index("jawOpen")
    rows = slice(larger[3][jaw], larger[3][jaw + 1])
    chin = larger[2][rows][larger[1][rows] == load_generic().feature("chin_front")]
    np.testing.assert_allclose(chin[0], 1.1 * steps["jawOpen"][load_generic().feature("chin_front")], atol=2e-4)


def test_the_rulers_see_what_is_wrong() -> None:
    rest = random_person(0)
    generic, grid = load_generic(), mouth_grid()
    forward = rest.copy()
    forward[generic.part("eye_left")] += [0.0, 0.0, 0.003]
    assert 0.5 < face_motion.face_figures(forward, forward).eye_through < 3.0
    apart = rest.copy()
    apart[grid.rings[:, grid.lower], 1] -= 0.002
    assert face_motion.face_figures(rest, apart).lip_gap == pytest.approx(2.0, abs=0.3)
    biting = rest.copy()
    biting[generic.part("teeth_upper")] += [0.0, 0.0, 0.03]
    assert face_motion.face_figures(rest, biting).teeth_through > 5.0
    licking = rest.copy()
    licking[generic.part("tongue")] += [0.0, -0.006, 0.02]
    assert face_motion.face_figures(rest, licking).tongue_through > 2.0
    shifted = rest + 0.001
    assert face_motion.face_figures(rest, shifted).ears == pytest.approx(3**0.5, rel=0.01)
