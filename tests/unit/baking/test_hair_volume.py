"""Hair that hangs on bare skin is where photos of all sides agree; one lost mask of two does not shave it."""

from dataclasses import dataclass
from types import SimpleNamespace

import numpy as np
import pytest

from cloner.baking.hair_volume import agreed_mm
from cloner.frames import ViewId


@dataclass
class Stand:
    """A photo that says the same of every point."""

    view: ViewId
    inside_mm: float
    before: bool = True
    flip_m: float | None = None

    @property
    def posed(self):
        return SimpleNamespace(view=self.view)

    def evidence(self, points_m):
        return np.full(len(points_m), self.inside_mm, np.float32), np.full(len(points_m), self.before)


FRONT, NEAR, SIDE, BACK = ViewId.BODY_FRONT, ViewId.FACE_FRONT, ViewId.BODY_SIDE, ViewId.BODY_BACK


@pytest.mark.parametrize(
    ("views", "hair"),
    [
        ([Stand(FRONT, 8.0), Stand(NEAR, -20.0), Stand(SIDE, 5.0)], True),  # the face photo's mask lost it
        ([Stand(FRONT, -8.0), Stand(NEAR, -20.0), Stand(SIDE, 5.0)], False),  # both fronts show none
        ([Stand(FRONT, 8.0), Stand(SIDE, -5.0), Stand(BACK, 9.0)], False),  # from the side there is none
        ([Stand(FRONT, 8.0), Stand(SIDE, -5.0, before=False), Stand(BACK, 9.0)], True),  # hidden from the side
        ([Stand(SIDE, 8.0), Stand(SIDE, -5.0, flip_m=0.0)], False),  # the other half is another side
        ([Stand(FRONT, 8.0, before=False)], False),  # nobody sees it
    ],
)
def test_each_side_of_the_person_has_one_voice(views, hair):
    found = agreed_mm(views, np.zeros((3, 3)))
    assert found.shape == (3,)
    assert np.all(found > 0.0) == hair
