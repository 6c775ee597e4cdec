"""Stage: the nearest generic human, and pose and camera of every body photo.

Method §7 "Beyond": shape coefficients, one pose a photo and the perspective
cameras are solved together, first to the joints, then to the outlines too, before
the paper's skeleton, rough and fine steps begin.
"""

from __future__ import annotations

from collections.abc import Callable

import numpy as np

from cloner.body.evidence import Params, PhotoEvidence, gather_evidence
from cloner.body.footwear import FOOTWEAR, SHOES, sole_height
from cloner.body.hair_height import hair_height_mm
from cloner.body.model import WORN, BodyFamily, body_family
from cloner.body.portrait import nearest_of_sex, portrait_shape
from cloner.body.solve import BodyState, outline_term, solve
from cloner.frames import ViewId, mm_from_m
from cloner.generic.load import GenericHuman, load_generic
from cloner.records.arrays import Array
from cloner.records.bodies import Phenotype, PosedView
from cloner.records.photos import Person
from cloner.records.points import BodyPoints
from cloner.records.proposals import Proposals
from cloner.records.results import Residual, StageResult
from cloner.records.silhouettes import SilhouetteSet
from cloner.records.views import ViewSet
from cloner.stages.points import points_for_fit


def height_above_skull(
    body: BodyFamily, state: BodyState, evidence: dict[ViewId, PhotoEvidence]
) -> dict[ViewId, float]:
    """Return the height of the outline's top above the skull in each photo, metres."""
    top = body.points(np.array([body.generic.feature("head_top")]))
    reach = {}
    for view, seen in evidence.items():
        point = top.posed(state.shape, state.poses[view])
        camera = state.camera(seen)
        above = camera.project(point)[0, 1] - seen.top_px
        reach[view] = float(above * camera.metres_per_pixel(point[0]))
    return reach


def run(
    *,
    proposals: Proposals,
    body_points: BodyPoints,
    silhouettes: SilhouetteSet,
    views: ViewSet,
    person: Person,
    tick: Callable[[float], None],
) -> StageResult:
    """Produce the phenotype with one pose and camera per body photo."""
    params, generic, hair_mm = Params(), load_generic(), hair_height_mm(proposals, silhouettes)
    evidence = {
        view: gather_evidence(
            seen,
            points_for_fit(body_points.views[view]),
            silhouettes.views[view],
            proposals.views[view],
            hair_mm,
            params,
        )
        for view, seen in views.views.items()
    }
    if not evidence:
        guess = nearest_of_sex(generic, portrait_shape(generic, proposals), person.sex)
        value = Phenotype(guess, person.stature_m, SHOES.sole_m[0], {}, _attributes(generic, guess))
        return StageResult({"phenotype": value})
    barefoot = bool(np.mean([seen.barefoot for seen in evidence.values()]) > 0.5)
    body = body_family(generic, person.stature_m, barefoot=barefoot, shapes=max(params.shapes))
    state = solve(body, evidence, params, tick)
    posed, residuals = {}, []
    for view, seen in evidence.items():
        posed[view] = PosedView(view, state.camera(seen), (body.pose @ state.poses[view]).reshape(-1, 3))
        term = outline_term(body, seen, state, params, params.reach_mm[-1])
        pixels = state.camera(seen).project(term.model.posed(state.shape, state.poses[view]))
        residuals.append(Residual("outline gap", term.gap_mm(pixels, seen.mm_per_px), "mm", view.value))
    above = list(height_above_skull(body, state, evidence).values())
    residuals.append(Residual("height normalisation", mm_from_m(float(np.ptp(above)) / 2.0), "mm"))
    coefficients = state.shape[WORN:]
    sole = sole_height(body.wear, float(state.shape[0]))
    ease, attributes = state.shape[FOOTWEAR:WORN], _attributes(generic, coefficients)
    value = Phenotype(coefficients, person.stature_m, sole, posed, attributes, ease)
    return StageResult({"phenotype": value}, tuple(residuals))


def _attributes(generic: GenericHuman, coefficients: Array) -> dict[str, float]:
    """Return the named phenotype by linear regression from the coefficients."""
    values = generic.phenotype_mean + generic.phenotype_from_shape[:, : len(coefficients)] @ coefficients
    return {name: float(value) for name, value in zip(generic.phenotype_names, values, strict=True)}
