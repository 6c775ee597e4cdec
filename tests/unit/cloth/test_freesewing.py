"""Garments in FreeSewing's form, of a test's own numbers, worn by somebody else."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest

from cloner.bodies.made import clone_of_measures
from cloner.bodies.telling import BodySpecification
from cloner.cloth.drafting.freesewing import PIECES, read_svg_garment
from cloner.cloth.drafting.pattern import Pattern, length_m
from cloner.cloth.drafting.sections import Sections, sections
from cloner.cloth.dressing import find_pattern
from cloner.cloth.simulation.fabrics import FABRICS
from cloner.cloth.simulation.moving import place_garment, simulate
from cloner.cloth.simulation.solver import strains
from cloner.errors import ClonerError
from cloner.motion.limbs.rig import centre_joints
from cloner.motion.moves.own import own_motions
from cloner.records.clones import Clone

FRONT = "M 0,600 L 270,600 L 265,240 C 225,240 200,160 205,30 L 100,5 C 90,60 45,95 0,95 L 0,600 z"
BACK = "M 0,600 L 270,600 L 265,240 C 235,240 205,150 205,30 L 100,5 C 95,30 50,35 0,35 L 0,600 z"
#: Its cap has two more curves on the front's side than on the back's; its sides' handles lie on the cap's ends.
CAP = (
    "M -165,60 L 165,60 L 165,0 C 165,0 130,-20 115,-60 C 100,-100 60,-150 0,-150 "
    "C -60,-150 -110,-80 -120,-50 C -130,-25 -165,0 -165,0 L -165,60 z"
)
NOTCHES = '<use x="105" y="-90" xlink:href="#notch"/><use x="-112" y="-75" xlink:href="#bnotch"/>'


def draft_text(parts: dict[str, str], notches: str = NOTCHES) -> str:
    """Return a draft; every part has a seam allowance and a line of help beside its outline."""
    groups = "".join(
        f'<g id="fs-stack-mine.{name}" transform="translate(9, 9)"><g id="fs-stack-mine.{name}-part-mine.{name}">'
        f'<path class="fabric sa" d="M -20,-900 L 900,-900 L 900,900 z"/><path class="help" d="M 0,0 L 10,0"/>'
        f'<path class="fabric" d="{outline}"/>{notches if name == "sleeve" else ""}</g></g>'
        for name, outline in parts.items()
    )
    return (
        '<svg xmlns="http://www.w3.org/2000/svg" xmlns:xlink="http://www.w3.org/1999/xlink" '
        f'freesewing="4.10.2" width="900mm" height="700mm" viewBox="0 0 900 700">{groups}</svg>'
    )


def draft(folder: Path, parts: dict[str, str], notches: str = NOTCHES) -> Path:
    """Write a draft."""
    path = folder / "mine.svg"
    path.write_text(draft_text(parts, notches))
    return path


@pytest.fixture(scope="module")
def eva() -> Clone:
    return centre_joints(
        clone_of_measures(BodySpecification("f", 1.68, {"bust_girth": 920.0, "waist_girth": 740.0}), 512)
    )


@pytest.fixture(scope="module")
def body(eva: Clone) -> Sections:
    return sections(eva)


def run_m(pattern: Pattern, name: str) -> float:
    """Return the length of all pieces of a run."""
    return sum(length_m(pattern.edge(f"{name}_{k}")) for k in range(PIECES))


def test_a_half_on_the_fold_becomes_a_whole_piece_hung_from_the_neck(body: Sections, tmp_path: Path) -> None:
    pattern = read_svg_garment(draft(tmp_path, {"front": FRONT, "back": BACK}), body)
    assert [segment.around for segment in pattern.segments] == ["front", "back"]
    outline = np.concatenate([edge[[0]] for edge in pattern.segments[0].edges.values()])
    assert outline[:, 0].max() == pytest.approx(0.27)
    assert outline[:, 0].min() == pytest.approx(-0.27)
    neck = float(body.place("neck_base_L")[1]) - body.waist_m
    assert outline[:, 1].max() == pytest.approx(neck + 0.012)
    assert run_m(pattern, "front.left_side") == pytest.approx(np.hypot(0.005, 0.36), abs=1e-4)
    assert run_m(pattern, "front.right_shoulder") == pytest.approx(np.hypot(0.105, 0.025), abs=1e-4)
    assert len(pattern.held) == 2 * PIECES, "without sleeves its shoulders stay on"


def test_seams_join_the_same_places_and_run_against_each_other(body: Sections, tmp_path: Path) -> None:
    pattern = read_svg_garment(draft(tmp_path, {"front": FRONT, "back": BACK, "sleeve": CAP}), body)
    assert not pattern.held
    for one, other in pattern.seams:
        assert length_m(pattern.edge(one)) == pytest.approx(length_m(pattern.edge(other)), rel=0.08), (one, other)
    trunk = {"front": 1.0, "back": -1.0}
    for side, x in (("left", 1.0), ("right", -1.0)):
        for part, turned in trunk.items():
            under = pattern.edge(f"{part}.{side}_armhole_0")
            low = under[np.argmin(under[:, 1])]
            assert np.sign(low[0]) == x * turned, "the wearer's left is at +x in front, at -x behind"
            biceps = pattern.edge(f"{side}_sleeve.cap_{part}_0")
            start = biceps[np.argmin(biceps[:, 1])]
            assert np.sign(start[0]) == -x * turned, "a sleeve's front lies before the arm"
            assert (low == under[0]).all() != (start == biceps[0]).all(), "they run against each other"
    top = np.concatenate([pattern.edge(f"left_sleeve.cap_front_{PIECES - 1}")[[0, 3]]])
    assert np.abs(top).min(axis=0) == pytest.approx([0.0, 0.0], abs=1e-9), "the cap's top is the shoulder"


def test_a_sleeve_drawn_the_other_way_round_is_told_by_its_notches(body: Sections, tmp_path: Path) -> None:
    parts = {"front": FRONT, "back": BACK, "sleeve": CAP}
    turned = NOTCHES.replace('"105"', '"-105"').replace('"-112"', '"112"')
    one = read_svg_garment(draft(tmp_path, parts), body).edge("left_sleeve.cap_front_1")
    other = read_svg_garment(draft(tmp_path, parts, turned), body).edge("left_sleeve.cap_front_1")
    assert np.abs(one - other).max() > 1e-3, "what lay behind lies before"


def test_somebody_else_wears_it(eva: Clone, tmp_path: Path) -> None:
    path = draft(tmp_path, {"front": FRONT, "back": BACK, "sleeve": CAP})
    pattern, ring = find_pattern(eva, str(path), None)
    assert ring is None
    worn = place_garment(eva, pattern, None, FABRICS["cotton"], own_motions(eva)[0], 0.04)
    start = worn.start.places_m
    assert np.quantile(strains(worn.sheet, start), 0.95) < 0.25
    moved = next(state.places_m for number, state in simulate(worn, 1) if number == 0)
    assert np.linalg.norm(moved - start, axis=1).max() < 0.35, "it stays on"


@pytest.mark.parametrize(
    ("parts", "words"),
    [
        ({"front": FRONT}, "no parts 'front' and 'back'"),
        ({"front": FRONT, "back": BACK, "topSleeve": CAP}, "'topSleeve' is no whole sleeve"),
        ({"front": FRONT, "back": BACK, "sleeve": BACK}, "the sleeve has 6 edges"),
        ({"front": FRONT, "back": "M 0,0 L 9,9"}, "'back' has no outline"),
        (
            {"front": FRONT, "back": BACK.replace("0,600", "5,600", 1).replace("0,600 z", "5,600 z")},
            "not cut on the fold",
        ),
        ({"front": FRONT, "back": BACK.replace("L 265,240", "L 240,450 L 270,440 L 265,240")}, "'back' has 7 edges"),
        ({"front": FRONT, "back": BACK.replace("240 C", "240 Q")}, "command"),
    ],
)
def test_what_cannot_be_sewn_is_refused_by_name(
    parts: dict[str, str], words: str, body: Sections, tmp_path: Path
) -> None:
    with pytest.raises(ClonerError, match=words):
        read_svg_garment(draft(tmp_path, parts), body)
