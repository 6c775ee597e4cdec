"""The source's elements against what mechanics says of strips, cantilevers, folds and energy."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest
from scipy.integrate import solve_bvp

from cloner.cloth.drafting.cut import Cloth
from cloner.cloth.simulation import implicit
from cloner.cloth.simulation.elements import compute_strain, energy_j, make_elements, stresses
from cloner.cloth.simulation.fabrics import BENDING_N_M, FABRICS, FULL_N_M, LOOP_N, Fabric, read_fabric
from cloner.cloth.simulation.forces import bending_forces, no_slips
from cloner.cloth.simulation.implicit import make_system
from cloner.cloth.simulation.solver import State, make_engine, make_sheet
from cloner.errors import ClonerError
from unit.cloth.test_solver import CALM, far_floor, strip, upright

#: Straight curves without loops, no air: what textbooks calculate.
IDEAL = replace(
    FABRICS["cotton"], extension=(0.6, 0.6), linearity=(1.0, 1.0), resilience=(1.0, 1.0), bending_hysteresis=(0.0, 0.0),
    shearing_hysteresis=(0.0, 0.0), shearing_hysteresis_5=(0.0, 0.0), air=0.0,
)  # fmt: skip
WEIGHT_N_M2 = IDEAL.weight_kg_m2 * 9.81


def run(cloth: Cloth, fabric: Fabric, held: np.ndarray, places: np.ndarray, frames: int) -> list[State]:
    sheet, system = make_sheet(cloth, fabric, held), make_system(cloth, fabric)
    states, fixed, floor = [State(places, np.zeros_like(places))], (places[held], places[held]), far_floor(-5.0)
    core = make_engine(sheet, len(floor.late_m))
    for _ in range(frames):
        states.append(implicit.step(sheet, core, system, states[-1], floor, fixed, 1.0 / 30.0, CALM))
    return states


def flat(cloth: Cloth) -> np.ndarray:
    """Return the cloth lying level, what hung down now ahead."""
    places = np.zeros((cloth.count, 3))
    places[cloth.vertex] = np.column_stack([cloth.flat_m[:, 0], np.zeros(len(cloth.flat_m)), -cloth.flat_m[:, 1]])
    return places


def test_a_strip_hangs_as_long_as_its_weight_draws_it() -> None:
    """Green's strain e, tension k e (1 + e') = w (L - y): summed over the length."""
    cloth = strip(0.2, 0.6, 0.05)
    held = np.unique(cloth.vertex[cloth.edges["a.top"]])
    hung = run(cloth, IDEAL, held, upright(cloth), 90)[-1]
    tension = WEIGHT_N_M2 * (0.6 - np.linspace(0.0, 0.6, 2001))
    stretch = np.ones(2001)
    for _ in range(50):
        strain = (stretch**2 - 1.0) / 2.0
        force = FULL_N_M / 0.6 * strain * stretch - tension
        stretch -= force / (FULL_N_M / 0.6 * (stretch**2 + strain))
    longer = np.trapezoid(stretch - 1.0, dx=0.6 / 2000)
    assert -float(hung.places_m[:, 1].min()) - 0.6 == pytest.approx(longer, rel=0.03)


def test_a_cantilever_sinks_as_the_elastica_does() -> None:
    """B t'' = -w (L - s) cos t from a level clamp; the clamp is half a row before the first free one."""
    fabric, step_m, long_m = replace(IDEAL, bending=(20.0, 20.0), extension=(0.05, 0.05)), 0.02, 0.12
    row = step_m * np.sqrt(3.0) / 2.0
    cloth = strip(0.1, long_m + 2.0 * row, step_m)
    places = flat(cloth)
    held = np.flatnonzero(places[:, 2] <= 2.0 * row + 1e-6)
    sunk = run(cloth, fabric, held, places, 120)[-1].places_m
    tip = places[:, 2] > places[:, 2].max() - 1e-6
    length = float(places[:, 2].max() - places[held, 2].max()) + row / 2.0
    along = np.linspace(0.0, length, 200)
    found = solve_bvp(
        lambda s, y: np.vstack([y[1], -WEIGHT_N_M2 * (length - s) * np.cos(y[0]) / (20.0 * BENDING_N_M)]),
        lambda start, end: np.array([start[0], end[1]]), along, np.vstack([np.linspace(0.0, 0.5, 200), np.zeros(200)]),
    )  # fmt: skip
    theory = float(np.trapezoid(np.sin(found.sol(along)[0]), along))
    assert -float(sunk[tip, 1].mean()) == pytest.approx(theory, rel=0.05)


@pytest.mark.parametrize("along", [0, 1])
def test_a_cylinder_holds_the_energy_of_its_curvature(along: int) -> None:
    """B k² / 2 an area, B of the direction in which it is bent; weft (x) is twice as stiff as warp here."""
    cloth = strip(0.2, 0.3, 0.01)
    made = make_elements(cloth, replace(IDEAL, bending=(10.0, 20.0)))
    x = np.zeros((cloth.count, 2))
    x[cloth.vertex] = cloth.flat_m
    curvature = 3.0
    places = np.column_stack([
        np.sin(curvature * x[:, along]) / curvature, (1.0 - np.cos(curvature * x[:, along])) / curvature,
        x[:, 1 - along],
    ])  # fmt: skip
    stiff = (20.0, 10.0)[along] * BENDING_N_M
    assert energy_j(made, places) == pytest.approx(stiff * curvature**2 * 0.06 / 2.0, rel=0.05)


def test_a_curve_goes_through_kawabata_s_point_and_back_below() -> None:
    silk = FABRICS["silk"]
    strain = np.array([[silk.extension[1], 0.0, 0.0], [silk.extension[1] / 2.0, 0.0, 0.0]])
    stress, _, half = stresses(silk, strain)
    assert stress[0, 0] + half[0, 0] == pytest.approx(FULL_N_M)
    assert (stress[0, 0] - half[0, 0]) / (stress[0, 0] + half[0, 0]) == pytest.approx(silk.resilience[1])
    work = np.trapezoid(
        [sum(stresses(silk, np.array([[e, 0.0, 0.0]]))[k][0, 0] for k in (0, 2)) for e in np.linspace(0, 0.04, 400)],
        dx=0.04 / 399,
    )
    assert work == pytest.approx(silk.linearity[1] * FULL_N_M * 0.04 / 2.0, rel=0.01)


def test_energy_never_grows_while_nothing_moves_it() -> None:
    cloth = strip(0.2, 0.4, 0.04)
    held = np.unique(cloth.vertex[cloth.edges["a.top"]])
    states = run(cloth, replace(FABRICS["wool"], air=0.0), held, flat(cloth), 60)
    sheet, made = make_sheet(cloth, FABRICS["wool"], held), make_elements(cloth, FABRICS["wool"])

    def energy(state: State) -> float:
        moving = 0.5 * float((sheet.mass_kg * (state.speeds_m_s**2).sum(axis=1)).sum())
        high = 9.81 * float((sheet.mass_kg * state.places_m[:, 1]).sum())
        return moving + high + energy_j(made, state.places_m)

    course = np.array([energy(state) for state in states])
    assert np.diff(course).max() < 1e-3 * np.ptp(course)
    assert np.ptp(course) > 0.02  # it fell


def test_a_bending_loop_is_as_wide_as_kawabata_prints_it() -> None:
    """Bent along the weft to 2 / cm and back: at 1 / cm both moments differ by 2HB, and a crease stays."""
    cloth = strip(0.1, 0.2, 0.01)
    made = make_elements(cloth, replace(IDEAL, bending_hysteresis=(0.4, 0.4)))
    x = np.zeros((cloth.count, 2))
    x[cloth.vertex] = cloth.flat_m

    def rolled(curvature: float) -> np.ndarray:
        turned = max(curvature, 1e-9) * x[:, 0]
        return (
            np.column_stack([np.sin(turned), 1.0 - np.cos(turned), turned * 0.0]) / max(curvature, 1e-9)
            + [0, 0, 1] * x[:, 1:]
        )

    held, moments = no_slips(made).bent_m, []
    for curvature in (*range(0, 201, 10), *range(190, -1, -10)):
        bent = bending_forces(made, rolled(curvature), np.zeros((cloth.count, 3)), held)
        held = bent.held_m
        grown = made.bends @ (rolled(curvature + 1.0) - rolled(curvature))
        moments.append(float((bent.turn_n * grown).sum()) / 0.02)
    there, back = moments[10], moments[30]
    assert there - back == pytest.approx(0.4 * LOOP_N, rel=0.15)
    assert moments[-1] < -0.4 * 0.4 * LOOP_N, "straightened again it pulls towards its crease"


def test_drawn_along_the_warp_it_grows_narrower() -> None:
    cloth = strip(0.1, 0.3, 0.03)
    ends = np.unique(cloth.vertex[np.concatenate([cloth.edges["a.top"], cloth.edges["a.hem"]])])
    places = upright(cloth)
    places[:, 1] *= 1.05
    pulled = run(cloth, replace(IDEAL, weight_kg_m2=0.01), ends, places, 20)[-1].places_m
    middle = np.abs(upright(cloth)[:, 1] + 0.15) < 0.04
    assert np.ptp(pulled[middle, 0]) < 0.0999


def test_the_same_start_gives_the_same_bytes() -> None:
    cloth = strip(0.2, 0.3, 0.05)
    held = np.unique(cloth.vertex[cloth.edges["a.top"]])
    one, other = (run(cloth, FABRICS["silk"], held, flat(cloth), 4)[-1].places_m for _ in range(2))
    assert one.tobytes() == other.tobytes()


def test_strain_is_green_s() -> None:
    cloth = strip(0.1, 0.1, 0.05)
    made = make_elements(cloth, IDEAL)
    places = upright(cloth) @ np.array([[1.1, 0.0, 0.0], [0.2, 0.9, 0.0], [0.0, 0.0, 1.0]])
    found = compute_strain(made, places).strain
    assert found == pytest.approx(np.tile([(1.1**2 - 1) / 2, (0.2**2 + 0.9**2 - 1) / 2, 1.1 * 0.2], (len(found), 1)))


def test_a_fabric_of_one_s_own_is_read_and_a_wrong_one_named(tmp_path: Path) -> None:
    sheet = "W=20\nEM=[4,6]\nLT=0.7\nRT=60\nB=0.1\n2HB=0.05\nG=0.7\n2HG=1\n2HG5=2\nMIU=0.2\nair=0.8\nT=0.5\nWC=0.2\n"
    mine = tmp_path / "mine.toml"
    mine.write_text(sheet)
    fabric = read_fabric(mine)
    assert (fabric.name, fabric.weight_kg_m2, fabric.extension) == ("mine", 0.2, (0.04, 0.06))
    assert fabric.linearity == (0.7, 0.7)
    for wrong, word in (
        (sheet.replace("EM=[4,6]", "EM=[4]"), "EM"),
        (sheet.replace("W=20\n", ""), "W"),
        (sheet.replace("G=0.7", "G=nan"), "G"),
        (sheet + "Q=1\n", "'Q'"),
        (sheet + 'colour="red"\n', "colour"),
        ("[", "no fabric"),
    ):
        mine.write_text(wrong)
        with pytest.raises(ClonerError, match=word):
            read_fabric(mine)
