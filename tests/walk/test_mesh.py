"""A real clone is one sound surface that does not go through itself at rest, with arms level or with UVs."""

import numpy as np
import pytest

from cloner.cloning import CloneOutcome
from cloner.evaluate.measures.crossings import buried_depths, self_intersections
from cloner.generic.load import load_generic
from cloner.generic.surfaces import load_surfaces, load_triangles
from cloner.geometry.articulation.skinning import joint_transforms, linear_blend_skinning
from cloner.geometry.meshes.triangles import areas, edges_of
from cloner.motion.flesh.rest import t_pose
from cloner.motion.limbs.body import body_of
from cloner.motion.limbs.rig import centre_joints

pytestmark = pytest.mark.slow


def sitting() -> np.ndarray:
    """Return (94, 3) rotation vectors of a person on a chair: thighs level, calves down."""
    rotations = np.zeros((94, 3))
    names = [str(name) for name in load_generic().joint_names]
    for side in "lr":
        rotations[names.index(f"{side}_hip"), 0] = -np.pi / 2
        rotations[names.index(f"{side}_knee"), 0] = np.pi / 2
    return rotations


def test_sitting_down_folds_no_skin_deep_into_the_body(cloned_anna: CloneOutcome) -> None:
    generic, clone = load_generic(), centre_joints(cloned_anna.values["clone"])
    transforms = joint_transforms(clone.joints_m, generic.joint_parents.astype(np.int32), sitting())
    points = linear_blend_skinning(
        clone.vertices_m, transforms, generic.skin_joints, generic.skin_weights.astype(np.float64)
    )
    triangles = load_triangles()[(generic.vertex_part[load_triangles()] == 0).all(axis=1)]
    found = self_intersections(points, triangles)
    assert buried_depths(points, triangles, found).max() < 0.008, "metres; 60 mm with the rig's own weights"


@pytest.mark.parametrize("pose", ["rest", "T"])
def test_skin_stays_out_of_skin(cloned_anna: CloneOutcome, pose: str) -> None:
    generic, clone = load_generic(), centre_joints(cloned_anna.values["clone"])
    rotations = np.zeros((94, 3)) if pose == "rest" else t_pose(body_of(clone))
    transforms = joint_transforms(clone.joints_m, generic.joint_parents.astype(np.int32), rotations)
    points = linear_blend_skinning(
        clone.vertices_m, transforms, generic.skin_joints, generic.skin_weights.astype(np.float64)
    )
    triangles = load_triangles()[(generic.vertex_part[load_triangles()] == 0).all(axis=1)]
    found = self_intersections(points, triangles)  # some 35 are slivers on an evened shoe's tip, .12 mm deep at most
    pressed = (generic.region("lips") | generic.region("mouth_interior"))[triangles].any(axis=1)
    assert (~pressed[found.pairs].all(axis=1)).sum() <= 60, "two thousand with folded toes"
    assert buried_depths(points, triangles, found).max() < 0.002, "metres"


def test_the_skin_is_closed_and_nothing_is_degenerate(cloned_anna: CloneOutcome) -> None:
    body = load_surfaces()[0]
    triangles = body.vertex[body.triangles]
    assert edges_of(triangles)[1].min() == 2
    assert areas(cloned_anna.values["clone"].vertices_m, triangles).min() > 1e-8, "square metres"
    for surface in load_surfaces():
        assert surface.uv.min() >= 0.0
        assert surface.uv.max() <= 1.0
