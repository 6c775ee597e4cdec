"""The five steps, always on top: the present one, completed ones, and those not yet possible."""

from __future__ import annotations

from collections.abc import Sequence

from PySide6.QtCore import Signal
from PySide6.QtWidgets import QButtonGroup, QPushButton, QWidget

from cloner_gui.language.words import translate
from cloner_gui.widgets.flow import Flow
from cloner_gui.widgets.pieces import set_accessible_name


class StepBar(QWidget):
    """One button per step."""

    chosen = Signal(int)

    def __init__(self, count: int, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        row = Flow(self)
        row.setSpacing(0)
        self.buttons = [QPushButton() for _ in range(count)]
        group = QButtonGroup(self)
        for number, one in enumerate(self.buttons):
            one.setObjectName("step")
            one.setCheckable(True)
            group.addButton(one, number)
            row.addWidget(one)
        group.idClicked.connect(self.chosen)

    def show_steps(self, titles: Sequence[str], current: int, reachable: int) -> None:
        """Show the steps' names, which one is shown and how far one may go."""
        for number, (one, title) in enumerate(zip(self.buttons, titles, strict=True)):
            one.setText(f"{number + 1}  {title}")
            one.setShortcut(f"Ctrl+{number + 1}")  # a new text takes the old one away
            one.setChecked(number == current)
            one.setEnabled(number <= reachable or number == current)
            step = translate("window", "Step {n}: {title}").format(n=number + 1, title=title)
            set_accessible_name(one, step)


def step_titles() -> tuple[str, ...]:
    """Return the steps' titles."""
    return (
        translate("visitor", "Visitor"),
        translate("photos", "Photos"),
        translate("points", "Points"),
        translate("clone", "Clone"),
        translate("takeaway", "Take away"),
    )
