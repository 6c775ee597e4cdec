"""From photos to the clone in memory: `clone` for programs (``from cloner import clone``), and its implementation."""

from __future__ import annotations

import logging
from collections.abc import Mapping, Sequence
from dataclasses import replace
from functools import partial
from pathlib import Path
from typing import Any, Final, cast

from cloner import pipeline
from cloner.errors import ClonerError
from cloner.frames import ViewId, cm_from_m
from cloner.pipeline import Progress, Stage, StageReport, no_progress
from cloner.project.corrections import no_corrections
from cloner.project.folder import checked_height_m, load_photos, read_corrections, read_person
from cloner.project.stamps import stamp_text
from cloner.records.clones import Clone
from cloner.records.measures import MeasureSet
from cloner.records.photos import Person, Photo, PhotoSet
from cloner.records.points import Corrections
from cloner.records.proposals import Proposals
from cloner.records.silhouettes import SilhouetteSet
from cloner.report.agreement import PhotoAgreement, agreements
from cloner.report.evidence import contradicting_photos, is_better
from cloner.stages import hair, textures
from cloner.vision.photographs.pictures import read_picture

log = logging.getLogger(__name__)

TEXTURE_SIZES: Final = (512, 1024, 2048, 4096)  # powers of two, as graphics cards want them
DEFAULT_TEXTURE_SIZE: Final = textures.Params().size


def clone(
    photos: str | Path | Mapping[str, str | Path],
    height_m: float | None = None,
    *,
    seed: int = 0,
    texture_size: int = DEFAULT_TEXTURE_SIZE,
    progress: Progress = no_progress,
) -> Clone:
    """Return the clone of the person in some photos; writes nothing.

    Parameters
    ----------
    photos : path or mapping of str to path
        A folder with body_front.jpg and so on (``person.toml`` and ``corrections.json`` beside them count), or files by
        view: body_front, body_side, body_back, face_front, face_side; one front photo is needed.
    height_m : float, optional
        Barefoot height in metres; wins over ``person.toml``. Without one 1.70 m is assumed.
    seed : int
        The same photos and seed give the same clone.
    texture_size : int
        Side of the texture: 512, 1024, 2048 or 4096 texels.
    progress : callable
        Called with a step's name and the fraction 0..1 of the whole; may raise :class:`cloner.errors.Cancelled`.

    Returns
    -------
    Clone
        ``cloner.exporters.table.EXPORTERS.get("glb")(clone, folder)`` writes it.

    Raises
    ------
    ClonerError
        If the photos or the height cannot be used; its message says what to do.
    """
    if isinstance(photos, str | Path):
        folder = Path(photos)
        loaded, corrections = load_photos(folder), read_corrections(folder)
        person = read_person(folder, None if height_m is None else cm_from_m(height_m))
    else:
        loaded, corrections, person = _load_photos(photos), no_corrections(), _person(height_m)
    values, _ = clone_photos(loaded, person, corrections, seed=seed, texture_size=texture_size, progress=progress)
    made: Clone = values["clone"]
    return made


def _load_photos(files: Mapping[str, str | Path]) -> PhotoSet:
    photos = {}
    for name, path in files.items():
        try:
            view = ViewId(name)
        except ValueError as error:
            raise ClonerError(f"{name!r} is no view", f"The views are {', '.join(ViewId)}", "photos") from error
        picture = read_picture(Path(path))
        photos[view] = Photo(view, picture.rgb, picture.focal_35mm, picture.digest, Path(path).name)
    if ViewId.BODY_FRONT not in photos and ViewId.FACE_FRONT not in photos:
        raise ClonerError("one front photo is needed", "Give body_front, face_front or both", "photos")
    return PhotoSet(photos)


def _person(height_m: float | None) -> Person:
    stature_m, known = checked_height_m(height_m)
    return Person(identifier="visitor", name="", stature_m=stature_m, stature_is_known=known, notes="", tape_mm=())


def clone_photos(
    photos: PhotoSet,
    person: Person,
    corrections: Corrections,
    *,
    seed: int = 0,
    progress: Progress = no_progress,
    found: pipeline.Found = pipeline.ignore_values,
    known: Mapping[str, object] | None = None,
    texture_size: int = DEFAULT_TEXTURE_SIZE,
) -> tuple[dict[str, Any], list[StageReport]]:
    """Return all values of the pipeline and one report a stage; writes nothing.

    Parameters
    ----------
    photos, person, corrections
    seed : int
        Project seed; the same input and seed give the same clone.
    progress, found : callable
        As in :func:`cloner.pipeline.run`.
    known : mapping, optional
        Values that are known already (say "proposals"); their stages are skipped, and their reports, if they are
        among them as "stage_reports", are told again.
    texture_size : int
        Side of the texture atlas, texels; one of `TEXTURE_SIZES`.

    Raises
    ------
    ClonerError
        If the photos cannot be cloned.
    Cancelled
        If ``progress`` raised it.
    """
    values = {**(known or {}), "photos": photos, "person": person, "corrections": corrections}
    check_texture_size(texture_size)
    values, fresh = _run_without_contradicting_photos(values, seed, progress, found, _stages(texture_size))
    reports = merge_reports(fresh, (known or {}).get("stage_reports", ()))
    measures = cast(MeasureSet, values["measures"]).measures
    values["clone"] = replace(
        cast(Clone, values["clone"]),
        stamp=stamp_text(seed, texture_size, [photo.digest for photo in photos.photos.values()]),
        measures_mm={name: round(measure.value_mm, 1) for name, measure in measures.items()},
    )
    return {**values, "stage_reports": reports}, list(reports)


def _run_without_contradicting_photos(
    values: Mapping[str, Any], seed: int, progress: Progress, found: pipeline.Found, stages: tuple[Stage, ...]
) -> tuple[dict[str, Any], list[StageReport]]:
    """Run the stages; if the clone contradicts a photo that it can do without, run them again without it.

    How well the clone covers the person is among the values, as "agreements".
    """
    given = dict(values)
    values, reports = pipeline.run(given, seed=seed, progress=progress, found=found, stages=stages)
    values["agreements"] = seen = _photo_agreements(values)
    unlike = contradicting_photos(seen)
    if unlike:
        log.info("made again without %s", ", ".join(unlike))
        base = {name: given[name] for name in ("photos", "person", "corrections")}
        base["proposals"] = cast(Proposals, values["proposals"]).without(unlike)
        again, fresh = pipeline.run(base, seed=seed, progress=progress, found=found, stages=stages)
        again["agreements"] = fresh_seen = _photo_agreements(again)
        if is_better(seen, fresh_seen):
            first = [report for report in reports if report.name == "proposals"]
            return again, [*first, *fresh]
    return values, reports


def _photo_agreements(values: Mapping[str, object]) -> dict[ViewId, PhotoAgreement]:
    return agreements(cast(Clone, values["clone"]), cast(SilhouetteSet, values["obeyed_silhouettes"]))


def merge_reports(fresh: Sequence[StageReport], earlier: object) -> tuple[StageReport, ...]:
    """Return the reports of all stages in order; stages that did not run again keep their earlier one, at zero time."""
    by_name = {report.name: replace(report, seconds=0.0, cpu_seconds=0.0) for report in cast(Any, earlier)}
    by_name |= {report.name: report for report in fresh}
    return tuple(by_name[stage.name] for stage in pipeline.STAGES if stage.name in by_name)


def check_texture_size(size: int) -> None:
    """Refuse texture sizes that no program likes, before any work.

    Raises
    ------
    ClonerError
        If the size is not one of `TEXTURE_SIZES`.
    """
    if size not in TEXTURE_SIZES:
        hint = f"The sizes are {', '.join(str(known) for known in TEXTURE_SIZES)}"
        raise ClonerError(f"a texture of {size} texels cannot be made", hint, "--size")


def _stages(texture_size: int) -> tuple[Stage, ...]:
    """Return the pipeline's stages with textures of the given size; hair needs none larger than the body."""
    own = min(hair.Params().size, texture_size)
    params = {"textures": textures.Params(size=texture_size), "hair": hair.Params(size=own)}
    return tuple(
        replace(stage, run=partial(stage.run, params=params[stage.name])) if stage.name in params else stage
        for stage in pipeline.STAGES
    )
