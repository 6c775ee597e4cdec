"""Hair of a drawn head is told from skin under light from aside; a bald crown is not taken for hair."""

from __future__ import annotations

from importlib.resources import files

import cv2
import numpy as np
import pytest

from cloner.vision.hair import HAIR, head_hair_labels

SIZE = (420, 360)


def drawn(hair_rgb: tuple[int, int, int], *, dark_side: float) -> tuple[np.ndarray, np.ndarray, np.ndarray, np.ndarray]:
    """Return picture, mask, mesh points and true hair of a head; light falls off across it to ``dark_side``."""
    with (files("cloner_models") / "nets" / "canonical_face.npz").open("rb") as stream:
        mesh = np.load(stream)["vertices_cm"].astype(np.float64)
    mesh_px = np.column_stack([180 + 9.0 * mesh[:, 0], 225 - 9.0 * mesh[:, 1]])
    rng = np.random.default_rng(0)
    head, hair, body = (np.zeros(SIZE, np.uint8) for _ in range(3))
    cv2.ellipse(head, (180, 210), (85, 125), 0, 0, 360, 1, -1)
    cv2.ellipse(hair, (180, 200), (92, 130), 0, 180, 360, 1, -1)
    hair[int(mesh_px[10, 1]) - 2 :] = 0
    cv2.rectangle(body, (140, 320), (220, 420), 1, -1)
    cv2.rectangle(body, (30, 390), (330, 420), 1, -1)
    picture = np.full((*SIZE, 3), 200.0)
    picture[body > 0] = (60, 90, 140)
    picture[head > 0] = (205, 160, 135)
    picture[hair > 0] = hair_rgb
    across = np.interp(np.arange(SIZE[1]), [110, 250], [1.0, dark_side])
    person = (head | hair | body) > 0
    picture = np.where(person[..., None], picture * across[None, :, None], picture) + rng.normal(0, 3, (*SIZE, 1))
    return np.clip(picture, 0, 255).astype(np.uint8), person.astype(np.float32), mesh_px, hair > 0


@pytest.mark.parametrize("dark_side", [1.0, 0.55])
@pytest.mark.parametrize("hair_rgb", [(45, 32, 25), (110, 75, 50)])
def test_hair_is_found_under_even_light_and_light_from_aside(hair_rgb, dark_side):
    rgb, mask, mesh, true = drawn(hair_rgb, dark_side=dark_side)
    found = head_hair_labels(rgb, mask, mesh, "face_front") == HAIR
    assert (found & true).sum() / (found | true).sum() > 0.8


@pytest.mark.parametrize("dark_side", [1.0, 0.6])
def test_a_bald_crown_is_skin(dark_side):
    rgb, mask, mesh, true = drawn((215, 170, 145), dark_side=dark_side)
    found = head_hair_labels(rgb, mask, mesh, "face_front") == HAIR
    assert found.sum() < 0.05 * true.sum()
