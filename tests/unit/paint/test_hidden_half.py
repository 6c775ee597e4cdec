"""What hair hides of a face in its front photo is painted from the other half, and nothing else is."""

from __future__ import annotations

import numpy as np

from cloner.frames import ViewId
from cloner.generic.load import load_generic
from cloner.generic.photo_shares import mirrored_share
from cloner.generic.surfaces import body_triangles
from cloner.geometry.cameras.visibility import compute_visibility
from cloner.paint.lookups.sources import Source, mirror_hidden
from cloner.records.views import Camera

GENERIC = load_generic()


def test_the_hidden_half_takes_the_other_half_s_pixels() -> None:
    points = GENERIC.vertices_m.astype(np.float64)
    to_camera = np.diag([1.0, -1.0, -1.0, 1.0])
    to_camera[:3, 3] = 0.0, 1.6, 2.0
    visibility = compute_visibility(points, body_triangles(), Camera(600, 600, 1500.0, to_camera))
    face = GENERIC.region("face")
    left = points[:, 0] > 0.005
    score = np.where(face & ~left, 0.8, 0.0)
    nothing = np.zeros((4, 4), np.float32)
    front = Source(ViewId.FACE_FRONT, False, None, visibility, visibility.pixel_px, nothing, nothing, score)  # type: ignore[arg-type]
    twin = mirror_hidden(GENERIC, front)
    assert twin.mirrored
    assert not twin.score[score > 0.0].any()
    assert not twin.score[~face].any()
    hidden = np.flatnonzero(face & left & (score[GENERIC.mirror] > 0.0))
    assert len(hidden) > 100
    assert np.allclose(twin.score[hidden], mirrored_share() * 0.8)
    assert np.array_equal(twin.lookup_px[hidden], front.lookup_px[GENERIC.mirror[hidden]])


def test_a_turned_head_s_far_cheek_and_ear_are_the_near_ones() -> None:
    """Turned by 25 degrees the far cheek lies at a slant: its pixels are stretched, a lamp behind draws its edge."""
    points = GENERIC.vertices_m.astype(np.float64)
    to_camera = np.diag([1.0, -1.0, -1.0, 1.0])
    turn = np.radians(25.0)
    to_camera[:3, :3] = to_camera[:3, :3] @ [
        [np.cos(turn), 0.0, np.sin(turn)], [0.0, 1.0, 0.0], [-np.sin(turn), 0.0, np.cos(turn)]
    ]  # fmt: skip
    to_camera[:3, 3] = 0.0, 1.6, 2.0
    visibility = compute_visibility(points, body_triangles(), Camera(600, 600, 1500.0, to_camera))
    head = GENERIC.region("face") | GENERIC.region("ear_left") | GENERIC.region("ear_right")
    score = np.where(head, np.clip(visibility.cosine, 0.0, 1.0), 0.0)
    nothing = np.zeros((4, 4), np.float32)
    front = Source(ViewId.FACE_FRONT, False, None, visibility, visibility.pixel_px, nothing, nothing, score)  # type: ignore[arg-type]
    twin = mirror_hidden(GENERIC, front)
    near, far = (GENERIC.region(name) for name in ("ear_left", "ear_right"))
    if score[near].mean() < score[far].mean():
        near, far = far, near
    assert twin.score[far].mean() > 0.1 > twin.score[near].mean()
    slanted = (
        GENERIC.region("face") & (score > 0.0) & (visibility.cosine < 0.4) & (visibility.cosine[GENERIC.mirror] > 0.7)
    )
    assert slanted.sum() > 30
    assert (twin.score[slanted] > 0.0).all()
    assert not twin.score[head & (visibility.cosine > 0.6)].any()
