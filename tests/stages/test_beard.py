"""A beard of known thickness is found again and rides on the jaw; stubble stays paint."""

from dataclasses import replace

import numpy as np
import pytest
import trimesh
from scipy.spatial import cKDTree

from cloner.generic.load import load_generic
from cloner.geometry.meshes.wedges import vertex_normals
from cloner.hair.shells.beard import beard_rows, is_contradicted
from cloner.records.labels import Label
from cloner.records.proposals import Proposals
from cloner.records.silhouettes import SilhouetteSet
from cloner.stages import hair
from kit import painted, people, studio

BEARD_MM = 14.0
BEARD, FACE, NECK, WALL = (60, 40, 30), (210, 170, 150), (200, 160, 140), (90, 140, 90)
LABELS = {BEARD: Label.BEARD, FACE: Label.FACE_SKIN, NECK: Label.BODY_SKIN}


def true_beard(person, fit, thick_mm):
    """Return the vertices of the whole skin with the lower part of the face lifted, and which triangles are bearded."""
    generic, triangles = load_generic(), people.skin_triangles()
    rows, zone = beard_rows(generic, fit)
    mouth, chin = (person.vertices_m[generic.feature(name)] for name in ("lip_bottom", "chin_bottom"))
    grows = np.zeros(len(person.vertices_m), bool)
    height = person.vertices_m[rows[zone], 1]
    grows[rows[zone]] = (height < mouth[1]) & (height > chin[1] - 0.006)
    normals = vertex_normals(person.vertices_m, triangles)
    lifted = person.vertices_m + normals * (grows * thick_mm / 1000)[:, None]
    return lifted, grows


def grow(thick_mm):
    """Photograph a person with a beard and run the stage; return the shells, the true surface and where it grows."""
    person = people.known_person(41, spread=0.5)
    lens = {"distance_m": 1.3, "height_m": 1.55, "aim_m": 1.5, "size_px": (1200, 1600), "focal_35mm": 75}
    close = {"face_front": studio.camera(0.0, **lens), "face_side": studio.camera(-90.0, **lens)}
    fit = painted.joined(person, dict.fromkeys(("body_front", *close), np.zeros((94, 3))), close)
    lifted, grows = true_beard(person, fit, thick_mm)
    triangles = people.skin_triangles()
    generic = load_generic()
    head = generic.region("face") | generic.region("scalp") | generic.region("ear_left") | generic.region("ear_right")
    kinds = np.where(grows[triangles].all(axis=1), 0, np.where(head[triangles].all(axis=1), 1, 2))
    colours = np.array([BEARD, FACE, NECK])[kinds]
    pictures, proposals, outlines = {}, {}, {}
    for view, posed in fit.views.items():
        picture = painted.draw(lifted, triangles, colours, posed.camera, background=WALL)
        mask = (picture != WALL).any(axis=2)
        labels = np.zeros(mask.shape, np.uint8)
        for colour, label in LABELS.items():
            labels[(picture == colour).all(axis=2)] = label
        pictures[view] = picture
        proposals[view] = replace(studio.empty_proposal(view, mask), labels=labels)
        outlines[view] = studio.silhouette_record(view, mask)
    result = hair.run(
        photos=studio.photo_set(pictures), proposals=Proposals(proposals), silhouettes=SilhouetteSet(outlines),
        joined=fit, tick=lambda part: None,
    )  # fmt: skip
    return [shell for shell in result.values["shells"] if shell.kind == "beard"], person, lifted, grows


@pytest.fixture(scope="module")
def full_beard():
    return grow(BEARD_MM)


def test_a_beard_is_as_thick_as_its_outlines(full_beard):
    shells, _, lifted, grows = full_beard
    assert len(shells) == 1
    shell, triangles = shells[0], people.skin_triangles()
    dense = trimesh.sample.sample_surface(trimesh.Trimesh(shell.vertices_m, shell.triangles), 40000, seed=1)[0]
    inner = grows.copy()  # the true beard ends in a step, ours in a round edge
    for _ in range(2):
        bare = (~inner)[triangles].any(axis=1)
        inner[triangles[bare]] = False
    assert inner.sum() > 50
    assert 1000 * np.median(cKDTree(dense).query(lifted[inner])[0]) < 2.5
    chin = lifted[load_generic().feature("chin_front")]
    assert 1000 * cKDTree(dense).query(chin[None])[0][0] < 3.0


def test_it_is_carried_by_the_skin_below(full_beard):
    shells, _, _, grows = full_beard
    shell, generic = shells[0], load_generic()
    assert grows[shell.rides].mean() > 0.8
    assert np.array_equal(shell.skin_joints, generic.skin_joints[shell.rides])
    assert np.allclose(shell.skin_weights, generic.skin_weights[shell.rides])


def test_stubble_is_paint():
    assert grow(0.0)[0] == []


def test_lips_stay_free(full_beard):
    shells, _, _, _ = full_beard
    assert not load_generic().region("lips")[shells[0].rides].any()


@pytest.mark.parametrize(
    ("front", "side", "expected"), [(0.3, 0.3, False), (0.07, 0.016, False), (0.107, 0.01, True), (0.0, 0.4, True)]
)
def test_a_beard_that_one_face_photo_alone_shows_is_a_shadow(front, side, expected):
    def proposal(view, share):
        labels = np.full((100, 100), Label.FACE_SKIN, np.uint8)
        labels.ravel()[: round(10_000 * share)] = Label.BEARD
        return replace(studio.empty_proposal(view, labels > 0), labels=labels)

    shown = {view: proposal(view, share) for view, share in (("face_front", front), ("face_side", side))}
    assert is_contradicted(Proposals(shown)) == expected
    assert not is_contradicted(Proposals({"face_front": shown["face_front"]}))
