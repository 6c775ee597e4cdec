"""One height of hair: photos with a nodding head, or that lose fine hair, are brought to the median height.

Where photos must agree, the one that shows the lowest crown would cut all hair flat.
"""

from __future__ import annotations

from dataclasses import replace
from typing import Final

import numpy as np

from cloner.frames import m_from_mm
from cloner.hair.volumes.views import HairView
from cloner.records.arrays import Array

#: A crown is where hair is so wide: a single lock is none, mm.
CROWN_MM: Final = 40.0


def align_crowns(views: list[HairView], scalp_m: Array, ears_m: float) -> list[HairView]:
    """Return the views with the median photo's height of hair above the ears.

    Parameters
    ----------
    views : list of HairView
    scalp_m : (N, 3) of the head at rest
    ears_m : float
        Height of the ears; what is below stays.
    """
    middle = scalp_m.mean(axis=0)[None]
    tall = {view.posed.view: crown_height_m(view, middle) - ears_m for view in views if view.flip_m is None}
    known = [height for height in tall.values() if height > 0.0]
    if not known:
        return views
    usual = float(np.median(known))
    return [
        replace(view, above_m=ears_m, taller=tall[view.posed.view] / usual) if tall[view.posed.view] > 0.0 else view
        for view in views
    ]


def crown_height_m(view: HairView, middle_m: Array) -> float:
    """Return the height of a photo's highest hair, rest frame, m; minus infinity where it shows none.

    Parameters
    ----------
    view : HairView
    middle_m : (1, 3) of the head at rest: so far from the camera
    """
    posed = view.to_view(middle_m)
    wide = np.flatnonzero(m_from_mm(view.pixel_mm(posed)) * view.hair.sum(axis=1) > m_from_mm(CROWN_MM))
    if not wide.size or wide[0] == 0:  # cut by the picture's edge
        return -np.inf
    pixel = np.array([[np.flatnonzero(view.hair[wide[0]]).mean(), wide[0]]], np.float64)
    return float(view.to_rest(view.posed.camera.back_project(pixel, posed))[0, 1])
