"""Plain texture of a body without photos: skin tone, short hair, brows, lips, and underwear.

Children wear a shirt and shorts.
"""

from __future__ import annotations

from typing import Final

import numpy as np
from numpy.typing import NDArray

from cloner.generic.charts import generic_atlas
from cloner.generic.load import GenericHuman, load_generic
from cloner.geometry.charts.atlas import AtlasMap
from cloner.paint.details.parts import face_rgb, paint_parts
from cloner.records.arrays import Array
from cloner.records.bodies import BodyMesh
from cloner.records.clones import TextureAtlas
from cloner.records.regions import REGIONS
from cloner.stages.textures import pad_charts, parts_atlas

#: sRGB, taste: a skin between light and dark, and cloth that no region's rule takes for skin.
SKIN: Final = np.array([186.0, 145.0, 122.0])
HAIR: Final = np.array([58.0, 45.0, 38.0])
LIPS: Final = np.array([172.0, 116.0, 102.0])
BROWS: Final = np.array([84.0, 64.0, 53.0])
CLOTH: Final = np.array([96.0, 100.0, 108.0])
IRIS: Final = np.array([92.0, 70.0, 50.0])
#: Edges fade over this, metres.
SOFT_M: Final = 0.002
#: Levels that the knit goes up and down, and a hem's seam is darker; how far the seam lies from the edge, metres.
KNIT, HEM_SHADE, HEM_M = 3.0, 22.0, 0.010
#: Briefs reach so far above the crotch, shares of the generic stature; their legs rise to the sides.
BRIEFS: Final = (0.085, 0.75)
#: What `underwear` draws for children: a shirt and shorts, neutral as underwear is.
CHILD: Final = "child"
#: Their waist lies so far above the briefs', shorts reach below the crotch, the collar below the neck's base, metres at
#: 1.70 m; sleeves go so far from shoulder to elbow (taste).
WAIST_M, SHORTS_M, COLLAR_M, SLEEVE = 0.05, 0.20, 0.008, 0.6
#: Brows stand above the eyes, at 1.70 m: height, half thickness, metres.
BROW_M: Final = (0.019, 0.0035)
#: Grain of skin: levels, and metres of its smallest patches.
GRAIN: Final = 4.0


def painted(body: BodyMesh, worn: str, size: int, rng: np.random.Generator) -> TextureAtlas:
    """Return the atlas of a body that no photo shows: decent, and plain.

    Parameters
    ----------
    body : BodyMesh
    worn : str
        As for :func:`underwear`.
    size : int
        Side, texels.
    """
    generic = load_generic()
    atlas = generic_atlas(generic, size)
    rgb = np.tile(SKIN.round().astype(np.uint8), (size, size, 1))
    texels = np.tile(SKIN.astype(np.float32), (len(atlas.texel), 1))
    places = atlas.interpolate(generic.vertices_m.astype(np.float64))
    texels += GRAIN * grain(places, rng)[:, None]
    skin = atlas.interpolate(generic.skin.astype(np.float64)) > 0.5
    brows = np.where(skin, _brows(generic, places.astype(np.float64)), -1.0)
    for field, colour in ((brows, BROWS), *((atlas.interpolate(each), rgb_) for each, rgb_ in _fields(generic))):
        texels += _inside(field) * (colour.astype(np.float32) - texels)
    draw_underwear(texels, generic, worn, atlas)
    rgb.reshape(-1, 3)[atlas.texel] = np.clip(np.rint(texels), 0, 255)
    paint_parts(generic, parts_atlas(generic, size), rgb, body.vertices_m, face_rgb(generic, rgb), IRIS, 0.0, None, rng)
    return TextureAtlas(pad_charts(rgb, atlas.covered()), np.zeros((size, size), np.uint8))


def regions(worn: str) -> NDArray[np.uint8]:
    """Return (T,) places in `REGIONS` of the generic human's triangles as :func:`painted` paints them."""
    generic = load_generic()
    triangles, _ = generic.triangles()
    part = np.array([name.split("_")[0] for name in generic.part_names])[generic.vertex_part[triangles[:, 0]]]
    labels = np.full(len(triangles), REGIONS.index("skin"))
    fields = {name: field[triangles].mean(axis=1) > 0.0 for name, field in underwear(generic, worn).items()}
    labels[fields["briefs"]] = REGIONS.index("lower_clothes")
    labels[fields.get("top", np.zeros(len(triangles), bool))] = REGIONS.index("upper_clothes")
    labels[_hair(generic)[triangles].mean(axis=1) > 0.0] = REGIONS.index("hair")
    for name, region in (("eye", "eyes"), ("lashes", "hair"), ("teeth", "mouth"), ("tongue", "mouth")):
        labels[part == name] = REGIONS.index(region)
    return labels.astype(np.uint8)


def draw_underwear(texels: NDArray[np.float32], generic: GenericHuman, worn: str, atlas: AtlasMap) -> None:
    """Draw neutral underwear over (N, 3) texels of an atlas: a plain knit with a hem."""
    rows, columns = np.divmod(atlas.texel, atlas.shape[1])
    knit = KNIT * np.where((rows + columns) % 4 < 2, 1.0, -1.0).astype(np.float32)[:, None]
    for each in underwear(generic, worn).values():
        field = atlas.interpolate(each)
        hem = HEM_SHADE * np.clip(1.0 - np.abs(field - HEM_M) / SOFT_M, 0.0, 1.0)[:, None]
        texels += _inside(field) * (CLOTH.astype(np.float32) + knit - hem - texels)


def _inside(field: NDArray[np.float32]) -> NDArray[np.float32]:
    return np.asarray(np.clip(0.5 + field / (2.0 * SOFT_M), 0.0, 1.0)[:, None], np.float32)


def grain(points_m: NDArray[np.float32], rng: np.random.Generator) -> NDArray[np.float32]:
    """Return (N,) smooth unevenness about 0 of size one, from a few waves through space."""
    waves = rng.normal(size=(12, 3)) * rng.uniform(60.0, 500.0, (12, 1))
    phases = rng.uniform(0.0, 2.0 * np.pi, 12)
    return np.asarray(np.sin(points_m @ waves.T.astype(np.float32) + phases).mean(axis=1) * 2.0, np.float32)


def _fields(generic: GenericHuman) -> list[tuple[Array, Array]]:
    """Return signed distances (V,), metres, positive inside, and their colours; later ones lie above."""
    lips = np.where(generic.region("lips"), SOFT_M, -2.0 * SOFT_M)
    return [(lips, LIPS), (_hair(generic), HAIR)]


def underwear(generic: GenericHuman, worn: str) -> dict[str, Array]:
    """Return by "briefs" and "top" the signed distance (V,) of every vertex to its edge, metres, positive inside.

    Parameters
    ----------
    worn : str
        "m" briefs alone, "f" a top too; `CHILD` a shirt and shorts in their place.
    """
    places = generic.vertices_m.astype(np.float64)
    x, y = np.abs(places[:, 0]), places[:, 1]
    trunk = (generic.share("torso", "pelvis", "left_thigh", "right_thigh") - 0.5) * 0.1
    crotch = float(places[generic.feature("crotch"), 1])
    top = crotch + BRIEFS[0] * 1.7
    if worn == CHILD:
        return _shirt_and_shorts(generic, trunk, top + WAIST_M, crotch - SHORTS_M)
    legs = y - (crotch - 0.015 + BRIEFS[1] * np.maximum(x - 0.05, 0.0))
    found = {"briefs": np.minimum(np.minimum(top - y, legs), trunk)}
    if worn == "f":
        low = float(places[generic.feature("chest_front"), 1]) - 0.075
        high = float(places[generic.feature("armpit_left"), 1]) + 0.005
        found["top"] = np.minimum(np.minimum(y - low, high - y), trunk)
    return found


def _shirt_and_shorts(generic: GenericHuman, trunk: Array, waist_m: float, hem_m: float) -> dict[str, Array]:
    """Return as `underwear` does what lies within the trunk's and thighs' field (V,), and the sleeves."""
    places = generic.vertices_m.astype(np.float64)
    x, y = np.abs(places[:, 0]), places[:, 1]
    arms = (generic.share("torso", "pelvis", "head", "left_upper_arm", "right_upper_arm") - 0.5) * 0.1
    shoulder, elbow = (abs(float(generic.joints_m[generic.joint(f"l_{name}"), 0])) for name in ("shoulder", "elbow"))
    sleeve = shoulder + SLEEVE * (elbow - shoulder) - x
    collar = float(places[generic.feature("neck_base_L"), 1]) - COLLAR_M - y
    return {
        "briefs": np.minimum(np.minimum(waist_m - y, y - hem_m), trunk),
        "top": np.minimum(np.minimum(np.minimum(y - waist_m, collar), sleeve), arms),
    }


def _hair(generic: GenericHuman) -> Array:
    """Return the scalp as a signed distance over its border, two rows of vertices wide."""
    return np.where(generic.region("scalp"), SOFT_M, -SOFT_M)


def _brows(generic: GenericHuman, places_m: Array) -> Array:
    """Return (N,) signed distances, metres, of places on the generic human to its brows."""
    corners, found = generic.vertices_m.astype(np.float64), np.full(len(places_m), -1.0)
    above, half = BROW_M
    for side in ("L", "R"):
        inner, outer = (corners[generic.feature(f"eye_{end}_{side}")] for end in ("inner", "outer"))
        along = (places_m[:, 0] - inner[0]) / (outer[0] - inner[0])
        share = np.clip(along, -0.05, 1.2)
        curve = inner[1] + above + 0.006 * np.sin(0.8 * np.pi * share.clip(0.0)) + share * (outer[1] - inner[1])
        away = np.hypot((along - share) * (outer[0] - inner[0]), places_m[:, 1] - curve)
        thick = half * np.clip(1.2 - 0.8 * share, 0.25, 1.0)
        front = places_m[:, 2] > min(inner[2], outer[2]) - 0.03
        found = np.maximum(found, np.where(front, thick - away, -1.0))
    return found
