"""Photos normalised on the surface: exposure, white balance and light; and fills where no photo sees it."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from cloner.frames import ViewId
from cloner.generic.load import GenericHuman
from cloner.geometry.meshes.graphs import SurfaceGraph
from cloner.paint.lookups.flattened import flatten_halves, flatten_slants, soften_glare
from cloner.paint.lookups.materials import Materials, is_skin_colour, shown_bare_share
from cloner.paint.lookups.sources import Source, shown_colours
from cloner.parallel import parallel_map
from cloner.records.arrays import Array
from cloner.records.results import Residual
from cloner.vision.retouching.normalising import (
    CLOTH_REFERENCES,
    FLATTENED_CLOTH,
    REFERENCE_HOLD,
    apply_light,
    beyond_light,
    common_balance,
    even_light,
    exposure_confidence,
    light_basis,
    light_coordinates,
    log_levels,
    one_sided_light,
    reference_index,
)
from cloner.vision.retouching.painting import paint_mouth

TRUSTED_COSINE = 0.45  # photos are compared where both see the surface at less than 63 degrees
SKIN_PRIOR = 1.0  # taste: how much one colour of skin counts against another photo of the same place
FADE = 0.08  # against data of weight 1: a correction dies away over sqrt(LEVEL_STIFFNESS / FADE) = 5 edges
LEVEL_STIFFNESS = 2.0  # taste: a correction follows no detail finer than some edges
FILL_STIFFNESS = 0.02  # taste: seen colours hold, unseen ones are harmonic
FILL_TRUST = 0.1  # a colour seen worse than this spreads nowhere
BURNT_WEIGHT = 0.02  # burnt-out colours spread only where there is nothing else
NEAREST_WEIGHT = 2e-4  # the nearest colour holds a little, so that borders of cloth do not melt over a hole
# The face's tone counts most: neck and hands are matched to it.
_REFERENCES = (ViewId.FACE_FRONT, ViewId.BODY_FRONT, ViewId.BODY_BACK, ViewId.BODY_SIDE, ViewId.FACE_SIDE)


def vertex_colours(sources: list[Source]) -> Array:
    """Return (K, V, 3) slightly blurred colours of every vertex in every photo, levels."""
    return np.stack([shown_colours(s, s.lookup_px, blurred=True) for s in sources]).astype(np.float64)


def normalise_photos(
    generic: GenericHuman,
    sources: list[Source],
    colours: Array,
    normals: Array,
    kinds: Materials,
    graph: SurfaceGraph,
) -> Array:
    """Return log gains (K, V, 3) per source and vertex that normalise exposure, white balance and light.

    Four steps, each on what the one before left: light from one side, told by
    the person's own symmetry; one exposure and first-order light a photo, told
    by shared surface; the white balance of all photos; and glare on skin. Skin and cloth are evened
    each by its own kind: cameras and developers bend dark cloth otherwise than skin.

    Parameters
    ----------
    colours : (K, V, 3) levels
    normals : (V, 3) unit
    kinds : Materials
    """
    trust = np.stack([_comparison_weights(source) for source in sources]) * exposure_confidence(colours)
    skin, worn = (kinds.bare > 0.5) & (kinds.scalp < 0.5), kinds.worn > 0.5
    halves = flatten_halves(sources, colours, skin, generic.mirror, graph)
    bare = _normalise_kind(sources, colours, normals, trust * skin, halves, SKIN_PRIOR)
    sides = _without_one_sided_light(generic, sources, colours, trust * worn, normals)
    light = kinds.bare[:, None] * bare
    light += kinds.worn[:, None] * _normalise_kind(sources, colours, normals, trust * worn, sides, 0.0)
    first = reference_index(_shown(sources), _REFERENCES)
    if (trust[first] * skin).any():
        logs = np.asarray(log_levels(colours), np.float64) + light
        plain = np.median(logs[first, (trust[first] > 0.0) & skin], axis=0)
        light += kinds.bare[:, None] * soften_glare(sources, logs, skin, plain, graph)
    return np.asarray(light)


def match_borders(
    generic: GenericHuman, sources: list[Source], colours: Array, light: Array, kinds: Materials, graph: SurfaceGraph
) -> Array:
    """Return log gains (K, V, 3): ``light`` (K, V, 3) plus a smooth remainder along the borders between photos.

    So no border needs a wide blend in the atlas. What is left on skin is shade where it turns away from all photos.

    Parameters
    ----------
    colours : (K, V, 3) levels, not yet evened
    """
    score = np.stack([source.score for source in sources])
    light = light + border_gains(normalised_colours(colours, light), score, exposure_confidence(colours), graph)
    logs = np.asarray(log_levels(colours), np.float64) + light
    skin = (kinds.bare > 0.5) & (kinds.scalp < 0.5)
    return np.asarray(light + (kinds.bare * flatten_slants(generic, sources, logs, skin, graph))[:, None])


def _normalise_kind(
    sources: list[Source], colours: Array, normals: Array, trust: Array, own: Array, prior: float
) -> Array:
    """Return log gains (K, V, 3): ``own`` (K, V, 3) plus what matches the photos, weighted by ``trust`` (K, V).

    With a ``prior`` > 0 the surface is thought of one colour as well, by that share of a photo's
    trust: light that overlaps do not show is told by the skin itself.
    """
    level = normalised_colours(colours, own)
    first = reference_index(_shown(sources), _REFERENCES if prior > 0.0 else CLOTH_REFERENCES)
    hold = np.where(np.arange(len(sources)) == first, REFERENCE_HOLD, 1.0)
    rows = trust[first] > 0.0
    if prior > 0.0 and rows.any():
        plain = np.median(level[first, rows], axis=0)
        level = np.concatenate([level, np.tile(plain, (1, len(normals), 1))])
        trust = np.concatenate([trust, prior * trust.max(axis=0, keepdims=True)])
        hold = np.append(hold, REFERENCE_HOLD)
    gains = even_light(level, trust, normals, hold)[: len(sources)]
    light = own + np.einsum("vb,kbc->kvc", light_basis(normals), gains)
    photos = np.array([not source.mirrored for source in sources])
    return np.asarray(light + common_balance(colours, light, trust[: len(sources)], photos))


def _shown(sources: list[Source]) -> list[tuple[ViewId, bool]]:
    """Return each source's photo and whether it is mirrored."""
    return [(source.view, source.mirrored) for source in sources]


def _without_one_sided_light(
    generic: GenericHuman, sources: list[Source], colours: Array, trust: Array, normals: Array
) -> Array:
    """Return log gains (K, V, 3) that reduce one-sided light on cloth in photos that show both halves."""
    light = np.zeros((len(sources), len(normals), 3))
    for k, source in enumerate(sources):
        if source.view.is_side:
            continue
        slope = one_sided_light(np.asarray(log_levels(colours[k]), np.float64), trust[k], normals, generic.mirror)
        light[k] = -FLATTENED_CLOTH * normals[:, :1] * slope
    return light


def _comparison_weights(source: Source) -> Array:
    """Return weights (V,) for comparing photos; mirrored ones count little, as halves differ."""
    steep = np.clip((source.visibility.cosine - TRUSTED_COSINE) / (1.0 - TRUSTED_COSINE), 0.0, 1.0)
    return np.where(source.score > 0.0, steep, 0.0) * (0.25 if source.mirrored else 1.0)


def border_gains(colours: Array, claim: Array, trust: NDArray[np.floating], graph: SurfaceGraph) -> Array:
    """Return smooth log gains (K, V, 3) that match photos along their borders.

    Where photos agree on what they show, each is drawn towards their mean,
    weighted by claim; the correction dies away over some ten edges. Where they
    differ by more than light can, they show different things: no correction.

    Parameters
    ----------
    colours : (K, V, 3) levels after evening
    claim : (K, V) >= 0
    trust : (K, V) in 0..1
        What is burnt out moves to what is not.

    References
    ----------
    Lempitsky and Ivanov 2007, "Seamless mosaicing of image-based texture maps" (seam levelling), with data
    from the whole overlap instead of one line.
    """
    logs = np.asarray(log_levels(colours), np.float64)
    share, trusted = (part**2 / np.maximum((part**2).sum(axis=0), 1e-12) for part in (claim, claim * trust))

    def gains(k: int) -> Array:
        pull, mass, data = np.zeros(logs.shape[1:]), trusted[k].copy(), np.zeros(logs.shape[1])
        for j in range(len(logs)):
            if j == k:
                continue
            gap = logs[j] - logs[k]
            alike = 1.0 / (1.0 + beyond_light(gap) ** 4)
            part = trusted[j] * alike * (claim[k] > 0.0)
            pull += part[:, None] * gap
            mass += part
            data += np.sqrt(share[k] * share[j]) * alike
        weight = np.clip(2.0 * data, 0.0, 1.0)
        goal = weight[:, None] * pull / np.maximum(mass, 1e-9)[:, None]
        return graph.fill(goal / (weight + FADE)[:, None], weight + FADE, LEVEL_STIFFNESS)

    return np.stack(list(parallel_map(gains, range(len(logs)))))


def normalised_colours(colours: Array, light: Array) -> Array:
    """Return vertex colours (K, V, 3) after normalisation, levels."""
    return np.stack([apply_light(colours[k], light[k]) for k in range(len(colours))])


def compare_photos(sources: list[Source], colours: Array, light: Array) -> list[Residual]:
    """Return each photo's median difference to the others on shared surface, before and after, grey levels."""
    evened = normalised_colours(colours, light)
    trust = np.stack([_comparison_weights(source) for source in sources])
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
    generic: GenericHuman, sources: list[Source], evened: Array, kinds: Materials, graph: SurfaceGraph
) -> NDArray[np.float32]:
    """Return (3, V, 3) smooth colours of skin, hair and cloth for every vertex.

    Seen vertices keep their own in the field of their kind; elsewhere each
    field spreads along the surface by itself, so that a hole beside a collar
    is filled with skin above the line and cloth below it.  Skin spreads from what has the person's colour alone:
    a collar's rim or the shade of a jaw does not run down the neck.
    """
    shown = shown_bare_share(generic, sources)
    skin = kinds.bare * (1.0 - kinds.scalp)

    def field(of_kind: tuple[Array, Array]) -> Array:
        kind, alike = of_kind
        colour, weight = _mean_shown(generic, sources, evened, alike)
        own = weight * np.clip(2.0 * kind - 1.0, 0.0, 1.0)
        if kind is skin:
            own *= is_skin_colour(np.asarray(log_levels(colour), np.float64), own > FILL_TRUST)
        if not (own > FILL_TRUST).any():  # no photo shows this kind: whatever is there must do
            colour, own = _mean_shown(generic, sources, evened, np.ones_like(shown))
        near = colour[graph.nearest(own > FILL_TRUST)]
        return graph.fill(near, np.maximum(own, NEAREST_WEIGHT), FILL_STIFFNESS, light_coordinates(near))

    all_kinds = ((skin, shown), (kinds.bare * kinds.scalp, shown), (kinds.worn, 1.0 - shown))
    return np.clip(np.stack(list(parallel_map(field, all_kinds))), 0.0, 255.0).astype(np.float32)


def _mean_shown(generic: GenericHuman, sources: list[Source], evened: Array, alike: Array) -> tuple[Array, Array]:
    """Return mean colours (V, 3) of the photos that show one kind, and how well it is seen (V,)."""
    score = np.stack([source.score for source in sources]) * alike
    total = score.sum(axis=0)
    colour = (score[..., None] * evened).sum(axis=0) / np.maximum(total, 1e-9)[:, None]
    weight = np.clip(total * 2.0, 0.0, 1.0) * np.maximum(exposure_confidence(colour), BURNT_WEIGHT)
    inside = generic.region("mouth_interior")
    lips_m = generic.vertices_m[generic.feature("stomion"), 2]
    colour[inside], weight[inside] = paint_mouth(lips_m - generic.vertices_m[inside, 2]), 1.0
    return colour, weight
