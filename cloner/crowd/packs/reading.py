"""Reading of a pack: validated description, verified files, and the arrays for the shaders."""

from __future__ import annotations

import json
from dataclasses import replace
from pathlib import Path
from typing import Any, Final

import numpy as np

from cloner.crowd.clones.faces import face_wedges
from cloner.crowd.clones.levels import body_levels, read_budgets
from cloner.crowd.clones.stock import CloneArrays, CrowdArrays
from cloner.crowd.drawing.impostors import BakeSettings, with_tiles
from cloner.crowd.drawing.player import ACTED_FILE, FACE_FILE, SPOKEN_FILE, STONES
from cloner.crowd.packs.files import FORMAT, MARK, VERSION, decode_webp, digest, shell_from, tiles_from, unpack_arrays
from cloner.crowd.packs.told import find_invalid
from cloner.crowd.staged.faces import SpeechTrack, Utterance
from cloner.crowd.staged.footing import Acted, is_in_range
from cloner.crowd.staged.rooms import LIGHT_FILE, LOOKS_FILE, ROOM_FILE, SUN_FILE, LitRoom, Probes
from cloner.crowd.staged.scene import Casting
from cloner.errors import ClonerError, printable
from cloner.untrusted import read_untrusted

_AGAIN: Final = "Make the crowd again with cloner crowd"
#: Twenty clones' description has 60 kB, their largest file 2 MB: a hundred times that is no crowd.
LARGEST_FACTS_BYTES, LARGEST_FILE_BYTES = 20_000_000, 500_000_000
_TILES: Final = ("colours.webp", "shapes.webp", "covers.webp")


def read_facts(pack: Path) -> dict[str, Any]:
    """Return the contents of ``crowd.json``.

    Raises
    ------
    ClonerError
        If there is no pack, or it is broken or newer than this version.
    """
    try:
        facts = json.loads(read_untrusted(pack / MARK, LARGEST_FACTS_BYTES))
        if facts["format"] != FORMAT or not isinstance(facts["version"], int):
            raise ValueError("another program's")
    except OSError as error:
        raise ClonerError("there is no crowd", "Give the folder that cloner crowd wrote", pack.name) from error
    except (ValueError, LookupError, TypeError, RecursionError) as error:
        raise ClonerError("the crowd's description cannot be read", _AGAIN, MARK) from error
    if facts["version"] > VERSION:
        raise ClonerError("the crowd was made by a newer version", "Update Cloner", MARK)
    if facts["version"] < VERSION:
        raise ClonerError("the crowd was made by an older version and cannot be read", _AGAIN, MARK)
    if wrong := find_invalid(facts):
        raise ClonerError(f"the crowd's description cannot be read: {printable(wrong)} is unfit", _AGAIN, MARK)
    return dict(facts)


def read_stock(pack: Path, facts: dict[str, Any]) -> CrowdArrays:
    """Return a pack's clones with their impostors.

    Raises
    ------
    ClonerError
        If a file is missing or damaged.
    """
    body = body_levels(mouth="faces" in facts)
    numbers, rows, atlases, shells, tiles = [], [], [], [], []
    faces = []
    stones: dict[str, list[Any]] = {name: [] for name in (STONES if facts.get("statues") else ())}
    try:
        for row in facts["people"]:
            files = {
                name: read_checked(pack, f"people/{row['id']}/{name}", facts)
                for name in ("numbers.bin", "atlas.webp", "codes.webp", "shell.webp", *_TILES)
            }
            arrays = unpack_arrays(files["numbers.bin"], row["arrays"])
            numbers.append(CloneArrays(*(arrays[name] for name in ("vertices", "loose", "corners", "bones"))))
            rows.append(arrays["table"])
            atlases.append(np.dstack([decode_webp(files["atlas.webp"]), decode_webp(files["codes.webp"])[..., 0]]))
            shells.append(shell_from(files["shell.webp"]))
            tiles.append(tiles_from(files, arrays["tiles"]))
            for name, own in stones.items():
                own.append(decode_webp(read_checked(pack, f"people/{row['id']}/{name}", facts)))
            if "faces" in facts:
                data = read_checked(pack, f"people/{row['id']}/{FACE_FILE}", facts)
                faces.append(unpack_arrays(data, row["face"])["moves"])
                if faces[-1].shape[1] != len(face_wedges(body)):
                    raise ValueError("another body's face")
        elevations = tuple(float(np.radians(ring)) for ring in facts["impostors"]["rings_deg"])
        budgets = read_budgets(facts["numbers"]["loose"])
        held = CrowdArrays(body, budgets, tuple(numbers), np.stack(rows), np.stack(atlases), np.stack(shells))
        if stones:
            held = replace(held, stones=np.stack(stones[STONES[0]]), stone_shells=np.stack(stones[STONES[1]]))
        if faces:
            held = replace(held, faces=np.stack(faces))
        return with_tiles(held, tiles, BakeSettings(elevations=elevations))
    except (ValueError, LookupError, TypeError, OSError) as error:
        raise ClonerError("the crowd's files do not fit together", _AGAIN, pack.name) from error


def read_acted(pack: Path, facts: dict[str, Any]) -> Acted:
    """Return the actions of a pack's clones, if it was baked.

    Raises
    ------
    ClonerError
        If it acts nothing, or the file is missing, damaged or does not fit the clones.
    """
    if "acted" not in facts:
        raise ClonerError("the crowd acts no scenario", "Make one with cloner crowd bake", pack.name)
    try:
        acted = Acted(**unpack_arrays(read_checked(pack, ACTED_FILE, facts), facts["acted"]["arrays"]))
        if not is_in_range(acted, [len(row["clips"]) for row in facts["people"]]):
            raise ValueError("other clones")
    except (ValueError, LookupError, TypeError) as error:
        raise ClonerError("what the crowd acts does not fit it", "Bake it again", pack.name) from error
    return acted


def read_spoken(pack: Path, facts: dict[str, Any]) -> SpeechTrack | None:
    """Return the speech of a pack's film, None without speech.

    Raises
    ------
    ClonerError
        If the file is missing, damaged or does not fit.
    """
    if "spoken" not in facts:
        return None
    data = facts["spoken"]
    try:
        weights = unpack_arrays(read_checked(pack, SPOKEN_FILE, facts), data["arrays"])["weights"]
        said = tuple(Utterance(**{name: one[name] for name in Utterance.__slots__}) for one in data["said"])
        if not np.isfinite(weights).all() or any(one.first + one.frames > len(weights) for one in said):
            raise ValueError("another film's")
    except (ValueError, LookupError, TypeError) as error:
        raise ClonerError("what is said does not fit the film", "Make it again", pack.name) from error
    return SpeechTrack(weights, said)


def read_room(pack: Path, facts: dict[str, Any]) -> LitRoom | None:
    """Return the lit room of a pack, None if there is none.

    Raises
    ------
    ClonerError
        If a file is missing, damaged or does not fit the others.
    """
    if "room" not in facts:
        return None
    data = facts["room"]
    try:
        held = unpack_arrays(read_checked(pack, ROOM_FILE, facts), data["arrays"])
        looks, light, sun = (
            decode_webp(read_checked(pack, name, facts)) for name in (LOOKS_FILE, LIGHT_FILE, SUN_FILE)
        )
        shape = tuple(data["shape"])
        fits_in = sun.shape == light.shape and held["probes"].shape == (*shape, 3, 4) and held["sun"].shape == shape
        finite = all(np.isfinite(one).all() for one in held.values())
        if not (fits_in and finite and len(data["heights"]) == shape[0] and not looks.shape[0] % looks.shape[1]):
            raise ValueError("a room of odd shapes")
    except (ValueError, LookupError, TypeError, OSError) as error:
        raise ClonerError("the room's files do not fit together", "Build it again", pack.name) from error
    low, heights = np.array(data["low"], float), np.array(data["heights"], float)
    probes = Probes(low, heights, float(data["step"]), held["probes"], held["sun"])
    return LitRoom(held["corners"], looks, light, sun[..., 0], probes, data)


def read_checked(pack: Path, name: str, facts: dict[str, Any]) -> bytes:
    """Return a file's content if its digest matches.

    Raises
    ------
    ClonerError
        If it is missing or damaged.
    """
    try:
        data = read_untrusted(pack / name, LARGEST_FILE_BYTES)
    except OSError as error:
        raise ClonerError("a file of the crowd is missing", _AGAIN, name) from error
    if digest(data) != facts["files"].get(name):
        raise ClonerError("a file of the crowd is damaged", _AGAIN, name)
    return data


def read_casting(facts: dict[str, Any]) -> Casting:
    """Return the rules of who wears what."""
    data = facts["looks"]
    return Casting(data["clones"], data["palettes"], data["wardrobe"], data["own_share"], data["dyed_share"])
