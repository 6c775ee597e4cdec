"""Clothes beside the fitted body hide hair behind them, as the body itself does."""

import numpy as np

from cloner.hair.volumes.pictures import extend_over_clothes

SHAPE = (20, 30)


def test_clothes_beside_a_body_are_as_deep_as_the_body_nearby():
    nearest = np.full(SHAPE, np.inf, np.float32)
    nearest[:, :8], nearest[:, 8:10] = 2.0, 2.5
    clothed = np.zeros((2 * SHAPE[0], 2 * SHAPE[1]), bool)
    clothed[:, 10:32] = True
    found = extend_over_clothes(nearest, clothed)
    np.testing.assert_array_equal(found[:, :10], nearest[:, :10])
    assert (found[:, 10:16] == 2.5).all()
    assert np.isinf(found[:, 16:]).all()


def test_nothing_is_hidden_where_neither_body_nor_clothes_are():
    nearest = np.full(SHAPE, np.inf, np.float32)
    assert np.isinf(extend_over_clothes(nearest, np.ones(SHAPE, bool))).all()
    nearest[5:9, 5:9] = 1.0
    np.testing.assert_array_equal(extend_over_clothes(nearest, np.zeros(SHAPE, bool)), nearest)
