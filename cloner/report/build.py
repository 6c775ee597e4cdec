"""The report of a clone as plain JSON values."""

from __future__ import annotations

import importlib.metadata
import platform
from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass
from typing import Any, Final

import cloner
from cloner.frames import ViewId
from cloner.generic.fdp import fdp_names
from cloner.geometry.measurement.under_clothes import NINE_IN_TEN
from cloner.pipeline import StageReport
from cloner.project.stamps import model_digests
from cloner.records.clones import Clone
from cloner.records.heads import HeadFit
from cloner.records.photos import Person, PhotoSet
from cloner.records.points import ObeyedPoint, PointSet
from cloner.records.silhouettes import SilhouetteSet
from cloner.records.views import ViewSet
from cloner.report.agreement import PhotoAgreement
from cloner.report.measures import measures_json
from cloner.report.standing import pose_warnings
from cloner.report.weak import group_warnings, photo_weaknesses
from cloner.stages.measures import UNKNOWN_STATURE_M

FORMAT: Final = 3  # 2: "measures_mm" instead of "girths_mm"
LIBRARIES: Final = (
    "numpy",
    "scipy",
    "opencv-contrib-python-headless",
    "pillow",
    "scikit-image",
    "trimesh",
    "moderngl",
    "pygltflib",
    "ai-edge-litert",
)


@dataclass(frozen=True, slots=True)
class Run:
    """Circumstances of a run.

    Attributes
    ----------
    seconds, cpu_seconds, peak_mib : float
        Of everything, from reading the photos to the last file.
    stages : tuple of StageReport
    seed : int
    formats : tuple of str
    warnings : tuple of str
        From reading the folder; the stages' own come from their reports.
    """

    seconds: float
    cpu_seconds: float
    peak_mib: float
    stages: tuple[StageReport, ...]
    seed: int
    formats: tuple[str, ...]
    warnings: tuple[str, ...]


def build_report(
    values: Mapping[str, Any], run: Run, seen: Mapping[ViewId, PhotoAgreement], files: Iterable[str] = ()
) -> dict[str, Any]:
    """Return the report of a finished clone as plain JSON values.

    Parameters
    ----------
    values : mapping
        All values of the pipeline, by name.
    run : Run
    seen : mapping
        How well the clone covers the person, of every photo that tells; see :func:`agreements`.
    files : iterable of str
        Paths of the written files, relative to the report.
    """
    person: Person = values["person"]
    clone: Clone = values["clone"]
    photos: PhotoSet = values["photos"]
    return {
        "format": FORMAT,
        "person": _person(person),
        "photos": {view: _photo(photo) for view, photo in photos.photos.items()},
        "stature": _stature(clone, person),
        "measures_mm": measures_json(values["measures"]),
        "silhouette_iou": {view: round(found.iou, 4) for view, found in seen.items()},
        "outline_rms": {
            view: {"px": round(found.outline_rms_px, 2), "mm": round(found.outline_rms_mm, 2)}
            for view, found in seen.items()
        },
        "residuals": _residuals(run.stages),
        "side_shown": _sides(values["views"], values["head"]),
        "features": _features(values["body_points"], values["face_points"]),
        "corrections": [_obeyed(point) for point in values["obeyed_points"]],
        "outline_segments": _outline_segments(values["silhouettes"]),
        "features_m": {name: _rounded(point, 5) for name, point in sorted(clone.features_m.items())},
        "timings": _timings(run),
        "peak_mib": round(run.peak_mib, 1),
        "seed": run.seed,
        "formats": list(run.formats),
        "files": sorted(files),
        "versions": versions(),
        "models": dict(model_digests()),
        "warnings": list(group_warnings((*warnings_of(run), *_weak(values, seen)))),
    }


def _weak(values: Mapping[str, Any], seen: Mapping[ViewId, PhotoAgreement]) -> tuple[str, ...]:
    """Return what is weak in the clone because of its photos."""
    weaknesses = photo_weaknesses(values["photos"], values["proposals"], seen)
    return *weaknesses, *pose_warnings(values["clone"], values["proposals"])


def warnings_of(run: Run) -> tuple[str, ...]:
    """Return all warnings once each, in the order in which they arose."""
    every = [*run.warnings, *(warning for stage in run.stages for warning in stage.warnings)]
    return tuple(dict.fromkeys(every))


def versions() -> dict[str, str]:
    """Return the versions of Cloner, Python and the libraries that shape the result."""
    found = {"cloner": cloner.__version__, "python": platform.python_version(), "machine": platform.machine()}
    for name in LIBRARIES:
        try:
            found[name] = importlib.metadata.version(name)
        except importlib.metadata.PackageNotFoundError:
            found[name] = "not installed"
    return found


def _person(person: Person) -> dict[str, Any]:
    return {
        "identifier": person.identifier,
        "name": person.name,
        "height_given_m": round(person.stature_m, 4) if person.stature_is_known else None,
        "notes": person.notes,
    }


def _photo(photo: Any) -> dict[str, Any]:
    return {
        "file": photo.name,
        "sha256": photo.digest,
        "width_px": photo.width_px,
        "height_px": photo.height_px,
        "focal_35mm": photo.focal_35mm,
    }


def _stature(clone: Clone, person: Person) -> dict[str, Any]:
    return {
        "value_m": round(clone.stature_m, 4),
        "known": person.stature_is_known,
        "plus_minus_m": None if person.stature_is_known else round(NINE_IN_TEN * UNKNOWN_STATURE_M, 3),
        "sole_m": round(clone.sole_m, 4),
    }


def _residuals(stages: Sequence[StageReport]) -> list[dict[str, Any]]:
    return [
        {
            "stage": stage.name,
            "name": residual.name,
            "view": residual.view or None,
            "value": round(residual.value, 3),
            "unit": residual.unit,
        }
        for stage in stages
        for residual in stage.residuals
    ]


def _sides(views: ViewSet, head: HeadFit) -> dict[str, str | None]:
    body = views.views.get(ViewId.BODY_SIDE)
    return {
        ViewId.BODY_SIDE: body.side_shown if body is not None else None,
        ViewId.FACE_SIDE: head.side_shown or None,
    }


def _features(body: PointSet, face: PointSet) -> dict[str, Any]:
    data: dict[str, Any] = {}
    for points in (body, face):
        for view, named in points.views.items():
            rows = zip(named.names, named.points_px, named.confidence, named.corrected, strict=True)
            data.setdefault(view, {}).update(
                {
                    name: {
                        "x_px": round(float(point[0]), 2),
                        "y_px": round(float(point[1]), 2),
                        "confidence": round(float(confidence), 3),
                        "source": "corrected" if corrected else "proposed",
                        **({"mpeg4": fdp_names()[name]} if name in fdp_names() else {}),
                    }
                    for name, point, confidence, corrected in rows
                }
            )
    return data


def _obeyed(point: ObeyedPoint) -> dict[str, Any]:
    return {
        "view": point.view,
        "name": point.name,
        "kind": point.kind,
        "px_before": round(point.before_px, 2),
        "px_after": round(point.after_px, 2),
        "moved_mm": round(point.moved_mm, 1),
        "note": point.note,
    }


def _outline_segments(silhouettes: SilhouetteSet) -> dict[str, Any]:
    return {
        view: [
            {"segment": name, "source": source, "goodness": round(float(goodness), 3)}
            for name, source, goodness in silhouette.sources
        ]
        for view, silhouette in silhouettes.views.items()
    }


def _timings(run: Run) -> dict[str, Any]:
    return {
        "seconds": round(run.seconds, 3),
        "cpu_seconds": round(run.cpu_seconds, 3),
        "stages": [
            {
                "stage": stage.name,
                "seconds": round(stage.seconds, 3),
                "cpu_seconds": round(stage.cpu_seconds, 3),
                "peak_mib": round(stage.peak_mib, 1),
            }
            for stage in run.stages
        ],
    }


def _rounded(point: Any, digits: int) -> list[float]:
    return [round(float(value), digits) for value in point]
