"""Feature points in photos: proposals, corrections, and what the fit uses."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from enum import StrEnum
from types import MappingProxyType

import numpy as np
from numpy.typing import NDArray

from cloner.frames import ViewId
from cloner.records.arrays import freeze

#: Start of the names of points that an operator put on an outline where no feature has a name.
ANCHOR = "outline_"
#: Error at which a body point's confidence has fallen to 1/e, share of the figure's height.
CONFIDENCE_SCALE = 0.02

#: A correction farther than this share of the figure's height from the proposal says that the proposal was wrong:
#: two spreads of the pose net's joints (parts: 5-40 px in 1,800 px).
FAR = 0.035

#: Error at which a face point's confidence has fallen to 1/e, share of the inter-ocular distance.
FACE_CONFIDENCE_SCALE = 0.10


def confidence_of(error: float) -> float:
    """Return a body point's confidence for an expected error in shares of the figure's height."""
    return float(np.exp(-max(error, 0.0) / CONFIDENCE_SCALE))


def expected_error(confidence: NDArray[np.float64]) -> NDArray[np.float64]:
    """Return the expected distance from the truth of body points, as shares of the figure's height."""
    return -CONFIDENCE_SCALE * np.log(np.clip(confidence, 1e-6, 1.0))


def face_confidence(error: NDArray[np.float64]) -> NDArray[np.float64]:
    """Return the confidence of face points with expected errors in shares of the inter-ocular distance."""
    return np.exp(-np.maximum(error, 0.0) / FACE_CONFIDENCE_SCALE)


def expected_face_error(confidence: NDArray[np.float64]) -> NDArray[np.float64]:
    """Return the expected distance from the truth of face points, as shares of the inter-ocular distance."""
    return -FACE_CONFIDENCE_SCALE * np.log(np.clip(confidence, 1e-6, 1.0))


class StateKind(StrEnum):
    """What a body photo shows that its points cannot be read from as usual."""

    ARM_TOUCHES = "arm touches the trunk"
    LEGS_TOGETHER = "legs together"
    HAND_HIDDEN = "hand before the body or in a pocket"
    FOOT_HIDDEN = "foot hidden"
    CUT = "cut by the picture's border"
    TURNED = "turned"
    EXCHANGED = "left and right exchanged by the net"
    REFUSED = "proposal refused"
    LOOSE_OUTLINE = "loose clothing makes the outline"


@dataclass(frozen=True, slots=True)
class PhotoState:
    """Something about a body photo that the points suffer from.

    Points that it makes unreadable are absent or have little confidence, so nobody need look at states to be safe.
    They are for the report, and for steps that treat such a photo in their own way.

    Attributes
    ----------
    kind : StateKind
    side : str
        "left" or "right" of the person, "" for both or none.
    sentence : str
        What is seen and what the operator can do, without the photo's name; "" when there is nothing to tell.
    confidence : float in 0..1
    rows_px : tuple of float
        First and last picture row that it concerns; (0, 0) when it concerns no rows.
    """

    kind: StateKind
    side: str
    sentence: str
    confidence: float = 1.0
    rows_px: tuple[float, float] = (0.0, 0.0)


@dataclass(frozen=True, slots=True, eq=False)
class ViewPoints:
    """Named feature points of one photo.

    Attributes
    ----------
    view : ViewId
    names : tuple of str
        Unique point names.
    points_px : (N, 2) float64, photo pixels, (0, 0) = centre of top-left pixel
    confidence : (N,) float64 in 0..1
        Body points: exp(-expected error / 2 % of the figure's height), see ``expected_error``; face points:
        exp(-expected error / 10 % of the inter-ocular distance), see ``expected_face_error``.
    corrected : (N,) bool
        True where an operator placed the point.
    proposed : ViewPoints or None
        The points before any correction; None where nothing was corrected.
    states : tuple of PhotoState
        What is unusual about a body photo.
    """

    view: ViewId
    names: tuple[str, ...]
    points_px: NDArray[np.float64]
    confidence: NDArray[np.float64]
    corrected: NDArray[np.bool_]
    proposed: ViewPoints | None = None
    states: tuple[PhotoState, ...] = ()

    def __post_init__(self) -> None:
        count = len(self.names)
        if len(set(self.names)) != count:
            raise ValueError(f"{self.view}: point names repeat")
        freeze(
            self,
            points_px=(np.float64, (count, 2)),
            confidence=(np.float64, (count,)),
            corrected=(np.bool_, (count,)),
        )

    def get(self, name: str) -> NDArray[np.float64] | None:
        """Return the (2,) pixel position of a point, or None if absent."""
        return self.points_px[self.names.index(name)] if name in self.names else None


@dataclass(frozen=True, slots=True, eq=False)
class PointSet:
    """Feature points of several photos (``BodyPoints`` and ``FacePoints``)."""

    views: Mapping[ViewId, ViewPoints]

    def __post_init__(self) -> None:
        object.__setattr__(self, "views", MappingProxyType(dict(self.views)))


#: Named feature points of the body photos.
BodyPoints = PointSet
#: Named feature points of the face photos (and of the face in body_front).
FacePoints = PointSet


@dataclass(frozen=True, slots=True)
class Correction:
    """One point placed by an operator.

    Attributes
    ----------
    x_px, y_px : float
        Position in photo pixels.
    photo_digest : str
        sha256 of the photo it was placed on; "" when unknown.
    """

    x_px: float
    y_px: float
    photo_digest: str = ""


@dataclass(frozen=True, slots=True)
class Corrections:
    """Everything operators placed: view -> point name -> correction."""

    points: Mapping[ViewId, Mapping[str, Correction]]

    def __post_init__(self) -> None:
        inner = {view: MappingProxyType(dict(named)) for view, named in self.points.items()}
        object.__setattr__(self, "points", MappingProxyType(inner))


def next_anchor(corrections: Corrections, view: ViewId) -> str:
    """Return a name for one more outline point of a photo that no feature has."""
    taken = set(corrections.points.get(view, {}))
    return next(name for name in (f"{ANCHOR}{k}" for k in range(1, len(taken) + 2)) if name not in taken)


@dataclass(frozen=True, slots=True)
class ObeyedPoint:
    """How well the finished clone keeps to one corrected point.

    Attributes
    ----------
    view : ViewId
    name : str
    kind : str
        "outline": the clone's outline passes through it; "pose": that photo's pose puts the joint or feature there;
        "scale": it set the photo's scale; "cloth": it lies on loose clothing, whose outline passes through it;
        "face": the face was bent to it, until the next whole run fits the head anew.
    before_px, after_px : float
        Distance of the clone's outline or joint from the point without and with this step, photo pixels.
    moved_mm : float
        Largest motion of skin, or of the joint, for this point.
    note : str
        What kept the clone from obeying, in plain words; "" if nothing did.
    """

    view: ViewId
    name: str
    kind: str
    before_px: float
    after_px: float
    moved_mm: float = 0.0
    note: str = ""

    @property
    def is_missed(self) -> bool:
        """Whether the clone keeps off the point."""
        return bool(self.note) and self.kind != "scale"
