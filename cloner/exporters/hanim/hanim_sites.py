"""Sites of the H-Anim standard on a clone: anthropometric points and ends of limbs.

Each is one vertex of the generic human, found once by what anatomy says of the point: an end of a bone is where the
skin is reached from a joint in some direction. Where the standard knows a height only by its own figure, the place
between two joints is that figure's. A clone's sites lie on its surface, which is cloth where it wears some. The points
named by ISO 7250-1 are CAESAR's; their left and right are mirrored.

References
----------
Humanoid Animation Working Group 1999, H-Anim 1.1, section 5 and its tables of feature points; ISO/IEC 19774-1:2019,
table of feature points (names of version 2); ISO 7250-1:2017, clause 5 (what the points mean).
"""

from __future__ import annotations

import functools
from dataclasses import dataclass
from typing import Final

import numpy as np
from numpy.typing import NDArray
from scipy.spatial import cKDTree

from cloner.exporters.hanim.hanim_names import identifier
from cloner.exporters.hanim.partition import dominant_joint
from cloner.generic.load import GenericHuman, load_generic
from cloner.records.arrays import Array
from cloner.records.clones import Clone

Ints = NDArray[np.integer]

#: How far from a ray skin may lie to be where it leaves the body, metres: half of a ring on the trunk.
_BEAM_M: Final = 0.014
_X, _Y, _Z = np.eye(3)
#: Features of ours that are the standard's under other names.
_OURS: Final = (
    "head_top",
    "nasion",
    "fingertip_left",
    "fingertip_right",
    "toe_left",
    "toe_right",
    "acromion_L",
    "acromion_R",
)
#: Names of sites that version 2 of the standard spells otherwise, without side.
_NAMES_2: Final = {
    "skull_tip": "skull_vertex_tip",
    "clavicale_pt": "clavicle_pt",
    "waist_preferred_post_pt": "waist_preferred_posterior_pt",
    "axilla_ant_pt": "axilla_distal_pt",
    "axilla_post_pt": "axilla_proximal_pt",
    "humeral_lateral_epicn_pt": "humeral_lateral_epicondyle_pt",
    "humeral_medial_epicn_pt": "humeral_medial_epicondyle_pt",
    "metacarpal_pha2_pt": "metacarpal_phalanx_2_pt",
    "metacarpal_pha5_pt": "metacarpal_phalanx_5_pt",
    "femoral_lateral_epicn_pt": "femoral_lateral_epicondyle_pt",
    "femoral_medial_epicn_pt": "femoral_medial_epicondyle_pt",
    "metatarsal_pha5_pt": "metatarsal_phalanx_5_pt",
    "metatarsal_pha1_pt": "metatarsal_phalanx_1_pt",
    "calcaneous_post_pt": "calcaneus_posterior_pt",
    "digit2_pt": "tarsal_distal_phalanx_2_pt",
    "thumb_distal_tip": "carpal_distal_phalanx_1_tip",
    "index_distal_tip": "carpal_distal_phalanx_2_tip",
    "middle_distal_tip": "carpal_distal_phalanx_3_tip",
    "ring_distal_tip": "carpal_distal_phalanx_4_tip",
    "pinky_distal_tip": "carpal_distal_phalanx_5_tip",
}


@dataclass(frozen=True, slots=True)
class Site:
    """A site of the standard.

    Attributes
    ----------
    name : str, of H-Anim 1.1, with the ending "_pt" of a feature point or "_tip" of a limb's end
    joint : int, the one that carries its segment
    vertex : int, of the generic human
    """

    name: str
    joint: int
    vertex: int


def name_2(site: str) -> str:
    """Return the name that version 2 of the standard (ISO/IEC 19774:2019) has for a site of version 1.1."""
    side = site[:2] if site[:2] in ("l_", "r_") else ""
    bare = site.removeprefix(side)
    return side + _NAMES_2.get(bare, bare)


def placed_sites(clone: Clone) -> list[tuple[str, int, Array]]:
    """Return name, joint and place (3,) in metres of all sites of a clone: the standard's, then features of ours.

    A feature hangs on the segment of the nearest skin, and has its own name and "_pt" where the standard knows none.
    """
    found = [(site.name, site.joint, clone.vertices_m[site.vertex]) for site in standard_sites()]
    names = {site.name for site in standard_sites()}
    own = [(f"{identifier(name)}_pt", place) for name, place in clone.features_m.items() if name not in _OURS]
    own = [(name, place) for name, place in own if name not in names]
    if own:
        generic = load_generic()
        dominant = dominant_joint(generic.skin_joints, generic.skin_weights)
        _, nearest = cKDTree(clone.vertices_m).query(np.array([place for _, place in own]))
        found += [(name, int(dominant[row]), place) for (name, place), row in zip(own, nearest, strict=True)]
    return found


@functools.cache
def standard_sites() -> tuple[Site, ...]:
    """Return all sites of the standard that mark a point of the body: 76 feature points and 13 ends."""
    generic = load_generic()
    figure = _Figure(generic)
    found = []
    for name, joint, vertex in (*_middle(figure), *_head(figure), *_trunk(figure), *_arm(figure), *_leg(figure)):
        if not name.startswith("l_"):
            found.append(Site(name, generic.joint(joint), vertex))
            continue
        for side, own in (("l_", vertex), ("r_", int(generic.mirror[vertex]))):
            carrier = side + joint.removeprefix("l_") if joint.startswith("l_") else joint
            found.append(Site(side + name.removeprefix("l_"), generic.joint(carrier), own))
    return tuple(found)


class _Figure:
    """The generic human with the one question that sites ask of it."""

    def __init__(self, generic: GenericHuman) -> None:
        self.generic = generic
        self.body = generic.part("body")
        self.points = np.asarray(generic.vertices_m, np.float64)[self.body]
        self.segment = generic.vertex_segment[self.body]

    def joint(self, name: str) -> Array:
        return np.asarray(self.generic.joints_m[self.generic.joint(name)], np.float64)

    def at(self, feature: str) -> Array:
        return np.asarray(self.generic.vertices_m[self.generic.feature(feature)], np.float64)

    def inside(self, *segments: str) -> Ints:
        """Return the rows of the body's vertices that belong to segments."""
        return np.flatnonzero(np.isin(self.segment, [self.generic.segment_names.index(name) for name in segments]))

    def exit(self, start: Array, direction: Array, *segments: str) -> int:
        """Return the vertex where a ray from inside leaves the skin of segments."""
        rows = self.inside(*segments)
        away = direction / np.linalg.norm(direction)
        offset = self.points[rows] - start
        along = offset @ away
        beside = np.linalg.norm(offset - along[:, None] * away, axis=1)
        nearest = np.flatnonzero((beside < max(_BEAM_M, 1.05 * beside[along > 0.0].min())) & (along > 0.0))
        return int(self.body[rows[nearest[(along - 2.0 * beside)[nearest].argmax()]]])

    def nearest(self, place: Array, *segments: str) -> int:
        """Return the vertex of segments next to a place."""
        rows = self.inside(*segments)
        return int(self.body[rows[np.linalg.norm(self.points[rows] - place, axis=1).argmin()]])

    def farthest(self, direction: Array, among: Ints) -> int:
        """Return the vertex of some rows that lies farthest in a direction."""
        return int(self.body[among[(self.points[among] @ direction).argmax()]])


_Rows = tuple[tuple[str, str, int], ...]
_TRUNK: Final = ("torso", "pelvis")


def _middle(figure: _Figure) -> _Rows:
    """Return name, joint and vertex of the points of the middle plane."""
    feature = figure.generic.feature
    chin, lip = figure.at("chin_front"), figure.at("lip_bottom")
    ribs, waist = _ribs(figure), figure.at("waist_back")
    return (
        ("skull_tip", "skullbase", feature("head_top")),
        ("sellion_pt", "skullbase", feature("nasion")),
        ("supramenton_pt", "skullbase", figure.nearest((chin + lip) / 2.0 - 0.004 * _Z, "head")),  # its hollow
        ("nuchale_pt", "skullbase", figure.exit(figure.joint("skullbase"), -_Z, "head", "torso")),
        ("suprasternale_pt", "vt1", feature("neck_front_base")),
        ("substernale_pt", "vt10", figure.exit(figure.joint("vt10"), _Z, *_TRUNK)),
        ("cervicale_pt", "vt1", feature("nape")),
        ("rib10_midspine_pt", "vl2", figure.exit(ribs * [0.0, 1.0, 1.0], -_Z, *_TRUNK)),
        ("waist_preferred_post_pt", "vl5", feature("waist_back")),
        ("crotch_pt", "sacroiliac", feature("crotch")),
        ("navel_pt", "vl5", figure.exit(waist * [0.0, 0.7, 1.0] + 0.3 * figure.joint("vl5") * _Y, _Z, *_TRUNK)),
    )


def _head(figure: _Figure) -> _Rows:
    """Return the left points of head and neck; the orbit's rim lies a third of the way from pupil to nostril."""
    feature, skull = figure.generic.feature, "skullbase"
    corner = feature("2.13")
    # Where the ear's upper and lower end meet the face.
    upper, lower = (np.asarray(figure.generic.vertices_m[feature(name)]) for name in ("10.9", "10.7"))
    pupil, nostril = figure.at("pupil_L"), figure.at("ala_L")
    rim = np.array([pupil[0], pupil[1] + (nostril[1] - pupil[1]) / 3.0, pupil[2] - 0.02])
    return (
        ("l_infraorbitale_pt", skull, figure.exit(rim, _Z, "head")),
        ("l_tragion_pt", skull, figure.nearest((upper + lower) / 2.0, "head")),
        ("l_gonion_pt", skull, corner),
        ("l_neck_base_pt", "vc7", feature("neck_base_L")),
    )


def _ribs(figure: _Figure) -> Array:
    """Return the middle of the trunk at the tenth rib: a third of the way from the waist up to the tenth vertebra."""
    return figure.joint("vl2") * [1.0, 0.0, 1.0] + (2.0 * figure.at("waist_back") + figure.joint("vt10")) / 3.0 * _Y


def _trunk(figure: _Figure) -> _Rows:
    """Return the left points of trunk and hip; heights between hip joint and waist as on the standard's figure."""
    feature = figure.generic.feature
    hip, knee, waist = figure.joint("l_hip"), figure.joint("l_knee"), figure.at("waist_back")
    armpit = figure.at("armpit_left")
    collar = figure.at("neck_front_base") + 0.02 * _X + 0.01 * _Y  # beside and over the notch between the collar bones

    def over_hip(share: float, sideways: float) -> Array:
        """Return a place of the middle depth, some share of the way from hip joint to waist, so wide as the hips."""
        return np.array([sideways * hip[0], hip[1] + share * (waist[1] - hip[1]), hip[2]])

    ribs = _ribs(figure)
    below = hip + 0.17 * (knee - hip)  # the great trochanter's side, as far as the figure has it below the joint
    return (
        ("l_clavicale_pt", "l_sternoclavicular", figure.nearest(collar, "torso", "head")),
        ("l_thelion_pt", "vt9", feature("chest_front")),
        ("l_rib10_pt", "vl2", figure.exit(ribs, 0.65 * _X + 0.76 * _Z, *_TRUNK)),
        ("l_asis_pt", "sacroiliac", figure.exit(over_hip(0.50, 0.95), _Z, *_TRUNK, "left_thigh")),
        ("l_iliocristale_pt", "sacroiliac", figure.exit(over_hip(0.82, 0.95), _X, *_TRUNK)),
        ("l_psis_pt", "sacroiliac", figure.exit(over_hip(0.59, 0.45), -_Z, *_TRUNK)),
        ("l_trochanterion_pt", "sacroiliac", figure.exit(below, _X, "pelvis", "left_thigh")),
        ("l_acromion_pt", "l_sternoclavicular", feature("acromion_L")),
        ("l_axilla_ant_pt", "l_sternoclavicular", figure.exit(armpit + 0.02 * _Y, _Z, "torso", "left_upper_arm")),
        ("l_axilla_post_pt", "l_sternoclavicular", figure.exit(armpit + 0.02 * _Y, -_Z, "torso", "left_upper_arm")),
    )


def _arm(figure: _Figure) -> _Rows:
    """Return the left points of arm and hand: thumb's and little finger's side as the resting hand has them."""
    shoulder, elbow, wrist = (figure.joint(f"l_{name}") for name in ("shoulder", "elbow", "wrist"))
    upper, lower = (
        (elbow - shoulder) / np.linalg.norm(elbow - shoulder),
        (wrist - elbow) / np.linalg.norm(wrist - elbow),
    )
    back = upper - lower  # where the bent elbow points
    hinge = np.cross(upper, lower)  # forearm bends forwards about it: from the body's side outwards, or the reverse
    thumb = _across(figure.joint("l_index0") - figure.joint("l_pinky0"), lower)
    outer = hinge if hinge @ thumb > 0.0 else -hinge
    limb, hand = ("left_upper_arm", "left_forearm"), ("left_forearm", "left_hand")
    knuckles = _across(figure.joint("l_index1") - figure.joint("l_pinky1"), figure.joint("l_middle1") - wrist)
    ends = tuple((f"l_{name}_distal_tip", f"l_{name}3", _fingertip(figure, name))
                 for name in ("thumb", "index", "middle", "ring", "pinky"))  # fmt: skip
    return (
        ("l_humeral_lateral_epicn_pt", "l_shoulder", figure.exit(elbow, outer, *limb)),
        ("l_humeral_medial_epicn_pt", "l_elbow", figure.exit(elbow, -outer, *limb)),
        ("l_olecranon_pt", "l_elbow", figure.exit(elbow, back, *limb)),
        ("l_radiale_pt", "l_elbow", figure.exit(elbow + 0.02 * lower, outer, *limb)),  # the head of the radius
        ("l_radial_styloid_pt", "l_elbow", figure.exit(wrist, thumb, *hand)),
        ("l_ulnar_styloid_pt", "l_wrist", figure.exit(wrist, -thumb, *hand)),
        ("l_metacarpal_pha2_pt", "l_wrist", figure.exit(figure.joint("l_index1"), knuckles, "left_hand")),
        ("l_metacarpal_pha5_pt", "l_wrist", figure.exit(figure.joint("l_pinky1"), -knuckles, "left_hand")),
        ("l_dactylion_pt", "l_index3", _fingertip(figure, "middle")),
        *ends,
    )


def _across(direction: Array, along: Array) -> Array:
    """Return what of a direction is at right angles to another."""
    return direction - along * float(direction @ along) / float(along @ along)


def _fingertip(figure: _Figure, finger: str) -> int:
    """Return the farthest vertex of a left finger along its last bone."""
    generic, last = figure.generic, figure.generic.joint(f"l_{finger}3")
    share = np.where(generic.skin_joints[figure.body] == last, generic.skin_weights[figure.body], 0.0).sum(axis=1)
    return figure.farthest(figure.joint(f"l_{finger}3") - figure.joint(f"l_{finger}2"), np.flatnonzero(share > 0.5))


def _leg(figure: _Figure) -> _Rows:
    """Return the left points of knee and foot."""
    feature, ball = figure.generic.feature, figure.joint("l_metatarsal")
    foot = figure.inside("left_foot")
    inner = figure.at("ankle_inner_left")
    return (
        ("l_knee_crease_pt", "l_hip", feature("knee_back_left")),
        ("l_femoral_lateral_epicn_pt", "l_hip", feature("knee_outer_left")),
        ("l_femoral_medial_epicn_pt", "l_hip", feature("knee_inner_left")),
        ("l_lateral_malleolus_pt", "l_ankle", feature("ankle_outer_left")),
        ("l_medial_malleolus_pt", "l_ankle", feature("ankle_inner_left")),
        ("l_sphyrion_pt", "l_ankle", figure.nearest(inner - 0.014 * _Y, "left_foot")),  # the malleolus' lower tip
        ("l_metatarsal_pha5_pt", "l_metatarsal", figure.exit(ball, _X, "left_foot")),
        ("l_metatarsal_pha1_pt", "l_midtarsal", figure.exit(ball, -_X, "left_foot")),
        ("l_calcaneous_post_pt", "l_ankle", feature("heel_left")),
        ("l_digit2_pt", "l_metatarsal", figure.farthest(_Z + 0.35 * _X, foot)),
        ("l_forefoot_tip", "l_metatarsal", feature("toe_left")),
    )
