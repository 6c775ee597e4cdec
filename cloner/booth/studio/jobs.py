"""Long jobs of the studio, as one object in a worker process."""

from __future__ import annotations

from cloner.booth.studio.carving import Carving
from cloner.booth.studio.shaping import Shaping
from cloner.booth.studio.wearing import Wearing
from cloner.booth.worker import Show, ignore


class StudioJobs(Wearing, Shaping, Carving):
    """Requests to the studio's process; every method takes a progress callable that may raise Cancelled.

    Parameters
    ----------
    show : callable
        Takes what a job has to show so far.
    """

    def __init__(self, show: Show = ignore) -> None:
        Wearing.__init__(self, show)
        Shaping.__init__(self)
        Carving.__init__(self)
