"""A portrait's clothes: who wears a shirt at the collar is not naked where no photo looks."""

from __future__ import annotations

from types import SimpleNamespace

import numpy as np
import pytest

from cloner.frames import ViewId
from cloner.generic.charts import person_graph
from cloner.generic.load import load_generic
from cloner.generic.photo_shares import photo_shares
from cloner.geometry.meshes.triangles import edges_of
from cloner.paint.details.unseen_clothes import SHIRT, dress_unseen, extend_clothes
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
        visibility=SimpleNamespace(cosine=np.where(seen, 1.0, -1.0)),
        matted=SimpleNamespace(skin=picture, labels=labels, bare=picture > 0),
        lookup_px=np.column_stack([np.arange(count), np.zeros(count)]).astype(float),
    )


def test_a_shirt_goes_on_around_the_body_and_ends_at_collar_and_hands(person):
    generic, vertices, graph = person
    collar = float(vertices[generic.region("neck"), 1].min()) + 0.01
    sources = [portrait(generic, vertices, collar)]
    kinds = dress_unseen(generic, sources, find_materials(generic, sources, graph), vertices, graph)
    behind = vertices[:, 2] < vertices[generic.region("neck"), 2].mean() - 0.03
    body = ~np.isin(np.arange(len(vertices)), np.concatenate(hands_beyond_cuffs(generic)))
    assert kinds.worn[behind & body & (vertices[:, 1] < collar - 0.04)].min() > 0.95
    assert kinds.worn[vertices[:, 1] > collar + 0.04].max() < 0.05
    assert kinds.worn[~body].max() == 0.0


def test_a_throat_in_the_chin_s_shade_is_no_collar(person):
    generic, vertices, graph = person
    neck = generic.region("neck")
    base = float(vertices[neck, 1].min())
    source = portrait(generic, vertices, base + 1.5 * np.abs(vertices[:, 0]))  # its wings stand beside the throat
    front = vertices[:, 2] > vertices[neck, 2].mean()
    throat = neck & front & (np.abs(vertices[:, 0]) < 0.03)
    shade = throat & (vertices[:, 1] > base + 0.03)
    source.score[shade] = 0.0
    kinds = dress_unseen(generic, [source], find_materials(generic, [source], graph), vertices, graph)
    assert shade.sum() > 10
    assert kinds.worn[shade].max() < 0.15


def test_a_neckline_that_no_photo_shows_is_no_zigzag_and_leaves_no_shoulder_bare(person):
    generic, vertices, graph = person
    source = portrait(generic, vertices, 0.0)
    source.score[vertices[:, 1] < vertices[generic.region("neck"), 1].max()] = 0.0  # the photo ends at the chin
    kinds = dress_unseen(generic, [source], find_materials(generic, [source], graph), vertices, graph)
    shoulders = generic.segment("torso") & (np.abs(vertices[:, 0]) > 0.10)
    assert kinds.worn[shoulders].min() == 1.0
    edges = edges_of(generic.triangles()[0])[0]
    edges = edges[(kinds.worn[edges] > 0.5).sum(axis=1) == 1]
    trunk = edges[generic.segment("torso")[edges].all(axis=1)]
    assert len(trunk) > 20
    assert np.median(np.ptp(kinds.worn[trunk], axis=1)) < 0.6, "the edge lies between vertices, not along them"


def test_only_what_is_seen_to_go_on_of_a_shirt_s_front_goes_on(person):
    generic, vertices, _ = person
    collar = float(vertices[generic.region("neck"), 1].min()) + 0.01
    seen_low = vertices[:, 1:2] < collar - 0.09
    badge = seen_low & (np.abs(vertices[:, :1]) < 0.05) & (vertices[:, 2:] > 0.0)
    found, seen = clothed(person, collar, np.where(badge, 240.0, 30.0) * np.ones(3))
    waist = vertices[generic.segment("pelvis"), 1].max()
    below = (vertices[:, 1] > waist) & (vertices[:, 1] < vertices[seen, 1].min() - 0.12)
    assert found[2, below & generic.segment("torso")].max() < 60.0


def test_a_neckline_that_is_low_in_front_is_not_behind(person):
    generic, vertices, graph = person
    base = float(vertices[generic.region("neck"), 1].min())
    source = portrait(generic, vertices, base - 0.03)
    source.score[np.abs(vertices[:, 0]) > 0.08] = 0.0  # hair hides the shoulders
    kinds = dress_unseen(generic, [source], find_materials(generic, [source], graph), vertices, graph)
    back = generic.segment("torso") & (vertices[:, 2] < -0.06) & (vertices[:, 1] < base - 0.02)
    assert back.sum() > 20
    assert kinds.worn[back].min() > 0.95
    assert kinds.worn[source.score > 0.0][vertices[source.score > 0.0, 1] > base - 0.01].max() < 0.05


def test_nobody_is_naked_below_what_a_photo_shows_bare(person):
    generic, vertices, graph = person
    sources = [portrait(generic, vertices, 0.0)]
    kinds = dress_unseen(generic, sources, find_materials(generic, sources, graph), vertices, graph)
    seen = sources[0].score > 0.0
    trunk = generic.segment("torso") | generic.segment("pelvis")
    assert kinds.worn[seen].max() == 0.0, "what the photo shows stays bare"
    assert kinds.worn[trunk & (vertices[:, 1] < vertices[seen & trunk, 1].min() - 0.04)].min() == 1.0
    assert kinds.worn[generic.segment("left_upper_arm")].max() == 0.0, "a shirt below bare shoulders has no sleeves"


@pytest.mark.parametrize(("top_m", "sleeve"), [(-0.06, 0.0), (0.01, 1.0)])
def test_bare_shoulders_above_a_top_have_no_sleeves(person, top_m, sleeve):
    generic, vertices, graph = person
    source = portrait(generic, vertices, float(vertices[generic.region("neck"), 1].min()) + top_m)
    kinds = dress_unseen(generic, [source], find_materials(generic, [source], graph), vertices, graph)
    arm = generic.segment("left_upper_arm")
    unseen = arm & (vertices[:, 1] < vertices[arm, 1].max() - 0.20)
    assert unseen.sum() > 20
    assert kinds.worn[unseen].min() == kinds.worn[unseen].max() == sleeve


def clothed(person, collar, cloth_rgb, labels=None, rgb=(40, 90, 160)):
    """Return fills and seen vertices of a portrait in which cloth has one colour and skin another."""
    generic, vertices, graph = person
    source = portrait(generic, vertices, collar)
    kinds = dress_unseen(generic, [source], find_materials(generic, [source], graph), vertices, graph)
    base = np.full((3, len(vertices), 3), (180.0, 130.0, 110.0), np.float32)
    base[2] = cloth_rgb
    source.matted.rgb = np.tile(np.array(rgb, np.uint8), (1, 3000, 1))
    source.matted.labels = np.full((1, 3000), Label.FACE_SKIN if labels is None else labels, np.uint8)
    return extend_clothes(generic, [source], base, kinds, vertices, graph), source.score > 0.0


def test_cloth_far_from_the_photo_has_the_shirt_s_colour_not_the_collar_s(person):
    generic, vertices, _ = person
    collar = float(vertices[generic.region("neck"), 1].min()) + 0.01
    cloth = np.where(vertices[:, 1:2] > collar - 0.02, 250.0, 90.0) * np.ones(3)
    found, _ = clothed(person, collar, cloth)
    behind = generic.segment("torso") & (vertices[:, 2] < -0.08) & (vertices[:, 1] < collar - 0.3)
    behind &= vertices[:, 1] > vertices[generic.segment("pelvis"), 1].max()
    assert behind.any()
    assert np.allclose(found[2, behind], 90.0, atol=1.0)


def test_a_shirt_s_front_goes_on_down_to_the_waist_above_dark_trousers_and_shoes(person):
    generic, vertices, _ = person
    collar = float(vertices[generic.region("neck"), 1].min()) + 0.01
    middle = (np.abs(vertices[:, :1]) < 0.05) & (vertices[:, 2:] > 0.0)
    found, seen = clothed(person, collar, np.where(middle, 240.0, 30.0) * np.ones(3))
    waist = vertices[generic.segment("pelvis"), 1].max()
    below = (vertices[:, 1] > waist) & (vertices[:, 1] < vertices[seen, 1].min() - 0.12)
    belly = below & (np.abs(vertices[:, 0]) < 0.03) & (vertices[:, 2] > 0.05)
    flank = below & generic.segment("torso") & (vertices[:, 0] > 0.10)
    assert found[2, belly].min() > 150.0
    assert found[2, flank].max() < 60.0
    assert found[2, generic.segment("left_calf")].max() <= 30.0 + 1.0, "trousers are never lighter than what is above"
    assert (found[2, generic.segment("left_foot")] <= 34.0).all()


def test_cloth_that_lies_on_no_surface_still_tells_the_shirt_s_colour(person):
    generic, vertices, _ = person
    waist = vertices[generic.segment("pelvis"), 1].max()
    chest = generic.segment("torso") & (vertices[:, 2] < -0.05) & (vertices[:, 1] > waist)
    found, _ = clothed(person, 0.0, 99.0, labels=Label.UPPER_CLOTHES)
    assert np.allclose(found[2, chest], (40, 90, 160), atol=1.0)
    found, _ = clothed(person, 0.0, 99.0)
    assert np.allclose(found[2, chest], SHIRT)
    found, _ = clothed(person, 0.0, 99.0, labels=Label.UPPER_CLOTHES, rgb=(186, 133, 112))
    assert np.allclose(found[2, chest], SHIRT), "cloth of the skin's colour would look like none"


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
