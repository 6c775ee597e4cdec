"""Side and back photos warped along feature lines that they share with the front photo.

The fit is wrong by some millimetres, and by another few in every photo: laid down as they are, two photos draw a brow,
a hairline or a stripe twice where they mix. The front photos stay, for they show most and squarely; the others meet
them, each where it sees the same skin.

References
----------
Method notes section 9: side views are deformed so that feature lines coincide with those of the front view.
"""

from __future__ import annotations

from dataclasses import replace
from typing import Final

import numpy as np
from numpy.typing import NDArray

from cloner.frames import ViewId
from cloner.generic.charts import generic_atlas
from cloner.generic.load import GenericHuman
from cloner.generic.photo_shares import arms
from cloner.geometry.cameras.visibility import DEPTH_SCALE
from cloner.geometry.charts.atlas import AtlasMap
from cloner.paint.lookups.sources import Source
from cloner.parallel import parallel_map
from cloner.vision.retouching.line_match import LinePicture, MatchScales, SharedSamples, line_pictures, match_lines

SIZE: Final = 384  # texels a side at which photos are compared: 7 mm on the body, 3 mm on the face
#: How finely faces and bodies are matched; what the fit is wrong by was measured on people of the kit.
FACE: Final = MatchScales(blur_m=0.0015, usual_m=0.003, most_m=0.010)
BODY: Final = MatchScales(blur_m=0.004, usual_m=0.010, most_m=0.025)
LEAST_COSINE: Final = 0.2  # more slanting sights are stretched too much to be compared
#: Who is displaced, in this order, and towards whom: earlier ones stay as they then lie.
MEETING: Final = (
    (ViewId.FACE_SIDE, (ViewId.FACE_FRONT,)),
    (ViewId.BODY_FRONT, (ViewId.FACE_FRONT, ViewId.FACE_SIDE)),
    (ViewId.BODY_BACK, (ViewId.FACE_SIDE,)),
    (ViewId.BODY_SIDE, (ViewId.BODY_FRONT, ViewId.BODY_BACK, ViewId.FACE_FRONT)),
)


def align_feature_lines(generic: GenericHuman, sources: list[Source]) -> list[Source]:
    """Return the sources with lookups warped so that the lines they share with better ones coincide.

    Parameters
    ----------
    sources : list of Source
        Mirrored ones are displaced as the photo itself: what is wrong is the photo's camera and pose more than the
        skin. (Matched by themselves they lay farther off on people of the kit, for no two halves are alike.)
    """
    atlas = generic_atlas(generic, SIZE)
    own = [source for source in sources if not source.mirrored]
    lines = dict(zip([source.view for source in own], parallel_map(_lines_of, own), strict=True))
    found = list(sources)
    for view, others in MEETING:
        stay = [source for source in found if source.view in others]
        for met in [_aligned(generic, atlas, stay, lines, source) for source in own if source.view is view]:
            found = [_moved(generic, source, met) if source.view is view else source for source in found]
    return found


def _moved(generic: GenericHuman, source: Source, met: Source) -> Source:
    """Return a photo's source, or its mirrored one, with the lookups of the warped one."""
    return replace(source, lookup_px=met.lookup_px[generic.mirror]) if source.mirrored else met


def _reach(view: ViewId) -> MatchScales:
    return FACE if view.is_face else BODY


def _lines_of(source: Source) -> dict[MatchScales, list[LinePicture]]:
    """Return a photo's line features at the scales of faces and of bodies."""
    matted, pixel_m = source.matted, source.visibility.metres_per_pixel * DEPTH_SCALE
    wanted = (FACE, BODY) if source.view.is_face else (BODY,)
    return {reach: line_pictures(matted.rgb, matted.labels, matted.inside_px > 0.0, pixel_m, reach) for reach in wanted}


def _aligned(
    generic: GenericHuman,
    atlas: AtlasMap,
    others: list[Source],
    lines: dict[ViewId, dict[MatchScales, list[LinePicture]]],
    source: Source,
) -> Source:
    """Return a source warped towards others; arms, which hang before the trunk, separately."""
    reach = _reach(source.view)
    limb = arms(generic)
    lookup = source.lookup_px.copy()
    for part in (limb, ~limb):
        shared = [
            (lines[other.view][reach], look)
            for other in others
            if (look := _shared_samples(atlas, source, other, part))
        ]
        if shared:
            pixel_m = source.visibility.metres_per_pixel * DEPTH_SCALE
            field = match_lines(lines[source.view][reach], shared, pixel_m, reach)
            lookup[part] += field.at(source.lookup_px[part])
    return source if (lookup == source.lookup_px).all() else replace(source, lookup_px=lookup)


def _shared_samples(atlas: AtlasMap, source: Source, other: Source, part: NDArray[np.bool_]) -> SharedSamples | None:
    """Return the samples of some vertices (V,) that two sources both show, None where there are none."""
    seen = part.copy()
    for one in (source, other):
        seen &= (one.score > 0.0) & (one.visibility.cosine > LEAST_COSINE)
    rows = atlas.rows_of(np.asarray(seen[atlas.triangles].all(axis=1), np.bool_))
    if not rows.size:
        return None
    table = np.column_stack([source.lookup_px, other.lookup_px, source.visibility.cosine, other.visibility.cosine])
    values = atlas.interpolate(table, rows)
    return SharedSamples(values[:, :2], values[:, 2:4], np.clip(np.minimum(values[:, 4], values[:, 5]), 0.0, 1.0))
