"""Small pictures for judging a clone: beside the photos, and with what was measured in them."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace
from pathlib import Path
from typing import Final

import numpy as np
from numpy.typing import NDArray
from PIL import Image, ImageDraw

from cloner.exporters.shared.files import jpeg_bytes, write_bytes
from cloner.frames import ViewId
from cloner.generic.layers import clone_layers
from cloner.generic.load import load_generic
from cloner.head.jaw import with_closed_jaw
from cloner.records.bodies import PosedView
from cloner.records.clones import Clone
from cloner.records.photos import Photo, PhotoSet
from cloner.records.points import PointSet
from cloner.records.proposals import Proposal, Proposals
from cloner.records.silhouettes import Silhouette, SilhouetteSet
from cloner.records.views import Camera
from cloner.render import Shading, coverage, draw, standard_camera

FOLDER: Final = "previews"
HEIGHT_PX: Final = 1000  # taste: a screen's height
MARGIN: Final = 0.05  # taste: air around the person, share of the person's height
#: Colours of the backdrop, of outlines in the photo and of the clone, and of points by where they come from (taste).
_BACKDROP: Final = (226, 228, 230)
_EXTRACTED: Final = (40, 220, 60)
_CLONE: Final = (255, 40, 220)
_PROPOSED: Final = (0, 200, 255)
_CORRECTED: Final = (255, 210, 0)
_NET: Final = (150, 190, 255)

Pixels = NDArray[np.uint8]


@dataclass(frozen=True, slots=True)
class _Window:
    """The part of a photo that a preview shows, and its scale.

    Attributes
    ----------
    left, top, right, bottom : int
        In pixels of the scaled photo.
    scale : float
        Preview pixels a photo pixel.
    """

    left: int
    top: int
    right: int
    bottom: int
    scale: float

    def crop(self, picture: Pixels) -> Pixels:
        """Return the window of a picture that was drawn at this scale."""
        return picture[self.top : self.bottom, self.left : self.right]

    def place(self, points_px: NDArray[np.float64]) -> NDArray[np.float64]:
        """Return photo pixels in the cropped preview; pixel centres stay centres."""
        return np.asarray((points_px + 0.5) * self.scale - 0.5 - [self.left, self.top])


def write_previews(
    clone: Clone,
    photos: PhotoSet,
    proposals: Proposals,
    points: Sequence[PointSet],
    silhouettes: SilhouetteSet,
    folder: Path,
) -> list[Path]:
    """Write all pictures into ``folder/previews`` and return their paths.

    ``beside_<view>``: photo and clone through the same camera in the same
    pose. ``overlay_<view>``: the photo with its feature points (blue; yellow
    where an operator placed them), the extracted outline (green) and the
    clone's outline (magenta). ``three_quarter``: the clone alone from four
    sides, softly lit, at one scale; ``face`` large and unlit, as photos show
    it; ``head`` softly lit from the sides and behind.

    Parameters
    ----------
    points : sequence of PointSet
        All that the fit used, body and face.

    Raises
    ------
    ClonerError
        If the folder cannot be written to.
    """
    pictures: dict[str, Pixels] = {}
    for view, photo in photos.photos.items():
        posed = clone.views.get(view)
        if posed is None:
            continue
        camera, window = _frame(photo, posed, silhouettes.views.get(view))
        # A laugh is shown with closed lips: an opened jaw alone would be a mouth without teeth.
        layers = clone_layers(clone, with_closed_jaw(load_generic(), posed.rotations))
        drawn = window.crop(draw(layers, camera, background=_BACKDROP))
        seen = window.crop(_resized(photo.rgb, camera))
        pictures[f"beside_{view}"] = np.hstack([seen, drawn])
        cover = window.crop((coverage(layers, camera, supersample=1) > 0.5).astype(np.uint8)) > 0
        net = proposals.views.get(view)
        pictures[f"overlay_{view}"] = _overlay(seen, cover, window, silhouettes.views.get(view), points, net, view)
    pictures["three_quarter"] = _strip(clone, ("three_quarter", "front", "left", "back"), HEIGHT_PX * 4 // 5, "soft")
    pictures["face"] = _strip(clone, ("face", "face_three_quarter"), HEIGHT_PX)
    pictures["head"] = _strip(clone, ("face_left", "face_side", "face_back"), HEIGHT_PX // 2, "soft")
    paths = []
    for name, picture in pictures.items():
        paths.append(folder / FOLDER / f"{name}.jpg")
        write_bytes(paths[-1], jpeg_bytes(picture, quality=88))
    return paths


def _frame(photo: Photo, posed: PosedView, silhouette: Silhouette | None) -> tuple[Camera, _Window]:
    """Return the photo's camera at preview size and the window around the person."""
    width, height = photo.width_px, photo.height_px
    left, top, right, bottom = 0, 0, width, height
    if posed.view.is_body and silhouette is not None and silhouette.mask.any():
        rows, columns = (np.flatnonzero(silhouette.mask.any(axis=axis)) for axis in (1, 0))
        air = MARGIN * float(rows[-1] - rows[0])
        left, right = int(max(columns[0] - air, 0)), int(min(columns[-1] + air, width))
        top, bottom = int(max(rows[0] - air, 0)), int(min(rows[-1] + air, height))
    scale = min(HEIGHT_PX / (bottom - top), 1.0)
    camera = scaled_camera(posed.camera, scale)
    right_edge, bottom_edge = min(round(right * scale), camera.width_px), min(round(bottom * scale), camera.height_px)
    return camera, _Window(round(left * scale), round(top * scale), right_edge, bottom_edge, scale)


def scaled_camera(camera: Camera, scale: float) -> Camera:
    """Return the camera of the same photo at another size."""
    return Camera(
        round(camera.width_px * scale),
        round(camera.height_px * scale),
        camera.focal_px * scale,
        camera.camera_from_model,
        None if camera.pixels_per_m is None else camera.pixels_per_m * scale,
    )


def _resized(rgb: Pixels, camera: Camera) -> Pixels:
    """Return a photo at its scaled camera's size."""
    size = (camera.width_px, camera.height_px)
    return np.asarray(Image.fromarray(rgb).resize(size, Image.Resampling.BOX, reducing_gap=2.0))


def _overlay(
    seen: Pixels,
    cover: NDArray[np.bool_],
    window: _Window,
    silhouette: Silhouette | None,
    points: Sequence[PointSet],
    net: Proposal | None,
    view: ViewId,
) -> Pixels:
    """Return the photo with outlines and points drawn on it."""
    marked = seen.copy()
    marked[_boundary_band(cover)] = _CLONE
    image = Image.fromarray(marked)
    pen = ImageDraw.Draw(image)
    for contour in silhouette.contours_px if silhouette is not None else ():
        line = window.place(contour)
        pen.line([*map(tuple, line.tolist()), tuple(line[0].tolist())], fill=_EXTRACTED, width=2)
    if net is not None and view.is_face and net.face_presence > 0.5:
        for x, y in window.place(net.face_px).tolist():
            pen.point((round(x), round(y)), fill=_NET)
    for named in (each.views[view] for each in points if view in each.views):
        for (x, y), corrected in zip(window.place(named.points_px).tolist(), named.corrected.tolist(), strict=True):
            colour = _CORRECTED if corrected else _PROPOSED
            pen.ellipse((x - 4, y - 4, x + 4, y + 4), outline=colour, width=2)
    return np.asarray(image)


def _boundary_band(mask: NDArray[np.bool_]) -> NDArray[np.bool_]:
    """Return the pixels of a mask within two pixels of its boundary, without the picture's own border."""
    inside = mask.copy()
    for _ in range(2):
        padded = np.pad(inside, 1, mode="edge")
        inside = padded[:-2, 1:-1] & padded[2:, 1:-1] & padded[1:-1, :-2] & padded[1:-1, 2:] & inside
    return mask & ~inside


def _strip(clone: Clone, views: Sequence[str], height_px: int, shading: Shading = "photo") -> Pixels:
    """Return the resting clone from several sides at one scale, side by side."""
    cameras = same_distance([standard_camera(clone, view, height_px, height_px) for view in views])
    layers = clone_layers(clone)
    pictures = [draw(layers, camera, shading=shading, background=_BACKDROP) for camera in cameras]
    return np.hstack([_trimmed(picture) for picture in pictures])


def same_distance(cameras: Sequence[Camera]) -> list[Camera]:
    """Return level cameras of one lens at the distance of the farthest, so that their pictures are to one scale.

    The distance is measured to the model's vertical axis, along each camera's own line of sight.
    """
    axis = [float(camera.to_camera(camera.position_m[None] * (0.0, 1.0, 0.0))[0, 2]) for camera in cameras]
    moved = []
    for camera, distance in zip(cameras, axis, strict=True):
        matrix = camera.camera_from_model.copy()
        matrix[2, 3] += max(axis) - distance
        moved.append(replace(camera, camera_from_model=matrix))
    return moved


def _trimmed(picture: Pixels) -> Pixels:
    """Return a picture without its empty columns, but for some air."""
    other = picture != np.array(_BACKDROP, dtype=np.uint8)
    columns = np.flatnonzero(other.reshape(len(picture), -1).any(axis=0).reshape(-1, 3).any(axis=1))
    if not columns.size:
        return picture
    air = round(MARGIN * picture.shape[0])
    return picture[:, max(int(columns[0]) - air, 0) : int(columns[-1]) + air + 1]
