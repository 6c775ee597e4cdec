"""Cloning and scoring of people of the generator: the usual rows, labels, parts and refusals."""

from __future__ import annotations

import logging
import tempfile
from collections.abc import Callable, Collection, Iterator, Sequence
from contextlib import ExitStack
from pathlib import Path
from typing import Final

import numpy as np
from numpy.typing import NDArray

from cloner.errors import Cancelled, ClonerError
from cloner.evaluate.figures import likeness, skins
from cloner.evaluate.figures.parts import wrong_part_share
from cloner.evaluate.figures.seams import seam_ratios
from cloner.evaluate.measures.posing import JOINTS, joints_by_truth_name, pose_clone
from cloner.evaluate.measuring import CloneRun, clone_in_process
from cloner.evaluate.rows import Row, rows_of, save_held_out
from cloner.evaluate.scores import Score, girth_scores, held_out_scores, landmark_scores, leak_scores, score_run
from cloner.evaluate.truths.baselines import generic_clone
from cloner.evaluate.truths.kit import KIT_SET, KitTruth, is_kit_person, photos_without_truth, read_kit
from cloner.evaluate.truths.labels import label_ious
from cloner.evaluate.truths.truth import THREE_QUARTER, given_height_m
from cloner.frames import BODY_VIEWS, ViewId, mm_from_m
from cloner.generic.load import GenericHuman, load_generic
from cloner.records.clones import Clone

log = logging.getLogger(__name__)

Pictures = dict[str, list[NDArray[np.uint8]]]
Report = Callable[[str], None]

_COLUMNS: Final = ("value", "generic", "other")


def evaluate_people(
    people: Sequence[Path],
    out: Path | None = None,
    *,
    shown: Collection[ViewId] = tuple(ViewId),
    progress: Callable[[str, float], None] = lambda what, fraction: None,
    report: Report = lambda sentence: None,
) -> list[Row]:
    """Clone people from their photos alone, then score them.

    Parameters
    ----------
    people : sequence of Path
        Folders of people of the generator.
    out : Path or None
        Receives the clones and the held-out pictures; None keeps nothing.
    shown : collection of ViewId
        Photos to clone from; the others are held out and scored as views that no photo shows.
    progress, report : callable
        Get what is done now and how far it is; get a sentence a refusal and a warning.

    Returns
    -------
    list of dict
        As :func:`cloner.evaluate.evaluate_visitors`; of a refused person the row ``cloned`` alone.
    """
    rows: list[Row] = []
    queue = [*people, *_neighbour_person(people)]
    with ExitStack() as kept:
        place = out or Path(kept.enter_context(tempfile.TemporaryDirectory(prefix="cloner-evaluate-")))
        first: CloneRun | None = None
        ahead: CloneRun | None = None
        for number, person in enumerate(people):
            progress(f"clone {person.name}", number / len(people))
            run = clone_person(person, place, report, shown) if number == 0 else ahead
            first = run if number == 0 else first
            after = number + 1
            ahead = clone_person(queue[after], place, report, shown) if after < len(queue) else first
            progress(f"score {person.name}", (number + 0.5) / len(people))
            rows += score_person(person, run, None if ahead is None else ahead.clone, out, shown)
    return rows


def _neighbour_person(people: Sequence[Path]) -> list[Path]:
    """Return a neighbour folder for one person alone, to compare with."""
    if len(people) != 1:
        return []
    place = people[0].resolve()
    return [near for near in sorted(place.parent.iterdir()) if near != place and is_kit_person(near)][:1]


def clone_person(person: Path, out: Path, report: Report, shown: Collection[ViewId] = tuple(ViewId)) -> CloneRun | None:
    """Return the clone of one person from the photos shown, None if there is none: refused, or a defect of ours."""
    with photos_without_truth(person, shown) as photos:
        try:
            run = clone_in_process(photos, given_height_m(person), out, labelled=True)
        except ClonerError as error:
            report(f"{person.name}: refused: {error}")
            return None
        except Cancelled:
            raise
        except Exception as error:  # one person's defect must not end a night's evaluation
            log.info("%s failed", person.name, exc_info=True)  # a trace is for --verbose
            report(
                f"{person.name}: not cloned: a defect of Cloner ({type(error).__name__}); report what --verbose says"
            )
            return None
    for warning in run.warnings:
        report(f"{person.name}: {warning}")
    return run


def score_person(
    person: Path,
    run: CloneRun | None,
    other: Clone | None,
    out: Path | None,
    shown: Collection[ViewId] = tuple(ViewId),
) -> list[Row]:
    """Return all rows of one person; the truth is first read here, the clone exists."""
    if run is None:
        return rows_of(person.name, KIT_SET, [Score("cloned", "", "", 0.0)], {})
    kit, generic, pictures = read_kit(person), load_generic(), Pictures()
    hidden = held_out_names(shown)
    subjects = dict(zip(_COLUMNS, (run.clone, generic_clone(generic, kit.truth.stature_m), other), strict=True))
    figures = {
        column: {
            (score.metric, score.view): score for score in subject_scores(subject, run, generic, kit, hidden, pictures)
        }
        for column, subject in subjects.items()
        if subject is not None
    }
    own = [
        Score("cloned", "", "", 1.0),
        *score_run(run, kit.truth),
        *label_scores(run, kit),
        *_part_scores(run, generic, kit),
        *figures["value"].values(),
        *_texture_scores(run, generic, kit),
    ]
    if out is not None:
        save_held_out(out / person.name, kit.truth, pictures)
    return rows_of(person.name, KIT_SET, own, figures)


def held_out_names(shown: Collection[ViewId]) -> list[str]:
    """Return the views that are scored as no clone saw them: always those from 45 degrees, and photos kept back."""
    return [*THREE_QUARTER, *(view for view in ViewId if view not in shown)]


def label_scores(run: CloneRun, kit: KitTruth) -> Iterator[Score]:
    """Yield the overlap of the product's labels with the true ones, one score a photo and label."""
    for view, found in run.labels.items():
        for name, iou in label_ious(found, kit.labels[view]).items():
            yield Score("label_iou", f"{view}/{name}", "", iou)


def _part_scores(run: CloneRun, generic: GenericHuman, kit: KitTruth) -> Iterator[Score]:
    if run.origins is not None:
        share = wrong_part_share(run.origins, generic, kit)
        yield Score("wrong_part_texels", "", "%", None if share is None else 100.0 * share)


def subject_scores(
    subject: Clone,
    run: CloneRun,
    generic: GenericHuman,
    kit: KitTruth,
    hidden: Sequence[str],
    pictures: Pictures,
) -> Iterator[Score]:
    """Yield the figures that a clone and both baselines have."""
    clone, truth = run.clone, kit.truth
    front = clone.views.get(ViewId.BODY_FRONT)
    rotations = np.zeros((len(clone.joints_m), 3)) if front is None else front.rotations
    for view in BODY_VIEWS:
        if view in clone.views and view in truth.views:
            overlap = likeness.seen_as_photo(subject, clone, generic, view, truth.views[view].mask)
            yield Score("silhouette_iou", view.value, "", overlap)
            if subject is clone:
                yield Score("joints_mean_mm", view.value, "mm", joint_error_mm(clone, generic, kit, view))
    held_out = {name: truth.views[name] for name in hidden if name in truth.views}
    yield from held_out_scores(
        subject, generic, held_out, rotations, lambda name, picture: pictures.setdefault(name, []).append(picture)
    )
    posed = pose_clone(subject, generic, np.zeros_like(rotations))
    face = skins.face_surface_mm(posed, generic, truth.surface, rng=np.random.default_rng(0))
    yield Score("face_surface_similarity_mm", "", "mm", face.similarity.mean)
    yield Score("face_surface_rigid_mm", "", "mm", face.rigid.mean)
    yield from landmark_scores(posed, truth)
    yield from girth_scores(subject, run.measures if subject is clone else None, truth)


def joint_error_mm(clone: Clone, generic: GenericHuman, kit: KitTruth, view: ViewId) -> float:
    """Return how far the joints of the fitted pose lie from the true ones in a photo, mean, mm at the joints' depth."""
    seen, truth = clone.views[view], kit.truth.views[view.value]
    found = joints_by_truth_name(pose_clone(clone, generic, seen.rotations), generic)
    true = np.array([truth.joints_m[name] for name in JOINTS])
    away = seen.camera.project(np.array([found[name] for name in JOINTS])) - truth.camera.project(true)
    return mm_from_m(float(np.linalg.norm(away, axis=1).mean()) * truth.camera.metres_per_pixel(true.mean(axis=0)))


def _texture_scores(run: CloneRun, generic: GenericHuman, kit: KitTruth) -> Iterator[Score]:
    """Yield what only a clone's own texture can be asked."""
    clone, views = run.clone, kit.truth.views
    photos = {view: views[view].photo for view in clone.views if view in views}
    for where, ratio in seam_ratios(clone, generic, photos).items():
        yield Score(f"seam_{where}_ratio", "", "", ratio)
    yield from leak_scores(clone, generic, kit.truth)
