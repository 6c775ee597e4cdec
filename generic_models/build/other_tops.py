"""People of the kit in tops that it seldom draws: such as leave shoulders bare, and such as have the skin's colour.

It shows bare shoulders on one person in a hundred, and a decoder taught by the kit alone takes real people's for a top;
taught by bare shoulders alone it takes tops of the skin's colour for skin. Both teach, as many of the one as of the
other.
"""

from __future__ import annotations

from typing import Any

import numpy as np

#: Seeds from here on show bare shoulders, and from here on tops of the skin's colour; the kit's own people have
#: smaller ones.
FIRST_BARE_SEED, FIRST_SKIN_COLOURED_SEED = 60000, 70000
#: Kinds of tops and how often each is worn.
KINDS = {"tank": 0.35, "straps": 0.2, "deep": 0.15, "strapless": 0.3}
#: Where a garment's colour comes from, as the kit names it, and how often.
COLOURS = {"any": 0.6, "dark": 0.2, "skin": 0.12, "hair": 0.08}


def in_other_tops(make_people: Any, person: dict[str, Any]) -> dict[str, Any]:
    """Return a drawn person of the kit in what the range of its seed wears."""
    if person["seed"] >= FIRST_SKIN_COLOURED_SEED:
        return skin_coloured(make_people, person)
    return bared(make_people, person) if person["seed"] >= FIRST_BARE_SEED else person


def skin_coloured(make_people: Any, person: dict[str, Any]) -> dict[str, Any]:
    """Return a drawn person of the kit with a top of about the skin's colour, mostly plain, often wrinkled."""
    rng = np.random.default_rng([person["seed"], 616])
    outfit = person["outfit"]
    suit = outfit.get("suit")
    garments = [suit["upper"]] if suit else [outfit["outer" if "outer" in outfit else "top"]]
    if rng.random() < 0.3:
        below = [suit["lower"]] if suit else [outfit[name] for name in ("low", "skirt") if name in outfit]
        garments += [garment for garment in below if "c1" in garment]
    colour = np.array(make_people.garment_colour(rng, "skin", person["_skin_col"]))
    for garment in garments:
        garment["c1"] = tuple(float(channel) for channel in colour * rng.uniform(0.9, 1.1))
        garment["ptype"] = 0 if rng.random() < 0.75 else 6  # plain, else a pattern of its own colour's shades
        garment["c2"] = tuple(float(channel) for channel in colour * rng.uniform(0.6, 1.3))
        garment["wrinkle"] *= rng.uniform(0.5, 2.0)
    if suit:
        suit["recolour"], suit["tone_keep"] = True, float(rng.uniform(0.7, 1.0))
    elif rng.random() < 0.7:
        outfit["top"]["sleeve"] = max(outfit["top"]["sleeve"], float(rng.uniform(0.2, 1.0)))
    return person


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
