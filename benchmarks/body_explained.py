"""Say in words why a clone is bad, from its figures alone."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any, Final

Row = Mapping[str, Any]

#: From here on a figure is told as a cause; taste, a little beyond what most people have.
POOR_OUTLINE_IOU: Final = 0.97
FAR_JOINT_MM: Final = 30.0
THICK_MM: Final = 8.0
MANY_WRONG: Final = 3


def explain(row: Row) -> str:
    """Return the causes that a person's figures show, the outline's first: what is wrong there nothing can mend."""
    causes = [
        f"outline of the {view[5:]} photo wrong (IoU {found['outline_iou']:.3f}, mask alone {found['mask_iou']:.3f})"
        for view, found in row["outlines"].items()
        if found["outline_iou"] < POOR_OUTLINE_IOU
    ]
    wrong = row["points"]["wrong"]
    if len(wrong) >= MANY_WRONG:
        causes.append(f"{len(wrong)} wrong feature points ({', '.join(wrong[:4])}…)")
    last = row["steps"]["finished"]
    far = sorted(((mm, name) for name, mm in last["joints_mm"].items() if mm > FAR_JOINT_MM), reverse=True)
    if far:
        causes.append("posed wrong: " + ", ".join(f"{name} {mm:.0f} mm off" for mm, name in far[:3]))
    thick = sorted(((mean, part) for part, (mean, _) in last["part_mm"].items() if mean > THICK_MM), reverse=True)
    if thick:
        causes.append("surface: " + ", ".join(f"{part} {mm:.0f} mm" for mm, part in thick[:3]))
    if not causes:
        part, (mean, _) = max(last["part_mm"].items(), key=lambda item: item[1][0])
        joint, away = max(last["joints_mm"].items(), key=lambda item: item[1])
        causes.append(f"no single cause; most at {part} ({mean:.0f} mm) and {joint} ({away:.0f} mm)")
    return "; ".join(causes)
