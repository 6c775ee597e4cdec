"""How packs are staged: statues that wake, heads that are given, cameras that cut and follow."""

from __future__ import annotations

import numpy as np
import pytest

from cloner.crowd.packs.told import _STAGING, _first_invalid, _unknown_staged
from cloner.crowd.staged.footing import GONE, Acted
from cloner.crowd.staged.staging import HEAD_MIDDLE, HEADLESS, PART, PLAIN, STONE, UP, Staging, add_caption, eased_value

STATURE_M = 1.7


def standing(count: int) -> Acted:
    """So many people of one clone who stand in a row and breathe for 60 s."""
    people = np.zeros((count, 5, 4), np.float32)
    people[:, 1, 3] = 1.0
    rows = [[0.0, 60.0, 1.0, -1.0, 0.0, -1.0, k, 0.0, k, 0.0, 0.0, 0.0] for k in range(count)]
    clips = np.array([[[48, 1.0], [16, 6.0]]], np.float32)
    touches = np.zeros((1, 2, 48, 6), np.float32)
    return Acted(np.array(rows, np.float32), np.arange(count + 1, dtype=np.uint32), people, touches, clips)


def test_keys_are_held_and_eased() -> None:
    keys = [[1.0, 0.0, 5.0], [3.0, 8.0, 5.0]]
    assert eased_value(keys, 0.0).tolist() == [0.0, 5.0]
    assert eased_value(keys, 2.0).tolist() == [4.0, 5.0]
    assert eased_value(keys, 1.5)[0] == pytest.approx(8.0 * (3 * 0.25**2 - 2 * 0.25**3))
    assert eased_value(keys, 9.0).tolist() == [8.0, 5.0]
    assert eased_value([[2.0, 0.0], [2.0, 1.0]], 2.0).tolist() == [1.0], "a change in no time"


def test_a_statue_does_not_breathe_until_it_wakes() -> None:
    told = {**PLAIN, "wakes": [[0, 5.0]], "stone": [[0, [[0.0, 1.0], [5.0, 1.0], [7.0, 0.0]]]]}
    staging, acted = Staging(told, [STATURE_M]), standing(2)
    still, later, awake, alive = (staging.rows(acted, now) for now in (0.5, 3.1, 6.0, 9.0))
    assert (still[0] == later[0]).all()
    assert (still[1] != later[1]).any(), "the other one breathes"
    assert still[0, 4, STONE] == 1.0
    assert awake[0, 4, STONE] == pytest.approx(0.5)
    assert (alive[0, 4, STONE], alive[1, 4, STONE]) == (0.0, 0.0)
    assert (awake[0, 1:3] != still[0, 1:3]).any()


def test_a_head_is_somewhere_else_until_it_is_given_back() -> None:
    path = [[0.0, 3.0, 0.1, -2.0, 0.5, 0.25], [4.0, 0.0, HEAD_MIDDLE * STATURE_M, 0.0, 0.0, 0.0]]
    told = {**PLAIN, "heads": [{"who": 1, "of": 0, "until": 4.0, "path": path}]}
    staging, acted = Staging(told, [STATURE_M]), standing(2)
    apart, whole = staging.rows(acted, 1e-6), staging.rows(acted, 4.0)
    assert apart[0, 4, PART] == HEADLESS
    assert apart[1, 0, 1:] == pytest.approx([3.0, -2.0, 0.5])
    assert apart[1, 4, UP] == pytest.approx(0.1 - HEAD_MIDDLE * STATURE_M)
    assert apart[1, 4, PART] == pytest.approx(2.25)
    assert (whole[0, 4, PART], whole[1, 0, 0]) == (0.0, GONE)
    almost = staging.rows(acted, 4.0 - 1e-4)
    assert almost[1, 4, UP] == pytest.approx(0.0, abs=1e-3), "it comes down where it belongs"


def test_cameras_cut_move_and_follow() -> None:
    first = [[0.0, 0, 1, 5, 0, 1, 0, -1.0, 40.0], [2.0, 0, 1, 9, 0, 1, 0, -1.0, 20.0]]
    second = [[3.0, 7, 2, 7, 0, 0, 0, 1.0, 30.0]]
    staging, acted = Staging({**PLAIN, "shots": [first, second]}, [STATURE_M]), standing(2)
    rows = staging.rows(acted, 1.0)
    assert staging.camera(rows, 1.0) == ((0.0, 1.0, 7.0), (0.0, 1.0, 0.0), 30.0)
    assert staging.camera(rows, 2.999)[0] == (0.0, 1.0, 9.0)
    place, target, field = staging.camera(rows, 3.0)
    assert (place, field) == ((7.0, 2.0, 7.0), 30.0)
    assert target == pytest.approx((1.0, 0.93 * STATURE_M, 0.0)), "the second one's eyes"


def test_captions_and_curtains_are_drawn() -> None:
    grey = np.full((180, 320, 3), 90, np.uint8)
    assert (add_caption(grey, "", 1.0) == grey).all()
    assert (add_caption(grey, "", 0.5) == 45).all()
    written = add_caption(grey, "Who am I?", 1.0)
    assert (written[:120] == grey[:120]).all()
    assert written.max() > 220
    told = {**PLAIN, "captions": [[1.0, 3.0, "so"]]}
    assert [Staging(told, [1.7]).caption(now) for now in (0.9, 1.0, 3.0)] == ["", "so", ""]


@pytest.mark.parametrize(
    ("key", "value"),
    [
        ("light", []), ("light", [[0.0, 1.0]]), ("stars", [[2.0, 0.0], [1.0, 0.0]]), ("stops", [[0.0, "much"]]),
        ("captions", [[0.0, 1.0]]), ("wakes", [[-1, 3.0]]), ("heads", [{"who": 0}]), ("shots", [[[0.0] * 8]]),
        ("stone", [[0, [[0.0, float("nan")]]]]),
    ],
)  # fmt: skip
def test_what_a_hostile_pack_stages_is_refused(key: str, value: object) -> None:
    assert _first_invalid({"staging": dict(PLAIN)}, _STAGING, "") == ""
    assert _first_invalid({"staging": {**PLAIN, key: value}}, _STAGING, "").startswith(f"staging.{key}")


def test_nobody_is_staged_who_is_not_there() -> None:
    assert _unknown_staged({**PLAIN, "wakes": [[1, 3.0]]}, 2) == ""
    assert _unknown_staged({**PLAIN, "wakes": [[2, 3.0]]}, 2) == "staging"
