"""A side photo of the face in which hair covers the profile: placed by the body's side photo, for its hair alone.

No profile places such a photo, yet nothing shows the hair's side as sharply. The same head stands smaller in the body's
side photo: one similarity lays the heads' outlines on each other, and with both photos taken level it gives the camera.
"""

from __future__ import annotations

from dataclasses import replace
from typing import Final

import cv2
import numpy as np
from numpy.typing import NDArray
from scipy.optimize import minimize

from cloner.frames import ViewId, m_from_mm
from cloner.generic.load import GenericHuman
from cloner.hair.volumes.views import HairView, hair_views
from cloner.head.size import head_camera
from cloner.records.arrays import Array
from cloner.records.bodies import PosedView
from cloner.records.clones import Joined
from cloner.records.labels import Label
from cloner.records.proposals import PERSON_LEVEL, Proposal, Proposals
from cloner.records.silhouettes import SilhouetteSet
from cloner.records.views import Camera

Floats = NDArray[np.float32]

#: Masks are compared at this long side, px, softened by so much for the search.
LONG_PX: Final = 280
SOFT_PX: Final = 1.5
#: Share of the figure's height in which a head with its hair lies.
HEAD_SHARE: Final = 0.42
#: The outlines are compared from the hair's top down to this many of its widths, then fading out: shoulders differ.
HEIGHT, FADE = 1.2, 0.2
#: Weight of the hair's own outline beside the person's. Errors of 31 heads of generated people (of 30501 to 30923) in
#: the photo, mean and median: 10.5 and 8.6 mm so, 11.4 and 9.0 at 0.3, 12.3 and 10.8 at 1, 14.7 and 11.7 with
#: shoulders.
HAIR_WEIGHT: Final = 0.1
#: Starts of the search: factors of the scale that makes the hairs equally wide.
SCALES: Final = (0.8, 0.9, 1.0, 1.1, 1.25)
#: Outlines that overlap less show something else: of 31 such heads 29 cost 0.02 to 0.06, mirrored 27 of 31 more than
#: this, beside another person 27 of 28.
UNLIKE: Final = 0.065
#: What lies nearer to the hair's edge than a head is placed wrongly may show a face or the wall.
PLACED_MM: Final = 8.0


def covered_side_views(
    generic: GenericHuman, joined: Joined, proposals: Proposals, silhouettes: SilhouetteSet, focal_px: float
) -> list[HairView]:
    """Return the hair of a side photo of the face that no profile placed; none where one did, or nothing can.

    Parameters
    ----------
    focal_px : float
        Focal length of the side photo of the face.

    Returns
    -------
    list of HairView
        As it is and mirrored. Pixels near the hair's edge are left out.
    """
    near = proposals.views.get(ViewId.FACE_SIDE) or proposals.covered.get(ViewId.FACE_SIDE)
    if near is None or ViewId.FACE_SIDE in joined.views or ViewId.BODY_SIDE not in joined.views:
        return []
    laid = align_heads(near, proposals.views[ViewId.BODY_SIDE])
    if laid is None:
        return []
    head_m = joined.vertices_m[generic.segment("head")].mean(axis=0)
    camera = level_camera(head_camera(joined.joints_m, joined.views[ViewId.BODY_SIDE]), laid, head_m, near, focal_px)
    posed = PosedView(ViewId.FACE_SIDE, camera, np.zeros_like(joined.views[ViewId.BODY_SIDE].rotations))
    alone = Proposals({ViewId.FACE_SIDE: near})
    placed = hair_views(generic, replace(joined, views={ViewId.FACE_SIDE: posed}), alone, silhouettes)
    least_px = m_from_mm(PLACED_MM) / camera.metres_per_pixel(head_m)
    return [replace(view, hair=view.hair & (view.hair_px > least_px)) for view in placed]


def level_camera(far: Camera, laid: Array, head_m: Array, near: Proposal, focal_px: float) -> Camera:
    """Return the camera of a photo of the head, level as another one and as a similarity between both photos says.

    Parameters
    ----------
    far : Camera
        Of the other photo, relative to the head at rest.
    laid : (2, 3)
        Pixels of the other photo from those of the photo.
    head_m : (3,)
        Middle of the head at rest.
    near : Proposal
        Of the photo.
    """
    height, width = near.mask.shape
    turn, shift = laid[:, :2], laid[:, 2]
    scale, roll = float(np.sqrt(np.linalg.det(turn))), float(np.arctan2(turn[1, 0], turn[0, 0]))
    level = Camera(width, height, focal_px, np.eye(4))
    pixel = np.linalg.solve(turn, far.project(head_m[None])[0] - shift)
    depth = focal_px * far.metres_per_pixel(head_m) * scale
    rolled = np.array([[np.cos(roll), np.sin(roll), 0.0], [-np.sin(roll), np.cos(roll), 0.0], [0.0, 0.0, 1.0]])
    pose = np.eye(4)
    pose[:3, :3] = rolled @ far.camera_from_model[:3, :3]
    pose[:3, 3] = depth * np.array([*((pixel - level.centre_px) / focal_px), 1.0]) - pose[:3, :3] @ head_m
    return replace(level, camera_from_model=pose)


def align_heads(near: Proposal, far: Proposal) -> Array | None:
    """Return the similarity (2, 3) from pixels of a side photo of a head to those of a side photo of the body.

    None where either shows no hair, or they show two heads or the two sides of one.
    """
    rows, columns = np.nonzero(far.person())
    if not rows.size:
        return None
    top = int(rows.min())
    end = top + int(HEAD_SHARE * np.ptp(rows))
    box = np.s_[top : end + 1, int(columns[rows <= end].min()) : int(columns[rows <= end].max()) + 1]
    shown, shrunk = _soft_masks(near, np.s_[:, :])
    wanted, reduced = _soft_masks(far, box)
    spread, offset = _width_and_top(shown[1]), _width_and_top(wanted[1])
    if spread is None or offset is None:
        return None
    size = (shown[0].shape[1], shown[0].shape[0])
    middle = 0.5 * np.array(size)
    fade = np.clip((spread[0] * HEIGHT + spread[1][1] - np.arange(size[1])) / (FADE * spread[0]), 0.0, 1.0)[:, None]

    def matrix(place: Array) -> Array:
        scale, turn = np.exp(place[0]), place[1]
        linear = scale * np.array([[np.cos(turn), -np.sin(turn)], [np.sin(turn), np.cos(turn)]])
        return np.column_stack([linear, place[2:] - linear @ middle])

    def cost(place: Array) -> float:
        total = 0.0
        for own, other, weight in zip(shown, wanted, (1.0, HAIR_WEIGHT), strict=True):
            laid = cv2.warpAffine(other, matrix(place), size, flags=cv2.INTER_LINEAR | cv2.WARP_INVERSE_MAP)
            both, either = (float((pick(own, laid) * fade).sum()) for pick in (np.minimum, np.maximum))
            total += weight * (1.0 - both / max(either, 1e-6))
        return total

    found = []
    for factor in SCALES:
        scale = factor * offset[0] / spread[0]
        start = np.array([np.log(scale), 0.0, *(offset[1] - scale * (spread[1] - middle))])
        simplex = start + np.vstack([np.zeros(4), np.diag([0.1, 0.06, 6.0, 6.0])])
        options = {"initial_simplex": simplex, "maxiter": 250, "xatol": 1e-3, "fatol": 1e-4}
        found.append(minimize(cost, start, method="Nelder-Mead", options=options))
    nearest = min(found, key=lambda one: float(one.fun))
    if float(nearest.fun) > UNLIKE:
        return None
    best = matrix(nearest.x)
    best[:, :2] *= shrunk / reduced
    best[:, 2] = best[:, 2] / reduced + (box[1].start, box[0].start)
    return best


def _soft_masks(proposal: Proposal, box: tuple[slice, slice]) -> tuple[tuple[Floats, Floats], float]:
    """Return person and hair of a photo's window, reduced and softened, and by what they were reduced."""
    person, hair = proposal.mask[box] > PERSON_LEVEL, proposal.labels[box] == Label.HAIR
    share = min(LONG_PX / max(person.shape), 1.0)
    size = (max(round(person.shape[1] * share), 1), max(round(person.shape[0] * share), 1))

    def soft(mask: NDArray[np.bool_]) -> Floats:
        small = cv2.resize(mask.astype(np.float32), size, interpolation=cv2.INTER_AREA)
        return np.asarray(cv2.GaussianBlur(small, (0, 0), SOFT_PX), np.float32)

    return (soft(person), soft(hair & person)), share


def _width_and_top(hair: Floats) -> tuple[float, Array] | None:
    """Return the greatest width of a mask, and its middle column at its top row, px."""
    shown = hair > 0.5
    rows = np.flatnonzero(shown.any(axis=1))
    if rows.size < 2:
        return None
    width = float(shown.sum(axis=1).max())
    return width, np.array([float(np.nonzero(shown)[1].mean()), float(rows[0])])
