"""Outlines while points move: prepared in a thread of their own, linked again at every move."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from pathlib import Path

import numpy as np
from numpy.typing import NDArray
from PySide6.QtCore import QObject, Signal

from cloner.booth.visitors.cached_work import cached_values
from cloner.frames import ViewId
from cloner.interactive.relinking import LiveOutline, Step, follow_corrections, live_outline
from cloner.records.photos import PhotoSet
from cloner.records.points import Corrections, ViewPoints
from cloner.records.proposals import Proposals
from cloner_gui.background.worker import Task

Borders = tuple[NDArray[np.float64], ...]
Outlines = dict[ViewId, LiveOutline]


def ready_outlines(
    folder: Path, photos: PhotoSet, proposed: Mapping[ViewId, ViewPoints], progress: Callable[[str, float], None]
) -> Outlines:
    """Return the outlines of a visitor's body photos, prepared for moves; none before the nets have run."""
    proposals = cached_values(folder, photos).get("proposals")
    found: Outlines = {}
    for view, photo in photos.photos.items():
        if isinstance(proposals, Proposals) and view.is_body and view in proposals.views:
            progress("silhouettes", len(found) / len(photos.photos))
            outline = live_outline(photo, proposals.views[view], proposed.get(view))
            if outline is not None:
                found[view] = outline
    return found


class LiveOutlines(QObject):
    """The outlines of one visitor's photos."""

    changed = Signal()

    def __init__(self, parent: QObject | None = None) -> None:
        super().__init__(parent)
        self._ready: Outlines = {}
        self._steps: dict[ViewId, tuple[Step, ...]] = {}
        self._task: Task | None = None

    @property
    def busy(self) -> bool:
        """Whether photos are being made ready."""
        return self._task is not None

    def prepare(self, folder: Path, photos: PhotoSet, proposed: Mapping[ViewId, ViewPoints]) -> None:
        """Make the photos of a visitor ready in the background; :attr:`changed` follows."""
        self.forget()
        task = Task(lambda progress: ready_outlines(folder, photos, proposed, progress))
        self._task = task
        task.succeeded.connect(self.take)
        task.start()

    def take(self, ready: Outlines) -> None:
        """Use outlines from now on."""
        if self.sender() in (None, self._task):
            self._task = None
            self._ready, self._steps = ready, {}
            self.changed.emit()

    def forget(self) -> None:
        """Let go of a visitor's photos; work under way ends by itself."""
        self._ready, self._steps = {}, {}
        if self._task is not None:
            self._task.cancel()
            self._task = None

    def borders(self, view: ViewId, corrections: Corrections) -> Borders:
        """Return the closed borders (M, 2) of a photo's outline through all corrected points; none before it is ready.

        Cost: some 12 ms for every point that moved since the last call.
        """
        outline = self._ready.get(view)
        if outline is None:
            return ()
        steps = follow_corrections(outline, self._steps.get(view, ()), corrections.points.get(view, {}))
        self._steps[view] = steps
        return steps[-1].contours_px if steps else outline.traced_px
