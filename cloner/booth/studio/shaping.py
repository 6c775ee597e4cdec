"""Bodies from measures and changed clones: previewed while they are edited, written when finished."""

from __future__ import annotations

import functools
from collections.abc import Sequence
from pathlib import Path
from typing import Final

from cloner.bodies.children import GROWN, stature_mm
from cloner.bodies.made import clone_of_measures, figure, remeasured_clone
from cloner.bodies.telling import BodySpecification
from cloner.bodies.written import body_folder, sex_of
from cloner.booth.studio.values import BodyWish, Figure
from cloner.generic.tape import load_tape_rules
from cloner.geometry.measurement.measuring import measures_mm
from cloner.picture import clone_file, load_clone_at
from cloner.pipeline import Progress
from cloner.records.clones import Clone

#: Side of the texture that a body is shown in while it is told, texels.
_SHOWN_TEXELS: Final = 1024
#: Whose skin and face are shown, metres.
_USUAL_M: Final = {"f": 1.65, "m": 1.75}


@functools.lru_cache(maxsize=4)
def _average(sex: str, age_years: float) -> Clone:
    """Return an average person."""
    stature_m = _USUAL_M[sex] if age_years >= GROWN else stature_mm(sex, age_years)[0] / 1e3
    return clone_of_measures(BodySpecification(sex, stature_m, {}, age_years), _SHOWN_TEXELS)


class Shaping:
    """Jobs of the bodies' window."""

    def __init__(self) -> None:
        self._source: tuple[tuple[Path, int], Clone] | None = None

    def begin_body(self, wish: BodyWish, progress: Progress) -> tuple[Clone, str]:
        """Return the clone that provides the body's skin and face, and its sex."""
        progress("body", 0.0)
        if wish.source is not None:
            clone = self._of(wish.source)
            return clone, wish.sex or sex_of(clone)
        return _average(wish.sex, wish.age_years), wish.sex

    def shape_body(self, wish: BodyWish, progress: Progress) -> Figure:
        """Return a body with given measures; see `cloner.bodies.made`."""
        progress("body", 0.0)
        told_mm = {key: 10.0 * value for key, value in wish.cm.items()}
        if wish.source is None:
            body = figure(BodySpecification(wish.sex, wish.stature_cm / 100.0, told_mm, wish.age_years))
            shown = measures_mm(body.vertices_m, body.joints_m, load_tape_rules())
            return Figure(body.vertices_m, body.joints_m, (), {**shown, **told_mm})
        clone = self._of(wish.source)
        made = remeasured_clone(
            clone, BodySpecification(wish.sex or sex_of(clone), wish.stature_cm / 100.0, told_mm, wish.age_years)
        )
        return Figure(
            made.vertices_m, made.joints_m, tuple(shell.vertices_m for shell in made.shells), made.measures_mm
        )

    def save_body(
        self, wish: BodyWish, out: Path, identifier: str, formats: Sequence[str], size: int, progress: Progress
    ) -> Path:
        """Write a body as a result; see `cloner.bodies.written.body_folder`."""
        folder, _ = body_folder(
            out, identifier, sex=wish.sex, stature_cm=wish.stature_cm, measures_cm=wish.cm, formats=formats,
            texture_size=size, age_years=wish.age_years, source=wish.source, progress=progress,
        )  # fmt: skip
        return folder

    def _of(self, source: Path) -> Clone:
        key = source, clone_file(source).stat().st_mtime_ns
        if self._source is None or self._source[0] != key:
            self._source = key, load_clone_at(source)
        return self._source[1]
