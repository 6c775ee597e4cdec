"""Pictures of clones beside the truth: where the silhouettes differ, and both surfaces in one light."""

from __future__ import annotations

from collections.abc import Mapping
from pathlib import Path
from typing import Any, Final

import cv2
import numpy as np
from body_truth import KnownPerson
from numpy.typing import NDArray

from cloner.evaluate.figures import likeness
from cloner.evaluate.measures.posing import fit_rotations
from cloner.frames import ViewId
from cloner.generic.load import load_generic
from cloner.geometry.meshes.wedges import vertex_normals
from cloner.records.clones import Clone
from cloner.render import Layer, clone_layers, draw, render_mask

Image = NDArray[np.uint8]
Mask = NDArray[np.bool_]

PANEL_PX: Final = 520  # height of one panel
_TRUE_ONLY: Final = (230, 40, 40)
_CLONE_ONLY: Final = (50, 90, 255)
_CLAY: Final = (0.72, 0.62, 0.56)


def write_person(path: Path, row: Mapping[str, Any], known: KnownPerson, clone: Clone) -> None:
    """Write two rows of pictures: photos with the differences of the silhouettes; true and cloned surface."""
    from body_truth import true_view

    generic = load_generic()
    held = true_view(known.shots["body_three_quarter"])
    rotations = fit_rotations(clone, generic, held.joints_m, held.points_m, clone.views[ViewId.BODY_FRONT].rotations)
    seen = {view.value: (posed.camera, posed.rotations) for view, posed in clone.views.items() if view.is_body}
    seen[held.name] = (likeness.held_out_camera(clone, rotations, generic, held), rotations)
    columns = []
    for name, shot in known.shots.items():
        camera, turned = seen[name]
        above = differences(shot.rgb, shot.mask, render_mask(clone, camera, turned))
        normals = vertex_normals(shot.dressed_m, known.dressed.triangles.astype(np.int32))
        true = [Layer(shot.dressed_m, normals, known.dressed.triangles.astype(np.int32), colour=_CLAY)]
        below = np.hstack([cropped(draw(layers, eye, shading="soft"), shot.mask)
                           for layers, eye in ((true, shot.camera), (clay(clone, turned), camera))])  # fmt: skip
        columns.append(stacked([cropped(above, shot.mask), below]))
    path.parent.mkdir(parents=True, exist_ok=True)
    picture = np.hstack(columns)
    cv2.imwrite(str(path), captioned(picture, caption(row))[..., ::-1])


def clay(clone: Clone, rotations: NDArray[np.float64]) -> list[Layer]:
    """Return the clone's layers in one colour."""
    layers = clone_layers(clone, rotations)
    return [
        Layer(layer.vertices_m, layer.normals, layer.triangles, colour=_CLAY, two_sided=layer.two_sided)
        for layer in layers
        if layer.texture is None or layer.texture.shape[2] == 3 or layer.two_sided
    ]


def differences(photo: Image, true: Mask, found: Mask) -> Image:
    """Return a darkened photo; red where only the truth is, blue where only the clone is."""
    picture = (photo * 0.55 + 50).astype(np.uint8)
    picture[true & ~found] = _TRUE_ONLY
    picture[found & ~true] = _CLONE_ONLY
    return picture


def cropped(picture: Image, mask: Mask) -> Image:
    """Return the picture around a person, `PANEL_PX` high and as wide as his own shape wants."""
    rows, columns = np.flatnonzero(mask.any(axis=1)), np.flatnonzero(mask.any(axis=0))
    margin = int(0.03 * np.ptp(rows))
    top, bottom = max(rows[0] - margin, 0), min(rows[-1] + margin, len(mask))
    left, right = max(columns[0] - margin, 0), min(columns[-1] + margin, mask.shape[1])
    part = picture[top:bottom, left:right]
    return np.asarray(
        cv2.resize(part, (round(PANEL_PX * part.shape[1] / len(part)), PANEL_PX), interpolation=cv2.INTER_AREA)
    )


def stacked(pictures: list[Image]) -> Image:
    """Return pictures one below the other, centred on white."""
    width = max(picture.shape[1] for picture in pictures)
    padded = []
    for picture in pictures:
        spare = width - picture.shape[1]
        padded.append(np.pad(picture, ((0, 0), (spare // 2, spare - spare // 2), (0, 0)), constant_values=255))
    return np.vstack(padded)


def caption(row: Mapping[str, Any]) -> str:
    """Return one line about a person's figures."""
    step = row["steps"]["finished"]
    overlaps = " ".join(f"{view[5:]} {value:.3f}" for view, value in step["silhouette_iou"].items())
    return f"{row['name']}  IoU {overlaps}  surface {step['surface_mean_mm']:.1f} / p95 {step['surface_p95_mm']:.1f} mm"


def captioned(picture: Image, words: str) -> Image:
    """Return the picture below a line of words."""
    bar = np.full((34, picture.shape[1], 3), 255, np.uint8)
    cv2.putText(bar, words, (8, 24), cv2.FONT_HERSHEY_SIMPLEX, 0.6, (20, 20, 20), 1, cv2.LINE_AA)
    return np.vstack([bar, picture])
