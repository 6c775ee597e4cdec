"""Cloning of a visitor from the photos alone in a process of its own, with time and memory."""

from __future__ import annotations

import multiprocessing
import time
from collections.abc import Mapping
from concurrent.futures import ProcessPoolExecutor
from dataclasses import dataclass, field
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from cloner.cloning import clone_folder
from cloner.evaluate.figures.origins import TexelOrigins, texel_origins
from cloner.evaluate.floor import ask_nets, encode_pictures
from cloner.evaluate.truths.labels import photo_labels
from cloner.memory import peak_mib
from cloner.project.folder import load_photos
from cloner.records.clones import Clone
from cloner.records.measures import MeasureSet
from cloner.records.points import PointSet
from cloner.records.silhouettes import SilhouetteSet


@dataclass(frozen=True, slots=True, eq=False)
class CloneRun:
    """A clone, with its time and memory.

    Attributes
    ----------
    clone : Clone
    outlines : mapping of view name to (H, W) bool
        Silhouettes extracted from the photos.
    face_points : PointSet
        The points used for the face; without corrections they are the proposals.
    seconds, cpu_seconds : float
        Whole clone as ``cloner clone`` does it: decoding, all stages, exports, previews and report.
    floor_seconds : float
        Decoding the photos, running the nets once and encoding the texture.
    peak_mib : float
        Peak resident memory of the process.
    measures : MeasureSet or None
        What the clone says of the body under the clothes.
    labels : mapping of view name to (H, W) uint8
        What the product takes every pixel for, places in `LABELS`; empty where nobody asked.
    origins : Origins or None
        Where the clone's texels came from; None where nobody asked.
    warnings : tuple of str
        What the operator is told.
    """

    clone: Clone
    outlines: Mapping[str, NDArray[np.bool_]]
    face_points: PointSet
    seconds: float
    cpu_seconds: float
    floor_seconds: float
    peak_mib: float
    measures: MeasureSet | None = None
    labels: Mapping[str, NDArray[np.uint8]] = field(default_factory=dict)
    origins: TexelOrigins | None = None
    warnings: tuple[str, ...] = ()


def clone_in_process(photos: Path, stature_m: float, out: Path, *, labelled: bool = False) -> CloneRun:
    """Clone the photos of a folder in a new process.

    Parameters
    ----------
    photos : Path
        Holds the photographs and nothing that is true of the visitor.
    stature_m : float
        The height that the visitor told, metres.
    out : Path
        Receives the clone's folder, as ``cloner clone`` writes it.
    labelled : bool
        Whether labels and texels' origins are wanted, which takes some seconds more after the clone is measured.

    Raises
    ------
    ClonerError
        As the stages do.
    """
    context = multiprocessing.get_context("spawn")
    with ProcessPoolExecutor(max_workers=1, mp_context=context) as pool:
        return pool.submit(clone_here, photos, stature_m, out, labelled=labelled).result()


def clone_here(photos: Path, stature_m: float, out: Path, *, labelled: bool = False) -> CloneRun:
    """Clone the photos of a folder in this process; see :func:`clone_in_process`."""
    wall, cpu = time.perf_counter(), time.process_time()
    outcome = clone_folder(photos, out, height_cm=100.0 * stature_m)
    seconds, cpu_seconds, peak = time.perf_counter() - wall, time.process_time() - cpu, peak_mib()
    clone: Clone = outcome.values["clone"]
    before = time.perf_counter()
    ask_nets(load_photos(photos))
    encode_pictures(clone, outcome.folder)
    floor = time.perf_counter() - before
    labels = photo_labels(outcome.values["photos"], outcome.values["proposals"]) if labelled else {}
    silhouettes: SilhouetteSet = outcome.values["obeyed_silhouettes"]
    return CloneRun(
        clone=clone,
        outlines={view.value: silhouette.mask for view, silhouette in silhouettes.views.items()},
        face_points=outcome.values["face_points"],
        seconds=seconds,
        cpu_seconds=cpu_seconds,
        floor_seconds=floor,
        peak_mib=peak,
        measures=outcome.values["measures"],
        labels={view.value: picture for view, picture in labels.items()},
        origins=texel_origins(outcome.values) if labelled else None,
        warnings=outcome.warnings,
    )
