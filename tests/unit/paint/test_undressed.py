"""A portrait's clothes: who wears a shirt at the collar is not naked where no photo looks."""

from __future__ import annotations

from types import SimpleNamespace

import numpy as np
import pytest

from cloner.frames import ViewId
from cloner.generic.charts import person_graph
from cloner.generic.load import load_generic
from cloner.generic.photo_shares import photo_shares
from cloner.paint.details.undressed import dress_unseen, plain_beyond
from cloner.paint.lookups.materials import find_materials, hands_beyond_cuffs
from cloner.records.labels import Label


@pytest.fixture(scope="module")
def person():
    generic = load_generic()
    vertices = generic.vertices_m.astype(float)
    return generic, vertices, person_graph(generic, vertices)


def portrait(generic, vertices, collar_m):
    """Return a photo of the front of head and chest in which cloth begins at a height."""
    count = len(vertices)
    neck = vertices[generic.region("neck"), 1].min()
    seen = (vertices[:, 1] > neck - 0.10) & (vertices[:, 2] > vertices[generic.region("neck"), 2].mean())
    dressed = vertices[:, 1] < collar_m
    picture = np.where(dressed, 0, 255).astype(np.uint8).reshape(1, count)
    labels = np.where(dressed, Label.UPPER_CLOTHES, Label.FACE_SKIN).astype(np.uint8).reshape(1, count)
    return SimpleNamespace(
        view=ViewId.FACE_FRONT,
        mirrored=False,
        score=seen.astype(float),
        sight=SimpleNamespace(cosine=np.where(seen, 1.0, -1.0)),
        plate=SimpleNamespace(skin=picture, labels=labels, bare=picture > 0),
        lookup_px=np.column_stack([np.arange(count), np.zeros(count)]).astype(float),
    )


def test_a_shirt_goes_on_around_the_body_and_ends_at_collar_and_hands(person):
    generic, vertices, graph = person
    collar = float(vertices[generic.region("neck"), 1].min()) + 0.01
    sources = [portrait(generic, vertices, collar)]
    kinds = dress_unseen(generic, sources, find_materials(generic, sources, graph), vertices)
    behind = vertices[:, 2] < vertices[generic.region("neck"), 2].mean() - 0.03
    body = ~np.isin(np.arange(len(vertices)), np.concatenate(hands_beyond_cuffs(generic)))
    assert kinds.worn[behind & body & (vertices[:, 1] < collar - 0.04)].min() > 0.95
    assert kinds.worn[vertices[:, 1] > collar + 0.04].max() < 0.05
    assert kinds.worn[~body].max() == 0.0


def test_who_shows_bare_shoulders_is_not_dressed(person):
    generic, vertices, graph = person
    sources = [portrait(generic, vertices, 0.0)]
    found = find_materials(generic, sources, graph)
    assert dress_unseen(generic, sources, found, vertices) is found


def test_cloth_far_from_the_photo_has_the_shirt_s_colour_not_the_collar_s(person):
    generic, vertices, graph = person
    collar = float(vertices[generic.region("neck"), 1].min()) + 0.01
    sources = [portrait(generic, vertices, collar)]
    kinds = dress_unseen(generic, sources, find_materials(generic, sources, graph), vertices)
    base = np.full((3, len(vertices), 3), 90.0, np.float32)
    base[2, vertices[:, 1] > collar - 0.02] = 250.0
    found = plain_beyond(sources, base, kinds, vertices[:, 1], graph)
    assert np.allclose(found[2, vertices[:, 1] < collar - 0.5], 90.0, atol=1.0)


def test_a_portrait_without_body_photos_paints_the_chest_as_it_shows_it(person):
    generic, vertices, _ = person
    alone = photo_shares(generic, ViewId.FACE_FRONT, photos=frozenset({ViewId.FACE_FRONT}))
    beside = photo_shares(generic, ViewId.FACE_FRONT, photos=frozenset({ViewId.FACE_FRONT, ViewId.BODY_FRONT}))
    neck = float(vertices[generic.region("neck"), 1].min())
    middle = np.abs(vertices[:, 0]) < 0.05
    chest = middle & (np.abs(vertices[:, 1] - (neck - 0.15)) < 0.02)
    assert (alone[chest] > 0.0).all()
    assert not beside[chest].any()
    assert not alone[vertices[:, 1] < neck - 0.3].any(), "hands and what they hold lie before the belly"
