"""Light on the tip of a shoe shows a shoe; bare toes stay toes."""

from __future__ import annotations

import cv2
import numpy as np
from scipy.spatial import ConvexHull, cKDTree

from cloner.body.feet import close_toes
from cloner.generic.load import load_generic
from cloner.generic.surfaces import load_triangles, surface_normals
from cloner.generic.toes import smooth_shoe_tips
from cloner.geometry.meshes.wedges import vertex_normals
from cloner.records.bodies import BodyMesh


def _toes() -> np.ndarray:
    generic = load_generic()
    own = np.where(generic.skin_joints == generic.joint("l_metatarsal"), generic.skin_weights, 0.0).sum(axis=1)
    return np.flatnonzero(own > 0.9)


def _shod() -> np.ndarray:
    generic = load_generic()
    return close_toes(BodyMesh(generic.vertices_m.astype(float), generic.joints_m.astype(float))).vertices_m


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


def _crumpled() -> np.ndarray:
    """Return the shod generic human with the toes' skin a third of a millimetre out of place, as fits leave it."""
    points = _shod().copy()
    generic = load_generic()
    own = np.concatenate([_toes(), generic.mirror[_toes()]])
    points[own] += np.random.default_rng(5).normal(0.0, 0.0003, (len(own), 3))
    return points


def _notched_mm2(points: np.ndarray) -> float:
    """Return the area of notches under 5 mm wide in the left tip's outlines, from the front and from below."""
    foot = load_generic().region("foot_left")
    triangles = load_triangles()[foot[load_triangles()].all(axis=1)]
    corners, toes = points[triangles], points[_toes()]
    disc, notches = cv2.getStructuringElement(cv2.MORPH_ELLIPSE, (51, 51)), 0
    for plane, begin, end in (([0, 1], 0.0, 0.02), ([0, 2], -0.03, 0.01)):
        edge = toes[:, 1].min() if plane[1] == 1 else toes[:, 2].max()
        low = np.array([toes[:, 0].min(), edge + begin]) - 0.01
        outline = np.zeros((int(1e4 * (end - begin + 0.01)), int(1e4 * (np.ptp(toes[:, 0]) + 0.02))), np.uint8)
        for flat in np.rint(1e4 * (corners[:, :, plane] - low)).astype(np.int32):
            cv2.fillConvexPoly(outline, flat, 1)
        closed = cv2.morphologyEx(outline, cv2.MORPH_CLOSE, disc)
        notches += int((closed - outline)[30:-30, 30:-30].sum())
    return notches / 100.0


def test_a_shoes_tip_is_smooth_as_long_as_before_and_stands_on_the_floor() -> None:
    rough = _crumpled()
    smooth = smooth_shoe_tips(rough)
    assert _notched_mm2(smooth) < 0.2 * _notched_mm2(rough)
    tips = [np.percentile(points[_toes(), 2], 95.0) for points in (smooth, rough)]
    assert abs(tips[0] - tips[1]) < 0.004, "metres; a hull's edges are sharper than those of fitted shoes"
    assert np.linalg.norm(smooth - rough, axis=1).max() < 0.012, "metres; sharp edges are rounded"
    assert smooth[:, 1].min() >= rough[:, 1].min()


def test_only_tips_of_shoes_are_evened() -> None:
    bare, generic = np.asarray(load_generic().vertices_m, float), load_generic()
    assert np.array_equal(smooth_shoe_tips(bare), bare)
    rough, joints = _crumpled(), [generic.joint(f"{side}_metatarsal") for side in "lr"]
    carried = np.where(np.isin(generic.skin_joints, joints), generic.skin_weights, 0.0).sum(axis=1)
    rest = carried <= 0.05
    assert np.array_equal(smooth_shoe_tips(rough)[rest], rough[rest])
