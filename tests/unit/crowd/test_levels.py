"""The levels are lists of the generic human's own vertices, fine at joints, and shells keep theirs."""

from __future__ import annotations

import hashlib
import json
from pathlib import Path

import numpy as np
import pytest

import cloner.crowd
from cloner.crowd.clones.levels import FLOWING, LOOSE, body_levels, read_budgets, shell_levels
from cloner.generic.load import load_generic
from cloner.generic.surfaces import load_surfaces
from kit.clones import toy_clone

ISSUE_TRIANGLES = (17_536, 9_536, 4_000, 2_000)  # with hair, as measured on clones when the crowd was planned


def test_the_sizes_are_those_that_were_planned() -> None:
    totals = [len(own) + loose for own, loose in zip(body_levels().triangles, LOOSE, strict=True)]
    assert totals == pytest.approx(ISSUE_TRIANGLES, rel=0.01)


def test_a_pack_tells_which_levels_it_has() -> None:
    assert read_budgets(list(FLOWING)) == FLOWING
    for told in ([4_000, 2_700, 1_000, 501], [10**9] * 4, None):
        with pytest.raises(ValueError, match="levels that no pack has"):
            read_budgets(told)


def test_weights_and_texture_coordinates_are_the_generic_humans_own() -> None:
    body, generic = body_levels(), load_generic()
    assert np.array_equal(body.joints, generic.skin_joints[body.vertex])
    own = generic.skin_weights[body.vertex].astype(np.float64)
    assert np.abs(body.weights - own / own.sum(axis=1, keepdims=True)).max() < 1e-12
    known = {(int(v), *uv) for one in load_surfaces() for v, uv in zip(one.vertex, one.uv.tolist(), strict=True)}
    assert all((int(v), *uv) in known for v, uv in zip(body.vertex, body.uv.tolist(), strict=True))


def test_coarse_levels_use_the_first_vertices_of_the_finer_ones() -> None:
    body = body_levels()
    assert list(body.counts) == sorted(body.counts, reverse=True)
    for triangles, count in zip(body.triangles, body.counts, strict=True):
        assert triangles.max() == count - 1


def test_elbows_and_knees_stay_denser_than_the_limbs_between() -> None:
    """Share of kept vertices within 6 cm of a bending joint against 6 cm around the middle of its bones."""
    body, generic = body_levels(), load_generic()
    kept = np.zeros(len(generic.vertices_m), bool)
    kept[body.vertex[: body.counts[2]]] = True
    skin = generic.vertex_part == 0

    def share(place: np.ndarray) -> float:
        near = skin & (np.linalg.norm(generic.vertices_m - place, axis=1) < 0.09)
        return float(kept[near].sum() / near.sum())

    joint = lambda name: generic.joints_m[generic.joint(name)]  # noqa: E731
    for side in "lr":
        knee, hip = joint(f"{side}_knee"), joint(f"{side}_hip")
        assert share(knee) > share((knee + hip) / 2.0)


def test_shells_keep_their_own_vertices_and_stay_below_the_budget() -> None:
    shell = toy_clone().shells[0]
    chain = shell_levels(shell.vertices_m, shell.triangles, (2000, 800, 500))
    for triangles, budget in zip(chain, (2000, 800, 500), strict=True):
        assert 0.7 * budget < len(triangles) <= budget
        assert triangles.max() < len(shell.vertices_m)
        spread = np.ptp(shell.vertices_m[np.unique(triangles)], axis=0)
        assert np.allclose(spread, np.ptp(shell.vertices_m, axis=0), atol=0.02)


def test_pieces_that_cannot_be_made_fewer_are_cut_off_at_the_budget() -> None:
    (hair,) = [shell for shell in toy_clone().shells if shell.kind == "hair"]
    alone = hair.triangles.reshape(-1)
    apart = hair.vertices_m[alone] + np.arange(len(alone))[:, None] * 1e-5
    triangles = np.arange(len(alone), dtype=np.int32).reshape(-1, 3)
    (few,) = shell_levels(apart, triangles, (len(triangles) // 4,))
    assert len(few) <= len(triangles) // 4


def test_the_shipped_lists_and_scripts_are_the_ones_of_the_record() -> None:
    folder = Path(cloner.crowd.__file__).parent
    for place in ("data", "web"):
        (row,) = json.loads((folder / place / "PROVENANCE.json").read_text())
        assert hashlib.sha256((folder / place / row["file"]).read_bytes()).hexdigest() == row["sha256"]
