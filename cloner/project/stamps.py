"""What a result was made from, and whether it still is that: stamps of the input, digests of the output."""

from __future__ import annotations

import functools
import hashlib
import importlib.resources
import json
from collections.abc import Mapping, Sequence
from importlib.resources.abc import Traversable
from pathlib import Path
from types import MappingProxyType
from typing import Any, Final

import cloner
from cloner.project import corrections as corrections_json
from cloner.project.atomic import RESULT_MARK
from cloner.project.folder import PERSON_FILE, find_photos

_BLOCK: Final = 1 << 20


def input_stamp(photos_dir: Path, options: Mapping[str, Any]) -> dict[str, Any]:
    """Return everything that decides what a clone looks like, as JSON values.

    Parameters
    ----------
    photos_dir : Path
        Holds the photos, and optionally ``person.toml`` and ``corrections.json``.
    options : mapping
        Formats, seed, texture size and a height from outside; JSON values.

    Raises
    ------
    ClonerError
        If the folder holds no usable photos.
    """
    beside = (PERSON_FILE, corrections_json.WHERE)
    return {
        "cloner": cloner.__version__,
        "models": digest_of_models(),
        "photos": {str(view): file_digest(path) for view, path in find_photos(photos_dir).items()},
        "beside": {name: file_digest(photos_dir / name) for name in beside if (photos_dir / name).is_file()},
        "options": dict(options),
    }


def output_digests(folder: Path, files: Sequence[str]) -> dict[str, str]:
    """Return the sha256 of files below a folder, by relative path."""
    return {name: file_digest(folder / name) for name in sorted(files)}


def why_not_current(result: Path, stamp: Mapping[str, Any]) -> str:
    """Return why a result has to be made again, "" if it is complete, undamaged and of this very input."""
    try:
        report = json.loads((result / RESULT_MARK).read_text(encoding="utf-8"))
        stored, outputs = dict(report["stamp"]), dict(report["outputs"])
    except (OSError, ValueError, KeyError, TypeError, RecursionError):
        return "there is no complete result"
    if stored != json.loads(json.dumps(stamp)):
        changed = [name for name in stamp if stored.get(name) != stamp[name]]
        return f"{' and '.join(changed)} changed since"
    for name, digest in outputs.items():
        path = result / name
        if not path.is_file() or file_digest(path) != digest:
            return f"{name} is missing or damaged"
    return ""


def file_digest(path: Path) -> str:
    """Return the sha256 of a file."""
    digest = hashlib.sha256()
    with path.open("rb") as stream:
        while block := stream.read(_BLOCK):
            digest.update(block)
    return digest.hexdigest()


@functools.cache
def model_digests() -> Mapping[str, str]:
    """Return the sha256 of every shipped model file, by path inside ``cloner_models``; read once a process."""
    return MappingProxyType({name: hashlib.sha256(file.read_bytes()).hexdigest() for name, file in model_files()})


def digest_of_models() -> str:
    """Return one digest of all shipped models."""
    return hashlib.sha256(json.dumps(dict(model_digests()), sort_keys=True).encode()).hexdigest()


def stamp_text(seed: int, texture_size: int) -> str:
    """Return what every output says of how it was made: version, models, generic human, and options of its looks."""
    generic = "".join(model_digests()[name] for name in ("body.npz", "head.npz"))
    return (
        f"Cloner {cloner.__version__}, models {digest_of_models()[:16]}, "
        f"generic {hashlib.sha256(generic.encode()).hexdigest()[:16]}, seed {seed}, texture {texture_size}"
    )


def model_files() -> list[tuple[str, Traversable]]:
    """Return the shipped model files, by path inside ``cloner_models``."""
    root = importlib.resources.files("cloner_models")
    folders = (("", root), ("nets/", root / "nets"))
    return [
        (prefix + file.name, file)
        for prefix, folder in folders
        for file in sorted(folder.iterdir(), key=lambda file: file.name)
        if file.name.endswith((".npz", ".tflite"))
    ]
