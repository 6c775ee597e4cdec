"""Long jobs of the window, as one object in a worker process that caches the nets' results."""

from __future__ import annotations

import time
from collections import OrderedDict
from collections.abc import Callable, Mapping, Sequence
from pathlib import Path
from typing import Final, cast

from cloner import pipeline
from cloner.booth.body_preview import shape_after
from cloner.booth.handover.handing import hand_over
from cloner.booth.phone.parcel import pack
from cloner.booth.photos.photo_check import check_photo
from cloner.booth.photos.photo_files import placed_photos
from cloner.booth.photos.photo_problems import PhotoCheck
from cloner.booth.visitors.cached_work import PROPOSED_FILE, RESULTS, VALUES_FILE, WORK, cached_values, photo_digests
from cloner.booth.visitors.versions import keep_previous
from cloner.booth.walk_pictures import draw_walk_pictures
from cloner.booth.worker import ignore
from cloner.cloning import clone_folder
from cloner.errors import ClonerError
from cloner.frames import ViewId
from cloner.pipeline import Progress
from cloner.project.corrections import no_corrections
from cloner.project.folder import load_photo, safe_identifier
from cloner.project.values_file import save_values
from cloner.records.photos import PhotoSet
from cloner.records.proposals import Proposal
from cloner.stages.figures import NobodySeen
from cloner.stages.photo_checks import check_photos
from cloner.stages.proposals import propose, resolve_hidden

#: Proposals of so many photos are remembered: two visitors and some retakes, 4 MB each.
REMEMBERED: Final = 16
#: Values of a clone that lie elsewhere: photos and corrections as files, the clone as ``clone.npz``, how well it covers
#: the person in its report.
_ELSEWHERE: Final = {"photos", "person", "corrections", "painted", "surfaces", "clone", "agreements"}


class Jobs:
    """Requests to a worker process; every method takes a progress callable that may raise Cancelled.

    Parameters
    ----------
    show : callable
        Takes the `Shape` of the body after every stage of a clone that changes it.
    """

    def __init__(self, show: Callable[[object], None] = ignore) -> None:
        self._show = show
        self._proposals: OrderedDict[tuple[str, ViewId], Proposal] = OrderedDict()

    def check_photo(self, path: Path, wanted: ViewId | None, progress: Progress) -> PhotoCheck:
        """Return a photo's view and its problems; the nets' results are cached."""
        progress("look", 0.0)
        photo = load_photo(path, wanted or ViewId.BODY_FRONT)
        check, proposal = check_photo(photo, wanted)
        if proposal is not None:
            self._remember(photo.digest, proposal)
        return check

    def propose(self, folder: Path, progress: Progress) -> Path:
        """Propose the points of all photos of a visitor, store them in the work folder, and return the file.

        Raises
        ------
        ClonerError
            If a photo does not show one person as its name says.
        """
        progress("photos", 0.0)
        photos = _photos(folder)
        views: dict[ViewId, Proposal] = {}
        unseen: dict[ViewId, NobodySeen] = {}
        for view, photo in photos.photos.items():
            progress("proposals", len(views) / (1 + len(photos.photos)))
            known = self._proposals.get((photo.digest, view))
            try:
                views[view] = known if known is not None else propose(photo)
            except NobodySeen as error:
                unseen[view] = error
                continue
            self._remember(photo.digest, views[view])
        proposals = resolve_hidden(photos, views, unseen)
        check_photos(proposals, photos)
        stages = tuple(stage for stage in pipeline.STAGES if stage.name == "points")
        values: Mapping[str, object] = {
            "photos": photos,
            "proposals": proposals,
            "corrections": no_corrections(),
        }
        found, _ = pipeline.run(values, stages=stages)
        kept = {name: found[name] for name in ("proposals", "body_points", "face_points")}
        save_values(kept | {"digests": photo_digests(photos)}, folder / WORK / PROPOSED_FILE)
        return folder / WORK / PROPOSED_FILE

    def clone(self, folder: Path, formats: Sequence[str], progress: Progress) -> float:
        """Clone a visitor, cache what later clones and refits need, and return the seconds.

        Raises
        ------
        ClonerError
            If the visitor cannot be cloned.
        """
        start = time.monotonic()
        photos = _photos(folder)
        known = cached_values(folder, photos)
        with keep_previous(folder, safe_identifier(folder.name), photo_digests(photos)):
            outcome = clone_folder(
                folder, folder / RESULTS, formats=formats, known=known, progress=progress, found=self._found
            )
        values = outcome.values
        kept = {name: value for name, value in values.items() if name not in _ELSEWHERE}
        stamp = {"digests": photo_digests(cast(PhotoSet, values["photos"])), "person": values["person"]}
        save_values(kept | stamp, folder / WORK / VALUES_FILE)
        return time.monotonic() - start

    def hand_over(self, result: Path, target: Path, formats: Sequence[str], progress: Progress) -> Path:
        """Write the files for a visitor into a folder or a zip file: `cloner.booth.handover.handing.hand_over`."""
        return hand_over(result, target, formats, progress)

    def pack(self, folder: Path, result: Path, progress: Progress) -> Path:
        """Make what the page for phones shows of a visitor; see `cloner.booth.phone.parcel.pack`."""
        return pack(folder, result, progress)

    def draw_walk(self, folder: Path, result: Path, progress: Progress) -> Path:
        """Draw a visitor's walking clone for the visitors' screen; see
        `cloner.booth.walk_pictures.draw_walk_pictures`.
        """
        return draw_walk_pictures(folder, result, progress)

    def _found(self, step: str, values: Mapping[str, object]) -> None:
        shape = shape_after(step, values)
        if shape is not None:
            self._show(shape)

    def _remember(self, digest: str, proposal: Proposal) -> None:
        self._proposals[digest, proposal.view] = proposal
        self._proposals.move_to_end((digest, proposal.view))
        while len(self._proposals) > REMEMBERED:
            self._proposals.popitem(last=False)


def _photos(folder: Path) -> PhotoSet:
    """Return a visitor's photos, those that exist."""
    photos = placed_photos(folder)
    if not photos.photos:
        raise ClonerError("there is no photo yet", "Take the photos first", folder.name)
    return photos
