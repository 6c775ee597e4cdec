"""Where lookups in the side photo are doubted."""

from __future__ import annotations

import numpy as np
import pytest

from cloner.generic.load import GenericHuman, load_generic
from cloner.generic.photo_shares import arms_beside_head
from cloner.paint.lookups.zones import hair_kept, near_bare_head
from cloner.vision.retouching.matting import MattedPhoto

SIZE = 1000
PX_PER_M = 500.0


def side_plate(bare: np.ndarray) -> MattedPhoto:
    """Return a plate of which only the skin label counts."""
    nothing = np.zeros((SIZE, SIZE), bool)
    levels = np.zeros((SIZE, SIZE, 3), np.uint8)
    far = np.full((SIZE, SIZE), 100.0, np.float32)
    labels = bare.astype(np.uint8)
    grey = levels[..., 0]
    return MattedPhoto(levels, levels, far, labels, nothing, bare, grey, None, nothing, None, grey, nothing, 900.0)


@pytest.fixture(scope="module")
def generic() -> GenericHuman:
    return load_generic()


@pytest.fixture(scope="module")
def lookup_px(generic: GenericHuman) -> np.ndarray:
    """Where a side photo of the generic human shows every vertex."""
    return np.column_stack([500.0 + PX_PER_M * generic.vertices_m[:, 2], 950.0 - PX_PER_M * generic.vertices_m[:, 1]])


def test_a_sleeve_beside_the_arms_own_skin_is_painted(generic: GenericHuman, lookup_px: np.ndarray) -> None:
    upper = arms_beside_head(generic)
    elbow = lookup_px[upper, 1].max()
    bare = np.zeros((SIZE, SIZE), bool)
    bare[int(elbow) - 20 :] = True  # the short sleeve ends above the elbow
    assert not near_bare_head(generic, side_plate(bare), lookup_px)[upper].any()


def test_an_arm_looked_up_on_the_neck_is_not_painted(generic: GenericHuman, lookup_px: np.ndarray) -> None:
    neck = lookup_px[generic.region("neck"), 1].max()
    bare = np.zeros((SIZE, SIZE), bool)
    bare[: int(neck)] = True
    misjudged = lookup_px - [0.0, 100.0]  # the shoulder 20 cm too high
    misjudged[generic.region("neck")] = lookup_px[generic.region("neck")]
    upper = arms_beside_head(generic)
    top = upper & (misjudged[:, 1] < neck)
    assert top.any()
    assert near_bare_head(generic, side_plate(bare), misjudged)[top].all()


def test_hair_before_the_face_is_no_hairline(generic: GenericHuman) -> None:
    kept, face = hair_kept(generic), generic.region("face")
    inner = [generic.feature(name) for name in ("nose_tip", "lip_top", "eye_outer_L", "chin_front")]
    assert face[inner].all()
    assert not kept[inner].any()
    assert 0.05 < kept.sum() / face.sum() < 0.7  # the rim below the hairline
