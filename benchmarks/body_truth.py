"""What is true of a painted random person, as the rulers of ``cloner.evaluate`` take it."""

from __future__ import annotations

import sys
from collections.abc import Mapping
from pathlib import Path
from typing import Any, Final

import numpy as np
from body_scores import HELD_OUT, KnownTruth
from numpy.typing import NDArray

from cloner.evaluate.measures.posing import JOINTS, turning_marks
from cloner.evaluate.measures.surfaces import sample_surface
from cloner.evaluate.truths.truth import TruthSurface, TruthView
from cloner.generic.load import load_generic
from cloner.generic.tape import load_tape_rules
from cloner.geometry.measurement.measures import girths_mm

sys.path.insert(0, str(Path(__file__).resolve().parents[1] / "generic_models" / "build"))
from painted_people import KnownPerson, Shot, photograph_person
from painted_people_clothes import CLOTH, HAIR, ORGAN, SHOE, SKIN, Dressed
from painted_people_pictures import rendered

__all__ = ["KnownPerson", "known_truth", "photograph", "true_view"]

Array = NDArray[np.float64]

KINDS: Final = {SKIN: "bare", CLOTH: "worn", HAIR: "hair", SHOE: "worn", ORGAN: "organ"}
#: Those of the marks that pose a clone which clothes cover.
TRUNK_MARKS: Final = ("acromion_L", "acromion_R", "neck_base_L", "neck_base_R", "crotch", "nape")
#: Joints that say how the trunk and the head are carried.
SPINE: Final = ("HumanoidRoot", "vl1", "vt6", "vc7", "skullbase")
#: Points on the true surface: 4.5 mm apart on average, under the disc that each stands for.
SURFACE_POINTS: Final = 100_000
#: Directions of the feet, by the names that the sample visitors' truth uses.
_SHOES: Final = {
    f"shoe_{part}_{side}": f"{part}_{name}"
    for part in ("toe", "heel")
    for side, name in (("L", "left"), ("R", "right"))
}


def photograph(seed: int, tightness: str, background: str) -> KnownPerson:
    """Return a random person with his photos; names as in the benchmark's tables."""
    chosen: Any = {"tightness": tightness, "background": background}
    return photograph_person(seed, **chosen)


def known_truth(known: KnownPerson) -> KnownTruth:
    """Return the truth of a painted person; its surface is in the front photo's pose."""
    front = known.shots["body_front"]
    coarse = known.dressed.vertices_m[: len(known.body.vertices_m)]  # splitting keeps the coarse vertices first
    return KnownTruth(
        stature_m=known.body.stature_m,
        girths_mm=known.girths_mm,
        dressed_girths_mm=girths_mm(coarse, known.body.joints_m, load_tape_rules()),
        surface=true_surface(known.dressed, front, np.random.default_rng([known.seed, 9])),
        views={name: true_view(shot) for name, shot in known.shots.items()},
        head_masks={name: head_mask(known.dressed, shot) for name, shot in known.shots.items()},
        points_px={name: true_points_px(shot, known.dressed) for name, shot in known.shots.items() if name != HELD_OUT},
        spine_m={name: front.joints_m[load_generic().joint(name)] for name in SPINE},
    )


def true_view(shot: Shot) -> TruthView:
    """Return the truth of one shot in the shot's own frame."""
    return TruthView(shot.name, shot.camera, marks_m(shot), joints_m(shot), {}, shot.mask, shot.rgb)


def joints_m(shot: Shot) -> dict[str, Array]:
    """Return the main joints under the truth's names."""
    generic = load_generic()
    return {name: shot.joints_m[generic.joint(ours)] for name, ours in JOINTS.items()}


def marks_m(shot: Shot) -> dict[str, Array]:
    """Return the named marks on the naked skin, and where the shoes point.

    Marks of the trunk lie on the clothes, as a clone's do: what poses it must not depend on how thick they are.
    """
    generic = load_generic()
    named = {name: shot.naked_m[generic.feature(name)] for name in generic.feature_names}
    named |= {name: shot.dressed_m[generic.feature(name)] for name in TRUNK_MARKS}
    named |= turning_marks(generic, shot.naked_m)
    return {**named, **{name: named[own] for name, own in _SHOES.items()}}


def true_points_px(shot: Shot, dressed: Dressed) -> Mapping[str, Array]:
    """Return the pixels of joint centres, of feature points on the dressed surface, and of the lowest shoe points."""
    generic = load_generic()
    joints = shot.camera.project(shot.joints_m)
    points = shot.camera.project(shot.dressed_m[generic.feature_vertices])
    named = {
        **dict(zip(generic.feature_names, points, strict=True)),
        **dict(zip(generic.joint_names, joints, strict=True)),
    }
    rows = np.flatnonzero(shot.mask.any(axis=1))
    named["head_top"] = np.array([named["head_top"][0], rows[0]])
    shoes = shot.camera.project(shot.dressed_m[dressed.kind == SHOE])
    left = dressed.vertices_m[dressed.kind == SHOE, 0] > 0.0
    return named | {
        f"sole_{name}": own[np.argmax(own[:, 1])] for name, own in (("left", shoes[left]), ("right", shoes[~left]))
    }


def true_surface(dressed: Dressed, shot: Shot, rng: np.random.Generator) -> TruthSurface:
    """Return points spread over the dressed person as one shot shows him."""
    triangles = dressed.triangles.astype(np.int32)
    points, normals, which = sample_surface(shot.dressed_m, triangles, SURFACE_POINTS, rng=rng)
    kinds = np.array([KINDS[kind] for kind in range(len(KINDS))])[dressed.kind[triangles[which, 0]]]
    return TruthSurface(
        points, normals, kinds, joints_m(shot), marks_m(shot), np.zeros((0, 3)), np.zeros((0, 3), np.int32)
    )


def head_mask(dressed: Dressed, shot: Shot) -> NDArray[np.bool_]:
    """Return the (H, W) pixels of a shot that show head or hair."""
    generic = load_generic()
    chin = float(dressed.vertices_m[generic.feature("chin_bottom"), 1])
    on_head = np.zeros(len(dressed.vertices_m))
    on_head[dressed.kind == HAIR] = 1.0
    above = dressed.vertices_m[:, 1] > chin
    arms = np.abs(dressed.vertices_m[:, 0]) > 0.13
    on_head[above & ~arms] = 1.0
    white = np.repeat(on_head[:, None], 3, axis=1)
    return np.asarray(rendered(shot.dressed_m, dressed.triangles, white, shot.camera)[..., 0] > 0.5)
