"""Known people for the calibration of measures: what clothes add, and how the fit errs.

``python benchmarks/measure_samples.py ease OUT --people 250`` dresses random bodies in three dimensions, without a
photo (one CPU second each); ``python benchmarks/measure_samples.py fits OUT --people 60`` photographs random people,
clones their bodies and keeps what the clones measure beside what is true (half a CPU minute each). Interrupted runs
go on where they stopped. The seeds are apart from those of every benchmark that judges.
"""

from __future__ import annotations

import argparse
import sys
from collections.abc import Iterator, Mapping
from pathlib import Path
from typing import Any

import numpy as np

sys.path.insert(0, str(Path(__file__).resolve().parents[1] / "generic_models" / "build"))

from painted_people import photograph_person
from painted_people_bodies import random_body
from painted_people_clothes import CLOTH, TIGHTNESSES, dress, random_wardrobe
from painted_people_pictures import BACKGROUNDS

from cloner import pipeline
from cloner.errors import ClonerError
from cloner.generic.load import load_generic
from cloner.generic.tape import load_tape_rules
from cloner.geometry.measuring import measures_mm
from cloner.project.corrections import no_corrections
from cloner.records.measures import Cover
from cloner.stages.covering import covers
from cloner.stages.outlined import outlined_photos, see
from cloner.stages.rumpled import garments_rumples_mm
from cloner.stages.side_arms import hidden_rows

#: First seeds: dressed bodies without photos, photographed people to calibrate on, and people to check the result on.
#: People 750000 to 750029 checked an earlier table and went into the next one.
EASE_SEED, FIT_SEED, CHECK_SEED = 710_000, 740_000, 760_000
#: The stages up to the joined person; hair and textures measure nothing.
LAST_STAGE = "join"


def vector(vertices_m: np.ndarray, joints_m: np.ndarray, floor_m: float = 0.0) -> np.ndarray:
    """Return every measure and slice of a rest-pose body, mm."""
    return np.array(list(measures_mm(vertices_m, joints_m, load_tape_rules(), floor_m).values()))


def eased(seed: int) -> dict[str, Any]:
    """Return the measures of one body naked and in clothes of every tightness."""
    generic = load_generic()
    body = random_body(generic, np.random.default_rng([seed, 0]))
    worn = []
    for place, tightness in enumerate(TIGHTNESSES):
        rng = np.random.default_rng([seed, 1, place])
        wardrobe = random_wardrobe(tightness, rng)
        long = type(wardrobe)(**{**{n: getattr(wardrobe, n) for n in wardrobe.__slots__}, "sleeve": 0.97, "leg": 0.97})
        dressed = dress(body, long, rng, splits=0)
        worn.append(vector(dressed.vertices_m[: len(body.vertices_m)], body.joints_m))
    return {
        "coefficients": body.coefficients,
        "stature_m": body.stature_m,
        "sex": body.phenotype["sex"],
        "naked": vector(body.vertices_m, body.joints_m),
        "worn": np.array(worn),
    }


def fitted(seed: int, number: int) -> dict[str, Any]:
    """Return what a clone of one photographed person measures, and what is true of the person."""
    tightness = TIGHTNESSES[number % 3]
    known = photograph_person(seed, tightness=tightness, background=BACKGROUNDS[(number // 3) % 3])
    values = {"photos": known.photos, "person": known.person, "corrections": no_corrections()}
    names = [stage.name for stage in pipeline.STAGES]
    found, reports = pipeline.run(values, stages=pipeline.STAGES[: names.index(LAST_STAGE) + 1])
    fine = next(report for report in reports if report.name == "fine")
    joined = found["joined"]
    cover = covers(found["proposals"], joined)
    dressed_m = known.dressed.vertices_m[: len(known.body.vertices_m)]
    return {
        "seed": seed,
        "tightness": TIGHTNESSES.index(tightness),
        "background": known.background,
        "stature_m": known.body.stature_m,
        "sex": known.body.phenotype["sex"],
        "shown": vector(joined.vertices_m, joined.joints_m, joined.sole_m),
        "dressed": vector(dressed_m, known.body.joints_m),
        "naked": vector(known.body.vertices_m, known.body.joints_m),
        "cloth": known.dressed.kind[: len(dressed_m)] == CLOTH,
        **evidence(found, cover),
        "gap_mm": [residual.value for residual in fine.residuals if residual.name == "outline gap"],
    } | {f"cover_{name}": flags(own) for name, own in cover.items()}


def evidence(found: Mapping[str, Any], cover: Mapping[str, Cover]) -> dict[str, np.ndarray]:
    """Return how rumpled the outline is above and below the waist, and where an arm hides the trunk's depth."""
    bodies = found["bodies"]
    photos = outlined_photos(found["phenotype"], found["silhouettes"], found["proposals"], bodies.views)
    seen = {view: see(bodies.consensus, photo) for view, photo in photos.items()}
    rumple = garments_rumples_mm(seen, photos, found["silhouettes"], cover)
    return {"rumple": rumple, "hidden": hidden_rows(bodies.consensus.vertices_m, seen)}


def flags(cover: Cover) -> np.ndarray:
    """Return the slices of a cover as numbers: 1 cloth, 0 bare, -1 not seen."""
    return np.array([-1 if slice_ is None else int(slice_) for slice_ in cover.covered])


def stored(folder: Path, seeds: range) -> Iterator[tuple[int, int, Path]]:
    """Yield number, seed and file of the samples that are not there yet."""
    folder.mkdir(parents=True, exist_ok=True)
    for number, seed in enumerate(seeds):
        path = folder / f"{seed}.npz"
        if not path.exists():
            yield number, seed, path


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("what", choices=("ease", "fits", "checks"))
    parser.add_argument("out", type=Path)
    parser.add_argument("--people", type=int, default=60)
    chosen = parser.parse_args()
    first = {"ease": EASE_SEED, "fits": FIT_SEED, "checks": CHECK_SEED}[chosen.what]
    for number, seed, path in stored(chosen.out / chosen.what, range(first, first + chosen.people)):
        try:
            sample = eased(seed) if chosen.what == "ease" else fitted(seed, number)
        except ClonerError as error:  # the product refuses a photo now and then, and says so: no measures then
            print(f"{seed}: {error}", flush=True)
            continue
        np.savez_compressed(path, **sample)
        print(path.name, flush=True)


if __name__ == "__main__":
    main()
