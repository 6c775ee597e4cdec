"""The baseline: the generic human, scaled to the stature, in one plain colour."""

from __future__ import annotations

from typing import Final

import numpy as np

from cloner.generic.load import GenericHuman
from cloner.records.clones import Clone, TextureAtlas

#: A middle skin tone, sRGB; taste.
_PLAIN_RGB: Final = (190, 150, 128)
_ATLAS_PX: Final = 16


def generic_clone(generic: GenericHuman, stature_m: float) -> Clone:
    """Return the mean human at a stature as a clone without photographs.

    Parameters
    ----------
    generic : GenericHuman
    stature_m : float
        Barefoot stature, metres; the soles are bare and stand on y = 0.
    """
    vertices, joints = generic.shape(np.zeros(0), stature_m)
    rgb = np.full((_ATLAS_PX, _ATLAS_PX, 3), _PLAIN_RGB, dtype=np.uint8)
    return Clone(
        vertices_m=np.asarray(vertices, dtype=np.float64),
        joints_m=np.asarray(joints, dtype=np.float64),
        morph_names=(),
        morph_index=np.zeros(0, dtype=np.int32),
        morph_delta_m=np.zeros((0, 3), dtype=np.float32),
        morph_start=np.zeros(1, dtype=np.int32),
        atlas=TextureAtlas(rgb, np.zeros((_ATLAS_PX, _ATLAS_PX), dtype=np.uint8)),
        shells=(),
        features_m={name: vertices[generic.feature(name)] for name in generic.feature_names},
        views={},
        stature_m=stature_m,
        sole_m=0.0,
    )
