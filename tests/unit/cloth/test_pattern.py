"""Pieces are cut as they were drawn, and bad ones are refused by name."""

from __future__ import annotations

import json
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest

from cloner.cloth.drafting.blocks import BLOCKS, draft_block
from cloner.cloth.drafting.cut import triangulate
from cloner.cloth.drafting.pattern import (
    Pattern,
    bezier,
    check_pattern,
    evenly_spaced,
    length_m,
    pattern_text,
    read_pattern,
)
from cloner.errors import ClonerError


@pytest.fixture
def skirt() -> Pattern:
    return draft_block(BLOCKS["skirt"], 0.75, 0.60)


def test_a_half_circle_skirt_has_a_half_circle_s_lengths(skirt: Pattern) -> None:
    check_pattern(skirt, "skirt")
    assert sum(length_m(segment.edges["top"]) for segment in skirt.segments) == pytest.approx(0.75, abs=1e-3)
    hem = 0.75 + np.pi * 0.60  # half a circle's circumference grows by pi times the way out
    assert sum(length_m(segment.edges["hem"]) for segment in skirt.segments) == pytest.approx(hem, abs=2e-3)
    assert length_m(skirt.edge("front.left")) == pytest.approx(0.60, abs=1e-9)


def test_points_lie_evenly_along_a_curve() -> None:
    bent = np.array([[0.0, 0.0], [0.0, 1.0], [0.1, 1.0], [1.0, 1.0]])
    apart = np.linalg.norm(np.diff(evenly_spaced(bent, 40), axis=0), axis=1)
    assert np.ptp(apart) < 0.01 * apart.mean()
    assert bezier(bent, np.array([0.0, 1.0])) == pytest.approx(bent[[0, 3]])


def test_cut_pieces_have_the_area_drawn_and_sewn_seams_are_closed(skirt: Pattern) -> None:
    cloth = triangulate(skirt, 0.03)
    corner = cloth.flat_m[cloth.triangles]
    one, other = corner[:, 1] - corner[:, 0], corner[:, 2] - corner[:, 0]
    area = (one[:, 0] * other[:, 1] - one[:, 1] * other[:, 0]) / 2.0
    assert (area > 0.0).all()
    inner = 0.75 / np.pi
    assert area.sum() == pytest.approx(np.pi / 2.0 * ((inner + 0.6) ** 2 - inner**2), rel=0.005)
    faces = cloth.faces
    sides = np.sort(np.concatenate([faces[:, [0, 1]], faces[:, [1, 2]], faces[:, [2, 0]]]), axis=1)
    _, count = np.unique(sides, axis=0, return_counts=True)
    assert count.max() == 2  # nowhere three triangles at one edge
    border = len(cloth.edges["front.top"]) + len(cloth.edges["front.hem"]) - 2
    assert (count == 1).sum() == 2 * border  # only the waist and the hem are open
    slim = np.sort(np.linalg.norm(np.diff(corner[:, [0, 1, 2, 0]], axis=1), axis=2), axis=1)
    assert np.quantile(slim[:, 0] / slim[:, 2], 0.01) > 0.4


def test_a_garment_is_read_as_it_was_written(skirt: Pattern, tmp_path: Path) -> None:
    path = tmp_path / "skirt.json"
    path.write_text(pattern_text(skirt))
    again = read_pattern(path)
    assert again.seams == skirt.seams
    assert again.edge("back.hem") == pytest.approx(skirt.edge("back.hem"), abs=1e-5)


def changed(skirt: Pattern, **edges: np.ndarray) -> Pattern:
    front = replace(skirt.segments[0], edges=dict(skirt.segments[0].edges) | edges)
    return replace(skirt, segments=(front, skirt.segments[1]))


def test_what_cannot_be_cut_is_refused_by_name(skirt: Pattern) -> None:
    open_top = skirt.edge("front.top") + np.array([0.0, 0.02])
    with pytest.raises(ClonerError, match="outline of the piece 'front' is open"):
        check_pattern(changed(skirt, top=open_top), "x")
    bent = skirt.edge("front.hem").copy()
    bent[1:3] = [[3.0, 1.0], [-3.0, 1.0]]
    with pytest.raises(ClonerError, match="crosses itself"):
        check_pattern(changed(skirt, hem=bent), "x")
    with pytest.raises(ClonerError, match="in no piece"):
        check_pattern(replace(skirt, seams=(("front.left", "back.sleeve"),)), "x")
    with pytest.raises(ClonerError, match="sewn twice"):
        check_pattern(replace(skirt, seams=(("front.left", "back.right"), ("front.left", "back.left"))), "x")
    with pytest.raises(ClonerError, match=r"of a seam are 37\.5 and 60\.0 cm long"):
        check_pattern(replace(skirt, seams=(("front.top", "back.right"),)), "x")
    huge = changed(skirt, **{name: 100.0 * edge for name, edge in skirt.segments[0].edges.items()})
    with pytest.raises(ClonerError, match="no garment's size"):
        check_pattern(huge, "x")
    for lies in (((0.0, 0.0), (0.0, 0.1)), ((0.0, np.nan),)):
        falling = replace(skirt, segments=(replace(skirt.segments[0], lies=lies), skirt.segments[1]))
        with pytest.raises(ClonerError, match="heights that do not rise"):
            check_pattern(falling, "x")


@pytest.mark.parametrize("text", ["", "[]", '{"format": 1}', '{"format": 9, "segments": [], "seams": []}', "[" * 2000])
def test_files_that_are_no_garment_are_refused(text: str, tmp_path: Path) -> None:
    path = tmp_path / "x.json"
    path.write_text(text)
    with pytest.raises(ClonerError):
        read_pattern(path)


def test_edges_of_other_forms_are_refused(tmp_path: Path) -> None:
    told = {
        "format": 1,
        "segments": [{"name": "a", "edges": {"top": [[0, 0], [1, 1]], "hem": [[1, 1], [0, 0]]}}],
        "seams": [],
    }
    path = tmp_path / "x.json"
    path.write_text(json.dumps(told))
    with pytest.raises(ClonerError, match="no curve of four points"):
        read_pattern(path)
