"""What nets and colours say about photos before anybody corrects a point."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field
from types import MappingProxyType
from typing import Final

import numpy as np
from numpy.typing import NDArray

from cloner.frames import ViewId
from cloner.records.arrays import freeze

#: A person is likelier than not above it, of 255.
PERSON_LEVEL: Final = 127


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
        Values of ``cloner.records.labels.Label``.
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

    def person(self) -> NDArray[np.bool_]:
        """Return where the photo shows the person (H, W)."""
        return self.mask > PERSON_LEVEL


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
