"""Operator corrections: pure edits, and JSON."""

from __future__ import annotations

import json
import math
from collections.abc import Collection
from typing import Any, Final

from cloner.errors import ClonerError
from cloner.frames import ViewId
from cloner.generic.load import load_generic
from cloner.project.texts import check_format
from cloner.records.photos import PhotoSet
from cloner.records.points import Correction, Corrections

FORMAT: Final = 1
WHERE: Final = "corrections.json"
_HINT: Final = "Correct the entry, or move the file away to use the proposals alone"


def no_corrections() -> Corrections:
    """Return corrections that hold no point."""
    return Corrections(points={})


def move_point(corrections: Corrections, view: ViewId, name: str, x_px: float, y_px: float, digest: str) -> Corrections:
    """Return corrections in which one point lies at the given place.

    Parameters
    ----------
    corrections : Corrections
        Unchanged.
    view : ViewId
    name : str
        Name of the feature point.
    x_px, y_px : float
        Photo pixels of ``view``.
    digest : str
        sha256 of the photo the point was placed on.

    Raises
    ------
    ValueError
        If the place is not finite.
    """
    if not (math.isfinite(x_px) and math.isfinite(y_px)):
        raise ValueError(f"{view}.{name}: ({x_px}, {y_px}) is no place in a photo")
    points = _mutable(corrections)
    points.setdefault(ViewId(view), {})[name] = Correction(float(x_px), float(y_px), digest)
    return Corrections(points=points)


def remove_point(corrections: Corrections, view: ViewId, name: str) -> Corrections:
    """Return corrections without one point; the proposal counts again. Absent points stay absent."""
    points = _mutable(corrections)
    points.get(view, {}).pop(name, None)
    return Corrections(points={view: named for view, named in points.items() if named})


def to_json(corrections: Corrections) -> str:
    """Return the text of ``corrections.json``, views and names sorted."""
    views = {
        view.value: {
            name: {"x": point.x_px, "y": point.y_px, "photo_sha256": point.photo_digest}
            for name, point in sorted(corrections.points[view].items())
        }
        for view in ViewId
        if corrections.points.get(view)
    }
    return json.dumps({"format": FORMAT, "views": views}, indent=1) + "\n"


def from_json(text: str) -> Corrections:
    """Return the corrections in the text of ``corrections.json``.

    Raises
    ------
    ClonerError
        If the text is no JSON, of another format, or names an unknown view.
    """
    try:
        data = json.loads(text)
    except (ValueError, RecursionError) as error:
        raise ClonerError("this is not valid JSON", _HINT, WHERE) from error
    if not isinstance(data, dict) or "format" not in data:
        raise ClonerError(f'it must be an object with "format": {FORMAT}', _HINT, WHERE)
    check_format(data["format"], FORMAT, WHERE)
    unknown = sorted(set(data) - {"format", "views"})
    if unknown:
        raise ClonerError(f"the key {unknown[0]!r} is not known", _HINT, WHERE)
    views = _object(data.get("views", {}), "views")
    return Corrections(points={_view(key): _points(key, named) for key, named in views.items()})


def point_names() -> frozenset[str]:
    """Return the names a correction may use: feature points and joints of the generic human."""
    generic = load_generic()
    return frozenset((*generic.feature_names, *generic.joint_names))


def check_against(
    corrections: Corrections, photos: PhotoSet, known_names: Collection[str] | None = None
) -> tuple[str, ...]:
    """Return warnings about corrections placed on photos that have changed since.

    Parameters
    ----------
    corrections : Corrections
    photos : PhotoSet
    known_names : names, optional
        Those a correction may use; None accepts every name.

    Raises
    ------
    ClonerError
        If a point lies outside its photo or has an unknown name.
    """
    warnings = []
    for view, named in corrections.points.items():
        photo = photos.photos.get(view)
        if photo is None:
            warnings.append(f"corrections.json corrects {view}, but there is no such photo: they are not used")
            continue
        changed = False
        for name, point in named.items():
            where = f"{WHERE}, {view}.{name}"
            if known_names is not None and name not in known_names:
                raise ClonerError("there is no feature point of this name in this view", _HINT, where)
            # half a pixel beyond the outermost pixel centres is still the photo
            if not (-0.5 <= point.x_px <= photo.width_px - 0.5 and -0.5 <= point.y_px <= photo.height_px - 0.5):
                size = f"{photo.width_px} x {photo.height_px} pixels"
                raise ClonerError(f"the point lies outside the photo of {size}", _HINT, where)
            changed = changed or bool(point.photo_digest and point.photo_digest != photo.digest)
        if changed:
            warnings.append(f"{view} has changed since its points were corrected: check them")
    return tuple(warnings)


def _mutable(corrections: Corrections) -> dict[ViewId, dict[str, Correction]]:
    return {view: dict(named) for view, named in corrections.points.items()}


def _object(value: Any, what: str) -> dict[str, Any]:
    if not isinstance(value, dict):
        raise ClonerError(f"{what} must be an object", _HINT, WHERE)
    return value


def _view(key: str) -> ViewId:
    try:
        return ViewId(key)
    except ValueError as error:
        message = f"{key!r} is not a view; the views are {', '.join(ViewId)}"
        raise ClonerError(message, _HINT, WHERE) from error


def _points(view: str, named: Any) -> dict[str, Correction]:
    return {name: _point(f"{view}.{name}", entry) for name, entry in _object(named, view).items()}


def _point(where: str, entry: Any) -> Correction:
    entry = _object(entry, where)
    unknown = sorted(set(entry) - {"x", "y", "photo_sha256"})
    if unknown:
        raise ClonerError(f"the key {unknown[0]!r} is not known", _HINT, f"{WHERE}, {where}")
    x_px, y_px = (_number(entry.get(axis)) for axis in ("x", "y"))
    digest = entry.get("photo_sha256", "")
    if x_px is None or y_px is None or not isinstance(digest, str):
        raise ClonerError('a point needs numbers "x" and "y" in photo pixels', _HINT, f"{WHERE}, {where}")
    return Correction(x_px, y_px, digest)


def _number(value: Any) -> float | None:
    if isinstance(value, bool) or not isinstance(value, int | float):
        return None
    try:
        number = float(value)
    except OverflowError:  # JSON's whole numbers have no end
        return None
    return number if math.isfinite(number) else None
