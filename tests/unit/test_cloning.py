"""What a second run may take over from a first one."""

from __future__ import annotations

import numpy as np

from cloner.cloning import still_true
from cloner.frames import ViewId
from cloner.records.photos import Photo, PhotoSet


def photos(**digests: str) -> PhotoSet:
    blank = np.zeros((4, 4, 3), dtype=np.uint8)
    return PhotoSet({ViewId(view): Photo(ViewId(view), blank, None, digest, "") for view, digest in digests.items()})


def test_proposals_stay_while_the_files_stay() -> None:
    before = {"photos": photos(body_front="a", face_front="b"), "proposals": "found", "body_points": "old"}
    assert still_true(before, photos(body_front="a", face_front="b")) == {"proposals": "found"}
    assert still_true(before, photos(body_front="a", face_front="c")) == {}
    assert still_true(before, photos(body_front="a")) == {}
    assert still_true({"proposals": "found"}, photos(body_front="a")) == {}
    assert still_true({"photos": photos(body_front="a")}, photos(body_front="a")) == {}
