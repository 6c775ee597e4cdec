"""Loose clothing around the legs as a surface of its own.

A step of the hair stage, which makes all shells. The body below stays the one that
pose, phenotype and the visible parts of the legs give.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from cloner.frames import ViewId
from cloner.generic.load import GenericHuman
from cloner.generic.seen_points import combined_pose
from cloner.geometry.charts.atlas import map_atlas
from cloner.geometry.charts.tubes import tube_mesh
from cloner.hair.clothing.loose_shape import COLUMNS, loose_tube
from cloner.hair.clothing.loose_views import LegSkinning, LooseView, loose_views
from cloner.hair.shells.shell_paint import ShellView, paint_shell
from cloner.records.clones import Joined
from cloner.records.heads import Shell
from cloner.records.labels import CLOTHES, shows
from cloner.records.loose import AROUND_LEGS
from cloner.records.photos import PhotoSet
from cloner.records.proposals import Proposals
from cloner.records.silhouettes import SilhouetteSet
from cloner.vision.photographs.arms import arm_zone
from cloner.vision.retouching.repair import signed_distance

#: The sentence of the report.
SAID = "Loose clothing between hips and knees was given its own surface"
HEM_MARGIN = 0.005  # of the figure: a hem hangs unevenly, and below it are legs
ARM_MARGIN = 0.012  # of the figure: hands are wider than the net's lines
CLAIM = {ViewId.BODY_FRONT: 1.0, ViewId.BODY_BACK: 1.0, ViewId.BODY_SIDE: 0.8}  # taste: hands hide the side more often


@dataclass(frozen=True, slots=True)
class Params:
    """Settings of loose shells.

    Attributes
    ----------
    size : int
        Side of the texture, texels.
    """

    size: int = 1024


def loose_shells(
    generic: GenericHuman,
    joined: Joined,
    photos: PhotoSet,
    proposals: Proposals,
    silhouettes: SilhouetteSet,
    params: Params | None = None,
) -> tuple[Shell, ...]:
    """Return a shell for the cloth around the legs, none where no photo shows any."""
    params = params or Params()
    regions = {
        view: region
        for view, silhouette in silhouettes.views.items()
        for region in silhouette.loose
        if region.name == AROUND_LEGS
    }
    views = loose_views(generic, joined, regions, LegSkinning.of(generic, joined))
    if all(view.posed.view is ViewId.BODY_SIDE for view in views):
        return ()
    points = loose_tube(generic, joined, views)
    tube = tube_mesh(points, params.size)
    whole = (tube.ring * COLUMNS + tube.column)[tube.triangles].astype(np.int32)
    flat = points.reshape(-1, 3)
    joints, weights = views[0].hanging.weights(flat)
    atlas = map_atlas(tube.uv, tube.triangles, whole, params.size)
    shown = shell_views(views, proposals, silhouettes)
    rgba = paint_shell(generic, joined, photos.photos, shown, atlas, flat, joints, weights)
    joints, weights = views[0].hanging.weights(tube.vertices_m)
    return (Shell(tube.vertices_m, tube.triangles, tube.uv, joints, weights, rgba, "cloth"),)


def shell_views(views: list[LooseView], proposals: Proposals, silhouettes: SilhouetteSet) -> list[ShellView]:
    """Return the photos with their pixels of cloth without arms; the side photo also mirrored."""
    found = []
    for view in views:
        name, proposal = view.posed.view, proposals.views[view.posed.view]
        person = silhouettes.views[name].mask
        figure = float(np.count_nonzero(person.any(axis=1)))
        mask: NDArray[np.bool_] = person & view.region.cloth(
            (person.shape[0], person.shape[1]), margin_px=HEM_MARGIN * figure
        )
        arms = arm_zone(combined_pose(proposal), figure, person.shape)
        # labels know bare arms where the net's lines miss them; sleeves are told by the lines alone
        mask &= (signed_distance(arms) < -ARM_MARGIN * figure) & shows(proposal.labels, *CLOTHES)
        inside = signed_distance(mask)
        found.append(ShellView(view.posed, mask, inside, CLAIM[name]))
        if name is ViewId.BODY_SIDE:
            found.append(ShellView(view.posed, mask, inside, CLAIM[name], view.hanging.middle_m))
    return found
