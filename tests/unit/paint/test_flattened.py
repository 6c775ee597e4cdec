"""Hard light on skin: both halves of a face, and glare."""

from types import SimpleNamespace

import numpy as np

from cloner.frames import ViewId
from cloner.generic.charts import person_graph
from cloner.generic.load import load_generic
from cloner.geometry.meshes.graphs import surface_graph
from cloner.paint.lookups.flattened import flatten_halves, flatten_slants, soften_glare

SKIN = np.array([190.0, 140.0, 110.0])
ROWS = 61


def _ribbon():
    """Return the graph of a ribbon across a face, each vertex's place -1..1 and its twin's number."""
    across = np.linspace(-1.0, 1.0, ROWS)
    vertices = np.stack([np.repeat(0.08 * across, 3), np.tile([0.0, 0.003, 0.006], ROWS), np.zeros(3 * ROWS)], axis=1)
    corner = (3 * np.arange(ROWS - 1)[:, None] + np.arange(2)).ravel()
    upper, lower = np.stack([corner, corner + 1, corner + 3], 1), np.stack([corner + 1, corner + 4, corner + 3], 1)
    graph = surface_graph(vertices, np.concatenate([upper, lower]).astype(np.int32))
    twin = np.arange(3 * ROWS).reshape(ROWS, 3)[::-1].ravel()
    return graph, np.repeat(across, 3), twin


def _photo(view):
    return SimpleNamespace(view=view, score=np.ones(3 * ROWS), visibility=SimpleNamespace(cosine=np.ones(3 * ROWS)))


def _after(rgb, view):
    graph, _, twin = _ribbon()
    gains = flatten_halves([_photo(view)], rgb[None], np.ones(len(rgb), bool), twin, graph)
    return np.log(rgb + 8.0) + gains[0]


def test_a_lamp_beside_the_face_leaves_two_like_halves_and_every_mole():
    _, across, twin = _ribbon()
    rgb = np.where(across[:, None] > 0.0, 1.25, 0.6) * SKIN  # a hard terminator down the nose
    mole = 3 * 45 + 1
    rgb[mole] *= 0.5
    logs = _after(rgb, ViewId.FACE_FRONT)
    aside = (np.abs(across) > 0.15) & (np.abs(across - across[mole]) > 0.12) & (np.abs(across + across[mole]) > 0.12)
    gap = np.abs(logs - logs[twin])[aside]
    assert 0.05 < gap.max() < 0.25  # .7 before
    assert (logs[mole + 3] - logs[mole]).mean() > 0.35  # .65 before, and none of it on the other cheek
    assert np.abs(logs[twin[mole]] - logs[twin[mole] + 3]).max() < 0.2


def test_soft_light_keeps_its_side():
    _, across, twin = _ribbon()
    logs = _after(np.exp(0.05 * across[:, None]) * SKIN, ViewId.FACE_FRONT)
    left = (logs - logs[twin])[across > 0.6] / (2 * 0.05 * across[across > 0.6, None])
    assert 0.5 < left.min() < left.max() < 0.75


def test_a_side_photo_shows_one_half_and_is_left_alone():
    _, across, _ = _ribbon()
    rgb = np.where(across[:, None] > 0.0, 1.25, 0.6) * SKIN
    assert np.allclose(_after(rgb, ViewId.FACE_SIDE), np.log(rgb + 8.0))


def test_glare_comes_down_and_shade_stays():
    graph, across, _ = _ribbon()
    plain = np.log(SKIN + 8.0)
    logs = plain + np.where(across[:, None] > 0.5, 0.6, np.where(across[:, None] < -0.5, -0.6, 0.0))
    skin = np.ones(len(logs), bool)
    found = logs + soften_glare([_photo(ViewId.FACE_SIDE)], logs[None], skin, plain, graph)[0]
    assert 0.15 < (found - plain)[across > 0.7].mean() < 0.25
    assert np.abs(found - logs)[across < 0.3].max() < 0.03


def test_a_dark_strip_between_two_photos_is_lit_as_the_skin_around_it_and_a_nostril_stays() -> None:
    generic = load_generic()
    graph = person_graph(generic, generic.vertices_m.astype(float))
    face = generic.region("face")
    turned = generic.vertices_m[:, 0] - generic.vertices_m[face, 0].mean()
    strip = face & (np.abs(turned) > 0.035) & (np.abs(turned) < 0.05)
    nostril = np.linalg.norm(generic.vertices_m - generic.vertices_m[generic.feature("subnasale")], axis=1) < 0.006
    logs = np.full((1, len(face), 3), 5.0)
    logs[:, strip] -= 0.1
    logs[:, nostril] -= 1.0
    photo = SimpleNamespace(
        score=np.ones(len(face)), visibility=SimpleNamespace(cosine=np.where(strip | nostril, 0.5, 1.0))
    )
    gain = flatten_slants(generic, [photo], logs, np.ones(len(face), bool), graph)
    assert 0.04 < np.median(gain[strip]) < 0.1  # about half of it: the rest may be the person
    assert gain[nostril].mean() < 0.05  # of 1: only its rim
    assert np.abs(gain[face & ~strip & ~nostril]).max() < 0.04
