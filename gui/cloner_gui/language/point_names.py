"""Points by their common names, in the window's language."""

from __future__ import annotations

from typing import Final

from PySide6.QtCore import QT_TRANSLATE_NOOP

from cloner_gui.language.words import TranslatedWords, translate

_LEFT: Final = ("_L", "_left")
_RIGHT: Final = ("_R", "_right")


def point_label(name: str) -> str:
    """Return a point's common name: ``eye_inner_L`` is "inner corner of the eye, left"."""
    base, side = _parted(name)
    words = NAMES[base] if base in NAMES else base.replace("_", " ")
    if not side:
        return words
    sided = translate("sides", "%1, left") if side == "left" else translate("sides", "%1, right")
    return sided.replace("%1", words)


def is_point(name: str) -> bool:
    """Return whether this is the name of a point."""
    return _parted(name)[0] in NAMES


def _parted(name: str) -> tuple[str, str]:
    """Return a name without its side, and the side: "left", "right" or ""."""
    for side, ends, start in (("left", _LEFT, "l_"), ("right", _RIGHT, "r_")):
        for end in ends:
            if name.endswith(end):
                return name.removesuffix(end), side
        if name.startswith(start):
            return f"{name.removeprefix(start)}_joint", side
    return name.split("_")[0] if name.startswith("outline_") else name, ""


#: Names without their sides.
NAMES: Final = TranslatedWords(
    "names",
    {
        "eye_inner": QT_TRANSLATE_NOOP("names", "inner corner of the eye"),
        "eye_outer": QT_TRANSLATE_NOOP("names", "outer corner of the eye"),
        "eye_upper": QT_TRANSLATE_NOOP("names", "upper lid"),
        "eye_lower": QT_TRANSLATE_NOOP("names", "lower lid"),
        "mouth_corner": QT_TRANSLATE_NOOP("names", "corner of the mouth"),
        "ala": QT_TRANSLATE_NOOP("names", "wing of the nose"),
        "pupil": QT_TRANSLATE_NOOP("names", "pupil"),
        "ear_top": QT_TRANSLATE_NOOP("names", "top of the ear"),
        "ear_lobe": QT_TRANSLATE_NOOP("names", "earlobe"),
        "ear_outer": QT_TRANSLATE_NOOP("names", "outermost point of the ear"),
        "ear_back": QT_TRANSLATE_NOOP("names", "back of the ear"),
        "nasion": QT_TRANSLATE_NOOP("names", "root of the nose"),
        "glabella": QT_TRANSLATE_NOOP("names", "forehead between the brows"),
        "nose_tip": QT_TRANSLATE_NOOP("names", "tip of the nose"),
        "subnasale": QT_TRANSLATE_NOOP("names", "base of the nose"),
        "lip_top": QT_TRANSLATE_NOOP("names", "upper lip"),
        "stomion": QT_TRANSLATE_NOOP("names", "middle of the mouth"),
        "lip_bottom": QT_TRANSLATE_NOOP("names", "lower lip"),
        "chin_front": QT_TRANSLATE_NOOP("names", "front of the chin"),
        "chin_bottom": QT_TRANSLATE_NOOP("names", "bottom of the chin"),
        "hairline_top": QT_TRANSLATE_NOOP("names", "hairline"),
        "head_top": QT_TRANSLATE_NOOP("names", "top of the head"),
        "toe": QT_TRANSLATE_NOOP("names", "toe"),
        "waist": QT_TRANSLATE_NOOP("names", "waist"),
        "waist_front": QT_TRANSLATE_NOOP("names", "waist, front"),
        "waist_back": QT_TRANSLATE_NOOP("names", "waist, back"),
        "hip": QT_TRANSLATE_NOOP("names", "hip"),
        "hip_joint": QT_TRANSLATE_NOOP("names", "hip joint"),
        "knee_outer": QT_TRANSLATE_NOOP("names", "outside of the knee"),
        "knee_inner": QT_TRANSLATE_NOOP("names", "inside of the knee"),
        "knee_front": QT_TRANSLATE_NOOP("names", "front of the knee"),
        "knee_back": QT_TRANSLATE_NOOP("names", "back of the knee"),
        "knee_joint": QT_TRANSLATE_NOOP("names", "knee joint"),
        "ankle_outer": QT_TRANSLATE_NOOP("names", "outside of the ankle"),
        "ankle_inner": QT_TRANSLATE_NOOP("names", "inside of the ankle"),
        "ankle_front": QT_TRANSLATE_NOOP("names", "front of the ankle"),
        "ankle_back": QT_TRANSLATE_NOOP("names", "back of the ankle"),
        "ankle_joint": QT_TRANSLATE_NOOP("names", "ankle joint"),
        "elbow_outer": QT_TRANSLATE_NOOP("names", "outside of the elbow"),
        "elbow_inner": QT_TRANSLATE_NOOP("names", "inside of the elbow"),
        "elbow_joint": QT_TRANSLATE_NOOP("names", "elbow joint"),
        "wrist_outer": QT_TRANSLATE_NOOP("names", "outside of the wrist"),
        "wrist_inner": QT_TRANSLATE_NOOP("names", "inside of the wrist"),
        "wrist_joint": QT_TRANSLATE_NOOP("names", "wrist joint"),
        "shoulder_end": QT_TRANSLATE_NOOP("names", "end of the shoulder"),
        "shoulder_joint": QT_TRANSLATE_NOOP("names", "shoulder joint"),
        "acromion": QT_TRANSLATE_NOOP("names", "bony tip of the shoulder"),
        "neck_base": QT_TRANSLATE_NOOP("names", "base of the neck"),
        "neck_front": QT_TRANSLATE_NOOP("names", "front of the neck"),
        "neck_back": QT_TRANSLATE_NOOP("names", "back of the neck"),
        "neck_front_base": QT_TRANSLATE_NOOP("names", "pit of the neck"),
        "nape": QT_TRANSLATE_NOOP("names", "nape"),
        "armpit": QT_TRANSLATE_NOOP("names", "armpit"),
        "sole": QT_TRANSLATE_NOOP("names", "sole"),
        "heel": QT_TRANSLATE_NOOP("names", "heel"),
        "crotch": QT_TRANSLATE_NOOP("names", "crotch"),
        "chest": QT_TRANSLATE_NOOP("names", "chest"),
        "chest_front": QT_TRANSLATE_NOOP("names", "chest, front"),
        "back": QT_TRANSLATE_NOOP("names", "back"),
        "belly_front": QT_TRANSLATE_NOOP("names", "belly"),
        "buttock": QT_TRANSLATE_NOOP("names", "seat"),
        "thigh_front": QT_TRANSLATE_NOOP("names", "front of the thigh"),
        "thigh_back": QT_TRANSLATE_NOOP("names", "back of the thigh"),
        "thigh_outer": QT_TRANSLATE_NOOP("names", "outside of the thigh"),
        "thigh_inner": QT_TRANSLATE_NOOP("names", "inside of the thigh"),
        "calf": QT_TRANSLATE_NOOP("names", "calf"),
        "fingertip": QT_TRANSLATE_NOOP("names", "fingertip"),
        "vertex_top": QT_TRANSLATE_NOOP("names", "top of the skull"),
        "outline": QT_TRANSLATE_NOOP("names", "outline point"),
    },
)
