"""Inner tensors come out of a net, and what it gave before is untouched."""

from __future__ import annotations

from importlib.resources import files

import numpy as np
import pytest
from ai_edge_litert.interpreter import Interpreter

from cloner.detectors.nets.inner_tensors import with_outputs


def run(model: bytes, image: np.ndarray) -> list[np.ndarray]:
    net = Interpreter(model_content=model, num_threads=1)
    net.allocate_tensors()
    net.set_tensor(net.get_input_details()[0]["index"], image)
    net.invoke()
    return [net.get_tensor(detail["index"]) for detail in net.get_output_details()]


def test_more_outputs_same_answers() -> None:
    model = (files("cloner_models") / "nets" / "selfie_segmentation.tflite").read_bytes()
    image = np.random.default_rng(1).random((1, 256, 256, 3), dtype=np.float32)
    before, after = run(model, image), run(with_outputs(model, (25, 48, 91)), image)
    assert len(after) == len(before) + 3
    for old, new in zip(before, after, strict=False):
        assert np.array_equal(old, new)
    # sides and channels as the net's own description gives them
    assert [out.shape[1:] for out in after[len(before) :]] == [(64, 64, 16), (32, 32, 24), (16, 16, 32)]


def test_what_is_no_model_is_refused() -> None:
    with pytest.raises(ValueError, match="no field"):
        with_outputs(b"\x10\x00\x00\x00" + bytes(60), (1,))
