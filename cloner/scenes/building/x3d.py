"""A room as X3D: base texture times light map, with two sets of texture coordinates.

The light map lies in the room's folder (``light.png``, white standing for 2). ``MODULATE2X`` doubles coded values: 1.2
stops more than the map says, about what a room's exposure adds (``crowd/staged/daylight.py``).

References: Web3D Consortium 2023, ISO/IEC 19775-1, section 18.4.6 (MultiTexture).
"""

from __future__ import annotations

from typing import Final
from xml.sax.saxutils import quoteattr

import numpy as np
from numpy.typing import NDArray

from cloner.exporters.shared.files import jpeg_bytes
from cloner.scenes.building.charts import make_charts
from cloner.scenes.building.gltf import make_meshes
from cloner.scenes.building.solids import Room

TEXTURES: Final = "textures"
_HEAD: Final = (
    '<?xml version="1.0" encoding="UTF-8"?>\n'
    '<!DOCTYPE X3D PUBLIC "ISO//Web3D//DTD X3D 3.3//EN" "https://www.web3d.org/specifications/x3d-3.3.dtd">\n'
    '<X3D profile="Immersive" version="3.3">\n'
)


def room_x3d(room: Room, light: str) -> dict[str, bytes]:
    """Return a lit room's X3D file and its textures by their names in the room's folder.

    Parameters
    ----------
    room : Room
    light : str
        Where the light map lies, from there.
    """
    meshes = make_meshes(*make_charts(room), room.looks)
    found = {f"{TEXTURES}/{one.look}.jpg": jpeg_bytes(room.looks[one.look].pixels) for one in meshes}
    x, _, z = _middle(room)
    rows = [_HEAD, f'<head><meta name="title" content={quoteattr(room.plan.name)}/></head>\n<Scene>\n']
    rows.append('<NavigationInfo type=\'"WALK" "EXAMINE" "ANY"\' headlight="false" avatarSize="0.25 1.6 0.75"/>\n')
    rows.append(f'<Viewpoint description="inside" position="{x:.3f} 1.6 {z:.3f}"/>\n')
    for mesh in meshes:
        index = " ".join(f"{a} {b} {c} -1" for a, b, c in mesh.triangles)
        uv = mesh.uv * (1.0, -1.0)  # X3D counts rows from below
        light_uv = np.column_stack([mesh.light_uv[:, 0], 1.0 - mesh.light_uv[:, 1]])
        rows.append(
            '<Shape><Appearance><Material diffuseColor="0 0 0" emissiveColor="1 1 1"/>'
            '<MultiTexture mode=\'"MODULATE" "MODULATE2X"\'>'
            f"<ImageTexture url='\"{TEXTURES}/{mesh.look}.jpg\"'/>"
            f'<ImageTexture repeatS="false" repeatT="false" url=\'"{light}"\'/></MultiTexture></Appearance>\n'
            f'<IndexedFaceSet solid="true" coordIndex="{index}"><Coordinate point="{_numbers(mesh.places)}"/>'
            f'<Normal vector="{_numbers(mesh.normals)}"/><MultiTextureCoordinate>'
            f'<TextureCoordinate point="{_numbers(uv)}"/><TextureCoordinate point="{_numbers(light_uv)}"/>'
            "</MultiTextureCoordinate></IndexedFaceSet></Shape>\n"
        )
    rows.append("</Scene>\n</X3D>\n")
    return {"room.x3d": "".join(rows).encode("utf-8"), **found}


def _middle(room: Room) -> NDArray[np.float64]:
    floor = max(room.plan.floors, key=lambda one: (one.high[0] - one.low[0]) * (one.high[1] - one.low[1]))
    return np.array([(floor.low[0] + floor.high[0]) / 2.0, 0.0, -floor.low[1] - 0.1 * (floor.high[1] - floor.low[1])])


def _numbers(rows: NDArray[np.float64]) -> str:
    return ", ".join(" ".join(f"{one:.5g}" for one in row) for row in rows)
