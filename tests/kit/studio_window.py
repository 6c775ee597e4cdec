"""What tests of the studio's windows share: its jobs on the caller's thread, clones from a tape, presses that wait."""

from PySide6.QtCore import Qt

from cloner.bodies.made import clone_of_measures
from cloner.booth.studio.jobs import StudioJobs
from cloner.project.clone_file import save_clone

#: Longest that a step of the studio takes on a machine with others at work, ms.
PATIENCE_MS = 60000
#: Side of the atlas of clones that are not looked at closely.
TEXELS = 512


class Studio:
    """The studio's jobs, one after the other where they are called, kept open like the window's own process."""

    def __init__(self):
        self._show = None
        self._jobs = StudioJobs(lambda value: self._show(value))

    def __call__(self, method, arguments, progress, show):
        self._show = show
        return getattr(self._jobs, method)(*arguments, progress=progress)


def tape_clone(folder, told):
    """Return a new folder with the clone of what a tape told."""
    folder.mkdir(parents=True)
    save_clone(clone_of_measures(told, TEXELS), folder / "clone.npz")
    return folder


def press(qtbot, button):
    """Click a button once it may be clicked."""
    qtbot.waitUntil(button.isEnabled, timeout=PATIENCE_MS)
    qtbot.mouseClick(button, Qt.MouseButton.LeftButton)
