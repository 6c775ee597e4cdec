"""Hairs beyond the hair's outline: measured where a photo shows them, and as many on the cards made of them."""

from types import SimpleNamespace

import numpy as np
import pytest
import trimesh

from cloner.frames import ViewId
from cloner.generic.layers import Layer
from cloner.generic.painter import paint
from cloner.geometry.meshes.wedges import vertex_normals
from cloner.hair.shells.frizz import Frizz, measure_frizz, shares_beyond
from cloner.hair.shells.frizz_cards import DENSE, INSIDE_MM, frizz_shell, make_room
from cloner.hair.volumes.views import distances_px
from cloner.records.heads import Shell
from cloner.records.photos import Photo
from kit import studio

PIXEL_MM, SIZE, RADIUS_PX = 1.0, 420, 85
ROW, COLUMN = np.mgrid[:SIZE, :SIZE]
OUT_MM = PIXEL_MM * (np.hypot(ROW - 210.0, COLUMN - 210.0) - RADIUS_PX)
HAIR, WALL = np.array([50, 40, 35]), np.array([190, 200, 205])


def view(hair):
    """Return a photo's evidence of a round head of hair on a wall."""
    flags, to_hair, _, to_person = distances_px(hair, hair)
    posed = SimpleNamespace(view=ViewId.BODY_FRONT)
    return SimpleNamespace(
        posed=posed, hair=flags, hair_px=to_hair, outline_px=to_person, flip_m=None,
        to_view=lambda points: points, pixel_mm=lambda points: PIXEL_MM,
    )  # fmt: skip


def photo(share):
    """Return a picture in which so much of each pixel (H, W) is hair, in tufts of its own."""
    chosen = np.random.default_rng(2).random((SIZE, SIZE)) < share
    return np.where(chosen[..., None], HAIR, WALL).astype(np.uint8)


def measured(rgb, hair=OUT_MM < 0.0):
    photos = {ViewId.BODY_FRONT: Photo(ViewId.BODY_FRONT, rgb, None, "", "")}
    return measure_frizz([view(hair)], photos, np.zeros((1, 3)))


def cover(frizz, away_mm):
    """Return the share of hair at some distance beyond the outline."""
    return 1.0 - np.exp(-frizz.depth * np.exp(-away_mm / frizz.length_mm))


@pytest.mark.parametrize("frizz", [Frizz(0.7, 11.0), Frizz(0.4, 7.0)])
def test_depth_and_length_of_frizz_are_found(frizz):
    found = measured(photo(np.where(OUT_MM < 0.0, 1.0, cover(frizz, np.maximum(OUT_MM, 0.0)))))
    assert found is not None
    assert found.length_mm == pytest.approx(frizz.length_mm, rel=0.25)
    assert found.depth == pytest.approx(frizz.depth, rel=0.25)


def test_of_two_photos_the_smoother_is_believed():
    frizzy = photo(np.where(OUT_MM < 0.0, 1.0, cover(Frizz(0.7, 11.0), np.maximum(OUT_MM, 0.0))))
    smooth = photo((OUT_MM < 0.0).astype(float))
    front, side = view(OUT_MM < 0.0), view(OUT_MM < 0.0)
    side.posed = SimpleNamespace(view=ViewId.BODY_SIDE)
    photos = {
        ViewId.BODY_FRONT: Photo(ViewId.BODY_FRONT, frizzy, None, "", ""),
        ViewId.BODY_SIDE: Photo(ViewId.BODY_SIDE, smooth, None, "", ""),
    }
    assert measure_frizz([front, side], photos, np.zeros((1, 3))) is None
    assert measure_frizz([front], photos, np.zeros((1, 3))) is not None


def test_smooth_hair_has_none_also_where_its_edge_is_blurred():
    assert measured(photo(OUT_MM < 0.0)) is None
    edge = np.clip(0.5 - OUT_MM / 4.0, 0.0, 1.0)[..., None]
    assert measured(np.rint(edge * HAIR + (1.0 - edge) * WALL).astype(np.uint8)) is None


def test_a_wall_of_hair_s_colour_and_a_cluttered_one_tell_nothing():
    dark = photo(np.where(OUT_MM < 0.0, 1.0, 0.0))
    dark[OUT_MM >= 0.0] = HAIR + 10
    assert shares_beyond(dark, view(OUT_MM < 0.0), PIXEL_MM) is None
    spotted = photo(np.where(OUT_MM < 0.0, 1.0, 0.4))
    assert shares_beyond(spotted, view(OUT_MM < 0.0), PIXEL_MM) is None


def head(radius_m=0.11):
    """Return a ball of hair as a shell, and a skin far inside it."""
    ball = trimesh.creation.icosphere(subdivisions=4, radius=radius_m)
    points, triangles = np.asarray(ball.vertices), np.asarray(ball.faces, np.int32)
    count = len(points)
    shell = Shell(
        points, triangles, np.full((count, 2), 0.5), np.zeros((count, 4), np.int32),
        np.tile([1.0, 0.0, 0.0, 0.0], (count, 1)), np.full((8, 8, 4), (60, 50, 40, 255), np.uint8),
    )  # fmt: skip
    return shell, (0.5 * points, vertex_normals(points, triangles))


@pytest.mark.parametrize("frizz", [Frizz(2.3, 11.0), Frizz(0.9, 8.0)])
def test_cards_make_the_outline_as_hairy_as_it_was_measured(frizz):
    hair, skin = head()
    cards = frizz_shell(frizz, hair, (hair.vertices_m, hair.triangles, np.full(len(hair.vertices_m), 12.0)), skin)
    shown = []
    for turn_deg in (0.0, 70.0, 200.0):
        camera = studio.orthographic(turn_deg, pixels_per_m=1000.0, aim_m=0.0, size_px=(SIZE, SIZE))
        layers = [
            Layer(one.vertices_m, one.vertices_m, one.triangles, one.uv, one.rgba, two_sided=True)
            for one in (hair, cards)
        ]
        shown.append(1.0 - paint(layers, camera, background=(255, 255, 255)).mean(axis=2) / 255.0)
    share = np.mean(shown, axis=0) / (1.0 - np.mean([60, 50, 40]) / 255.0)
    away_mm = np.hypot(ROW - 209.5, COLUMN - 209.5) - 110.0
    for ring_mm in (2.0, 8.0, 14.0):
        found = share[np.abs(away_mm - ring_mm) < 1.5].mean()
        assert found == pytest.approx(cover(frizz, ring_mm), abs=0.1), ring_mm
    assert cards.kind == "frizz"


def test_cards_stand_on_the_shell_s_weights_clear_of_skin_and_hairline():
    hair, skin = head()
    inside = np.where(hair.vertices_m[:, 1] > 0.0, 12.0, INSIDE_MM - 1.0)
    cards = frizz_shell(Frizz(2.3, 11.0), hair, (hair.vertices_m, hair.triangles, inside), skin)
    roots = cards.vertices_m.reshape(-1, 4, 3)[:, :2].mean(axis=1)
    assert (roots[:, 1] > -0.005).all()
    np.testing.assert_allclose(np.linalg.norm(roots, axis=1), 0.11, atol=0.004)
    assert np.array_equal(cards.skin_joints, np.zeros_like(cards.skin_joints))
    near = (1.15 * hair.vertices_m, skin[1])  # skin above the shell: no room
    assert frizz_shell(Frizz(2.3, 11.0), hair, (hair.vertices_m, hair.triangles, inside), near) is None


def test_a_shell_with_frizz_draws_in_to_where_hair_is_dense_but_not_below_the_skin_or_at_its_edge():
    hair, skin = head()
    inside = np.where(hair.vertices_m[:, 1] > 0.0, 12.0, 0.0)
    frizz = Frizz(0.5, 10.0)
    drawn, dense = make_room(frizz, hair.vertices_m, hair.triangles, inside, skin)
    sunk_mm = 1000.0 * (0.11 - np.linalg.norm(drawn, axis=1))
    np.testing.assert_allclose(sunk_mm[inside > 0.0], 10.0 * np.log(DENSE / 0.5), atol=0.2)
    np.testing.assert_allclose(sunk_mm[inside == 0.0], 0.0, atol=1e-6)
    assert dense == Frizz(DENSE, 10.0)
    close = (0.95 * hair.vertices_m, skin[1])
    shallow_mm = 1000.0 * (
        0.11 - np.linalg.norm(make_room(frizz, hair.vertices_m, hair.triangles, inside, close)[0], axis=1)
    )
    assert shallow_mm.max() < 3.0  # 5.5 mm of hair, of which 3 stay
