"""Checks that each photo shows what its name says, by the sum of log odds; only certain mistakes are refused.

Every sign gives its weight for one answer as the logarithm of odds, and so does the photo's name: people exchange
photos seldom. What each sign is on photos that show the one and the other was measured on 40 generated people and the
samples.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Mapping
from functools import partial
from typing import Final

import numpy as np

from cloner.calibration.loader import calibrated
from cloner.detectors.face.face_side import side_face_of
from cloner.detectors.nets import pose_rows as net
from cloner.detectors.table import DETECTORS
from cloner.errors import ClonerError
from cloner.frames import ViewId
from cloner.records.labels import FACE, Label, shows
from cloner.records.photos import Photo, PhotoSet
from cloner.records.proposals import PERSON_LEVEL, Proposal, Proposals

#: What each number is and where it comes from: ``cloner/calibration/stages.toml``.
_CALIBRATED: Final = calibrated("stages.photo_checks")

FRONTAL: Final = _CALIBRATED.pair("frontal", "share")
PROFILE: Final = _CALIBRATED.pair("profile", "share")
CLOSE_UP: Final = _CALIBRATED.number("close_up", "share")
CUT_BELOW: Final = _CALIBRATED.number("cut_below", "share")
TURNED: Final = _CALIBRATED.number("turned", "deg")
FIGURE_WIDE: Final = _CALIBRATED.number("figure_wide", "share")
USUAL_FACE: Final = _CALIBRATED.number("usual_face", "share")
ASIDE: Final = _CALIBRATED.pair("aside", "share")
ASIDE_MOST: Final = _CALIBRATED.number("aside_most", "score")
LEAST_PART: Final = _CALIBRATED.number("least_part", "share")
SIDE_NAME: Final = _CALIBRATED.number("side_name", "score")
LEAST_BELIEF: Final = _CALIBRATED.number("least_belief", "factor")
#: Outer eye corners in the face net.
_EYES: Final = (33, 263)
_HINT: Final = "Rename or retake the photos so that each shows what its name says"


def check_photos(proposals: Proposals, photos: PhotoSet) -> None:
    """Refuse photos that are exchanged or that cut the person.

    Raises
    ------
    ClonerError
        If a photo certainly shows another side than its name says, a face photo the whole
        body, or a body photo only a part of it.
    """
    front = proposals.views.get(ViewId.BODY_FRONT)
    # where this face is seen from so far away, a front photo without one is no front photo
    faced = _SEEN_IN_FRONT if front is not None and front.face_presence > 0.0 else 0.0
    checks: Mapping[ViewId, Callable[[Proposal, Photo], str]] = {
        ViewId.BODY_BACK: partial(_trouble_in_body, hidden=faced),
        ViewId.FACE_FRONT: _trouble_in_face_front,
        ViewId.FACE_SIDE: _trouble_in_face_side,
    }
    for view, proposal in proposals.views.items():
        if not proposal.pose_visibility.any():
            continue  # hair or a hood hides all that could tell
        trouble = checks.get(view, _trouble_in_body)(proposal, photos.photos[view])
        if trouble:
            raise ClonerError(trouble, _HINT, photos.photos[view].name)


def log_odds(value: float, even: float, step: float, most: float) -> float:
    """Return the log odds of a cue: 0 at ``even``, 1 a ``step`` above it, at most ``most`` either way."""
    return float(np.clip((value - even) / step, -most, most))


def _trouble_in_body(proposal: Proposal, photo: Photo, hidden: float = 0.0) -> str:
    """Return what is wrong with a body photo, "" when nothing is; ``hidden`` adds to the odds of a missing face."""
    pose, view = proposal.pose_px, proposal.view
    height = proposal.mask.shape[0]
    if pose[net.KNEES, 1].min() > height:
        return "this photo shows only the upper part of the person, not the whole body"
    if pose[net.ANKLES, 1].min() > height:
        return "the feet are outside this photo"
    sideways = side_odds(proposal)
    if view is ViewId.BODY_SIDE:
        away = sideways + SIDE_NAME < 0.0
        return "this photo shows the person from the front or back, not from the side" if away else ""
    if sideways - 1.0 > 0.0:
        return f"this photo shows the person from the side, not the {view.value[5:]}"
    forwards = front_odds(proposal)
    if view is ViewId.BODY_FRONT:
        away = forwards + (_FACE if proposal.face_presence > 0.0 else _NO_FACE) + 1.5 < 0.0
        return "this photo shows the person's back, not the front" if away else ""
    if forwards > 0.0 and forwards + (_FACE if _sees_face(photo) else _NO_FACE + hidden + hair_odds(proposal)) > 1.5:
        return "this photo shows the person's front, not the back"
    return ""


def side_odds(proposal: Proposal) -> float:
    """Return the log odds that a body is seen from the side.

    Signs, in heights of the figure, on front and back photos against side ones: breadth of the shoulders 0.12-0.22
    against 0.06 and less, of the hips 0.06-0.12 against 0.02, toes beside the heels 0.03 against 0.09-0.11, nose
    beside the ears 0.01 against 0.03-0.06. A body turned by 45 degrees has about even odds. The whole figure with its
    arms, which no net has to name, is 0.47-0.57 wide against 0.17-0.20.
    """
    pose = proposal.pose_px
    shown = proposal.person()
    rows, columns = (np.flatnonzero(shown.any(axis=axis)) for axis in (1, 0))
    tall = max(float(rows[-1] - rows[0]), 1.0) if len(rows) else 1.0
    wide = float(columns[-1] - columns[0]) / tall if len(columns) else FIGURE_WIDE
    shoulders, hips = (abs(float(pose[pair[0], 0] - pose[pair[1], 0])) / tall for pair in (net.SHOULDERS, net.HIPS))
    toes = abs(float(pose[[*net.TOES], 0].mean() - pose[[*net.HEELS], 0].mean())) / tall
    nose = abs(float(pose[net.NOSE, 0] - pose[[*net.EARS], 0].mean())) / tall
    broad = (
        log_odds(shoulders, 0.085, 0.02, 3.0)
        + log_odds(hips, 0.04, 0.015, 1.5)
        + log_odds(wide, FIGURE_WIDE, 0.05, 3.0)
    )
    return log_odds(toes, 0.06, 0.02, 1.5) + log_odds(nose, 0.02, 0.01, 1.0) - broad


def front_odds(proposal: Proposal) -> float:
    """Return the log odds that a body is seen from the front rather than from behind, by its pose alone.

    The net knows left from right as a rule. It is surer of the toes than of the heels on people who face the camera
    (0.10-0.51 in front, -0.59 to 0.05 from behind; of one person in a cap with long hair 0.51 from behind).
    """
    left, right = proposal.pose_px[net.SHOULDERS[0], 0], proposal.pose_px[net.SHOULDERS[1], 0]
    seen = proposal.pose_visibility
    lead = float(seen[[*net.TOES]].mean() - seen[[*net.HEELS]].mean())
    return (2.0 if left > right else -2.0) + log_odds(lead, 0.08, 0.08, 2.0)


def hair_odds(proposal: Proposal) -> float:
    """Return the log odds, at most 0, that a head without a face is seen from the front: less where it is all hair.

    Of heads seen from the front .18 to .94 are face and not hair, curtains of hair before faces among them; from
    behind 0 to .18, and more where hair is thin, so much skin tells nothing.
    """
    face, hair = (int(shows(proposal.labels, *classes).sum()) for classes in (FACE, (Label.HAIR,)))
    return min(log_odds(face / (face + hair), _FACE_SHARE, 0.04, 3.0), 0.0) if face + hair else 0.0


_FACE_SHARE: Final = _CALIBRATED.number("face_share", "share")
_FACE = _CALIBRATED.number("face", "score")
_NO_FACE = _CALIBRATED.number("no_face", "score")
_SEEN_IN_FRONT: Final = _CALIBRATED.number("seen_in_front", "score")


def _sees_face(photo: Photo) -> bool:
    return DETECTORS.get("face")(photo.rgb) is not None


def _trouble_in_face_front(proposal: Proposal, photo: Photo) -> str:
    """Return what is wrong with the front photo of the face, "" when nothing is."""
    if _shows_whole_body(proposal) and _ear_distance_px(proposal) < CLOSE_UP * proposal.mask.shape[0]:
        return "this photo shows the whole body, not the face from near"
    place = nose_between_ears(proposal)
    straight = proposal.face_presence > 0.0 and abs(turned_degrees(proposal)) < TURNED
    if not PROFILE[0] < place < PROFILE[1] and not straight:
        return "this photo shows the face from the side, not from the front"
    if proposal.face_presence == 0.0:
        return "no face can be seen from the front in this photo"
    return ""


def turned_degrees(proposal: Proposal) -> float:
    """Return the yaw of the face by the face net, degrees; infinite without depths."""
    first, second = _EYES
    across = float(np.hypot(*(proposal.face_px[second] - proposal.face_px[first])))
    if across == 0.0:
        return math.inf
    return math.degrees(math.atan2(float(proposal.face_depth[second] - proposal.face_depth[first]), across))


def _trouble_in_face_side(proposal: Proposal, photo: Photo) -> str:
    """Return what is wrong with the side photo of the face, "" when nothing is."""
    if _shows_whole_body(proposal):
        return "this photo shows the whole body, not the face from near"
    away = side_face_odds(proposal, photo) < 0.0
    return "this photo shows the head from the front or back, not from the side" if away else ""


def side_face_odds(proposal: Proposal, photo: Photo) -> float:
    """Return the log odds that a photo shows a head from the side, by all cues."""
    profile = profile_odds(proposal)
    odds = (profile * pose_reliability(proposal) if profile < 0.0 else profile) + 2.0
    if odds < 1.0:
        odds += max(log_odds(face_offset_in_head(proposal), *ASIDE, ASIDE_MOST), 0.0)
    if odds < 1.0:
        odds += _outline_odds(proposal)
    if odds < 1.0 and odds > -3.0:
        odds += _front_face_odds(photo)
    return odds


def shows_mostly_hair(proposal: Proposal, photo: Photo) -> bool:
    """Return whether a side photo of the face shows hair or headwear and next to no face: it may be seen from behind.

    Bare shoulders below a fall of hair are taken for a face at times, so a little face is none unless the face net sees
    one from the front.
    """
    little = pose_reliability(proposal) < 1.0
    if not little or _shows_whole_body(proposal) or side_face_odds(proposal, photo) >= 0.0:
        return False
    return not shows(proposal.labels, Label.FACE_SKIN).any() or _front_face_odds(photo) == 0.0


def profile_odds(proposal: Proposal) -> float:
    """Return the log odds that a head is seen from the side, by its pose alone.

    Signs on fronts and backs against profiles, the last two over the height of the nose above the shoulders: the place
    of the nose between the ears, breadth of the shoulders 1.6-3.3 against 0.03-1.14, of the ears 0.6-1.7 against
    0.01-0.43. Beards and long hair mislead the first most.
    """
    pose, place = proposal.pose_px, nose_between_ears(proposal)
    between = -2.0 if FRONTAL[0] < place < FRONTAL[1] else 2.0 if not PROFILE[0] < place < PROFILE[1] else 0.0
    up = max(float(pose[[*net.SHOULDERS], 1].mean() - pose[net.NOSE, 1]), 1.0)
    shoulders, ears = (abs(float(pose[pair[0], 0] - pose[pair[1], 0])) / up for pair in (net.SHOULDERS, net.EARS))
    return between - log_odds(shoulders, 1.4, 0.2, 1.5) - log_odds(ears, 0.45, 0.1, 1.5)


def face_offset_in_head(proposal: Proposal) -> float:
    """Return the distance of the face from the middle of hair and headwear, in head widths; 0 where either is small.

    Profiles .06-.46, median .28, one in twenty under .13; fronts 0-.19, median .03, one in twenty over .13. A beard and
    a cap hide from the pose net what it goes by, not from the labels.
    """
    face, other = shows(proposal.labels, Label.FACE_SKIN), shows(proposal.labels, Label.HAIR, Label.ACCESSORY)
    sizes = int(face.sum()), int(other.sum())
    if min(sizes) < LEAST_PART * max(sum(sizes), 1):
        return 0.0
    columns = [np.nonzero(part)[1] for part in (face, other)]
    wide = float(np.ptp(np.concatenate(columns)))
    return abs(float(columns[0].mean() - columns[1].mean())) / max(wide, 1.0)


def pose_reliability(proposal: Proposal) -> float:
    """Return 0..1 how reliable the pose net is on a head: it guesses where hair or headwear covers the face.

    Share of face skin in face, hair and headwear: profiles 0.25-0.35, the bald 1, hair before the face 0-0.08.
    """
    labels = proposal.labels
    face = int(shows(labels, Label.FACE_SKIN).sum())
    head = face + int(shows(labels, Label.HAIR, Label.ACCESSORY).sum())
    return float(np.clip(face / (USUAL_FACE * max(head, 1)), LEAST_BELIEF, 1.0))


def _outline_odds(proposal: Proposal) -> float:
    """Return the log odds of a profile by how well one fits the outline.

    It costs 0.08-0.43 on profiles, median 0.22; 0.25-0.49 on fronts and backs, median 0.4.
    """
    found = side_face_of(proposal)
    return -2.0 if found is None else max(-log_odds(found.fitted.cost, 0.32, 0.03, 3.0), -2.0)


def _front_face_odds(photo: Photo) -> float:
    """Return the log odds of a profile given a detected front face; the face net sees none in most
    profiles and backs.
    """
    face = DETECTORS.get("face")(photo.rgb)
    return -3.0 if face is not None and abs(face.turn_deg) < TURNED else 0.0


def nose_between_ears(proposal: Proposal) -> float:
    """Return the nose's position across the photo: 0 and 1 at the ears, outside on a profile."""
    ears = np.sort(proposal.pose_px[net.EARS, 0])
    return float((proposal.pose_px[net.NOSE, 0] - ears[0]) / max(ears[1] - ears[0], 1.0))


def _shows_whole_body(proposal: Proposal) -> bool:
    inside = bool(proposal.pose_px[net.ANKLES, 1].max() < proposal.mask.shape[0])
    return inside and float((proposal.mask[-2:] > PERSON_LEVEL).mean()) < CUT_BELOW


def _ear_distance_px(proposal: Proposal) -> float:
    return float(np.ptp(proposal.pose_px[net.EARS, 0]))
