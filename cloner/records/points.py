"""Feature points in photos: proposals, corrections, and what the fit uses."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field
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


@dataclass(frozen=True, slots=True, eq=False, weakref_slot=True)  # a profile found in it is remembered with it
class Proposal:
    """What nets and colours say about one photo, before any correction.

    Attributes
    ----------
    view : ViewId
    pose_px : (33, 2) float64
        Pose landmarks in photo pixels (BlazePose order), NaN-free.
    pose_visibility : (33,) float64 in 0..1; all zero when no pose was found
    face_px : (468, 2) float64
        Face-mesh points in photo pixels; zeros when ``face_presence`` is 0.
    face_depth : (468,) float64
        Relative depth in the same unit (pixels), smaller = nearer.
    face_presence : float in 0..1
    mask : (H, W) uint8
        Person probability, 0..255, at photo resolution.
    labels : (H, W) uint8
        0 background, 1 skin, 2 hair, 3 cloth or other (meaningful on the head).
    barefoot : bool
        Whether what a body photo shows below the ankles is skin and not shoes.
    irises_px : (2, 2) float64
        Centres of the person's left and right iris; zeros where no face was found or nobody looked.
    seen_px : (21, 2) float64
        Joints and points under clothes, ``cloner.generic.seen_points.NAMES``; no rows where nobody looked for them.
    naked_px : (N, 4) float64
        Edges of the body under clothes, ``cloner.labels.naked_edges``; no rows where nobody looked for them.
    """

    view: ViewId
    pose_px: NDArray[np.float64]
    pose_visibility: NDArray[np.float64]
    face_px: NDArray[np.float64]
    face_depth: NDArray[np.float64]
    face_presence: float
    mask: NDArray[np.uint8]
    labels: NDArray[np.uint8]
    barefoot: bool = False
    irises_px: NDArray[np.float64] = field(default_factory=lambda: np.zeros((2, 2)))
    seen_px: NDArray[np.float64] = field(default_factory=lambda: np.zeros((0, 2)))
    naked_px: NDArray[np.float64] = field(default_factory=lambda: np.zeros((0, 4)))

    def __post_init__(self) -> None:
        freeze(
            self,
            pose_px=(np.float64, (33, 2)),
            pose_visibility=(np.float64, (33,)),
            face_px=(np.float64, (468, 2)),
            face_depth=(np.float64, (468,)),
            mask=(np.uint8, (None, None)),
            labels=(np.uint8, (None, None)),
            irises_px=(np.float64, (2, 2)),
            seen_px=(np.float64, (None, 2)),
            naked_px=(np.float64, (None, 4)),
        )


@dataclass(frozen=True, slots=True, eq=False)
class Proposals:
    """One proposal a photo.

    Attributes
    ----------
    views : mapping of ViewId to Proposal
    left_out : mapping of ViewId to str
        Photos that no shape is taken from, and why, as the operator reads it.
    covered : mapping of ViewId to Proposal
        Those among them that may still show the person's hair.
    """

    views: Mapping[ViewId, Proposal]
    left_out: Mapping[ViewId, str] = field(default_factory=dict)
    covered: Mapping[ViewId, Proposal] = field(default_factory=dict)

    def __post_init__(self) -> None:
        for name in ("views", "left_out", "covered"):
            object.__setattr__(self, name, MappingProxyType(dict(getattr(self, name))))

    def without(self, reasons: Mapping[ViewId, str]) -> Proposals:
        """Return the proposals without some photos; a side photo of the face may still show the hair."""
        kept = {view: proposal for view, proposal in self.views.items() if view not in reasons}
        side = {view: one for view, one in self.views.items() if view in reasons and view.is_face and view.is_side}
        return Proposals(kept, {**self.left_out, **reasons}, {**self.covered, **side})


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
