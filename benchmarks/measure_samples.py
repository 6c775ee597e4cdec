"""Known people for the calibration of measures: random bodies, and dressed people beside their clones.

``python benchmarks/measure_samples.py bodies OUT --people 250`` measures random bodies of the generic family;
``python benchmarks/measure_samples.py painted OUT --people 40`` clones painted people in tight clothes;
``python benchmarks/measure_samples.py people OUT --photos KIT`` clones people of the generator of labelled people
(``make_people.py``; any clothes, any light) as far as measures need and keeps what the clones measure beside what is
true (some 10 CPU seconds each). Interrupted runs go on where they stopped. Their seeds must be apart from those of any
benchmark that judges (5000 to 5999, 9000 to 9999).
"""

from __future__ import annotations

import argparse
import json
import sys
from collections.abc import Callable, Mapping
from functools import partial
from pathlib import Path
from typing import Any

import numpy as np
from scipy.spatial import cKDTree

sys.path.insert(0, str(Path(__file__).resolve().parents[1] / "generic_models" / "build"))

from body_truth import photograph
from painted_people_bodies import random_body
from painted_people_pictures import BACKGROUNDS

from cloner.body.outlined import outlined_photos
from cloner.errors import ClonerError
from cloner.evaluate.measures.rulers import fit_similarity, transform_points
from cloner.evaluate.truths.kit import kit_people
from cloner.generic.load import load_generic
from cloner.generic.tape import load_tape_rules
from cloner.geometry.measurement.measuring import measures_mm
from cloner.measure.gathered import gather_measures
from cloner.project.folder import read_corrections
from cloner.records.measures import Cover
from cloner.testing import first_values, folder_values, run_stages, up_to

#: First seeds of the bodies without photos, and of painted people.
BODY_SEED, PAINTED_SEED = 710_000, 720_000
#: The stages up to the obeyed person; hair and textures measure nothing.
LAST_STAGE = "obeyed"
#: Skin vertices that carry a joint along with a posed body.
CARRIERS = 120


def vector(vertices_m: np.ndarray, joints_m: np.ndarray, floor_m: float = 0.0) -> np.ndarray:
    """Return every measure and slice of a rest-pose body, mm."""
    return np.array(list(measures_mm(vertices_m, joints_m, load_tape_rules(), floor_m).values()))


def body(seed: int) -> dict[str, Any]:
    """Return the shape and the measures of one random body."""
    found = random_body(load_generic(), np.random.default_rng([seed, 0]))
    naked = vector(found.vertices_m, found.joints_m)
    return {"coefficients": found.coefficients, "stature_m": found.stature_m, "naked": naked}


def naked_mm(person: Path) -> np.ndarray:
    """Return every measure of a generated person's naked body, mm: in the front photo's pose, a few mm from rest."""
    generic = load_generic()
    with np.load(person / "truth_body.npz") as held:
        posed = held["vertices_body_front"].astype(np.float64)
    whole = np.array(generic.vertices_m, np.float64)
    whole[: len(posed)] = posed
    tree, joints = cKDTree(generic.vertices_m[: len(posed)]), np.array(generic.joints_m, np.float64)
    for row, joint in enumerate(joints):
        near = tree.query(joint, CARRIERS)[1]
        joints[row] = transform_points(fit_similarity(generic.vertices_m[near], posed[near], scale=True), joint[None])[
            0
        ]
    return vector(whole, joints)


def cloned(values: Mapping[str, Any]) -> dict[str, Any]:
    """Return what a clone of one photographed person measures."""
    found, _ = run_stages(values, up_to(LAST_STAGE))
    photos = outlined_photos(found["phenotype"], found["obeyed_silhouettes"], found["proposals"], found["body"].views)
    told = gather_measures(found["obeyed"], found["body"].mesh, photos, found["obeyed_silhouettes"], found["proposals"])
    return {
        "shown": np.array(list(told.shown_mm.values())),
        "under": told.under_mm,
        "rumple": told.rumple_mm,
        "hidden": told.hidden,
        "around_legs": told.around_legs,
        "gap_mm": told.gap_mm,
    } | {f"cover_{name}": flags(own) for name, own in told.cover.items()}


def generated(person: Path) -> dict[str, Any]:
    """Return what a clone of a person of the generator measures, and what is true of the person."""
    truth = json.loads((person / "truth.json").read_text())
    own = {"stature_m": float(truth["stature_mm"]) / 1e3, "naked": naked_mm(person)}
    return own | cloned(folder_values(person, read_corrections(person)))


def painted(seed: int) -> dict[str, Any]:
    """Return what a clone of a painted person in tight clothes measures, and what is true of the person."""
    known = photograph(seed, "tight", BACKGROUNDS[seed % len(BACKGROUNDS)])
    own = {"stature_m": known.person.stature_m, "naked": vector(known.body.vertices_m, known.body.joints_m)}
    return own | cloned(first_values(known.photos, known.person))


def flags(cover: Cover) -> np.ndarray:
    """Return the slices of a cover as numbers: 1 cloth, 0 bare, -1 not seen."""
    return np.array([-1 if slice_ is None else int(slice_) for slice_ in cover.covered])


def keep(path: Path, sample: Mapping[str, Any]) -> None:
    np.savez_compressed(path, **sample)
    print(path.name, flush=True)


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("what", choices=("bodies", "painted", "people"))
    parser.add_argument("out", type=Path)
    parser.add_argument("--people", type=int, default=250, help="how many bodies or painted people")
    parser.add_argument("--photos", type=Path, help="the generated people")
    chosen = parser.parse_args()
    folder = chosen.out / chosen.what
    folder.mkdir(parents=True, exist_ok=True)
    making: dict[str, Callable[[], dict[str, Any]]]
    if chosen.what == "people":
        making = {person.name: partial(generated, person) for person in kit_people([chosen.photos])}
    else:
        make, first = {"bodies": (body, BODY_SEED), "painted": (painted, PAINTED_SEED)}[chosen.what]
        making = {str(seed): partial(make, seed) for seed in range(first, first + chosen.people)}
    for name, sample in making.items():
        if not (folder / f"{name}.npz").exists():
            try:
                keep(folder / f"{name}.npz", sample())
            except ClonerError as error:  # the product refuses a photo now and then, and says so: no measures then
                print(f"{name}: {error}", flush=True)


if __name__ == "__main__":
    main()
