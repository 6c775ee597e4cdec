"""The command ``cloner scene film``: a script, a lit room and a pack of clones become a film, pictures, or a page."""

from __future__ import annotations

import tempfile
from collections.abc import Iterator
from pathlib import Path
from typing import Any, Final

import numpy as np
from numpy.typing import NDArray
from PIL import Image

from cloner.acting.written import write_acted
from cloner.crowd.drawing.theatre import CrowdRenderer
from cloner.crowd.packs.held import film_tokens
from cloner.crowd.packs.reading import read_acted, read_facts, read_room, read_spoken, read_stock
from cloner.crowd.packs.still import ScenePainter
from cloner.crowd.staged.footing import Acted
from cloner.crowd.staged.staging import Staging, read_staging
from cloner.errors import ClonerError
from cloner.motion.face.sound import wav_bytes
from cloner.pipeline import Progress, no_progress
from cloner.project.atomic import atomic_file, result_folder, safe_output
from cloner.records.arrays import Array
from cloner.scenes.films.hearing import RATE_HZ, Ear, mix_stereo
from cloner.scenes.films.sequence import read_sequence
from cloner.scenes.films.staged import compile_film
from cloner.scenes.films.steps import footsteps
from cloner.scenes.films.voices import Voices, read_voices
from cloner.scenes.inhabited import add_sound, page_views, room_parts
from cloner.scenes.written import read_built_room, read_light, read_room_sound
from cloner.vision.photographs.films import FORMATS, png_text, write_film

Pixels = NDArray[np.uint8]

#: What is said, beside the pictures of a folder.
SOUND_FILE: Final = "sound.wav"
#: Pictures are named by so many digits.
DIGITS: Final = 5


def film_file(
    source: Path, room: Path, pack: Path, out: Path | None, page: Path | None, progress: Progress = no_progress
) -> list[str]:
    """Write a film, and a page that plays it; return a report.

    Parameters
    ----------
    source : Path
        The film's lines.
    room : Path
        What ``cloner scene light`` wrote.
    pack : Path
        What ``cloner crowd --feelings --statues`` wrote.
    out : Path or None
        A film (.mp4, .webp, .gif), or a folder that receives a PNG a picture.
    page : Path or None
        Folder that receives the pack whose page plays the film.
    progress : callable
        May raise Cancelled; no film is left then.

    Raises
    ------
    ClonerError
        If a line is not understood, the pack lacks what the film wants, or something cannot be read or written.
    """
    if out is None and page is None:
        raise ClonerError("nothing is to be written", "Give --out film.mp4 or --page FOLDER", source.name)
    film = read_sequence(source)
    if out is not None:
        safe_output(out)
    if page is not None and page.resolve() == pack.resolve():
        raise ClonerError("the pack would be replaced by what is made of it", "Choose another --page folder", page.name)
    facts = read_facts(pack)
    built = read_built_room(room)
    parts = add_sound(room_parts(built, *read_light(room), room.name), read_room_sound(room, built))
    if film.speeches and "faces" not in facts:
        hint = "Make it with cloner crowd --faces"
        raise ClonerError("nobody in the pack can speak", hint, "the film")
    said = read_voices(film, source.parent)
    acted, staging = compile_film(film, read_stock(pack, facts), facts["people"], progress)
    data = {"title": film.title, "seconds": film.seconds, "size_px": list(film.size_px), "rate_hz": film.rate_hz}
    lines = [
        f"{film.title or source.stem}: {film.seconds:g} s, {len(film.actors)} actors, {len(staging['shots'])} shots"
    ]
    with tempfile.TemporaryDirectory() as folder:
        staged = page if page is not None else Path(folder) / "staged"
        write_acted(
            pack, facts, staged, acted, film.seconds, page_views(built.plan), parts, staging | {"film": data},
            spoken=said[0] if said else None,
        )  # fmt: skip
        if out is not None:
            _draw(staged, out, said[1] if said else None, read_room_sound(room, built), progress)
    return [
        *lines,
        *([str(out)] if out is not None else []),
        *([str(page / "player.html")] if page is not None else []),
    ]


def _draw(
    pack: Path, out: Path, voices: Voices | None, echo: tuple[bytes, list[float]] | None, progress: Progress
) -> None:
    """Render a staged pack's film into a file, or into a folder of pictures, with its speech."""
    facts = read_facts(pack)
    data = facts["staging"]["film"]
    acted, staging = read_acted(pack, facts), read_staging(facts)
    sound = None
    if staging:
        sources = [*(voices.sources() if voices else ()), *footsteps(acted, staging, data["seconds"])]
        sound = mix_stereo(sources, data["seconds"], _ear(staging, acted), echo) if sources else None
    theatre = CrowdRenderer(read_stock(pack, facts))
    try:
        painter = ScenePainter(
            theatre, facts, acted, tuple(data["size_px"]), read_room(pack, facts), staging, read_spoken(pack, facts)
        )
        pictures = _pictures(painter, data, progress)
        if out.suffix.lower() in FORMATS:
            with atomic_file(out) as temporary:
                out.parent.mkdir(parents=True, exist_ok=True)
                write_film(pictures, data["rate_hz"], temporary, film_tokens(facts["people"]), sound, RATE_HZ)
        else:
            with result_folder(out.parent, out.name) as folder:
                for number, shown in enumerate(pictures, start=1):
                    Image.fromarray(shown).save(
                        folder / f"{number:0{DIGITS}}.png", pnginfo=png_text(film_tokens(facts["people"]))
                    )
                if sound is not None:
                    (folder / SOUND_FILE).write_bytes(wav_bytes(sound, RATE_HZ))
    finally:
        theatre.close()


def _ear(staging: Staging, acted: Acted) -> Ear:
    """Return functions of time: the camera's position and its right direction, and a person's head."""

    def ear(now: float, who: int) -> tuple[Array, Array, Array]:
        rows = staging.rows(acted, now)
        eye, look, _ = staging.camera(rows, now)
        ahead = np.subtract(look, eye)
        right = np.array([-ahead[2], 0.0, ahead[0]]) / max(float(np.hypot(ahead[0], ahead[2])), 1e-9)
        return np.array(eye), right, staging.head(rows, who)

    return ear


def _pictures(painter: ScenePainter, data: dict[str, Any], progress: Progress) -> Iterator[Pixels]:
    count = max(round(data["seconds"] * data["rate_hz"]), 1)
    for k in range(count):
        yield painter.film_picture(k / data["rate_hz"])
        progress("pictures", (k + 1) / count)
