"""Shape coefficients and camera poses together, from points and curves in photos."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from typing import Final

import numpy as np

from cloner.fit.cameras import MOST_SHIFT, Aim
from cloner.fit.evidence import Rows, points, together
from cloner.fit.problem import Block, Problem, Values
from cloner.records.arrays import Array
from cloner.records.views import Camera

#: A camera turned beyond so many expected turns is held ever less: most people stand as they were asked, some do not.
TURN_OUTLIER: Final = 1.5
#: Longest steps: of a coefficient in spreads, of a camera's turn in radians, of the logarithm of the focal length.
MOST_SHAPE, MOST_TURN, MOST_ZOOM = 1.0, 0.1, 0.2


@dataclass(frozen=True, slots=True, eq=False)
class Evidence:
    """What one photo says about places on the model.

    Attributes
    ----------
    camera : int
        Index of the photo's camera.
    base_m : (N, 3)
        Places at zero coefficients, metres.
    basis_m : (F, N, 3)
        Their change with each coefficient.
    target_px : (N, 2)
    sigma_px : (N,)
        Expected error.
    normal_px : (N, 2) or None
        When given, only the error along this unit direction counts: a point may slide on a curve.
    outlier : float
        Errors beyond this many sigmas lose their weight (Cauchy).
    drift_px : (M, N, 2) or None
        Errors that the targets make together; their sizes are solved for and follow the shape coefficients.
    skew_px : (F, N, 2) or None
        Errors of the targets that follow from the shape.
    whiten : (2 N, 2 N) or None
        Stands for ``sigma_px`` where points err together: makes their errors, x and y after each other, independent and
        of size one. Such points lose their weight together.
    """

    camera: int
    base_m: Array
    basis_m: Array
    target_px: Array
    sigma_px: Array
    normal_px: Array | None = None
    outlier: float = 3.0
    drift_px: Array | None = None
    skew_px: Array | None = None
    whiten: Array | None = None

    def places_m(self, coefficients: Array) -> Array:
        """Return the places (N, 3) at some coefficients."""
        return np.asarray(self.base_m + np.tensordot(coefficients[: len(self.basis_m)], self.basis_m, axes=1))

    def rows(self, coefficients: Array, aim: Aim, motion: Array, zoom: Array | None = None) -> Rows:
        """Return its rows for coefficients, camera and, where it is sought, zoom."""
        shapes, number = len(self.basis_m), f"camera {self.camera}"
        seen, by_point, by_aim = aim.seen(self.places_m(coefficients), motion, 0.0 if zoom is None else float(zoom[0]))
        by_shape = np.zeros((*seen.shape, len(coefficients)))
        by_shape[..., :shapes] = np.einsum("nia,fna->nif", by_point, self.basis_m)
        if self.skew_px is not None:
            by_shape[..., :shapes] += self.skew_px.transpose(1, 2, 0)
            seen = seen + np.tensordot(coefficients[:shapes], self.skew_px, axes=1)
        if self.drift_px is not None:
            by_shape[..., shapes:] = self.drift_px.transpose(1, 2, 0)
            seen = seen + np.tensordot(coefficients[shapes:], self.drift_px, axes=1)
        of = ("shape", number) if zoom is None else ("shape", number, "zoom")
        slopes = np.concatenate([by_shape, by_aim[..., : 6 if zoom is None else 7]], axis=2)
        away = seen - self.target_px
        if self.whiten is not None:
            return together(of, away, slopes, self.whiten, outlier=self.outlier)
        return points(of, away, slopes, self.sigma_px, outlier=self.outlier, along=self.normal_px)


@dataclass(frozen=True, slots=True, eq=False)
class ShapeFit:
    """Coefficients (F,) or with drifts (F + M,), cameras, and what they moved.

    ``turned`` is each turn from its expected pose (radians, (K, 3)), ``zoomed`` the logarithm of the common change of
    their focal lengths, with distances that keep the head's size in the photos.
    """

    coefficients: Array
    cameras: tuple[Camera, ...]
    turned: Array
    zoomed: float = 0.0


def fit_shape(
    start: ShapeFit,
    gather: Callable[[ShapeFit, int], Sequence[Evidence]],
    *,
    at_least: Array | float = -np.inf,
    rarity: Array | float = 0.0,
    turn_sigma: Array | None = None,
    zoom_sigma: float = 0.0,
    iterations: int = 10,
) -> ShapeFit:
    """Return the most likely coefficients and cameras.

    Parameters
    ----------
    start : ShapeFit
    gather : callable
        ``gather(fit, iteration)`` returns the evidence for the present fit: curves are matched afresh each time.
    at_least : float or (F,)
        No coefficient becomes smaller.
    rarity : float or (F,)
        Decline of the expected coefficients' logarithm beside the normal prior: for what is mostly absent.
    turn_sigma : (K, 3), optional
        Expected turn of each camera (``ShapeFit.turned``), radians, with heavy tails (Cauchy beyond ``TURN_OUTLIER``);
        infinite where the evidence alone decides.
    zoom_sigma : float
        Expected relative error of the cameras' common focal length; 0 keeps it.
    """
    fit = start
    for iteration in range(iterations):  # cameras turn on from where they are, so that their turns add up
        fit = _stepped(fit, gather(fit, iteration), at_least, rarity, turn_sigma, zoom_sigma)
    return fit


def _stepped(
    fit: ShapeFit,
    found: Sequence[Evidence],
    at_least: Array | float,
    rarity: Array | float,
    turn_sigma: Array | None,
    zoom_sigma: float,
) -> ShapeFit:
    """Return the fit after one turn of the solver."""
    names = [f"camera {k}" for k in range(len(fit.cameras))]
    depths = _depths(fit, found)
    blocks = {"shape": Block(fit.coefficients, 0.0, 1.0, np.inf, rarity, at_least, longest=MOST_SHAPE)}
    for number, name in enumerate(names):
        spread, expected = np.full(6, np.inf), np.zeros(6)
        expected[:3] = -fit.turned[number]
        spread[:3] = np.inf if turn_sigma is None else turn_sigma[number]
        longest = np.repeat([MOST_TURN, MOST_SHIFT * depths[number]], 3)
        blocks[name] = Block(np.zeros(6), expected, spread, TURN_OUTLIER, longest=longest)
    if zoom_sigma > 0.0:
        blocks["zoom"] = Block(np.zeros(1), -fit.zoomed, zoom_sigma, longest=MOST_ZOOM)
    aims = [Aim(camera, float(depth)) for camera, depth in zip(fit.cameras, depths, strict=True)]

    def look(values: Values, turn: int) -> list[Rows]:
        zoom = values.get("zoom")
        return [one.rows(values["shape"], aims[one.camera], values[names[one.camera]], zoom) for one in found]

    values = Problem(blocks).solve(look, turns=1).values
    zoom, motions = float(values["zoom"][0]) if "zoom" in values else 0.0, np.array([values[name] for name in names])
    cameras = tuple(aim.camera(motion, zoom) for aim, motion in zip(aims, motions, strict=True))
    return ShapeFit(values["shape"], cameras, fit.turned + motions[:, :3], fit.zoomed + zoom)


def _depths(fit: ShapeFit, found: Sequence[Evidence]) -> Array:
    """Return the mean depth (K,) of what each photo shows, metres."""
    first = [next(item for item in found if item.camera == number) for number in range(len(fit.cameras))]
    inside = [fit.cameras[item.camera].to_camera(item.places_m(fit.coefficients)) for item in first]
    return np.array([places[:, 2].mean() for places in inside])


def misfit(fit: ShapeFit, evidence: Sequence[Evidence], turn_sigma: Array) -> float:
    """Return twice the negative log likelihood (Cauchy errors, normal priors): smaller is likelier.

    Comparable only among fits to the same places and targets, as when several starts are tried.
    """
    turns = np.log1p((fit.turned / turn_sigma) ** 2 / TURN_OUTLIER**2)
    total = float((fit.coefficients**2).sum() + TURN_OUTLIER**2 * turns.sum())
    for item in evidence:
        rows = item.rows(fit.coefficients, Aim(fit.cameras[item.camera]), np.zeros(6))
        group = 2 if item.normal_px is None else 1
        total -= item.outlier**2 * float(np.log(np.asarray(rows.weight)[::group]).sum())
    return total
