"""The head's pose in each photo, fitted again with the person's own head.

The phenotype's head is nobody's; once the fitted head sits on the body, neck and
skull base turn a little until the head lies where each photo shows it (method §5,
"one rest-pose body and one pose per photo"). A face seen from the front places its
photo's head to two millimetres. Where hair makes the outline, all photos share one
thickness of hair, an unknown of the same fit: what front and side tell about it
holds the head in the photo of the back, which shows nothing else. Face photos nod
about the face, whose place is known already: no photo of a face tells its nod well.
"""

from __future__ import annotations

import functools
from collections.abc import Callable, Iterator, Mapping
from typing import Final

import numpy as np

from cloner.body.head_pose_evidence import HeadEvidence, Params, RestHead, head_evidence, turn_head
from cloner.body.outlined import OutlinedPhoto
from cloner.calibration.loader import calibrated
from cloner.fit.evidence import Residuals
from cloner.fit.problem import ParameterBlock, Problem, Values
from cloner.frames import ViewId
from cloner.hair.volumes.agreement import HairField, hairline_residuals
from cloner.head.skin_matches import SkinMatches
from cloner.records.arrays import Array
from cloner.records.bodies import BodyMesh, PosedView
from cloner.records.points import ViewPoints

#: What each number is and where it comes from: ``cloner/calibration/body.toml``.
_CALIBRATED: Final = calibrated("body.head_pose")


_MAX_STEP_RAD = _CALIBRATED.number("step_rad", "rad")
#: A photo without a face, and one in which nothing was looked up.
UNSEEN = np.zeros((0, 2))
NOTHING = SkinMatches(np.zeros(0, dtype=np.int64), np.zeros((0, 2)), np.zeros(0))


def fit_head_poses(
    mesh: BodyMesh,
    photos: Mapping[ViewId, OutlinedPhoto],
    points: Mapping[ViewId, ViewPoints],
    faces_px: Mapping[ViewId, Array],
    face_errors_m: Array,
    lines: Mapping[ViewId, HairField],
    look: Callable[[Mapping[ViewId, PosedView]], Mapping[ViewId, SkinMatches]],
) -> dict[ViewId, PosedView]:
    """Return the photos' poses with neck and head rotated as each photo shows them.

    Parameters
    ----------
    mesh : BodyMesh
        The joined person in rest pose, in the frame of the photos' cameras.
    photos : mapping of ViewId to Outlined
        Pose, camera and outline of each photo.
    points : mapping of ViewId to ViewPoints
        Named points of body photos.
    faces_px : mapping of ViewId to (468, 2)
        The face net's points where a body photo shows a face.
    face_errors_m : (468, 2)
        What the net makes of this face when it looks straight at the camera: right and down in the picture.
    lines : mapping of ViewId to HairField
        Hairlines of the photos that show hair.
    look : callable
        Gives the skin that is found in some photos, from the poses so far.
    """
    params, head = Params(), RestHead.of(mesh)
    turning = {view: functools.partial(turn_head, photos[view].posed, pivot_m=head.pivot_m) for view in lines}
    spots: dict[ViewId, SkinMatches] = {}

    def seen(view: ViewId, angles: Array) -> HeadEvidence:
        face, spot = faces_px.get(view, UNSEEN), spots.get(view, NOTHING)
        return head_evidence(head, photos[view], angles, points.get(view), face, face_errors_m, spot, params)

    def stood(values: Values) -> dict[ViewId, PosedView]:
        return {view: turn_head(photo.posed, values[view], head.pivot_m) for view, photo in photos.items()}

    def linearise(values: Values, iteration: int) -> Iterator[Residuals]:
        if iteration == params.looks_at:
            spots.update(look(stood(values)))
        for view in photos:
            sight = first[view] if iteration == 0 else seen(view, values[view])
            yield Residuals((view, "hair"), *sight.linear(values[view], values["hair"]))
        yield from hairline_residuals(mesh, lines, turning, {view: values[view] for view in lines})

    usual = {view: np.deg2rad(_prior_angles_deg(view, params)) for view in photos}
    blocks = {
        view.value: ParameterBlock(np.zeros(len(u)), sigma=u, max_step=_MAX_STEP_RAD) for view, u in usual.items()
    }
    first = {view: seen(view, np.zeros(len(u))) for view, u in usual.items()}
    mean, sigma = np.transpose(params.thickness_mm)
    # from usual hair an afro's outline would count as another thing's
    begin = np.append(median_hair_thickness_mm(first, mean[0]), mean[1:])
    blocks["hair"] = ParameterBlock(begin, mean, sigma)
    return stood(Problem(blocks).solve(linearise, iterations=params.iterations).values)


def median_hair_thickness_mm(sights: Mapping[ViewId, HeadEvidence], otherwise_mm: float) -> float:
    """Return the median thickness of hair above the skull over all photos; `otherwise_mm` where none shows hair."""
    thickness_mm = np.concatenate([sight.thickness_mm() for sight in sights.values()])
    return float(np.median(thickness_mm)) if len(thickness_mm) else otherwise_mm


def _prior_angles_deg(view: ViewId, params: Params) -> tuple[float, ...]:
    """Return the prior sigmas of a photo's angles, degrees: three of the neck and three of the head, or a face photo's
    pitch.
    """
    return (params.nod_deg,) if view.is_face else (*[params.neck_deg] * 3, *[params.head_deg] * 3)
