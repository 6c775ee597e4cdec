"""A scarf that photos of all sides show is found again as a ring round the neck; glasses and collars are none."""

from dataclasses import replace

import numpy as np
import pytest
import trimesh
from scipy.spatial import cKDTree

from cloner.generic.load import load_generic
from cloner.hair.clothing.scarves import scarf_evidence, scarf_shell
from cloner.hair.volumes.views import hair_views
from cloner.records.labels import Label
from cloner.records.proposals import Proposals
from cloner.records.silhouettes import SilhouetteSet
from kit import painted, people, studio

SCARF, FACE, CLOTH, WALL = (200, 60, 60), (210, 170, 150), (60, 80, 140), (90, 140, 90)
LABELS = {SCARF: Label.ACCESSORY, FACE: Label.FACE_SKIN, CLOTH: Label.UPPER_CLOTHES}
THICK_M = 0.03


def ring(person):
    """Return vertices and triangles of a ring around a person's neck, thirty millimetres thick."""
    generic = load_generic()
    neck = person.vertices_m[generic.region("neck") & generic.skin]
    middle = 0.5 * (neck.min(axis=0) + neck.max(axis=0))
    wide = 0.5 * np.ptp(neck[:, [0, 2]], axis=0).max() + 0.5 * THICK_M
    torus = trimesh.creation.torus(wide, THICK_M, 48, 24)
    torus.apply_transform(trimesh.transformations.rotation_matrix(np.pi / 2, [1, 0, 0]))
    torus.apply_translation(middle)
    return np.asarray(torus.vertices), np.asarray(torus.faces, np.int32)


def photographed(worn=True, views=("body_front", "body_side", "body_back")):
    """Photograph a person in a scarf; return what the stage has, and the true ring."""
    person = people.known_person(41, spread=0.5)
    lens = {"distance_m": 2.5, "height_m": 1.4, "aim_m": 1.4, "size_px": (900, 900), "focal_35mm": 75}
    turns = {"body_front": 0.0, "body_side": -90.0, "body_back": 180.0}
    cameras = {view: studio.camera(turns[view], **lens) for view in views}
    fit = painted.joined(person, dict.fromkeys(cameras, np.zeros((94, 3))), cameras)
    points, faces = ring(person)
    skin, generic = people.skin_triangles(), load_generic()
    vertices = np.concatenate([person.vertices_m, points]) if worn else person.vertices_m
    triangles = np.concatenate([skin, faces + len(person.vertices_m)]) if worn else skin
    face = generic.region("face") | generic.region("scalp")
    colours = np.where(face[skin].all(axis=1)[:, None], FACE, CLOTH)
    colours = np.concatenate([colours, np.tile(SCARF, (len(faces), 1))]) if worn else colours
    pictures, proposals, outlines = {}, {}, {}
    for view, posed in fit.views.items():
        picture = painted.draw(vertices, triangles, np.asarray(colours), posed.camera, background=WALL)
        mask = (picture != WALL).any(axis=2)
        labels = np.zeros(mask.shape, np.uint8)
        for colour, label in LABELS.items():
            labels[(picture == colour).all(axis=2)] = label
        pictures[view], outlines[view] = picture, studio.silhouette_record(view, mask)
        proposals[view] = replace(studio.empty_proposal(view, mask), labels=labels)
    proposals = Proposals(proposals)
    seen = hair_views(generic, fit, proposals, SilhouetteSet(outlines))
    return (generic, fit, studio.photo_set(pictures), proposals, seen), points


@pytest.fixture(scope="module")
def worn():
    given, true = photographed()
    return scarf_shell(*given), given, true


def test_a_scarf_is_where_it_was_worn(worn):
    shell, _, true = worn
    assert shell.kind == "scarf"
    dense = trimesh.sample.sample_surface(trimesh.Trimesh(shell.vertices_m, shell.triangles), 20000, seed=1)[0]
    outer = true[np.hypot(*(true - true.mean(axis=0))[:, [0, 2]].T) > 0.5 * np.ptp(true[:, 0]) - 0.006]
    away_mm = 1000.0 * cKDTree(dense).query(outer)[0]
    assert np.median(away_mm) < 6.0
    assert np.percentile(away_mm, 90) < 15.0


def test_it_has_its_own_colour_and_moves_with_the_skin_below(worn):
    shell, given, _ = worn
    shown = shell.rgba[shell.rgba[..., 3] > 200][:, :3]
    np.testing.assert_allclose(np.median(shown, axis=0), SCARF, atol=12)
    generic, fit = given[:2]
    skin = np.flatnonzero(generic.skin)
    nearest = skin[cKDTree(fit.vertices_m[skin]).query(shell.vertices_m)[1]]
    assert (generic.skin_joints[nearest] == shell.skin_joints).mean() > 0.95
    np.testing.assert_allclose(shell.skin_weights.sum(axis=1), 1.0, atol=1e-6)
    assert shell.triangles.max() < len(shell.vertices_m)


def test_nobody_wears_one_that_no_photo_or_one_side_alone_shows():
    given, _ = photographed(worn=False)
    assert scarf_shell(*given) is None
    given, _ = photographed(views=("body_front",))
    assert scarf_shell(*given) is None


def test_glasses_are_no_scarf(worn):
    _, (generic, fit, _, proposals, views), _ = worn
    labels = np.full_like(proposals.views["body_front"].labels, Label.FACE_SKIN)
    chin = fit.vertices_m[generic.feature("chin_bottom")]
    eyes = fit.vertices_m[generic.feature("glabella")]
    front = views[0]
    column, row = front.posed.camera.project(front.to_view(eyes[None]))[0].astype(int)
    labels[row - 12 : row + 12, column - 40 : column + 40] = Label.ACCESSORY
    assert scarf_evidence(front, labels, chin) is None
    labels[row + 60 : row + 64, column - 3 : column + 3] = Label.ACCESSORY  # a chain
    assert scarf_evidence(front, labels, chin) is None
