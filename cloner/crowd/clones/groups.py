"""Ten recolourable groups of a clone's surface, their greys, and the clone's own outfit.

References
----------
McDonnell, Dobbyn, O'Sullivan 2007, Pipeline for Populating Games with Realistic Crowds: triangle groups with white
material; one greyscale texture with region codes in alpha. Mapping the seven regions to its eight groups is ours.
"""

from __future__ import annotations

import functools
from collections.abc import Mapping
from dataclasses import dataclass
from typing import Final

import cv2
import numpy as np
from numpy.typing import NDArray
from scipy.ndimage import distance_transform_edt

from cloner.crowd.clones.zones import zone_texels
from cloner.exporters.shared.regions import texel_triangles
from cloner.generic.load import GenericHuman, load_generic
from cloner.geometry.articulation.fingers import palm_normal
from cloner.geometry.meshes.vectors import unit
from cloner.records.clones import Clone
from cloner.records.regions import REGIONS

Pixels = NDArray[np.uint8]

#: The source's eight groups, then hair and mouth.
GROUPS: Final = ("eyes", "head", "arms", "nails", "legs", "top", "bottom", "shoes", "hair", "mouth")
#: Codes are far apart, so that a reader may round.
STEP: Final = 255 // len(GROUPS)
#: What outfits dye; nothing else is ever dyed, hair only where it was asked for.
WORN: Final = ("top", "bottom", "shoes")
#: Added to the code for each zone of a limb: clothes that end earlier there show skin, on the trunk the wearer's cloth.
ZONE_STEP: Final = 2
#: Codes go on this far beyond the charts, texels, so that their borders show no gap.
GROWN: Final = 6
#: Brightest share of a group that may be cut off when its grey is scaled to 8 bits; taste.
CUT_OFF: Final = 0.01
#: A nail covers this last part of a finger's end joint, and faces away from the palm; read off the generic human.
NAIL_FROM: Final = 0.45
NAIL_FACING: Final = 0.55
_LUMA: Final = np.array([0.2126, 0.7152, 0.0722])
_FROM_REGION: Final = {"hair": "hair", "eyes": "eyes", "mouth": "mouth", "upper_clothes": "top",
                       "lower_clothes": "bottom", "shoes": "shoes"}  # fmt: skip


def triangle_groups(clone: Clone) -> NDArray[np.uint8]:
    """Return the index in `GROUPS` of each triangle of the generic human, (T,), as this clone is dressed."""
    skin = _skin_groups().copy()
    for region, group in _FROM_REGION.items():
        skin[clone.triangle_regions == REGIONS.index(region)] = GROUPS.index(group)
    return skin


@functools.cache
def _skin_groups() -> NDArray[np.uint8]:
    """Return (T,) the group of each triangle of a naked body."""
    generic = load_generic()
    triangles, _ = generic.triangles()
    group = np.full(len(triangles), GROUPS.index("head"), np.uint8)
    segment = generic.vertex_segment[triangles[:, 0]]
    for number, name in enumerate(generic.segment_names):
        if "arm" in name or "hand" in name:
            group[segment == number] = GROUPS.index("arms")
        elif any(part in name for part in ("pelvis", "thigh", "calf", "foot")):
            group[segment == number] = GROUPS.index("legs")
    group[_nails(generic)[triangles].all(axis=1)] = GROUPS.index("nails")
    part = generic.vertex_part[triangles[:, 0]]
    for number, name in enumerate(generic.part_names):
        if name.startswith("eye_"):
            group[part == number] = GROUPS.index("eyes")
        elif name.startswith(("teeth", "tongue")):
            group[part == number] = GROUPS.index("mouth")
    group.setflags(write=False)
    return group


def _nails(generic: GenericHuman) -> NDArray[np.bool_]:
    """Return (V,) which vertices lie on fingernails: on the back of each finger's last phalanx."""
    found = np.zeros(len(generic.vertices_m), bool)
    places = generic.vertices_m.astype(np.float64)
    heaviest = np.take_along_axis(generic.skin_joints, generic.skin_weights.argmax(axis=1)[:, None], axis=1)[:, 0]
    triangles, _ = generic.triangles()
    faces = np.cross(
        places[triangles[:, 1]] - places[triangles[:, 0]], places[triangles[:, 2]] - places[triangles[:, 0]]
    )
    normals = np.zeros_like(places)
    for corner in range(3):
        np.add.at(normals, triangles[:, corner], faces)
    normals = unit(normals, 1e-12)
    for side in "lr":
        for finger in ("thumb", "index", "middle", "ring", "pinky"):
            joint, before = generic.joint(f"{side}_{finger}3"), generic.joint(f"{side}_{finger}2")
            own = np.flatnonzero((heaviest == joint) & (generic.vertex_part == 0))
            axis = generic.joints_m[joint] - generic.joints_m[before]
            axis = axis / np.linalg.norm(axis)
            along = (places[own] - generic.joints_m[joint]) @ axis
            back = _back(generic, side, axis)
            share = along / along.max()
            found[own[(share > NAIL_FROM) & (normals[own] @ back > NAIL_FACING)]] = True
    return found


def _back(generic: GenericHuman, side: str, axis: NDArray[np.float64]) -> NDArray[np.float64]:
    """Return the unit direction of a finger's back: perpendicular to the finger, away from the palm."""
    palm = palm_normal(generic, side)
    back = -palm + (palm @ axis) * axis
    return np.asarray(back / np.linalg.norm(back))


def texel_groups(groups: NDArray[np.uint8], size: int) -> Pixels:
    """Return the (size, size) codes of the atlas' texels: ``STEP * (place in GROUPS + 1)``, 0 outside the charts."""
    codes = np.append(STEP * (groups.astype(np.int64) + 1), 0).astype(np.uint8)
    return np.asarray(codes[texel_triangles(size)])


def garment_masks(codes: NDArray[np.uint8]) -> dict[str, NDArray[np.bool_]]:
    """Return which texels each garment covers."""
    return {name: codes == STEP * (GROUPS.index(name) + 1) for name in WORN}


def shader_codes(codes: Pixels) -> Pixels:
    """Return the codes as shaders read them: `ZONE_STEP` added per zone, and extended beyond the charts."""
    marked = codes + np.where(codes > 0, ZONE_STEP * zone_texels(len(codes)), 0).astype(np.uint8)
    away, (row, column) = distance_transform_edt(codes == 0, return_indices=True)
    return np.where(away <= GROWN, marked[row, column], 0).astype(np.uint8)


def sorted_by_group(
    triangles: NDArray[np.int32], uv: NDArray[np.float64], codes: Pixels
) -> tuple[NDArray[np.int32], dict[str, tuple[int, int]]]:
    """Return triangles (T, 3) sorted by group, and each group's first triangle and count.

    A triangle belongs where its middle lies in the atlas; parts of another texture than the atlas count as hair.
    """
    size = len(codes)
    middle = np.clip((uv[triangles].mean(axis=1) * size).astype(int), 0, size - 1)
    group = codes[middle[:, 1], middle[:, 0]].astype(int) // STEP
    order = np.argsort(group, kind="stable")
    ranges = {}
    for number, name in enumerate(GROUPS):
        own = np.flatnonzero(group[order] == number + 1)
        if len(own):
            ranges[name] = (int(own[0]), len(own))
    return triangles[order], ranges


@dataclass(frozen=True, slots=True)
class GroupLook:
    """Colours of one group of one clone.

    Attributes
    ----------
    colour : 3 floats 0..255
        The clone's own outfit: grey x colour is the texture.
    scale : float
        Luma (0..255) that grey 1 stands for.
    median : float
        Median luma of the group's texels, 0..255.
    evenness : float
        Power that a dye's grey takes, 0..1: below one where the cloth is so dark that noise would show.
    share : float
        Of the atlas' painted texels.
    """

    colour: tuple[float, float, float]
    scale: float
    median: float
    evenness: float
    share: float


#: Variation of luma against its mean that dyed cloth may show; taste: folds of bright cloth in the samples.
EVEN: Final = 0.35


def luma(rgb: NDArray[np.integer]) -> NDArray[np.float64]:
    """Return the (...) luma 0..255 of (..., 3) sRGB colours."""
    return np.asarray(rgb @ _LUMA)


def group_looks(rgb: Pixels, codes: Pixels) -> dict[str, GroupLook]:
    """Return the look of each visible group, from an atlas and its codes of the same size."""
    found = {}
    painted = max(int((codes > 0).sum()), 1)
    for number, name in enumerate(GROUPS):
        own = codes == STEP * (number + 1)
        if not own.any():
            continue
        colours = rgb[own].astype(np.float64)
        light = luma(colours)
        scale = max(float(np.quantile(light, 1.0 - CUT_OFF)), 1.0)
        grey = np.clip(light / scale, 0.0, 1.0)
        colour = (colours * grey[:, None]).sum(axis=0) / max(float((grey**2).sum()), 1e-9)
        spread = float(light.std() / max(light.mean(), 1.0))
        found[name] = GroupLook(
            tuple(np.clip(colour, 0.0, 255.0).tolist()),
            scale,
            max(float(np.median(light)), 1.0),
            min(1.0, EVEN / max(spread, 1e-9)),
            float(own.sum() / painted),
        )
    return found


def grey_atlas(rgb: Pixels, codes: Pixels, looks: Mapping[str, GroupLook]) -> Pixels:
    """Return the (S, S, 4) greyscale atlas: RGB the grey of each texel in its group's scale, A the code."""
    scale = np.ones(256)
    for name, look in looks.items():
        scale[STEP * (GROUPS.index(name) + 1)] = look.scale
    grey = np.clip(np.round(255.0 * luma(rgb) / scale[codes]), 0, 255).astype(np.uint8)
    grey[codes == 0] = 0
    return np.dstack([grey, grey, grey, codes])


def recolour(grey: Pixels, outfit: Mapping[str, tuple[float, float, float]]) -> Pixels:
    """Return the colours (S, S, 3) of a greyscale atlas in an outfit: one colour 0..255 per group."""
    table = np.zeros((256, 3))
    for name, colour in outfit.items():
        table[STEP * (GROUPS.index(name) + 1)] = colour
    return np.clip(np.round(grey[..., :1] / 255.0 * table[grey[..., 3]]), 0, 255).astype(np.uint8)


def exchange_garment(
    rgb: Pixels, codes: Pixels, donor_rgb: Pixels, donor_codes: Pixels, garment: str
) -> tuple[Pixels, Pixels]:
    """Return colours and codes of a wearer in a donor's garment.

    Where the donor's garment lies its texels are taken; where the wearer's own one reached farther along a limb, the
    median of the wearer's own skin of that limb fills in (inpainting would cross charts), on the trunk it stays.
    """
    code = STEP * (GROUPS.index(garment) + 1)
    new, old = donor_codes == code, codes == code
    out, new_codes = rgb.copy(), codes.copy()
    bare = old & ~new & (zone_texels(len(codes)) > 0)
    if bare.any():
        for name, colour in skin_colours(rgb, codes).items():
            part = bare & (_naked_codes(codes.shape[0]) == STEP * (GROUPS.index(name) + 1))
            out[part], new_codes[part] = colour, STEP * (GROUPS.index(name) + 1)
    out[new], new_codes[new] = donor_rgb[new], code
    return out, new_codes


def skin_colours(rgb: Pixels, codes: Pixels) -> dict[str, NDArray[np.uint8]]:
    """Return the median skin colour of head, arms and legs; covered ones take the nearest visible one's."""
    found: dict[str, NDArray[np.uint8]] = {}
    for name in ("arms", "legs", "head"):
        own = codes == STEP * (GROUPS.index(name) + 1)
        if own.sum() > 50:  # fewer texels are labels' borders
            found[name] = np.median(rgb[own], axis=0).astype(np.uint8)
    nearest = found.get("arms", found.get("head", found.get("legs", np.array([200, 160, 140], np.uint8))))
    return {name: found.get(name, nearest) for name in ("head", "arms", "legs")}


@functools.lru_cache(maxsize=3)
def _naked_codes(size: int) -> Pixels:
    return texel_groups(_skin_groups(), size)


def reduced(rgb: Pixels, size: int) -> Pixels:
    """Return an (S, S, k) picture reduced to (size, size, k) by area averaging."""
    return rgb if rgb.shape[0] == size else np.asarray(cv2.resize(rgb, (size, size), interpolation=cv2.INTER_AREA))
