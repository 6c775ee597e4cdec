"""The head's size: from the face in the body photo, or from statistics at this stature."""

from __future__ import annotations

from dataclasses import replace
from typing import Final

import numpy as np

from cloner.calibration.loader import calibrated
from cloner.fit.cameras import resect
from cloner.frames import ViewId
from cloner.generic.load import GENERIC_STATURE_M, load_generic
from cloner.geometry.articulation.skinning import joint_transforms
from cloner.head.evidence import FrontEvidence, Params
from cloner.head.fit import FittedHead
from cloner.head.jaw import with_open_jaw
from cloner.head.model import HeadModel
from cloner.records.arrays import Array
from cloner.records.bodies import Phenotype, PosedView
from cloner.records.proposals import Proposals
from cloner.records.views import Camera

#: What each number is and where it comes from: ``cloner/calibration/head.toml``.
_CALIBRATED: Final = calibrated("head.size")

USUAL_M: Final = _CALIBRATED.triple("usual_m", "m")
BY_STATURE: Final = _CALIBRATED.number("by_stature", "factor")
NET_M: Final = _CALIBRATED.number("net_m", "m")


def body_camera(model: HeadModel, phenotype: Phenotype) -> Camera | None:
    """Return body_front's camera relative to the head at rest, which the body's pose moves."""
    posed = phenotype.views.get(ViewId.BODY_FRONT)
    return None if posed is None else head_camera(model.joints_m, posed)


def head_camera(joints_m: Array, posed: PosedView) -> Camera:
    """Return a photo's camera relative to the head at rest, for a person with joints (94, 3)."""
    transforms = joint_transforms(joints_m, load_generic().joint_parents, posed.rotations)
    skull = transforms[load_generic().joint("skullbase")]
    return replace(posed.camera, camera_from_model=posed.camera.camera_from_model @ skull)


def expected_scale(model: HeadModel, fitted: FittedHead, phenotype: Phenotype) -> float:
    """Return the factor that brings a head to the expected size at its stature.

    Eye distance, height of the face and length of the skull vote alike; each alone differs by 4 to 6 % among people.
    """
    whole = model.whole(fitted.head_m)

    def at(name: str) -> Array:
        return np.asarray(whole[model.generic.feature(name)])

    skull = whole[model.generic.region("scalp"), 2].min()
    own = (
        np.linalg.norm(at("pupil_L") - at("pupil_R")),
        np.linalg.norm(at("nasion") - at("chin_bottom")),
        at("glabella")[2] - skull,
    )
    by_stature = BY_STATURE * np.log(phenotype.stature_m / GENERIC_STATURE_M)
    return float(np.exp(by_stature + np.mean(np.log(USUAL_M) - np.log(np.maximum(own, 1e-3)))))


def head_scale(
    model: HeadModel,
    fitted: FittedHead,
    jaw_rad: float,
    front: FrontEvidence | None,
    proposals: Proposals,
    phenotype: Phenotype,
    params: Params,
) -> float:
    """Return the head's scale: the face in the body photo weighed against the phenotype's own head.

    The face photos alone tell no size. The body photo does, through its camera, but its face is small; both guesses
    are weighted by their errors. A jaw that is open in the face photo by ``jaw_rad`` is no error of the net's. Without
    any body photo the usual size at the stature is taken.
    """
    limit = np.log1p(params.scale_limit)
    if front is not None and not phenotype.views:
        return float(np.exp(np.clip(np.log(expected_scale(model, fitted, phenotype)), -limit, limit)))
    camera, proposal = body_camera(model, phenotype), proposals.views.get(ViewId.BODY_FRONT)
    if front is None or fitted.front is None or camera is None:
        return 1.0
    if proposal is None or proposal.face_presence < params.presence:
        return 1.0
    whole = model.whole(fitted.head_m)
    places = model.net.places.at(whole)
    shown = model.net.places.at(with_open_jaw(model.generic, whole, model.joints_m, jaw_rad))
    made = model.modes.frontal_errors_m(front.net_px, shown, fitted.front)
    factor = observed_scale(model, places, made, camera, proposal.face_px)
    certain = params.own_scale**2 / (params.own_scale**2 + params.body_scale**2)
    return float(np.exp(np.clip(certain * np.log(max(factor, 1e-3)), -limit, limit)))


def observed_scale(model: HeadModel, places: Array, made: Array, camera: Camera, face_px: Array) -> float:
    """Return the scale of a face (468, 2) px in a photo relative to its projection.

    The face may nod and turn otherwise than the camera believes, and is drawn with the net's errors (468, 2), metres,
    that were found in another photo of the same face: a bent or a turned face looks smaller than it is.
    """
    metres, middle = camera.metres_per_pixel(places.mean(axis=0)), camera.to_camera(places.mean(axis=0)[None])[0]
    weight = 1.0 / (model.net.sigma_m**2 + NET_M**2)
    turned = camera
    for _ in range(2):
        errors = (made + model.modes.turn_errors_m(turned.camera_from_model[:3, :3])) / metres
        found = resect(places, face_px - errors, camera, sigma_px=1.0 / (np.sqrt(weight) * metres))
        pose = np.array(found.camera_from_model)
        pose[:3, 3] += middle - found.to_camera(places.mean(axis=0)[None])[0]
        turned = replace(camera, camera_from_model=pose)
    weight = weight / weight.sum()
    wanted, have = face_px - errors, turned.project(places)
    wanted, have = wanted - weight @ wanted, have - weight @ have
    alike = (weight * (np.conj(have @ [1, 1j]) * (wanted @ [1, 1j]))).sum()
    return float(abs(alike) / max(float(weight @ (have**2).sum(axis=1)), 1e-12))
