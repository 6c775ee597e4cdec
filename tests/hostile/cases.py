"""What a case of bad input is, and how the product reads each kind."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass
from pathlib import Path
from typing import Any

from cloner.motion.captures.bvh import read_bvh
from cloner.motion.face.faps import read_fap
from cloner.motion.face.sound import read_sound, resampled
from cloner.motion.face.speech import phoneme_visemes, read_phonemes
from cloner.personal_data.holdings import holdings
from cloner.picture import load_clone_at
from cloner.project.corrections import check_against, point_names
from cloner.project.folder import load_photos, read_corrections, read_person
from cloner.project.manifest import find_visitors, shard
from cloner.stages import proposals
from cloner.stages.photo_checks import check_photos


@dataclass(frozen=True, slots=True)
class Case:
    """One bad file or folder.

    Attributes
    ----------
    name : str
    kind : str
        Key of `READERS`.
    make : callable
        Makes it below an empty folder and returns the path that a person would give.
    words : str
        What must be said of it (regular expression); "" if it must be taken.
    hint : str
        A word of what to do.
    where : str
        The file, field or folder that must be named.
    command : bool
        Whether the whole command line is tried with it too.
    """

    name: str
    kind: str
    make: Callable[[Path], Path]
    words: str
    hint: str = ""
    where: str = ""
    command: bool = False


def file(name: str, content: bytes | str) -> Callable[[Path], Path]:
    """Return a maker of one file."""

    def make(folder: Path) -> Path:
        path = folder / name
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_bytes(content.encode("utf-8", "surrogateescape") if isinstance(content, str) else content)
        return path

    return make


def folder_with(name: str, content: bytes | str) -> Callable[[Path], Path]:
    """Return a maker of one file that gives its folder."""
    return lambda folder: file(f"visitor/{name}", content)(folder).parent


def _corrections(folder: Path) -> None:
    check_against(read_corrections(folder), load_photos(folder), point_names())


def _shown(folder: Path) -> None:
    photos = load_photos(folder)
    found = proposals.run(photos=photos, tick=lambda fraction: None)
    check_photos(found.values["proposals"], photos)  # type: ignore[arg-type]


READERS: Mapping[str, Callable[[Path], Any]] = {
    "photos": load_photos,
    "person": read_person,
    "corrections": _corrections,
    "shown": _shown,
    "visitors": find_visitors,
    "row": lambda path: load_photos(find_visitors(path)[0].photos),
    "shard": lambda path: shard(find_visitors(path), path.name),
    "held": lambda path: holdings(path, None),
    "bvh": read_bvh,
    "fap": read_fap,
    "wav": lambda path: resampled(*read_sound(path)),
    "phonemes": lambda path: phoneme_visemes(read_phonemes(path)),
    "clone": load_clone_at,
}

#: How the command line is given each kind; CLONE stands for a good clone, OUT for a place that is not there yet.
COMMANDS: Mapping[str, tuple[str, ...]] = {
    "photos": ("clone", "PATH", "--out", "OUT"),
    "person": ("clone", "PATH", "--out", "OUT"),
    "corrections": ("clone", "PATH", "--out", "OUT"),
    "shown": ("clone", "PATH", "--out", "OUT"),
    "visitors": ("batch", "PATH", "--out", "OUT"),
    "held": ("list", "--photos", "PATH"),
    "bvh": ("animate", "CLONE", "PATH", "--out", "OUT.glb"),
    "fap": ("animate", "CLONE", "PATH", "--out", "OUT.glb"),
    "wav": ("animate", "CLONE", "PATH", "--out", "OUT.glb"),
    "phonemes": ("animate", "CLONE", "PATH", "--out", "OUT.glb"),
    "clone": ("render", "PATH", "--out", "OUT.png"),
}
