"""Stamps of a result's input and digests of its output."""

from __future__ import annotations

import functools
import hashlib
import importlib.resources
import json
from collections.abc import Iterable, Mapping, Sequence
from importlib.resources.abc import Traversable
from pathlib import Path
from types import MappingProxyType
from typing import Any

import cloner
from cloner.project import corrections as corrections_json
from cloner.project.folder import PERSON_FILE, find_photos
from cloner.project.results import RESULT_MARK, file_digest
from cloner.project.texts import LARGEST_BYTES
from cloner.untrusted import read_untrusted


def input_stamp(photos_dir: Path, options: Mapping[str, Any]) -> dict[str, Any]:
    """Return everything that decides what a clone of the files of now looks like, as JSON values.

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
    photos = {str(view): file_digest(path) for view, path in find_photos(photos_dir).items()}
    return stamp_of(photos, beside_digests(photos_dir), options)


def stamp_of(photos: Mapping[str, str], beside: Mapping[str, str], options: Mapping[str, Any]) -> dict[str, Any]:
    """Return everything that decides what a clone looks like, as JSON values.

    Parameters
    ----------
    photos : mapping of str to str
        sha256 by view of the bytes that were decoded.
    beside : mapping of str to str
        As :func:`beside_digests`.
    options : mapping
        As in :func:`input_stamp`.
    """
    return {
        "cloner": cloner.__version__,
        "models": digest_of_models(),
        "photos": dict(photos),
        "beside": dict(beside),
        "options": dict(options),
    }


def beside_digests(photos_dir: Path) -> dict[str, str]:
    """Return the sha256 of the files beside the photos that count, by name."""
    beside = (PERSON_FILE, corrections_json.WHERE)
    return {name: file_digest(photos_dir / name) for name in beside if (photos_dir / name).is_file()}


def output_digests(folder: Path, files: Sequence[str]) -> dict[str, str]:
    """Return the sha256 of files below a folder, by relative path."""
    return {name: file_digest(folder / name) for name in sorted(files)}


def why_not_current(result: Path, stamp: Mapping[str, Any]) -> str:
    """Return why a result has to be made again, "" if it is complete, undamaged and of this very input."""
    try:
        report = json.loads(read_untrusted(result / RESULT_MARK, LARGEST_BYTES))
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


@functools.cache
def model_digests() -> Mapping[str, str]:
    """Return the sha256 of every shipped model file, by path inside ``cloner_models``; read once a process."""
    return MappingProxyType({name: hashlib.sha256(file.read_bytes()).hexdigest() for name, file in model_files()})


def digest_of_models() -> str:
    """Return one digest of all shipped models."""
    return hashlib.sha256(json.dumps(dict(model_digests()), sort_keys=True).encode()).hexdigest()


def photos_token(photos: Iterable[str]) -> str:
    """Return a token of the photos' digests for every output of a clone: enough to find it, not to identify anyone."""
    return hashlib.sha256(" ".join(sorted(photos)).encode()).hexdigest()[:32]


def stamp_text(seed: int, texture_size: int, photos: Iterable[str] = ()) -> str:
    """Return the stamp of every output: version, models, generic human, options of its looks, photos.

    ``photos`` are the digests of the photos, in any order.
    """
    generic = "".join(model_digests()[name] for name in ("body.npz", "head.npz"))
    return (
        f"Cloner {cloner.__version__}, models {digest_of_models()[:16]}, "
        f"generic {hashlib.sha256(generic.encode()).hexdigest()[:16]}, seed {seed}, texture {texture_size}, "
        f"photos {photos_token(photos)}"
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
