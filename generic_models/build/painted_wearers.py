"""Random people photographed in skirts, open coats and with bags over their other clothes."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
from painted_garments import EASE_M, Garment, Kind, make_garment
from painted_people import AZIMUTH_DEG, SIZE_PX, KnownPerson, take
from painted_people_bodies import naked_girths_mm, random_body, random_rotations
from painted_people_clothes import Dressed, dress
from painted_people_pictures import Background
from painted_people_wardrobe import CLOTH, random_wardrobe
from scipy.sparse import csr_matrix, vstack

from cloner.generic.load import load_generic


def wear(dressed: Dressed, garment: Garment) -> Dressed:
    """Return the dressed person with a garment over the other clothes."""
    count = len(dressed.vertices_m)
    return replace(
        dressed,
        vertices_m=np.vstack([dressed.vertices_m, garment.vertices_m]),
        triangles=np.vstack([dressed.triangles, garment.triangles + count]),
        kind=np.concatenate([dressed.kind, np.full(len(garment.vertices_m), CLOTH, np.int8)]),
        colours=np.vstack([dressed.colours, garment.colours]),
        carry=csr_matrix(vstack([dressed.carry, garment.carry])),
    )


def photograph_wearer(
    seed: int, kind: Kind, *, background: Background = "plain", size_px: tuple[int, int] = SIZE_PX
) -> tuple[KnownPerson, Garment]:
    """Return a random person in a loose garment, with three body photos and a held-out one, and the garment."""
    generic = load_generic()
    body = random_body(generic, np.random.default_rng([seed, 0]))
    rng = np.random.default_rng([seed, 1])
    wardrobe = random_wardrobe("tight", rng)
    if kind.endswith("skirt"):
        wardrobe = replace(wardrobe, leg=0.12)
    garment = make_garment(generic, body.vertices_m, body.joints_m, kind, rng, ease_m=EASE_M + wardrobe.shirt_m)
    dressed = wear(dress(body, wardrobe, rng), garment)
    side, exif = str(rng.choice(["left", "right"])), bool(rng.random() < 0.5)
    poses = {name: random_rotations(generic, body.joints_m, rng) for name in list(AZIMUTH_DEG)[:3]}
    poses["body_three_quarter"] = poses["body_front"]
    shots = {}
    for number, (name, azimuth) in enumerate(AZIMUTH_DEG.items()):
        turned = azimuth if side == "left" or name != "body_side" else -azimuth
        own = np.random.default_rng([seed, 10 + number])
        shots[name] = take(
            name, body, dressed, poses[name], turned + own.uniform(-4, 4), background, size_px, own, seed
        )
    return KnownPerson(seed, body, naked_girths_mm(body), dressed, background, exif, side, shots), garment
