"""Stage: measures of the body under its clothes, and what cloth covers (beyond the paper)."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import replace
from typing import Final

import numpy as np
from numpy.typing import NDArray

from cloner.body.outlined import outlined_photos
from cloner.calibration.loader import calibrated
from cloner.frames import ViewId
from cloner.generic.measure_prior import load_measure_prior
from cloner.generic.tape import load_tape_rules
from cloner.geometry.measurement.measuring import ALL_KEYS, LOOSE_KEYS, bare_rows, measures_mm
from cloner.geometry.measurement.prior import MeasurePrior
from cloner.geometry.measurement.under_clothes import NINE_IN_TEN, BodyEstimate, OutlineMeasures, estimate_body
from cloner.measure.gathered import gather_measures
from cloner.records.arrays import Array
from cloner.records.bodies import FineBody, Phenotype
from cloner.records.clones import Joined
from cloner.records.measures import BY_KEY, FITS, MEASURE_KEYS, Cover, Measure, MeasureSet
from cloner.records.photos import Person
from cloner.records.proposals import Proposals
from cloner.records.results import Residual, StageResult
from cloner.records.silhouettes import SilhouetteSet

#: What each number is and where it comes from: ``cloner/calibration/stages.toml``.
_CALIBRATED: Final = calibrated("stages.measures")


UNKNOWN_STATURE_M: Final = _CALIBRATED.number("unknown_stature_m", "m")
TAPE_ERROR_MM: Final = _CALIBRATED.number("tape_error_mm", "mm")
#: No clothes were seen.
NO_RUMPLE_MM: Final = np.full(2, np.nan)
NOT_HIDDEN: Final = np.zeros(len(ALL_KEYS), dtype=bool)
#: Girths that the depth in the side photo decides most.
WAISTS: Final = ("narrowest_waist_girth", "waist_girth", "navel_girth")
STRANGE: Final = _CALIBRATED.number("strange", "factor")


def estimate_measures(
    shown_mm: Mapping[str, float],
    person: Person,
    cover: Mapping[str, Cover],
    *,
    noise: float = 1.0,
    rumple_mm: Array = NO_RUMPLE_MM,
    hidden: NDArray[np.bool_] = NOT_HIDDEN,
    under_mm: Array | None = None,
) -> tuple[MeasureSet, tuple[str, ...]]:
    """Return the measures of a photographed person, and sentences on what makes some of them doubtful.

    Parameters
    ----------
    shown_mm : mapping of str to float
        :func:`measures_mm` of the clone's skin; what loose clothing hides is missing.
    person : Person
    cover : mapping of str to Cover
        By segment.
    noise : float
        How much worse this clone fits its outlines than usual, as a ratio.
    rumple_mm : (2,) float64
        How rumpled the outline of the clothes is above and below the waist; NaN where not seen.
    hidden : (K,) bool
        Where an arm hides the depth of the trunk in the side photo.
    under_mm : (K,) float64, optional
        Girths that the label net sees under the clothes, NaN where it sees none.
    """
    prior = load_measure_prior()
    shown = np.array([shown_mm.get(key, np.nan) for key in ALL_KEYS])
    shown[hidden] = np.nan  # left to its neighbours: of eight people as good as larger noise (52 against 53 mm)
    tape = {ALL_KEYS.index(key): value for key, value in person.tape_mm}
    without = OutlineMeasures(shown, person.stature_m, bare_rows(cover), {}, noise, rumple_mm, under_mm)
    photos_say = estimate_body(without, prior)
    found = estimate_body(replace(without, tape_mm=tape), prior) if tape else photos_say
    share = 0.0 if person.stature_is_known else NINE_IN_TEN * UNKNOWN_STATURE_M / person.stature_m
    values = {key: _measure(key, found, prior, shown_mm, dict(person.tape_mm), share) for key in MEASURE_KEYS}
    fits = [dict(zip(FITS, map(float, each), strict=True)) for each in (found.upper_fit, found.lower_fit)]
    return MeasureSet(values, cover, *fits), (
        *_hidden_waist(hidden),
        *_unlikely_tapes(photos_say, prior, person, share),
    )


def _measure(
    key: str,
    found: BodyEstimate,
    prior: MeasurePrior,
    shown_mm: Mapping[str, float],
    tape_mm: Mapping[str, float],
    share: float,
) -> Measure:
    row = ALL_KEYS.index(key)
    value = float(tape_mm.get(key, found.mm[row]))
    half = float(np.hypot(prior.spread[row] * found.deviation_mm[row], share * value))
    return Measure(value, TAPE_ERROR_MM if key in tape_mm else half, shown_mm.get(key), key in tape_mm)


def _hidden_waist(hidden: NDArray[np.bool_]) -> tuple[str, ...]:
    """Return a sentence when an arm covers the waist's depth."""
    if not hidden[[ALL_KEYS.index(key) for key in WAISTS]].any():
        return ()
    return (
        f"{ViewId.BODY_SIDE}: an arm lies over the edge of the trunk, girths there are less certain; with the arm "
        "before the middle of the trunk they would be surer",
    )


def _unlikely_tapes(photos_say: BodyEstimate, prior: MeasurePrior, person: Person, share: float) -> tuple[str, ...]:
    """Return a sentence for every tape measure that the photos make unlikely."""
    warnings = []
    for key, tape in person.tape_mm:
        row = ALL_KEYS.index(key)
        seen = float(photos_say.mm[row])
        half = float(np.hypot(prior.spread[row] * photos_say.deviation_mm[row], share * seen))
        if abs(tape - seen) > STRANGE * np.hypot(half, TAPE_ERROR_MM):
            warnings.append(
                f"The tape says {tape / 10:.1f} cm for {key} ({BY_KEY[key].words}), the photos say "
                f"{seen / 10:.1f} ± {half / 10:.1f}: measure again, or check the height and the photos"
            )
    return tuple(warnings)


def measures_of_mesh(shown_mm: Mapping[str, float]) -> MeasureSet:
    """Return the measures of a body without photos: those of its mesh, without a ±."""
    return MeasureSet({key: Measure(shown_mm[key], None, shown_mm[key]) for key in MEASURE_KEYS})


def run(
    *,
    proposals: Proposals,
    silhouettes: SilhouetteSet,
    phenotype: Phenotype,
    body: FineBody,
    joined: Joined,
    person: Person,
    tick: Callable[[float], None],
) -> StageResult:
    """Produce the measures of the joined person; the residual is the distance from silhouette to outlines."""
    outlined = outlined_photos(phenotype, silhouettes, proposals, body.views)
    if not outlined:
        shown = measures_mm(joined.vertices_m, joined.joints_m, load_tape_rules(), joined.sole_m)
        return StageResult({"measures": measures_of_mesh(shown)})
    tick(0.4)
    measured = gather_measures(joined, body.mesh, outlined, silhouettes, proposals)
    tick(0.7)
    hidden_keys = LOOSE_KEYS if measured.around_legs else frozenset()
    found, warnings = estimate_measures(
        {key: value for key, value in measured.shown_mm.items() if key not in hidden_keys},
        person,
        measured.cover,
        noise=max(1.0, measured.gap_mm / load_measure_prior().gap_mm),
        rumple_mm=measured.rumple_mm,
        hidden=measured.hidden,
        under_mm=measured.under_mm,
    )
    return StageResult({"measures": found}, (Residual("gap of the body's rim", measured.gap_mm, "mm"),), warnings)
