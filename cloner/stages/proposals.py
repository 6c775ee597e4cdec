"""Stage: proposals of nets and colours for each photo: pose, face, mask, labels.

Runs once a photo; corrections never run it again.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping

from cloner.detectors.face.profile_cut import without_wall_before_face
from cloner.detectors.table import DETECTORS
from cloner.frames import ViewId
from cloner.generic.seen_points import ANKLES
from cloner.labels.states import stands_barefoot
from cloner.parallel import pipelined
from cloner.records.photos import Photo, PhotoSet
from cloner.records.proposals import Proposal, Proposals
from cloner.records.results import StageResult
from cloner.stages.figures import Figure, NobodySeen, find_figure, find_hidden_figure, standing_mask
from cloner.stages.hidden import SOMEBODY, shares_colours
from cloner.stages.photo_checks import shows_mostly_hair

HIDDEN = (
    "nobody can be made out in this photo, so it was left out; retake it with hair, hood or scarf away from the face"
)
COVERED = (
    "hair hides the face in this photo, so it shows no more than the hair; "
    "retake it with hair, hood or scarf away from the face"
)


def resolve_hidden(
    photos: PhotoSet, views: Mapping[ViewId, Proposal], unseen: Mapping[ViewId, NobodySeen]
) -> Proposals:
    """Return all proposals, with those of photos without a detected person, by help of the other photos.

    A side photo of the face may show hair or a hood alone. It is kept for its mask when somebody is made out in it and
    its colours are the person's; with one of both it is left out. So are a face behind hair beside the body's front,
    and a body's side or back in which only the label net sees somebody stand. A side that may as well be a back is left
    out but for its hair.

    Raises
    ------
    NobodySeen
        Of the first photo that has nothing of the person.
    """
    others = [(photos.photos[view].rgb, proposal.person()) for view, proposal in views.items()]
    found, left_out = dict(views), dict[ViewId, str]()
    for view, error in unseen.items():
        photo, close = photos.photos[view], view.is_face and (view.is_side or ViewId.BODY_FRONT in views)
        figure = find_hidden_figure(photo) if close else None
        alike = close and shares_colours(photo.rgb, others) >= SOMEBODY
        stands = view.is_body and not view.is_front and standing_mask(photo) is not None
        if figure is not None and alike and view.is_side:
            found[view] = propose_in_figure(photo, figure)
        elif figure is not None or alike or stands:
            left_out[view] = HIDDEN
        else:
            raise error
    side, covered = views.get(ViewId.FACE_SIDE), dict[ViewId, Proposal]()
    if side is not None and len(views) > 1 and shows_mostly_hair(side, photos.photos[ViewId.FACE_SIDE]):
        left_out[ViewId.FACE_SIDE], covered[ViewId.FACE_SIDE] = COVERED, side
    kept = {view: found[view] for view in photos.photos if view in found and view not in left_out}
    return Proposals(kept, left_out, covered)


def propose_in_figure(photo: Photo, figure: Figure) -> Proposal:
    """Return the proposal of a photo whose person is found."""
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
        figure.naked_px,
    )
    return without_wall_before_face(photo, found) if photo.view is ViewId.FACE_SIDE else found


def propose(photo: Photo) -> Proposal:
    """Return the proposal of one photo.

    Raises
    ------
    ClonerError
        If the photo does not show exactly one person.
    """
    return propose_in_figure(photo, find_figure(photo))


def run(*, photos: PhotoSet, tick: Callable[[float], None]) -> StageResult:
    """Produce one proposal per photo; a photo in which hair or a hood covers everything may be left out.

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
        return figure if isinstance(figure, NobodySeen) else propose_in_figure(photo, figure)

    proposed = pipelined(figure_of, proposal_of, photos.photos.values())
    for view, found in zip(photos.photos, proposed, strict=True):
        if isinstance(found, NobodySeen):
            unseen[view] = found
        else:
            views[view] = found
        tick((len(views) + len(unseen)) / len(photos.photos))
    settled = resolve_hidden(photos, views, unseen)
    DETECTORS.get("release_nets")()  # no later stage asks them
    return StageResult({"proposals": settled})
