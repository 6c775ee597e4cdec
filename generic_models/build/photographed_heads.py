"""Heads of the generator of photographed people, as the painted portraits tell theirs: to teach small features.

The generator is no part of this repository; a folder of its people (``face_front`` and ``face_side`` at least) is told.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import dataclass
from pathlib import Path
from typing import Final

import numpy as np
from numpy.typing import NDArray
from painted_portraits import segmented

from cloner.errors import ClonerError
from cloner.evaluate.truths.kit import kit_people, read_kit
from cloner.generic.load import load_generic
from cloner.records.labels import Label
from cloner.vision.photographs.pictures import read_picture

Array = NDArray[np.float64]

#: What hides the skin below.
COVERS: Final = (Label.HAIR, Label.UPPER_CLOTHES, Label.LOWER_CLOTHES, Label.ACCESSORY)


@dataclass(frozen=True, slots=True, eq=False)
class Head:
    """One picture of a head: photo, mask (0..255), marks, those that are hidden, and the side that is asked for."""

    seed: int
    rgb: NDArray[np.uint8]
    mask: NDArray[np.uint8]
    marks_px: Mapping[str, Array]
    hidden: frozenset[str]
    vertices_px: Array
    side: str


def photographed(people: Path, view: str, names: tuple[str, ...]) -> Iterator[Head]:
    """Give the people's photos of a view, "face_front" or "face_side", with the named marks that lie in them.

    The side is the one that faces the camera of a side photo.
    """
    generic = load_generic()
    for folder in kit_people([people]):
        try:
            known, rgb = read_kit(folder), read_picture(folder / f"{view}.jpg").rgb
        except ClonerError as error:
            print(f"{folder.name}: {error}")
            continue
        places = known.truth.views[view].camera.project(known.whole_m(view))
        labels, seed = known.labels[view], int("".join(filter(str.isdigit, folder.name)))
        inside = {name: places[generic.feature(name)] for name in names}
        inside = {
            name: at for name, at in inside.items() if ((at > 1.0) & (at < np.array(rgb.shape[1::-1]) - 2.0)).all()
        }
        at = {name: tuple(np.round(place).astype(int)[::-1]) for name, place in inside.items()}
        hidden = frozenset(name for name, place in at.items() if labels[place] in COVERS)
        nose, ears = places[generic.feature("nose_tip")], places[generic.region("ear_left")].mean(axis=0)
        person = (labels != Label.BACKGROUND).astype(np.float32)
        mask = segmented(person, np.random.default_rng([seed, 77]))
        yield Head(seed, rgb, mask, inside, hidden, places, "L" if nose[0] < ears[0] else "R")
