"""Choice among fitted profiles: labels in a profile's own frame, which its outline alone does not tell.

A moustache, glasses before a brow or a fringe have the outline of a face as well as the face has. A linear model of the
logarithm of the error (ridge regression) reads the labels on a grid that lies with the profile, where the pose net has
eye, nose and mouth, and how well the outline fits; ``generic_models/build/learn_profile_judge.py`` taught it on
generated people.
"""

from __future__ import annotations

import functools
import importlib.resources
from dataclasses import dataclass
from typing import Final

import numpy as np
from numpy.typing import NDArray

from cloner.calibration.loader import calibrated
from cloner.detectors.face.profile_fit import FittedProfile
from cloner.detectors.face.profile_search import ProfileModel, curve_normals
from cloner.records.arrays import Array
from cloner.records.labels import FACE, Label, labels_at, shows

#: What each number is and where it comes from: ``cloner/calibration/detectors.toml``.
_CALIBRATED: Final = calibrated("detectors.profile_judge")

#: Where labels are read, metres forward of the nose tip and over it: from behind the ear to before the nose, from the
#: throat to the hair over the forehead.
FORWARD_M: Final = _CALIBRATED.number("step_m", "m") * np.arange(-9, 4)
UP_M: Final = _CALIBRATED.number("step_m", "m") * np.arange(-8, 11)
#: Labels that tell the same of a profile; 0 is the wall.
_MERGED: Final = {
    Label.BODY_SKIN: 1, Label.FACE_SKIN: 2, Label.MOUTH: 2, Label.HAIR: 3, Label.UPPER_CLOTHES: 4,
    Label.LOWER_CLOTHES: 4, Label.SHOES: 4, Label.EYES: 5, Label.ACCESSORY: 6, Label.BEARD: 7,
}  # fmt: skip
_CLASS_OF: Final = np.array([_MERGED.get(label, 0) for label in Label])
_CLASSES: Final = 8
#: How deep inside an outline it is asked whether there is face; a fall of hair may have a face's outline.
INSIDE_M: Final = _CALIBRATED.number("inside_m", "m")
#: Places of nose, eye and mouth of the pose net against the nose tip, metres (the mean profile's own).
_USUAL_M: Final = np.array([(0.0, 0.0), _CALIBRATED.pair("eye_m", "m"), _CALIBRATED.pair("mouth_m", "m")])
_EYE_TO_MOUTH_M: Final = float(np.linalg.norm(_USUAL_M[1] - _USUAL_M[2]))
#: Where the share of face behind the outline, and the outline's cost, stand among the features.
FACE_SHARE, COST = -7, -5
#: Farther off than this the pose net's places tell no more, metres and logarithm of the size.
_FAR_M: Final = _CALIBRATED.number("far_m", "m")
_FAR_SIZE: Final = 1.0


@dataclass(frozen=True, slots=True, eq=False)
class ProfileJudge:
    """A linear model of the logarithm of a profile's error in millimetres.

    Attributes
    ----------
    mean, weights : (D,) float64
        Of :func:`features`.
    usual : float
        Mean logarithm.
    """

    mean: Array
    weights: Array
    usual: float

    def error_mm(self, seen: Array) -> float:
        """Return the expected error of a fitted profile, millimetres, by its features (D,)."""
        return float(np.exp(self.usual + (seen - self.mean) @ self.weights))


@functools.cache
def load_judge() -> ProfileJudge:
    """Return the shipped model."""
    place = importlib.resources.files("cloner_models") / "profile_judge.npz"
    with place.open("rb") as stream, np.load(stream, allow_pickle=False) as archive:
        mean, weights = (archive[name].astype(np.float64) for name in ("mean", "weights"))
        return ProfileJudge(mean, weights, archive["usual"].item())


def features(
    model: ProfileModel, fitted: FittedProfile, facing: int, labels: NDArray[np.uint8], known: tuple[int, Array] | None
) -> Array:
    """Return the features (D,) of a fitted profile.

    Parameters
    ----------
    model : ProfileModel
    fitted : FittedProfile
    facing : int
        +1 when the profile looks to the image's right, -1 left.
    labels : (H, W) uint8
    known : (int, (3, 2) float64) or None
        Which way the head looks by the pose net, and where it has nose, eye and mouth, px.
    """
    tip = model.mean[model.samples + model.names.index("nose_tip")]
    linear, shift = fitted.px_from_m[:, :2], fitted.px_from_m[:, 2]
    grid = np.stack(np.meshgrid(FORWARD_M, UP_M), axis=-1).reshape(-1, 2) + tip
    seen = _CLASS_OF[labels_at(labels, grid @ linear.T + shift)]
    shown = (seen[:, None] == np.arange(1, _CLASSES)).ravel()
    face = face_share(model, fitted, labels)
    tilt = np.arctan2(-linear[1, 0], facing * linear[0, 0])
    fit = (fitted.cost, np.sqrt(max(fitted.cost, 0.0)), fitted.weights @ fitted.weights / 10.0, tilt, 4.0 * tilt**2)
    return np.concatenate([shown, _pose_features(fitted, facing, tip, known), [face, face**2], fit])


def face_share(model: ProfileModel, fitted: FittedProfile, labels: NDArray[np.uint8]) -> float:
    """Return the share of a fitted profile with face labels (H, W) on its inner side."""
    inwards = -curve_normals(model.shape(fitted.weights)[: model.samples]) @ fitted.px_from_m[:, :2].T
    return float(shows(labels_at(labels, fitted.curve_px(model) + INSIDE_M * inwards), *FACE).mean())


def _pose_features(fitted: FittedProfile, facing: int, tip: Array, known: tuple[int, Array] | None) -> Array:
    """Return the pose net's positions in a profile's frame; zeros without them."""
    if known is None:
        return np.zeros(21)
    own_m = np.linalg.solve(fitted.px_from_m[:, :2], (known[1] - fitted.px_from_m[:, 2]).T).T
    away = np.clip((own_m - tip - _USUAL_M) / _FAR_M, -1.0, 1.0).ravel()
    size = np.linalg.norm(known[1][1] - known[1][2]) / (_EYE_TO_MOUTH_M * fitted.size)
    larger = float(np.clip(np.log(max(float(size), 1e-6)) / _FAR_SIZE, -1.0, 1.0))
    return np.concatenate([away, away**2, np.abs(away), [larger, larger**2, 1.0 if known[0] == facing else -1.0]])
