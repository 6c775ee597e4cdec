"""A shell is brought to the photos' outlines as one: no strings of pearls, nothing blown up towards a camera."""

from __future__ import annotations

import numpy as np
import pytest
import trimesh

from cloner.hair.volumes import settled
from cloner.hair.volumes.cap import Scalp
from cloner.hair.volumes.settled import settle_shell

RADIUS_M, FILM_MM = 0.1, 2.0


def _ball(radius_m: float) -> trimesh.Trimesh:
    return trimesh.creation.icosphere(subdivisions=4, radius=radius_m)


def _scalp(radius_m: float) -> Scalp:
    skull = _ball(radius_m)
    one = np.ones(len(skull.vertices))
    points = np.asarray(skull.vertices)
    return Scalp(points, points / radius_m, np.zeros(3), np.asarray(skull.faces, np.int32), one[None], one, one, one)


def _settled(
    monkeypatch: pytest.MonkeyPatch, rim_mm: np.ndarray, skull_m: float = 0.05
) -> tuple[np.ndarray, np.ndarray]:
    """Return a ball's vertices before and after a front photo (along z) told its rim's gaps ``rim_mm`` in turn."""
    ball = _ball(RADIUS_M)
    start = np.asarray(ball.vertices)
    rim = np.flatnonzero(np.abs(start[:, 2]) < 0.1 * RADIUS_M)
    goal_m = np.zeros(len(start))
    goal_m[rim] = RADIUS_M + 1e-3 * np.resize(rim_mm, len(rim))

    def drive(_: object, surface_m: np.ndarray, __: object) -> tuple[np.ndarray, np.ndarray]:
        trust = (goal_m > 0.0).astype(float)
        return trust * 1e3 * (goal_m - np.linalg.norm(surface_m, axis=1)), trust

    monkeypatch.setattr(settled, "outline_forces_mm", drive)
    return start, settle_shell(
        [], (_scalp(skull_m).points_m, _scalp(skull_m).normals), start, np.asarray(ball.faces, np.int32), FILM_MM
    )


def test_a_rim_moves_outwards_and_what_faces_the_camera_stays(monkeypatch: pytest.MonkeyPatch) -> None:
    start, found = _settled(monkeypatch, np.array([20.0]))
    moved_mm = 1e3 * (found - start)
    rim = np.abs(start[:, 2]) < 0.1 * RADIUS_M
    assert np.linalg.norm(moved_mm[rim], axis=1).mean() > 15.0
    assert np.abs(moved_mm[start[:, 2] > 0.95 * RADIUS_M, 2]).max() < 2.0


def test_outlines_that_disagree_from_place_to_place_leave_no_pearls(monkeypatch: pytest.MonkeyPatch) -> None:
    start, found = _settled(monkeypatch, np.array([20.0, -5.0]))
    radius_mm = 1e3 * np.linalg.norm(found, axis=1)
    rim = np.abs(start[:, 2]) < 0.1 * RADIUS_M
    assert radius_mm[rim].mean() == pytest.approx(107.5, abs=2.5)
    assert radius_mm[rim].std() < 3.5, "the wanted gaps have 12.5"


@pytest.mark.parametrize("rim_mm", [-30.0, -60.0])
def test_no_shell_sinks_below_the_film_over_the_skin(monkeypatch: pytest.MonkeyPatch, rim_mm: float) -> None:
    """However deep inside the body an outline lies: a back stood out through long hair."""
    _, found = _settled(monkeypatch, np.array([rim_mm]), skull_m=0.09)
    assert 1e3 * np.linalg.norm(found, axis=1).min() > 90.0 + FILM_MM - 0.7


def test_the_wall_that_lies_on_the_skin_stays_below_the_hair(monkeypatch: pytest.MonkeyPatch) -> None:
    """Outlines that lie farther in moved it out along its own normals, through the hair over it: torn hair on backs."""
    skull, outer, inner = _scalp(0.1), _ball(0.108), _ball(0.0985)
    points = np.concatenate([outer.vertices, inner.vertices])
    triangles = np.concatenate([outer.faces, inner.faces[:, ::-1] + len(outer.vertices)]).astype(np.int32)

    def drive(_: object, surface_m: np.ndarray, __: object) -> tuple[np.ndarray, np.ndarray]:
        return np.full(len(surface_m), -5.0), np.ones(len(surface_m))

    monkeypatch.setattr(settled, "outline_forces_mm", drive)
    found = settle_shell([], (skull.points_m, skull.normals), points, triangles, FILM_MM)
    radius_mm = 1e3 * np.linalg.norm(found, axis=1)
    assert radius_mm[: len(outer.vertices)].max() < 104.0  # moved in, on to the film over the skin
    assert radius_mm[len(outer.vertices) :].max() < radius_mm[: len(outer.vertices)].min()
