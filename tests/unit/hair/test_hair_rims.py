"""Hair beyond its surface: its share in photos, where its surface ends, and cards that show it where photos do."""

from dataclasses import replace
from types import SimpleNamespace

import numpy as np
import pytest
import trimesh

from cloner.frames import ViewId
from cloner.generic.layers import Layer
from cloner.generic.painter import paint
from cloner.hair.shells.edge import FADE_MM, inside_hairline_mm
from cloner.hair.shells.mattes import hair_rim_mm, make_matte, reduce_to_core
from cloner.hair.shells.rim_cards import crown_centre, rim_shell
from cloner.hair.shells.rim_strips import LEFT, RIGHT, TEXEL_MM, make_strips
from cloner.hair.shells.rims import camera_around, half_outlines, points_beside
from cloner.hair.volumes.pictures import distances_px
from cloner.hair.volumes.views import HairView
from cloner.records.heads import Shell
from kit import studio

SIZE, RADIUS_MM, PIXEL_MM = 420, 110.0, 1.0
ROW, COLUMN = np.mgrid[:SIZE, :SIZE]
OUT_MM = PIXEL_MM * np.hypot(ROW - 209.5, COLUMN - 209.5) - RADIUS_MM
TURN = np.degrees(np.arctan2(COLUMN - 209.5, 209.5 - ROW))
HAIR, WALL = np.array([50, 40, 35]), np.array([190, 200, 205])


def view(hair, name=ViewId.FACE_FRONT, azimuth_deg=0.0):
    """Return a photo's evidence of a round head of hair before a wall, seen without perspective."""
    flags, to_hair, to_line, to_person = distances_px(hair, hair)
    camera = studio.orthographic(azimuth_deg, pixels_per_m=1000.0, aim_m=0.0, size_px=(SIZE, SIZE))
    still = np.tile(np.eye(4), (94, 1, 1))
    hanger = SimpleNamespace(joints=np.zeros(4, int), shares=lambda points: (np.ones(len(points)), *np.zeros((2, 1))))
    posed = SimpleNamespace(view=name, camera=camera)
    return HairView(posed, still, hanger, None, flags, to_hair, to_line, to_person, np.zeros_like(flags))


def curly(depth=0.7, length_mm=7.0, seed=2):
    """Return a picture of hair that thins out beyond its outline, in tufts of 3 px."""
    away = np.maximum(OUT_MM, 0.0)
    share = np.where(OUT_MM < 0.0, 1.0, 1.0 - np.exp(-depth * 3.0 * np.exp(-away / length_mm)))
    tufts = np.random.default_rng(seed).random((SIZE // 3, SIZE // 3)).repeat(3, 0).repeat(3, 1)
    return np.where((tufts < share)[..., None], HAIR, WALL).astype(np.uint8)


def spiky():
    """Return a picture of a head with twelve pointed spikes of 20 mm, and the spikes (H, W)."""
    spikes = (np.abs((TURN + 15.0) % 30.0 - 15.0) < 5.0 * (1.0 - OUT_MM / 20.0)) & (OUT_MM >= 0.0)
    return np.where(((OUT_MM < 0.0) | spikes)[..., None], HAIR, WALL).astype(np.uint8), spikes


def matte(rgb, hair=OUT_MM < 5.0):
    return make_matte(rgb, view(hair), PIXEL_MM)


def test_the_core_ends_where_hair_gets_thin_and_the_rim_where_none_is_left():
    found = matte(curly())
    assert found.clear
    radius = np.sqrt(found.core.sum() / np.pi) * found.pixel_mm
    assert RADIUS_MM - 3.0 < radius < RADIUS_MM + 12.0
    reach_mm = hair_rim_mm([found])
    assert 20.0 < reach_mm <= 45.0
    shorter = hair_rim_mm([matte(curly(0.7, 4.0))])
    assert shorter < reach_mm


def test_smooth_hair_has_no_rim_also_where_its_edge_is_blurred():
    assert hair_rim_mm([matte(np.where((OUT_MM < 5.0)[..., None], HAIR, WALL).astype(np.uint8))]) is None
    edge = np.clip(0.5 - (OUT_MM - 5.0) / 3.0, 0.0, 1.0)[..., None]
    assert hair_rim_mm([matte(np.rint(edge * HAIR + (1.0 - edge) * WALL).astype(np.uint8))]) is None


def test_of_two_photos_the_smoother_is_believed():
    smooth, rough = np.where((OUT_MM < 5.0)[..., None], HAIR, WALL).astype(np.uint8), curly()
    assert hair_rim_mm([matte(smooth), matte(rough)]) is None
    assert hair_rim_mm([matte(rough)]) is not None


def test_a_wall_of_hair_s_colour_and_a_cluttered_one_tell_nothing():
    dark = curly()
    dark[OUT_MM >= 5.0] = HAIR + 10
    assert not matte(dark).clear
    spotted = curly()
    far = (OUT_MM > 25.0) & (np.random.default_rng(1).random((SIZE, SIZE)) < 0.3)
    spotted[far] = HAIR
    assert not matte(spotted).clear
    assert hair_rim_mm([matte(dark), matte(spotted)]) is None


def test_another_thing_s_colour_beyond_the_hair_is_no_hair():
    rgb = curly(0.0)
    poster = (OUT_MM > 8.0) & (COLUMN > 280)
    rgb[poster] = (200, 20, 20)
    found = matte(rgb)
    beyond = OUT_MM[:: int(found.step), :: int(found.step)] > 0.0  # step 1: a pixel is a millimetre
    assert found.step == 1.0
    top = found.origin_px.astype(int)
    window = np.s_[top[1] : top[1] + found.share.shape[0], top[0] : top[0] + found.share.shape[1]]
    assert found.share[poster[window] & beyond[window]].mean() < 0.05


def test_mixed_pixels_have_the_colour_of_the_hair_around():
    found = matte(curly())
    shown = found.share > 0.3
    np.testing.assert_allclose(found.rgb[shown].mean(axis=0), HAIR, atol=6.0)


def test_surfaces_are_fitted_to_the_core():
    seen, rgb = view(OUT_MM < 15.0), curly(0.7, 8.0)
    fitted = reduce_to_core(seen, make_matte(rgb, seen, PIXEL_MM))
    assert fitted.hair.sum() < seen.hair.sum()
    assert (fitted.hair_px[OUT_MM > 14.0] < 0.0).all()
    assert (fitted.outline_px[OUT_MM > 14.0] < 0.0).all()


def head(radius_m=0.001 * RADIUS_MM):
    """Return a ball of hair as a shell, and a body far inside it."""
    ball = trimesh.creation.icosphere(subdivisions=4, radius=radius_m)
    points, triangles = np.asarray(ball.vertices), np.asarray(ball.faces, np.int32)
    count = len(points)
    shell = Shell(
        points, triangles, np.full((count, 2), 0.5), np.zeros((count, 4), np.int32),
        np.tile([1.0, 0.0, 0.0, 0.0], (count, 1)), np.full((8, 8, 4), (*HAIR, 255), np.uint8),
    )  # fmt: skip
    return shell, (0.3 * points, triangles)


@pytest.mark.parametrize("azimuth_deg", [0.0, 40.0, 130.0])
def test_rims_of_a_ball_are_its_great_circle_from_the_crown_down(azimuth_deg):
    hair, body = head()
    left, right = half_outlines(
        (hair.vertices_m, hair.triangles), body, camera_around(np.zeros(3), np.radians(azimuth_deg)), np.zeros(3)
    )
    across = np.array([np.cos(np.radians(azimuth_deg)), 0.0, -np.sin(np.radians(azimuth_deg))])
    for rim, sign in ((left, -1.0), (right, 1.0)):
        assert rim.free.all()
        np.testing.assert_allclose(np.linalg.norm(rim.place_m, axis=1), 0.11, atol=0.003)
        assert np.abs(rim.place_m[0, 0]) < 0.01
        assert rim.place_m[0, 1] > 0.105
        assert (sign * rim.place_m[5:-5] @ across > 0.0).all()
        out = points_beside(camera_around(np.zeros(3), np.radians(azimuth_deg)), rim, 20.0)
        np.testing.assert_allclose(np.linalg.norm(out, axis=1), 0.13, atol=0.003)


def test_hair_that_no_photo_shows_is_whole_beside_a_hairline():
    """From the front the lower half is face: behind, a little farther than that line tells, the hair has no edge."""
    hair, _ = head()
    person = OUT_MM < 5.0
    hair_flags, to_hair, to_line, to_person = distances_px(person & (ROW < 210), person)
    front = replace(
        view(person), hair=hair_flags, hair_px=to_hair, line_px=to_line, outline_px=to_person,
        nearest_m=np.full((SIZE // 2, SIZE // 2), np.inf, np.float32),
    )  # fmt: skip
    inside_mm = inside_hairline_mm([front], [1.0], hair.vertices_m, hair.triangles)
    face = (hair.vertices_m[:, 2] > 0.05) & (hair.vertices_m[:, 1] < -0.02)
    behind = hair.vertices_m[:, 2] < -0.08
    assert inside_mm[face].max() < 0.0
    assert inside_mm[behind].min() > FADE_MM[1]


def test_a_rim_is_not_the_hair_s_where_the_body_stands_out():
    hair, _ = head()
    column = trimesh.creation.cylinder(radius=0.06, height=0.5)
    column.apply_transform(trimesh.transformations.rotation_matrix(np.pi / 2, [1, 0, 0], [0, 0, 0]))
    column.apply_translation([0.0, -0.25, 0.0])
    body = np.asarray(column.vertices), np.asarray(column.faces, np.int32)
    left, _ = half_outlines((hair.vertices_m, hair.triangles), body, camera_around(np.zeros(3), 0.0), np.zeros(3))
    low = left.place_m[:, 1] < -0.11
    assert not left.free[low].any()
    assert left.free[left.place_m[:, 1] > -0.08].all()


def cards_of(rgb, hair=OUT_MM < 5.0, reach_mm=24.0, bare=None, names=(ViewId.FACE_FRONT,)):
    """Return strips and cards of the ball by one front photo."""
    shell, body = head()
    views = [view(hair, name) for name in names]
    mattes = {name: make_matte(rgb, one, PIXEL_MM) for name, one in zip(names, views, strict=True)}
    grown = shell.vertices_m, shell.triangles
    strips = make_strips(
        grown, body[1], dict.fromkeys(names, body[0]), views, mattes, reach_mm, crown_centre(shell.vertices_m)
    )
    bare = np.zeros(len(shell.vertices_m), bool) if bare is None else bare
    return shell, strips, rim_shell(shell, grown, body, strips, reach_mm, bare)


def seen(shells, azimuth_deg):
    """Return how dark every pixel is, 0..1."""
    camera = studio.orthographic(azimuth_deg, pixels_per_m=1000.0, aim_m=0.0, size_px=(SIZE, SIZE))
    layers = [Layer(s.vertices_m, s.vertices_m, s.triangles, s.uv, s.rgba, two_sided=True) for s in shells]
    return (255.0 - paint(layers, camera, background=(255, 255, 255)).mean(axis=2)) / (255.0 - HAIR.mean())


def test_spikes_stand_where_the_photo_shows_them():
    rgb, spikes = spiky()
    hair, _, cards = cards_of(rgb)
    shown = seen((hair, cards), 0.0)
    away = np.abs((TURN + 15.0) % 30.0 - 15.0)
    upper = (ROW < 260) & (OUT_MM > 4.0)
    assert shown[upper & spikes & (OUT_MM < 15.0) & (away < 1.5)].mean() > 0.6
    assert shown[upper & (away > 6.0)].mean() < 0.15
    assert cards.kind == "frizz"


@pytest.mark.parametrize("azimuth_deg", [0.0, 45.0, 70.0])
def test_cards_make_the_outline_as_hairy_as_photos_show_it(azimuth_deg):
    rgb = curly()
    hair, _, cards = cards_of(rgb)
    photo = (rgb == HAIR).all(axis=2)
    shown = seen((hair, cards), azimuth_deg)
    for ring_mm in (4.0, 9.0, 14.0):
        ring = (np.abs(OUT_MM - ring_mm) < 2.0) & (ROW < 260)
        assert shown[ring].mean() == pytest.approx(photo[ring].mean(), abs=0.25), ring_mm


def test_cards_stand_on_the_shell_s_weights_and_not_under_a_hat():
    shell, _ = head()
    hat = shell.vertices_m[:, 1] > 0.03
    _, _, cards = cards_of(curly(), bare=hat)
    roots = cards.vertices_m.reshape(-1, 4, 3)[:, :2].mean(axis=1)
    assert roots[:, 1].max() < 0.05
    assert np.array_equal(cards.skin_joints, np.zeros_like(cards.skin_joints))
    assert cards_of(curly(), bare=np.ones(len(shell.vertices_m), bool))[2] is None


def test_what_a_photo_cuts_off_is_filled_by_its_other_half_and_by_what_is_near():
    rgb = curly()
    cut = rgb[:, : SIZE // 2 + 30].copy()
    shell, body = head()
    whole = view(OUT_MM < 5.0)
    camera = whole.posed.camera
    narrow = SimpleNamespace(view=ViewId.FACE_FRONT, camera=camera)
    flags = (OUT_MM < 5.0)[:, : SIZE // 2 + 30]
    found, to_hair, to_line, to_person = distances_px(flags, flags)
    half = HairView(
        narrow, whole.transforms, whole.hanger, None, found, to_hair, to_line, to_person, np.zeros_like(flags)
    )
    matte_cut = make_matte(cut, half, PIXEL_MM)
    grown = shell.vertices_m, shell.triangles
    strips = make_strips(
        grown, body[1], {ViewId.FACE_FRONT: body[0]}, [half], {ViewId.FACE_FRONT: matte_cut}, 24.0, np.zeros(3)
    )
    assert set(strips) == {LEFT, RIGHT}
    beyond = round(20.0 / TEXEL_MM)
    amounts = [strip.rgba[:beyond, :, 3].mean() for strip in strips.values()]
    assert min(amounts) > 0.6 * max(amounts) > 0.0


def test_without_a_photo_that_shows_the_rim_there_are_no_strips():
    shell, body = head()
    grown = shell.vertices_m, shell.triangles
    assert make_strips(grown, body[1], {}, [], {}, 24.0, np.zeros(3)) == {}
    assert rim_shell(shell, grown, body, {}, 24.0, np.zeros(len(grown[0]), bool)) is None


def test_a_wall_that_hides_most_of_the_rims_leaves_no_cards():
    """Dark boards behind dark hair: what little was told were the boards' own corners, and rods stood out of a head."""
    rgb = curly()
    rgb[:, 100:] = HAIR.mean().astype(np.uint8)
    assert cards_of(rgb)[1] == {}
