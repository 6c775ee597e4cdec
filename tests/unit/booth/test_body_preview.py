"""What an operator sees while somebody is cloned: a body of the person's size that comes nearer to the person."""

from types import SimpleNamespace

import numpy as np
import pytest

from cloner.booth.body_preview import plain_clone, shape_after
from cloner.generic.load import load_generic
from cloner.render import standard_camera


def test_stages_that_change_the_body_give_its_shape_and_others_none():
    generic = load_generic()
    fitted = generic.shape(np.full(4, 0.7), 1.63)[0]
    values = {
        "phenotype": SimpleNamespace(coefficients=np.full(4, 0.7), stature_m=1.63),
        "body": SimpleNamespace(mesh=SimpleNamespace(vertices_m=fitted + 0.01)),
        "joined": SimpleNamespace(vertices_m=fitted + 0.02),
        "silhouettes": None,
    }
    first, fine, joined = (shape_after(step, values) for step in ("phenotype", "fine", "join"))
    assert np.ptp(first.vertices_m[:, 1]) == pytest.approx(1.63, abs=2e-3)
    assert np.allclose(fine.vertices_m, fitted + 0.01, atol=1e-6)
    assert np.allclose(joined.vertices_m, fitted + 0.02, atol=1e-6)
    assert first.vertices_m.nbytes < 400_000, "small enough to be sent while others wait"
    assert shape_after("silhouettes", values) is None


def test_a_shape_can_be_looked_at_like_a_clone():
    body = plain_clone(load_generic().shape(np.zeros(0), 1.7)[0].astype(np.float32))
    camera = standard_camera(body, "front", 200, 400)
    seen = camera.project(body.vertices_m)
    assert 0 < seen[:, 1].min() < 60
    assert 340 < seen[:, 1].max() < 400
