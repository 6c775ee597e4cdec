"""A photo laid on a mesh by markers: camera, bent mesh, texture, against a drawn person that is known."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest

from cloner.errors import ClonerError
from cloner.generic.charts import generic_atlas
from cloner.generic.layers import clone_layers
from cloner.generic.load import load_generic
from cloner.geometry.cameras.viewpoints import framing_camera
from cloner.render import draw
from cloner.statues import photo_fit
from cloner.statues.markers import MARKED, known_points
from cloner.statues.photo_fit import fit_markers, fit_photo, focal_px_of, mark
from cloner.statues.photographed import clone_with_photo, mesh_of
from kit.clones import toy_clone

WIDE, HIGH = 600, 800
MAGENTA = (255, 0, 255)


@pytest.fixture(scope="module")
def vertex() -> np.ndarray:
    return np.array([known_points()[name] for name in MARKED])


@pytest.fixture(scope="module")
def sitter():
    """Somebody whose face differs from the usual one by a known shape, and their portrait before magenta."""
    generic, clone = load_generic(), toy_clone(hair=False)
    moved = clone.vertices_m.copy()
    weights = np.random.default_rng(5).normal(0.0, 1.5, 12)
    moved[generic.head_vertices] += np.tensordot(weights, generic.face_basis[:12], axes=1)
    person = replace(clone, vertices_m=moved)
    head = moved[generic.vertex_segment == generic.segment_names.index("head")]
    camera = framing_camera(head, 20.0, WIDE, HIGH)
    return person, camera, draw(clone_layers(person), camera, background=MAGENTA)


@pytest.fixture(scope="module")
def fitted(sitter, vertex):
    person, camera, photo = sitter
    markers = camera.project(person.vertices_m[vertex])
    return fit_photo(mesh_of(toy_clone(hair=False)), vertex, markers, photo, focal_px=camera.focal_px, size=512)


def test_markers_are_met_exactly_and_the_camera_is_found(sitter, fitted, vertex) -> None:
    person, camera, _ = sitter
    seen = fitted.fit.camera.project(fitted.fit.vertices_m[vertex])
    assert np.abs(seen - camera.project(person.vertices_m[vertex])).max() < 1e-9
    axis = fitted.fit.camera.camera_from_model[2, :3] @ camera.camera_from_model[2, :3]
    assert np.degrees(np.arccos(axis)) < 3.0
    away = np.linalg.norm(fitted.fit.camera.position_m - camera.position_m)
    assert away < 0.05 * np.linalg.norm(camera.position_m - person.vertices_m[vertex].mean(axis=0))
    assert fitted.fit.turned < 20  # where lips touch


def test_what_lies_between_markers_comes_nearer_too(sitter, fitted, vertex) -> None:
    generic, (person, camera, _) = load_generic(), sitter
    face = np.setdiff1d(np.flatnonzero(generic.region("face")), vertex)
    true = camera.project(person.vertices_m[face])
    unbent = fitted.fit.camera.project(toy_clone(hair=False).vertices_m[face])
    bent = fitted.fit.camera.project(fitted.fit.vertices_m[face])
    before, after = (float(np.linalg.norm(each - true, axis=1).mean()) for each in (unbent, bent))
    assert after < 0.4 * before
    feet = generic.region("sole")
    assert np.array_equal(fitted.fit.vertices_m[feet], toy_clone(hair=False).vertices_m[feet])


def test_a_mesh_that_is_the_thing_itself_is_not_bent(sitter, vertex) -> None:
    person, camera, _ = sitter
    fit = fit_markers(
        mark(mesh_of(person), vertex), camera.project(person.vertices_m[vertex]), (WIDE, HIGH), camera.focal_px
    )
    assert fit.missed_px.max() < 1e-3
    assert np.abs(fit.vertices_m - person.vertices_m).max() < 1e-6


def test_a_drag_of_forty_markers_goes_on_from_the_camera_before(sitter, vertex, monkeypatch) -> None:
    person, camera, _ = sitter
    assert len(vertex) == 40
    marked, markers = mark(mesh_of(toy_clone(hair=False)), vertex), camera.project(person.vertices_m[vertex])
    fit = fit_markers(marked, markers, (WIDE, HIGH), camera.focal_px)
    monkeypatch.setattr(photo_fit, "_found", lambda *_: pytest.fail("the camera is looked for from all sides again"))
    for step in range(9):
        markers[2] += 1.0
        fit = fit_markers(marked, markers, (WIDE, HIGH), camera.focal_px, fit)
        assert fit.uv_photo.shape == (len(person.vertices_m), 2)
        assert np.abs(fit.camera.project(fit.vertices_m[vertex]) - markers).max() < 1e-9, step


def test_one_dragged_marker_moves_its_neighbourhood_and_hardly_the_camera(sitter, vertex) -> None:
    person, camera, _ = sitter
    marked, markers = mark(mesh_of(person), vertex), camera.project(person.vertices_m[vertex])
    before = fit_markers(marked, markers, (WIDE, HIGH), camera.focal_px)
    markers[MARKED.index("nose_tip")] += (25.0, 0.0)
    after = fit_markers(marked, markers, (WIDE, HIGH), camera.focal_px, before)
    places = person.vertices_m[vertex]
    ears = [MARKED.index(name) for name in ("ear_top_L", "ear_top_R")]
    assert np.abs((after.camera.project(places) - before.camera.project(places))[ears]).max() < 6.0
    nose = known_points()["nose_tip"]
    moved = np.linalg.norm(after.vertices_m - before.vertices_m, axis=1)
    assert moved[nose] > 0.6 * 25.0 * camera.metres_per_pixel(person.vertices_m[nose])
    assert moved[known_points()["ear_top_L"]] < 0.35 * moved[nose]


def test_the_texture_is_the_photo_where_it_is_seen_and_goes_on_behind(sitter, fitted) -> None:
    person, _, _ = sitter
    generic, laid = load_generic(), fitted.laid
    atlas = generic_atlas(generic, 512)
    body = generic.vertex_part[atlas.triangles[:, 0]] == 0
    near = np.linalg.norm(generic.vertices_m - generic.vertices_m[generic.feature("nose_tip")], axis=1) < 0.11
    rows = atlas.rows_of(body & near[atlas.triangles].all(axis=1))
    seen = laid.seen.reshape(-1)[atlas.texel[rows]] > 250
    assert seen.mean() > 0.5
    truth = np.asarray(person.atlas.rgb)[::2, ::2].reshape(-1, 3)[atlas.texel[rows[seen]]].astype(float)
    got = laid.rgb.reshape(-1, 3)[atlas.texel[rows[seen]]].astype(float)
    assert np.median(np.abs(got - truth)) < 6.0  # levels; the portrait is drawn unlit
    behind = laid.rgb.reshape(-1, 3)[atlas.texel].astype(float)
    pink = (behind[:, 0] > 200) & (behind[:, 2] > 200) & (behind[:, 1] < 90)
    assert not pink.any()  # nothing of the background
    assert (laid.rgb.reshape(-1, 3)[atlas.texel].max(axis=1) > 0).all()


def test_hair_goes_on_as_hair_and_skin_as_skin(vertex) -> None:
    generic, clone = load_generic(), toy_clone(hair=False)
    size = len(clone.atlas.rgb)
    atlas = generic_atlas(generic, size)
    scalp = generic.region("scalp")[atlas.triangles].all(axis=1)
    rgb = clone.atlas.rgb.copy()
    rgb.reshape(-1, 3)[atlas.texel[atlas.rows_of(scalp)]] = (40, 30, 25)
    person = replace(clone, atlas=replace(clone.atlas, rgb=rgb))
    head = person.vertices_m[generic.vertex_segment == generic.segment_names.index("head")]
    camera = framing_camera(head, 0.0, WIDE, HIGH)
    photo = draw(clone_layers(person), camera, background=MAGENTA)
    markers = camera.project(person.vertices_m[vertex])
    laid = fit_photo(mesh_of(clone), vertex, markers, photo, focal_px=camera.focal_px, size=size).laid
    behind = scalp & (generic.vertices_m[atlas.triangles][..., 2] < -0.05).all(axis=1)
    texels = atlas.texel[atlas.rows_of(behind)]
    assert (laid.seen.reshape(-1)[texels] == 0).all()
    assert (
        np.abs(np.median(laid.rgb.reshape(-1, 3)[texels], axis=0) - (40, 30, 25)).max() < 25.0
    )  # skin is 174 levels away


def test_the_same_photo_gives_the_same_texture(sitter, fitted, vertex) -> None:
    person, camera, photo = sitter
    markers = camera.project(person.vertices_m[vertex])
    again = fit_photo(mesh_of(toy_clone(hair=False)), vertex, markers, photo, focal_px=camera.focal_px, size=512)
    assert np.array_equal(again.laid.rgb, fitted.laid.rgb)


def test_the_fitted_clone_keeps_round_eyes_and_a_face_that_moves(fitted) -> None:
    from cloner.paint.details.parts import fit_sphere

    generic, clone = load_generic(), clone_with_photo(toy_clone(hair=False), fitted)
    for side in ("left", "right"):
        rows = generic.part(f"eye_{side}")
        centre, radius = fit_sphere(clone.vertices_m[rows])
        assert np.abs(np.linalg.norm(clone.vertices_m[rows] - centre, axis=1) - radius).max() < 0.0005
        joint = clone.joints_m[generic.joint(f"{side[0]}_eyeball_joint")]
        assert np.linalg.norm(joint - centre) < 0.001
    assert {"jawOpen", "eyeBlinkLeft"} <= set(clone.morph_names)


@pytest.mark.parametrize(
    ("change", "word"),
    [
        (lambda v, p: (v[:4], p[:4]), "few"),
        (lambda v, p: (np.append(v[:-1], 10**7), p), "not on the mesh"),
        (lambda v, p: (np.append(v[:-1], v[0]), p), "same vertex"),
        (lambda v, p: (v, p[:-1]), "number"),
        (lambda v, p: (v, np.full_like(p, 300.0)), "one place"),
        (lambda v, p: (v, p * np.nan), "number"),
    ],
)
def test_markers_that_make_no_sense_are_refused(sitter, vertex, change, word: str) -> None:
    person, camera, photo = sitter
    rows, markers = change(vertex, camera.project(person.vertices_m[vertex]))
    with pytest.raises(ClonerError, match=word):
        fit_photo(mesh_of(person), rows, markers, photo, size=512)


def test_a_photo_without_a_focal_length_is_taken_for_a_portrait() -> None:
    assert focal_px_of(2400, 3600) == pytest.approx(7500.0)
    assert focal_px_of(3600, 2400, 36.0) == pytest.approx(3600.0)
