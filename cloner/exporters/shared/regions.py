"""Region masks of the atlas, for recolouring a clone's clothes or hair."""

from __future__ import annotations

import io
import json
from functools import lru_cache
from pathlib import Path
from typing import Final

import numpy as np
from numpy.typing import NDArray
from PIL import Image

from cloner.exporters.shared.files import write_bytes
from cloner.generic.charts import generic_atlas
from cloner.generic.load import load_generic
from cloner.records.clones import Clone
from cloner.records.regions import REGIONS

LARGEST_PX: Final = 1024  # labels are as coarse as triangles: more texels would tell no more
#: Level of texels that belong to no region.
NOTHING: Final = 255
#: Colours of the labels for people who look at the picture.
_SHOWN: Final = (230, 190, 165, 90, 55, 30, 255, 255, 255, 200, 60, 80, 60, 110, 220, 60, 180, 90, 40, 40, 40)


def export(clone: Clone, folder: Path, *, name: str = "clone") -> tuple[Path, ...]:
    """Write ``textures/<name>_regions.png`` and ``.json`` and return their paths.

    The picture lies on the clone's atlas; its palette's numbers are the places of the names in the JSON, 255 is outside
    the charts.

    Raises
    ------
    ClonerError
        If the folder cannot be written to.
    """
    image = Image.fromarray(region_texels(clone, min(LARGEST_PX, len(clone.atlas.rgb))), mode="P")
    image.putpalette([*_SHOWN, *[0] * (768 - len(_SHOWN))])
    stream = io.BytesIO()
    image.save(stream, "PNG")
    picture, legend = (folder / "textures" / f"{name}_regions.{suffix}" for suffix in ("png", "json"))
    write_bytes(picture, stream.getvalue())
    write_bytes(legend, json.dumps({"regions": list(REGIONS), "outside": NOTHING, "stamp": clone.stamp}).encode())
    return picture, legend


def region_texels(clone: Clone, size: int) -> NDArray[np.uint8]:
    """Return (size, size) places in `REGIONS` of the atlas' texels, `NOTHING` outside the charts."""
    shown = texel_triangles(size)
    if not len(clone.triangle_regions):
        return np.full(shown.shape, NOTHING, dtype=np.uint8)
    return np.append(clone.triangle_regions, NOTHING).astype(np.uint8)[shown]


@lru_cache(maxsize=3)  # the same for everybody, and most formats ask
def texel_triangles(size: int) -> NDArray[np.int32]:
    """Return the (size, size) triangle that each texel of the atlas shows, -1 outside the charts; read only."""
    atlas = generic_atlas(load_generic(), size)
    shown = np.full(size * size, -1, dtype=np.int32)
    shown[atlas.texel] = atlas.triangle
    shown.setflags(write=False)
    return shown.reshape(size, size)
