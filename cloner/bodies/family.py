"""The generic body family with a fixed head, which never follows a tape measure."""

from __future__ import annotations

import functools
from dataclasses import dataclass
from typing import Final

import numpy as np
from numpy.typing import NDArray
from scipy.sparse import csr_array

from cloner.bodies.children import GROWN, children
from cloner.generic.load import GENERIC_STATURE_M, GenericHuman, load_generic
from cloner.geometry.meshes.triangles import edges_of
from cloner.records.arrays import Array
from cloner.records.bodies import BodyMesh

#: Rounds in which a mode's displacements are averaged with their neighbours' (taste: no nipple turns over).
SMOOTHINGS: Final = 12
#: The head turns with the end of the neck: joints from here on go with it.
NECK: Final = ("vc7", "vc6", "vc5", "vc4", "vc3", "vc2", "vc1")


@dataclass(frozen=True, slots=True, eq=False)
class Family:
    """Bodies round one that is known, at its stature.

    Attributes
    ----------
    base : BodyMesh
        Soles on y = 0.
    modes_m : (C, V, 3) float32
        Metres a standard deviation; the head only goes aside with the neck, never up, and keeps its shape.
    joint_modes_m : (C, 94, 3)
    """

    base: BodyMesh
    modes_m: NDArray[np.float32]
    joint_modes_m: Array

    def body(self, coefficients: Array) -> BodyMesh:
        """Return the body of (C,) coefficients."""
        shift = np.tensordot(coefficients.astype(np.float32), self.modes_m, axes=1)
        joints = self.base.joints_m + np.tensordot(coefficients, self.joint_modes_m, axes=1)
        return BodyMesh(self.base.vertices_m + shift, joints)


def usual_coefficients(sex: str, age_years: float) -> Array:
    """Return (C,) the likeliest coefficients of a woman or girl ("f"), a man or boy ("m") of an age."""
    if age_years < GROWN:
        return children(sex).at(age_years)[0]
    generic = load_generic()
    rows = [generic.phenotype_names.index(name) for name in ("sex", "age_years")]
    facts = np.array([0.0 if sex == "f" else 1.0, age_years]) - generic.phenotype_mean[rows]
    slopes = generic.phenotype_from_shape[rows].astype(np.float64)
    return np.asarray(slopes.T @ np.linalg.solve(slopes @ slopes.T, facts))


def usual_body(sex: str, stature_m: float, age_years: float) -> BodyMesh:
    """Return the usual woman, man, girl or boy of a stature and an age."""
    generic, scale = load_generic(), stature_m / GENERIC_STATURE_M
    coefficients = usual_coefficients(sex, age_years)
    vertices, joints = generic.shape(coefficients, stature_m)
    if age_years < GROWN:  # a mean of drawn children, whole; adults are a line through theirs, heads apart
        return BodyMesh(vertices, joints)
    mean = BodyMesh(scale * generic.vertices_m.astype(np.float64), scale * generic.joints_m.astype(np.float64))
    own = round_body(mean, stature_m).body(coefficients)
    share, above = generic.head_blend.astype(np.float64)[:, None], head_joints(generic)[:, None]
    skull = generic.joint("skullbase")
    aside = (own.joints_m[skull] - joints[skull]) * [0.0, 0.0, 1.0]
    return BodyMesh(
        (1.0 - share) * own.vertices_m + share * (vertices + aside),
        (1.0 - above) * own.joints_m + above * (joints + aside),
    )


@functools.cache
def _frozen() -> tuple[NDArray[np.float32], Array]:
    """Return the family's modes (C, V, 3) and joint modes (C, 94, 3) at the generic stature, head and feet frozen.

    The head goes only forward and back with the end of the neck, feet only along the floor with the ankles.
    """
    generic = load_generic()
    modes = _smooth(generic, generic.shape_basis.astype(np.float64))
    joints = generic.joint_basis.astype(np.float64)
    head = (generic.head_blend.astype(np.float64), head_joints(generic), "skullbase", (0.0, 0.0, 1.0))
    feet = []
    for side in ("left", "right"):
        own = generic.share(f"{side}_foot")
        below = np.array([float(_is_below(generic, row, f"{side[0]}_ankle")) for row in range(len(joints[0]))])
        feet.append((own, below, f"{side[0]}_ankle", (1.0, 0.0, 1.0)))
    for share, joint_share, joint, axes in (head, *feet):
        carried = generic.joint_basis[:, generic.joint(joint)] * np.array(axes)
        modes = (1.0 - share)[:, None] * modes + share[:, None] * carried[:, None]
        joints = (1.0 - joint_share)[:, None] * joints + joint_share[:, None] * carried[:, None]
    return modes.astype(np.float32), joints


def _smooth(generic: GenericHuman, modes: Array) -> Array:
    """Return modes (C, V, 3) without what differs between neighbours: far from the mean that would turn skin over."""
    edges, _ = edges_of(generic.triangles()[0].astype(np.int32))
    ends = np.concatenate([edges, edges[:, ::-1]])
    count = modes.shape[1]
    links = csr_array((np.ones(len(ends)), (ends[:, 0], ends[:, 1])), shape=(count, count))
    around = np.maximum(np.asarray(links.sum(axis=1)).ravel(), 1.0)[:, None]
    flat = np.moveaxis(modes, 0, 1).reshape(count, -1)
    for _ in range(SMOOTHINGS):
        flat = 0.5 * flat + 0.5 * (links @ flat) / around
    fingers = generic.share("left_hand", "right_hand")[:, None]  # too thin to be averaged
    return np.asarray((1.0 - fingers) * np.moveaxis(flat.reshape(count, len(modes), 3), 1, 0) + fingers * modes)


def _is_below(generic: GenericHuman, row: int, name: str) -> bool:
    while row >= 0 and generic.joint_names[row] != name:
        row = int(generic.joint_parents[row])
    return row >= 0


def head_joints(generic: GenericHuman) -> Array:
    """Return the weight (94,) with which each joint belongs to the head: the neck's partly, those above fully."""
    shares = np.zeros(len(generic.joint_names))
    for row, name in enumerate(NECK):
        shares[generic.joint(name)] = row / len(NECK)
    for row, parent in enumerate(generic.joint_parents):
        above = int(parent) >= 0 and shares[parent] >= (len(NECK) - 1) / len(NECK)
        if generic.joint_names[row] == "skullbase" or above:
            shares[row] = 1.0
    return shares


def round_body(base: BodyMesh, stature_m: float) -> Family:
    """Return the family round a body of a stature."""
    modes, joints = _frozen()
    scale = stature_m / GENERIC_STATURE_M
    return Family(base, np.float32(scale) * modes, scale * joints)
