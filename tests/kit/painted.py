"""Unlit photographs of painted people, by the painter's algorithm."""

import cv2
import numpy as np

from cloner.frames import ViewId
from cloner.generic.load import load_generic
from cloner.geometry.articulation.skinning import joint_transforms, linear_blend_skinning
from cloner.records.bodies import PosedView
from cloner.records.clones import Joined
from kit import people, studio

BODY = ("body_front", "body_side", "body_back")


def draw(vertices_m, triangles, colours, seen_by, *, background=(90, 140, 90)):
    """Return the (H, W, 3) picture of triangles with their own flat colours (T, 3), nearest on top."""
    depth = seen_by.to_camera(vertices_m[triangles].mean(axis=1))[:, 2]
    pixels = np.round(seen_by.project(vertices_m) * 16).astype(np.int32)
    drawn = np.empty((seen_by.height_px, seen_by.width_px, 3), np.uint8)
    drawn[:] = background
    for row in np.argsort(-depth):
        cv2.fillConvexPoly(drawn, pixels[triangles[row]], [int(c) for c in colours[row]], cv2.LINE_8, 4)
    return drawn


def joined(person, rotations_of_view, cameras=None):
    """Return a perfect fit of a known person with naked soles on the floor."""
    views = {
        ViewId(view): PosedView(ViewId(view), (cameras or {}).get(view) or studio.camera(studio.AZIMUTH_DEG[view]), r)
        for view, r in rotations_of_view.items()
    }
    return Joined(
        person.vertices_m, person.joints_m, views, (), np.zeros(0, np.int32), np.zeros((0, 3), np.float32),
        np.zeros(1, np.int32), {}, person.stature_m, 0.0,
    )  # fmt: skip


def posed(fit, view):
    """Return the vertices (V, 3) of a fit in one view's pose."""
    generic = load_generic()
    moved = joint_transforms(fit.joints_m, generic.joint_parents, fit.views[ViewId(view)].rotations)
    return linear_blend_skinning(fit.vertices_m, moved, generic.skin_joints, generic.skin_weights.astype(float))


def photograph(fit, colour_of_vertex, view, *, before=None):
    """Return picture (H, W, 3) and mask (H, W) of a person painted by vertex; ``before`` are vertices, triangles and
    colour of a thing that hangs there.
    """
    triangles = people.skin_triangles()
    colours = colour_of_vertex[triangles].mean(axis=1)
    vertices, seen_by = posed(fit, view), fit.views[ViewId(view)].camera
    if before is not None:
        places, faces, colour = before
        triangles, vertices = np.vstack([triangles, faces + len(vertices)]), np.vstack([vertices, places])
        colours = np.vstack([colours, np.tile(np.float64(colour), (len(faces), 1))])
    mask = studio.silhouette(vertices, triangles, seen_by)
    return draw(vertices, triangles, colours, seen_by), mask
