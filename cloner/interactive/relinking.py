"""An outline that follows an operator's points while they move, by relinking a stretch at a time."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass

import numpy as np

from cloner.errors import ClonerError
from cloner.records.arrays import Array
from cloner.records.photos import Photo
from cloner.records.points import Correction, ViewPoints
from cloner.records.proposals import Proposal
from cloner.stages.silhouettes import ON_OUTLINE, silhouette
from cloner.vision.contours.stretches import LinkableOutline, prepare_linking, relink_stretch

Contours = tuple[Array, ...]


@dataclass(frozen=True, slots=True, eq=False)
class LiveOutline:
    """One photo's outline, prepared for relinking.

    Attributes
    ----------
    ready : Linkable
    traced_px : tuple of (M, 2) float64
        The outline without corrections, closed polygons, px.
    """

    ready: LinkableOutline
    traced_px: Contours


@dataclass(frozen=True, slots=True, eq=False)
class Step:
    """The outline after one more point: its name, its position (2,) px, and the contours through it
    and those before.
    """

    name: str
    place_px: tuple[float, float]
    contours_px: Contours


def live_outline(photo: Photo, proposal: Proposal, points: ViewPoints | None) -> LiveOutline | None:
    """Return a photo's outline prepared for relinking; None where no outline is found.

    Parameters
    ----------
    photo : Photo
    proposal : Proposal
    points : ViewPoints or None
        The proposed points of a body photo.
    """
    ready = prepare_linking(photo.rgb, proposal.mask.astype(np.float32) / np.float32(255.0))
    if ready is None:
        return None
    try:
        return LiveOutline(ready, silhouette(photo, proposal, points).contours_px)
    except ClonerError:
        return None


def follow_corrections(
    outline: LiveOutline, steps: tuple[Step, ...], corrections: Mapping[str, Correction]
) -> tuple[Step, ...]:
    """Return the steps through all corrected outline points; the last one holds the outline.

    Parameters
    ----------
    outline : LiveOutline
    steps : tuple of Step
        Of the last call. What still holds of them is not linked again: a point that moves stands last after its first
        move, and costs one stretch from then on.
    corrections : mapping of str to Correction
        All of this photo; those that lie on no outline are left out.
    """
    wanted = {name: (at.x_px, at.y_px) for name, at in corrections.items() if name.startswith(ON_OUTLINE)}
    kept: list[Step] = []
    for step in steps:
        if wanted.get(step.name) != step.place_px:
            break
        kept.append(step)
    done, stood = {step.name for step in kept}, {step.name for step in steps if wanted.get(step.name) == step.place_px}
    placed = [step.place_px for step in kept]
    for name in sorted(wanted.keys() - done, key=lambda name: (name not in stood, name)):
        placed.append(wanted[name])
        before = kept[-1].contours_px if kept else outline.traced_px
        contours = relink_stretch(outline.ready, before, np.array(placed), np.array(wanted[name]))
        kept.append(Step(name, wanted[name], contours))
    return tuple(kept)
