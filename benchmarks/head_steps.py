"""Fit one known head with the product's own stages and score every step; one JSON a head."""

from __future__ import annotations

import time
from collections.abc import Mapping
from dataclasses import replace
from typing import Any, Final

import numpy as np
from head_people import KnownHead
from head_scans import azimuth_error_deg
from head_scores import Ruler, ruler, score, worst_landmark
from numpy.typing import NDArray
from scipy.interpolate import RBFInterpolator

from cloner import pipeline
from cloner.errors import ClonerError
from cloner.evaluate.measures.posing import LANDMARKS
from cloner.evaluate.measures.rulers import fit_similarity
from cloner.frames import ViewId
from cloner.generic.head_controls import load_head_controls
from cloner.generic.load import GenericHuman, load_generic
from cloner.geometry.deformation.dffd import deform
from cloner.head.evidence import FitLog, Params, front_evidence, side_evidence
from cloner.head.model import make_head_model
from cloner.head.modes import load_head_modes
from cloner.records.heads import HeadFit
from cloner.records.photos import Person, PhotoSet
from cloner.records.points import PointSet, ViewPoints
from cloner.records.proposals import Proposals
from cloner.records.views import Camera
from cloner.stages import head
from cloner.testing import first_values, run_stages

Array = NDArray[np.float64]
Values = dict[str, Any]

BEFORE: Final = ("proposals", "points", "views", "silhouettes", "phenotype")
#: Steps of the method, then other ways to carry the same displacements of the control points.
STEPS: Final = ("generic", "start", "basis", "dffd", "finished")
WAYS: Final = ("carried by DFFD", "carried by RBF", "scaled by axis")


def fit_head(known: KnownHead) -> tuple[Values, dict[str, float]]:
    """Return the values of all stages before the head, and their CPU seconds; nets run here, once."""
    return before_head(known.photos, known.person)


def before_head(photos: PhotoSet, person: Person) -> tuple[Values, dict[str, float]]:
    """Return the values of all stages before the head of anybody, and their CPU seconds."""
    values, reports = run_stages(first_values(photos, person), BEFORE)
    return values, {report.name: report.cpu_seconds for report in reports}


def with_true_features(values: Values, known: KnownHead) -> Values:
    """Return the values with every named point of both photos put where it truly is, as an operator would."""
    points = dict(values["face_points"].views)
    for view, camera in known.views.items():
        if view in points:
            points[view] = true_points(points[view], camera.project, known.truth.marks_m)
    return {**values, "face_points": PointSet(points)}


def true_points(points: ViewPoints, project: Any, marks: Mapping[str, Array]) -> ViewPoints:
    """Return the points with those of known marks (3,) where they truly are, as an operator would put them."""
    rows = [row for row, name in enumerate(points.names) if name in marks]
    places, corrected = points.points_px.copy(), points.corrected.copy()
    if rows:
        places[rows] = project(np.array([marks[points.names[row]] for row in rows]))
        corrected[rows] = True
    return ViewPoints(points.view, points.names, places, points.confidence, corrected)


def with_true_net(values: Values, known: KnownHead) -> Values:
    """Return the values with the front photo's 468 points where the net draws such a face on the average.

    Its known bias and pull towards the mean stay, for the fit takes them out again; only for the generic's topology.
    """
    camera, proposals = known.views[ViewId.FACE_FRONT], dict(values["proposals"].views)
    true_px = true_net_px(np.asarray(known.vertices_m), camera)
    proposals[ViewId.FACE_FRONT] = replace(proposals[ViewId.FACE_FRONT], face_px=true_px)
    return {**values, "proposals": Proposals(proposals)}


def true_net_px(vertices: Array, camera: Camera) -> Array:
    """Return where the net draws a face (V, 3) of the generic's topology on the average, (468, 2) px."""
    from calibrate_head_net import coefficients_of, fitted_shapes, rest_camera

    from cloner.detectors.face.face_net import load_face_net

    net, generic = load_face_net(), load_generic()
    metres = camera.metres_per_pixel(vertices[generic.feature("nasion")])
    coefficients, scale, rotation = coefficients_of(fitted_shapes(), vertices[generic.head_vertices])
    drawn = load_head_modes().errors_m(coefficients, rest_camera(camera, rotation)) / (scale * metres)
    return np.asarray(camera.project(net.places.at(vertices)) + drawn)


def steps(values: Values) -> dict[str, Array]:
    """Return the person's vertices (V, 3) after every step of the head's fit, and by other deformations."""
    generic, params, log = load_generic(), Params(), FitLog()
    phenotype, photos = values["phenotype"], values["photos"]
    model = make_head_model(phenotype)
    front = front_evidence(model, photos, values["proposals"], values["face_points"], params)
    side = side_evidence(model, values["proposals"], values["silhouettes"], values["face_points"], params)
    shaped = head.shape_head(model, photos, phenotype, (front, side), params, log, lambda fraction: None)
    mean, _ = generic.shape(np.zeros(0), phenotype.stature_m)
    out = {
        "generic": mean,
        "start": model.vertices_m,
        "basis": model.whole(shaped.basis.head_m),
        "dffd": model.whole(shaped.relief.head_m),
    }
    return out | _carried(generic, out["start"], out["dffd"])


def _carried(generic: GenericHuman, start: Array, goal: Array) -> dict[str, Array]:
    """Return the start carried to the goal's control points by DFFD, by an RBF, and by scaling the axes."""
    controls, rows = load_head_controls(), generic.head_vertices
    scale = float(np.ptp(start[rows, 1]) / np.ptp(generic.vertices_m[rows, 1]))
    near = np.array([int(np.argmin(((generic.vertices_m[rows] - place) ** 2).sum(axis=1)))
                     for place in controls.controls_m])  # fmt: skip
    moves = np.where(controls.movable[:, None], (goal - start)[rows][near], 0.0)
    places = start[rows][near]
    _, single = np.unique(near, return_index=True)
    spline = RBFInterpolator(places[single], moves[single], kernel="thin_plate_spline")
    faces = near[controls.movable]
    a, b = start[rows][faces], goal[rows][faces]
    factors = ((a - a.mean(0)) * (b - b.mean(0))).sum(0) / ((a - a.mean(0)) ** 2).sum(0)
    made = {
        "carried by DFFD": start[rows] + deform(controls.weights, moves / scale) * scale,
        "carried by RBF": start[rows] + spline(start[rows]),
        "scaled by axis": (start[rows] - a.mean(0)) * factors + b.mean(0),
    }
    out = {}
    for name, vertices in made.items():
        out[name] = start.copy()
        out[name][rows] = vertices
    return out


def finished(values: Values) -> tuple[Array, float, tuple[str, ...], HeadFit]:
    """Return the head stage's own result as a person's vertices, its CPU seconds, its warnings and the result."""
    stage = next(stage for stage in pipeline.STAGES if stage.name == "head")
    begin = time.process_time()
    result = stage.run(**{name: values[name] for name in stage.needs}, tick=lambda fraction: None)
    vertices, _ = load_generic().shape(values["phenotype"].coefficients, values["phenotype"].stature_m)
    vertices[load_generic().head_vertices] = result.values["head"].vertices_m
    return vertices, time.process_time() - begin, result.warnings, result.values["head"]


def yaw_errors(known: KnownHead, vertices: Array, fit: HeadFit) -> dict[str, float]:
    """Return by how much each face photo's camera stands too far round the person's left, degrees."""
    names = [name for name in LANDMARKS if name in known.truth.marks_m and not name.startswith("ear")]
    own = vertices[[load_generic().feature(name) for name in names]]
    true = np.array([known.truth.marks_m[name] for name in names])
    turn = fit_similarity(true, own, scale=False)[:3, :3]
    return {
        view.value: azimuth_error_deg(turn, fit.cameras[view], camera)
        for view, camera in known.views.items()
        if view in fit.cameras
    }


def measure_head(known: KnownHead) -> tuple[dict[str, Any], dict[str, Array], Ruler]:
    """Return the JSON row of one head, its clones (V, 3) by kind of features, and its ruler."""
    generic, begin, measure = load_generic(), time.process_time(), ruler(known.truth)
    row: dict[str, Any] = {"name": known.name, "about": dict(known.about)}
    try:
        values, seconds = fit_head(known)
    except ClonerError as error:
        return row | {"error": f"{error.message} ({error.where})"}, {}, measure
    proposed, cpu, warnings, fit = finished(values)
    clones = {"proposed": proposed, "corrected": finished(with_true_features(values, known))[0]}
    if known.vertices_m is not None:
        clones["true"] = finished(with_true_net(with_true_features(values, known), known))[0]
    made = steps(values) | {"finished": proposed}
    row |= {
        "steps": {name: score(made[name], measure, generic) for name in (*STEPS, *WAYS)},
        "features": {name: score(clone, measure, generic) for name, clone in clones.items()},
        "yaw_deg": yaw_errors(known, proposed, fit),
        "landmarks": worst_landmark(proposed, measure, generic),
        "seconds": {**seconds, "head": cpu, "all": time.process_time() - begin},
        "warnings": list(warnings),
    }
    return row, clones, measure
