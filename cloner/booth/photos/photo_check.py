"""The check of a new photo while the visitor is still present: its view and its problems."""

from __future__ import annotations

from dataclasses import replace
from typing import Final

import cv2
import numpy as np
from numpy.typing import NDArray

from cloner.booth.photos.photo_problems import PhotoCheck, PhotoProblem
from cloner.detectors.table import DETECTORS
from cloner.errors import ClonerError
from cloner.frames import FACE_VIEWS, ViewId
from cloner.records.labels import SKINS, shows
from cloner.records.photos import Photo, PhotoSet
from cloner.records.proposals import Proposal, Proposals
from cloner.stages.photo_checks import check_photos
from cloner.stages.proposals import propose

#: Person's share of the photo's height below which too few pixels are left, by kind of photo (taste: 900 of 1800 px).
SMALLEST_BODY: Final = 0.5
SMALLEST_HEAD: Final = 0.25
#: Pixels of the photo's edge that the person may touch before it counts as cut; feet and head need air.
EDGE_PX: Final = 2
#: Width of the sharpest edges, share of the person's height, above which a photo is blurred (see `edge_width`).
#: Samples: sharp 0.0022-0.0031, softened with a Gaussian of 2 px 0.0037-0.0046, of 3 px from 0.0049 on.
BLUR_BODY: Final = 0.0042
BLUR_FACE: Final = 0.0048
#: Medians of the person's brightness, and shares of burnt-out pixels (taste; the samples lie at 60-160 and below 0.02).
DARKEST: Final = 38.0
BRIGHTEST: Final = 215.0
BURNT: Final = 0.12
_WORK_PX: Final = 1000  # the person's height at which sharpness is measured


def check_photo(photo: Photo, wanted: ViewId | None) -> tuple[PhotoCheck, Proposal | None]:
    """Return a photo's view and problems, and the nets' results in that view.

    Parameters
    ----------
    photo : Photo
        Its own view counts for nothing.
    wanted : ViewId or None
        The view in which the nets are asked; None takes the one that it shows. What it shows does not depend on it.
    """
    people = DETECTORS.get("people")(photo.rgb)
    if len(people) != 1:
        return PhotoCheck(photo.digest, None, (PhotoProblem.SEVERAL if people else PhotoProblem.NOBODY,)), None
    try:
        first = propose(replace(photo, view=ViewId.BODY_FRONT))  # its face is looked for, too
    except ClonerError:
        return PhotoCheck(photo.digest, None, (PhotoProblem.NOBODY,)), None
    if is_lying(first):
        return PhotoCheck(photo.digest, None, (PhotoProblem.LYING,)), None
    passes = frozenset(view for view in ViewId if _fits(photo, first, view))
    shown = detect_view(first, passes)
    if shown is None:
        return PhotoCheck(photo.digest, None, (PhotoProblem.NO_VIEW,)), None
    own = _in_view(photo, first, shown)
    check = PhotoCheck(photo.digest, shown, find_problems(photo.rgb, own), passes)
    return check, own if wanted in (None, shown) else _in_view(photo, first, wanted)


def _in_view(photo: Photo, first: Proposal, view: ViewId) -> Proposal:
    """Return the nets' results in a view; ``first`` are those in `ViewId.BODY_FRONT`."""
    return first if view is ViewId.BODY_FRONT else propose(replace(photo, view=view))


def is_lying(proposal: Proposal) -> bool:
    """Return whether the person lies on the side, as in a photo that was not rotated.

    A lying body is wider than high. Of a head alone the line from the eyes to the mouth tells, and so it does of a
    body whose pose was found: it leads down in every photo that is upright, whichever side it shows.
    """
    person = proposal.person()
    rows, columns = np.flatnonzero(person.any(axis=1)), np.flatnonzero(person.any(axis=0))
    if not len(rows):
        return False
    eyes, mouth = proposal.pose_px[[2, 5]].mean(axis=0), proposal.pose_px[9:11].mean(axis=0)
    across, down = np.abs(mouth[0] - eyes[0]), mouth[1] - eyes[1]
    tilted = bool(down < across)
    whole = proposal.pose_px[27:29, 1].max() < person.shape[0]  # the ankles are in the picture: a body
    return tilted and (not whole or bool(np.ptp(columns) > np.ptp(rows)))


def detect_view(proposal: Proposal, passes: frozenset[ViewId]) -> ViewId | None:
    """Return the likeliest of the views that a photo passes as, by the checks for exchanged photos.

    A body seen squarely can pass as front and as back: a face decides, and without one where the left shoulder is.
    """
    fitting = [view for view in ViewId if view in passes]
    if ViewId.BODY_FRONT in fitting and ViewId.BODY_BACK in fitting:
        left, right = proposal.pose_px[11, 0], proposal.pose_px[12, 0]
        front = proposal.face_presence > 0.0 or left > right
        return ViewId.BODY_FRONT if front else ViewId.BODY_BACK
    faces = [view for view in FACE_VIEWS if view in fitting]
    if len(faces) == 2:
        return ViewId.FACE_FRONT if proposal.face_presence > 0.0 else ViewId.FACE_SIDE
    return fitting[0] if fitting else None


def _fits(photo: Photo, proposal: Proposal, view: ViewId) -> bool:
    shown = replace(proposal, view=view)
    try:
        check_photos(Proposals({view: shown}), PhotoSet({view: replace(photo, view=view)}))
    except ClonerError:
        return False
    return True


def find_problems(rgb: NDArray[np.uint8], proposal: Proposal) -> tuple[PhotoProblem, ...]:
    """Return problems of framing, light and sharpness of a photo, the worst first.

    Parameters
    ----------
    rgb : (H, W, 3) uint8
    proposal : Proposal
        What the nets say of it; its view says what must be seen.
    """
    person = proposal.person()
    found = []
    if is_cut(person, proposal):
        found.append(PhotoProblem.CUT)
    if _height_share(person, proposal) < (SMALLEST_BODY if proposal.view.is_body else SMALLEST_HEAD):
        found.append(PhotoProblem.SMALL)
    grey = np.asarray(cv2.cvtColor(np.ascontiguousarray(rgb), cv2.COLOR_RGB2GRAY))
    values = _skin_or_person(grey, proposal, person)
    if np.median(values) < DARKEST:
        found.append(PhotoProblem.DARK)
    if np.median(values) > BRIGHTEST or (values > 252).mean() > BURNT:
        found.append(PhotoProblem.BRIGHT)
    if edge_width(grey, person) > (BLUR_BODY if proposal.view.is_body else BLUR_FACE):
        found.append(PhotoProblem.BLURRED)
    return tuple(found)


def is_cut(person: NDArray[np.bool_], proposal: Proposal) -> bool:
    """Return whether the photo's border cuts what its view must show: the whole body, or a face's head."""
    height, width = person.shape
    if proposal.view.is_body:
        edges = (person[:EDGE_PX], person[-EDGE_PX:], person[:, :EDGE_PX], person[:, -EDGE_PX:])
        return any(bool(edge.any()) for edge in edges)
    face = proposal.pose_px[:11]  # nose, eyes, ears, mouth
    inside = (face[:, 0] > 0) & (face[:, 0] < width) & (face[:, 1] > 0) & (face[:, 1] < height)
    return bool(person[:EDGE_PX].any() or not inside.all())


def _height_share(person: NDArray[np.bool_], proposal: Proposal) -> float:
    """Return the share of the photo's height that the body or head takes."""
    rows = np.flatnonzero(person.any(axis=1))
    if not len(rows):
        return 0.0
    if proposal.view.is_body:
        return float(rows[-1] - rows[0]) / float(person.shape[0])
    mouth = float(np.mean(proposal.pose_px[9:11, 1]))
    return 1.3 * (mouth - float(rows[0])) / float(person.shape[0])  # crown to mouth is three quarters of a head


def _skin_or_person(grey: NDArray[np.uint8], proposal: Proposal, person: NDArray[np.bool_]) -> NDArray[np.uint8]:
    """Return the brightness of the skin, as clothes would mislead; of the whole person if little skin is known."""
    skin = person & shows(proposal.labels, *SKINS)
    return grey[skin] if skin.sum() > 0.02 * person.sum() else grey[person]


def edge_width(grey: NDArray[np.uint8], person: NDArray[np.bool_]) -> float:
    """Return the width of the sharpest edges in and around the person, relative to the person's height.

    The height of a step over its steepest slope is its width; strong steps are compared with their slope one by one.
    """
    rows = np.flatnonzero(person.any(axis=1))
    if not len(rows):
        return 1.0
    scale = _WORK_PX / max(float(rows[-1] - rows[0]), 1.0)
    kind = cv2.INTER_AREA if scale < 1.0 else cv2.INTER_LINEAR
    small = cv2.resize(grey, None, fx=scale, fy=scale, interpolation=kind).astype(np.float32)
    near = cv2.dilate(cv2.resize(person.astype(np.uint8), small.shape[::-1]), np.ones((9, 9), np.uint8)) > 0
    slope = np.hypot(cv2.Sobel(small, cv2.CV_32F, 1, 0, scale=0.125), cv2.Sobel(small, cv2.CV_32F, 0, 1, scale=0.125))
    around = np.ones((9, 9), np.uint8)
    step = cv2.dilate(small, around) - cv2.erode(small, around)
    strong = near & (step >= max(30.0, float(np.percentile(step[near], 90))))
    if not strong.any():
        return 1.0
    ratio = slope[strong] / step[strong]
    return float(1.0 / max(np.percentile(ratio, 95), 1e-6)) / _WORK_PX
