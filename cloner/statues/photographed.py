"""A photograph of a statue, or of any face, laid on a clone or on a mesh from elsewhere, as a result."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace
from pathlib import Path
from typing import Any, Final

import numpy as np
from numpy.typing import NDArray

import cloner
from cloner.bodies.carried import move_shells_with_skin
from cloner.bodies.made import clone_of_measures
from cloner.bodies.telling import BodySpecification
from cloner.errors import ClonerError
from cloner.exporters.shared.obj_files import read_obj, write_obj
from cloner.exporters.table import check_formats
from cloner.generic.features import named_features
from cloner.generic.load import load_generic
from cloner.head.parts import place_eyes_and_mouth
from cloner.head.targets import face_targets
from cloner.making import check_texture_size
from cloner.picture import load_clone_at
from cloner.pipeline import Progress, no_progress
from cloner.project.atomic import result_folder
from cloner.project.folder import read_consent, read_terms, safe_identifier
from cloner.project.results import place_digest
from cloner.project.stamps import output_digests, stamp_text
from cloner.records.arrays import Array
from cloner.records.clones import Clone, TextureAtlas
from cloner.records.meshes import Mesh
from cloner.report.derived import FORMAT, make_manifest, write_result
from cloner.report.write import write_report
from cloner.stages.join import eye_joints
from cloner.statues.carved import check_material, statue_of
from cloner.statues.markers import read_markers
from cloner.statues.photo_fit import Fit, PhotoFit, fit_photo, focal_px_of
from cloner.vision.photographs.pictures import Picture, read_picture

#: Whom a photo is laid on where nobody is named: the family's usual man.
USUAL: Final = BodySpecification("m", 1.75, {})
OBJ: Final = ".obj"
#: Lips that are moved turn some ten triangles over (docs/statues_benchmark.md); markers that cross turn many.
MANY_TURNED: Final = 50


def mesh_of(clone: Clone) -> Mesh:
    """Return a clone's skin, eyes and mouth as a mesh to lay photos on."""
    generic = load_generic()
    triangles, uv_triangles = generic.triangles()
    return Mesh(
        clone.vertices_m,
        triangles.astype(np.int32),
        generic.uv.astype(np.float64),
        uv_triangles.astype(np.int32),
        generic.mirror.astype(np.int32),
        generic.region("scalp").astype(np.int32),
    )


def clone_with_photo(clone: Clone, fitted: PhotoFit) -> Clone:
    """Return the clone with the shape and texture of a photo that was fitted to its mesh, face targets and rig
    included.

    Lids are laid on the eyeballs and lips meet again, so that the face can move: markers there give by what that takes.
    """
    generic = load_generic()
    vertices = place_eyes_and_mouth(clone.vertices_m, fitted.fit.vertices_m, None)
    skin = np.flatnonzero(generic.skin)
    shift = (vertices - clone.vertices_m)[skin]
    names, index, delta, start = face_targets(vertices)
    return replace(
        clone,
        vertices_m=vertices,
        joints_m=eye_joints(generic, clone.joints_m, vertices),
        morph_names=names,
        morph_index=index,
        morph_delta_m=delta,
        morph_start=start,
        atlas=TextureAtlas(fitted.laid.rgb, fitted.laid.seen),
        shells=move_shells_with_skin(clone.shells, clone.vertices_m[skin], shift),
        features_m=named_features(generic, vertices),
        views={},
    )


def photo_folder(
    photo: Path,
    markers: Path,
    out: Path,
    identifier: str,
    *,
    onto: Path | None = None,
    material: str = "",
    formats: Sequence[str],
    texture_size: int,
    progress: Progress = no_progress,
) -> tuple[Path, tuple[str, ...]]:
    """Lay a photo on a clone or a mesh and write it; return its folder and what to say of it.

    Parameters
    ----------
    photo : Path
        Its folder's ``person.toml`` says who consented to what.
    markers : Path
    out : Path
        Receives a folder named by the identifier.
    identifier : str
    onto : Path or None
        A result's folder, a clone.npz, or an .obj; None for the usual man.
    material : str
        A clone is cut from it in the end; "" leaves the photo's colours.
    formats : sequence of str
        Names of exporters; a mesh is written as OBJ.
    texture_size : int
    progress : callable
        May raise Cancelled; nothing is left behind.

    Raises
    ------
    ClonerError
        If something cannot be read or written, or the markers make no sense.
    """
    check_formats(formats)
    check_texture_size(texture_size)
    foreign = onto is not None and onto.suffix.lower() == OBJ
    _check_material(material, foreign=foreign)
    progress("photos", 0.0)
    placed, picture, name = read_markers(markers), read_picture(photo), safe_identifier(identifier)
    source = None if foreign else onto
    clone = None if foreign else load_clone_at(onto) if onto is not None else clone_of_measures(USUAL, texture_size)
    mesh = mesh_of(clone) if clone is not None else read_obj(Path(str(onto)))
    progress("textures", 0.2)
    fitted = _fitted(mesh, placed.vertices(named=not foreign), _at_size(placed.px, picture), picture, texture_size)
    stamp = stamp_text(0, texture_size, [picture.digest])
    with result_folder(out, name) as folder:
        progress("export", 0.6)
        if clone is None:
            write_obj(mesh, fitted.fit.vertices_m, fitted.laid.rgb, folder, name, stamp)
            _write_manifest(folder, stamp, picture, photo)
        else:
            made = _made(clone, fitted, material, photo, source, stamp)
            write_result(made, folder, f"Statue {name}", formats, _manifest(made, material, source, photo, picture))
    progress("done", 1.0)
    return out / name, _said(fitted.fit)


def _fitted(mesh: Mesh, vertices: NDArray[np.int32], places_px: Array, picture: Picture, size: int) -> PhotoFit:
    height, width = picture.rgb.shape[:2]
    focal_px = focal_px_of(width, height, picture.focal_35mm)
    return fit_photo(mesh, vertices, places_px, picture.rgb, focal_px=focal_px, size=size)


def _check_material(material: str, *, foreign: bool) -> None:
    if material:
        check_material(material)
    if material and foreign:
        raise ClonerError("a mesh from elsewhere keeps the photo's colours", "Leave --material out", "--material")


def _at_size(markers_px: Array, picture: Picture) -> Array:
    """Return places in the photo as it was read; large ones were made smaller."""
    scale = picture.rgb.shape[1] / picture.original_size[0]
    return np.asarray((markers_px + 0.5) * scale - 0.5)


def _made(clone: Clone, fitted: PhotoFit, material: str, photo: Path, source: Path | None, stamp: str) -> Clone:
    """Return the finished clone; it may be shown if the photo and, where it is fitted to somebody, the person may."""
    made = clone_with_photo(clone, fitted)
    made = replace(
        made,
        consent=bool(read_consent(photo.parent)) and (source is None or clone.consent),
        terms=read_terms(photo.parent),
        stamp=(stamp if source is None else f"{clone.stamp}, then {stamp}")[:400],
    )
    return statue_of(made, material) if material else made


def _manifest(made: Clone, material: str, source: Path | None, photo: Path, picture: Picture) -> dict[str, Any]:
    """Return the manifest of a clone, with the photo that lies on it."""
    manifest = make_manifest(made, "photo on a mesh", {"material": material}, source)
    manifest["stamp"]["photos"] = {**manifest["stamp"]["photos"], "photo": picture.digest}
    manifest["source"] = manifest["source"] or place_digest(photo.parent)
    return manifest


def _write_manifest(folder: Path, stamp: str, picture: Picture, photo: Path) -> None:
    """Write what a mesh of no clone was made from, as all results do."""
    files = [path.relative_to(folder).as_posix() for path in folder.rglob("*") if path.is_file()]
    data: dict[str, Any] = {
        "format": FORMAT,
        "kind": "photo on a mesh",
        "made_by": stamp,
        "source": place_digest(photo.parent),
        "stamp": {"cloner": cloner.__version__, "photos": {"photo": picture.digest}, "beside": {}, "options": {}},
        "outputs": output_digests(folder, files),
    }
    write_report(data, folder)


def _said(fit: Fit) -> tuple[str, ...]:
    """Return how far the markers bent the mesh, and whether they cross."""
    size = float(np.sqrt(np.mean(fit.missed_px**2)))
    lines = [f"{len(fit.missed_px)} markers: {size:.1f} px from the unbent mesh on average, met exactly"]
    if fit.turned > MANY_TURNED:
        lines.append(f"note: {fit.turned} triangles are turned over: some markers cross; drag them apart")
    return tuple(lines)
