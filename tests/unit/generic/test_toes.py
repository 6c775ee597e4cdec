"""Light on the tip of a shoe shows a shoe; bare toes stay toes."""

from __future__ import annotations

import numpy as np
from scipy.spatial import ConvexHull, cKDTree

from cloner.body.feet import closed_toes
from cloner.generic.load import load_generic
from cloner.generic.surfaces import load_triangles, surface_normals
from cloner.geometry.meshes.wedges import vertex_normals
from cloner.records.bodies import BodyMesh


def _toes() -> np.ndarray:
    generic = load_generic()
    own = np.where(generic.skin_joints == generic.joint("l_metatarsal"), generic.skin_weights, 0.0).sum(axis=1)
    return np.flatnonzero(own > 0.9)


def _shod() -> np.ndarray:
    generic = load_generic()
    return closed_toes(BodyMesh(generic.vertices_m.astype(float), generic.joints_m.astype(float))).vertices_m


def _unlike(points: np.ndarray, normals: np.ndarray) -> float:
    """Return the mean angle between normals of vertices that lie within 3 mm of each other, degrees."""
    one, other = cKDTree(points).query_pairs(0.003, output_type="ndarray").T
    cosine = np.einsum("ij,ij->i", normals[one], normals[other])
    return float(np.degrees(np.arccos(np.clip(cosine, -1.0, 1.0))).mean())


def test_bare_toes_keep_the_normals_of_their_skin() -> None:
    bare = np.asarray(load_generic().vertices_m, float)
    plain, told = vertex_normals(bare, load_triangles()), surface_normals(bare)
    assert np.array_equal(plain[_toes()], told[_toes()])


def test_in_a_shoe_neighbours_look_the_same_way_and_outwards() -> None:
    points, toes = _shod(), _toes()
    plain, told = vertex_normals(points, load_triangles())[toes], surface_normals(points)[toes]
    assert np.abs(np.linalg.norm(told, axis=1) - 1.0).max() < 1e-9
    assert _unlike(points[toes], told) < 0.6 * _unlike(points[toes], plain)
    hull = ConvexHull(points[toes])
    away = hull.equations[:, :3][(points[toes] @ hull.equations[:, :3].T + hull.equations[:, 3]).argmax(axis=1)]
    ahead = points[toes][:, 2] > np.percentile(points[toes][:, 2], 60.0)  # the hull's back lies within the foot
    outwards = [np.median(np.einsum("ij,ij->i", own[ahead], away[ahead])) for own in (plain, told)]
    assert outwards[1] > max(0.85, outwards[0] - 0.05)


def test_all_else_keeps_its_normals() -> None:
    points = _shod()
    generic = load_generic()
    joints = [generic.joint(f"{side}_metatarsal") for side in "lr"]
    carried = np.where(np.isin(generic.skin_joints, joints), generic.skin_weights, 0.0).sum(axis=1)
    teeth = np.isin(generic.vertex_part, [generic.part_names.index(f"teeth_{jaw}") for jaw in ("upper", "lower")])
    rest = (carried <= 0.5) & ~teeth
    assert np.array_equal(vertex_normals(points, load_triangles())[rest], surface_normals(points)[rest])
