"""Measures and clothes as plain JSON values and sentences."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import Any, Final

from cloner.records.measures import MEASURES, Cover, Measure, MeasureSet

NOTE: Final = (
    "Photos show clothes: a measure of the body under them is an estimate, the likeliest body of the generic family "
    "that could show these outlines in clothes from tight to loose. Nine in ten lie within the ±, as measured on known "
    "people. The last column is the clone's own measure, clothes included. Names are those of ISO 8559-1."
)
NO_BODY_NOTE: Final = "There was no body photo: these are the measures of a generic body, not of this person."
#: A garment is called by its fit from this probability on.
SURE: Final = 0.6
_PLACES: Final = {
    "neck": "neck", "torso": "trunk", "pelvis": "hips", "upper_arm": "upper arms", "forearm": "forearms",
    "hand": "hands", "thigh": "thighs", "calf": "lower legs", "foot": "feet",
}  # fmt: skip


def measures_json(measures: MeasureSet) -> dict[str, Any]:
    """Return all measures, with what covers the body."""
    seen = bool(measures.upper_fit)
    return {
        "note": NOTE if seen else NO_BODY_NOTE,
        "measured": seen,
        "values": {kind.key: _measure(measures.measures[kind.key], kind.words, kind.clause) for kind in MEASURES},
        "clothes": {
            "above_waist": {name: round(share, 3) for name, share in measures.upper_fit.items()},
            "below_waist": {name: round(share, 3) for name, share in measures.lower_fit.items()},
            "covered": {name: _cover(cover) for name, cover in measures.covers.items()},
            "words": list(clothes_words(measures)),
        },
    }


def _measure(measure: Measure, words: str, clause: str) -> dict[str, Any]:
    return {
        "value": round(measure.value_mm, 1),
        "plus_minus": None if measure.plus_minus_mm is None else round(measure.plus_minus_mm, 1),
        "over_clothes": None if measure.shown_mm is None else round(measure.shown_mm, 1),
        "taped": measure.taped,
        "words": words,
        "clause": clause,
    }


def _cover(cover: Cover) -> dict[str, Any]:
    share = cover.share
    return {"share": None if share is None else round(share, 3), "confidence": round(cover.confidence, 3)}


def clothes_words(measures: MeasureSet) -> tuple[str, ...]:
    """Return sentences about the clothes: their fit, and what is bare."""
    if not measures.upper_fit:
        return ()
    sentences = [
        f"Clothes above the waist look {_fit(measures.upper_fit)}, below it {_fit(measures.lower_fit)}.",
    ]
    bare = [words for name, words in _PLACES.items() if _shares(measures.covers, name, most=0.1)]
    partly = [words for name, words in _PLACES.items() if _shares(measures.covers, name, most=0.9, least=0.1)]
    if bare:
        sentences.append(f"Bare skin: {_listed(bare)}.")
    if partly:
        sentences.append(f"Partly bare: {_listed(partly)}.")
    return (*sentences, *_taped_words(measures))


def _taped_words(measures: MeasureSet) -> list[str]:
    """Return the interpretation of the difference between tape and outline: cloth."""
    cloth = [
        f"{kind.words.split(',')[0]} {measure.shown_mm - measure.value_mm:.0f} mm"
        for kind in MEASURES
        for measure in [measures.measures[kind.key]]
        if kind.is_girth and measure.taped and measure.shown_mm is not None
        if measure.shown_mm - measure.value_mm > (measure.plus_minus_mm or 0.0)
    ]
    return [f"By the tape, this much of the outline is cloth: {_listed(cloth)}."] if cloth else []


def _fit(shares: Mapping[str, float]) -> str:
    best = sorted(shares, key=lambda name: -shares[name])
    if shares[best[0]] >= SURE:
        return f"{best[0]} ({100 * shares[best[0]]:.0f} percent)"
    return f"{best[0]} or {best[1]} ({100 * shares[best[0]]:.0f} and {100 * shares[best[1]]:.0f} percent)"


def _shares(covers: Mapping[str, Cover], name: str, *, most: float, least: float = -1.0) -> bool:
    """Return whether the covered share of a place, on both sides together, lies between two values."""
    own = [covers[key].share for key in (name, f"left_{name}", f"right_{name}") if key in covers]
    known = [share for share in own if share is not None]
    return bool(known) and least < sum(known) / len(known) <= most


def _listed(words: Sequence[str]) -> str:
    return words[0] if len(words) == 1 else f"{', '.join(words[:-1])} and {words[-1]}"
