"""Sights that are not believed: a temple shows no hair of another photo, a shoulder's stripe goes on."""

from __future__ import annotations

from dataclasses import dataclass, field, replace
from types import SimpleNamespace

import numpy as np
import pytest

from cloner.frames import ViewId
from cloner.generic.charts import person_graph
from cloner.generic.load import load_generic
from cloner.paint.lookups.materials import Materials, continues, with_surroundings
from cloner.paint.lookups.normalised import fill_surface
from cloner.paint.lookups.rejected import reject_grazing, reject_slanted, reject_wrong_parts
from cloner.records.labels import SKINS, SURFACES, Label

GENERIC = load_generic()
COUNT = len(GENERIC.vertices_m)
SKIN, HAIR, BLUE, ORANGE = (200.0, 160.0, 140.0), (60.0, 45.0, 40.0), (50.0, 90.0, 160.0), (250.0, 140.0, 50.0)


@dataclass(frozen=True)
class Photo:
    """One photo that sees every vertex at some angle; its pixels are the vertices, in a row."""

    view: ViewId
    cosine: np.ndarray
    score: np.ndarray
    mirrored: bool = False
    brows: np.ndarray = field(default_factory=lambda: np.zeros((1, COUNT), np.uint8))
    skin: np.ndarray | int = 255
    labels: np.ndarray | int = 0

    @property
    def visibility(self):
        return SimpleNamespace(cosine=self.cosine)

    @property
    def matted(self):
        return SimpleNamespace(
            brows=self.brows,
            skin=np.full((1, COUNT), self.skin, np.uint8),
            labels=np.full((1, COUNT), self.labels, np.uint8),
            bare=np.isin(np.full((1, COUNT), self.labels, np.uint8), SKINS),
        )

    @property
    def lookup_px(self):
        return np.column_stack([np.arange(COUNT), np.zeros(COUNT)]).astype(float)


def surfaces(name):
    """Return (V, 6) shares of surfaces where all is one."""
    return np.tile(np.eye(len(SURFACES))[SURFACES.index(name)], (COUNT, 1))


@pytest.fixture(scope="module")
def graph():
    return person_graph(GENERIC, GENERIC.vertices_m.astype(float))


def face_photos(**front):
    """Return front and side photo of a face, by the angles of the generic's own shape."""
    points = GENERIC.vertices_m - GENERIC.vertices_m[GENERIC.region("face")].mean(axis=0) + (0.0, 0.0, 0.06)
    turned = points / np.maximum(np.linalg.norm(points[:, [0, 2]], axis=1, keepdims=True), 1e-9)
    pairs = ((ViewId.FACE_FRONT, turned[:, 2], front), (ViewId.FACE_SIDE, -turned[:, 0], {}))
    return [Photo(view, cosine, np.clip(cosine, 0.0, 1.0), **more) for view, cosine, more in pairs]


def around(name, reach_m):
    """Return the face's vertices around a feature."""
    away = np.linalg.norm(GENERIC.vertices_m - GENERIC.vertices_m[GENERIC.feature(name)], axis=1)
    return GENERIC.region("face") & (away < reach_m)


def test_hair_beside_the_temple_gives_way_to_the_photo_that_shows_skin_there(graph):
    front, side = face_photos()
    hair = GENERIC.region("face") & (front.cosine > 0.1) & (front.cosine < 0.5) & (side.cosine > 0.5)
    colours = np.tile(SKIN, (2, COUNT, 1))
    colours[0, hair] = HAIR
    found = reject_slanted(GENERIC, [front, side], colours, graph)
    assert hair.sum() > 30
    assert not found[0].score[hair].any()
    assert np.array_equal(found[1].score, side.score)
    assert (found[0].score[around("nose_tip", 0.02)] > 0.0).sum() == (front.score[around("nose_tip", 0.02)] > 0.0).sum()


def test_a_brow_comes_from_the_photo_that_faces_it_even_where_the_side_photo_faces_it_better(graph):
    brow = around("eye_outer_R", 0.012) & ~GENERIC.region("eyelids")
    picture = np.where(brow, 255, 0).astype(np.uint8)[None]
    front, side = face_photos(brows=picture)
    assert (side.cosine[brow] > 0.4).any()
    colours = np.tile(SKIN, (2, COUNT, 1))
    colours[0, brow] = HAIR  # the side photo shows skin there: it has the brow a little higher
    found = reject_slanted(GENERIC, [front, side], colours, graph)
    square = brow & (front.cosine > 0.55)
    assert square.sum() > 5
    assert (found[0].score[square] > 0.0).all()
    assert not found[1].score[square].any()


def test_photos_that_agree_keep_all_their_claims(graph):
    photos = face_photos()
    found = reject_slanted(GENERIC, photos, np.tile(SKIN, (2, COUNT, 1)), graph)
    assert all(np.array_equal(new.score, old.score) for new, old in zip(found, photos, strict=True))


@pytest.mark.parametrize(("cosine", "shown", "kept"), [(0.4, 0, True), (0.4, 255, False), (0.25, 0, False)])
def test_a_stripe_on_cloth_goes_on_at_a_slant_and_skin_behind_it_does_not(graph, cosine, shown, kept):
    stripe = np.abs(GENERIC.vertices_m[:, 0] - 0.12) < 0.02
    angles = np.where(stripe, cosine, 0.9)
    photo = Photo(ViewId.BODY_FRONT, angles, angles, skin=np.where(stripe, shown, 0))
    colours = np.where(stripe[:, None], ORANGE, BLUE)[None]
    worn = Materials(np.zeros(COUNT), np.zeros(COUNT), np.ones(COUNT), surfaces("upper_clothes"))
    (found,) = reject_grazing(GENERIC, [photo], colours, with_surroundings([photo], colours, worn, graph))
    shoulders = GENERIC.vertices_m[:, 1] < GENERIC.vertices_m[GENERIC.feature("neck_base_L"), 1]
    below = stripe & shoulders  # ears are bare whatever they show
    assert bool((found.score[below] > 0.0).mean() > 0.99) == kept


def test_a_photo_that_shows_trousers_where_the_surface_is_sleeve_is_not_believed():
    """The fitted forearm misses the photo's and lies before the trousers; another photo shows the sleeve."""
    arm = GENERIC.vertex_segment == GENERIC.segment_names.index("left_forearm")
    angles = np.full(COUNT, 0.9)
    wrong = np.where(arm, Label.LOWER_CLOTHES, Label.UPPER_CLOTHES)
    photos = [
        Photo(ViewId.BODY_FRONT, angles, angles, labels=int(Label.UPPER_CLOTHES)),
        Photo(ViewId.BODY_SIDE, angles, angles, labels=wrong),
    ]
    kinds = Materials(np.zeros(COUNT), np.zeros(COUNT), np.ones(COUNT), surfaces("upper_clothes"))
    front, side = reject_wrong_parts(GENERIC, photos, kinds)
    assert np.array_equal(front.score, angles)
    assert not side.score[arm].any()
    assert np.array_equal(side.score[~arm], angles[~arm])


def bare():
    return Materials(np.ones(COUNT), np.zeros(COUNT), np.zeros(COUNT), surfaces("skin"))


def test_skin_has_no_stripes_a_collar_beside_the_jaw_is_not_its_colour(graph):
    """The labels end a pixel or two beside a white collar: at a slant that is a centimetre of jaw."""
    jaw = around("chin_bottom", 0.03) & (
        GENERIC.vertices_m[:, 1] < GENERIC.vertices_m[GENERIC.feature("chin_bottom"), 1]
    )
    angles = np.where(jaw, 0.4, 0.9)
    photo = Photo(ViewId.FACE_FRONT, angles, angles)
    colours = np.where(jaw[:, None], (225.0, 235.0, 250.0), SKIN)[None]
    kinds = with_surroundings([photo], colours, bare(), graph)
    (found,) = reject_grazing(GENERIC, [photo], colours, kinds)
    assert jaw.sum() > 10
    assert not found.score[jaw].any()
    assert np.array_equal(found.score[~jaw], angles[~jaw])
    # Texels between vertices are asked the same; a lamp's shade is still skin.
    assert not continues(colours[0, jaw], kinds.around[jaw]).any()
    assert continues(0.7 * np.tile(SKIN, (int(jaw.sum()), 1)), kinds.around[jaw]).all()


def test_skin_is_compared_with_skin_and_cloth_with_cloth(graph):
    """A neck above a white collar: the mean of both would let the collar climb it."""
    cloth = GENERIC.vertices_m[:, 1] < GENERIC.vertices_m[GENERIC.feature("neck_base_L"), 1]
    angles = np.full(COUNT, 0.9)
    photo = Photo(ViewId.FACE_FRONT, angles, angles)
    colours = np.where(cloth[:, None], (225.0, 235.0, 250.0), SKIN)[None]
    kinds = Materials(1.0 * ~cloth, np.zeros(COUNT), 1.0 * cloth, surfaces("skin"))
    around = with_surroundings([photo], colours, kinds, graph).around
    person = np.abs(np.diff(around, axis=0)).max() > 0.0
    assert person
    assert np.allclose(np.exp(around[~cloth & GENERIC.region("neck")]).std(axis=0), 0.0, atol=1e-3)


def test_what_is_labelled_skin_and_white_as_the_collar_is_not_the_skin_around(graph):
    """A squarely seen rim of a collar under skin's label: the neck's skin went white there and up to the jaw."""
    rim = GENERIC.region("neck") & (GENERIC.vertices_m[:, 1] < GENERIC.vertices_m[GENERIC.region("neck"), 1].mean())
    angles = np.full(COUNT, 0.9)
    photo = Photo(ViewId.FACE_FRONT, angles, angles, labels=Label.FACE_SKIN)
    colours = np.where(rim[:, None], (225.0, 235.0, 250.0), SKIN)[None]
    kinds = with_surroundings([photo], colours, bare(), graph)
    assert not continues(colours[0, rim], kinds.around[rim]).any()
    photo = replace(photo, score=np.where(GENERIC.segment("torso"), 0.0, angles))
    skin = fill_surface(GENERIC, [photo], colours, bare(), graph)[0]
    assert np.abs(skin[GENERIC.segment("torso")] - SKIN).max() < 3.0, "nothing white runs down the chest"


def test_a_garment_that_a_photo_shows_at_the_face_is_not_the_face():
    chin = around("chin_bottom", 0.03)
    angles = np.full(COUNT, 0.9)
    labels = np.where(chin, Label.UPPER_CLOTHES, Label.FACE_SKIN)
    (found,) = reject_wrong_parts(GENERIC, [Photo(ViewId.FACE_FRONT, angles, angles, labels=labels)], bare())
    assert not found.score[chin].any()
    (lost,) = reject_wrong_parts(
        GENERIC, [Photo(ViewId.FACE_FRONT, angles, angles, labels=int(Label.UPPER_CLOTHES))], bare()
    )
    assert np.array_equal(lost.score[GENERIC.region("face")], angles[GENERIC.region("face")])  # no face was told at all
    worn = np.where(chin, Label.ACCESSORY, Label.FACE_SKIN)  # glasses stay: nothing else would be left of them
    (kept,) = reject_wrong_parts(GENERIC, [Photo(ViewId.FACE_FRONT, angles, angles, labels=worn)], bare())
    assert np.array_equal(kept.score, angles)
