"""From a folder of photos to a folder of results: the one function behind command line, batch and window."""

from __future__ import annotations

import logging
import time
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace
from functools import partial
from pathlib import Path
from typing import Any, Final

from cloner import pipeline
from cloner.errors import ClonerError
from cloner.exporters.table import EXPORTERS, check_formats
from cloner.interactive.refitting import reusable_values
from cloner.making import DEFAULT_TEXTURE_SIZE, check_texture_size, clone_photos
from cloner.memory import check_address_limit, peak_mib, use_one_heap
from cloner.parallel import in_background, parallel_map
from cloner.pipeline import Progress, no_progress
from cloner.previews import write_previews
from cloner.project.atomic import result_folder
from cloner.project.clone_file import CLONE_FILE, save_clone
from cloner.project.corrections import check_against, point_names
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
from cloner.project.stamps import beside_digests, output_digests, stamp_of
from cloner.records.clones import Clone
from cloner.records.photos import Person
from cloner.records.points import Corrections
from cloner.records.terms import Terms
from cloner.report.build import Run, build_report, warnings_of
from cloner.report.derived import GLB_FILE
from cloner.report.viewer import write_viewer
from cloner.report.write import write_page, write_report

log = logging.getLogger(__name__)

DEFAULT_FORMATS: Final = ("glb", "wrl")
PIPELINE_SHARE: Final = 0.85  # measured on the samples: the stages' part of the whole time


@dataclass(frozen=True, slots=True, eq=False)
class CloneOutcome:
    """The result of a finished clone.

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


def clone_folder(
    photos_dir: Path,
    out_dir: Path,
    *,
    height_cm: float | None = None,
    formats: Sequence[str] = DEFAULT_FORMATS,
    seed: int = 0,
    identifier: str | None = None,
    texture_size: int = DEFAULT_TEXTURE_SIZE,
    progress: Progress = no_progress,
    found: pipeline.Found = pipeline.ignore_values,
    known: Mapping[str, object] | None = None,
) -> CloneOutcome:
    """Clone the person in a folder of photos; the result appears completely or not at all.

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
        Side of the texture atlas, texels; one of `cloner.making.TEXTURE_SIZES`.
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
    check_address_limit()
    use_one_heap()
    check_formats(formats)
    check_texture_size(texture_size)
    progress("photos", 0.0)
    given = _read_side_files(photos_dir, height_cm, identifier)
    options = stamp_options(height_cm, formats, seed, texture_size)
    work = _Work(photos_dir, tuple(formats), options, begun, progress, found)
    with result_folder(out_dir, given.person.identifier, photos_dir) as folder:
        report, values = work.into(folder, given, known or {})
    progress("done", 1.0)
    return CloneOutcome(given.person.identifier, out_dir / given.person.identifier, report, values)


@dataclass(frozen=True, slots=True)
class _SideFiles:
    """The contents of the files beside the photos, and the sha256 of those that count, by name."""

    person: Person
    corrections: Corrections
    consent: bool
    terms: Terms
    digests: Mapping[str, str]


def _read_side_files(photos_dir: Path, height_cm: float | None, identifier: str | None) -> _SideFiles:
    """Read what lies beside the photos; refuse files that change meanwhile."""
    digests = beside_digests(photos_dir)
    person, corrections = read_person(photos_dir, height_cm, identifier), read_corrections(photos_dir)
    given = _SideFiles(person, corrections, bool(read_consent(photos_dir)), read_terms(photos_dir), digests)
    if beside_digests(photos_dir) != digests:
        raise ClonerError("its files were changed while they were read", "Clone again", photos_dir.name)
    return given


@dataclass(frozen=True, slots=True)
class _Work:
    """One clone in progress: its options, start time and listeners."""

    photos_dir: Path
    formats: tuple[str, ...]
    options: Mapping[str, Any]
    begun: tuple[float, float]
    progress: Progress
    found: pipeline.Found

    def into(
        self, folder: Path, given: _SideFiles, known: Mapping[str, object]
    ) -> tuple[dict[str, Any], dict[str, Any]]:
        """Clone into a folder; return the report and all values of the pipeline."""
        photos = load_photos(self.photos_dir)
        person, corrections = given.person, given.corrections
        warnings = *person_warnings(person), *photo_warnings(photos), *check_against(corrections, photos, point_names())
        seed = self.options["seed"]
        values, stages = clone_photos(
            photos,
            person,
            corrections,
            seed=seed,
            texture_size=self.options["texture_size"],
            found=self.found,
            known=reusable_values(known, photos, person, corrections),
            progress=lambda step, share: self.progress("export" if step == "done" else step, PIPELINE_SHARE * share),
        )
        values["clone"] = clone = replace(
            values["clone"], consent=given.consent, terms=given.terms, sex=person.sex, age_years=person.age_years
        )
        _write_clone(values, self.formats, folder, self.progress)
        wall, cpu = time.perf_counter() - self.begun[0], time.process_time() - self.begun[1]
        run = Run(wall, cpu, peak_mib(), tuple(stages), seed, self.formats, warnings)
        self.progress("report", 0.97)
        digests = {str(view): photo.digest for view, photo in photos.photos.items()}
        report = build_report(values, run, values["agreements"], sorted({*_files(folder), RESULT_MARK})) | {
            "made_by": clone.stamp,
            "stamp": stamp_of(digests, given.digests, self.options),
            "source": place_digest(self.photos_dir),
        }
        write_page(report, folder)
        report |= {"outputs": output_digests(folder, _files(folder))}
        write_report(report, folder)
        log.info("%s: %.1f s, %d warnings", person.identifier, run.seconds, len(warnings_of(run)))
        return report, values


def _write_clone(values: Mapping[str, Any], formats: Sequence[str], folder: Path, progress: Progress) -> None:
    """Write the clone's own file, the exports, the previews and the viewer."""
    clone, person = values["clone"], values["person"]
    keep = partial(save_clone, clone, folder / CLONE_FILE)
    writers = (keep, *(partial(_export, name, clone, folder) for name in formats))
    progress("previews", 0.9)
    shown = (values["photos"], values["proposals"], (values["body_points"], values["face_points"]))
    with in_background(
        lambda: list(parallel_map(lambda write: write(), writers))
    ):  # drawing stays on this thread, as GL wants
        write_previews(clone, *shown, values["obeyed_silhouettes"], folder)
    if (folder / GLB_FILE).is_file():
        write_viewer(f"Clone of {person.name or person.identifier}", folder / GLB_FILE)


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
