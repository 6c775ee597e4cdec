"""Plans become rooms: what scenarios walk on is floor, what stands in their way stands there, nothing else."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest

from cloner.behaviour.language import read_scenario
from cloner.errors import ClonerError
from cloner.scenes.building.charts import PAD, make_charts
from cloner.scenes.building.gltf import make_meshes
from cloner.scenes.building.reading import SHIPPED, parse_plan, read_plan
from cloner.scenes.building.solids import build_room

SAMPLE = Path(__file__).parents[3] / "samples" / "museum.crowd"
FLOOR = '[[floor]]\nfrom = [0, 0]\nto = [4, 3]\nlook = "flags"\n'
WALL = '[[wall]]\nfrom = [0, 3]\nto = [4, 3.4]\nhigh = 3\nlook = "plaster"\n'


def box_of(corners) -> tuple[float, ...]:
    low, high = np.min(corners, axis=0), np.max(corners, axis=0)
    return tuple(np.round([*low, *high], 6).tolist())


def test_the_museum_stands_where_its_scenario_walks() -> None:
    plan, scenario = read_plan("museum")[0], read_scenario(SAMPLE)
    assert sorted(box_of([one.low, one.high]) for one in plan.floors) == sorted(
        box_of(one.corners) for one in scenario.floors
    )
    blocks = {one.name: box_of([np.array(one.at) - np.array(one.size) / 2, np.array(one.at) + np.array(one.size) / 2])
              for one in plan.blocks}  # fmt: skip
    assert {one.name: box_of(one.corners) for one in scenario.obstacles}.items() <= blocks.items()
    assert {one.name: tuple(one.at) for one in scenario.things} == {
        one.name: one.at for one in plan.blocks if one.name in ("venus", "apollo")
    }


@pytest.mark.parametrize("name", SHIPPED)
def test_walls_stand_beside_floors_and_doors_stay_open(name: str) -> None:
    room = build_room(read_plan(name)[0])
    for one in room.plan.floors:
        x, y = np.meshgrid(np.linspace(one.low[0] + 0.05, one.high[0] - 0.05, 40),
                           np.linspace(one.low[1] + 0.05, one.high[1] - 0.05, 40))  # fmt: skip
        places = np.column_stack([x.ravel(), np.full(x.size, 1.5), -y.ravel()])
        stands = np.zeros(len(places), bool)
        for block in room.plan.blocks:
            half = np.array(block.size) / 2 + 1e-9
            stands |= (np.abs(places[:, [0, 2]] * (1, -1) - block.at) <= half).all(axis=1)
        solid = np.zeros(len(places), bool)
        for low, high in room.boxes:
            solid |= ((places > low) & (places < high)).all(axis=1)
        assert not (solid & ~stands).any(), "a wall stands on the floor"


@pytest.mark.parametrize("name", SHIPPED)
def test_every_pillar_has_all_its_sides(name: str) -> None:
    room = build_room(read_plan(name)[0])
    shafts = [one for one in room.panels if abs(one.normal[1]) < 1e-9 and one.size[0] < 0.3 and one.size[1] > 4.0]
    assert len(shafts) == 8 * sum(one.pillar for one in room.plan.blocks)


def test_a_wall_is_there_behind_what_hangs_before_its_middle_and_a_base_has_a_top() -> None:
    hung = '[[block]]\nname = "a"\nat = [2, 2.95]\nsize = [1, 0.1]\nlow = 1\nhigh = 2\nlook = "stone"\n'
    stood = '[[pillar]]\nnames = ["b"]\nat = [[1, 1]]\nsize = [0.8, 0.8]\nhigh = 3\nlook = "stone"\n'
    room = build_room(parse_plan(FLOOR + WALL + hung + stood, "x.toml"))
    assert any(one.normal[2] > 0.99 and one.size == pytest.approx((4.0, 3.0)) for one in room.panels)
    level = [one for one in room.panels if abs(one.normal[1]) > 0.99 and one.size == pytest.approx((0.8, 0.8))]
    assert sorted(float(one.normal[1]) for one in level) == [-1.0, 1.0, 1.0]  # below the capital, on it, on the base


@pytest.mark.parametrize("name", SHIPPED)
def test_charts_do_not_overlap_and_floors_have_texels_of_4_cm(name: str) -> None:
    room = build_room(read_plan(name)[0])
    charts, (wide, tall) = make_charts(room)
    taken = np.zeros((tall, wide), int)
    for chart in charts:
        taken[chart.y - PAD : chart.y + chart.size[1] + PAD, chart.x - PAD : chart.x + chart.size[0] + PAD] += 1
        if chart.panel.normal[1] > 0.99 and chart.panel.corner[1] < 1e-6:
            assert max(np.array(chart.panel.size) / (np.array(chart.size) - 1)) <= 0.04 + 1e-9
    assert taken.max() == 1
    for mesh in make_meshes(charts, (wide, tall), room.looks):
        assert ((mesh.light_uv > 0.0) & (mesh.light_uv < 1.0)).all()
        corners = mesh.places[mesh.triangles]
        turned = np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0])
        assert ((turned * mesh.normals[mesh.triangles[:, 0]]).sum(axis=1) > 0.0).all(), "faces look outwards"


@pytest.mark.parametrize(
    ("text", "said"),
    [
        ("", "no floor"),
        (FLOOR.replace("flags", "gold"), "the look 'gold', which is none of"),
        (FLOOR.replace("[4, 3]", "[0, 3]"), "not right of"),
        (FLOOR.replace("[4, 3]", "[4, nan]"), "not 2 numbers"),
        (FLOOR + WALL + "openings = [{ at = 3.9, wide = 1, low = 0, high = 2 }]\n", "does not lie in its wall"),
        (FLOOR + WALL.replace("high = 3\n", ""), "'high'"),
        (FLOOR + "[[throne]]\n", "'throne'"),
        (
            FLOOR + '[[pillar]]\nnames = ["a"]\nat = [[1, 1], [2, 2]]\nsize = [1, 1]\nhigh = 3\nlook = "stone"\n',
            "names",
        ),
        ("floor = 3", "[[floor]]"),
        ("[[floor", "cannot be read"),
    ],
)
def test_wrong_plans_are_refused_in_one_sentence(text: str, said: str) -> None:
    with pytest.raises(ClonerError) as error:
        parse_plan(text, "x.toml")
    assert said in str(error.value)
