"""Lengths and errors in millimetres, measured on meshes of the generic human's topology."""

import numpy as np

from cloner.generic.load import load_generic
from cloner.generic.tape import load_tape_rules
from cloner.geometry.measurement.measures import slice_points


def lengths_mm(vertices_m, joints_m):
    """Return stature, shoulder breadth, crotch height, waist width and depth of a rest pose, mm.

    Heights count from y = 0, the naked soles; shoes lie below.
    """
    generic = load_generic()
    rules = load_tape_rules()
    level = np.array([0.0, vertices_m[list(rules.level_vertices["waist"]), 1].mean(), 0.0])
    waist = slice_points(vertices_m, rules.torso, level, np.array([0.0, 1.0, 0.0]))
    shoulders = joints_m[generic.joint("l_shoulder")] - joints_m[generic.joint("r_shoulder")]
    return {
        "stature": 1000 * float(vertices_m[generic.part("body"), 1].max()),
        "shoulder_breadth": 1000 * float(np.linalg.norm(shoulders)),
        "crotch_height": 1000 * float(vertices_m[generic.feature("crotch"), 1]),
        "waist_width": 1000 * float(np.ptp(waist[:, 0])),
        "waist_depth": 1000 * float(np.ptp(waist[:, 2])),
    }


def describe(found, known):
    """Return one line that names every length with its error, for failure messages."""
    return ", ".join(f"{name} {found[name]:.0f} ({found[name] - known[name]:+.1f})" for name in known)
