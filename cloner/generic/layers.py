"""A clone as posed meshes with one texture each, ready to draw."""

from __future__ import annotations

import functools
from collections.abc import Sequence
from dataclasses import dataclass, replace

import numpy as np
from numpy.typing import NDArray

from cloner.generic.load import load_generic
from cloner.generic.surfaces import load_surfaces, surface_normals
from cloner.geometry.articulation.skinning import joint_transforms, linear_blend_skinning
from cloner.geometry.meshes.wedges import welded_normals
from cloner.records.arrays import Array
from cloner.records.clones import Clone
from cloner.records.heads import Shell

Image = NDArray[np.uint8]


@dataclass(frozen=True, slots=True, eq=False)
class Layer:
    """One mesh with one texture, ready to draw.

    Attributes
    ----------
    vertices_m : (N, 3) float64, posed, model frame
    normals : (N, 3) float64, unit
    triangles : (T, 3) int32
    uv : (N, 2) float64 or None, v downwards
    texture : (S, S, 3 or 4) uint8 or None
        Four channels are blended over what lies behind.
    colour : (3,) float, 0..1
        Used where there is no texture.
    two_sided : bool
    white : bool
        Of the texture only the alpha counts.
    """

    vertices_m: Array
    normals: Array
    triangles: NDArray[np.int32]
    uv: Array | None = None
    texture: Image | None = None
    colour: tuple[float, float, float] = (1.0, 1.0, 1.0)
    two_sided: bool = False
    white: bool = False


def clone_layers(clone: Clone, rotations: Array | None = None) -> list[Layer]:
    """Return a clone's posed meshes, opaque ones first."""
    generic = load_generic()
    posed, transforms = clone.vertices_m, None
    if rotations is not None:
        pose = np.asarray(rotations, dtype=np.float64)
        transforms = joint_transforms(clone.joints_m, generic.joint_parents.astype(np.int32), pose)
        weights = generic.skin_weights.astype(np.float64)
        posed = linear_blend_skinning(clone.vertices_m, transforms, generic.skin_joints.astype(np.int32), weights)
    normals = surface_normals(posed)
    layers = [
        Layer(
            posed[surface.vertex],
            normals[surface.vertex],
            surface.triangles,
            surface.uv,
            clone.atlas.rgb if surface.rgba is None else surface.rgba,
            two_sided=surface.rgba is not None,
        )
        for surface in load_surfaces()
    ]
    for shell in clone.shells:
        if transforms is None:
            layers.append(_rest_layer(shell))
        else:
            layers.append(
                _layer(
                    shell, linear_blend_skinning(shell.vertices_m, transforms, shell.skin_joints, shell.skin_weights)
                )
            )
    return layers


@functools.lru_cache(maxsize=8)
def _rest_layer(shell: Shell) -> Layer:
    """Return a shell as it is at rest; it is the same object, picture after picture."""
    return _layer(shell, shell.vertices_m)


def _layer(shell: Shell, posed_m: Array) -> Layer:
    normals = welded_normals(posed_m, shell.triangles)
    return Layer(posed_m, normals, shell.triangles, shell.uv, shell.rgba, two_sided=True)


def white_layers(layers: Sequence[Layer]) -> list[Layer]:
    """Return the layers all white but for their alpha: drawn on black they show what is covered."""
    return [replace(layer, texture=_with_alpha(layer.texture), colour=(1.0, 1.0, 1.0), white=True) for layer in layers]


def _with_alpha(texture: Image | None) -> Image | None:
    """Return a texture if it has alpha: the very same pixels, which the driver may hold already."""
    return texture if texture is not None and texture.shape[2] == 4 else None
