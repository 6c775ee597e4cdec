"""The texture of a shell of hair or loose clothing, from its own pixels in all photos."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from cloner.frames import ViewId
from cloner.generic.load import GenericHuman
from cloner.geometry.articulation.skinning import joint_transforms, linear_blend_skinning
from cloner.geometry.cameras.visibility import Visibility, compute_visibility
from cloner.geometry.charts.atlas import AtlasMap
from cloner.geometry.meshes.graphs import SurfaceGraph, surface_graph
from cloner.geometry.meshes.wedges import vertex_normals
from cloner.hair.shells.strands import curliness, grow_strands, roughness
from cloner.paint.lookups.posed import parents_of
from cloner.parallel import parallel_map
from cloner.records.arrays import Array
from cloner.records.bodies import PosedView
from cloner.records.clones import Joined
from cloner.records.photos import Photo
from cloner.vision.photographs.blending import Layer, blend_pyramids, push_pull
from cloner.vision.retouching.aligning import sample
from cloner.vision.retouching.normalising import (
    CLOTH_REFERENCES,
    REFERENCE_HOLD,
    apply_light,
    common_balance,
    even_light,
    light_basis,
    light_coordinates,
    reference_index,
)
from cloner.vision.retouching.repair import remove_background_coloured, repair_bleeding

SHARPNESS = 5  # weights are (claim x cosine)**5: mostly one photo a texel, so strands do not ghost
LEVELS = 2  # charts are small islands: wide bands would make them differ along their borders
SMOOTHING = 3  # rounds over the surface, where charts do not matter
KNOWN = 0.01  # of a claim, squared: what photos show goes on from there
NEAREST_WEIGHT = 0.05  # of what is nearest, against an edge to a neighbour, where nothing is known (taste)
PLAIN_ROUNDS = 10  # of averaging: a pattern does not go on where no photo shows it (taste)
FLOOR = 1e-6  # keeps from dividing by nothing
_MIRRORED = 0.8  # taste: trust in a colour of the other side against a photo's own
REACH_SHARE = 0.02  # of the shell's size in the photo: how deep other things shine through its edge
BAND_PX = 2.5  # labels are about this many pixels unsure


@dataclass(frozen=True, slots=True, eq=False)
class ShellView:
    """A shell in one photo.

    Attributes
    ----------
    posed : PosedView
    mask : (H, W) bool
        Pixels that show it.
    inside_px : (H, W) float32
        Signed distance to the mask's outline, positive inside.
    claim : float
        Weight against the other photos.
    flip_m : float or None
        When set, points are mirrored at x = flip_m first: the photo stands for the other half.
    """

    posed: PosedView
    mask: NDArray[np.bool_]
    inside_px: NDArray[np.float32]
    claim: float
    flip_m: float | None = None


def paint_shell(
    generic: GenericHuman,
    joined: Joined,
    photos: Mapping[ViewId, Photo],
    views: list[ShellView],
    atlas: AtlasMap,
    vertices_m: Array,
    skin_joints: NDArray[np.int32],
    skin_weights: Array,
    *,
    strands: float | None = None,
) -> NDArray[np.uint8]:
    """Return the (size, size, 4) texture of a shell.

    Parameters
    ----------
    generic, joined : the person the shell belongs to
    photos : mapping of ViewId to Photo
    views : list of ShellView
        At least one with any pixel that shows the shell.
    atlas : AtlasMap of the shell, its triangles indexing ``vertices_m``
    vertices_m : (N, 3), skin_joints, skin_weights : (N, 4)
    strands : float or None
        Hair goes on in strands where no photo shows it; so much they count where photos show it badly. None: no hair.
    """
    normals = vertex_normals(vertices_m, atlas.triangles)
    graph = surface_graph(vertices_m, atlas.triangles)
    usable = [view for view in views if view.posed.view in photos and view.mask.any()]
    pictures = _pictures(photos, usable)
    shell = (vertices_m, skin_joints, skin_weights, atlas.triangles)
    sights = list(parallel_map(lambda view: _visibility(generic, joined, view, *shell), usable))
    seen = [_claim(view, visibility) for view, visibility in zip(usable, sights, strict=True)]
    claims = np.stack([graph.smooth(claim[:, None], SMOOTHING)[:, 0] * (claim > 0.0) for claim in seen])
    own = np.array([view.flip_m is None for view in usable])
    widest = int(np.argmax(claims.sum(axis=1) * own))
    first = reference_index(_shown(usable), CLOTH_REFERENCES) if strands is None else widest
    light, evened = _normalised_colours(pictures, sights, seen, normals, first, own)
    shown = [_ColourSource(*each) for each in zip(pictures, sights, claims, light, strict=True)]
    sure, summed = (claims**2).sum(axis=0), ((claims**2)[..., None] * evened).sum(axis=0)
    mean = summed.sum(axis=0) / max(float(sure.sum()), 1e-9)
    ground, weight = np.tile(mean.astype(np.float32), (*atlas.shape, 1)), np.full(atlas.shape, FLOOR, np.float32)
    if strands is None:
        _flat(ground)[atlas.texel] = atlas.interpolate(_extended_colours(graph, sure, summed, mean))
    else:
        look = pictures[first], usable[first].mask
        seen_rgb, claim = summed / np.maximum(sure, 1e-9)[:, None], claims.max(axis=0)
        made = grow_strands(atlas, vertices_m, graph, seen_rgb, claim, roughness(*look), curliness(*look))
        own = (strands * atlas.interpolate(made.claim[:, None])[:, 0]) ** SHARPNESS
        _flat(ground)[atlas.texel], weight.ravel()[atlas.texel] = made.rgb, np.maximum(own, FLOOR)

    def layers() -> Iterator[Layer]:
        yield Layer(ground, weight)
        yield from (_texture_layer(atlas, one) for one in shown)  # one by one: a layer of 2048 texels takes 64 MiB

    covered = atlas.covered()
    blended = blend_pyramids(layers(), (*atlas.shape, 3), LEVELS) * covered[..., None]
    rgb = push_pull(blended, covered.astype(np.float32))
    opaque = np.full((*atlas.shape, 1), 255.0, np.float32)
    return np.concatenate([np.clip(np.rint(rgb), 0, 255), opaque], axis=2).astype(np.uint8)


@dataclass(frozen=True, slots=True, eq=False)
class _ColourSource:
    """A photo as a source of a shell's colour: its picture, and every vertex's visibility, claim (N,)
    and light (N, 3).
    """

    picture: NDArray[np.uint8]
    visibility: Visibility
    claim: Array
    light: Array


def _shown(views: Sequence[ShellView]) -> list[tuple[ViewId, bool]]:
    """Return each view's photo and whether it is mirrored."""
    return [(view.posed.view, view.flip_m is not None) for view in views]


def _pictures(photos: Mapping[ViewId, Photo], views: Sequence[ShellView]) -> list[NDArray[np.uint8]]:
    """Return the repaired photo of each view; a mirrored view has the same."""
    shown = {view.posed.view: view for view in reversed(views)}
    repaired = parallel_map(lambda view: _repaired(photos[view.posed.view].rgb, view), shown.values())
    picture_of = dict(zip(shown, repaired, strict=True))
    return [picture_of[view.posed.view] for view in views]


def _claim(view: ShellView, visibility: Visibility) -> Array:
    """Return how well (N,) a photo shows each vertex, 0 where it does not."""
    seen = visibility.visible_vertices()
    claim = view.claim * (_MIRRORED if view.flip_m is not None else 1.0)
    near = sample(view.inside_px, visibility.pixel_px)[:, 0] > -2.0 * BAND_PX
    return np.where(seen & near, claim * np.clip(visibility.cosine, 0.0, 1.0), 0.0)


def _normalised_colours(
    pictures: Sequence[NDArray[np.uint8]],
    sights: Sequence[Visibility],
    seen: Sequence[Array],
    normals: Array,
    first: int,
    own: NDArray[np.bool_],
) -> tuple[list[Array], Array]:
    """Return each photo's log gains (N, 3) that normalise light and exposure, and colours (K, N, 3) with them.

    ``first`` is the photo that keeps its own most.
    """
    colours = np.stack([sample(p, s.pixel_px) for p, s in zip(pictures, sights, strict=True)]).astype(np.float64)
    # Hair and cloth shine at grazing angles: only what both photos see nearly head-on tells their exposures.
    square = [np.clip((visibility.cosine - 0.5) / 0.5, 0.0, 1.0) for visibility in sights]
    trusts = np.stack([np.where(claim > 0.0, part, 0.0) for claim, part in zip(seen, square, strict=True)])
    hold = np.where(np.arange(len(pictures)) == first, REFERENCE_HOLD, 1.0)
    basis = light_basis(normals)
    light = np.stack([basis @ gain for gain in even_light(colours, trusts, normals, hold)])
    light += common_balance(colours, light, trusts, own)
    return list(light), np.stack([apply_light(colour, gain) for colour, gain in zip(colours, light, strict=True)])


def _extended_colours(graph: SurfaceGraph, sure: Array, summed: Array, mean: Array) -> Array:
    """Return the photos' colours (N, 3), extended along the surface where none shows it.

    Parameters
    ----------
    sure : (N,) sum of the photos' weights
    summed : (N, 3) of their colours by weight
    mean : (3,) of all, for parts that no photo shows
    """
    evenly = graph.smooth(np.column_stack([summed, sure]), PLAIN_ROUNDS)
    known = sure > KNOWN
    nearest = graph.nearest(known)
    near = np.where(known[nearest][:, None], evenly[nearest, :3] / np.maximum(evenly[nearest, 3:], 1e-9), mean)
    return graph.fill(near, np.clip(sure, NEAREST_WEIGHT, 1.0), 1.0, light_coordinates(near))


def _texture_layer(atlas: AtlasMap, shown: _ColourSource) -> Layer:
    """Return one photo's layer of a shell's texture."""
    rows = atlas.rows_of(np.any((shown.claim > 0.0)[atlas.triangles], axis=1))
    visibility = shown.visibility
    table = np.column_stack([visibility.pixel_px, visibility.depth_m, visibility.cosine, shown.claim, shown.light])
    values = atlas.interpolate(table, rows)
    good = visibility.visible(values[:, :2], values[:, 2], values[:, 3]) & (values[:, 4] > 0.02)
    values, texel = values[good], atlas.texel[rows[good]]
    image, known = np.zeros((*atlas.shape, 3), np.float32), np.zeros(atlas.shape, np.float32)
    _flat(image)[texel] = apply_light(sample(shown.picture, values[:, :2]), values[:, 5:])
    known.ravel()[texel] = 1.0
    whole = push_pull(image, known)
    known.ravel()[texel] = np.minimum(values[:, 4], 1.0) ** SHARPNESS + FLOOR
    return Layer(whole, known)


def _flat(image: NDArray[np.float32]) -> NDArray[np.float32]:
    """Return a view of a picture (h, w, C) as (h * w, C)."""
    return image.reshape(-1, image.shape[2])


def _repaired(rgb: NDArray[np.uint8], view: ShellView) -> NDArray[np.uint8]:
    """Return the photo with every pixel in the shell's own nearest colour."""
    size = float(np.sqrt(view.mask.sum()))
    own = remove_background_coloured(rgb, view.mask, max(REACH_SHARE * size, 2.0 * BAND_PX))
    return repair_bleeding(rgb, own, BAND_PX)[0]


def _visibility(
    generic: GenericHuman,
    joined: Joined,
    view: ShellView,
    vertices_m: Array,
    skin_joints: NDArray[np.int32],
    skin_weights: Array,
    triangles: NDArray[np.int32],
) -> Visibility:
    """Return the shell's visibility in one photo; in a mirrored photo that of the mirrored shell."""
    points, faces = vertices_m, triangles
    if view.flip_m is not None:
        points = points * (-1.0, 1.0, 1.0) + (2.0 * view.flip_m, 0.0, 0.0)
        faces = triangles[:, ::-1]
        skin_joints = mirror_joints(generic)[skin_joints]
    transforms = joint_transforms(joined.joints_m, parents_of(generic), view.posed.rotations)
    return compute_visibility(
        linear_blend_skinning(points, transforms, skin_joints, skin_weights),
        np.ascontiguousarray(faces),
        view.posed.camera,
    )


def mirror_joints(generic: GenericHuman) -> NDArray[np.int32]:
    """Return each joint's counterpart on the other side, itself in the middle, (94,)."""
    names = generic.joint_names
    other = {"l_": "r_", "r_": "l_"}
    return np.array([names.index(other.get(name[:2], name[:2]) + name[2:]) for name in names], np.int32)
