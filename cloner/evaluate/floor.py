"""The unavoidable work of a clone: decoding photos, running the nets, encoding pictures.

Masks, labels and everything after are not in it. Until 22 November 2026 it held the whole stage "proposals" instead of
the nets, and of the pictures only the atlas (and, in ``make bench``, the shells).
"""

from __future__ import annotations

from contextlib import suppress
from functools import partial
from pathlib import Path

import numpy as np
from PIL import Image

from cloner.detectors.face.frontal import frontal_face
from cloner.detectors.table import DETECTORS
from cloner.exporters.shared.files import jpeg_bytes, png_bytes
from cloner.generic.surfaces import load_surfaces
from cloner.parallel import parallel_map
from cloner.previews import FOLDER
from cloner.records.clones import Clone
from cloner.records.photos import Photo, PhotoSet
from cloner.stages.figures import NobodySeen, check_people


def ask_nets(photos: PhotoSet) -> None:
    """Ask the nets about every photo, two at a time as the stage "proposals" does, and let them go.

    Raises
    ------
    ClonerError
        If a photo shows more than one person.
    """

    def ask(photo: Photo) -> None:
        with suppress(NobodySeen):  # a photo that the clone was made without
            check_people(photo)
        DETECTORS.get("pose")(photo.rgb)
        frontal_face(photo)

    for _ in parallel_map(ask, photos.photos.values()):
        pass
    DETECTORS.get("release_nets")()


def encode_pictures(clone: Clone, folder: Path) -> int:
    """Encode every picture that is delivered once, two at a time, and return the bytes.

    Parameters
    ----------
    clone : Clone
        Atlas, shells and lashes, for exports and for the clone's own file.
    folder : Path
        The clone's, for its previews.
    """
    kept = [clone.atlas.rgb, clone.atlas.coverage, *(shell.rgba for shell in clone.shells)]
    kept += [surface.rgba for surface in load_surfaces() if surface.rgba is not None]
    shown = [clone.atlas.rgb, *(np.asarray(Image.open(path)) for path in sorted((folder / FOLDER).glob("*.jpg")))]
    jobs = [*(partial(png_bytes, pixels) for pixels in kept), *(partial(jpeg_bytes, pixels) for pixels in shown)]
    return sum(parallel_map(lambda job: len(job()), jobs))
