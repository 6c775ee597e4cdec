"""Cloth obeys what physics says of simple cases."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest

from cloner.cloth.drafting.blocks import BLOCKS, draft_block
from cloner.cloth.drafting.cut import Cloth, triangulate
from cloner.cloth.drafting.pattern import Pattern, Segment
from cloner.cloth.simulation.core.host import push_out_of_skin
from cloner.cloth.simulation.fabrics import FABRICS, Fabric
from cloner.cloth.simulation.solver import LONGEST, THICK_M, Sheet, State, make_engine, make_sheet, step, strains
from cloner.cloth.simulation.threads import colour_constraints, make_spacing
from cloner.cloth.simulation.wearer import Skin
from cloner.evaluate.measures.crossings import self_intersections

CALM = np.zeros(3)


def strip(width_m: float, length_m: float, step_m: float) -> Cloth:
    """Return a rectangle whose upper edge is called top."""
    corners = np.array([[width_m, 0.0], [0.0, 0.0], [0.0, -length_m], [width_m, -length_m]])
    edges = {
        name: np.array([corners[k] + t * (corners[(k + 1) % 4] - corners[k]) for t in (0.0, 1 / 3, 2 / 3, 1.0)])
        for k, name in enumerate(("top", "left", "hem", "right"))
    }
    return triangulate(Pattern("strip", (Segment("a", edges),), ()), step_m)


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
    state, held, core = State(places, np.zeros_like(places)), places[sheet.held], make_engine(sheet, len(skin.late_m))
    for _ in range(frames):
        state = step(core, sheet.fabric, state, skin, (held, held), 1.0 / 30.0, substeps, CALM)
    return state


@pytest.mark.parametrize("name", sorted(FABRICS))
def test_a_hanging_strip_keeps_its_length(name: str) -> None:
    cloth = strip(0.1, 0.5, 0.025)
    held = np.unique(cloth.vertex[cloth.edges["a.top"]])
    sheet = make_sheet(cloth, FABRICS[name], held)
    state = run(sheet, upright(cloth), far_floor(-3.0), 45)
    lowest = float(state.places_m[:, 1].min())
    assert lowest == pytest.approx(-0.5, rel=0.05)
    assert np.quantile(strains(sheet, state.places_m), 0.99) < 0.05


def test_mass_and_area_are_the_fabric_s() -> None:
    cloth = strip(0.2, 0.5, 0.03)
    sheet = make_sheet(cloth, FABRICS["denim"], np.array([0]))
    assert sheet.area_m2.sum() == pytest.approx(0.1, rel=1e-6)
    assert sheet.mass_kg.sum() == pytest.approx(0.1 * 0.380, rel=1e-6)


def test_free_cloth_falls_as_everything_does() -> None:
    cloth = strip(0.1, 0.2, 0.03)
    airless = replace(FABRICS["wool"], air=0.0)
    sheet = make_sheet(cloth, airless, np.array([0]))
    sheet = replace(sheet, held=np.zeros(0, dtype=np.int64), leash_m=np.full(cloth.count, 1e6))
    state = run(sheet, upright(cloth), far_floor(-9.0), 6)
    dropped = -float((state.places_m - upright(cloth))[:, 1].mean())
    assert dropped == pytest.approx(9.81 * 0.2**2 / 2.0, rel=0.2)  # its own rubbing slows it by up to a fifth


def test_cloth_comes_to_rest_on_the_skin_and_friction_holds_it() -> None:
    cloth = strip(0.2, 0.2, 0.025)
    sheet = make_sheet(cloth, FABRICS["cotton"], np.array([0]))
    sheet = replace(sheet, held=np.zeros(0, dtype=np.int64), leash_m=np.full(cloth.count, 1e6))
    flat = np.zeros((cloth.count, 3))
    flat[cloth.vertex] = np.column_stack([cloth.flat_m[:, 0], np.full(len(cloth.flat_m), 0.02), cloth.flat_m[:, 1]])
    state = run(sheet, flat, far_floor(0.0), 30)
    assert state.places_m[:, 1] == pytest.approx(THICK_M, abs=1e-3)
    assert np.abs(state.places_m[:, [0, 2]] - flat[:, [0, 2]]).max() < 0.003


def test_the_same_start_gives_the_same_end() -> None:
    cloth = triangulate(draft_block(BLOCKS["skirt"], 0.75, 0.3), 0.04)
    held = np.unique(cloth.vertex[np.concatenate([cloth.edges["front.top"], cloth.edges["back.top"]])])
    sheet = make_sheet(cloth, FABRICS["silk"], held)
    ends = [run(sheet, upright(cloth), far_floor(-3.0), 3).places_m for _ in range(2)]
    assert ends[0].tobytes() == ends[1].tobytes()


def test_stiffer_fabrics_are_stiffer() -> None:
    silk, burlap = FABRICS["silk"], FABRICS["burlap"]
    assert burlap.bend_n_m() > 20.0 * silk.bend_n_m()
    assert silk.bend_n_m() == pytest.approx(9.81e-5 * 0.0225)
    assert silk.stretch_n_m()[0] == pytest.approx(490.0 / 0.03)
    assert all(isinstance(fabric, Fabric) for fabric in FABRICS.values())


def test_no_thread_stays_long_and_nothing_is_moved_that_is_held() -> None:
    cloth = strip(0.05, 0.3, 0.05)
    sheet = make_sheet(cloth, FABRICS["cotton"], np.flatnonzero(cloth.flat_m[:, 1] > -1e-6))
    core, places = make_engine(sheet, 0), upright(cloth)
    core.arrays["place"][:] = 1.2 * places
    for _ in range(300):
        core.call("limit", LONGEST)
    assert core.arrays["place"][sheet.held].tolist() == (1.2 * places[sheet.held]).tolist()
    assert strains(sheet, core.arrays["place"]).max() == pytest.approx(
        max(LONGEST - 1.0, strains(sheet, 1.2 * places)[np.isin(sheet.edges, sheet.held).all(axis=1)].max()), abs=2e-3
    )
    core.arrays["place"][:] = 0.5 * places
    core.call("limit", LONGEST)
    assert core.arrays["place"].tolist() == (0.5 * places).tolist(), "what is short folds as it likes"


def test_threads_of_a_group_share_no_vertex() -> None:
    """Six threads round a hexagon, whose neighbours alone meet: two groups."""
    ends = np.array([[k, (k + 1) % 6] for k in range(6)])
    threads = colour_constraints(ends, np.arange(6.0), np.arange(6.0), 6)
    assert sorted(threads.rest_m.tolist()) == list(range(6))
    assert all(len(np.unique(threads.ends[rows])) == 6 for rows in (slice(0, 3), slice(3, 6)))
    assert (ends[threads.rest_m.astype(int)] == threads.ends).all()


def thrown(cloth: Cloth) -> State:
    """Return a strip folded up in front of itself, its flap thrown at it askew."""
    x, y = cloth.flat_m.T
    fold, thick = -0.2, 0.08
    turn = (fold - y).clip(0.0, np.pi * thick / 2.0) / (thick / 2.0)
    up = (fold - y - np.pi * thick / 2.0).clip(0.0)
    low = np.maximum(y, fold) - thick / 2.0 * np.sin(turn) + up
    places = np.column_stack([x, low, thick / 2.0 * (1.0 - np.cos(turn))])
    speeds = np.zeros_like(places)
    speeds[up > 0.0] = 0.3, 0.0, -2.0
    return State(places, speeds)


@pytest.mark.parametrize("spaced", [True, False])
def test_cloth_that_flies_into_itself_does_not_pass(spaced: bool) -> None:
    """Vertices that need no distance, and thus no gap to guard, let it through."""
    cloth = strip(0.15, 0.45, 0.02)
    top = np.flatnonzero(cloth.flat_m[:, 1] > -1e-6)
    sheet = make_sheet(cloth, FABRICS["cotton"], top)
    if not spaced:
        sheet = replace(sheet, spacing=replace(sheet.spacing, radius_m=np.zeros(cloth.count)))
    state, most, skin, core = thrown(cloth), 0, far_floor(-5.0), make_engine(sheet, 81 * 81)
    held = state.places_m[top]
    for _ in range(20):
        state = step(core, sheet.fabric, state, skin, (held, held), 1 / 30, 20, CALM)
        most = max(most, len(self_intersections(state.places_m, sheet.faces).pairs))
    assert most == 0 if spaced else most > 10


def test_edges_that_are_pressed_keep_their_gap_and_their_side() -> None:
    """Two crossed edges 1 mm apart, their ends farther off than vertices keep: guarded alone, also once they passed."""
    cloth = strip(0.02, 0.02, 0.02)
    assert len(cloth.faces) >= 2
    sheet = make_sheet(cloth, FABRICS["cotton"], np.zeros(0, np.int64))
    high = cloth.count
    faces = np.concatenate([sheet.faces, sheet.faces + high])
    edges, rest = np.concatenate([sheet.edges, sheet.edges + high]), np.tile(sheet.rest_m, 2)
    both = replace(
        sheet, faces=faces, mass_kg=np.tile(sheet.mass_kg, 2), edges=edges, rest_m=rest,
        stretch=colour_constraints(edges, rest, np.ones(len(edges)), 2 * high),
        bend=colour_constraints(np.zeros((0, 2), np.int64), np.zeros(0), np.zeros(0), 2 * high),
        anchor=np.zeros(2 * high, np.int64), leash_m=np.full(2 * high, np.inf),
        spacing=make_spacing(edges, rest, np.zeros((0, 2), np.int64), np.zeros(0), 2 * high),
    )  # fmt: skip
    core, flat = make_engine(both, 0), upright(cloth)
    turned = flat[:, [1, 0, 2]] * [-1.0, -1.0, 1.0] + [0.005, -0.004, 0.001]
    core.arrays["place"][:] = np.concatenate([flat, turned])
    core.call("findPairs", 0.0)
    core.call("findGuards", 0.0)
    core.arrays["place"][high:, 2] -= 0.0015  # through
    assert len(self_intersections(np.array(core.arrays["place"]), faces).pairs) == 0, (
        "flat pieces side by side in space"
    )
    for _ in range(20):
        core.call("keepGap")
    gap = core.arrays["place"][high:, 2].mean() - core.arrays["place"][:high, 2].mean()
    assert gap > 0.001, "back on the side on which it was"


def test_edges_that_begin_at_neighbours_are_guarded() -> None:
    """Three edges of 2 cm in a row, folded: the first and last meet near their joined ends, the others are far off."""
    sheet = make_sheet(strip(0.02, 0.02, 0.02), FABRICS["cotton"], np.zeros(0, np.int64))
    edges, rest, none = np.array([[0, 1], [1, 2], [2, 3]]), np.full(3, 0.02), np.zeros((0, 2), np.int64)
    row = replace(
        sheet, faces=np.zeros((0, 3), np.int64), mass_kg=np.full(4, 1e-4), edges=edges, rest_m=rest,
        stretch=colour_constraints(edges, rest, np.ones(3), 4),
        bend=colour_constraints(none, np.zeros(0), np.zeros(0), 4), anchor=np.zeros(4, np.int64),
        leash_m=np.full(4, np.inf), spacing=make_spacing(edges, rest, none, np.zeros(0), 4),
    )  # fmt: skip
    core = make_engine(row, 0)
    core.arrays["place"][:] = [[-0.016, 0.0, 0.0], [0.004, 0.0, 0.0], [0.0, -0.004, 0.001], [0.0, 0.016, 0.001]]
    core.call("findPairs", 0.0)
    core.call("findGuards", 0.0)
    core.arrays["place"][2:, 2] -= 0.0015  # through
    for _ in range(20):
        core.call("keepGap")
    z = core.arrays["place"][:, 2]
    assert 0.8 * (z[2] - z[0]) + 0.2 * (z[3] - z[1]) > 0.001, "back on the side on which it was"


def test_points_between_two_skins_have_the_nearer_one_s_plane() -> None:
    """Two walls 1 cm apart that face each other: a mean of both would face anywhere."""
    x, y = (one.ravel() for one in np.meshgrid(np.linspace(-0.1, 0.1, 21), np.linspace(-0.1, 0.1, 21)))
    left = np.column_stack([np.full(len(x), -0.005), x, y])
    walls = np.concatenate([left, left * [-1.0, 1.0, 1.0]])
    normals = np.repeat([[1.0, 0.0, 0.0], [-1.0, 0.0, 0.0]], len(x), axis=0)
    points = np.array([[-0.0005, 0.003, 0.002], [0.0005, 0.003, 0.002]])
    out = push_out_of_skin(points, Skin(walls, walls, normals), 0.0048, 0.05)
    assert out == pytest.approx(np.array([[-0.0002, 0.003, 0.002], [0.0002, 0.003, 0.002]]), abs=1e-6)


def test_skin_that_swings_past_takes_cloth_along() -> None:
    """A wall that goes 13 cm in a frame, as a foot does: cloth 1 cm before it is never behind it."""
    x, y = (one.ravel() for one in np.meshgrid(np.linspace(-0.3, 0.3, 61), np.linspace(-0.8, 0.3, 111)))
    wall = np.column_stack([x, y, np.zeros(len(x))])
    cloth = strip(0.1, 0.3, 0.02)
    top = np.flatnonzero(cloth.flat_m[:, 1] > -1e-6)
    sheet = make_sheet(cloth, FABRICS["cotton"], top)
    places = upright(cloth) + [0.0, 0.0, 0.01]
    front = np.tile([0.0, 0.0, 1.0], (len(x), 1))
    back = wall - [0.0, 0.0, 0.04]
    skin = Skin(
        np.concatenate([wall, back]), np.concatenate([wall, back]) + [0.0, 0.0, 0.13], np.concatenate([front, -front])
    )
    held = places[top]
    state = step(
        make_engine(sheet, 2 * len(x)), sheet.fabric, State(places, np.zeros_like(places)), skin,
        (held, held + [0.0, 0.0, 0.13]), 1 / 30, 40, CALM,
    )  # fmt: skip
    assert state.places_m[:, 2].min() > 0.13
