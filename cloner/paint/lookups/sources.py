"""Photos as sources of colour: lookup, visibility and quality at each vertex."""

from __future__ import annotations

from dataclasses import dataclass, replace

import cv2
import numpy as np
from numpy.typing import NDArray

from cloner.frames import ViewId
from cloner.generic.face_grids import mouth_grid
from cloner.generic.lip_steps import SHARE, drop_from_borders
from cloner.generic.load import GenericHuman
from cloner.generic.photo_shares import arms_beside_head, mirrored_share, photo_shares
from cloner.generic.surfaces import body_triangles
from cloner.geometry.cameras.visibility import Visibility, depth_at
from cloner.paint.lookups.ear_match import shift_ear
from cloner.paint.lookups.posed import PosedPerson, pose_person
from cloner.paint.lookups.prepared import Limits, matted_photo, person_mask, person_skin
from cloner.paint.lookups.zones import always_bare, hair_allowed, hair_kept, in_arm_zone, near_bare_head, near_shell
from cloner.parallel import parallel_map
from cloner.records.arrays import Array
from cloner.records.clones import Joined
from cloner.records.heads import Shell
from cloner.records.photos import PhotoSet
from cloner.records.proposals import Proposals
from cloner.records.results import Residual
from cloner.records.silhouettes import SilhouetteSet
from cloner.vision.retouching.aligning import outline_shift, sample, shift_points
from cloner.vision.retouching.background_colours import colours_by_height
from cloner.vision.retouching.matting import MattedPhoto
from cloner.vision.retouching.normalising import exposure_confidence, restore_clipped_hue
from cloner.vision.retouching.open_mouth import lip_colour_edges
from cloner.vision.retouching.repair import remove_outside_body

HAIR_CLEARANCE_M = 0.006  # hair that stands off less than this hugs the skin: its colour is the hairline's
CLAIM_POWER = 1.5  # taste: grazing photos give way early, their pixels are stretched
UNSAFE_CLAIM = 0.3  # of the usual, beside an inner outline
BURNT_CLAIM = 0.15  # of the usual, where a channel is at its end
SQUARE_COSINE = (0.6, 0.8)  # surfaces that face a photo stay its own: features must not come from two photos
FITTED_COSINE = 0.5  # a face's own points lie on its photo; its rim is carried to the outline (taste)
SHELL_SHARE = 0.012  # of the figure, 2 cm: labels this far from any shell are doubted
BESIDE_M = 0.01  # what stands out of the fitted body by more is room: its colours are the person's, its place is not
HAIR_RIM_SHARE = 0.0044  # a fringe's rim may lie this much farther out in the photo than in the shell
HAIR_GROWTH_SHARE = 0.004  # hair labels grow by this share of the figure: strands fray


@dataclass(frozen=True, slots=True, eq=False)
class Source:
    """One photo (or its mirror image) as a source of colour for every vertex.

    Attributes
    ----------
    view : ViewId
    mirrored : bool
    matted : Plate
    visibility : Visibility
    lookup_px : (V, 2) float64
        Where the photo shows each vertex after the outlines were aligned.
    hair_m : (h, w) float32
        Depth of the nearest hair shell, inf where there is none.
    hair : (H, W) uint8
        255 where hair may hide what is below it.
    score : (V,) float64
        Claim on each vertex: share x cosine, 0 where not seen.
    """

    view: ViewId
    mirrored: bool
    matted: MattedPhoto
    visibility: Visibility
    lookup_px: Array
    hair_m: NDArray[np.float32]
    hair: NDArray[np.uint8]
    score: Array


def gather_sources(
    generic: GenericHuman,
    photos: PhotoSet,
    proposals: Proposals,
    silhouettes: SilhouetteSet,
    joined: Joined,
    shells: tuple[Shell, ...],
    limits: Limits,
) -> tuple[list[Source], list[Residual]]:
    """Return all photos as sources, side photos also mirrored, and the outline shifts made."""
    sources: list[Source] = []
    residuals: list[Residual] = []
    taken = frozenset(view for view in joined.views if view in photos.photos)
    skins = person_skin(photos, proposals, silhouettes)

    def prepared(view: ViewId) -> tuple[Source, float] | None:
        posed_person = pose_person(generic, joined, shells, joined.views[view])
        mask = person_mask(view, proposals.views[view], silhouettes)
        if not view.is_face:  # a face photo's shoulders hang in no known pose
            mask = remove_outside_body(mask, posed_person.shown, BESIDE_M / posed_person.visibility.metres_per_pixel)
            mask = own.without_room(photos.photos[view].rgb, mask)
        photo, proposal = photos.photos[view].rgb, proposals.views[view]
        matted = matted_photo(view, photo, proposal, mask, limits, skins.get(view))
        if not (matted.inside_px > 0.0).any():
            return None
        return make_source(generic, posed_person, view, matted, limits, taken)

    views = [view for view in joined.views if view in photos.photos and view in proposals.views]
    bodies = [view for view in views if not view.is_face]
    own = colours_by_height((photos.photos[v].rgb, person_mask(v, proposals.views[v], silhouettes)) for v in bodies)
    for view, found in zip(views, parallel_map(prepared, views), strict=True):
        if found is None:
            continue
        source, gap = found
        sources.append(source)
        residuals.append(Residual("outline_shift", gap, "px", str(view)))
        if view.is_side:
            sources.append(mirror_source(generic, source))
        if view is ViewId.FACE_FRONT:
            sources.append(mirror_hidden(generic, source))
    return sources, residuals


def make_source(
    generic: GenericHuman,
    posed_person: PosedPerson,
    view: ViewId,
    matted: MattedPhoto,
    limits: Limits,
    taken: frozenset[ViewId],
) -> tuple[Source, float]:
    """Return one photo as a source, and the mean distance between outlines before the shift, px."""
    visibility = posed_person.visibility
    fitted = generic.region("face") & (visibility.cosine > FITTED_COSINE)
    lookup, gap = align(visibility, matted, limits, visibility.pixel_px[fitted] if view.is_face else None)
    lookup = shift_ear(generic, posed_person.posed_m, body_triangles(), visibility, matted.hair, view, lookup)
    if matted.lips_px is not None:
        grid = mouth_grid()
        lookup[grid.rings, 1] += SHARE[:, None] * drop_from_borders(
            grid, lookup[grid.rings], lip_colour_edges(matted.lips_px)
        )
    rim = (
        2 * int(np.ceil(HAIR_RIM_SHARE * matted.figure_px * posed_person.hair_m.shape[0] / matted.inside_px.shape[0]))
        + 1
    )
    hair_m = cv2.erode(posed_person.hair_m, np.ones((rim, rim), np.uint8), borderValue=np.inf)
    growth = 2 * int(np.ceil(HAIR_GROWTH_SHARE * matted.figure_px)) + 1
    hair = cv2.dilate(matted.hair.astype(np.uint8) * 255, np.ones((growth, growth), np.uint8))
    if np.isfinite(hair_m).any():
        hair[~near_shell(hair_m, hair.shape, SHELL_SHARE * matted.figure_px)] = 0
    source = Source(view, False, matted, visibility, lookup, hair_m, hair, np.zeros(len(lookup)))
    seen = visible_points(source, limits, visibility.pixel_px, lookup, visibility.depth_m, visibility.cosine)
    seen &= ~covered_by_hair(
        source, visibility.pixel_px, lookup, visibility.depth_m, hair_allowed(generic), hair_kept(generic)
    )
    if view is ViewId.BODY_SIDE:
        seen &= ~(arms_beside_head(generic) & near_bare_head(generic, matted, lookup))
        seen &= in_arm_zone(generic, matted, lookup)
    share = photo_shares(generic, view, photos=taken)
    share = np.where(
        visibility.before_edge(visibility.pixel_px, visibility.depth_m, visibility.cosine), UNSAFE_CLAIM * share, share
    )
    # Where a photo is burnt out another one shows more, if it faces the surface better.
    square = np.clip((visibility.cosine - SQUARE_COSINE[0]) / (SQUARE_COSINE[1] - SQUARE_COSINE[0]), 0.0, 1.0)
    share = share * np.maximum(np.maximum(exposure_confidence(sample(matted.blurred, lookup)), square), BURNT_CLAIM)
    return replace(source, score=share * np.where(seen, np.clip(visibility.cosine, 0.0, 1.0) ** CLAIM_POWER, 0.0)), gap


def align(
    visibility: Visibility, matted: MattedPhoto, limits: Limits, placed_px: Array | None = None
) -> tuple[Array, float]:
    """Return lookups (V, 2) after the mesh's outline was moved to the photo's, and the distance, px.

    ``placed_px`` (N, 2) is where the mesh lies on the photo already: shoulders in no known pose, as a face photo shows
    them, do not move it.
    """
    height, width = matted.inside_px.shape
    small = np.isfinite(visibility.nearest_m).astype(np.float32)
    mesh_mask = cv2.resize(small, (width, height), interpolation=cv2.INTER_LINEAR) > 0.5
    limit = limits.shift_share * matted.figure_px
    growth = 2 * int(np.ceil(limit)) + 1
    usable = cv2.dilate(matted.hair.astype(np.uint8), np.ones((growth, growth), np.uint8)) == 0
    field, gap = outline_shift(mesh_mask, matted.inside_px, usable, limit, placed_px)
    return shift_points(visibility.pixel_px, field), gap


def shown_colours(
    source: Source,
    lookup_px: NDArray[np.floating],
    skin: NDArray[np.floating] | None = None,
    *,
    blurred: bool = False,
) -> NDArray[np.float32]:
    """Return the photo's colours (N, 3) at lookups (N, 2), levels, overexposed skin restored.

    ``skin`` (N,) in 0..1 is the matted photo's ``skin`` there, where it is known already.
    """
    matted = source.matted
    colour = sample(matted.blurred if blurred else matted.rgb, lookup_px)
    if matted.shares is None:
        return colour
    shown = sample(matted.skin, lookup_px)[:, 0] / 255.0 if skin is None else skin
    return np.asarray(restore_clipped_hue(colour, matted.shares, shown), np.float32)


def mirror_source(generic: GenericHuman, source: Source) -> Source:
    """Return a side photo as the source of the half of the person that it does not show."""
    twin = generic.mirror
    return replace(
        source,
        mirrored=True,
        visibility=source.visibility.mirrored(twin),
        lookup_px=source.lookup_px[twin],
        score=mirrored_share() * source.score[twin],
    )


def mirror_hidden(generic: GenericHuman, source: Source) -> Source:
    """Return a front photo of the face as the source of the half that hair or the head's yaw hides in it.

    A turned head shows one cheek and ear at a slant, its edge stretched, and the other ones well.
    """
    mirrored = mirror_source(generic, source)
    slant = (source.visibility.cosine < SQUARE_COSINE[0]) & (mirrored.score > source.score)
    hidden = always_bare(generic) & ((source.score <= 0.0) | slant)
    return replace(mirrored, score=np.where(hidden, mirrored.score, 0.0))


def visible_points(
    source: Source,
    limits: Limits,
    pixel_px: NDArray[np.floating],
    lookup_px: NDArray[np.floating],
    depth_m: NDArray[np.floating],
    cosine: NDArray[np.floating],
) -> NDArray[np.bool_]:
    """Return which surface points (N,) the photo shows, hair left aside."""
    seen = source.visibility.visible(pixel_px, depth_m, cosine) & (cosine > limits.steepest_cosine)
    near = sample(source.matted.inside_px, lookup_px)[:, 0] > -limits.shift_share * source.matted.figure_px
    opening = sample(source.matted.openings.view(np.uint8), lookup_px)[:, 0] > 0.5
    return seen & near & ~opening


def covered_by_hair(
    source: Source,
    pixel_px: NDArray[np.floating],
    lookup_px: NDArray[np.floating],
    depth_m: NDArray[np.floating],
    allowed: NDArray[np.bool_],
    kept: NDArray[np.bool_],
) -> NDArray[np.bool_]:
    """Return which points (N,) lie below hair that is not theirs.

    Parameters
    ----------
    source : Source
    pixel_px, lookup_px : (N, 2); depth_m : (N,)
    allowed : (N,) scalp, which keeps the hair's colour
    kept : (N,) face, where only a shell in front counts
    """
    labelled = 2.0 * sample(source.hair, lookup_px)[:, 0] > 255.0
    shell = depth_at(source.hair_m, pixel_px)
    below = depth_m > shell + HAIR_CLEARANCE_M
    # A scalp shows hair or bare skin: where the photo shows neither, the lookup left the head.
    bare = sample(source.matted.bare.view(np.uint8), lookup_px)[:, 0] > 0.5
    stray = allowed & ~labelled & ~bare & bool(source.hair.any())
    return ((below | (labelled & ~kept)) & ~allowed) | stray
