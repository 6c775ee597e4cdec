"""What the pose net says of a known body: its joints, off by what the net is usually off."""

import numpy as np

from cloner.detectors.body.levels import load_levels
from cloner.detectors.nets import pose_rows as net
from cloner.frames import ViewId
from cloner.generic.load import load_generic
from cloner.records.proposals import Proposal
from kit import studio
from kit.people import with_shoes_and_hair

KINDS = {"body_front": "front", "body_side": "side", "body_back": "back"}
SMALL_PX = (600, 900)
_HEAD = {
    net.NOSE: "nose_tip", 2: "pupil_L", 5: "pupil_R", 7: "ear_outer_L", 8: "ear_outer_R",
    9: "mouth_corner_L", 10: "mouth_corner_R",
}  # fmt: skip


def seen(person, rotations, view, *, turned_deg=0.0, size_px=SMALL_PX):
    """Return the mask (H, W) uint8, the net's (33, 2) points, the camera, posed vertices and posed joints."""
    vertices, joints = person.posed(rotations)
    camera = studio.camera(studio.AZIMUTH_DEG[view] + turned_deg, size_px=size_px)
    mask = studio.silhouette(*with_shoes_and_hair(vertices), camera)
    return (
        np.where(mask, 255, 0).astype(np.uint8),
        pose_points(vertices, joints, view, camera, mask),
        camera,
        vertices,
        joints,
    )


def pose_points(vertices_m, joints_m, view, camera, mask):
    """Return the (33, 2) points of a net that errs along the body as the real one does on average."""
    generic, model = load_generic(), load_levels(KINDS[view])
    pose = np.zeros((33, 2))
    for name, row in net.JOINTS.items():
        pose[row] = camera.project(joints_m[[generic.joint(name)]])[0]
    for row, name in _HEAD.items():
        pose[row] = camera.project(vertices_m[[generic.feature(name)]])[0]
    for side, name in enumerate(net.SIDES):
        tip = camera.project(vertices_m[[generic.feature(f"fingertip_{name}")]])[0]
        for fingers in net.FINGERS:
            pose[fingers[side]] = 0.45 * tip + 0.55 * pose[net.WRISTS[side]]
        for rows, end in ((net.HEELS, "heel"), (net.TOES, "toe")):
            pose[rows[side]] = camera.project(vertices_m[[generic.feature(f"{end}_{name}")]])[0]
    rows = np.flatnonzero(mask.any(axis=1))
    height = float(rows[-1] - rows[0])
    for joint, pair in (("shoulder", net.SHOULDERS), ("hip", net.HIPS), ("knee", net.KNEES), ("ankle", net.ANKLES)):
        usual = model.mean[model.index(f"net_{joint}")] - model.mean[model.index(f"joint_{joint}")]
        pose[list(pair), 1] -= usual * height
    for name, pair in (("ears", net.EARS), ("heel", net.HEELS), ("toe", net.TOES)):
        level = model.mean[model.index(f"net_{name}")]
        own = (rows[-1] - pose[list(pair), 1].mean()) / height
        pose[list(pair), 1] -= (level - own) * height if name != "ears" else 0.0
    return pose


def proposal(view, mask, pose, *, visibility=1.0):
    """Return a proposal without face and hair."""
    return Proposal(
        ViewId(view), pose, np.full(33, visibility), np.zeros((468, 2)), np.zeros(468), 1.0, mask, np.zeros_like(mask)
    )
