"""What nets and colours say about each photo: pose, face, mask, skin and hair.

Runs once a photo; corrections never run it again.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass
from typing import Final, cast

import numpy as np
from numpy.typing import NDArray

from cloner.abreast import in_two_steps
from cloner.calibration.loader import calibrated
from cloner.detectors.body.pose_order import read_again
from cloner.detectors.face.found import Face, face_behind_hair, face_in
from cloner.detectors.face.profile_cut import free_profile
from cloner.detectors.nets.portraits import is_cut_below
from cloner.detectors.nets.results import Box, PoseResult
from cloner.detectors.table import DETECTORS
from cloner.errors import ClonerError
from cloner.frames import ViewId
from cloner.generic.seen_points import ANKLES
from cloner.labels.photo import label_photo, look
from cloner.labels.states import stands_barefoot
from cloner.records.photos import Photo, PhotoSet
from cloner.records.points import Proposal, Proposals
from cloner.records.results import StageResult
from cloner.stages.hidden import SOMEBODY, shares_colours
from cloner.stages.photo_checks import hides_its_side
from cloner.vision.segmentation.masks import refine_mask

#: What each number is and where it comes from: ``cloner/calibration/stages.toml``.
_CALIBRATED: Final = calibrated("stages.proposals")

DENIED: Final = _CALIBRATED.number("denied", "score")
LABELLED: Final = _CALIBRATED.number("labelled", "share")
LEAST_PERSON = _CALIBRATED.number("least_person", "share")
UPRIGHT = _CALIBRATED.number("upright", "factor")
MOST_UNSURE = _CALIBRATED.number("most_unsure", "share")

HIDDEN = (
    "nobody can be made out in this photo, so it was left out; retake it with hair, hood or scarf away from the face"
)


class NobodySeen(ClonerError):
    """No net sees a person in a photo."""


def nobody_in(photo: Photo) -> NobodySeen:
    """Return the refusal of a photo in which no net sees a person."""
    return NobodySeen("no person found in this photo", "Take it again with one person in full view", photo.name)


def check_people(photo: Photo) -> Box:
    """Return the one person, or face, in a photo; refuse it without exactly one.

    Raises
    ------
    NobodySeen
        If nobody is found.
    ClonerError
        If more than one person is found.
    """
    people: list[Box] = DETECTORS.get("people")(photo.rgb)
    if not people:
        raise nobody_in(photo)
    if len(people) > 1:
        raise ClonerError(
            f"{len(people)} people found in this photo", "Take it again with one person alone in view", photo.name
        )
    return people[0]


@dataclass(frozen=True, slots=True, eq=False)
class Figure:
    """Where the person is in a photo.

    Attributes
    ----------
    pose_px : (33, 2)
    visibility : (33,)
    probability : (H, W) uint8, 0..255
    inside : (H, W) bool
    labels : (H, W) uint8
    face : tuple
        As :func:`cloner.detectors.face.found.face_in` gives it.
    seen_px : (21, 2) or (0, 2)
        Joints and points under clothes.
    """

    pose_px: NDArray[np.float64]
    visibility: NDArray[np.float64]
    probability: NDArray[np.uint8]
    inside: NDArray[np.bool_]
    labels: NDArray[np.uint8]
    face: Face
    seen_px: NDArray[np.float64]


def find_figure(photo: Photo) -> Figure:
    """Return pose, face, mask and labels of one photo.

    Raises
    ------
    ClonerError
        If the photo does not show exactly one person.
    """
    try:
        pose = DETECTORS.get("pose")(photo.rgb, check_people(photo))
    except NobodySeen:
        pose = _pose_unseen(photo)
    if pose is None:
        raise nobody_in(photo)
    pose = read_again(photo.rgb, photo.view, pose, DETECTORS.get("pose"))
    if float((pose.mask > 0.5).mean()) < LEAST_PERSON:
        raise nobody_in(photo)
    return _figure(photo, pose.points_px, np.asarray(pose.visibility, dtype=np.float64), pose.mask)


def _pose_unseen(photo: Photo) -> PoseResult | None:
    """Return the pose of somebody whom no detector sees, None where there is none."""
    if photo.view is ViewId.FACE_SIDE:
        return cast(PoseResult | None, DETECTORS.get("pose_with_room")(photo.rgb))
    standing = standing_mask(photo) if photo.view.is_body else None
    return None if standing is None else DETECTORS.get("pose_in_mask")(photo.rgb, standing)


def _figure(
    photo: Photo, pose_px: NDArray[np.float64], visibility: NDArray[np.float64], rough: NDArray[np.float32]
) -> Figure:
    """Return what is in a photo whose person is roughly (H, W) known.

    Raises
    ------
    NobodySeen
        If next to nothing of the photo is the person.
    """
    face = face_in(photo)
    shown = face[0] if face[2] > 0.0 else None
    looks = look(
        photo.rgb, rough > 0.5, photo.view, DETECTORS.get("label_features"), face_points=shown, pose_points=pose_px
    )
    labelled = looks.person(rough.shape)
    rough = both_masks(rough, labelled) if photo.view.is_face else undenied(rough, labelled)
    mask = refine_mask(photo.rgb, rough, pose_px if photo.view.is_body and visibility.any() else None)
    if float((mask > 0.5).mean()) < LEAST_PERSON:
        raise nobody_in(photo)
    labels, _ = label_photo(photo.rgb, mask > 0.5, looks, shown, faced=photo.view is not ViewId.BODY_BACK)
    if shown is None and visibility.any():
        face = face_behind_hair(photo, pose_px, labels) or face
    probability = np.round(np.clip(mask, 0.0, 1.0) * 255).astype(np.uint8)
    return Figure(pose_px, visibility, probability, mask > 0.5, labels, face, looks.seen_px)


def both_masks(posed: NDArray[np.float32], labelled: NDArray[np.float32]) -> NDArray[np.float32]:
    """Return (H, W) the person's probability in a face photo from the selfie net's mask and that of the label net."""
    first, second = (np.clip(each, 0.01, 0.99) for each in (posed, labelled))
    odds = (1.0 - LABELLED) * np.log(first / (1.0 - first)) + LABELLED * np.log(second / (1.0 - second))
    return np.asarray(1.0 / (1.0 + np.exp(-odds)), np.float32)


def undenied(posed: NDArray[np.float32], labelled: NDArray[np.float32]) -> NDArray[np.float32]:
    """Return (H, W) the person's probability in a body photo: the pose net's, even odds where the label net is sure of
    the opposite.

    Either takes what stands behind a limb for a part of it now and then, seldom both; the photo's colours decide there.
    """
    denied = np.where(posed > 0.5, labelled < DENIED, labelled > 1.0 - DENIED)
    return np.where(denied, np.float32(0.5), posed)


def find_hidden_figure(photo: Photo) -> Figure | None:
    """Return a portrait in which no body or face is seen, as the label net sees it; None where that is torn.

    Its pose is unknown: all points lie in the mask's middle and none is visible.
    """
    everywhere = np.ones(photo.rgb.shape[:2], np.bool_)
    mask = look(photo.rgb, everywhere, photo.view, DETECTORS.get("label_features")).person(everywhere.shape)
    if not _is_whole(mask) or not is_cut_below(mask.astype(np.float64)):
        return None
    rows, columns = np.nonzero(mask > 0.5)
    pose = np.tile(np.array([columns.mean(), rows.mean()]), (33, 1))
    return _figure(photo, pose, np.zeros(33), mask)


def standing_mask(photo: Photo) -> NDArray[np.bool_] | None:
    """Return the (H, W) standing figure that the label net sees in a body photo, None where it sees none."""
    everywhere = np.ones(photo.rgb.shape[:2], np.bool_)
    mask = look(photo.rgb, everywhere, photo.view, DETECTORS.get("label_features")).person(everywhere.shape)
    inside = np.asarray(mask > 0.5, np.bool_)
    return inside if _is_whole(mask) and not is_cut_below(mask.astype(np.float64)) and _stands(inside) else None


def _is_whole(mask: NDArray[np.float32]) -> bool:
    """Whether a (H, W) probability is a person's: large enough, and sure where it ends."""
    person, unsure = float((mask > 0.5).mean()), float(((mask > 0.1) & (mask < 0.9)).mean())
    return person >= LEAST_PERSON and unsure <= MOST_UNSURE * person


def _stands(inside: NDArray[np.bool_]) -> bool:
    rows, columns = (np.ptp(np.flatnonzero(inside.any(axis=axis))) for axis in (1, 0))
    return bool(rows > UPRIGHT * columns)


def settle_hidden(photos: PhotoSet, views: Mapping[ViewId, Proposal], unseen: Mapping[ViewId, NobodySeen]) -> Proposals:
    """Return all proposals, with those of photos in which no net sees anybody, by what the other photos tell.

    A side photo of the face may show hair or a hood alone. It is kept for its mask when somebody is made out in it and
    its colours are the person's; with one of both it is left out. So are a face behind hair beside the body's front, a
    side that may as well be a back, and a body's side or back in which only the label net sees somebody stand.

    Raises
    ------
    NobodySeen
        Of the first photo that has nothing of the person.
    """
    others = [(photos.photos[view].rgb, proposal.mask > 127) for view, proposal in views.items()]
    found, left_out = dict(views), dict[ViewId, str]()
    for view, error in unseen.items():
        photo, close = photos.photos[view], view.is_face and (view.is_side or ViewId.BODY_FRONT in views)
        figure = find_hidden_figure(photo) if close else None
        alike = close and shares_colours(photo.rgb, others) >= SOMEBODY
        stands = view in (ViewId.BODY_SIDE, ViewId.BODY_BACK) and standing_mask(photo) is not None
        if figure is not None and alike and view.is_side:
            found[view] = propose_within(photo, figure)
        elif figure is not None or alike or stands:
            left_out[view] = HIDDEN
        else:
            raise error
    side = views.get(ViewId.FACE_SIDE)
    if side is not None and len(views) > 1 and hides_its_side(side, photos.photos[ViewId.FACE_SIDE]):
        left_out[ViewId.FACE_SIDE] = HIDDEN
    kept = {view: found[view] for view in photos.photos if view in found and view not in left_out}
    return Proposals(kept, left_out)


def propose_within(photo: Photo, figure: Figure) -> Proposal:
    """Return pose, face, mask and labels of one photo whose person is found."""
    points, depth, presence, irises = figure.face
    found = Proposal(
        photo.view,
        figure.pose_px,
        figure.visibility,
        points,
        depth,
        presence,
        figure.probability,
        figure.labels,
        photo.view.is_body and stands_barefoot(figure.labels, figure.seen_px[ANKLES]),
        irises,
        figure.seen_px,
    )
    return free_profile(photo, found) if photo.view is ViewId.FACE_SIDE else found


def propose(photo: Photo) -> Proposal:
    """Return pose, face, mask and labels of one photo.

    Raises
    ------
    ClonerError
        If the photo does not show exactly one person.
    """
    return propose_within(photo, find_figure(photo))


def run(*, photos: PhotoSet, tick: Callable[[float], None]) -> StageResult:
    """Give one proposal a photo; a photo in which hair or a hood hides all may be left out.

    Raises
    ------
    ClonerError
        If a photo does not show exactly one person.
    """
    views: dict[ViewId, Proposal] = {}
    unseen: dict[ViewId, NobodySeen] = {}

    def figure_of(photo: Photo) -> Figure | NobodySeen:
        try:
            return find_figure(photo)
        except NobodySeen as error:
            return error

    def proposal_of(photo: Photo, figure: Figure | NobodySeen) -> Proposal | NobodySeen:
        return figure if isinstance(figure, NobodySeen) else propose_within(photo, figure)

    proposed = in_two_steps(figure_of, proposal_of, photos.photos.values())
    for view, found in zip(photos.photos, proposed, strict=True):
        if isinstance(found, NobodySeen):
            unseen[view] = found
        else:
            views[view] = found
        tick((len(views) + len(unseen)) / len(photos.photos))
    settled = settle_hidden(photos, views, unseen)
    DETECTORS.get("let_nets_go")()  # no later stage asks them
    return StageResult({"proposals": settled})
