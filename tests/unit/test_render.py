"""Pictures of clones: aligned with our pixel frame, the right way round, posed by the skeleton."""

from __future__ import annotations

import moderngl
import numpy as np
import pytest

import cloner.render
from cloner.errors import ClonerError
from cloner.generic.load import load_generic
from cloner.geometry.cameras.viewpoints import look_at
from cloner.records.views import Camera
from cloner.render import render, render_mask, render_mesh, render_rgba, standard_camera
from kit.clones import HAIR, RED_LEFT_HAND, SHIRT, toy_clone


def _has_gl() -> bool:
    try:
        cloner.render.require_gl()
    except ClonerError:
        return False
    return True


needs_gl = pytest.mark.skipif(not _has_gl(), reason="no EGL on this machine: the GL renderer is not tested")


@pytest.fixture(params=["gl", "painter"])
def backend(request, monkeypatch):
    """Both ways to draw must pass every test."""
    if request.param == "painter":
        monkeypatch.setattr(cloner.render, "has_gl", lambda: False)
    elif not _has_gl():
        pytest.skip("no EGL on this machine: the GL renderer is not tested")
    return request.param


def _square(x: float, y: float, half: float, z: float = 0.0):
    corners = np.array(
        [[x - half, y - half, z], [x + half, y - half, z], [x + half, y + half, z], [x - half, y + half, z]]
    )
    return corners, np.array([[0, 1, 2], [0, 2, 3]], dtype=np.int32)


def _camera(width: int, height: int, pixels_per_m: float | None = None) -> Camera:
    eye = np.array([0.3, 1.2, 2.5])
    return Camera(width, height, 700.0, look_at(eye, eye + np.array([-0.05, -0.1, -1.0])), pixels_per_m)


@pytest.mark.parametrize("size", [(200, 301), (301, 200), (256, 256)])
@pytest.mark.parametrize("pixels_per_m", [None, 300.0])
def test_a_square_lands_where_the_camera_projects_it(backend, size, pixels_per_m):
    """Centroid within 0.1 px and area within 2 % of the projected square, odd and even sizes alike."""
    camera = _camera(*size, pixels_per_m)
    corners, triangles = _square(0.25, 1.0, 0.11)
    drawn = render_mesh(corners, triangles, camera, colour=(1, 1, 1), shading="photo", background=(0, 0, 0))
    cover = drawn[..., 0] / 255.0
    rows, columns = np.mgrid[: size[1], : size[0]]
    centre = np.array([(cover * columns).sum(), (cover * rows).sum()]) / cover.sum()
    quad = camera.project(corners)
    x, y = quad.T
    cross = x * np.roll(y, -1) - np.roll(x, -1) * y
    area = cross.sum() / 2
    wanted = np.array([((x + np.roll(x, -1)) * cross).sum(), ((y + np.roll(y, -1)) * cross).sum()]) / (6 * area)
    tolerance_px = 0.1 if backend == "gl" else 0.35  # the painter takes one sample a pixel
    assert np.abs(centre - wanted).max() < tolerance_px
    assert cover.sum() == pytest.approx(abs(area), rel=0.02 if backend == "gl" else 0.03)


def test_the_nearer_of_two_squares_is_seen(backend):
    camera = _camera(120, 120)
    far, triangles = _square(0.2, 1.0, 0.2)
    near, _ = _square(0.22, 1.02, 0.05, z=0.3)
    both = np.concatenate([near, far])
    drawn = cloner.render.draw(
        [
            cloner.render.Layer(near, np.tile([0.0, 0, 1], (4, 1)), triangles, colour=(1, 0, 0)),
            cloner.render.Layer(far, np.tile([0.0, 0, 1], (4, 1)), triangles, colour=(0, 1, 0)),
        ],
        camera,
    )
    column, row = np.round(camera.project(both[:4].mean(axis=0)[None])[0]).astype(int)
    assert drawn[row, column].tolist() == [255, 0, 0]


def test_the_red_left_hand_is_at_plus_x_and_on_the_right_in_the_front_view(backend):
    clone = toy_clone()
    camera = standard_camera(clone, "front", 300, 400)
    picture = render(clone, camera).astype(int)
    red = np.abs(picture - RED_LEFT_HAND).sum(axis=2) < 40
    hand = clone.features_m["fingertip_left"]
    assert hand[0] > 0.3, "the person's left must be +X"
    column, row = camera.project(hand[None])[0]
    assert np.count_nonzero(red) > 50
    assert np.abs(np.argwhere(red).mean(axis=0) - [row, column]).max() < 30
    assert np.argwhere(red)[:, 1].mean() > 150


def test_the_back_view_shows_hair_and_the_front_view_a_face(backend):
    clone = toy_clone()
    hair = {}
    for view in ("face", "face_back"):
        picture = render(clone, standard_camera(clone, view, 200, 200)).astype(int)
        hair[view] = np.count_nonzero(np.abs(picture - HAIR).sum(axis=2) < 30)
    assert hair["face_back"] > 1.5 * hair["face"] > 0


def test_a_bent_shoulder_moves_the_arm_and_nothing_else(backend):
    clone = toy_clone(hair=False)
    camera = standard_camera(clone, "front", 300, 300)
    rotations = np.zeros((94, 3))
    rotations[load_generic().joint("l_shoulder"), 2] = np.radians(30)  # the person's left arm up
    rest, moved = render_mask(clone, camera), render_mask(clone, camera, rotations)
    changed = np.argwhere(rest != moved)
    neck = camera.project(clone.features_m["neck_base_left"][None])[0, 0]
    assert len(changed) > 300
    assert changed[:, 1].min() > neck, "only the person's left side may move"


def test_hair_counts_in_the_mask(backend):
    bald, haired = toy_clone(hair=False), toy_clone(hair=True)
    camera = standard_camera(haired, "face", 200, 200)
    gained = render_mask(haired, camera) & ~render_mask(bald, camera)
    assert np.count_nonzero(gained) > 100
    assert not (render_mask(bald, camera) & ~render_mask(haired, camera)).any()


def test_the_cut_out_is_opaque_inside_and_clear_outside(backend):
    clone = toy_clone()
    camera = standard_camera(clone, "front", 200, 300)
    cut = render_rgba(clone, camera)
    mask = render_mask(clone, camera)
    assert ((cut[..., 3] > 127) == mask).mean() > 0.999
    chest = np.round(camera.project(clone.features_m["belly_front"][None])[0]).astype(int)
    assert np.abs(cut[chest[1], chest[0], :3].astype(int) - SHIRT).max() <= 3


@needs_gl
def test_gl_and_painter_draw_the_same_picture(monkeypatch):
    clone = toy_clone()
    camera = standard_camera(clone, "face_three_quarter", 240, 240)
    drawn = [render(clone, camera, shading="soft").astype(int)]
    monkeypatch.setattr(cloner.render, "has_gl", lambda: False)
    drawn.append(render(clone, camera, shading="soft").astype(int))
    assert np.abs(drawn[0] - drawn[1]).mean() < 6.0


@pytest.mark.parametrize("view", ["front", "side", "left", "right", "back", "three_quarter"])
def test_standard_cameras_frame_the_whole_body(view):
    clone = toy_clone()
    points = standard_camera(clone, view, 300, 500).project(clone.vertices_m)
    assert (points >= 0).all()
    assert (points <= [299, 499]).all()
    assert max(np.ptp(points[:, 0]) / 300, np.ptp(points[:, 1]) / 500) > 0.85, "the figure should fill the picture"


def test_side_is_the_person_s_right_looking_to_the_image_right():
    clone = toy_clone()
    camera = standard_camera(clone, "side", 300, 500)
    assert camera.position_m[0] < -1.0
    nose, nape = camera.project(np.stack([clone.features_m["nose_tip"], clone.features_m["nape"]]))
    assert nose[0] > nape[0]


def test_an_unknown_view_is_refused_with_the_known_ones():
    with pytest.raises(ValueError, match="three_quarter"):
        standard_camera(toy_clone(), "below", 100, 100)


def test_without_egl_the_error_says_how_to_get_it(monkeypatch):
    def broken(**_):
        raise Exception("libEGL.so.1 not loaded")

    monkeypatch.setattr(moderngl, "create_context", broken)
    monkeypatch.setattr(cloner.render._local, "stage", None, raising=False)
    with pytest.raises(ClonerError) as caught:
        cloner.render.require_gl()
    assert "apt-get install" in caught.value.hint
    assert caught.value.where == "EGL"


@needs_gl
def test_the_wire_mesh_shows_edges_of_what_is_seen_and_hides_the_rest():
    camera = _camera(160, 160)
    near, triangles = _square(0.2, 1.0, 0.2, z=0.3)
    far, _ = _square(0.2, 1.0, 0.1)
    layers = [cloner.render.Layer(points, np.tile([0.0, 0, 1], (4, 1)), triangles) for points in (near, far)]
    drawn = cloner.render.draw(layers, camera, shading="wire", background=(255, 255, 255)).astype(int)
    dark = drawn.sum(axis=2) < 600
    corner, middle = camera.project(near[:2]).round().astype(int)[0], camera.project(far[:2]).mean(axis=0)
    assert dark[corner[1] - 2 : corner[1] + 3, corner[0] - 2 : corner[0] + 3].any(), "the near square's edges are seen"
    column, row = middle.round().astype(int)
    assert not dark[row - 2 : row + 3, column - 4 : column + 5].any(), "edges behind it are not"
    assert 0.002 < dark.mean() < 0.05, "edges, no faces"


def test_pictures_follow_a_texture_that_changes(backend):
    corners, triangles = _square(0.25, 1.0, 0.3)
    camera, uv = _camera(64, 64), np.array([[0, 1], [1, 1], [1, 0], [0, 0.0]])
    normals, seen = np.tile([0.0, 0, 1], (4, 1)), []
    for colour in ((250, 0, 0), (0, 250, 0)):
        texture = np.tile(np.array(colour, np.uint8), (8, 8, 1))
        texture.flags.writeable = False
        layer = cloner.render.Layer(corners, normals, triangles, uv, texture)
        seen.append(cloner.render.draw([layer], camera)[32, 32].tolist())
    assert seen == [[250, 0, 0], [0, 250, 0]]
