"""What a host tells the walkers' core, kept so that another host tells it the same: Python writes, a page repeats."""

from __future__ import annotations

import base64
import json
import subprocess
from pathlib import Path
from typing import Any

import numpy as np

from cloner.behaviour.core.host import ARRAYS, MODULE
from cloner.behaviour.ground import Ground
from cloner.behaviour.walking import Bodies

PLAYER = Path(__file__).with_name("core_player.js")
#: Rows that a host may set; the core alone writes the others.
TOLD = ("place", "velocity", "way", "wants", "radius", "target", "facing", "look", "goal", "present", "avoids",
        "spotted", "settled", "wanders", "looks", "direct", "slow")  # fmt: skip
TABLES = ("clear", "walls", "near", "fields", "regions")


class CoreLog:
    """Watches a core from now on: keeps how it is, and before each step what was changed in its rows."""

    def __init__(self, bodies: Bodies, ground: Ground, *, places: int, seed: int = 0, period_m: float = 0.0) -> None:
        rows, cols, reach = ground.near.shape
        self.core, self.steps, self._step = bodies.core, 0, bodies.core.step
        self.begin = [len(bodies.place), rows, cols, len(ground.walls), reach, places, *ground.low.tolist(), period_m]
        self.seed, self.changes = str(seed), []  # type: tuple[str, list[list[Any]]]
        self.first = {name: self.core.arrays[name].copy() for name in TOLD}
        self.before = {name: rows.copy() for name, rows in self.first.items()}
        setattr(self.core, "step", self.step)  # noqa: B010  # as a method of this instance

    def step(self) -> None:
        """Keep what changed since the last step, and let the next pass."""
        for name in TOLD:
            now, before = self.core.arrays[name].ravel(), self.before[name].ravel()
            for k in np.flatnonzero(now != before):
                self.changes.append([self.steps, name, int(k), now[k].item()])
        self._step()
        self.steps += 1
        self.before = {name: self.core.arrays[name].copy() for name in TOLD}

    def written(self, every: int) -> str:
        """Return all as JSON, with how often, in steps, a player shall keep the places."""
        arrays = {name: self.core.arrays[name] for name in TABLES} | self.first
        return json.dumps({
            "module": base64.b64encode(MODULE.read_bytes()).decode(),
            "kinds": {name: [number, kind] for number, (name, kind, _) in enumerate(ARRAYS)},
            "begin": self.begin, "seed": self.seed, "steps": self.steps, "every": every, "changes": self.changes,
            "arrays": {name: base64.b64encode(rows.tobytes()).decode() for name, rows in arrays.items()},
        })  # fmt: skip


def page(log: str) -> str:
    """Return a page that plays a log when `play(LOG)` is asked for."""
    script = PLAYER.read_text(encoding="utf-8")
    return f"<!doctype html><meta charset=utf-8><script>{script}\nconst LOG = {log};</script>"


def in_node(log: str, folder: Path) -> dict[str, Any]:
    """Return what node's player tells of a log."""
    run = folder / "play.js"
    script = PLAYER.read_text(encoding="utf-8")
    run.write_text(f"{script}\nplay({log}).then((told) => console.log(JSON.stringify(told)));", encoding="utf-8")
    return dict(json.loads(subprocess.run(["node", run], capture_output=True, text=True, check=True).stdout))


def kept_places(told: dict[str, Any]) -> list[bytes]:
    """Return the places that a player kept, each as float64 bytes."""
    return [base64.b64decode(one) for one in told["places"]]
