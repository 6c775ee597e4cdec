"""Statues: a clone in stone, a photograph fitted to a clone by markers, a body of metaballs."""

from __future__ import annotations

import json
import tempfile
from pathlib import Path
from typing import Any, Final

import numpy as np

from cloner import pipeline
from cloner.bodies.made import clone_of_measures
from cloner.booth.studio.values import Figure, MarkedPhoto, Markers, Pixels, StatueWish
from cloner.errors import ClonerError
from cloner.frames import ViewId
from cloner.generic.load import load_generic
from cloner.geometry.cameras.viewpoints import facing_camera
from cloner.picture import clone_file, load_clone_at
from cloner.pipeline import Progress
from cloner.project.corrections import no_corrections
from cloner.project.folder import load_photo
from cloner.records.arrays import Array
from cloner.records.clones import Clone
from cloner.records.photos import Photo, PhotoSet
from cloner.stages.proposals import propose, resolve_hidden
from cloner.statues.blob_bodies import blob_folder, clone_of_blobs
from cloner.statues.blobs import Blob, written_blobs
from cloner.statues.carved import statue_of
from cloner.statues.markers import FORMAT, MARKED, known_points
from cloner.statues.photo_fit import fit_markers, fit_photo, focal_px_of, mark
from cloner.statues.photographed import USUAL, clone_with_photo, mesh_of, photo_folder
from cloner.statues.poses import standing
from cloner.statues.usual_blobs import usual_blobs
from cloner.statues.written import statue_folder
from cloner.vision.photographs.pictures import read_picture

#: Side of the texture that the usual man is shown in, texels.
_SHOWN_TEXELS: Final = 1024
#: A face of which nothing is known is as high as this share of its photo.
_FACE_SHARE: Final = 0.5


class Carving:
    """Jobs of the statues' windows."""

    def __init__(self) -> None:
        self._onto: tuple[tuple[Path | None, int], Clone] | None = None

    # --- a clone in stone --------------------------------------------------------------

    def carve(self, source: Path, material: str, pose: str, progress: Progress) -> Clone:
        """Return a clone in a material."""
        progress("textures", 0.2)
        return standing(statue_of(self._base(source), material), pose)

    def save_carved(self, source: Path, pose: str, wish: StatueWish, progress: Progress) -> Path:
        """Write a clone as a statue; see `cloner.statues.written.statue_folder`."""
        return statue_folder(
            source, wish.out, wish.identifier, material=wish.material, pose=pose, formats=wish.formats,
            progress=progress,
        )  # fmt: skip

    # --- a photograph on a clone --------------------------------------------------------

    def mark_photo(self, path: Path, onto: Path | None, progress: Progress) -> MarkedPhoto:
        """Return a photo with markers for the face points that the nets find in it."""
        progress("photos", 0.0)
        clone, picture = self._base(onto), read_picture(path)
        progress("proposals", 0.3)
        found = _seen(load_photo(path, ViewId.FACE_FRONT))
        focal = focal_px_of(picture.rgb.shape[1], picture.rgb.shape[0], picture.focal_35mm)
        markers = _placed(clone, found, (picture.rgb.shape[1], picture.rgb.shape[0]), focal)
        return MarkedPhoto(picture.rgb, focal, clone, markers, bool(found))

    def paint_photo(
        self, rgb: Pixels, focal_px: float, markers: Markers, onto: Path | None, material: str, progress: Progress
    ) -> Clone:
        """Return the clone with a photo fitted to it and extended all around, optionally in a material."""
        progress("textures", 0.0)
        clone, known = self._base(onto), known_points()
        vertices = np.array([one if isinstance(one, int) else known[one] for one in markers.at], np.int32)
        size = len(clone.atlas.rgb)
        fitted = fit_photo(mesh_of(clone), vertices, markers.px, rgb, focal_px=focal_px, size=size)
        progress("textures", 0.7)
        made = clone_with_photo(clone, fitted)
        return statue_of(made, material) if material else made

    def save_photo(
        self, photo: Path, markers: Markers, onto: Path | None, wish: StatueWish, progress: Progress
    ) -> Path:
        """Write the clone with a fitted photo; see `cloner.statues.photographed.photo_folder`."""
        whole, shown = read_picture(photo).original_size, read_picture(photo).rgb.shape[1]
        px = (markers.px + 0.5) * (whole[0] / shown) - 0.5  # the file tells places in the photo as it was taken
        data = [{"at": at, "px": place} for at, place in zip(markers.at, px.tolist(), strict=True)]
        with tempfile.TemporaryDirectory() as room:
            file = Path(room) / "markers.json"
            file.write_text(json.dumps({"format": FORMAT, "markers": data}), encoding="utf-8")
            folder, _ = photo_folder(
                photo, file, wish.out, wish.identifier, onto=onto, material=wish.material, formats=wish.formats,
                texture_size=wish.texels, progress=progress,
            )  # fmt: skip
        return folder

    # --- a body of blobs ------------------------------------------------------------------

    def begin_blobs(self, onto: Path | None, progress: Progress) -> tuple[Clone, tuple[Blob, ...]]:
        """Return a clone, the average man if none is named, and the metaballs that form its body."""
        progress("body", 0.3)
        clone = self._base(onto)
        return clone, usual_blobs(clone.vertices_m, clone.joints_m)

    def place_blobs(self, onto: Path | None, blobs: tuple[Blob, ...], progress: Progress) -> Figure:
        """Return the clone's skin fitted to metaballs."""
        progress("body", 0.0)
        made, _ = clone_of_blobs(self._base(onto), blobs)
        shells = tuple(shell.vertices_m for shell in made.shells)
        return Figure(made.vertices_m, made.joints_m, shells, made.measures_mm)

    def save_blobs(self, onto: Path | None, blobs: tuple[Blob, ...], wish: StatueWish, progress: Progress) -> Path:
        """Write a body of metaballs; see `cloner.statues.blob_bodies.blob_folder`."""
        with tempfile.TemporaryDirectory() as room:
            file = Path(room) / "blobs.json"
            file.write_text(written_blobs(blobs, self._base(onto).stamp), encoding="utf-8")
            folder, _ = blob_folder(
                file, wish.out, wish.identifier, onto=onto, material=wish.material, formats=wish.formats,
                texture_size=wish.texels, progress=progress,
            )  # fmt: skip
        return folder

    def _base(self, source: Path | None) -> Clone:
        """Return a clone, the average man if none is named; the latest one is cached."""
        key = source, 0 if source is None else clone_file(source).stat().st_mtime_ns
        if self._onto is None or self._onto[0] != key:
            made = clone_of_measures(USUAL, _SHOWN_TEXELS) if source is None else load_clone_at(source)
            self._onto = key, made
        return self._onto[1]


def _seen(photo: Photo) -> dict[str, Array]:
    """Return the pixels (2,) of a face's named points in a photo; empty if the nets find no face."""
    photos = PhotoSet({photo.view: photo})
    try:
        proposals = resolve_hidden(photos, {photo.view: propose(photo)}, {})
        stages = tuple(stage for stage in pipeline.STAGES if stage.name == "points")
        data: dict[str, Any] = {"photos": photos, "proposals": proposals, "corrections": no_corrections()}
        made: dict[str, Any] = dict(pipeline.run(data, stages=stages)[0])
    except ClonerError:
        return {}
    points = made["face_points"].views.get(photo.view)
    return {} if points is None else dict(zip(points.names, points.points_px, strict=True))


def _placed(clone: Clone, found: dict[str, Array], size_px: tuple[int, int], focal_px: float) -> Markers:
    """Return markers at the found points, and between them where a clone bent to those shows them."""
    known, generic = known_points(), load_generic()
    vertices = np.array([known[name] for name in MARKED], np.int32)
    rows = [row for row, name in enumerate(MARKED) if name in found]
    places, camera = clone.vertices_m, None
    try:
        fit = fit_markers(
            mark(mesh_of(clone), vertices[rows]), np.array([found[MARKED[row]] for row in rows]), size_px, focal_px
        )
        places, camera = fit.vertices_m, fit.camera
    except ClonerError:
        head = clone.vertices_m[generic.segment("head")]
        high, (width, height) = _FACE_SHARE * size_px[1], size_px
        corners = np.array([[0.0, 1.0], [0.0, -1.0], [0.5, 0.0], [-0.5, 0.0]]) * high / 2.0 + (width / 2, height / 2)
        ends = np.array([head[head[:, 1].argmin()], head[head[:, 1].argmax()], head[head[:, 0].argmax()],
                         head[head[:, 0].argmin()]])  # fmt: skip
        camera = facing_camera(ends, corners, azimuth=0.0, focal_px=focal_px, width_px=width, height_px=height)
    px = camera.project(places[vertices])
    if rows and places is not clone.vertices_m:
        px[rows] = [found[MARKED[row]] for row in rows]
    return Markers(MARKED, np.clip(px, 0.0, np.array(size_px) - 1.0))
