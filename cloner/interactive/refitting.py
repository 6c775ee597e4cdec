"""Immediate refit after a moved point: the last run's values and new corrections give the new body, without nets or
fit.

What corrections change of the body is one step (``stages/obeyed.py``), the very one that the next whole run ends with;
what they leave as it was, that run takes over (``reusable_values``).
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, replace
from typing import Any, Final

import numpy as np
from numpy.typing import NDArray

from cloner import pipeline
from cloner.editing.face import preview_face
from cloner.editing.outline_constraints import posed_photo
from cloner.frames import ViewId
from cloner.generic.surfaces import body_triangles
from cloner.geometry.outlines.silhouette import borders_px, fill_triangles
from cloner.records.clones import Clone, Joined
from cloner.records.photos import Person, PhotoSet
from cloner.records.points import Corrections, ObeyedPoint, PointSet, ViewPoints
from cloner.records.silhouettes import Silhouette, SilhouetteSet
from cloner.stages.obeyed import obey
from cloner.stages.points import apply_corrections, points_for_fit
from cloner.stages.silhouettes import missed_points

#: Stages that see of the body's points only what ``points_for_fit`` and far outline points let through.
FITTED: Final = ("views", "silhouettes", "phenotype", "fine", "join")


@dataclass(frozen=True, slots=True, eq=False)
class RefittedBody:
    """The body after points were moved.

    Attributes
    ----------
    person : Joined
        As the next whole run gives it, when ``is_whole``.
    obeyed : tuple of ObeyedPoint
    is_whole : bool
        False when a correction also changes the fit of the whole body or of the face: then only cloning again shows
        everything it does.
    """

    person: Joined
    obeyed: tuple[ObeyedPoint, ...]
    is_whole: bool


def refit_body(values: Mapping[str, Any], corrections: Corrections) -> RefittedBody:
    """Return the body with new corrections met.

    Parameters
    ----------
    values : mapping
        All values of a whole run on the same photos: "photos", "body_points", "face_points", "silhouettes", "joined".
    corrections : Corrections
        All that count now, not only the new one.

    Raises
    ------
    ClonerError
        If a correction lies off the image.
    """
    body, face = moved_points(values, corrections)
    silhouettes: SilhouetteSet = values["silhouettes"]
    head, on_face = preview_face(values["joined"], values["face_points"], face)
    person, outcomes = obey(head, body, silhouettes)
    whole = same_fit(values["body_points"], body, silhouettes) and same_points(values["face_points"], face)
    return RefittedBody(person, (*outcomes, *on_face), whole)


def clone_after(values: Mapping[str, Any], person: Joined) -> Clone:
    """Return the last run's clone with the refitted skin; hair and textures are kept."""
    clone: Clone = values["clone"]
    moved = person.vertices_m - values["obeyed"].vertices_m
    views = {**clone.views, **person.views}
    return replace(clone, vertices_m=clone.vertices_m + moved, joints_m=person.joints_m, views=views)


def outline_px(person: Joined, view: ViewId) -> tuple[NDArray[np.float64], ...]:
    """Return the closed borders (M, 2) of the person's skin in a photo, px; none of a face photo."""
    posed = person.views.get(view)
    if posed is None or not view.is_body:
        return ()
    seen = posed_photo(person.vertices_m, person.joints_m, posed)
    size = (posed.camera.height_px, posed.camera.width_px)
    return borders_px(fill_triangles(seen.pixels, body_triangles(), size))


def moved_points(values: Mapping[str, Any], corrections: Corrections) -> tuple[PointSet, PointSet]:
    """Return a run's points of body and face with other corrections on top."""
    photos: PhotoSet = values["photos"]
    faces: PointSet = values["face_points"]
    own = {view: frozenset(_proposed(points).names) for view, points in faces.views.items()}
    moved: dict[str, dict[ViewId, ViewPoints]] = {"body_points": {}, "face_points": {}}
    for kind, sets in moved.items():
        for view, points in values[kind].views.items():
            on_face = kind == "face_points"
            placed = {
                name: point
                for name, point in corrections.points.get(view, {}).items()
                if (name in own.get(view, ())) == on_face
            }
            sets[view] = apply_corrections(_proposed(points), placed, photos.photos[view])
    return PointSet(moved["body_points"]), PointSet(moved["face_points"])


def _proposed(points: ViewPoints) -> ViewPoints:
    return points.proposed or points


def same_fit(before: PointSet, after: PointSet, silhouettes: SilhouetteSet) -> bool:
    """Return whether the fit of the whole body would use the same points.

    Parameters
    ----------
    before, after : PointSet
        Body points; ``before`` are those the outlines were traced by.
    silhouettes : SilhouetteSet
        The outlines, as the fit took them.
    """
    if set(before.views) != set(after.views):
        return False
    fitted = [PointSet({view: points_for_fit(points) for view, points in one.views.items()}) for one in (before, after)]
    if not same_points(*fitted):
        return False
    return all(_same_trace(silhouettes.views[view], before.views[view], after.views[view]) for view in after.views)


def _same_trace(silhouette: Silhouette, before: ViewPoints, after: ViewPoints) -> bool:
    """Return whether one photo's outline would be traced alike: distant points stay, and none becomes distant."""
    far = set(missed_points(silhouette.contours_px, after))
    if not silhouette.through:
        return not far
    pairs = [(before.get(name), after.get(name)) for name in silhouette.through]
    return far <= set(silhouette.through) and all(
        was is not None and now is not None and np.array_equal(was, now) for was, now in pairs
    )


def same_points(before: PointSet, after: PointSet) -> bool:
    """Return whether two sets hold the same points at the same positions with the same confidence."""
    return set(before.views) == set(after.views) and all(
        own.names == other.names
        and np.array_equal(own.points_px, other.points_px)
        and np.array_equal(own.confidence, other.confidence)
        and np.array_equal(own.corrected, other.corrected)
        for own, other in ((before.views[view], after.views[view]) for view in before.views)
    )


def reusable_values(
    known: Mapping[str, object], photos: PhotoSet, person: Person, corrections: Corrections
) -> dict[str, object]:
    """Return those values of an earlier run that a new run would produce again.

    Parameters
    ----------
    known : mapping
        Values of an earlier run with the same seed; the photos must be the same files, or nothing stays.
    photos, person, corrections
        As they are now.

    Notes
    -----
    A value stays while all that its stage needs has stayed; corrections of points change only what takes those
    points (see ``FITTED``). The clone itself is always painted anew: its size may be another. The stages' reports are
    kept under "stage_reports", for what does not run again.
    """
    before = known.get("photos")
    if not isinstance(before, PhotoSet) or _digests(before) != _digests(photos):
        return {}
    changed = {"corrections", *(("person",) if known.get("person") != person else ())}
    kept: dict[str, object] = {"stage_reports": known["stage_reports"]} if "stage_reports" in known else {}
    for stage in pipeline.STAGES:
        needs = set(stage.needs)
        if stage.name == "points" and {*stage.gives, *stage.needs, "silhouettes"} <= set(known):
            body, face = moved_points({**known, "photos": photos}, corrections)
            kept |= {"body_points": body, "face_points": face}
            changed |= _changed_points(known, body, face)
            continue
        if "body_points" in needs and stage.name in FITTED and "fitted_points" not in changed:
            needs.discard("body_points")
        if needs & changed or {"painted", "surfaces", "clone"} & set(stage.gives) or not set(stage.gives) <= set(known):
            changed |= set(stage.gives) | ({"fitted_points"} if stage.name == "points" else set())
        else:
            kept |= {name: known[name] for name in stage.gives}
    return kept


def _changed_points(known: Mapping[str, Any], body: PointSet, face: PointSet) -> set[str]:
    """Return which of "body_points", "fitted_points" (what the whole fit takes of them) and "face_points" changed."""
    changed = set()
    if not same_points(known["body_points"], body):
        changed.add("body_points")
    if not same_fit(known["body_points"], body, known["silhouettes"]):
        changed.add("fitted_points")
    if not same_points(known["face_points"], face):
        changed.add("face_points")
    return changed


def _digests(photos: PhotoSet) -> dict[ViewId, str]:
    return {view: photo.digest for view, photo in photos.photos.items()}
