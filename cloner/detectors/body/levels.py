"""A Gaussian over levels of features along the body, conditioned on those that a photo shows.

The Gaussian is learnt by ``generic_models/build/calibrate_body_levels.py`` from photographs of painted and generated
people. Conditioned on what was seen it gives every feature's level with its spread; and each seen level is tried
against all others, so that a wrong one is found before it is used.
"""

from __future__ import annotations

import functools
import importlib.resources
from collections.abc import Iterator, Mapping
from contextlib import contextmanager
from dataclasses import dataclass
from typing import Final

import numpy as np
from numpy.lib.npyio import NpzFile

from cloner.calibration.loader import calibrated
from cloner.records.arrays import Array

#: What each number is and where it comes from: ``cloner/calibration/detectors.toml``.
_CALIBRATED: Final = calibrated("detectors.levels")


GATE_SPREADS: Final = _CALIBRATED.number("gate_spreads", "sigmas")
GATE_LEAST: Final = _CALIBRATED.number("gate_least", "figure")
UNKNOWN: Final = _CALIBRATED.number("unknown", "figure")


@dataclass(frozen=True, slots=True, eq=False)
class LevelModel:
    """A Gaussian over named levels.

    Attributes
    ----------
    names : tuple of str
    mean : (N,) float64
    covariance : (N, N) float64
    """

    names: tuple[str, ...]
    mean: Array
    covariance: Array

    def index(self, name: str) -> int:
        """Return a name's entry."""
        return self.names.index(name)


@dataclass(frozen=True, slots=True, eq=False)
class Levels:
    """The inferred levels of one person.

    Attributes
    ----------
    level : mapping of str to float
    sigma : mapping of str to float
        Standard deviation, same unit.
    refused : tuple of str
        Seen levels that contradict the others and were not used.
    """

    level: Mapping[str, float]
    sigma: Mapping[str, float]
    refused: tuple[str, ...]


def infer_levels(model: LevelModel, seen: Mapping[str, float]) -> Levels:
    """Return all levels given the observed ones; observations that contradict the rest are rejected, worst first."""
    used = [name for name in seen if name in model.names and np.isfinite(seen[name])]
    refused: list[str] = []
    while len(used) > 3:
        rows = [model.index(name) for name in used]
        precision = np.linalg.inv(_observation_covariance(model, rows))
        away = precision @ (np.array([seen[name] for name in used]) - model.mean[rows])
        alone = 1.0 / np.diag(precision)
        ratio = np.abs(away * alone) / np.maximum(GATE_SPREADS * np.sqrt(alone), GATE_LEAST)
        worst = int(ratio.argmax())
        if ratio[worst] <= 1.0:
            break
        refused.append(used.pop(worst))
    return _conditioned(model, {name: seen[name] for name in used}, tuple(refused))


def _observation_covariance(model: LevelModel, rows: list[int]) -> Array:
    return np.asarray(model.covariance[np.ix_(rows, rows)] + UNKNOWN**2 * np.eye(len(rows)))


def _conditioned(model: LevelModel, seen: Mapping[str, float], refused: tuple[str, ...]) -> Levels:
    """Return mean and sigma of all levels given some."""
    rows = [model.index(name) for name in seen]
    mean, covariance = model.mean, model.covariance
    if rows:
        gain = np.linalg.solve(_observation_covariance(model, rows), covariance[rows]).T
        mean = mean + gain @ (np.array([seen[name] for name in seen]) - model.mean[rows])
        covariance = covariance - gain @ covariance[rows]
    sigma = np.sqrt(np.maximum(np.diag(covariance), 0.0))
    return Levels(
        dict(zip(model.names, mean.tolist(), strict=True)),
        dict(zip(model.names, sigma.tolist(), strict=True)),
        refused,
    )


@contextmanager
def _archive() -> Iterator[NpzFile]:
    place = importlib.resources.files("cloner_models") / "body_levels.npz"
    with place.open("rb") as stream, np.load(stream, allow_pickle=False) as archive:
        yield archive


@functools.cache
def load_levels(kind: str) -> LevelModel:
    """Return the shipped model of "front", "back", "side", "arm_front" or "arm_back", read once per process."""
    with _archive() as archive:
        names = tuple(str(name) for name in archive[f"{kind}_names"])
        mean, covariance = (archive[f"{kind}_{part}"].astype(np.float64) for part in ("mean", "covariance"))
    mean.setflags(write=False)
    covariance.setflags(write=False)
    return LevelModel(names, mean, covariance)


@dataclass(frozen=True, slots=True, eq=False)
class Offsets:
    """Mean errors of proposed points in one kind of photo, figure heights.

    Attributes
    ----------
    names : tuple of str
        Point names; joints as ``knee_net`` and ``knee_middle`` (see ``joint_places``).
    offset : (N, 2) float64
        What must be added, outwards (from the side: forwards) and up.
    error : (N,) float64
        Mean distance from the truth that is left.
    """

    names: tuple[str, ...]
    offset: Array
    error: Array

    def of(self, name: str) -> tuple[Array, float]:
        """Return the mean error (2,) and the sigma of a point."""
        row = self.names.index(name)
        return self.offset[row], float(self.error[row])


@functools.cache
def load_offsets(kind: str) -> Offsets:
    """Return the shipped offsets of "front", "back" or "side", read once per process."""
    with _archive() as archive:
        names = tuple(str(name) for name in archive[f"{kind}_point_names"])
        offset, error = (archive[f"{kind}_point_{part}"].astype(np.float64) for part in ("offset", "error"))
    offset.setflags(write=False)
    error.setflags(write=False)
    return Offsets(names, offset, error)
