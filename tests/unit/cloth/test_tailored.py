"""Garments cut to measure fit many bodies: whole, sewn as garments are, closed round the body and outside it."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest
from scipy.sparse import coo_array
from scipy.sparse.csgraph import connected_components

from cloner.bodies.made import clone_of_measures
from cloner.bodies.telling import BodySpecification
from cloner.cloth.drafting.blocks import BLOCKS, line
from cloner.cloth.drafting.cut import Cloth, triangulate
from cloner.cloth.drafting.pattern import Segment, check_pattern, length_m, pattern_text, read_pattern
from cloner.cloth.drafting.sections import convex_ring, girth_of, offset_ring, sections
from cloner.cloth.dressing import GARMENTS, find_pattern
from cloner.cloth.simulation.fabrics import FABRICS
from cloner.cloth.simulation.moving import place_garment, simulate
from cloner.cloth.simulation.placing import body_ring
from cloner.cloth.simulation.solver import strains
from cloner.cloth.simulation.wrapping import _spans
from cloner.errors import ClonerError
from cloner.generic.load import load_generic
from cloner.motion.limbs.rig import centre_joints
from cloner.motion.moves.own import own_motions
from cloner.records.clones import Clone

#: What is open in each garment: neck, hem, cuffs, ...
OPENINGS = {
    "skirt": 2, "circle-skirt": 2, "straight-skirt": 2, "long-skirt": 2, "cape": 1, "tee": 4, "dress": 4, "coat": 3,
    "trousers": 3,
}  # fmt: skip
PEOPLE = {
    "eva": BodySpecification("f", 1.68, {"waist_girth": 740.0}),
    "tall": BodySpecification("m", 1.92, {"bust_girth": 1020.0, "waist_girth": 860.0}),
    "stout": BodySpecification("m", 1.74, {"bust_girth": 1180.0, "waist_girth": 1120.0, "hip_girth": 1150.0}),
    "slight": BodySpecification("f", 1.52, {"bust_girth": 800.0, "waist_girth": 620.0, "hip_girth": 860.0}),
}


@pytest.fixture(scope="module")
def people() -> dict[str, Clone]:
    return {name: centre_joints(clone_of_measures(told, 512)) for name, told in PEOPLE.items()}


def borders(cloth: Cloth) -> int:
    """Return how many closed borders a sewn garment has; also that no edge has more than two triangles."""
    faces = cloth.faces
    sides = np.sort(np.concatenate([faces[:, [0, 1]], faces[:, [1, 2]], faces[:, [2, 0]]]), axis=1)
    ends, count = np.unique(sides, axis=0, return_counts=True)
    assert count.max() == 2
    rim = ends[count == 1]
    assert set(np.bincount(rim.ravel()).tolist()) == {0, 2}  # each border goes through a vertex once
    rows = np.unique(rim)
    own = np.searchsorted(rows, rim)
    graph = coo_array((np.ones(len(own)), (own[:, 0], own[:, 1])), shape=(len(rows), len(rows)))
    return int(connected_components(graph, directed=False)[0])


@pytest.mark.parametrize("garment", sorted(GARMENTS))
def test_every_block_fits_every_body(people: dict[str, Clone], garment: str) -> None:
    for name, clone in people.items():
        pattern, ring_level = find_pattern(clone, garment, None)
        check_pattern(pattern, name)
        for one, other in pattern.seams:
            long, short = length_m(pattern.edge(one)), length_m(pattern.edge(other))
            assert abs(long - short) < 0.02 * long + 0.002
        ring = body_ring(clone, ring_level) if ring_level else None
        worn = place_garment(clone, pattern, ring, FABRICS["cotton"], own_motions(clone)[0], 0.035)
        cloth, places = worn.cloth, worn.start.places_m
        assert borders(cloth) == OPENINGS[garment]
        assert np.isfinite(places).all()
        if ring is None:
            assert np.median(np.maximum(strains(worn.sheet, places), 0.0)) < 0.03  # what is short folds
            assert np.quantile(strains(worn.sheet, places), 0.95) < 0.2
            far = np.linalg.norm(places - places[worn.sheet.anchor], axis=1) - 1.01 * worn.sheet.leash_m
            assert far.max() < 0.03  # what hung farther from its held seam was thrown up by a metre when let go


def test_seams_lie_together(people: dict[str, Clone]) -> None:
    clone = people["eva"]
    pattern, _ = find_pattern(clone, "coat", None)
    cloth = triangulate(pattern, 0.035)
    for one, other in pattern.seams:
        assert cloth.vertex[cloth.edges[one]].tolist() == cloth.vertex[cloth.edges[other][::-1]].tolist()


def test_a_ring_is_the_hull_s_and_grows_by_its_turn() -> None:
    angle = np.linspace(0.0, 2.0 * np.pi, 400, endpoint=False)
    ring = convex_ring(np.column_stack([0.2 * np.sin(angle), 0.2 * np.cos(angle)]))
    assert girth_of(ring) == pytest.approx(0.4 * np.pi, rel=1e-3)
    assert ring[0] == pytest.approx([0.0, 0.2], abs=2e-3)
    assert ring[len(ring) // 4] == pytest.approx([0.2, 0.0], abs=2e-3)
    assert girth_of(offset_ring(ring, 0.05)) == pytest.approx(0.5 * np.pi, rel=1e-3)


def test_lengths_and_ease_are_those_asked_for(people: dict[str, Clone]) -> None:
    clone = people["eva"]
    body = sections(clone)
    dress, _ = find_pattern(clone, "dress", 70.0)
    assert dress.edge("front.hem")[:, 1] == pytest.approx(-0.7)
    trousers, _ = find_pattern(clone, "trousers", None)
    waist = sum(
        length_m(trousers.edge(f"{part}_{side}.waist")) for part in ("left", "right") for side in ("front", "back")
    )
    assert waist == pytest.approx(1.10 * body.girth("trunk", body.waist_m), rel=0.01)
    for garment, length in (("dress", 300.0), ("trousers", 20.0), ("tee", float("nan"))):
        with pytest.raises(ClonerError, match=garment):
            find_pattern(clone, garment, length)


def test_a_tee_stays_on_by_friction_alone(people: dict[str, Clone]) -> None:
    clone = people["eva"]
    pattern, _ = find_pattern(clone, "tee", None)
    assert pattern.held == ()
    worn = place_garment(clone, pattern, None, FABRICS["cotton"], own_motions(clone)[0], 0.045)
    states = [state.places_m for number, state in simulate(worn, 2) if number >= 0]
    shoulder = float(clone.vertices_m[load_generic().feature("acromion_L"), 1])
    for places in (states[0], states[-1]):
        assert float(places[:, 1].max()) == pytest.approx(shoulder + 0.04, abs=0.08)
        lowest = float(places[:, 1].min())
        hip = float(clone.vertices_m[load_generic().feature("crotch"), 1])
        assert lowest == pytest.approx(hip, abs=0.18)
    assert np.linalg.norm(states[-1] - states[0], axis=1).max() < 0.6


def test_what_lies_nowhere_is_refused(people: dict[str, Clone], tmp_path: Path) -> None:
    pattern, _ = find_pattern(people["eva"], "tee", None)
    tail = replace(pattern, segments=(replace(pattern.segments[0], around="tail"), *pattern.segments[1:]))
    with pytest.raises(ClonerError, match="lies round 'tail'"):
        check_pattern(tail, "x")
    half = replace(pattern, segments=(replace(pattern.segments[0], around=""), *pattern.segments[1:]))
    with pytest.raises(ClonerError, match="some pieces hang"):
        check_pattern(half, "x")
    with pytest.raises(ClonerError, match="held edge"):
        check_pattern(replace(pattern, held=("front.collar",)), "x")


def test_a_tailored_garment_is_read_as_it_was_written(people: dict[str, Clone], tmp_path: Path) -> None:
    pattern, _ = find_pattern(people["eva"], "coat", None)
    path = tmp_path / "coat.json"
    path.write_text(pattern_text(pattern))
    again = read_pattern(path)
    assert [segment.around for segment in again.segments] == [segment.around for segment in pattern.segments]
    assert again.held == pattern.held
    assert [np.round(segment.lies, 6).tolist() for segment in again.segments] == [
        np.round(segment.lies, 6).tolist() for segment in pattern.segments
    ]
    assert find_pattern(people["eva"], str(path), None)[1] is None


def test_a_front_is_as_long_as_the_way_over_the_bust(people: dict[str, Clone]) -> None:
    """Its shoulder is drawn higher than it lies, a back's less; no thread is drawn out where it is put on."""
    clone = people["eva"]
    pattern, _ = find_pattern(clone, "tee", None)
    longer = {
        segment.name: segment.lies[-1][0] - segment.lies[-1][1]
        for segment in pattern.segments
        if segment.around in ("front", "back")
    }
    assert 0.015 < longer["front"] < 0.12
    assert longer["back"] < longer["front"]
    worn = place_garment(clone, pattern, None, FABRICS["cotton"], own_motions(clone)[0], 0.035)
    assert np.quantile(strains(worn.sheet, worn.start.places_m), 0.95) < 0.09


def test_a_cape_hangs_open_in_front(people: dict[str, Clone]) -> None:
    clone = people["eva"]
    pattern, level = find_pattern(clone, "cape", None)
    assert level == BLOCKS["cape"].ring
    worn = place_garment(clone, pattern, body_ring(clone, "neck"), FABRICS["wool"], own_motions(clone)[0], 0.05)
    cloth, places = worn.cloth, worn.start.places_m
    free = [cloth.vertex[cloth.edges[f"{side}.{edge}"]] for side, edge in (("left", "left"), ("right", "right"))]
    assert all(places[rows, 2].mean() > 0.1 for rows in free)  # both free edges lie before the chest
    seam = cloth.vertex[cloth.edges["left.right"]]
    assert places[seam, 2].mean() < 0.0


def test_rounded_outlines_have_a_width_at_their_ends() -> None:
    """An average man's hem lay a bit's breadth below its own outline: one vertex of each leg had no place."""
    edges = {"hem": line((0.0, -0.9), (0.2, -0.9)), "side": line((0.2, -0.9), (0.2, 0.0))}
    edges |= {"top": line((0.2, 0.0), (0.0, 0.0)), "other": line((0.0, 0.0), (0.0, -0.9))}
    low, high = _spans(Segment("a", edges), np.array([np.nextafter(-0.9, -1.0), 0.0, np.nextafter(0.0, 1.0), 0.1]))
    assert low[:3] == pytest.approx([0.0, 0.0, 0.0])
    assert high[:3] == pytest.approx([0.2, 0.2, 0.2])
    assert np.isnan([low[3], high[3]]).all()


def test_pieces_without_a_place_are_refused(people: dict[str, Clone], monkeypatch: pytest.MonkeyPatch) -> None:
    clone = people["eva"]
    pattern, _ = find_pattern(clone, "tee", None)

    def nowhere(*_: object) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
        return np.full((triangulate(pattern, 0.08).count, 3), np.nan), np.zeros(0, np.int64), np.zeros((0, 3))

    monkeypatch.setattr("cloner.cloth.simulation.moving.wrap_around", nowhere)
    with pytest.raises(ClonerError, match="laid"):
        place_garment(clone, pattern, None, FABRICS["cotton"], own_motions(clone)[0], 0.08)
