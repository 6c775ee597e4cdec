"""People of the kit in clothes that it seldom draws: bare shoulders, tops of the skin's colour, tight clothes, hoods.

It shows bare shoulders on one person in a hundred, and a decoder taught by the kit alone takes real people's for a top;
taught by bare shoulders alone it takes tops of the skin's colour for skin. It never shows tight clothes, and a decoder
that never saw them takes a trunk under them for narrower than it is. One person in fifty wears a hood, and stripes on
a hood are now cloth, now a scarf. All four teach, as many of the one as of the others.
"""

from __future__ import annotations

from typing import Any

import numpy as np

#: Seeds from here on show bare shoulders, tops of the skin's colour, tight clothes, and covered heads; the kit's own
#: people have smaller ones.
FIRST_BARE_SEED, FIRST_SKIN_COLOURED_SEED, FIRST_TIGHT_SEED, FIRST_COVERED_SEED = 60000, 70000, 80000, 90000
#: Kinds of tops and how often each is worn.
KINDS = {"tank": 0.35, "straps": 0.2, "deep": 0.15, "strapless": 0.3}
#: Where a garment's colour comes from, as the kit names it, and how often.
COLOURS = {"any": 0.6, "dark": 0.2, "skin": 0.12, "hair": 0.08}
#: Kinds of tight tops, how often, and their hem, the range of their sleeves and their necks, as the kit measures them.
TIGHT_TOPS = {
    "tee": (0.3, 0.6, (0.15, 0.4), ("crew", "v", "scoop")), "tank": (0.22, 0.6, (0.0, 0.0), ("scoop", "crew")),
    "long": (0.2, 0.6, (0.8, 1.02), ("crew", "scoop")), "cropped": (0.13, 3.4, (0.0, 0.0), ("scoop", "crew")),
    "none": (0.15, 5.6, (0.0, 0.0), ("crew",)),
}  # fmt: skip
#: How far tight trousers go down the leg, and how often: briefs, trunks, shorts, leggings.
TIGHT_ENDS = {0.05: 0.15, 0.14: 0.15, 0.3: 0.2, 0.8: 0.15, 1.0: 0.35}
#: What covers a head, and how often; women alone wear the kit's headscarf.
COVERS = {"hood": 0.4, "headscarf": 0.3, "cap": 0.15, "beanie": 0.15}
#: Numbers of the kit's patterns that cross a head and its neck: stripes, plaid, dots, blotches, checks.
PATTERNS = (1, 1, 2, 3, 4, 5, 9)


def in_other_clothes(make_people: Any, person: dict[str, Any]) -> dict[str, Any]:
    """Return a drawn person of the kit in what the range of its seed wears."""
    if person["seed"] >= FIRST_COVERED_SEED:
        return covered(make_people, person)
    if person["seed"] >= FIRST_TIGHT_SEED:
        return tightly_dressed(make_people, person)
    if person["seed"] >= FIRST_SKIN_COLOURED_SEED:
        return skin_coloured(make_people, person)
    return bared(make_people, person) if person["seed"] >= FIRST_BARE_SEED else person


def one_of(rng: np.random.Generator, often: dict[Any, float]) -> Any:
    """Return one key, as often as its share of all."""
    shares = np.array(list(often.values()))
    return list(often)[int(rng.choice(len(shares), p=shares / shares.sum()))]


def shoes_of(outfit: dict[str, Any]) -> dict[str, Any]:
    """Return what an outfit of the kit tells of its shoes."""
    return {name: outfit[name] for name in ("shoes", "shoe_col", "shoe_recolour")}


def worn(make_people: Any, person: dict[str, Any], rng: np.random.Generator, **how: Any) -> dict[str, Any]:
    """Return a garment of a colour of its own, mostly plain, cut as told."""
    source = one_of(rng, COLOURS)
    colour = make_people.garment_colour(rng, source, person["_skin_col"], person["hair"]["col"])
    return {**make_people.fabric(rng, colour, 0.6, rng.random() < 0.2), **how}


def covered(make_people: Any, person: dict[str, Any]) -> dict[str, Any]:
    """Return a drawn person of the kit with a covered head, often in stripes, and often with a scarf."""
    rng = np.random.default_rng([person["seed"], 818])
    kind = one_of(rng, {k: share for k, share in COVERS.items() if k != "headscarf" or person["sex"] == "female"})
    accessories = {name: kept for name, kept in person["acc"].items() if name not in ("head", "scarf")}
    if kind == "hood":
        top = worn(make_people, person, rng, sleeve=1.02, neck="crew", nw=float(rng.uniform(0.4, 0.75)),
                   nd=float(rng.uniform(0.35, 0.9)), ndrop=0.0, strap=1.2, hem=float(rng.uniform(-0.35, 1.0)),
                   loose=float(rng.choice([0.2, 0.5, 1.0])), layer=1)  # fmt: skip
        low = worn(make_people, person, rng, end=float(rng.choice([0.45, 0.8, 1.0, 1.02])),
                   waist=float(rng.uniform(1.0, 1.9)), loose=float(rng.choice([0.0, 0.2, 0.5])), layer=0)  # fmt: skip
        shoes = shoes_of(person["outfit"])
        person["outfit"] = {"kind": "hoodie", "top": striped(top, rng), "low": low, "hood": "up", **shoes}
    else:
        cover = worn(make_people, person, rng, kind=kind, yf=float(rng.uniform(-0.06, 0.2)),
                     yb=float(rng.uniform(-0.5, -0.1)), brim=float(rng.uniform(0.5, 0.8)),
                     slouch=float(rng.uniform(0.0, 0.5)), back=bool(rng.random() < 0.15))  # fmt: skip
        accessories["head"] = striped(cover, rng)
    if rng.random() < 0.35 and "outer_collar" not in person["outfit"]:
        scarf = worn(make_people, person, rng, thick=float(rng.uniform(0.12, 0.3)), h=float(rng.uniform(0.0, 0.4)))
        accessories["scarf"] = striped(scarf, rng)
    person["acc"] = accessories
    return person


def striped(garment: dict[str, Any], rng: np.random.Generator) -> dict[str, Any]:
    """Return a garment, in two cases of five with stripes or another pattern of the kit."""
    if rng.random() < 0.4:
        garment["ptype"] = int(rng.choice(PATTERNS))
    return garment


def tightly_dressed(make_people: Any, person: dict[str, Any]) -> dict[str, Any]:
    """Return a drawn person of the kit in the closest clothes that it can draw, or in trunks alone.

    They lie on the kit's own suit, which adds 20 mm to an upper arm, 41 to the waist and 74 to the bust.
    """
    rng = np.random.default_rng([person["seed"], 717])
    other_sex_s = "none" if person["sex"] == "female" else "cropped"
    kind = one_of(rng, {name: often for name, (often, *_) in TIGHT_TOPS.items() if name != other_sex_s})
    _, hem, sleeves, necks = TIGHT_TOPS[kind]
    # Layers below the kit's first leave a millimetre or two between cloth and suit.
    top = worn(make_people, person, rng, sleeve=float(rng.uniform(*sleeves)), neck=str(rng.choice(necks)),
               nw=float(rng.uniform(0.4, 0.9)), nd=float(rng.uniform(0.35, 1.1)), ndrop=float(rng.uniform(-0.1, 0.1)),
               strap=float(rng.uniform(0.8, 1.4)), hem=hem + float(rng.uniform(-0.6, 0.6)), loose=0.0,
               layer=-0.6)  # fmt: skip
    if kind == "none":  # the kit wants a top: it gets a strip that lies within the body
        top.update(hem=hem, neck="crew", ndrop=0.0, layer=-8.0)
    end = one_of(rng, TIGHT_ENDS)
    low = worn(make_people, person, rng, end=end, waist=float(rng.uniform(0.9, 2.2)), loose=0.0, layer=-1.0)
    if rng.random() < 0.3 and kind != "none":  # a suit of one cloth
        low.update({name: top[name] for name in ("c1", "c2", "c3", "ptype", "scale", "angle", "ratio")})
    for garment in (top, low):
        garment["wrinkle"] *= float(rng.uniform(0.1, 0.8))
    shoes = shoes_of(person["outfit"])
    if rng.random() < 0.3:
        shoes["shoes"] = None
    person["outfit"] = {"kind": f"tight_{kind}", "top": top, "low": low, **shoes}
    person["acc"] = {name: kept for name, kept in person["acc"].items() if name != "scarf"}
    return person


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
    kind = one_of(rng, KINDS)
    width = float(rng.uniform(0.45, 0.95) if kind != "straps" else rng.uniform(0.8, 1.05))
    strap = float(width + (rng.uniform(0.15, 0.5) if kind != "straps" else rng.uniform(0.06, 0.15)))
    depth = float(rng.uniform(0.8, 1.5) if kind == "deep" else rng.uniform(0.35, 1.0))
    neck = {"strapless": "strapless", "deep": "v"}.get(kind, str(rng.choice(["scoop", "v", "scoop", "crew"])))
    top = worn(make_people, person, rng, sleeve=0.0, neck=neck, nw=width, nd=depth, strap=strap,
               ndrop=float(rng.uniform(-0.1, 0.25)), hem=float(rng.uniform(-0.35, 1.2)),
               loose=float(rng.choice([0.05, 0.3, 0.6])), layer=1)  # fmt: skip
    outfit = {"kind": kind, "top": top, **shoes_of(person["outfit"])}
    if person["sex"] == "female" and rng.random() < 0.4:
        outfit["skirt"] = {"end_y": float(rng.uniform(-6.8, -2.0)), "flare": float(rng.uniform(0.0, 0.5)),
                           "pleats": int(rng.integers(5, 16)), "same": True}  # fmt: skip
        top["hem"] = 0.6
    else:
        outfit["low"] = worn(make_people, person, rng, end=float(rng.choice([0.28, 0.45, 0.8, 1.0])),
                             waist=float(rng.uniform(1.0, 1.9)),
                             loose=float(rng.choice([0.0, 0.2, 0.5])), layer=0)  # fmt: skip
    person["acc"] = {name: kept for name, kept in person["acc"].items() if name != "scarf"}
    if person["acc"].get("head", {}).get("kind") == "headscarf":
        del person["acc"]["head"]  # it covers the shoulders
    person["outfit"] = outfit
    return person
