"""Texture files beside text formats."""

from __future__ import annotations

from pathlib import Path

from cloner.exporters.shared.files import jpeg_bytes, png_bytes, write_bytes
from cloner.generic.surfaces import load_surfaces
from cloner.records.clones import Clone


def picture_bytes(clone: Clone, name: str) -> dict[str, bytes]:
    """Return atlas, lashes and shells as files' contents, by their paths below the scene's folder."""
    pictures = {f"textures/{name}_atlas.jpg": jpeg_bytes(clone.atlas.rgb)}
    for surface in load_surfaces():
        if surface.rgba is not None:
            pictures[f"textures/{name}_{surface.name}.png"] = png_bytes(surface.rgba)
    for number, shell in enumerate(clone.shells):
        pictures[f"textures/{name}_{shell.kind}_{number}.png"] = png_bytes(shell.rgba)
    return pictures


def write_pictures(clone: Clone, folder: Path, name: str) -> tuple[Path, ...]:
    """Write atlas, lashes and shells into ``textures/`` and return their paths.

    Raises
    ------
    ClonerError
        If the folder cannot be written to.
    """
    pictures = picture_bytes(clone, name)
    for relative, data in pictures.items():
        write_bytes(folder / relative, data)
    return tuple(folder / relative for relative in pictures)
