"""Speech of a film: sound files become facial motion, and sound in the page and the film."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import asdict, dataclass
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from cloner.acting.written import SpokenParts
from cloner.crowd.clones.faces import TARGETS, WEIGHTS
from cloner.crowd.drawing.player import SPOKEN_FILE
from cloner.crowd.packs.files import pack_arrays
from cloner.crowd.staged.faces import MOST_AT_ONCE, MOST_SAID, Utterance
from cloner.crowd.staged.faces import RATE_HZ as FACES_HZ
from cloner.errors import ClonerError
from cloner.motion.face.sound import wav_bytes
from cloner.motion.face.talk import Speech, face_weights, speech_in
from cloner.records.arrays import Array
from cloner.scenes.films.hearing import Source, resample
from cloner.scenes.films.sequence import Sequence as Film


@dataclass(frozen=True, slots=True, eq=False)
class Voices:
    """Speech: who speaks when, and each one's sound (N,) at `RATE_HZ`, -1..1."""

    said: tuple[Utterance, ...]
    sounds: tuple[Array, ...]

    def sources(self) -> list[Source]:
        """Return its sound sources."""
        return [Source(one.when, one.who, sound) for one, sound in zip(self.said, self.sounds, strict=True)]


def read_voices(film: Film, folder: Path) -> tuple[SpokenParts, Voices] | None:
    """Return the speech of a film from files in a folder, for its pack and its sound; None without speech.

    Raises
    ------
    ClonerError
        If a file cannot be read, or too many speak at a time.
    """
    if not film.speeches:
        return None
    speeches = {name: speech_in(folder / name) for _, _, name in film.speeches}
    rows = {name: _rows(speech) for name, speech in speeches.items()}
    files = {name: f"speech/{number}.wav" for number, name in enumerate(speeches) if len(speeches[name].sound)}
    first = dict(zip(rows, np.cumsum([0, *(len(one) for one in rows.values())]).tolist(), strict=False))
    said = tuple(
        Utterance(who, when, first[name], len(rows[name]), files.get(name, ""))
        for when, actors, name in sorted(film.speeches, key=lambda one: one[0])
        for who in actors
    )
    _check_at_once(film, said)
    data, layout = pack_arrays({"weights": np.concatenate(list(rows.values()))})
    kept = {SPOKEN_FILE: data} | {
        file: wav_bytes(speeches[name].sound, speeches[name].rate_hz) for name, file in files.items()
    }
    sounds = {file: resample(speeches[name].sound, speeches[name].rate_hz) for name, file in files.items()}
    heard = tuple(sounds.get(one.sound, np.zeros(0)) for one in said)
    return SpokenParts(kept, {"arrays": layout, "said": [asdict(one) for one in said]}), Voices(said, heard)


def _rows(speech: Speech) -> NDArray[np.float32]:
    """Return the weights (F, WEIGHTS) of the speaker's face."""
    _, weights = face_weights(speech.shares)
    out = np.zeros((len(next(iter(weights.values()))), WEIGHTS), np.float32)
    for name, values in weights.items():
        if name in TARGETS:
            out[:, TARGETS.index(name)] = values
    return out


def _check_at_once(film: Film, said: Sequence[Utterance]) -> None:
    if len(said) > MOST_SAID:
        raise ClonerError(f"{len(said)} speeches are too many", f"Let at most {MOST_SAID} be said", "the film")
    ends = [one.when + (one.frames - 1) / FACES_HZ for one in said]
    for one in said:
        speak = [other for other, end in zip(said, ends, strict=True) if other.when <= one.when < end]
        if len(speak) > MOST_AT_ONCE:
            message = f"{len(speak)} speak at {one.when:g} s"
            raise ClonerError(message, f"Let at most {MOST_AT_ONCE} speak at a time", "the film")
        if sum(other.who == one.who for other in speak) > 1:
            message = f"{film.actors[one.who].name} is still speaking at {one.when:g} s"
            raise ClonerError(message, "Let one speech end before the next begins", "the film")
