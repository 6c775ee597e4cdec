"""The 15 skin segments, their slice coordinates and the connection database (Lee et al. 2000, section 3)."""

from __future__ import annotations

import hanim
import numpy as np
from source import FloatArray, IntArray

# Segment: (joint at s = 0, joint at s = 1). Head, hands and feet are free meshes, not grids.
AXES = {
    "torso": ("vl5", "vt1"),
    "pelvis": ("HumanoidRoot", "vl5"),
    **{
        f"{side}_{part}": (f"{side[0]}_{a}", f"{side[0]}_{b}")
        for side in ("left", "right")
        for part, a, b in (
            ("upper_arm", "shoulder", "elbow"),
            ("forearm", "elbow", "wrist"),
            ("thigh", "hip", "knee"),
            ("calf", "knee", "ankle"),
        )
    },
}


def segment_weights(skin: FloatArray) -> FloatArray:
    """Return (V, 15): skin weights summed over the joints of each segment."""
    rows = [hanim.SEGMENTS.index(hanim.segment_of_joint(n)) for n in hanim.NAMES]
    return skin @ np.eye(len(hanim.SEGMENTS))[rows]


def axis_joints() -> IntArray:
    """Return (15, 2) joint indices of each segment's axis, -1 where the segment is free."""
    out = np.full((len(hanim.SEGMENTS), 2), -1, dtype=np.int32)
    for name, (a, b) in AXES.items():
        out[hanim.SEGMENTS.index(name)] = hanim.INDEX[a], hanim.INDEX[b]
    return out


def slice_coordinates(vertices_m: FloatArray, joints_m: FloatArray, segment: IntArray) -> tuple[FloatArray, FloatArray]:
    """Return each vertex's slice position s (0..1) and angle theta (radians) in its own segment.

    Notes
    -----
    Limbs: s = 0 at the joint, 1 at the child joint, clipped. Torso and pelvis: the axis is vertical through the
    segment's middle, s runs over the segment's own height, because skin below the hips and above the collar belongs
    to no bone's length. theta is 0 in front and grows towards the person's left; free segments hold zeros.
    """
    s, theta = np.zeros(vertices_m.shape[0]), np.zeros(vertices_m.shape[0])
    for number, (a, b) in enumerate(axis_joints()):
        own = np.flatnonzero(segment == number)
        if a < 0 or own.size == 0:
            continue
        start, end = joints_m[a], joints_m[b]
        if hanim.SEGMENTS[number] in ("torso", "pelvis"):
            points = vertices_m[own]
            low, high = points.min(axis=0), points.max(axis=0)
            start = np.array([0.0, low[1], (low[2] + high[2]) / 2])
            end = np.array([0.0, high[1], start[2]])
        along = end - start
        length = np.linalg.norm(along)
        along = along / length
        front = np.array([0.0, 0.0, 1.0]) - along[2] * along
        front /= np.linalg.norm(front)
        left = np.cross(along, front)
        left *= np.sign(left[0])
        spoke = vertices_m[own] - start
        s[own] = np.clip(spoke @ along / length, 0.0, 1.0)
        theta[own] = np.arctan2(spoke @ left, spoke @ front)
    return s.astype(np.float32), theta.astype(np.float32)


def connections(quads: IntArray, segment: IntArray) -> tuple[IntArray, IntArray]:
    """Return each quad's segment (Q,) and rows (segment a, segment b, vertex) of shared border vertices, (M, 3)."""
    votes = np.zeros((quads.shape[0], len(hanim.SEGMENTS)), dtype=np.int64)
    for k in range(4):
        votes[np.arange(quads.shape[0]), segment[quads[:, k]]] += 1
    owner = votes.argmax(axis=1)
    touches = np.unique(np.column_stack([quads.ravel(), np.repeat(owner, 4)]), axis=0)
    rows = []
    for vertex in np.flatnonzero(np.bincount(touches[:, 0]) > 1):
        around = touches[touches[:, 0] == vertex, 1]
        rows += [(a, b, vertex) for i, a in enumerate(around) for b in around[i + 1 :]]
    return owner.astype(np.uint8), np.array(sorted(rows), dtype=np.int32)
