"""How well faces move: lids, lips, teeth, ears and skull of random heads and of finished clones, target by target.

    python benchmarks/face_motion.py [RESULT …] [--heads 10] [--page docs/face_motion.md]

RESULT is a folder that `cloner clone` made, or its clone.npz. Random heads are those of the head benchmark, every
second one bent out of the generic's family, seated and given their targets by the product's own steps, without photos.
"""

from __future__ import annotations

import argparse
from collections.abc import Iterator, Mapping
from dataclasses import replace
from pathlib import Path
from typing import Final

import numpy as np
from head_people import random_face

from cloner.evaluate.measures.face_motion import FaceFigures, face_figures, mixture_figures, target_figures
from cloner.evaluate.truths.baselines import generic_clone
from cloner.generic.load import load_generic
from cloner.head.parts import place_eyes_and_mouth
from cloner.head.targets import face_targets
from cloner.motion.face.limits import limited
from cloner.picture import load_clone_at
from cloner.records.clones import Clone

#: Faces of several targets; they are played as the product plays them, held back by `limited`.
TOGETHER: Final[Mapping[str, Mapping[str, float]]] = {
    "jawOpen + mouthClose": {"jawOpen": 1.0, "mouthClose": 1.0},
    "blink looking down": {"eyeBlinkLeft": 1.0, "eyeBlinkRight": 1.0, "eyeLookDownLeft": 1.0, "eyeLookDownRight": 1.0},
    "blink, eyes wide": {"eyeBlinkLeft": 1.0, "eyeBlinkRight": 1.0, "eyeWideLeft": 1.0, "eyeWideRight": 1.0},
    "all at once": {"jawOpen": 1.0, "viseme_aa": 1.0, "mouthSmileLeft": 1.0, "mouthSmileRight": 1.0,
                    "eyeBlinkLeft": 1.0, "eyeBlinkRight": 1.0, "eyeSquintLeft": 1.0, "eyeSquintRight": 1.0},
    "tongue, jaw open": {"tongueOut": 1.0, "jawOpen": 1.0},
    "tongue, lips pressed": {"tongueOut": 1.0, "viseme_PP": 1.0},
    "tongue, mouth closed": {"tongueOut": 1.0, "jawOpen": 1.0, "mouthClose": 1.0},
    "tongue, smile": {"tongueOut": 1.0, "mouthSmileLeft": 1.0, "mouthSmileRight": 1.0},
    "tongue, O": {"tongueOut": 1.0, "viseme_O": 1.0},
}  # fmt: skip
COLUMNS: Final = tuple(FaceFigures.__slots__)
PEOPLE: Final = ("person", "lips at rest", "lids in blink", "eye through a lid, any target", "lips in PP",
                 "jawOpen + mouthClose", "lips in jawOpen", "upper teeth shown in jawOpen", "teeth through skin, any",
                 "tongue through a lip, any", "ears moved, any", "skull moved, any")  # fmt: skip
TARGETS: Final = ("target", "lids left", "lids right", "eye through", "lips", "teeth through", "tongue through",
                  "teeth shown", "ears", "skull")  # fmt: skip


def random_head(seed: int) -> Clone:
    """Return a random head as the head stage seats it, with its own targets."""
    generic = load_generic()
    person, stature_m = random_face(generic, np.random.default_rng(seed), bent=bool(seed % 2))
    plain = generic_clone(generic, stature_m)
    rest = place_eyes_and_mouth(plain.vertices_m, person, None)
    names, index, delta, start = face_targets(rest)
    return replace(plain, vertices_m=rest, morph_names=names, morph_index=index, morph_delta_m=delta, morph_start=start)


def subjects(results: list[Path], heads: int) -> Iterator[tuple[str, Clone]]:
    """Yield the clones and the random heads, with their names."""
    for path in results:
        yield path.name, load_clone_at(path)
    for seed in range(heads):
        yield f"random {seed}", random_head(seed)


def measured(clone: Clone) -> dict[str, FaceFigures]:
    """Return the figures at rest, of every target, and of several together."""
    out = {"rest": face_figures(clone.vertices_m, clone.vertices_m)} | target_figures(clone)
    for name, weights in TOGETHER.items():
        held = limited(clone, {target: np.array([weight]) for target, weight in weights.items()})
        out[name] = mixture_figures(clone, {target: float(values[0]) for target, values in held.items()})
    return out


def worst(every: Mapping[str, FaceFigures], field: str) -> float:
    """Return the largest figure of one face over all its targets."""
    return max(getattr(one, field) for one in every.values())


def person_line(name: str, every: Mapping[str, FaceFigures]) -> str:
    """Return one row of the table of people."""
    cells = (
        every["rest"].lip_gap, max(every["eyeBlinkLeft"].lid_gap_left, every["eyeBlinkRight"].lid_gap_right),
        max(worst(every, "eye_through"), 0.0), every["viseme_PP"].lip_gap, every["jawOpen + mouthClose"].lip_gap,
        every["jawOpen"].lip_gap, every["jawOpen"].teeth_shown, worst(every, "teeth_through"),
        worst(every, "tongue_through"), worst(every, "ears"), worst(every, "skull"),
    )  # fmt: skip
    return f"| {name} | " + " | ".join(f"{value:.2f}" for value in cells) + " |"


def head(names: tuple[str, ...]) -> tuple[str, str]:
    """Return the two first lines of a Markdown table."""
    return "| " + " | ".join(names) + " |", "| --- " * len(names) + "|"


def page(found: Mapping[str, Mapping[str, FaceFigures]], command: str) -> str:
    """Return the tables as Markdown."""
    lines = ["# How faces move", "", f"`{command}`. All figures in mm; what goes through skin is the worst at a",
             "quarter, half, three quarters and all of a target.", "", "## People", "", *head(PEOPLE)]  # fmt: skip
    lines += [person_line(name, every) for name, every in found.items()]
    lines += ["", "## Targets, the worst of all people", "", *head(TARGETS)]
    for target in next(iter(found.values())):
        cells = [max(getattr(every[target], field) for every in found.values()) for field in COLUMNS]
        cells[2] = max(cells[2], 0.0)
        lines.append(f"| {target} | " + " | ".join(f"{value:.2f}" for value in cells) + " |")
    return "\n".join(lines) + "\n"


def main() -> None:
    """Measure, print, and write the page if asked."""
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("results", type=Path, nargs="*")
    parser.add_argument("--heads", type=int, default=10)
    parser.add_argument("--page", type=Path)
    options = parser.parse_args()
    found = {name: measured(clone) for name, clone in subjects(options.results, options.heads)}
    names = " ".join(path.name for path in options.results)
    text = page(found, f"python benchmarks/face_motion.py {names} --heads {options.heads}")
    print(text)
    if options.page is not None:
        options.page.write_text(text)


if __name__ == "__main__":
    main()
