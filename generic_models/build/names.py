"""Names on the generic human: body and face features, MPEG-4 points and regions of the skin."""

from __future__ import annotations

from dataclasses import dataclass

import hanim
import numpy as np
from source import FloatArray, IntArray

# Named skull, face and neck points of the project's truth data as hm08 vertices (left side; the right is the mirror).
_FACE = {
    "eye_inner": 7796,
    "eye_outer": 7755,
    "eye_upper": 7774,
    "eye_lower": 13370,
    "mouth_corner": 7129,
    "ala": 11669,
    "ear_top": 12012,
    "ear_lobe": 12329,
    "ear_back": 12018,
    "ear_outer": 12038,
    "acromion": 8274,
    "neck_base": 7478,
}
_MIDDLE = {
    "vertex_top": 881,
    "nasion": 132,
    "glabella": 227,
    "nose_tip": 297,
    "subnasale": 343,
    "lip_top": 455,
    "stomion": 474,
    "lip_bottom": 492,
    "chin_front": 5162,
    "chin_bottom": 5296,
    "nape": 1491,
    "neck_front_base": 815,
    "crotch": 4376,
}


@dataclass(frozen=True, slots=True, eq=False)
class Figure:
    """The mean body that the naming rules measure: vertices (V, 3), joints (94, 3), segment and twin (V,)."""

    vertices_m: FloatArray
    joints_m: FloatArray
    segment: IntArray
    mirror: IntArray
    body: IntArray

    def joint(self, name: str) -> FloatArray:
        """Return one joint's centre (3,)."""
        return self.joints_m[hanim.INDEX[name]]

    def inside(self, *segments: str) -> IntArray:
        """Return the body vertices of some segments."""
        wanted = [hanim.SEGMENTS.index(s) for s in segments]
        return self.body[np.isin(self.segment[self.body], wanted)]

    def farthest(self, among: IntArray, direction: FloatArray) -> int:
        """Return the vertex farthest along a direction."""
        return int(among[np.argmax(self.vertices_m[among] @ direction)])

    def near_plane(self, among: IntArray, point: FloatArray, normal: FloatArray, half_m: float) -> IntArray:
        """Return those vertices within ``half_m`` of a plane."""
        away = np.abs((self.vertices_m[among] - point) @ (normal / np.linalg.norm(normal)))
        return among[away < half_m]


X, Y, Z = np.eye(3)
_BAND_M = 0.012  # about one ring of hm08 on the limbs


def _limb_points(figure: Figure) -> dict[str, int]:
    """Return the left limb's outline points seen from the front and from the side."""
    out: dict[str, int] = {}
    bends = (
        ("elbow", "l_elbow", "l_shoulder", "l_wrist", ("left_upper_arm", "left_forearm")),
        ("wrist", "l_wrist", "l_elbow", "l_wrist", ("left_forearm", "left_hand")),
        ("knee", "l_knee", "l_hip", "l_ankle", ("left_thigh", "left_calf")),
        ("ankle", "l_ankle", "l_knee", "l_ankle", ("left_calf", "left_foot")),
    )
    for name, joint, above, below, segments in bends:
        along = figure.joint(below) - figure.joint(above)
        band = figure.near_plane(figure.inside(*segments), figure.joint(joint), along, _BAND_M)
        across = np.array([-along[1], along[0], 0.0])  # in the front view, away from the body's middle
        out[f"{name}_outer_left"] = figure.farthest(band, across)
        out[f"{name}_inner_left"] = figure.farthest(band, -across)
        if name in ("knee", "ankle"):
            out[f"{name}_front_left"] = figure.farthest(band, Z)
            out[f"{name}_back_left"] = figure.farthest(band, -Z)
    thigh = figure.near_plane(
        figure.inside("left_thigh"), (figure.joint("l_hip") + figure.joint("l_knee")) / 2, Y, _BAND_M
    )
    out["thigh_front_left"], out["thigh_back_left"] = figure.farthest(thigh, Z), figure.farthest(thigh, -Z)
    out["thigh_outer_left"], out["thigh_inner_left"] = figure.farthest(thigh, X), figure.farthest(thigh, -X)
    calf = figure.inside("left_calf")
    upper = calf[figure.vertices_m[calf, 1] > figure.joint("l_ankle")[1] + 0.12]
    out["calf_left"] = figure.farthest(upper, -Z - 0.02 * Y)
    foot = figure.inside("left_foot")
    out["heel_left"], out["toe_left"] = figure.farthest(foot, -Z - 0.2 * Y), figure.farthest(foot, Z)
    out["sole_left"] = figure.farthest(foot, -Y)
    hand = figure.inside("left_hand")
    out["fingertip_left"] = figure.farthest(hand, figure.joint("l_middle3") - figure.joint("l_middle0"))
    return out


def _trunk_points(figure: Figure, skin: FloatArray) -> dict[str, int]:
    """Return outline points of neck, trunk and seat."""
    v = figure.vertices_m
    shoulder = skin[:, hanim.INDEX["l_shoulder"]]
    trunk_share = skin[:, [hanim.INDEX[n] for n in hanim.LUMBAR_UP]].sum(axis=1)
    armhole = figure.body[(shoulder[figure.body] > 0.25) & (trunk_share[figure.body] > 0.25)]
    armpit = figure.farthest(armhole, -Y)
    trunk = figure.inside("torso", "pelvis")
    seat = figure.inside("pelvis", "left_thigh", "right_thigh")
    levels = np.arange(figure.joint("vl5")[1], figure.joint("vt10")[1], 0.005)
    widths = [v[figure.near_plane(trunk, np.array([0, y, 0.0]), Y, _BAND_M), 0].max() for y in levels]
    waist = np.array([0.0, levels[int(np.argmin(widths))], 0.0])
    band = figure.near_plane(trunk, waist, Y, _BAND_M)
    chest = trunk[(v[trunk, 1] < v[armpit, 1] + 0.03) & (v[trunk, 1] > waist[1] + 0.08) & (v[trunk, 0] >= 0)]
    front = figure.farthest(chest, Z)
    chest_band = figure.near_plane(trunk, v[front], Y, _BAND_M)
    upper_back = trunk[v[trunk, 1] > waist[1] + 0.1]
    middle = trunk[np.abs(v[trunk, 0]) < 1e-4]
    belly = middle[(v[middle, 1] < waist[1]) & (v[middle, 1] > figure.joint("l_hip")[1] + 0.04)]
    low = seat[(v[seat, 1] > v[_MIDDLE["crotch"], 1]) & (v[seat, 1] < waist[1]) & (v[seat, 0] >= 0)]
    middle_all = figure.body[np.abs(v[figure.body, 0]) < 1e-4]
    throat = figure.near_plane(middle_all, figure.joint("vc5"), Y + 0.3 * Z, _BAND_M)
    return {
        "head_top": _MIDDLE["vertex_top"],
        "crotch": _MIDDLE["crotch"],
        "neck_base_left": _FACE["neck_base"],
        "shoulder_end_left": _FACE["acromion"],
        "armpit_left": armpit,
        "waist_left": figure.farthest(band, X),
        "waist_front": figure.farthest(band, Z),
        "waist_back": figure.farthest(np.intersect1d(band, middle), -Z),
        "hip_left": figure.farthest(low, X),
        "buttock_left": figure.farthest(low, -Z),
        "chest_front": front,
        "chest_left": figure.farthest(chest_band, X),
        "back": figure.farthest(upper_back, -Z + 1e-6 * X),
        "belly_front": figure.farthest(belly, Z),
        "neck_front": figure.farthest(throat, Z),
        "neck_back": figure.farthest(throat, -Z),
        "neck_front_base": _MIDDLE["neck_front_base"],
        "nape": _MIDDLE["nape"],
    }


def features(figure: Figure, skin: FloatArray) -> dict[str, int]:
    """Return every named feature's vertex; sides ``_left``/``_right`` on the body, ``_L``/``_R`` on the face."""
    body = {**_trunk_points(figure, skin), **_limb_points(figure)}
    out: dict[str, int] = {}
    for name, vertex in body.items():
        out[name] = vertex
        if name.endswith("_left"):
            out[name.removesuffix("_left") + "_right"] = int(figure.mirror[vertex])
    for name, vertex in _MIDDLE.items():
        out[name] = vertex
    for name, vertex in _FACE.items():
        out[name + "_L"], out[name + "_R"] = vertex, int(figure.mirror[vertex])
    for side, part in (("L", "left"), ("R", "right")):
        out[f"pupil_{side}"] = figure.body.size + (0 if part == "left" else 386)
    return out
