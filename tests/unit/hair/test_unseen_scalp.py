"""What a front photo alone tells of the back of a head: hair beside what it shows goes on, a bare top too."""

from __future__ import annotations

from types import SimpleNamespace

import numpy as np
import pytest

from cloner.frames import ViewId
from cloner.generic.load import load_generic
from cloner.generic.surfaces import body_triangles
from cloner.geometry.meshes.graphs import surface_graph
from cloner.geometry.meshes.wedges import vertex_normals
from cloner.hair.shells.edge import FADE_MM, unseen_inside_mm
from cloner.hair.volumes.cap import VOTE_MM, Scalp, _with_unseen, label_votes, visibility_weights

GENERIC = load_generic()
POINTS = GENERIC.vertices_m.astype(np.float64)
SCALP = GENERIC.region("scalp")
HIGH = POINTS[:, 1] > POINTS[GENERIC.region("ear_left"), 1].max()
SHOWN = vertex_normals(POINTS, body_triangles())[:, 2] > 0.0


@pytest.fixture(scope="module")
def graph():
    return surface_graph(POINTS, body_triangles())


def told(graph, line_mm):
    return _with_unseen(graph, SCALP, line_mm, SHOWN, HIGH)[SCALP & ~SHOWN]


def test_behind_a_crop_is_hair_whatever_ears_and_neck_are(graph):
    line = np.where(SCALP & HIGH, 6.0, -VOTE_MM)
    assert (told(graph, line) == VOTE_MM).all()


def test_behind_a_bald_head_is_skin_and_a_wreath_keeps_its_bare_top(graph):
    bald = np.full(len(POINTS), -VOTE_MM)
    assert (told(graph, bald) == -VOTE_MM).all()
    wreath = np.where(np.abs(POINTS[:, 0]) > 0.06, 6.0, -VOTE_MM)
    found = _with_unseen(graph, SCALP, wreath, SHOWN, HIGH)
    crown = SCALP & ~SHOWN & (np.abs(POINTS[:, 0]) < 0.02) & HIGH
    nape = SCALP & ~SHOWN & ~HIGH
    assert (found[crown] < 0.0).mean() > 0.6
    assert (found[nape] == VOTE_MM).all()


def test_what_photos_show_stays_as_they_show_it(graph):
    line = np.where(SCALP & HIGH, 6.0, -VOTE_MM)
    assert np.array_equal(_with_unseen(graph, SCALP, line, SHOWN, HIGH)[SHOWN], line[SHOWN])
    seen = np.ones(len(POINTS), bool)
    assert _with_unseen(graph, SCALP, line, seen, HIGH) is line


def test_the_film_beyond_an_unseen_hairline_fades_and_a_fall_of_hair_before_it_does_not():
    hairy = SCALP.astype(float)
    none = np.zeros((1, len(POINTS)))
    normals = vertex_normals(POINTS, body_triangles())
    scalp = Scalp(POINTS, normals, POINTS.mean(axis=0), body_triangles(), none, hairy, hairy, 10.0 * hairy)
    crown, nape = GENERIC.feature("vertex_top"), GENERIC.feature("nape")
    film, fall = (POINTS[[crown, nape]] + away_m * normals[[crown, nape]] for away_m in (0.002, 0.02))
    on_crown, on_nape = unseen_inside_mm(scalp, film)
    assert on_crown > FADE_MM[1]
    assert on_nape < FADE_MM[0]
    assert (unseen_inside_mm(scalp, fall) == VOTE_MM).all()


@pytest.mark.parametrize("covered", [False, True])
def test_what_a_side_photo_shows_of_a_throat_is_the_hair_before_it_unless_it_is_covered(covered):
    """Between long curtains a band of hair lay below the chin, where no front photo looks; a headscarf lies there."""

    def photo(view, position, line):
        position = np.array(position)
        camera = SimpleNamespace(
            position_m=position,
            to_camera=lambda at: np.column_stack([at[:, :2], np.linalg.norm(at - position, axis=1)]),
            project=lambda at: np.full((len(at), 2), 2.0),
        )
        return SimpleNamespace(
            posed=SimpleNamespace(view=view, camera=camera), nearest_m=np.full((5, 5), 9.0, np.float32),
            line_px=np.full((5, 5), line, np.float32), pixel_mm=lambda at: 1.0, to_view=lambda at: at,
            turn=lambda at: at, speaks_for=lambda at: np.ones(len(at), bool),
        )  # fmt: skip

    views = [
        photo(ViewId.BODY_SIDE, (2.0, 1.5, 0.5), 10.0),
        photo(ViewId.FACE_FRONT, (0.0, 1.5, 2.0), 10.0 if covered else -10.0),
    ]
    normals, lobes_m = vertex_normals(POINTS, body_triangles()), POINTS[GENERIC.feature("ear_lobe_L")] * (0.0, 1.0, 1.0)
    free = np.stack([visibility_weights(view, POINTS, normals, None) for view in views])
    found, _ = label_votes(views, POINTS, normals, None, lobes_m)
    throat = np.linalg.norm(POINTS - POINTS[GENERIC.feature("chin_bottom")] + (0.0, 0.02, 0.02), axis=1) < 0.04
    nape = np.linalg.norm(POINTS - POINTS[GENERIC.feature("nape")], axis=1) < 0.03
    assert free[0, throat].max() > 0.05
    assert (found[0, throat].max() > 0.0) == covered
    assert np.array_equal(found[:, nape], free[:, nape])
    assert np.array_equal(found[1], free[1])
