"""A finished clone without photographs: the generic human with a painted atlas."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray
from PIL import Image, ImageDraw

from cloner.frames import ViewId
from cloner.generic.load import GenericHuman, load_generic
from cloner.geometry.cameras.viewpoints import framing_camera
from cloner.records.bodies import PosedView
from cloner.records.clones import Clone, TextureAtlas
from cloner.records.heads import Shell

SKIN, SHIRT, TROUSERS, SHOES = (214, 168, 142), (60, 90, 160), (70, 70, 74), (30, 26, 24)
RED_LEFT_HAND = (230, 20, 20)
WHITE_OF_EYE, IRIS, TEETH, TONGUE = (236, 234, 230), (70, 100, 60), (240, 236, 224), (190, 90, 90)
HAIR = (90, 58, 34)
ATLAS_PX = 1024
_SEGMENT_COLOURS = {
    "torso": SHIRT,
    "left_upper_arm": SHIRT,
    "right_upper_arm": SHIRT,
    "pelvis": TROUSERS,
    "left_thigh": TROUSERS,
    "right_thigh": TROUSERS,
    "left_calf": TROUSERS,
    "right_calf": TROUSERS,
    "left_foot": SHOES,
    "right_foot": SHOES,
    "left_hand": RED_LEFT_HAND,
}
_PART_COLOURS = {
    "eye_left": WHITE_OF_EYE,
    "eye_right": WHITE_OF_EYE,
    "teeth_upper": TEETH,
    "teeth_lower": TEETH,
    "tongue": TONGUE,
}


def toy_clone(stature_m: float = 1.70, *, hair: bool = True) -> Clone:
    """Return the mean adult in painted clothes, with a red left hand and a brown cap of hair.

    All feature points of the generic human are set; the views hold a front
    and a side camera with the arms lowered a little.
    """
    generic = load_generic()
    vertices, joints = generic.shape(np.zeros(0), stature_m)
    names = (*generic.arkit_names, *generic.viseme_names)
    start = np.concatenate([generic.arkit_start, generic.arkit_start[-1] + generic.viseme_start[1:]])
    delta = np.concatenate([generic.arkit_delta_m, generic.viseme_delta_m]) * (stature_m / 1.70)
    return Clone(
        vertices_m=vertices,
        joints_m=joints,
        morph_names=names,
        morph_index=np.concatenate([generic.arkit_index, generic.viseme_index]),
        morph_delta_m=delta,
        morph_start=start,
        atlas=_painted(generic),
        shells=(_cap(generic, vertices),) if hair else (),
        features_m=_features(generic, vertices),
        views=_views(generic, vertices),
        stature_m=stature_m,
        sole_m=0.0,
    )


def _features(generic: GenericHuman, vertices: NDArray[np.float64]) -> dict[str, NDArray[np.float64]]:
    """Return every named point, the MPEG-4 ones with the dots that their names have."""
    points = {name: vertices[generic.feature(name)] for name in generic.feature_names}
    named = zip(generic.fdp_names, generic.fdp_vertices, strict=True)
    return points | {f"fdp_{name}": vertices[vertex] for name, vertex in named}


def _painted(generic: GenericHuman) -> TextureAtlas:
    """Return the atlas with one colour a segment, painted quad by quad."""
    image = Image.new("RGB", (ATLAS_PX, ATLAS_PX), (128, 128, 128))
    pen = ImageDraw.Draw(image)
    # hands and eyes last: wherever charts touch they must win
    for row in np.argsort(generic.quad_part, kind="stable"):
        part = generic.part_names[generic.quad_part[row]]
        segment = generic.segment_names[generic.quad_segment[row]]
        colour = _PART_COLOURS.get(part) or _SEGMENT_COLOURS.get(segment, SKIN)
        if part.startswith("eye_") and _near_pupil(generic, part, generic.quads[row]):
            colour = IRIS
        corners = [tuple(uv) for uv in (generic.uv[generic.quad_uv[row]] * ATLAS_PX - 0.5).tolist()]
        pen.polygon(corners, fill=colour, outline=colour)
    return TextureAtlas(np.asarray(image), np.full((ATLAS_PX, ATLAS_PX), 255, np.uint8))


def _near_pupil(generic: GenericHuman, part: str, quad: NDArray[np.integer]) -> bool:
    """Return whether an eye's quad lies on the iris."""
    ball = generic.vertices_m[generic.part(part)]
    pole = ball[ball[:, 2].argmax()]
    return bool(np.linalg.norm(generic.vertices_m[quad].mean(axis=0) - pole) < 0.0058)


def _cap(generic: GenericHuman, vertices: NDArray[np.float64]) -> Shell:
    """Return a cap 8 mm above the back and top of the head, half of its texture's stripes clear."""
    head = generic.segment_names.index("head")
    top = vertices[:, 1].max()
    middle_z = np.median(vertices[generic.part("body")][generic.vertex_segment[generic.part("body")] == head, 2])
    high = (generic.vertex_segment == head) & (vertices[:, 1] > top - 0.16) & (vertices[:, 2] < middle_z + 0.0)
    high |= (generic.vertex_segment == head) & (vertices[:, 1] > top - 0.06)
    high &= generic.vertex_part == generic.part_names.index("body")
    quads = generic.quads[high[generic.quads].all(axis=1)]
    used, local = np.unique(quads, return_inverse=True)
    local = local.reshape(-1, 4)
    centre = np.array([0.0, top - 0.1, vertices[high, 2].mean()])
    outward = vertices[used] - centre
    points = vertices[used] + 0.008 * outward / np.linalg.norm(outward, axis=1, keepdims=True)
    rgba = np.zeros((64, 64, 4), np.uint8)
    rgba[...] = (*HAIR, 255)
    rgba[:, ::4, 3] = 0
    uv = np.column_stack([np.arctan2(outward[:, 0], -outward[:, 2]) / 6.3 + 0.5, (top + 0.01 - points[:, 1]) / 0.2])
    return Shell(
        points,
        np.concatenate([local[:, [0, 1, 2]], local[:, [0, 2, 3]]]),
        np.clip(uv, 0, 1),
        generic.skin_joints[used],
        generic.skin_weights[used] / generic.skin_weights[used].sum(1, keepdims=True),
        rgba,
    )


def _views(generic: GenericHuman, vertices: NDArray[np.float64]) -> dict[ViewId, PosedView]:
    """Return a front and a side view with the arms 15 degrees lower than in rest pose."""
    rotations = np.zeros((94, 3))
    rotations[generic.joint("l_shoulder"), 2] = np.radians(-15)
    rotations[generic.joint("r_shoulder"), 2] = np.radians(15)
    sides = ((ViewId.BODY_FRONT, 0.0), (ViewId.BODY_SIDE, -90.0))
    return {view: PosedView(view, framing_camera(vertices, azimuth, 400, 600), rotations) for view, azimuth in sides}
