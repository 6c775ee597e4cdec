"""Explanations of points and their placement, in plain words."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import Final

from PySide6.QtCore import QT_TRANSLATE_NOOP

from cloner.booth.visitors.uncertain import uncertain_points
from cloner.frames import ViewId
from cloner.records.points import ANCHOR, ViewPoints
from cloner_gui.canvas.photos.painting import CLONE, CORRECTED, LINKED, SURE, UNSURE
from cloner_gui.language.point_names import point_label
from cloner_gui.language.words import translate

Place = tuple[ViewId, str]

#: Hint for every point whose name, without its side, begins so; the longest beginning wins.
_HINTS: Final[dict[str, object]] = {
    ANCHOR: QT_TRANSLATE_NOOP("hints", "Your own point on the outline: drag it on to the border of the person."),
    "head_top": QT_TRANSLATE_NOOP("hints", "Highest point of the skull: under the hair, not on top of it."),
    "sole": QT_TRANSLATE_NOOP("hints", "Lowest edge of the shoe or foot: it sets the height of the person."),
    "toe": QT_TRANSLATE_NOOP("hints", "Foremost point of the shoe or foot."),
    "heel": QT_TRANSLATE_NOOP("hints", "Hindmost point of the shoe or foot."),
    "waist": QT_TRANSLATE_NOOP("hints", "Outline at the narrowest place of the trunk."),
    "hip": QT_TRANSLATE_NOOP("hints", "Outline at the widest place of the hips."),
    "knee": QT_TRANSLATE_NOOP("hints", "Outline of the leg at the middle of the kneecap."),
    "ankle": QT_TRANSLATE_NOOP("hints", "Outline of the leg at its narrowest place above the foot."),
    "calf": QT_TRANSLATE_NOOP("hints", "Outline of the lower leg where the calf is thickest."),
    "elbow": QT_TRANSLATE_NOOP("hints", "Outline of the arm at the bend of the elbow."),
    "wrist": QT_TRANSLATE_NOOP("hints", "Outline of the arm at its narrowest place before the hand."),
    "shoulder_end": QT_TRANSLATE_NOOP("hints", "Outline where the shoulder turns down into the arm."),
    "neck_base": QT_TRANSLATE_NOOP("hints", "Outline where the neck turns into the shoulder."),
    "neck": QT_TRANSLATE_NOOP("hints", "Outline of the neck at half its height."),
    "armpit": QT_TRANSLATE_NOOP("hints", "Where the arm meets the trunk: the end of the gap between them."),
    "crotch": QT_TRANSLATE_NOOP("hints", "Where the legs meet: the top of the gap between them."),
    "chest": QT_TRANSLATE_NOOP("hints", "Foremost outline of the chest."),
    "belly": QT_TRANSLATE_NOOP("hints", "Foremost outline of the belly."),
    "back": QT_TRANSLATE_NOOP("hints", "Hindmost outline of the upper back."),
    "buttock": QT_TRANSLATE_NOOP("hints", "Hindmost outline of the seat."),
    "thigh": QT_TRANSLATE_NOOP("hints", "Outline of the thigh at half its length."),
    "joint": QT_TRANSLATE_NOOP("hints", "Middle of the joint inside the limb: where it bends, not on the outline."),
    "pupil": QT_TRANSLATE_NOOP("hints", "Middle of the pupil."),
    "eye_inner": QT_TRANSLATE_NOOP("hints", "Corner of the eye towards the nose."),
    "eye_outer": QT_TRANSLATE_NOOP("hints", "Corner of the eye towards the ear."),
    "eye_upper": QT_TRANSLATE_NOOP("hints", "Edge of the upper lid, above the pupil."),
    "eye_lower": QT_TRANSLATE_NOOP("hints", "Edge of the lower lid, below the pupil."),
    "mouth_corner": QT_TRANSLATE_NOOP("hints", "Corner of the closed mouth."),
    "lip_top": QT_TRANSLATE_NOOP("hints", "Upper edge of the upper lip, in the middle."),
    "lip_bottom": QT_TRANSLATE_NOOP("hints", "Lower edge of the lower lip, in the middle."),
    "stomion": QT_TRANSLATE_NOOP("hints", "Middle of the line between the closed lips."),
    "ala": QT_TRANSLATE_NOOP("hints", "Outermost point of the wing of the nose."),
    "nose_tip": QT_TRANSLATE_NOOP("hints", "Tip of the nose; in the side photo its foremost point."),
    "nasion": QT_TRANSLATE_NOOP("hints", "Deepest place of the root of the nose, between the eyes."),
    "glabella": QT_TRANSLATE_NOOP("hints", "Foremost place of the forehead between the brows."),
    "subnasale": QT_TRANSLATE_NOOP("hints", "Where the nose meets the upper lip, in the middle."),
    "chin_front": QT_TRANSLATE_NOOP("hints", "Foremost point of the chin."),
    "chin_bottom": QT_TRANSLATE_NOOP("hints", "Lowest point of the chin."),
    "hairline": QT_TRANSLATE_NOOP("hints", "Where the hair begins above the forehead."),
    "ear_top": QT_TRANSLATE_NOOP("hints", "Highest point of the ear."),
    "ear_lobe": QT_TRANSLATE_NOOP("hints", "Lowest point of the earlobe."),
    "ear_back": QT_TRANSLATE_NOOP("hints", "Hindmost point of the ear."),
    "ear_outer": QT_TRANSLATE_NOOP("hints", "Point of the ear farthest from the head."),
}


def point_hint(name: str) -> str:
    """Return one sentence on what a point is, "" if there is nothing to say."""
    key = "joint" if name.startswith(("l_", "r_")) else name
    found = max((start for start in _HINTS if key.startswith(start)), key=len, default="")
    return translate("hints", str(_HINTS[found])) if found else ""


def point_text(points: ViewPoints | None, chosen: str) -> str:
    """Return rich text on a point: what it is, how certain, and how to place it."""
    if not chosen or points is None or chosen not in points.names:
        return translate("hints", "Drag a point to its place, or press Tab: the least sure point comes first.")
    row = points.names.index(chosen)
    sure = translate("hints", "%1 % sure").replace("%1", str(round(100 * float(points.confidence[row]))))
    state = translate("hints", "placed by you") if points.corrected[row] else sure
    head = translate("hints", "outline point") if chosen.startswith(ANCHOR) else point_label(chosen)
    return f"<b>{head}</b> · {state}<br>{point_hint(chosen)}"


def remaining_text(order: Sequence[Place], points: Mapping[ViewId, ViewPoints], now: Place) -> str:
    """Return the number of uncertain points after the present one in an order, and whether the last one was seen."""
    left = {(view, name) for view, names in uncertain_points(points).items() for name in names}
    coming = sum(one in left for one in order[order.index(now) + 1 :])
    if now in left or coming:
        return translate("points", "{n} doubtful points are left after this one.").format(n=coming)
    return translate("points", "All doubtful points are seen: this one is sure. Press Clone.")


def legend_text() -> str:
    """Return rich text on the colours of points and outlines."""
    marks = (
        ("○", SURE, translate("hints", "sure")),
        ("△", UNSURE, translate("hints", "doubtful")),
        ("□", CORRECTED, translate("hints", "placed by you")),
        ("▬", LINKED, translate("hints", "outline in the photo")),
        ("▬", CLONE, translate("hints", "outline of the clone")),
    )
    return " &nbsp; ".join(f'<span style="color:{colour.name()}">{mark}</span> {text}' for mark, colour, text in marks)
