"""Metaballs by their common names, in the window's language."""

from __future__ import annotations

from typing import Final

from PySide6.QtCore import QT_TRANSLATE_NOOP

from cloner_gui.language.words import TranslatedWords, translate

_NAMES: Final = TranslatedWords(
    "blobs",
    {
        "belly": QT_TRANSLATE_NOOP("blobs", "belly"),
        "waist": QT_TRANSLATE_NOOP("blobs", "waist"),
        "chest": QT_TRANSLATE_NOOP("blobs", "chest"),
        "neck": QT_TRANSLATE_NOOP("blobs", "neck"),
        "pelvis": QT_TRANSLATE_NOOP("blobs", "pelvis"),
        "chest_across": QT_TRANSLATE_NOOP("blobs", "chest, across"),
        "shoulders": QT_TRANSLATE_NOOP("blobs", "shoulders"),
        "buttock": QT_TRANSLATE_NOOP("blobs", "buttock"),
        "breast": QT_TRANSLATE_NOOP("blobs", "breast"),
        "deltoid": QT_TRANSLATE_NOOP("blobs", "shoulder's muscle"),
        "thigh": QT_TRANSLATE_NOOP("blobs", "thigh"),
        "calf": QT_TRANSLATE_NOOP("blobs", "lower leg"),
        "calf_muscle": QT_TRANSLATE_NOOP("blobs", "calf"),
        "kneecap": QT_TRANSLATE_NOOP("blobs", "kneecap"),
        "upper_arm": QT_TRANSLATE_NOOP("blobs", "upper arm"),
        "forearm": QT_TRANSLATE_NOOP("blobs", "forearm"),
    },
)


def blob_label(name: str) -> str:
    """Return a metaball's common name; a user's own name is returned unchanged."""
    sides = {"l_": translate("sides", "%1, left"), "r_": translate("sides", "%1, right")}
    start, base = (name[:2], name[2:]) if name[:2] in sides else ("", name)
    if base not in _NAMES:
        return name
    return sides[start].replace("%1", _NAMES[base]) if start else _NAMES[base]
