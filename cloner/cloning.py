"""The one way from a folder of photos to a folder of results; behind command line, batch and window."""

from __future__ import annotations

import logging
import time
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace
from functools import partial
from pathlib import Path
from typing import Any, Final, cast

from cloner import pipeline
from cloner.abreast import abreast, beside
from cloner.errors import ClonerError
from cloner.exporters.table import EXPORTERS
from cloner.frames import ViewId
from cloner.generic.load import load_generic
from cloner.interactive.refitting import still_true
from cloner.memory import check_room, peak_mib
from cloner.pipeline import Progress, Stage, StageReport, quiet
from cloner.previews import write_previews
from cloner.project.atomic import result_folder
from cloner.project.clone_file import CLONE_FILE, save_clone
from cloner.project.corrections import check_against
from cloner.project.folder import (
    load_photos,
    person_warnings,
    photo_warnings,
    read_consent,
    read_corrections,
    read_person,
    read_terms,
)
from cloner.project.results import RESULT_MARK, place_digest
from cloner.project.stamps import beside_digests, output_digests, stamp_of, stamp_text
from cloner.records.clones import Clone
from cloner.records.measures import MeasureSet
from cloner.records.photos import Person, PhotoSet
from cloner.records.points import Corrections, Proposals
from cloner.records.silhouettes import SilhouetteSet
from cloner.report.agreement import Agreement, agreements
from cloner.report.build import Run, build_report, warnings_of
from cloner.report.evidence import contradicted, is_better
from cloner.report.viewer import write_viewer
from cloner.report.write import write_page, write_report
from cloner.stages import hair, textures

log = logging.getLogger(__name__)

DEFAULT_FORMATS: Final = ("glb", "wrl")
PIPELINE_SHARE: Final = 0.85  # measured on the samples: the stages' part of the whole time
GLB_FILE: Final = "clone.glb"
TEXTURE_SIZES: Final = (512, 1024, 2048, 4096)  # powers of two, as graphics cards want them
DEFAULT_TEXTURE_SIZE: Final = textures.Params().size


@dataclass(frozen=True, slots=True, eq=False)
class CloneOutcome:
    """What a finished clone left.

    Attributes
    ----------
    identifier : str
    folder : Path
        Holds all files.
    report : mapping
        The content of ``report.json``.
    values : mapping
        All values of the pipeline, by name.
    """

    identifier: str
    folder: Path
    report: Mapping[str, Any]
    values: Mapping[str, Any]

    @property
    def warnings(self) -> tuple[str, ...]:
        """Warnings in plain words."""
        return tuple(self.report["warnings"])


def clone_photos(
    photos: PhotoSet,
    person: Person,
    corrections: Corrections,
    *,
    seed: int = 0,
    progress: Progress = quiet,
    found: pipeline.Found = pipeline.unseen,
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
        As in :func:`clone_folder`.
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
    values, fresh = _run_believing(values, seed, progress, found, _stages(texture_size))
    reports = with_earlier(fresh, (known or {}).get("stage_reports", ()))
    measures = cast(MeasureSet, values["measures"]).measures
    values["clone"] = replace(
        cast(Clone, values["clone"]),
        stamp=stamp_text(seed, texture_size, [photo.digest for photo in photos.photos.values()]),
        measures_mm={name: round(measure.value_mm, 1) for name, measure in measures.items()},
    )
    return {**values, "stage_reports": reports}, list(reports)


def _run_believing(
    values: Mapping[str, Any], seed: int, progress: Progress, found: pipeline.Found, stages: tuple[Stage, ...]
) -> tuple[dict[str, Any], list[StageReport]]:
    """Run the stages; when the clone contradicts a photo that it can do without, run them again without it.

    How well the clone covers the person is among the values, as "agreements".
    """
    given = dict(values)
    values, reports = pipeline.run(given, seed=seed, progress=progress, found=found, stages=stages)
    values["agreements"] = seen = _seen_whole(values)
    unlike = contradicted(seen)
    if unlike:
        log.info("made again without %s", ", ".join(unlike))
        base = {name: given[name] for name in ("photos", "person", "corrections")}
        base["proposals"] = cast(Proposals, values["proposals"]).without(unlike)
        again, fresh = pipeline.run(base, seed=seed, progress=progress, found=found, stages=stages)
        again["agreements"] = fresh_seen = _seen_whole(again)
        if is_better(seen, fresh_seen):
            first = [report for report in reports if report.name == "proposals"]
            return again, [*first, *fresh]
    return values, reports


def _seen_whole(values: Mapping[str, object]) -> dict[ViewId, Agreement]:
    return agreements(cast(Clone, values["clone"]), cast(SilhouetteSet, values["obeyed_silhouettes"]))


def clone_folder(
    photos_dir: Path,
    out_dir: Path,
    *,
    height_cm: float | None = None,
    formats: Sequence[str] = DEFAULT_FORMATS,
    seed: int = 0,
    identifier: str | None = None,
    texture_size: int = DEFAULT_TEXTURE_SIZE,
    progress: Progress = quiet,
    found: pipeline.Found = pipeline.unseen,
    known: Mapping[str, object] | None = None,
) -> CloneOutcome:
    """Clone the person in a folder of photos; the result appears whole or not at all.

    Parameters
    ----------
    photos_dir : Path
        Holds the photos, and optionally ``person.toml`` and ``corrections.json``.
    out_dir : Path
        Receives a folder named by the person's identifier.
    height_cm : float or None
        Barefoot height; wins over ``person.toml``.
    formats : sequence of str
        Names of exporters.
    seed : int
    identifier : str or None
        Name of the result's folder; None takes the photo folder's name.
    texture_size : int
        Side of the texture atlas, texels; one of `TEXTURE_SIZES`.
    progress : callable
        Called with a step's name and a fraction 0..1; may raise Cancelled.
    found : callable
        Called after every stage with its name and the values known by then.
    known : mapping, optional
        Values of an earlier run on this folder; those still true are not found again.

    Raises
    ------
    ClonerError
        If the input or the output folder is unusable, or a limit leaves too little memory.
    Cancelled
        If ``progress`` raised it; nothing is left behind.
    """
    begun = time.perf_counter(), time.process_time()
    check_room()
    check_formats(formats)
    check_texture_size(texture_size)
    progress("photos", 0.0)
    beside = beside_digests(photos_dir)
    person = read_person(photos_dir, height_cm, identifier)
    corrections, consent, terms = read_corrections(photos_dir), bool(read_consent(photos_dir)), read_terms(photos_dir)
    if beside_digests(photos_dir) != beside:
        raise ClonerError("its files were changed while they were read", "Clone again", photos_dir.name)
    with result_folder(out_dir, person.identifier, photos_dir) as folder:
        photos = load_photos(photos_dir)
        warnings = *person_warnings(person), *photo_warnings(photos), *check_against(corrections, photos, point_names())
        values, stages = clone_photos(
            photos,
            person,
            corrections,
            seed=seed,
            texture_size=texture_size,
            found=found,
            known=still_true(known or {}, photos, person, corrections),
            progress=lambda step, fraction: progress("export" if step == "done" else step, PIPELINE_SHARE * fraction),
        )
        values["clone"] = replace(values["clone"], consent=consent, terms=terms)
        _write_clone(values, formats, folder, progress)
        if (folder / GLB_FILE).is_file():
            write_viewer(f"Clone of {person.name or person.identifier}", folder / GLB_FILE)
        run = _run_since(begun, stages, seed=seed, formats=tuple(formats), warnings=warnings)
        progress("report", 0.97)
        report = build_report(values, run, values["agreements"], sorted({*_files(folder), RESULT_MARK})) | {
            "made_by": values["clone"].stamp,
            "stamp": stamp_of(
                {str(view): photo.digest for view, photo in photos.photos.items()},
                beside,
                stamp_options(height_cm, formats, seed, texture_size),
            ),
            "source": place_digest(photos_dir),
        }
        write_page(report, folder)
        report |= {"outputs": output_digests(folder, _files(folder))}
        write_report(report, folder)
    progress("done", 1.0)
    log.info("%s: %.1f s, %d warnings", person.identifier, run.seconds, len(warnings_of(run)))
    return CloneOutcome(person.identifier, out_dir / person.identifier, report, values)


def _run_since(
    begun: tuple[float, float],
    stages: Sequence[StageReport],
    *,
    seed: int,
    formats: tuple[str, ...],
    warnings: tuple[str, ...],
) -> Run:
    """Return how a clone was made since ``begun``, wall and CPU seconds."""
    wall, cpu = time.perf_counter() - begun[0], time.process_time() - begun[1]
    return Run(wall, cpu, peak_mib(), tuple(stages), seed, formats, warnings)


def with_earlier(fresh: Sequence[StageReport], earlier: object) -> tuple[StageReport, ...]:
    """Return the reports of all stages in their order: of those that did not run again the earlier one, at no time."""
    by_name = {report.name: replace(report, seconds=0.0, cpu_seconds=0.0) for report in cast(Any, earlier)}
    by_name |= {report.name: report for report in fresh}
    return tuple(by_name[stage.name] for stage in pipeline.STAGES if stage.name in by_name)


def check_formats(formats: Sequence[str]) -> None:
    """Refuse formats nobody can write, before any work.

    USD's library is loaded here, before other threads compute: its loading waits for Python's lock inside the dynamic
    loader's, and NumPy asks the loader under Python's lock (its stack walk for temporaries): both would wait for ever.

    Raises
    ------
    ClonerError
        If a name is not in the exporters' table, or USD is asked for and its library is not installed.
    """
    for name in formats:
        if name not in EXPORTERS:
            hint = f"The formats are {', '.join(EXPORTERS)}"
            raise ClonerError(f"the format {name!r} is not known", hint, "--format")
    if "usdz" in formats:
        from cloner.exporters.usd import usd_library

        usd_library()


def point_names() -> dict[ViewId, frozenset[str]]:
    """Return the names a correction may use: feature points and joints of the generic human, in every view."""
    generic = load_generic()
    return dict.fromkeys(ViewId, frozenset((*generic.feature_names, *generic.joint_names)))


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


def _write_clone(values: Mapping[str, Any], formats: Sequence[str], folder: Path, progress: Progress) -> None:
    """Write the clone's own file, the exports and the previews."""
    clone = values["clone"]
    keep = partial(save_clone, clone, folder / CLONE_FILE)
    writers = (keep, *(partial(_export, name, clone, folder) for name in formats))
    progress("previews", 0.9)
    shown = (values["photos"], values["proposals"], (values["body_points"], values["face_points"]))
    with beside(lambda: list(abreast(lambda write: write(), writers))):  # drawing stays on this thread, as GL wants it
        write_previews(clone, *shown, values["obeyed_silhouettes"], folder)


def _export(name: str, clone: Clone, folder: Path) -> None:
    EXPORTERS.get(name)(clone, folder)  # its module is loaded beside other work


def stamp_options(
    height_cm: float | None = None,
    formats: Sequence[str] = DEFAULT_FORMATS,
    seed: int = 0,
    texture_size: int = DEFAULT_TEXTURE_SIZE,
) -> dict[str, Any]:
    """Return the options of a clone as its stamp keeps them."""
    return {"height_cm": height_cm, "formats": sorted(formats), "seed": seed, "texture_size": texture_size}


def _files(folder: Path) -> list[str]:
    """Return every file below a folder, relative to it."""
    return [path.relative_to(folder).as_posix() for path in folder.rglob("*") if path.is_file()]
