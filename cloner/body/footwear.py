"""Footwear: feet closed, lengthened and raised as outlines show shoes.

An outline shows shoes, not feet. So the family of bodies that is fitted to photos
wears shoes of a usual shape, and three numbers of the family's linear model tell
how thick their soles are, and how long and how wide they are.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Final

import numpy as np

from cloner.body.feet import close_toes, scale_feet
from cloner.calibration.loader import calibrated
from cloner.generic.load import GENERIC_STATURE_M, GenericHuman
from cloner.records.arrays import Array
from cloner.records.bodies import BodyMesh

#: What each number is and where it comes from: ``cloner/calibration/body.toml``.
_CALIBRATED: Final = calibrated("body.footwear")


@dataclass(frozen=True, slots=True)
class Footwear:
    """A kind of footwear: mean size and one standard deviation.

    Attributes
    ----------
    sole_m : tuple of float
        Height of the soles below the naked feet, mean, spread and limits, metres.
    length, width : tuple of float
        Factors of the foot's length and width about the ankle: mean and spread.
    instep : float
        Factor of the instep's height.
    closed : bool
        Whether toes are hidden.
    """

    sole_m: tuple[float, float, float, float]
    length: tuple[float, float]
    width: tuple[float, float]
    instep: float
    closed: bool


def _kind(name: str, *, closed: bool) -> Footwear:
    """Return a kind of footwear from the calibration."""
    return Footwear(
        _CALIBRATED.quadruple(f"{name}_sole_m", "m"),
        _CALIBRATED.pair(f"{name}_length", "factor"),
        _CALIBRATED.pair(f"{name}_width", "factor"),
        _CALIBRATED.number(f"{name}_instep", "factor"),
        closed,
    )


SHOES: Final = _kind("shoes", closed=True)
BAREFOOT: Final = _kind("barefoot", closed=False)
#: Number of linear modes: sole height, length, width.
FOOTWEAR = 3


def with_footwear(generic: GenericHuman, stature_m: float, wear: Footwear) -> tuple[Array, Array]:
    """Return vertices (V, 3) of the mean human in footwear, and the displacements (3, V, 3) of its modes, metres.

    Parameters
    ----------
    stature_m : float
        Stature of the person in naked feet, metres; footwear has its real size at that stature.
    """
    scale = stature_m / GENERIC_STATURE_M
    mesh = BodyMesh(scale * generic.vertices_m.astype(np.float64), scale * generic.joints_m.astype(np.float64))
    foot = close_toes(mesh) if wear.closed else mesh
    sole, length, width = wear.sole_m[:2], wear.length, wear.width

    def sized(sole_sigmas: float, length_sigmas: float, width_sigmas: float) -> Array:
        size = (width[0] + width_sigmas * width[1], length[0] + length_sigmas * length[1], wear.instep, 0.0)
        return scale_feet(foot, np.array(size), sole[0] + sole_sigmas * sole[1])

    mean = sized(0.0, 0.0, 0.0)
    modes = np.array([(sized(*step) - sized(*(-step))) / 2.0 for step in np.eye(FOOTWEAR)])
    return mean, modes


def sole_height(wear: Footwear, sigmas: float) -> float:
    """Return the height of the soles, metres, within the footwear's limits."""
    mean, sigma, low, high = wear.sole_m
    return float(np.clip(mean + sigmas * sigma, low, high))
