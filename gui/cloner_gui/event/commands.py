"""The one undoable edit: a whole value replaced by another."""

from __future__ import annotations

from collections.abc import Callable

from PySide6.QtGui import QUndoCommand

from cloner.records.points import Corrections


class Swap(QUndoCommand):
    """Replace the corrections by others that were built and checked before.

    Parameters
    ----------
    before, after : Corrections
    label : str
        What the Edit menu says after "Undo".
    apply : callable
        Takes the corrections that count from now on; must not raise.
    gesture : str
        Swaps of one gesture (a drag) merge into one; "" never merges.
    """

    def __init__(
        self,
        before: Corrections,
        after: Corrections,
        label: str,
        apply: Callable[[Corrections], None],
        gesture: str = "",
    ) -> None:
        super().__init__(label)
        self._before, self._after = before, after
        self._apply, self._gesture = apply, gesture

    def id(self) -> int:
        """Return the kind of command, which Qt asks before merging."""
        return 1

    def mergeWith(self, other: QUndoCommand) -> bool:
        """Take over a later swap of the same gesture."""
        if not isinstance(other, Swap) or not self._gesture or other._gesture != self._gesture:
            return False
        self._after = other._after
        return True

    def redo(self) -> None:
        """Make the new value count."""
        self._apply(self._after)

    def undo(self) -> None:
        """Make the old value count."""
        self._apply(self._before)
