"""Height of the hair above the skull, estimated from the face below it.

The stature ends at the skull, a photo's outline at the hair. What lies between is read from how far the outline's top
is above the eyes, in lengths from the eyes to the chin: high hair, or a high cap, stands far above a face. Faces
differ, so the belief is a regression's: nearer to what is usual than the photo alone says. Who is bald has none.
"""

from __future__ import annotations

from typing import Final

import numpy as np
from numpy.typing import NDArray

from cloner.calibration.loader import calibrated
from cloner.frames import ViewId
from cloner.labels.states import State, read_states
from cloner.records.proposals import Proposals
from cloner.records.silhouettes import SilhouetteSet

#: What each number is and where it comes from: ``cloner/calibration/body.toml``.
_CALIBRATED: Final = calibrated("body.hair_height")

USUAL_MM: Final = _CALIBRATED.number("usual_mm", "mm")
FACE_MM: Final = _CALIBRATED.number("face_mm", "mm")
BARE_MM: Final = _CALIBRATED.number("bare_mm", "mm")
SPREAD_MM: Final = _CALIBRATED.number("spread_mm", "mm")
BALD_SPREAD_MM: Final = _CALIBRATED.number("bald_spread_mm", "mm")
#: Google's face mesh: outer corners of the eyes, chin.
EYES: Final = (33, 263)
CHIN: Final = 152


def height_above_eyes(face_px: NDArray[np.float64], top_px: float) -> float:
    """Return the height of a photo's top row above the eyes, as a multiple of the distance from eyes to chin.

    Parameters
    ----------
    face_px : (468, 2) float64
        Face mesh in photo pixels.
    top_px : float
        Row of the highest point of the person.
    """
    eyes_px = float(face_px[list(EYES), 1].mean())
    return (eyes_px - top_px) / (float(face_px[CHIN, 1]) - eyes_px)


def hair_height_mm(proposals: Proposals, silhouettes: SilhouetteSet) -> tuple[float, float]:
    """Return the height of hair above the skull and its sigma, mm; people's mean where no body photo shows a face."""
    proposal, outline = proposals.views.get(ViewId.BODY_FRONT), silhouettes.views.get(ViewId.BODY_FRONT)
    if proposal is None or outline is None or proposal.face_presence == 0.0:
        return USUAL_MM, SPREAD_MM
    if _is_bald(proposals):
        return 0.0, BALD_SPREAD_MM
    share = height_above_eyes(proposal.face_px, outline.top_px)
    return max(FACE_MM * share - BARE_MM, 0.0), SPREAD_MM


def _is_bald(proposals: Proposals) -> bool:
    """Return whether the face's front photo shows a bare scalp."""
    face = proposals.views.get(ViewId.FACE_FRONT)
    return (
        face is not None
        and face.face_presence > 0.0
        and State.BALD in read_states({face.view: face.labels}, face.face_px)
    )
