"""Who may use a visitor's files: chosen at the consent in the visitor's language, up to the event's widest licence."""

from __future__ import annotations

from collections.abc import Sequence

from PySide6.QtWidgets import QComboBox, QVBoxLayout, QWidget

from cloner_gui.language.languages import translator_of
from cloner_gui.language.words import LICENCE_MEANINGS, LICENCE_NAMES
from cloner_gui.widgets.pieces import GAP, label


class LicenceField(QWidget):
    """A choice of licences with a sentence on the chosen one."""

    def __init__(self, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self.choice, self.meaning = QComboBox(), label("dim")
        self._code = ""
        self._told: tuple[object, ...] = ()
        column = QVBoxLayout(self)
        column.setContentsMargins(0, 0, 0, 0)
        column.setSpacing(GAP // 2)
        column.addWidget(self.choice)
        column.addWidget(self.meaning)
        self.choice.currentIndexChanged.connect(self._explain)

    def offer(self, licences: Sequence[str], code: str, chosen: str) -> None:
        """Offer licences in the words of a language; what the visitor chose stays while all is offered as before.

        Parameters
        ----------
        licences : sequence of str
        code : str
            The language.
        chosen : str
            What is chosen at first.
        """
        told = (code, chosen, *licences)
        if told == self._told:
            return
        self._code, self._told = code, told
        translator = translator_of(code)
        self.choice.blockSignals(True)
        self.choice.clear()
        for licence in licences:
            self.choice.addItem(LICENCE_NAMES.by(translator, licence), licence)
        self.choice.blockSignals(False)
        self.choose(chosen)

    def choose(self, licence: str) -> None:
        """Show a licence as the chosen one."""
        self.choice.setCurrentIndex(max(self.choice.findData(licence), 0))
        self._explain()

    def forget(self) -> None:
        """Forget what was chosen: another visitor is asked."""
        self._told = ()

    def chosen(self) -> str:
        """Return the licence that is chosen."""
        return str(self.choice.currentData() or "")

    def _explain(self) -> None:
        self.meaning.setText(LICENCE_MEANINGS.by(translator_of(self._code), self.chosen()) if self.chosen() else "")
