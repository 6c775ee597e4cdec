"""The player page of a pack: one self-contained file."""

from __future__ import annotations

import base64
import importlib.resources
import json
from collections.abc import Mapping
from html import escape
from pathlib import Path
from typing import Any, Final

from cloner.crowd.drawing.shaders import page_shaders
from cloner.crowd.staged.rooms import ECHO_FILE, ROOM_FILES

#: The files of the pack that the page holds.
HELD: Final = ("numbers.bin", "colours.webp", "shapes.webp", "covers.webp", "atlas.webp", "codes.webp", "shell.webp")
#: And those of packs whose people can be statues.
STONES: Final = ("stone.webp", "stone_shell.webp")
#: And of those whose people can speak.
FACE_FILE: Final = "face.bin"
#: The body of all clones.
BODY_FILE: Final = "body.bin"
#: Footings of a pack that acts a scenario, numbers in line.
ACTED_FILE: Final = "acted.bin"
#: The beginning of a scenario that goes on in the page, numbers in line, and the engine that lets it.
MINDS_FILE: Final = "minds.bin"
ENGINE_FILE: Final = "engine.wasm"
#: Weights of faces that speak.
SPOKEN_FILE: Final = "spoken.bin"
_SCRIPTS: Final = (
    "scene.js",
    "stage.js",
    "blocks.js",
    "footing.js",
    "daylight.js",
    "room.js",
    "staging.js",
    "faces.js",
    "sound.js",
    "engine.js",
    "minds.js",
    "live.js",
    "player.js",
)
_POLICY: Final = (
    "default-src 'none'; script-src 'unsafe-inline'; style-src 'unsafe-inline'; img-src blob: data:; connect-src 'none'"
)
#: A page whose scenario goes on compiles its engine.
_GOING_POLICY: Final = _POLICY.replace("script-src 'unsafe-inline'", "script-src 'unsafe-inline' 'wasm-unsafe-eval'")
#: A page that is served may ask its own server, and nobody else.
_LIVE_POLICY: Final = _GOING_POLICY.replace("connect-src 'none'", "connect-src 'self'")


def player_page(folder: Path, facts: Mapping[str, Any]) -> bytes:
    """Return the page of a pack whose files lie in a folder.

    Parameters
    ----------
    folder : Path
    facts : mapping
        What ``crowd.json`` will hold; with ``live`` the page asks its server who comes (`web/live.js`).
    """
    web = importlib.resources.files("cloner.crowd") / "web"
    own = (*HELD, *(STONES if facts.get("statues") else ()), *((FACE_FILE,) if facts.get("faces") else ()))
    names = [BODY_FILE, *(f"people/{row['id']}/{name}" for row in facts["people"] for name in own)]
    if "acted" in facts:
        names.append(ACTED_FILE)
    goes_on = MINDS_FILE in facts["files"]
    if goes_on:
        names += [MINDS_FILE, ENGINE_FILE]
    if "spoken" in facts:
        names += [SPOKEN_FILE, *(one["sound"] for one in facts["spoken"]["said"] if one["sound"])]
    if "room" in facts:
        names += [one for one in (*ROOM_FILES, ECHO_FILE) if one in facts["files"]]
    held = "".join(
        f'<script type="application/octet-stream" data-file="{escape(name)}">'
        f"{base64.b64encode((folder / name).read_bytes()).decode('ascii')}</script>\n"
        for name in names
    )
    shaders = {name: (web / name).read_text(encoding="utf-8") for name in page_shaders()}
    shown = {key: value for key, value in facts.items() if key != "files"}
    page = (web / "player.html").read_text(encoding="utf-8")
    parts = {
        "POLICY": _LIVE_POLICY if facts.get("live") else _GOING_POLICY if goes_on else _POLICY,
        "STYLE": (web / "player.css").read_text(encoding="utf-8"),
        "FACTS": _inside_script({"facts": shown, "shaders": shaders}),
        "HELD": held,
        "THREE": (web / "three.crowd.min.js").read_text(encoding="utf-8"),
        "SCRIPTS": "\n".join((web / name).read_text(encoding="utf-8") for name in _SCRIPTS),
    }
    for key, value in parts.items():
        page = page.replace(f"@{key}@", value, 1)
    return page.encode("utf-8")


def _inside_script(value: Any) -> str:
    """Return JSON that cannot end the script element that contains it."""
    return json.dumps(value, sort_keys=True).replace("<", "\\u003c")
