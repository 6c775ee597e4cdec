"""Photos compared on the surface: evened light, disagreement, colours where no photo sees."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from cloner.baking.sources import Source
from cloner.frames import ViewId
from cloner.generic.load import GenericHuman
from cloner.geometry.graphs import SurfaceGraph
from cloner.records.results import Residual
from cloner.vision.aligning import sample
from cloner.vision.evening import REFERENCE_HOLD, SECOND_HOLD, apply_light, even_light, light_basis
from cloner.vision.painting import MOUTH_RGB

Array = NDArray[np.float64]

TRUSTED_COSINE = 0.45  # photos are compared where both see the surface at less than 63 degrees
FILL_STIFFNESS = 0.02  # taste: seen colours hold, unseen ones are harmonic
# The face's tone counts most: neck and hands are matched to it.
_REFERENCES = (ViewId.FACE_FRONT, ViewId.BODY_FRONT, ViewId.BODY_BACK, ViewId.BODY_SIDE, ViewId.FACE_SIDE)


def vertex_colours(sources: list[Source]) -> Array:
    """Return (K, V, 3) slightly blurred colours of every vertex in every photo, levels."""
    return np.stack([sample(s.plate.blurred, s.lookup_px) for s in sources]).astype(np.float64)


def even_photos(sources: list[Source], colours: Array, normals: Array) -> Array:
    """Return (K, 4, 3) log gains per source that even out exposure, white balance and light."""
    trust = np.stack([_trust(source) for source in sources])
    first = min(_REFERENCES.index(source.view) for source in sources)
    held = {ViewId.BODY_FRONT: SECOND_HOLD, _REFERENCES[first]: REFERENCE_HOLD}
    hold = np.array([held.get(source.view, 1.0) for source in sources])
    return even_light(colours, trust, normals, hold)


def _trust(source: Source) -> Array:
    """Return (V,) weights for comparing photos; mirrored ones count little, halves differ."""
    steep = np.clip((source.sight.cosine - TRUSTED_COSINE) / (1.0 - TRUSTED_COSINE), 0.0, 1.0)
    return np.where(source.score > 0.0, steep, 0.0) * (0.25 if source.mirrored else 1.0)


def evened_colours(colours: Array, gains: Array, normals: Array) -> Array:
    """Return (K, V, 3) vertex colours after evening, levels."""
    basis = light_basis(normals)
    return np.stack([apply_light(colours[k], basis @ gains[k]) for k in range(len(colours))])


def compare_photos(sources: list[Source], colours: Array, gains: Array, normals: Array) -> list[Residual]:
    """Return per photo the median difference to the others on shared surface, before and after, grey levels."""
    evened = evened_colours(colours, gains, normals)
    trust = np.stack([_trust(source) for source in sources])
    found: list[Residual] = []
    for k, source in enumerate(sources):
        if source.mirrored:
            continue
        others = [j for j, s in enumerate(sources) if j != k and not s.mirrored]
        shared = [(j, (trust[k] > 0) & (trust[j] > 0)) for j in others]
        for name, values in (("photo_disagreement_raw", colours), ("photo_disagreement", evened)):
            gaps = [np.abs(values[k, rows] - values[j, rows]).mean(axis=1) for j, rows in shared if rows.any()]
            if gaps:
                found.append(Residual(name, float(np.median(np.concatenate(gaps))), "levels", str(source.view)))
    return found


def fill_surface(
    generic: GenericHuman, sources: list[Source], evened: Array, graph: SurfaceGraph
) -> NDArray[np.float32]:
    """Return (V, 3) a smooth colour for every vertex: seen ones keep theirs, others spread along the surface."""
    score = np.stack([source.score for source in sources])
    weight = score.sum(axis=0)
    colour = (score[..., None] * evened).sum(axis=0) / np.maximum(weight, 1e-9)[:, None]
    weight = np.clip(weight * 2.0, 0.0, 1.0)
    inside = generic.region("mouth_interior")
    colour[inside], weight[inside] = MOUTH_RGB, 1.0
    return np.clip(graph.fill(colour, weight, FILL_STIFFNESS), 0.0, 255.0).astype(np.float32)
