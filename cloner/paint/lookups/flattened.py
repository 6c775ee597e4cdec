"""Removal of hard light on skin without a model of the lamp: by left-right symmetry, and by highlights.

A lamp at one side draws a terminator and the nose's shadow on a face: no light of low order says so. But
people are alike on both halves, and skin is hardly anywhere much brighter than most of it is.
"""

from __future__ import annotations

from typing import Final

import numpy as np
from numpy.typing import NDArray

from cloner.generic.load import GenericHuman
from cloner.generic.photo_shares import head_weight
from cloner.geometry.meshes.graphs import SurfaceGraph
from cloner.paint.lookups.sources import Source
from cloner.parallel import parallel_map
from cloner.records.arrays import Array
from cloner.vision.retouching.normalising import FLATTENED, HUE_LOG, LEAST_PAIRS, log_levels

SEEN_COSINE: Final = (0.2, 0.5)  # from nothing to full trust in what a photo shows of a half
STIFFNESS: Final = 2.0  # light follows no detail finer than some edges: moles and scars stay where they are
WARMEST: Final = 2.0 * HUE_LOG  # a warm lamp before a cool sky; what differs more in hue is paint
GLARE_STIFFNESS: Final = 0.3  # glare ends at hair and collars
UNSEEN: Final = 1e-4  # weight at which halves nobody can compare follow their neighbours
LARGEST_HALF: Final = 0.1  # taste: log level by which a half may stay lighter than the mean of both
FREE_GLARE: Final = 0.12  # log level by which skin is lighter than most of it in soft light (sample visitors)
LARGEST_GLARE: Final = 0.1  # taste: what hard light may leave beyond that
#: From nothing to full trust in the light on skin that a photo faces so well: what turns away from all of them lies
#: in a shade of their lamps.
FACED: Final = (0.6, 0.88)
SLANT_STIFFNESS: Final = 2.0  # as `STIFFNESS`
SHADE: Final = 0.3  # log level beyond which a slant is no shade but a nostril or a beard
LARGEST_SHADE: Final = 0.15  # taste; .25 costs .5 dE against photos in the same hard light


def flatten_halves(
    sources: list[Source], colours: Array, skin: NDArray[np.bool_], twin: NDArray[np.integer], graph: SurfaceGraph
) -> Array:
    """Return log gains (K, V, 3) that match the two halves of skin in photos that show both.

    Soft light keeps most of its side; of hard light only as much is left as soft light has.

    Parameters
    ----------
    sources : list of K photos; side photos get no gain
    colours : (K, V, 3) levels
    skin : (V,)
    twin : (V,) each vertex's mirror image
    """

    def gains(k: int) -> Array:
        source, (low, high) = sources[k], SEEN_COSINE
        shown = np.where(
            (source.score > 0.0) & skin, np.clip((source.visibility.cosine - low) / (high - low), 0.0, 1.0), 0.0
        )
        both = np.minimum(shown, shown[twin])
        if source.view.is_side or np.count_nonzero(both) < LEAST_PAIRS:
            return np.zeros(colours.shape[1:])
        logs = np.asarray(log_levels(colours[k]), np.float64)
        lean = graph.fill(0.5 * (logs - logs[twin]), both + UNSEEN, STIFFNESS)
        lean = 0.5 * (lean - lean[twin])
        return np.asarray(LARGEST_HALF * np.tanh((1.0 - FLATTENED) * lean / LARGEST_HALF) - lean)

    return np.stack(list(parallel_map(gains, range(len(sources)))))


def soften_glare(
    sources: list[Source], logs: Array, skin: NDArray[np.bool_], plain: Array, graph: SurfaceGraph
) -> Array:
    """Return log gains (K, V, 3), mostly negative, that bring hard-lit skin near the dominant skin colour.

    Only what is brighter: shade may be a beard. And only skin's own hue: faces may be painted.

    Parameters
    ----------
    logs : (K, V, 3) log levels after evening, also beyond what a picture holds
    skin : (V,)
    plain : (3,) log levels of most skin
    """

    def gains(k: int) -> Array:
        seen = (sources[k].score > 0.0) & skin
        if not seen.any():
            return np.zeros(logs.shape[1:])
        beyond = logs[k] - plain
        light = beyond.mean(axis=1, keepdims=True)
        glare = np.maximum(light - FREE_GLARE, 0.0)
        left = LARGEST_GLARE * np.tanh(glare / LARGEST_GLARE)
        hue = np.abs(beyond - light).mean(axis=1, keepdims=True)
        alike = 1.0 / (1.0 + (hue / WARMEST) ** 4)
        less = np.asarray(alike * (left - glare) / np.maximum(light, FREE_GLARE) * beyond, np.float64)
        return graph.fill(less, np.where(seen, 1.0, UNSEEN), GLARE_STIFFNESS)

    return np.stack(list(parallel_map(gains, range(len(sources)))))


def flatten_slants(
    generic: GenericHuman, sources: list[Source], logs: Array, skin: NDArray[np.bool_], graph: SurfaceGraph
) -> Array:
    """Return log gains (V,) on head skin that all photos see obliquely: it takes the light of its surroundings.

    Between front and side a cheek turns away from both and from the lamps beside both cameras: a dark strip down the
    face that no relighting explains.

    Parameters
    ----------
    logs : (K, V, 3) log levels after evening
    skin : (V,)
    """
    claim = np.stack([source.score for source in sources]) ** 2
    total = claim.sum(axis=0)
    shown = np.where(skin & (total > 0.0), 1.0, 0.0)
    if not shown.any():
        return np.zeros(len(skin))
    level = (claim[..., None] * logs).sum(axis=0) / np.maximum(total, 1e-12)[:, None]
    faced = np.stack([np.where(source.score > 0.0, source.visibility.cosine, 0.0) for source in sources]).max(axis=0)
    trust = shown * np.clip((faced - FACED[0]) / (FACED[1] - FACED[0]), 0.0, 1.0)
    own = graph.fill(level, np.maximum(shown, UNSEEN), SLANT_STIFFNESS)
    gap = graph.fill(level, np.maximum(trust, UNSEEN * shown), SLANT_STIFFNESS) - own
    light = gap.mean(axis=1)
    hue = np.abs(gap - light[:, None]).mean(axis=1)
    gain = LARGEST_SHADE * np.tanh(light / LARGEST_SHADE) / (1.0 + (light / SHADE) ** 4 + (hue / HUE_LOG) ** 4)
    ears = generic.region("ear_left") | generic.region("ear_right")
    return np.where(skin & ~ears, head_weight(generic) * (1.0 - trust) * gain, 0.0)
