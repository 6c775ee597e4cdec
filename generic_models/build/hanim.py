"""The 94 joints of H-Anim 1.1, the 15 skin segments and where each joint sits in hm08."""

from __future__ import annotations

import numpy as np
from scipy.interpolate import CubicSpline
from source import FloatArray, IntArray

SEGMENTS = (
    "head",
    "torso",
    "pelvis",
    "left_upper_arm",
    "right_upper_arm",
    "left_forearm",
    "right_forearm",
    "left_hand",
    "right_hand",
    "left_thigh",
    "right_thigh",
    "left_calf",
    "right_calf",
    "left_foot",
    "right_foot",
)

LUMBAR_UP = [f"vl{i}" for i in range(5, 0, -1)] + [f"vt{i}" for i in range(12, 0, -1)]
CERVICAL_UP = [f"vc{i}" for i in range(7, 0, -1)]
# Heights of the vertebrae in the H-Anim 1.1 centre table, metres: only their proportions are used here.
VERTEBRA_Y = dict(
    zip(
        [*LUMBAR_UP, *CERVICAL_UP, "skullbase"],
        (
            1.0568,
            1.0925,
            1.1276,
            1.1546,
            1.1912,
            1.2278,
            1.2679,
            1.2848,
            1.3126,
            1.3382,
            1.3625,
            1.3866,
            1.4102,
            1.4320,
            1.4583,
            1.4761,
            1.4951,
            1.5132,
            1.5357,
            1.5520,
            1.5662,
            1.5800,
            1.5928,
            1.6144,
            1.6209,
        ),
        strict=True,
    )
)


def _side(letter: str) -> tuple[list[tuple[str, str]], list[tuple[str, str]], list[tuple[str, str]]]:
    """Return (joint, parent) rows of one leg, one eye and one arm."""
    p = f"{letter}_"
    leg = [(p + "hip", "sacroiliac")]
    for child, parent in (
        ("knee", "hip"),
        ("ankle", "knee"),
        ("subtalar", "ankle"),
        ("midtarsal", "subtalar"),
        ("metatarsal", "midtarsal"),
    ):
        leg.append((p + child, p + parent))
    eye = [(p + n, "skullbase") for n in ("eyeball_joint", "eyelid_joint", "eyebrow_joint")]
    arm = [
        (p + "sternoclavicular", "vt1"),
        (p + "acromioclavicular", p + "sternoclavicular"),
        (p + "shoulder", p + "acromioclavicular"),
        (p + "elbow", p + "shoulder"),
        (p + "wrist", p + "elbow"),
    ]
    for finger, first in (("thumb", 1), ("index", 0), ("middle", 0), ("ring", 0), ("pinky", 0)):
        parent = p + "wrist"
        for number in range(first, 4):
            arm.append((f"{p}{finger}{number}", parent))
            parent = f"{p}{finger}{number}"
    return leg, eye, arm


def _tree() -> list[tuple[str, str]]:
    left, right = _side("l"), _side("r")
    spine = [*LUMBAR_UP, *CERVICAL_UP, "skullbase"]
    return [
        ("HumanoidRoot", ""),
        ("sacroiliac", "HumanoidRoot"),
        *left[0],
        *right[0],
        *zip(spine, ["HumanoidRoot", *spine[:-1]], strict=True),
        *left[1],
        *right[1],
        ("temporomandibular", "skullbase"),
        *left[2],
        *right[2],
    ]


JOINTS: tuple[tuple[str, str], ...] = tuple(_tree())
NAMES = tuple(name for name, _ in JOINTS)
INDEX = {name: i for i, name in enumerate(NAMES)}
PARENTS = np.array([INDEX.get(parent, -1) for _, parent in JOINTS], dtype=np.int32)


def segment_of_joint(name: str) -> str:
    """Return the coarse skin segment that a joint's skin belongs to."""
    if name in ("HumanoidRoot", "sacroiliac"):
        return "pelvis"
    bare = name.removeprefix("l_").removeprefix("r_")
    side = {"l_": "left_", "r_": "right_"}.get(name[:2], "")
    limbs = {"hip": "thigh", "knee": "calf", "shoulder": "upper_arm", "elbow": "forearm"}
    if side and bare in limbs:
        return side + limbs[bare]
    if bare in ("ankle", "subtalar", "midtarsal", "metatarsal"):
        return side + "foot"
    if bare == "wrist" or bare[:-1] in ("thumb", "index", "middle", "ring", "pinky"):
        return side + "hand"
    if bare in ("sternoclavicular", "acromioclavicular") or name[:2] in ("vl", "vt"):
        return "torso"
    return "head"


def _limb_recipe(side: str) -> dict[str, dict[str, float]]:
    """Return one side's joints as weighted sums of named centres (joint cubes without their prefix, or #vertex)."""
    j = f"{side}_"
    c = f"{side}-"
    brow = "#6996" if side == "l" else "#222"  # middle of the brow on the skin; checked against hm08.mirror
    toes = [f"{c}toe-{n}-1" for n in range(1, 6)]
    recipe: dict[str, dict[str, float]] = {
        j + "hip": {c + "upper-leg": 1},
        j + "knee": {c + "knee": 1},
        j + "ankle": {c + "ankle": 1},
        j + "subtalar": {c + "ankle": 0.65, c + "foot-1": 0.35},
        j + "midtarsal": {c + "ankle": 0.45, **{t: 0.11 for t in toes}},
        j + "metatarsal": {t: 0.2 for t in toes},
        j + "eyeball_joint": {c + "eye": 1},
        j + "eyelid_joint": {c + "eye": 1},
        j + "eyebrow_joint": {brow: 0.85, "head-2": 0.15},
        j + "sternoclavicular": {c + "clavicle": 1},
        j + "acromioclavicular": {c + "scapula": 1},
        j + "shoulder": {c + "shoulder": 1},
        j + "elbow": {c + "elbow": 1},
        j + "wrist": {c + "hand": 1},
    }
    for n in range(1, 4):
        recipe[f"{j}thumb{n}"] = {f"{c}finger-1-{n}": 1}
    for row, finger in enumerate(("index", "middle", "ring", "pinky")):
        recipe[f"{j}{finger}0"] = {c + "hand-3": 1 - row / 3, c + "hand-2": row / 3}
        for n in range(1, 4):
            recipe[f"{j}{finger}{n}"] = {f"{c}finger-{row + 2}-{n}": 1}
    return recipe


def _spine_recipe(cube_y: dict[str, float]) -> dict[str, dict[str, float]]:
    """Return vertebrae as weights of a cubic spline through the rig's spine centres; linear, so valid for any shape."""
    controls = ("pelvis", "spine-4", "spine-3", "spine-2", "spine-1", "neck", "head")
    low, high = cube_y["spine-4"], cube_y["neck"]
    bottom, top = VERTEBRA_Y["vl5"], VERTEBRA_Y["vc7"]
    knots = [bottom + (cube_y[c] - low) / (high - low) * (top - bottom) for c in controls[:-1]]
    knots.append(VERTEBRA_Y["skullbase"])
    weights = CubicSpline(knots, np.eye(len(controls)), bc_type="natural")(list(VERTEBRA_Y.values()))
    return {name: dict(zip(controls, row.tolist(), strict=True)) for name, row in zip(VERTEBRA_Y, weights, strict=True)}


def joint_regressor(groups: dict[str, IntArray], vertices_m: FloatArray) -> FloatArray:
    """Return the (94, 19158) matrix that gives the joint centres from the full hm08 vertices.

    Parameters
    ----------
    groups : vertex groups of hm08, joint cubes among them.
    vertices_m : (19158, 3) the undeformed mesh.
    """
    cube_y = {
        k.removeprefix("joint-"): float(vertices_m[v, 1].mean()) for k, v in groups.items() if k.startswith("joint-")
    }
    recipe = {
        "HumanoidRoot": {"pelvis": 0.6, "l-upper-leg": 0.2, "r-upper-leg": 0.2},
        "sacroiliac": {"pelvis": 0.65, "spine-4": 0.35},
        "temporomandibular": {"mouth": 1.0},
        **_spine_recipe(cube_y),
        **_limb_recipe("l"),
        **_limb_recipe("r"),
    }
    matrix = np.zeros((len(NAMES), vertices_m.shape[0]))
    for name, parts in recipe.items():
        for centre, weight in parts.items():
            rows = np.array([int(centre[1:])]) if centre[0] == "#" else groups[f"joint-{centre}"]
            matrix[INDEX[name], rows] += weight / rows.size
    return matrix
