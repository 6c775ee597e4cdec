"""People of the kit in tops that leave shoulders bare: tank tops, straps, deep necklines, strapless ones.

The kit dresses one person in a hundred so, and a decoder taught by the kit alone takes real people's bare shoulders for
a top.
"""

from __future__ import annotations

from typing import Any

import numpy as np

#: Seeds from here on wear such tops; the kit's own people have smaller ones.
FIRST_BARE_SEED = 60000
#: Kinds of tops and how often each is worn.
KINDS = {"tank": 0.35, "straps": 0.2, "deep": 0.15, "strapless": 0.3}
#: Where a garment's colour comes from, as the kit names it, and how often.
COLOURS = {"any": 0.6, "dark": 0.2, "skin": 0.12, "hair": 0.08}


def bared(make_people: Any, person: dict[str, Any]) -> dict[str, Any]:
    """Return a drawn person of the kit with bare shoulders; lengths in decimetres of the kit's base mesh."""
    rng = np.random.default_rng([person["seed"], 515])
    old = person["outfit"]

    def worn(**how: Any) -> dict[str, Any]:
        source = str(rng.choice(list(COLOURS), p=list(COLOURS.values())))
        colour = make_people.garment_colour(rng, source, person["_skin_col"], person["hair"]["col"])
        return {**make_people.fabric(rng, colour, 0.6, rng.random() < 0.2), **how}

    kind = str(rng.choice(list(KINDS), p=list(KINDS.values())))
    width = float(rng.uniform(0.45, 0.95) if kind != "straps" else rng.uniform(0.8, 1.05))
    strap = float(width + (rng.uniform(0.15, 0.5) if kind != "straps" else rng.uniform(0.06, 0.15)))
    depth = float(rng.uniform(0.8, 1.5) if kind == "deep" else rng.uniform(0.35, 1.0))
    neck = {"strapless": "strapless", "deep": "v"}.get(kind, str(rng.choice(["scoop", "v", "scoop", "crew"])))
    top = worn(sleeve=0.0, neck=neck, nw=width, nd=depth, ndrop=float(rng.uniform(-0.1, 0.25)), strap=strap,
               hem=float(rng.uniform(-0.35, 1.2)), loose=float(rng.choice([0.05, 0.3, 0.6])), layer=1)  # fmt: skip
    outfit = {"kind": kind, "top": top, **{name: old[name] for name in ("shoes", "shoe_col", "shoe_recolour")}}
    if person["sex"] == "female" and rng.random() < 0.4:
        outfit["skirt"] = {"end_y": float(rng.uniform(-6.8, -2.0)), "flare": float(rng.uniform(0.0, 0.5)),
                           "pleats": int(rng.integers(5, 16)), "same": True}  # fmt: skip
        top["hem"] = 0.6
    else:
        outfit["low"] = worn(end=float(rng.choice([0.28, 0.45, 0.8, 1.0])), waist=float(rng.uniform(1.0, 1.9)),
                             loose=float(rng.choice([0.0, 0.2, 0.5])), layer=0)  # fmt: skip
    person["acc"] = {name: kept for name, kept in person["acc"].items() if name != "scarf"}
    if person["acc"].get("head", {}).get("kind") == "headscarf":
        del person["acc"]["head"]  # it covers the shoulders
    person["outfit"] = outfit
    return person
