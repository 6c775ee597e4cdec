"""The sentence on which points deserve a check, or that none do."""

from __future__ import annotations

from collections.abc import Mapping

from PySide6.QtCore import QT_TRANSLATE_NOOP

from cloner.booth.visitors.uncertain import MOST, Effect, effect_of_point, uncertain_points
from cloner.frames import ViewId
from cloner.records.points import ViewPoints
from cloner_gui.language.point_names import point_label
from cloner_gui.language.words import VIEW_TITLES, TranslatedWords, translate

CHANGES = TranslatedWords(
    "worth",
    {
        Effect.HEIGHT: QT_TRANSLATE_NOOP("worth", "the height"),
        Effect.FACE: QT_TRANSLATE_NOOP("worth", "the face"),
        Effect.POSE: QT_TRANSLATE_NOOP("worth", "the pose"),
        Effect.BREADTH: QT_TRANSLATE_NOOP("worth", "how broad the body is"),
    },
)


def uncertain_text(points: Mapping[ViewId, ViewPoints]) -> str:
    """Return which points deserve a check and what they affect, in the window's language."""
    found = [(view, name) for view, names in uncertain_points(points).items() for name in names]
    if not found:
        return translate("worth", "All points are sure: the clone needs no hand.")
    names = ", ".join(f"{point_label(name)} ({VIEW_TITLES[view]})" for view, name in found[:MOST])
    more = len(found) - MOST
    if more > 0:
        names += translate("worth", " and {n} more").format(n=more)
    changes = ", ".join(dict.fromkeys(CHANGES[effect_of_point(view, name)] for view, name in found))
    told = translate("worth", "Worth a look under Points: {names}. They set {changes}.")
    return told.format(names=names, changes=changes)
