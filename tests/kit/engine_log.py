"""A scenario's beginning and the orders on the way, for the engine in node and browsers to make the same steps."""

from __future__ import annotations

import base64
import json
import subprocess
from collections.abc import Sequence
from pathlib import Path
from typing import Any

from cloner.behaviour.beginning import initial_state
from cloner.behaviour.core.host import MODULE
from cloner.behaviour.world import World

WEB = Path(__file__).resolve().parents[2] / "cloner" / "crowd" / "web"
SCRIPTS = (WEB / "engine.js", Path(__file__).with_name("engine_player.js"))


def log_of(world: World, steps: int, every: int, orders: Sequence[tuple[int, Sequence[float]]] = ()) -> str:
    """Return a world that has made no step as JSON, with orders (step, row) and how often a player keeps the places."""
    told, tables = initial_state(world)
    return json.dumps({
        "module": base64.b64encode(MODULE.read_bytes()).decode(), "told": told, "steps": steps, "every": every,
        "orders": [[at, list(row)] for at, row in orders],
        "tables": {name: base64.b64encode(rows.tobytes()).decode() for name, rows in tables.items()},
    })  # fmt: skip


def page(log: str) -> str:
    """Return a page that plays a log when `play(LOG)` is asked for."""
    return f"<!doctype html><meta charset=utf-8><script>{_script()}\nconst LOG = {log};</script>"


def in_node(log: str, folder: Path) -> dict[str, Any]:
    """Return what node's player tells of a log."""
    run = folder / "play.js"
    run.write_text(f"{_script()}\nplay({log}).then((told) => console.log(JSON.stringify(told)));", encoding="utf-8")
    return dict(json.loads(subprocess.run(["node", run], capture_output=True, text=True, check=True).stdout))


def _script() -> str:
    return "\n".join(one.read_text(encoding="utf-8") for one in SCRIPTS)


def kept_places(told: dict[str, Any]) -> list[bytes]:
    """Return the places that a player kept, each as float64 bytes."""
    return [base64.b64decode(one) for one in told["places"]]
