"""A fitted person without photographs or nets: known body, own poses, own outlines as the fit would have found them."""

from __future__ import annotations

import functools

import numpy as np

from cloner.frames import BODY_VIEWS
from cloner.generic.features import named_features
from cloner.generic.load import load_generic
from cloner.geometry.articulation.skinning import joint_transforms, linear_blend_skinning
from cloner.geometry.outlines.silhouette import fill_triangles
from cloner.records.bodies import PosedView
from cloner.records.clones import Joined
from cloner.records.points import PointSet, ViewPoints
from cloner.records.silhouettes import SilhouetteSet
from kit import people, studio


def seen(person, view):
    """Return the (V, 2) pixels of a joined person's vertices as a photo shows them."""
    generic, posed = load_generic(), person.views[view]
    moved = joint_transforms(person.joints_m, generic.joint_parents, posed.rotations)
    return posed.camera.project(
        linear_blend_skinning(person.vertices_m, moved, generic.skin_joints, generic.skin_weights)
    )


def joint_px(person, view, name):
    """Return the (2,) pixel of a joint as a photo shows it."""
    generic, posed = load_generic(), person.views[view]
    moved = joint_transforms(person.joints_m, generic.joint_parents, posed.rotations)[generic.joint(name)]
    return posed.camera.project((moved[:3, :3] @ person.joints_m[generic.joint(name)] + moved[:3, 3])[None])[0]


def mask(person, view):
    """Return the (H, W) filled picture of a joined person."""
    camera = person.views[view].camera
    return fill_triangles(seen(person, view), people.skin_triangles(), (camera.height_px, camera.width_px)) > 0


@functools.cache
def fitted_person(seed=3, *, stature_m=1.72):
    """Return a joined person, the points proposed for the three body photos, and the outlines, all exact."""
    generic = load_generic()
    known = people.known_person(seed, stature_m=stature_m, spread=0.7)
    views = {
        view: PosedView(view, studio.camera(studio.AZIMUTH_DEG[view]), people.known_pose(seed + number))
        for number, view in enumerate(BODY_VIEWS)
    }
    empty = np.zeros(0)
    person = Joined(
        known.vertices_m, known.joints_m, views, (), empty.astype(np.int32), np.zeros((0, 3), np.float32),
        np.zeros(1, np.int32), named_features(generic, known.vertices_m), stature_m, 0.0,
    )  # fmt: skip
    points, outlines = {}, {}
    for view in views:
        vertices, joints = known.posed(views[view].rotations)
        named = people.exact_points(vertices, joints, view, views[view].camera)
        picture = mask(person, view)
        rows = np.flatnonzero(picture.any(axis=1))
        named["head_top"] = np.array([np.flatnonzero(picture[rows[0]]).mean(), rows[0]])
        for side in ("left", "right"):
            named[f"sole_{side}"] = np.array([named[f"{side[0]}_ankle"][0], rows[-1]])
        count = len(named)
        points[view] = ViewPoints(
            view, tuple(named), np.array(list(named.values())), np.full(count, 0.7), np.zeros(count, bool)
        )
        outlines[view] = studio.silhouette_record(view, picture)
    return person, PointSet(points), SilhouetteSet(outlines)
