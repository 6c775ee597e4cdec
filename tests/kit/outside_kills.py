"""Kills `kit.outside_walk` at any moment and looks for everything that the window had held to be safe by then."""

from __future__ import annotations

import contextlib
import hashlib
import json
import os
import signal
import subprocess
import sys
import threading
import time
import urllib.request
from pathlib import Path

import numpy as np
from PIL import Image

from cloner.booth.events.event import Event, write_event
from cloner.booth.handover.takeaway import has_result
from cloner.booth.phone.parcel import FILES
from cloner.booth.phone.tickets import read_ticket
from cloner.booth.stage import result_of
from cloner.booth.visitors.person_file import person_facts
from cloner.frames import ViewId
from cloner.project.folder import read_corrections
from kit import outside_walk, walker


class World:
    """Event, camera and stick of one walk, and what was told of it."""

    def __init__(self, room: Path) -> None:
        self.event, self.camera, self.stick = (room / name for name in ("event", "camera", "stick"))
        for folder in (self.event, self.camera, self.stick):
            folder.mkdir(parents=True)
        write_event(self.event, Event(camera_folder=str(self.camera), phone=True))
        self.told: list[dict] = []
        self.dropped: dict[str, list[str]] = {}
        self.served = 0
        self._link = ""
        self._over = threading.Event()

    def run(self, kill_after_s: float | None) -> float:
        """Walk until the end, or until it is killed so long after it was ready; return the seconds it walked."""
        path = os.pathsep.join(sys.path)
        environment = {**os.environ, "QT_QPA_PLATFORM": "offscreen", "PYTHONPATH": path}
        command = [sys.executable, "-m", "kit.outside_walk", str(self.event), str(self.stick)]
        process = subprocess.Popen(command, stdout=subprocess.PIPE, text=True, env=environment)
        telephone = threading.Thread(target=self._call)
        telephone.start()
        cameras: list[threading.Thread] = []
        begun, killer = time.monotonic(), None
        try:
            for line in process.stdout:
                told = json.loads(line)
                self.told.append(told)
                if told["what"] == "ready":
                    begun = time.monotonic()
                    if kill_after_s is not None:
                        killer = threading.Timer(kill_after_s, lambda: process.send_signal(signal.SIGKILL))
                        killer.start()
                elif told["what"] == "agreed":
                    cameras.append(threading.Thread(target=self._drop, args=(told["visitor"],)))
                    cameras[-1].start()
                elif told["what"] == "link":
                    self._link = told["value"]
            code = process.wait()
            if kill_after_s is None and code != 0:
                raise RuntimeError(f"the walk ended with {code}")
        finally:
            self._over.set()
            for thread in (*cameras, telephone, *([killer] if killer else [])):
                thread.join()
        return time.monotonic() - begun

    def _drop(self, visitor: str) -> None:
        """Take photos as a camera does: a piece at a time under their own names."""
        known = self.dropped.setdefault(visitor, [])
        for number in range(outside_walk.PHOTOS_EACH):
            name = f"{visitor}_{walker.VIEWS[number]}.jpg"
            data = photo(f"{visitor}{number}")
            with (self.camera / name).open("wb") as file:
                for start in range(0, len(data), 2000):
                    file.write(data[start : start + 2000])
                    file.flush()
                    time.sleep(0.01)
            known.append(hashlib.sha256(data).hexdigest())
            time.sleep(0.1)

    def _call(self) -> None:
        """Load the page again and again, as a telephone does."""
        while not self._over.wait(0.05):
            if self._link:
                with contextlib.suppress(OSError):
                    urllib.request.urlopen(self._link + "clone.glb", timeout=5).read()
                    self.served += 1

    def doing(self) -> str:
        """Return what was told last."""
        return self.told[-1]["what"] if self.told else "start"


def photo(seed: str) -> bytes:
    """Return a photo that no other is the same as."""
    import io

    rng = np.random.default_rng(int(hashlib.sha256(seed.encode()).hexdigest()[:8], 16))
    file = io.BytesIO()
    Image.fromarray(rng.integers(0, 255, (120, 80, 3), dtype=np.uint8)).save(file, "JPEG", quality=90)
    return file.getvalue()


def lost(world: World) -> list[str]:
    """Return what is not there any more of all that was safe; call it after the event was opened again."""
    missing = []
    last: dict[tuple[str, str], object] = {(one["what"], one["visitor"]): one["value"] for one in world.told}
    for (what, visitor), value in last.items():
        if what != "ready" and not _is_there(world, what, world.event / visitor, value):
            missing.append(f"{visitor}: {what} {value}")
    for visitor, digests in world.dropped.items():
        gone = set(digests) - set(outside_walk.stored(world.event / visitor))
        missing += [f"{visitor}: a photo of the camera"] if gone else []
    missing += [f"{path.name}: half a copy" for path in world.stick.iterdir() if not _is_whole(path)]
    return missing


def _is_there(world: World, what: str, folder: Path, value: object) -> bool:
    if what == "new":
        return folder.is_dir()
    if what in ("name", "height", "agreed"):
        return person_facts(folder)[("name", "height", "agreed").index(what)] == value
    if what == "photos":
        return set(value) <= set(outside_walk.stored(folder))
    if what == "point":
        return read_corrections(folder).points[ViewId.BODY_FRONT]["nose_tip"].x_px >= value
    if what == "cloned":
        return has_result(result_of(folder))
    if what == "link":
        ticket = read_ticket(folder)
        same = ticket is not None and ticket.token in value
        return same and all((folder / "phone" / name).is_file() for name in FILES)
    if what == "copied":
        return (world.stick / folder.name / "clone.ply").is_file()
    return what == "copying"


def _is_whole(path: Path) -> bool:
    """Return whether a copy on the stick is whole; a hidden one has not its name yet."""
    return path.name.startswith(".") or ((path / "clone.ply").is_file() and (path / "clone.ply").stat().st_size > 1000)
