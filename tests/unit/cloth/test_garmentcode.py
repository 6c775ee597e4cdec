"""Garments in GarmentCode's form, of a test's own numbers, worn by somebody else."""

from __future__ import annotations

import copy
import json
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from cloner.bodies.made import clone_of_measures
from cloner.bodies.telling import BodySpecification
from cloner.cloth.drafting.garmentcode import read_garment
from cloner.cloth.drafting.pattern import length_m
from cloner.cloth.drafting.sections import Sections, sections
from cloner.cloth.dressing import find_pattern
from cloner.cloth.simulation.fabrics import FABRICS
from cloner.cloth.simulation.moving import place_garment, simulate
from cloner.cloth.simulation.solver import strains
from cloner.errors import ClonerError
from cloner.evaluate.measures.crossings import self_intersections
from cloner.motion.limbs.rig import centre_joints
from cloner.motion.moves.own import own_motions
from cloner.records.clones import Clone


@pytest.fixture(scope="module")
def eva() -> Clone:
    return centre_joints(
        clone_of_measures(BodySpecification("f", 1.68, {"bust_girth": 920.0, "waist_girth": 740.0}), 512)
    )


@pytest.fixture(scope="module")
def body(eva: Clone) -> Sections:
    return sections(eva)


def panel(corners: list[tuple[float, float]], at: tuple[float, float, float], turn: float = 0.0, **bends: Any) -> dict:
    """Return a panel with straight edges, but those that ``bends`` names ("e1")."""
    edges: list[dict[str, Any]] = [{"endpoints": [k, (k + 1) % len(corners)]} for k in range(len(corners))]
    for name, bend in bends.items():
        edges[int(name[1:])]["curvature"] = bend
    return {"translation": list(at), "rotation": [0.0, 0.0, turn], "vertices": corners, "edges": edges}


def mirrored(one: dict) -> dict:
    """Return a panel of the other side: x and turns the other way, edges run back."""
    out = copy.deepcopy(one)
    out["vertices"] = [(-x, y) for x, y in one["vertices"]]
    out["translation"][0] *= -1.0
    out["rotation"][2] *= -1.0
    return out


def specification(panels: dict[str, dict], stitches: list[tuple[str, int, str, int]]) -> dict[str, Any]:
    seams = [[{"panel": a, "edge": k}, {"panel": b, "edge": m}] for a, k, b, m in stitches]
    properties = {"curvature_coords": "relative", "units_in_meter": 100}
    return {"pattern": {"panels": panels, "stitches": seams}, "properties": properties}


def shirt() -> dict[str, Any]:
    """Return a shirt: four panels of the trunk, two of each sleeve; shoulders at 138 cm of another body."""
    torso = [(0.0, 0.0), (25.0, 0.0), (25.0, 26.0), (17.5, 45.0), (9.0, 48.0), (0.0, 38.0)]
    bends = {"e2": {"type": "cubic", "params": [[0.3, 0.2], [0.6, 0.15]]},
             "e4": {"type": "quadratic", "params": [[0.4, 0.2]]}}  # fmt: skip
    front = panel(torso, (0.0, 90.0, 22.0), **bends)
    back = panel(torso, (0.0, 90.0, -22.0), **bends)
    cap = {"e1": {"type": "cubic", "params": [[0.35, -0.12], [0.65, 0.04]]}}
    sleeve = [(0.0, 0.0), (-26.0, 0.0), (-15.0, -17.5), (0.0, -15.5)]
    arm_front, arm_back = (
        panel(sleeve, (48.0, 112.0, 17.0), -45.0, **cap),
        panel(sleeve, (48.0, 112.0, -13.0), -45.0, **cap),
    )
    panels, stitches = {}, []
    for side in ("left", "right"):
        own = [front, back, arm_front, arm_back]
        names = [f"{side}_{name}" for name in ("ftorso", "btorso", "sleeve_f", "sleeve_b")]
        bent = own if side == "left" else [mirrored(one) for one in own]
        for name, one in zip(names, bent, strict=True):
            if side == "right":
                for edge in one["edges"]:
                    for x in edge.get("curvature", {}).get("params", ()):
                        x[1] *= -1.0
            panels[name] = one
        f, b, sf, sb = names
        stitches += [(f, 1, b, 1), (f, 3, b, 3), (sf, 0, sb, 0), (sf, 2, sb, 2), (sf, 1, f, 2), (sb, 1, b, 2)]
    stitches += [("left_ftorso", 5, "right_ftorso", 5), ("left_btorso", 5, "right_btorso", 5)]
    return specification(panels, stitches)


def skirt() -> dict[str, Any]:
    """Return a flared skirt of two panels with arcs above and below."""

    def half(z: float) -> dict:
        corners = [(0.0, 0.0), (-20.0, -50.0), (59.0, -50.0), (39.0, 0.0)]
        bends = {"e1": {"type": "circle", "params": [120.0, 0, 1]}, "e3": {"type": "circle", "params": [60.0, 0, 0]}}
        return panel(corners, (-19.5, 104.0, z), **bends)

    return specification({"skirt_front": half(17.0), "skirt_back": half(-13.0)},
                         [("skirt_front", 0, "skirt_back", 0), ("skirt_front", 2, "skirt_back", 2)])  # fmt: skip


def trousers() -> dict[str, Any]:
    """Return trousers with a dart in each of four panels and a band of two; crotch at 78 cm of another body."""
    rise, panels, stitches = {"type": "quadratic", "params": [[0.9, 0.3]]}, {}, []
    for part, reach, wide, z in (("f", 5.0, 24.0, 22.0), ("b", 9.0, 26.0, -20.0)):
        side, dart = reach + wide - 3.0, reach + (wide - 3.0) / 2.0
        corners = [(side + 1.0, -68.0), (side + 3.0, 6.0), (side, 26.0), (dart + 1.25, 26.0), (dart, 14.0),
                   (dart - 1.25, 26.0), (reach, 26.0), (reach, 15.0), (0.0, 0.0), (reach, -68.0)]  # fmt: skip
        left = panel(corners, (0.5, 78.0, z), e7=rise)
        right = mirrored(left)
        right["edges"][7]["curvature"]["params"][0][1] *= -1.0
        panels |= {f"pant_{part}_l": left, f"pant_{part}_r": right}
        piece = (wide - 3.0 - 2.5) / 2.0
        across = [k * piece for k in (-2.0, -1.0, 0.0, 1.0, 2.0)]
        panels[f"wb_{part}"] = panel(
            [*((x, 0.0) for x in across), (across[-1], 4.0), (across[0], 4.0)], (0.0, 106.0, z)
        )
        for number, place in enumerate(("r", "r", "l", "l")):
            stitches.append((f"wb_{part}", number, f"pant_{part}_{place}", (2, 5, 5, 2)[number]))
        stitches += [(f"pant_{part}_{side}", 3, f"pant_{part}_{side}", 4) for side in "lr"]
        stitches += [(f"pant_{part}_l", edge, f"pant_{part}_r", edge) for edge in (6, 7)]
    stitches += [(f"pant_f_{side}", edge, f"pant_b_{side}", edge) for side in "lr" for edge in (0, 1, 8)]
    stitches += [("wb_f", edge, "wb_b", edge) for edge in (4, 6)]
    return specification(panels, stitches)


def written(told: Any, folder: Path, name: str = "mine_specification.json") -> Path:
    (folder / name).write_text(json.dumps(told))
    return folder / name


def test_panels_go_round_the_parts_that_they_stand_beside(body: Sections, tmp_path: Path) -> None:
    pattern = read_garment(written(shirt(), tmp_path), body)
    assert pattern.name == "mine"
    around = {segment.name: segment.around for segment in pattern.segments}
    assert around["left_ftorso"] == "front"
    assert around["right_btorso"] == "back"
    assert around["left_sleeve_b"] == "left_arm"
    assert around["right_sleeve_f"] == "right_arm"
    assert not pattern.held, "sleeves hold a shirt"
    left = next(one for one in pattern.segments if one.name == "left_ftorso")
    corner = np.concatenate([edge[[0]] for edge in left.edges.values()])
    assert corner[:, 0].max() == pytest.approx(0.25)
    assert corner[:, 1].max() == pytest.approx(float(body.place("neck_base_L")[1]) - body.waist_m + 0.008, abs=0.03)
    back = next(one for one in pattern.segments if one.name == "left_btorso")
    assert min(float(edge[:, 0].min()) for edge in back.edges.values()) == pytest.approx(-0.25)
    sleeve = next(one for one in pattern.segments if one.name == "left_sleeve_f")
    ends = np.concatenate(list(sleeve.edges.values()))
    assert ends[:, 1].max() == pytest.approx(0.0)
    assert ends[:, 1].min() == pytest.approx(-0.26)


def test_an_arc_is_as_long_as_the_circle_s(body: Sections, tmp_path: Path) -> None:
    pattern = read_garment(written(skirt(), tmp_path), body)
    hem, top = pattern.edge("skirt_front.e1"), pattern.edge("skirt_front.e3")
    assert length_m(hem) == pytest.approx(2.4 * np.arcsin(0.79 / 2.4), rel=1e-3)
    assert length_m(top) == pytest.approx(1.2 * np.arcsin(0.39 / 1.2), rel=1e-3)
    assert hem[:, 1].min() < hem[[0, 3], 1].min()  # both dip
    assert set(pattern.held) == {"skirt_front.e3", "skirt_back.e3"}


def test_trousers_meet_in_the_middle_and_hang_by_their_band(body: Sections, tmp_path: Path) -> None:
    pattern = read_garment(written(trousers(), tmp_path), body)
    around = {segment.name: segment.around for segment in pattern.segments}
    assert around["pant_f_l"] == "left_leg_front"
    assert around["pant_b_r"] == "right_leg_back"
    assert around["wb_b"] == "back"
    assert pattern.held == ("wb_f.e5", "wb_b.e5")
    for name, reach, outer in (("pant_f_l", 0.05, 1.0), ("pant_f_r", 0.05, -1.0), ("pant_b_l", 0.09, -1.0)):
        rise = pattern.edge(f"{name}.e6")
        np.testing.assert_allclose(rise[:, 0], 0.0, atol=1e-3)
        own = next(one for one in pattern.segments if one.name == name).edges
        assert min(float((outer * edge[:, 0]).min()) for edge in own.values()) == pytest.approx(-reach, abs=1e-3)


@pytest.mark.parametrize("told", [shirt, skirt, trousers])
def test_somebody_else_wears_it(told: Any, eva: Clone, tmp_path: Path) -> None:
    pattern, ring = find_pattern(eva, str(written(told(), tmp_path)), None)
    assert ring is None
    worn = place_garment(eva, pattern, None, FABRICS["cotton"], own_motions(eva)[0], 0.04)
    assert np.quantile(strains(worn.sheet, worn.start.places_m), 0.95) < 0.25
    moved = next(state.places_m for number, state in simulate(worn, 1) if number == 0)
    assert np.isfinite(moved).all()
    start = worn.start.places_m
    low = 0.45 * eva.stature_m if told is trousers else 0.0  # legs walk
    assert np.linalg.norm(moved - start, axis=1)[start[:, 1] > low].max() < 0.35, "it stays on"
    assert len(np.unique(self_intersections(moved, worn.cloth.faces).pairs)) < 0.05 * len(worn.cloth.faces)


def test_what_is_no_garment_is_refused_in_one_sentence(body: Sections, tmp_path: Path) -> None:
    none, open_one, unlike, arc = skirt(), skirt(), skirt(), skirt()
    none["pattern"]["stitches"][0][0]["panel"] = "nobody"
    open_one["pattern"]["panels"]["skirt_front"]["edges"].pop()
    unlike["pattern"]["stitches"][0] = [{"panel": "skirt_front", "edge": 0}, {"panel": "skirt_back", "edge": 1}]
    bend = {"endpoints": [0, 0], "curvature": {"type": "circle", "params": [120.0, 0, 1]}}
    arc["pattern"]["panels"]["skirt_front"]["edges"][0] = bend
    for told, words in ((arc, "no garment of GarmentCode"),
                        (none, "no garment of GarmentCode"), (open_one, "open"),
                        (unlike, "long"), ({"pattern": {}}, "no garment of GarmentCode")):  # fmt: skip
        with pytest.raises(ClonerError, match=words):
            read_garment(written(told, tmp_path), body)
