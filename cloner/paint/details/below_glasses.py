"""Photos without the glasses that somebody wears in them: the frame has a shell of its own."""

from __future__ import annotations

from dataclasses import replace
from typing import Final

import cv2
import numpy as np
from numpy.typing import NDArray

from cloner.generic.load import GenericHuman
from cloner.geometry.meshes.rasters import rasterise
from cloner.labels.glasses import glasses_frame
from cloner.paint.lookups.posed import posed_shell
from cloner.records.bodies import PosedView
from cloner.records.clones import Joined
from cloner.records.heads import Shell
from cloner.records.labels import Label, shows
from cloner.records.photos import PhotoSet
from cloner.records.proposals import Proposal, Proposals

#: Removed around the frame, as a share of its width, 1.6 mm: labels end inside the frame and its shade.
RIM_SHARE: Final = 0.012


def remove_glasses(
    generic: GenericHuman, joined: Joined, photos: PhotoSet, proposals: Proposals, glasses: Shell | None
) -> tuple[PhotoSet, Proposals]:
    """Return photos and proposals with the skin around a frame in its place.

    The frame is what labels call so and, labels losing thin frames, what the fitted one covers of skin.

    Parameters
    ----------
    glasses : Shell, None where the frame's shape could not be made out
    """
    taken, proposed = dict(photos.photos), dict(proposals.views)
    for view in proposed.keys() & taken.keys():
        proposal = proposed[view]
        frame = glasses_frame(proposal)
        if glasses is not None and view in joined.views and (view.is_front or view.is_side):
            skin = shows(proposal.labels, Label.FACE_SKIN, Label.BODY_SKIN, Label.ACCESSORY)
            frame |= skin & _covered(generic, joined, joined.views[view], glasses, proposal.labels.shape)
        rgb, proposed[view] = fill_frame(taken[view].rgb, proposal, frame)
        taken[view] = replace(taken[view], rgb=rgb)
    return replace(photos, photos=taken), replace(proposals, views=proposed)


def fill_frame(
    rgb: NDArray[np.uint8], proposal: Proposal, frame: NDArray[np.bool_]
) -> tuple[NDArray[np.uint8], Proposal]:
    """Return a photo (H, W, 3) and its proposal with a spectacle frame (H, W) replaced by the skin around it.

    Small holes are filled from their rims (A. Telea, An image inpainting technique based on the fast marching method,
    2004).
    """
    rows, columns = np.flatnonzero(frame.any(axis=1)), np.flatnonzero(frame.any(axis=0))
    if not rows.size:
        return rgb, proposal
    around = max(2, int(RIM_SHARE * np.ptp(columns)))
    wide = cv2.dilate(frame.astype(np.uint8), np.ones((2 * around + 1,) * 2, np.uint8))
    reach = 4 * around
    box = np.s_[max(rows[0] - reach, 0) : rows[-1] + reach, max(columns[0] - reach, 0) : columns[-1] + reach]
    filled = rgb.copy()
    filled[box] = cv2.inpaint(np.ascontiguousarray(rgb[box]), wide[box], 2.0 * around, cv2.INPAINT_TELEA)
    return filled, replace(proposal, labels=np.where(frame, np.uint8(Label.FACE_SKIN), proposal.labels))


def _covered(
    generic: GenericHuman, joined: Joined, view: PosedView, shell: Shell, shape: tuple[int, ...]
) -> NDArray[np.bool_]:
    """Return the pixels (H, W) of a photo that a shell covers, whatever is before it."""
    px = view.camera.project(posed_shell(generic, joined, view, shell))
    pixel, _, _ = rasterise(px, shell.triangles, shape[1], shape[0])
    covered = np.zeros(shape[0] * shape[1], np.bool_)
    covered[pixel] = True
    return covered.reshape(shape[:2])
