"""Garments, fabrics and output formats of a dressed clone, in the window's language."""

from __future__ import annotations

from typing import Final

from PySide6.QtCore import QT_TRANSLATE_NOOP

from cloner_gui.language.words import TranslatedWords

GARMENTS: Final = TranslatedWords(
    "garments",
    {
        "skirt": QT_TRANSLATE_NOOP("garments", "Skirt"),
        "circle-skirt": QT_TRANSLATE_NOOP("garments", "Circle skirt"),
        "straight-skirt": QT_TRANSLATE_NOOP("garments", "Straight skirt"),
        "long-skirt": QT_TRANSLATE_NOOP("garments", "Long skirt"),
        "cape": QT_TRANSLATE_NOOP("garments", "Cape"),
        "tee": QT_TRANSLATE_NOOP("garments", "T-shirt"),
        "dress": QT_TRANSLATE_NOOP("garments", "Dress"),
        "coat": QT_TRANSLATE_NOOP("garments", "Coat"),
        "trousers": QT_TRANSLATE_NOOP("garments", "Trousers"),
    },
)
FABRICS: Final = TranslatedWords(
    "fabrics",
    {
        "silk": QT_TRANSLATE_NOOP("fabrics", "Silk"),
        "cotton": QT_TRANSLATE_NOOP("fabrics", "Cotton"),
        "linen": QT_TRANSLATE_NOOP("fabrics", "Linen"),
        "wool": QT_TRANSLATE_NOOP("fabrics", "Wool"),
        "denim": QT_TRANSLATE_NOOP("fabrics", "Denim"),
        "burlap": QT_TRANSLATE_NOOP("fabrics", "Burlap"),
    },
)
#: What a dressed clone is written as, by file ending; a folder has none.
TARGETS: Final = TranslatedWords(
    "garments",
    {
        ".glb": QT_TRANSLATE_NOOP("garments", "GLB: the clone walks in it"),
        ".mp4": QT_TRANSLATE_NOOP("garments", "MP4 film"),
        ".webp": QT_TRANSLATE_NOOP("garments", "WebP film"),
        ".gif": QT_TRANSLATE_NOOP("garments", "GIF film"),
        ".usdc": QT_TRANSLATE_NOOP("garments", "USD: the garment alone"),
        ".pc2": QT_TRANSLATE_NOOP("garments", "PC2 and OBJ: the garment alone"),
        "": QT_TRANSLATE_NOOP("garments", "Folder: a clone in it, whose cloth flows in crowds"),
    },
)
