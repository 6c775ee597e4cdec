"""How much of the visible surface carries its true label."""

from __future__ import annotations

from collections.abc import Mapping
from types import MappingProxyType
from typing import Final

import numpy as np
from numpy.typing import NDArray

from cloner.evaluate.measures.posing import PosedClone
from cloner.evaluate.measures.rulers import transform_points
from cloner.evaluate.measures.surfaces import TriangleSurface, visible_from_outside
from cloner.evaluate.truths.truth import TruthSurface
from cloner.generic.load import GenericHuman
from cloner.geometry.articulation.skinning import joint_transforms, linear_blend_skinning
from cloner.records.arrays import Array
from cloner.records.clones import Clone
from cloner.records.regions import REGIONS, SHELL_REGIONS

#: What a true part may be called. The truth's suits are one part each: both halves of the clothes are right.
RIGHT: Final[Mapping[str, tuple[str, ...]]] = MappingProxyType({
    "skin": ("skin", "mouth"),
    "hair": ("hair",),
    "eyes": ("eyes",),
    "shoes": ("shoes",),
    "clothes": ("upper_clothes", "lower_clothes"),
})  # fmt: skip
_SAMPLES: Final = 8_000  # moves the share by half a percent between seeds


def region_agreement(
    clone: Clone,
    generic: GenericHuman,
    posed: PosedClone,
    rotations: Array,
    truth_from_clone: Array,
    truth: TruthSurface,
    *,
    rng: np.random.Generator,
) -> float | None:
    """Return the share of the truth's visible labelled surface whose nearest place on the clone has that label.

    Parameters
    ----------
    clone : Clone
    generic : GenericHuman
    posed : Posed
        The clone's skin laid on the truth.
    rotations : (94, 3) float64
        The pose in which it lies there, rotation vectors in radians.
    truth_from_clone : (4, 4) float64, rigid
        The motion that laid it there.
    truth : TruthSurface
    rng : numpy Generator
        Draws the points that are asked.

    Returns
    -------
    float or None
        None for a clone or a truth without labels.
    """
    if not (len(clone.triangle_regions) and len(truth.label)):
        return None
    seen = visible_from_outside(truth.points_m, truth.normals, truth.points_m)
    asked = np.flatnonzero(seen & (truth.label != ""))
    asked = rng.choice(asked, size=min(_SAMPLES, len(asked)), replace=False)
    vertices, triangles, labels = _aligned_labelled_mesh(clone, generic, posed, rotations, truth_from_clone)
    _, _, nearest = TriangleSurface(vertices, triangles).closest(truth.points_m[asked])
    found, wanted = np.array(REGIONS)[labels[nearest]], truth.label[asked]
    return float(np.mean([name in RIGHT[label] for name, label in zip(found, wanted, strict=True)]))


def _aligned_labelled_mesh(
    clone: Clone, generic: GenericHuman, posed: PosedClone, rotations: Array, truth_from_clone: Array
) -> tuple[Array, NDArray[np.int32], NDArray[np.uint8]]:
    """Return vertices, triangles and labels of skin and shells, laid on the truth, as one mesh."""
    transforms = joint_transforms(clone.joints_m, generic.joint_parents.astype(np.int32), rotations)
    vertices, triangles, labels = (
        [posed.vertices_m],
        [generic.triangles()[0].astype(np.int32)],
        [clone.triangle_regions],
    )
    for shell in clone.shells:
        start = sum(map(len, vertices))
        loose = linear_blend_skinning(shell.vertices_m, transforms, shell.skin_joints, shell.skin_weights)
        vertices.append(transform_points(truth_from_clone, loose))
        triangles.append(shell.triangles + np.int32(start))
        labels.append(np.full(len(shell.triangles), REGIONS.index(SHELL_REGIONS[shell.kind]), dtype=np.uint8))
    return np.vstack(vertices), np.vstack(triangles), np.concatenate(labels)
