"""The door for benchmarks and experiments: stages run alone, and people made of what is known so far.

Nothing of the product imports it. Names stand here so that scripts need not know how stages are wired.
"""

from __future__ import annotations

from collections.abc import Collection, Mapping, Sequence
from pathlib import Path
from typing import Any

import numpy as np

from cloner import pipeline
from cloner.pipeline import StageReport
from cloner.project.corrections import no_corrections
from cloner.project.folder import load_photos, read_person
from cloner.records.clones import Clone, Joined, TextureAtlas
from cloner.records.heads import Shell
from cloner.records.photos import Person, PhotoSet
from cloner.records.points import Corrections
from cloner.stages.textures import assemble

Values = dict[str, Any]
#: The stages in their order.
STAGE_NAMES = tuple(stage.name for stage in pipeline.STAGES)


def first_values(photos: PhotoSet, person: Person, corrections: Corrections | None = None) -> Values:
    """Return the initial values of a clone, without corrections unless given."""
    return {"photos": photos, "person": person, "corrections": corrections or no_corrections()}


def folder_values(folder: Path, corrections: Corrections | None = None) -> Values:
    """Return the initial values of the clone of a folder; ``corrections.json`` beside the photos is ignored."""
    return first_values(load_photos(folder), read_person(folder), corrections)


def run_stages(values: Mapping[str, Any], names: Collection[str]) -> tuple[Values, Sequence[StageReport]]:
    """Return all values after some stages, and a report of each; values that are known already are kept.

    Raises
    ------
    KeyError
        If a stage needs what no other gives.
    """
    return pipeline.run(values, stages=tuple(stage for stage in pipeline.STAGES if stage.name in names))


def up_to(name: str) -> tuple[str, ...]:
    """Return the names of a stage and of all before it."""
    return STAGE_NAMES[: STAGE_NAMES.index(name) + 1]


def bare_atlas() -> TextureAtlas:
    """Return the smallest atlas there is, for people whose texture nobody looks at."""
    return TextureAtlas(np.zeros((8, 8, 3), np.uint8), np.zeros((8, 8), np.uint8))


def untextured(person: Joined, shells: tuple[Shell, ...] = ()) -> Clone:
    """Return a joined person as a clone without a texture."""
    return assemble(person, shells, bare_atlas())
