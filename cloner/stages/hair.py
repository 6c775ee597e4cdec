"""Stage: hair as a volume over the head, and loose clothing as a surface around the legs.

References
----------
Method notes section 12; visual hull after Laurentini 1994, limited to what labels and outlines allow.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, field
from typing import cast

import numpy as np
from numpy.typing import NDArray

from cloner.frames import ViewId, m_from_mm
from cloner.generic.load import GenericHuman, load_generic
from cloner.generic.surfaces import body_triangles
from cloner.geometry.meshes.wedges import vertex_normals
from cloner.hair.clothing.coverings import merge_covering_labels
from cloner.hair.clothing.hoods import relabel_single_hoods
from cloner.hair.clothing.loose_clothes import SAID, loose_shells
from cloner.hair.clothing.peaks import find_peak, headwear_views, peak_mesh, under_headwear
from cloner.hair.clothing.scarves import scarf_shell
from cloner.hair.shells.beard import beard_shell
from cloner.hair.shells.mattes import Matte, hair_rim_mm, make_mattes, reduce_to_cores
from cloner.hair.shells.rim_cards import crown_centre, rim_shell
from cloner.hair.shells.rim_strips import make_strips
from cloner.hair.shells.shell import dress_shell, visible_part
from cloner.hair.shells.surface import (
    MeshLimits,
    hair_mesh,
    head_rows,
    median_plane_x,
    scan_scalp,
    tucked_skin,
    with_common_height,
)
from cloner.hair.volumes.amounts import inconsistent_views
from cloner.hair.volumes.cap import VOTE_MM, Scalp
from cloner.hair.volumes.covered_side import covered_side_views
from cloner.hair.volumes.ears import press_ears
from cloner.hair.volumes.lost import restore_lost_hair
from cloner.hair.volumes.settled import settle_shell
from cloner.hair.volumes.views import HairSkinning, HairView, hair_views
from cloner.hair.volumes.volume import FILM_MM
from cloner.hair.volumes.weights import hair_weights
from cloner.labels.glasses import wears_glasses
from cloner.paint.details.glasses import glasses_shell
from cloner.paint.lookups.posed import posed_vertices
from cloner.records.arrays import Array
from cloner.records.clones import Joined
from cloner.records.heads import Shell
from cloner.records.photos import PhotoSet
from cloner.records.proposals import Proposals
from cloner.records.results import Residual, StageResult
from cloner.records.silhouettes import SilhouetteSet
from cloner.stages.views import face_focal_px
from cloner.vision.photographs.noise import denoised


@dataclass(frozen=True, slots=True)
class Params:
    """Settings of the hair stage.

    Attributes
    ----------
    size : int
        Side of the texture, texels.
    mesh : MeshLimits
    thinnest_mm : float
        Hair thinner than this on the median is left to the skin's texture.
    least_share : float
        Bald below this share of hairy vertices on the scalp.
    """

    size: int = 1024
    mesh: MeshLimits = field(default_factory=MeshLimits)
    thinnest_mm: float = 1.5
    least_share: float = 0.1


def run(
    *,
    photos: PhotoSet,
    proposals: Proposals,
    silhouettes: SilhouetteSet,
    joined: Joined,
    tick: Callable[[float], None],
    params: Params | None = None,
) -> StageResult:
    """Produce the shells: hair (or the reason for none as a warning), beard, loose clothing and glasses.

    Residuals: median and largest thickness of the cap, mm.
    """
    generic, photos = load_generic(), denoised(photos)
    views = hair_views(generic, joined, proposals, silhouettes)
    body, on_scalp = body_triangles(), generic.region("scalp")
    scalp = joined.vertices_m, vertex_normals(joined.vertices_m, body), body[on_scalp[body].all(axis=1)]
    neck = joined.vertices_m[generic.region("neck")]
    neck_m = np.array([neck[:, 0].mean(), neck[:, 1].min(), neck[:, 2].mean()])
    views, hooded = merge_covering_labels(views, photos.photos, proposals, *scalp, neck_m)
    views = restore_lost_hair(views, photos.photos, head_middle(generic, joined))
    alike, odd = consistent_views(generic, joined, views)
    covered = covered_side_views(generic, joined, proposals, silhouettes, face_focal_px(photos, ViewId.FACE_SIDE))
    hair = grow_hair(photos, proposals, alike, covered, joined, tick, params or Params(), hooded=hooded)
    beard = beard_shell(generic, joined, photos, proposals, views)
    loose = loose_shells(generic, joined, photos, proposals, silhouettes)
    scarf = scarf_shell(generic, joined, photos, proposals, views)
    worn = (*(one for one in (beard, scarf) if one is not None), *loose, *make_glasses(photos, proposals, joined))
    shells = (*cast(tuple[Shell, ...], hair.values["shells"]), *worn)
    return StageResult({"shells": shells}, hair.residuals, (*odd, *hair.warnings, *((SAID,) if loose else ())))


def consistent_views(
    generic: GenericHuman, joined: Joined, views: list[HairView]
) -> tuple[list[HairView], tuple[str, ...]]:
    """Return the views without photos whose hair disagrees with the others, and a sentence for each of those."""
    odd = inconsistent_views(views, head_middle(generic, joined))
    said = tuple(
        f"{view}: the hair is {share:.1f} times as large here as in the other photos, so this photo's was not used; "
        "take it again before a wall that looks unlike the hair"
        for view, share in odd.items()
    )
    return [view for view in views if view.posed.view not in odd], said


def head_middle(generic: GenericHuman, joined: Joined) -> Array:
    """Return the middle (3,) of the head at the height of the ears' tops, at rest."""
    ears = joined.vertices_m[generic.region("ear_left") | generic.region("ear_right")]
    return np.array([median_plane_x(generic, joined), ears[:, 1].max(), ears[:, 2].mean()])


def make_glasses(photos: PhotoSet, proposals: Proposals, joined: Joined) -> tuple[Shell, ...]:
    """Return the glasses that the face's front photo shows, if any."""
    if ViewId.FACE_FRONT not in joined.views or not wears_glasses(proposals):
        return ()
    front = photos.photos[ViewId.FACE_FRONT]
    found = glasses_shell(load_generic(), joined, front, proposals.views[ViewId.FACE_FRONT])
    return () if found is None else (found,)


def grow_hair(
    photos: PhotoSet,
    proposals: Proposals,
    views: list[HairView],
    covered: list[HairView],
    joined: Joined,
    tick: Callable[[float], None],
    params: Params,
    *,
    hooded: bool,
) -> StageResult:
    """Return the hair shell, or none with the reason as a warning, and its cap's thickness; ``covered`` views only
    colour it. No single hairs stand out of a hood.
    """
    generic = load_generic()
    if not any(view.hair.any() for view in views):
        return StageResult({"shells": ()}, (), ("No hair was found in the photos: the head stays bare",))
    joined, views = press_ears(generic, joined, views)
    body, on_scalp = body_triangles(), generic.region("scalp")
    normals = vertex_normals(joined.vertices_m, body)
    views = relabel_single_hoods(views, joined.vertices_m, normals, body[on_scalp[body].all(axis=1)])
    tick(0.2)
    scalp = scan_scalp(generic, joined, views)
    rows = on_scalp[head_rows(generic)]
    hairy = float((scalp.hairy[rows] > 0.5).mean()) if rows.any() else 0.0
    thick = scalp.thickness_mm[scalp.thickness_mm > 0.5]
    if hairy < params.least_share or thick.size == 0 or float(np.median(thick)) < params.thinnest_mm:
        return StageResult({"shells": ()}, (), ("The hair is too short or too little for a volume of its own",))
    tick(0.4)
    skin = tucked_skin(generic, joined, scalp)
    mesh = hair_mesh(generic, joined, with_common_height(generic, joined, views, scalp), scalp, skin, params.mesh)
    if mesh is None:
        return StageResult({"shells": ()}, (), ("The hair's shape could not be made out: it is only painted on",))
    tick(0.7)
    mattes = make_mattes(photos.photos, views, scalp.points_m)
    reach_mm = None if hooded else hair_rim_mm(mattes.values())
    fitted = views if reach_mm is None else reduce_to_cores(views, mattes)
    settled = settle_shell(fitted, skin, *mesh, FILM_MM)
    used, triangles, inside_mm = visible_part(views, settled, mesh[1], scalp)
    if not len(triangles):
        return StageResult({"shells": ()}, (), ("The hair's shape could not be made out: it is only painted on",))
    grown = settled[used], triangles
    surface = add_peak(generic, joined, views, proposals, scalp, (*grown, inside_mm))
    peaked = np.arange(len(surface[1])) >= len(triangles)
    hats = headwear_views(views, proposals) if peaked.any() or reach_mm is not None else []
    worn = (peaked, hats) if peaked.any() else None
    hung = HairSkinning.of(generic, joined).weights(surface[0])
    strands = 1.0 if all(view.posed.view.is_front for view in views) else 0.0
    carried = hair_weights(generic, joined, *surface[:2])
    seen = views + covered
    shell = dress_shell(
        generic, joined, photos, seen, surface, hung, params.size, strands=strands, carried=carried, worn=worn
    )
    cards = None if reach_mm is None else hair_cards(generic, joined, views, mattes, reach_mm, shell, grown, hats)
    residuals = (
        Residual("hair_thickness_median", float(np.median(thick)), "mm"),
        Residual("hair_thickness_largest", float(thick.max()), "mm"),
    )
    tick(1.0)
    return StageResult({"shells": (shell,) if cards is None else (shell, cards)}, residuals)


def hair_cards(
    generic: GenericHuman,
    joined: Joined,
    views: list[HairView],
    mattes: dict[ViewId, Matte],
    reach_mm: float,
    shell: Shell,
    grown: tuple[Array, NDArray[np.int32]],
    hats: list[HairView],
) -> Shell | None:
    """Return the cards around a hair's outline, with the photos' own strands, ``reach_mm`` long."""
    body, vertices = body_triangles(), grown[0]
    bodies = {view.posed.view: posed_vertices(generic, joined, view.posed) for view in views}
    strips = make_strips(grown, body, bodies, views, mattes, reach_mm, crown_centre(vertices))
    bare = under_headwear(hats, vertices)
    return rim_shell(shell, grown, (joined.vertices_m, body), strips, reach_mm, bare)


def add_peak(
    generic: GenericHuman,
    joined: Joined,
    views: list[HairView],
    proposals: Proposals,
    scalp: Scalp,
    surface: tuple[Array, NDArray[np.int32], Array],
) -> tuple[Array, NDArray[np.int32], Array]:
    """Return a hair's vertices, triangles and distances inside its edge, mm, with the peak of a cap
    that photos show.
    """
    ears = joined.vertices_m[generic.region("ear_left") | generic.region("ear_right")]
    cap = scalp.points_m + scalp.normals * m_from_mm(1.0) * scalp.thickness_mm[:, None]
    peak = find_peak(views, proposals, cap, float(ears[:, 1].mean()))
    if peak is None:
        return surface
    vertices, triangles, inside_mm = surface
    points, faces = peak_mesh(peak)
    return (
        np.concatenate([vertices, points]),
        np.concatenate([triangles, faces + np.int32(len(vertices))]),
        np.concatenate([inside_mm, np.full(len(points), VOTE_MM)]),
    )
