"""Photos with far less or far more hair than the others: hair lost before a similar wall, or a wrong pose."""

from __future__ import annotations

from typing import Final

import numpy as np

from cloner.frames import ViewId
from cloner.hair.volumes.views import HairView
from cloner.records.arrays import Array

#: Square millimetres of the person above the ears, against the median of the other photos: eleven generated people
#: have .75 to 1.35 (sides are deeper than fronts are wide), with a tail high on the crown 1.7; a white afro before a
#: pale wall .2. Far larger is a head that its camera sees at a wrong size.
LEAST, MOST = 0.6, 2.5
#: With fewer photos nobody knows which one is wrong.
FEWEST: Final = 3


def inconsistent_views(views: list[HairView], ears_m: Array) -> dict[ViewId, float]:
    """Return the photos whose amount of hair disagrees with the others, with its ratio.

    Parameters
    ----------
    views : list of HairView
    ears_m : (3,)
        The head's middle at the height of the ears' tops, at rest.
    """
    hairy = [view for view in views if view.flip_m is None and view.hair.any()]  # a bald front is not odd
    shown = {view.posed.view: area_above_ears_mm2(view, ears_m) for view in hairy}
    odd: dict[ViewId, float] = {}
    while len(shown) - len(odd) >= FEWEST:
        kept = {name: area for name, area in shown.items() if name not in odd}
        share = {
            name: area / max(float(np.median([other for each, other in kept.items() if each != name])), 1.0)
            for name, area in kept.items()
        }
        worst = max(share, key=lambda name: abs(np.log(max(share[name], 1e-3))))
        if LEAST <= share[worst] <= MOST:
            break
        odd[worst] = share[worst]
    return odd


def area_above_ears_mm2(view: HairView, ears_m: Array) -> float:
    """Return the area of a photo's person above the ears, mm2."""
    posed = view.to_view(ears_m[None])
    row = int(np.clip(view.posed.camera.project(posed)[0, 1], 0, len(view.outline_px)))
    return float(np.count_nonzero(view.outline_px[:row] > 0.0)) * view.pixel_mm(posed) ** 2
