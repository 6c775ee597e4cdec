"""Rows of the pose net (BlazePose numbering) by name."""

from __future__ import annotations

from typing import Final

#: BlazePose's rows, left first.
NOSE: Final = 0
EARS: Final = (7, 8)
SHOULDERS: Final = (11, 12)
ELBOWS: Final = (13, 14)
WRISTS: Final = (15, 16)
HIPS: Final = (23, 24)
KNEES: Final = (25, 26)
ANKLES: Final = (27, 28)
HEELS: Final = (29, 30)
TOES: Final = (31, 32)
MOUTH: Final = (9, 10)
#: Little finger, index finger and thumb, left and right.
FINGERS: Final = ((17, 18), (19, 20), (21, 22))
#: All rows that have a twin on the other side, left first.
TWINS: Final = (
    (1, 4), (2, 5), (3, 6), EARS, MOUTH, SHOULDERS, ELBOWS, WRISTS, *FINGERS, HIPS, KNEES, ANKLES, HEELS, TOES,
)  # fmt: skip
ARM_TWINS: Final = (ELBOWS, WRISTS, *FINGERS)
LEG_TWINS: Final = (KNEES, ANKLES, HEELS, TOES)
LEFT, RIGHT = 0, 1
SIDES: Final = ("left", "right")

#: Rows that stand for H-Anim joint centres.
JOINTS: Final = {
    f"{side[0]}_{name}": pair[number]
    for number, side in enumerate(SIDES)
    for name, pair in (
        ("shoulder", SHOULDERS),
        ("elbow", ELBOWS),
        ("wrist", WRISTS),
        ("hip", HIPS),
        ("knee", KNEES),
        ("ankle", ANKLES),
    )
}
#: Rows that stand for surface features of head and feet.
FEATURES: Final = {
    "nose_tip": NOSE,
    "ear_outer_L": EARS[LEFT],
    "ear_outer_R": EARS[RIGHT],
    "pupil_L": 2,
    "pupil_R": 5,
    "heel_left": HEELS[LEFT],
    "heel_right": HEELS[RIGHT],
    "toe_left": TOES[LEFT],
    "toe_right": TOES[RIGHT],
}
