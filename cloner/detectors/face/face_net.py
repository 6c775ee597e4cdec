"""Calibration of the face net's points, read from ``face_net.npz``."""

from __future__ import annotations

import functools
import importlib.resources
from collections.abc import Mapping
from dataclasses import dataclass
from types import MappingProxyType
from typing import Final

import numpy as np

from cloner.detectors.face.profile_search import ProfileModel
from cloner.geometry.meshes.surface import SurfacePoints
from cloner.records.arrays import Array

#: Curves of the front face that are pulled on to the image.
CURVES: Final = ("lid_upper_L", "lid_upper_R", "lid_lower_L", "lid_lower_R", "mouth")


@dataclass(frozen=True, slots=True, eq=False)
class FaceNet:
    """Positions of the net's points on the generic head, and rules for named points.

    Attributes
    ----------
    places : SurfacePoints
        468 places on the generic human's vertices.
    sigma_m : (468,) float64
        Spread of each place along one picture axis, metres, over random heads.
    drift_m : (M, 468, 2) float64
        Errors that the points make together, right and down in the picture, metres; each times a standard normal
        number.
    alone_m : (468,) float64
        What is left of the spread without them.
    names : tuple of str
    rules : (K, 468) float64
        Weights that make named points from net points, rows sum to one.
    rule_error : (K,) float64
        Root-mean-square error of each rule as a share of the eye distance.
    iris_offset_iod : (2,) float64
        The left iris' centre beside the pupil point, share of the eye distance; the right one mirrors it.
    iris_error_iod : float
    curves : mapping of str to (N, 468) float64
        Rules that make the points of a lid's edge or the line between the lips from net points, by curve; lids from
        the inner to the outer corner, the mouth from the person's right to the left.
    profile : ProfileModel
        Outlines of side faces with named points.
    """

    places: SurfacePoints
    sigma_m: Array
    drift_m: Array
    alone_m: Array
    names: tuple[str, ...]
    rules: Array
    rule_error: Array
    iris_offset_iod: Array
    iris_error_iod: float
    curves: Mapping[str, Array]
    profile: ProfileModel


@functools.cache
def load_face_net() -> FaceNet:
    """Return the shipped calibration, read once per process (made by ``calibrate_face_net.py``)."""
    place = importlib.resources.files("cloner_models") / "face_net.npz"
    with place.open("rb") as stream, np.load(stream, allow_pickle=False) as archive:
        data = {name: archive[name] for name in archive.files}
    profile = ProfileModel(
        data["profile_mean_m"].astype(np.float64),
        data["profile_modes_m"].astype(np.float64),
        data["profile_rest_m"].astype(np.float64),
        tuple(str(n) for n in data["profile_names"]),
    )
    return FaceNet(
        SurfacePoints(data["corners"], data["weights"].astype(np.float64)),
        data["sigma_m"].astype(np.float64),
        data["drift_m"].astype(np.float64),
        data["alone_m"].astype(np.float64),
        tuple(str(n) for n in data["named"]),
        data["rules"].astype(np.float64),
        data["rule_error_iod"].astype(np.float64),
        data["iris_offset_iod"].astype(np.float64),
        float(data["iris_error_iod"].ravel()[0]),
        MappingProxyType({name: data[f"curve_{name}"].astype(np.float64) for name in CURVES}),
        profile,
    )
