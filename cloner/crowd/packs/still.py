"""A still or a film of a pack without a browser, with the same tiers and shaders."""

from __future__ import annotations

import re
from collections.abc import Iterator
from pathlib import Path
from typing import Any, Final

import numpy as np
from numpy.typing import NDArray
from PIL import Image

from cloner.crowd.drawing.theatre import CrowdRenderer
from cloner.crowd.packs.files import MARK
from cloner.crowd.packs.held import film_tokens
from cloner.crowd.packs.reading import read_acted, read_casting, read_facts, read_room, read_spoken, read_stock
from cloner.crowd.staged.daylight import CAST_PX, DAY, RoomLight, room_values
from cloner.crowd.staged.eye import CrowdCamera
from cloner.crowd.staged.faces import SpeechTrack, faces_values
from cloner.crowd.staged.footing import GONE, Acted, feelings_at, people_at
from cloner.crowd.staged.rooms import LitRoom, people_light
from cloner.crowd.staged.scene import ACTED, SCENES, Scene, make_scene, places_at
from cloner.crowd.staged.staging import UP, Staging, add_caption, read_staging
from cloner.errors import ClonerError
from cloner.project.atomic import atomic_file
from cloner.vision.photographs.films import FORMATS, png_text, write_film

Pixels = NDArray[np.uint8]

#: Where the eye stands and looks in each view of each scene, metres; the player's own.
VIEWS: Final = {
    "plaza": ((0.0, 9.0, 34.0), (0.0, 1.0, 0.0)),
    "walk": ((0.0, 6.0, 18.0), (0.0, 1.0, -6.0)),
    "stadium": ((0.0, 9.0, 22.0), (0.0, 4.0, -30.0)),
    "near": ((1.2, 1.7, 10.5), (0.0, 1.2, 5.0)),
    "street": ((0.0, 1.7, 12.0), (0.0, 1.4, -10.0)),
}
_SCENE_OF: Final = {"near": "plaza", "street": "walk"}
FIELD_DEG: Final = 45.0
SAMPLES: Final = 4
STATURE_M: Final = 1.75
SKY: Final = (0.8, 0.84, 0.88, 1.0)
FILM_S: Final = 4.0  # taste
FRAMES_PER_S: Final = 25.0
DOLLY_M: Final = 6.0  # towards the crowd over a film: everybody in the middle passes the switch
STARTED_S: Final = 3.0
LARGEST_PX: Final = 4096


def is_pack(path: Path) -> bool:
    """Return whether a folder is a crowd's pack."""
    return (path / MARK).is_file()


def draw_pack(pack: Path, view: str, out: Path, size: str) -> None:
    """Draw a crowd into a PNG file, or a film whose suffix says the format.

    Parameters
    ----------
    pack : Path
    view : str
        plaza, walk, stadium, near or street.
    out : Path
    size : str
        "WIDTHxHEIGHT" in pixels.

    Raises
    ------
    ClonerError
        If the pack, view or size is no good, this machine cannot draw, or ``out`` cannot be written.
    """
    facts = read_facts(pack)
    view = str(facts["scene"]) if view == "front" else view  # what cloner render asks for unless told
    views = VIEWS | ({ACTED: facts["acted"]["views"]["overview"]} if "acted" in facts else {})
    if view not in views:
        raise ClonerError(f"{view!r} is no view of a crowd", f"Choose one of {', '.join(views)}", "--view")
    match = re.fullmatch(r"(\d+)[x×](\d+)", size.strip().lower())
    width, height = (int(part) for part in match.groups()) if match else (0, 0)
    if not (16 <= width <= LARGEST_PX and 16 <= height <= LARGEST_PX):
        raise ClonerError(
            f"{size!r} is no size from 16x16 to {LARGEST_PX}x{LARGEST_PX}", "Write it like 1280x720", "--size"
        )
    name = _SCENE_OF.get(view, view)
    if name not in (*SCENES, ACTED):
        raise ClonerError(f"{name!r} is no scene", f"Choose one of {', '.join(SCENES)}", "--view")
    casting = read_casting(facts)
    made = read_acted(pack, facts) if name == ACTED else make_scene(name, int(facts["people_count"]), casting)
    theatre = CrowdRenderer(read_stock(pack, facts))
    try:
        staging = read_staging(facts) if name == ACTED else None
        painter = ScenePainter(
            theatre, facts, made, (width, height), read_room(pack, facts) if name == ACTED else None, staging,
            read_spoken(pack, facts) if name == ACTED else None,
        )  # fmt: skip
        with atomic_file(out) as temporary:
            if out.suffix.lower() in FORMATS:
                write_film(_film(painter, views[view]), FRAMES_PER_S, temporary, film_tokens(facts["people"]))
            else:
                shown = Image.fromarray(painter.picture(views[view], STARTED_S))
                shown.save(temporary, format="PNG", pnginfo=png_text(film_tokens(facts["people"])))
    finally:
        theatre.close()


def _film(painter: ScenePainter, view: tuple[Any, Any]) -> Iterator[Pixels]:
    place, target = (np.array(one) for one in view)
    ahead = (target - place) * (1.0, 0.0, 1.0)
    ahead = ahead / np.linalg.norm(ahead)
    count = round(FILM_S * FRAMES_PER_S)
    for k in range(count):
        moved = place + ahead * DOLLY_M * k / count
        yield painter.picture((tuple(moved), tuple(target)), STARTED_S + k / FRAMES_PER_S)


class ScenePainter:
    """Renders one scene of a pack at any time from any camera."""

    def __init__(
        self, theatre: CrowdRenderer, facts: dict[str, Any], made: Scene | Acted, size_px: tuple[int, int],
        room: LitRoom | None = None, staging: Staging | None = None, spoken: SpeechTrack | None = None,
    ) -> None:  # fmt: skip
        self._staging, self._spoken = staging, spoken
        self._room = room
        if room:
            theatre.send_room(room.looks, room.light, room.sun)
        self._theatre, self._facts, self._scene, self._size = theatre, facts, made, size_px
        if isinstance(made, Scene):
            theatre.send_people(made.rows)
        feelings = facts["faces"]["feelings"] if "faces" in facts and isinstance(made, Acted) else []
        names = [clip["name"] for clip in facts["people"][0]["clips"]]
        self._feelings = np.array([feelings.index(one) + 1 if one in feelings else 0 for one in names])

    def picture(
        self,
        view: tuple[Any, Any],
        now: float,
        mode: str = "hybrid",
        hour: RoomLight = DAY,
        field_deg: float = FIELD_DEG,
    ) -> Pixels:
        """Return the (H, W, 3) picture from an eye towards a target at a time, seconds.

        ``mode``: "hybrid", "levels" (no impostors) or "geometry" (the finest level alone).
        """
        focal = self._size[1] / 2.0 / np.tan(np.radians(field_deg) / 2.0)
        eye = CrowdCamera(np.array(view[0], float), np.array(view[1], float), self._size, float(focal))
        theatre = self._theatre
        target = theatre.target(self._size, 1, SAMPLES)
        values = {
            "clipFromWorld": eye.clip_from_world(), "eye": eye.place_m, "focalPx": eye.focal_px, "now": now,
            "laneLength": self._scene.lane_m if isinstance(self._scene, Scene) else 1.0,
            "classic": int(bool(self._facts["impostors"]["classic"])),
        }  # fmt: skip
        if "statues" in self._facts:
            values["stoneColour"] = tuple(self._facts["statues"]["colour"])
        if self._room:
            values |= room_values(self._room.probes, self._room.facts, eye, hour)
        values["faced"] = int(self._feelings.any())
        if self._spoken:
            values |= faces_values(*self._spoken.faces(now))
        chosen = self._tiers(eye, now, mode)
        if "shadowed" in values:
            seen = np.concatenate(chosen)
            theatre.cast(_instances(seen), {**values, "clipFromWorld": values["shadowFromWorld"]}, CAST_PX)
        theatre.begin(target, SKY)
        if self._room:
            theatre.draw_sky(values)
            theatre.draw_room(self._room.corners, values)
        if isinstance(self._scene, Acted):
            theatre.draw_blocks(self._scene.blocks, values)
        theatre.draw_ground(_instances(np.concatenate(chosen)), values)
        for level, who in enumerate(chosen[:-1]):
            theatre.draw_people(level, _instances(who), {**values, "coarse": int(level >= 2)})
        theatre.draw_impostors(_instances(chosen[-1]), values)
        return np.ascontiguousarray(theatre.read(target)[..., :3])

    def film_picture(self, now: float) -> Pixels:
        """Return the (H, W, 3) picture of a staged film at a time, seconds."""
        if self._staging is None or not isinstance(self._scene, Acted):
            raise ValueError("nothing is staged")
        eye, look, field_deg = self._staging.camera(self._staging.rows(self._scene, now), now)
        shown = self.picture((eye, look), now, hour=self._staging.hour(now), field_deg=field_deg)
        return add_caption(shown, self._staging.caption(now), self._staging.curtain(now))

    def _tiers(self, eye: CrowdCamera, now: float, mode: str) -> list[NDArray[np.int64]]:
        """Return who is drawn at each level, and last as an impostor."""
        if isinstance(self._scene, Scene):
            where, here = places_at(self._scene, now), None
        else:
            rows = self._staging.rows(self._scene, now) if self._staging else people_at(self._scene, now)
            self._theatre.send_people(rows)
            if self._feelings.any():
                felt = feelings_at(self._scene, now)
                felt[:, 0] = self._feelings[felt[:, 0].astype(int)]
                self._theatre.send_feels(felt)
            if self._room:
                self._theatre.send_glow(people_light(self._room.probes, rows))
            where, here = np.column_stack([rows[:, 0, 1], rows[:, 4, UP], rows[:, 0, 2]]), rows[:, 0, 0] < GONE
        away = np.linalg.norm(where + (0.0, 0.9, 0.0) - eye.place_m, axis=1)
        tiers = self._facts["tiers"]
        far = eye.focal_px * self._facts["switch"]["metres_per_focal_px"]
        limits = [min(eye.focal_px * STATURE_M / tier["largest_px"], far) for tier in tiers[1:]] + [far]
        if mode == "levels":
            limits[-1] = np.inf
        if mode == "geometry":
            limits = [np.inf] * len(limits)  # one that is lower behind a higher one would not be found
        level = np.searchsorted(np.array(limits), away, side="right")
        shown = np.ones(len(level), bool) if here is None else here
        return [np.flatnonzero((level == k) & shown) for k in range(len(tiers) + 1)]


def _instances(who: NDArray[np.int64]) -> NDArray[np.float32]:
    return np.column_stack([who, np.ones(len(who))]).astype(np.float32)
