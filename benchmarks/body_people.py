"""Clone one known person with the product's own stages and score every step; one JSON a person."""

from __future__ import annotations

import functools
import json
import os
import subprocess
import time
from collections.abc import Mapping
from dataclasses import dataclass
from pathlib import Path
from typing import Any, Final

import numpy as np
from body_scores import (
    KnownTruth,
    Values,
    body_clone,
    laid_on,
    score_measures,
    score_outlines,
    score_points,
    score_step,
    stature_error_mm,
)

from cloner.errors import ClonerError
from cloner.generic.load import GenericHuman, load_generic
from cloner.records.clones import Clone
from cloner.records.photos import Person, PhotoSet
from cloner.stages.rough import follow_joints
from cloner.testing import STAGE_NAMES, first_values, run_stages, untextured

#: All stages but those of the texture, which no ruler of the body sees.
ALL_STAGES: Final = tuple(name for name in STAGE_NAMES if name not in ("textures", "regions"))


@dataclass(frozen=True, slots=True)
class Case:
    """One person of the benchmark: a seed, what he wears and where he stands."""

    seed: int
    tightness: str
    background: str

    @property
    def name(self) -> str:
        """A name for files and tables."""
        return f"{self.seed:03d}_{self.tightness}_{self.background}"


def cases(count: int, first: int) -> list[Case]:
    """Return people with every tightness before every background equally often."""
    tightness, backgrounds = ("tight", "regular", "loose"), ("plain", "cluttered", "low_contrast")
    return [Case(first + k, tightness[k % 3], backgrounds[(k // 3 + k) % 3]) for k in range(count)]


def step_clones(values: Values, generic: GenericHuman) -> dict[str, Clone]:
    """Return the body after every step, each with the poses and cameras that the fit found."""
    phenotype = values["phenotype"]
    stature, sole, views = phenotype.stature_m, phenotype.sole_m, phenotype.views
    vertices, joints = generic.shape(phenotype.coefficients, stature)
    skeleton = values["skeletons"].consensus.joints_m
    meshes = {
        "phenotype": (vertices, joints),
        "skeleton": (follow_joints(vertices, joints, skeleton), skeleton),
        "rough": (values["rough_bodies"].consensus.vertices_m, values["rough_bodies"].consensus.joints_m),
        "fine": (values["body"].mesh.vertices_m, values["body"].mesh.joints_m),
    }
    made = {name: body_clone(generic, *mesh, views, stature, sole) for name, mesh in meshes.items()}
    mean = body_clone(generic, *generic.shape(np.zeros(0), stature), views, stature, sole)
    return {"generic": laid_on(mean, made["phenotype"], generic), **made}


def finished_clone(values: Values) -> Clone:
    """Return the clone with head and hair, not textured."""
    return untextured(values["joined"], values["shells"])


def score_clone(values: Values, seconds: Mapping[str, Any], truth: KnownTruth, tightness: str) -> dict[str, Any]:
    """Return every figure of one clone; ``values`` are those of all stages but the textures."""
    generic = load_generic()
    clones = step_clones(values, generic) | {"finished": finished_clone(values)}
    return {
        "steps": {name: score_step(clone, generic, truth) for name, clone in clones.items()},
        "outlines": score_outlines(values, truth),
        "points": score_points(values["body_points"], truth),
        "measures": score_measures(values["measures"], truth, tightness),
        "stature_m": truth.stature_m,
        "stature_error_mm": stature_error_mm(clones["finished"], generic, truth),
        "sole_mm": 1e3 * clones["finished"].sole_m,
        "seconds": seconds,
    }


def score_photos(photos: PhotoSet, person: Person, truth: KnownTruth, tightness: str) -> tuple[dict[str, Any], Values]:
    """Return the figures of one person and the values of the stages; a refused photo gives ``error`` alone."""
    try:
        values, reports = run_stages(first_values(photos, person), ALL_STAGES)
    except ClonerError as error:
        return {"error": f"{error.message} ({error.where})"}, {}
    seconds = {report.name: {"s": report.seconds, "cpu_s": report.cpu_seconds} for report in reports}
    return score_clone(values, seconds, truth, tightness), values


@functools.cache
def commit() -> str:
    """Return which version of the product is scored: the checkout's, or the one an exported copy was told."""
    told = os.environ.get("CLONER_COMMIT", "")
    if told:
        return told
    command = ["git", "-C", str(Path(__file__).resolve().parent), "rev-parse", "--short", "HEAD"]
    return subprocess.run(command, capture_output=True, text=True, check=False).stdout.strip()


def write_json(path: Path, value: Mapping[str, Any]) -> None:
    """Write a JSON file whole or not at all."""
    path.parent.mkdir(parents=True, exist_ok=True)
    partial = path.with_name(f".{path.name}.{os.getpid()}")
    partial.write_text(json.dumps(value, indent=1, default=float))
    os.replace(partial, path)


def painted_case(case: Case, folder: Path) -> dict[str, Any]:
    """Photograph, clone and score one random person; writes his JSON and pictures, and returns the JSON."""
    from body_pictures import write_person  # here: drawing is wanted by the process that has the person
    from body_truth import known_truth, photograph

    start = time.perf_counter()
    known = photograph(case.seed, case.tightness, case.background)
    truth = known_truth(known)
    found, values = score_photos(known.photos, known.person, truth, case.tightness)
    row = {
        "name": case.name, "seed": case.seed, "tightness": case.tightness, "background": case.background,
        "exif": known.exif, "side": known.side, "hair": known.dressed.wardrobe.hair,
        "ease_mm": [1e3 * known.dressed.wardrobe.shirt_m, 1e3 * known.dressed.wardrobe.trousers_m],
        "phenotype": dict(known.body.phenotype), "commit": commit(), **found,
    }  # fmt: skip
    if values:
        write_person(folder / f"{case.name}.png", row, known, finished_clone(values))
    row["wall_s"] = time.perf_counter() - start
    write_json(folder / f"{case.name}.json", row)
    return row
