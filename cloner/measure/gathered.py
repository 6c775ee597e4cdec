"""Evidence of the photos about a clone's measures, for the product and for learning."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from cloner.body.outlined import OutlinedPhoto, outline_distances_mm, posed_silhouette
from cloner.frames import ViewId
from cloner.generic.tape import load_tape_rules
from cloner.geometry.measurement.measuring import measures_mm
from cloner.measure.covering import find_covers
from cloner.measure.naked_girths import naked_girths
from cloner.measure.rumpled import garments_rumples_mm
from cloner.measure.side_arms import hidden_rows
from cloner.records.arrays import Array
from cloner.records.bodies import BodyMesh
from cloner.records.clones import Joined
from cloner.records.loose import AROUND_LEGS
from cloner.records.measures import Cover
from cloner.records.proposals import Proposals
from cloner.records.silhouettes import SilhouetteSet


@dataclass(frozen=True, slots=True, eq=False)
class MeasureEvidence:
    """Evidence of one person's photos about measures; K measures in the order of `ALL_KEYS`.

    Attributes
    ----------
    shown_mm : mapping of str to float
        Measures of the clone's skin, clothes included.
    cover : mapping of str to Cover
        By segment.
    around_legs : bool
        Whether a skirt or a coat hangs around the legs.
    gap_mm : float
        Mean gap between the body's rim and the outlines.
    rumple_mm : (2,) float64
        How rumpled the outline of the clothes is above and below the waist; NaN where not seen.
    hidden : (K,) bool
        Where an arm hides the depth of the trunk in the side photo.
    under_mm : (K,) float64
        Girths that the label net sees under the clothes; NaN where it sees none.
    """

    shown_mm: Mapping[str, float]
    cover: Mapping[str, Cover]
    around_legs: bool
    gap_mm: float
    rumple_mm: Array
    hidden: NDArray[np.bool_]
    under_mm: Array


def gather_measures(
    joined: Joined,
    mesh: BodyMesh,
    outlined: Mapping[ViewId, OutlinedPhoto],
    silhouettes: SilhouetteSet,
    proposals: Proposals,
) -> MeasureEvidence:
    """Return the evidence of the photos about a clone's measures.

    Parameters
    ----------
    joined : Joined
        Whose skin is measured.
    mesh : BodyMesh
        The fitted body, which is compared with the photos.
    outlined : mapping of ViewId to Outlined
        At least one photo.
    silhouettes : SilhouetteSet
    proposals : Proposals
    """
    shown = measures_mm(joined.vertices_m, joined.joints_m, load_tape_rules(), joined.sole_m)
    regions = [region for silhouette in silhouettes.views.values() for region in silhouette.loose]
    seen = {view: posed_silhouette(mesh, photo) for view, photo in outlined.items()}
    cover = find_covers(proposals, joined)
    return MeasureEvidence(
        shown,
        cover,
        around_legs=any(region.name == AROUND_LEGS for region in regions),
        gap_mm=float(np.mean([outline_distances_mm(seen[view], photo)[""] for view, photo in outlined.items()])),
        rumple_mm=garments_rumples_mm(seen, outlined, silhouettes, cover),
        hidden=hidden_rows(mesh.vertices_m, seen),
        under_mm=naked_girths(mesh, shown, seen, proposals),
    )
