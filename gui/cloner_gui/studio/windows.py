"""The studio's windows by name."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from typing import Final

from cloner_gui.studio.bench import Bench
from cloner_gui.studio.blobs import BlobsWindow
from cloner_gui.studio.bodies import BodiesWindow
from cloner_gui.studio.photograph import PhotographWindow
from cloner_gui.studio.statues import StoneWindow
from cloner_gui.studio.wearing import WearingWindow

_WINDOWS: Final[Mapping[str, Callable[..., Bench]]] = {
    "wearing": WearingWindow,
    "bodies": BodiesWindow,
    "stone": StoneWindow,
    "photograph": PhotographWindow,
    "blobs": BlobsWindow,
}


def window_of(which: str) -> Callable[..., Bench]:
    """Return the constructor of a window, which takes the booth and the parent."""
    return _WINDOWS[which]
