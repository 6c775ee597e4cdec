"""The formats that visitors may choose, in words."""

from __future__ import annotations

from typing import Final

from PySide6.QtCore import QT_TRANSLATE_NOOP

from cloner_gui.language.words import TranslatedWords

FORMATS: Final = TranslatedWords(
    "formats",
    {
        "glb": QT_TRANSLATE_NOOP("formats", "GLB: games, web, telephone"),
        "wrl": QT_TRANSLATE_NOOP("formats", "VRML97: H-Anim players"),
        "x3d": QT_TRANSLATE_NOOP("formats", "X3D: H-Anim with one skin"),
        "vrm": QT_TRANSLATE_NOOP("formats", "VRM: virtual meeting places"),
        "obj": QT_TRANSLATE_NOOP("formats", "OBJ: any 3-D program"),
        "ply": QT_TRANSLATE_NOOP("formats", "PLY: 3-D printing"),
    },
)
