"""A beard hangs below all of its roots: the air between a chin's and those of the throat under it is beard too."""

from types import SimpleNamespace

import numpy as np

from cloner.frames import ViewId
from cloner.hair.shells.beard import depth_below_mm, nearest_views


def test_between_the_beard_of_a_chin_and_that_of_the_throat_below_it_hangs_beard():
    """Only what lay below the throat's counted, and a long beard had a hole from aside."""
    cap = np.full((9, 20, 9), -5.0, np.float32)
    cap[3:6, 15:17, 3:6] = 5.0  # the chin's
    cap[3:6, 2:4, 3:6] = 5.0  # the throat's
    hanging = depth_below_mm(cap) > 0.0
    assert hanging[4, 4:15, 4].all()
    assert hanging[4, :2, 4].all()
    assert not hanging[:, 17:].any()
    assert (depth_below_mm(np.full((3, 3, 3), -5.0, np.float32)) <= 0.0).all()


def test_photos_of_the_body_are_heard_where_no_photo_of_the_face_shows_the_beard():
    """In a small photo a beard ran into the hair beside it: the clone had a strap of beard to its shoulder."""
    seen = {view: SimpleNamespace(posed=SimpleNamespace(view=view)) for view in ViewId}
    front, side, face = (seen[view] for view in (ViewId.BODY_FRONT, ViewId.BODY_SIDE, ViewId.FACE_FRONT))
    assert nearest_views([front, side, face]) == [side, face]
    assert nearest_views([front, side, face, seen[ViewId.FACE_SIDE]]) == [face, seen[ViewId.FACE_SIDE]]
    assert nearest_views([front, side]) == [front, side]
