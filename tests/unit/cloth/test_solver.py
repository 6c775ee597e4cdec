"""Cloth obeys what physics says of simple cases."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest

from cloner.cloth.drafting.blocks import BLOCKS, draft
from cloner.cloth.drafting.cut import Cloth, cut
from cloner.cloth.drafting.pattern import Pattern, Segment
from cloner.cloth.simulation.fabrics import FABRICS, Fabric
from cloner.cloth.simulation.solver import THICK_M, Sheet, State, sheet_of, step, strains
from cloner.cloth.simulation.threads import LONGEST, grouped, limits, pull
from cloner.cloth.simulation.wearer import Skin
from cloner.evaluate.measures.crossings import self_crossings

CALM = np.zeros(3)


def strip(width_m: float, length_m: float, step_m: float) -> Cloth:
    """Return a rectangle whose upper edge is called top."""
    corners = np.array([[width_m, 0.0], [0.0, 0.0], [0.0, -length_m], [width_m, -length_m]])
    edges = {
        name: np.array([corners[k] + t * (corners[(k + 1) % 4] - corners[k]) for t in (0.0, 1 / 3, 2 / 3, 1.0)])
        for k, name in enumerate(("top", "left", "hem", "right"))
    }
    return cut(Pattern("strip", (Segment("a", edges),), ()), step_m)


def far_floor(height_m: float) -> Skin:
    """Return a flat floor of points, facing up."""
    x, z = np.meshgrid(np.linspace(-1.0, 1.0, 81), np.linspace(-1.0, 1.0, 81))
    points = np.column_stack([x.ravel(), np.full(x.size, height_m), z.ravel()])
    return Skin(points, points, np.tile([0.0, 1.0, 0.0], (x.size, 1)))


def upright(cloth: Cloth) -> np.ndarray:
    places = np.zeros((cloth.count, 3))
    places[cloth.vertex] = np.column_stack([cloth.flat_m, np.zeros(len(cloth.flat_m))])
    return places


def run(sheet: Sheet, places: np.ndarray, skin: Skin, frames: int, substeps: int = 20) -> State:
    state, held = State(places, np.zeros_like(places)), places[sheet.held]
    for _ in range(frames):
        state = step(sheet, state, skin, (held, held), 1.0 / 30.0, substeps, CALM)
    return state


@pytest.mark.parametrize("name", sorted(FABRICS))
def test_a_hanging_strip_keeps_its_length(name: str) -> None:
    cloth = strip(0.1, 0.5, 0.025)
    held = np.unique(cloth.vertex[cloth.edges["a.top"]])
    sheet = sheet_of(cloth, FABRICS[name], held)
    state = run(sheet, upright(cloth), far_floor(-3.0), 45)
    lowest = float(state.places_m[:, 1].min())
    assert lowest == pytest.approx(-0.5, rel=0.05)
    assert np.quantile(strains(sheet, state.places_m), 0.99) < 0.05


def test_mass_and_area_are_the_fabric_s() -> None:
    cloth = strip(0.2, 0.5, 0.03)
    sheet = sheet_of(cloth, FABRICS["denim"], np.array([0]))
    assert sheet.area_m2.sum() == pytest.approx(0.1, rel=1e-6)
    assert sheet.mass_kg.sum() == pytest.approx(0.1 * 0.380, rel=1e-6)


def test_free_cloth_falls_as_everything_does() -> None:
    cloth = strip(0.1, 0.2, 0.03)
    airless = replace(FABRICS["wool"], air=0.0)
    sheet = sheet_of(cloth, airless, np.array([0]))
    sheet = replace(sheet, held=np.zeros(0, dtype=np.int64), leash_m=np.full(cloth.count, 1e6))
    state = run(sheet, upright(cloth), far_floor(-9.0), 6)
    dropped = -float((state.places_m - upright(cloth))[:, 1].mean())
    assert dropped == pytest.approx(9.81 * 0.2**2 / 2.0, rel=0.2)  # its own rubbing slows it by up to a fifth


def test_cloth_comes_to_rest_on_the_skin_and_friction_holds_it() -> None:
    cloth = strip(0.2, 0.2, 0.025)
    sheet = sheet_of(cloth, FABRICS["cotton"], np.array([0]))
    sheet = replace(sheet, held=np.zeros(0, dtype=np.int64), leash_m=np.full(cloth.count, 1e6))
    flat = np.zeros((cloth.count, 3))
    flat[cloth.vertex] = np.column_stack([cloth.flat_m[:, 0], np.full(len(cloth.flat_m), 0.02), cloth.flat_m[:, 1]])
    state = run(sheet, flat, far_floor(0.0), 30)
    assert state.places_m[:, 1] == pytest.approx(THICK_M, abs=1e-3)
    assert np.abs(state.places_m[:, [0, 2]] - flat[:, [0, 2]]).max() < 0.003


def test_the_same_start_gives_the_same_end() -> None:
    cloth = cut(draft(BLOCKS["skirt"], 0.75, 0.3), 0.04)
    held = np.unique(cloth.vertex[np.concatenate([cloth.edges["front.top"], cloth.edges["back.top"]])])
    sheet = sheet_of(cloth, FABRICS["silk"], held)
    ends = [run(sheet, upright(cloth), far_floor(-3.0), 3).places_m for _ in range(2)]
    assert ends[0].tobytes() == ends[1].tobytes()


def test_stiffer_fabrics_are_stiffer() -> None:
    silk, burlap = FABRICS["silk"], FABRICS["burlap"]
    assert burlap.bend_n_m() > 20.0 * silk.bend_n_m()
    assert silk.bend_n_m() == pytest.approx(9.81e-5 * 0.0225)
    assert silk.stretch_n_m()[0] == pytest.approx(490.0 / 0.03)
    assert all(isinstance(fabric, Fabric) for fabric in FABRICS.values())


def test_no_thread_stays_long_and_nothing_is_moved_that_is_held() -> None:
    threads = grouped(np.array([[0, 1], [1, 2]]), np.ones(2), np.ones(2), 3)
    free, places = np.array([0.0, 1.0, 1.0]), np.array([[0.0, 0.0, 0.0], [0.0, -1.2, 0.0], [0.0, -2.4, 0.0]])
    for _ in range(50):
        pull(limits(threads, free), places, slack=True)
    assert places[0].tolist() == [0.0, 0.0, 0.0]
    assert np.diff(-places[:, 1]) == pytest.approx(LONGEST, abs=1e-3)
    short = places * 0.5
    pull(limits(threads, free), short, slack=True)
    assert short.tolist() == (places * 0.5).tolist(), "what is short folds as it likes"


@pytest.mark.parametrize("together", [False, True])
def test_cloth_that_flies_into_itself_does_not_pass(together: bool, monkeypatch: pytest.MonkeyPatch) -> None:
    """A strip folded up in front of itself, its flap thrown at it askew; without contact it goes through."""
    cloth = strip(0.15, 0.45, 0.02)
    if together:
        monkeypatch.setattr("cloner.cloth.simulation.solver.keep_apart", lambda *_: None)
    top = np.flatnonzero(cloth.flat_m[:, 1] > -1e-6)
    sheet = sheet_of(cloth, FABRICS["cotton"], top)
    x, y = cloth.flat_m.T
    fold, thick = -0.2, 0.08
    turn = (fold - y).clip(0.0, np.pi * thick / 2.0) / (thick / 2.0)
    up = (fold - y - np.pi * thick / 2.0).clip(0.0)
    low = np.maximum(y, fold) - thick / 2.0 * np.sin(turn) + up
    places = np.column_stack([x, low, thick / 2.0 * (1.0 - np.cos(turn))])
    speeds = np.zeros_like(places)
    speeds[up > 0.0] = 0.3, 0.0, -2.0
    state, most = State(places, speeds), 0
    for _ in range(20):
        state = step(sheet, state, far_floor(-5.0), (places[top], places[top]), 1 / 30, 20, CALM)
        most = max(most, len(self_crossings(state.places_m, sheet.faces).pairs))
    assert (most > 10) if together else most == 0
