"""A statue as a result: a folder like any clone's, which belongs to the same visitor."""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path

from cloner.exporters.table import check_formats
from cloner.picture import folder_name, load_clone_at
from cloner.pipeline import Progress, no_progress
from cloner.project.atomic import result_folder
from cloner.project.folder import safe_identifier
from cloner.report.derived import make_manifest, write_result
from cloner.statues.carved import check_material, statue_of
from cloner.statues.poses import REST, check_pose, standing


def statue_folder(
    clone_path: Path,
    out: Path,
    identifier: str = "",
    *,
    material: str,
    pose: str = REST,
    formats: Sequence[str],
    progress: Progress = no_progress,
) -> Path:
    """Write a clone as a statue, a result of its own that belongs to the same visitor; return its folder.

    Parameters
    ----------
    clone_path : Path
        A result's folder or its clone.npz.
    out : Path
        Receives a folder named by the identifier.
    identifier : str
        "" for the clone's folder's name and the material.
    material : str
        One of `cloner.statues.materials.MATERIALS`.
    pose : str
        One of `cloner.statues.poses.POSES`; how it rests.
    formats : sequence of str
        Names of exporters.
    progress : callable
        May raise Cancelled; nothing is left behind.

    Raises
    ------
    ClonerError
        If material, pose or a format is not known, or something cannot be read or written.
    """
    check_formats(formats)
    check_material(material)
    check_pose(pose)
    progress("textures", 0.0)
    clone = load_clone_at(clone_path)
    name = safe_identifier(identifier or f"{folder_name(clone_path)}-{material}")
    with result_folder(out, name) as folder:
        statue = standing(statue_of(clone, material), pose)
        progress("export", 0.6)
        options = {"material": material, "pose": pose}
        write_result(statue, folder, f"Statue {name}", formats, make_manifest(statue, "statue", options, clone_path))
    progress("done", 1.0)
    return out / name
