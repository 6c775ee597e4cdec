"""Remaining traces of a visitor below some folders: copies, renamed photos, derived files, names in texts, packs.

Everything is looked at, hidden folders and what links lead to as well; nothing is changed.
"""

from __future__ import annotations

import hashlib
import json
import os
import re
import stat
import unicodedata
import zipfile
from collections.abc import Collection, Iterator, Mapping
from dataclasses import dataclass, field
from html import escape
from pathlib import Path
from typing import BinaryIO, Final
from urllib.parse import quote

from cloner.project.archives import BROKEN
from cloner.project.results import RESULT_MARK, read_manifest
from cloner.untrusted import open_untrusted

SHORTEST_NAME: Final = 3  # letters; shorter ones stand in every file
#: Files in which a name is a name; elsewhere the same letters stand by chance.
_TEXTS: Final = (
    ".json", ".csv", ".html", ".htm", ".toml", ".txt", ".log", ".wrl", ".x3d", ".gltf", ".md", ".obj", ".mtl", ".xml",
)  # fmt: skip
_BLOCK: Final = 1 << 20
_OVERLAP: Final = 512  # bytes: longer than any name, so that none is cut by a block's end
LARGEST_BYTES: Final = 2_000_000_000  # of a pack unpacked; larger ones are told by their name alone


@dataclass(frozen=True, slots=True)
class Traces:
    """What tells of a visitor.

    Attributes
    ----------
    digests : mapping of str to int or None
        sha256 of each of the visitor's files, and its size in bytes where known.
    names : collection of str
        Identifiers and the name of the person.
    tokens : collection of str
        What every output of a clone carries of its photos; see `cloner.project.stamps.photos_token`.
    anywhere, in_texts : tuple of bytes
        What to look for in every file, and what in texts only; made of the others.
    """

    digests: Mapping[str, int | None]
    names: Collection[str]
    tokens: Collection[str]
    anywhere: tuple[bytes, ...] = field(init=False)
    in_texts: tuple[bytes, ...] = field(init=False)

    def __post_init__(self) -> None:
        """Spell everything once: an event has thousands of files."""
        names = {one for name in self.names for one in _spellings(name)}
        object.__setattr__(self, "anywhere", tuple(one.encode() for one in self.tokens))
        object.__setattr__(self, "in_texts", (*names, *(one.encode() for one in self.digests)))


def _spellings(name: str) -> Iterator[bytes]:
    """Yield a name as texts write it: plain, composed and decomposed, escaped for JSON, HTML and addresses."""
    if len(name) < SHORTEST_NAME:
        return
    for form in ("NFC", "NFD"):
        text = unicodedata.normalize(form, name)
        for spelt in (text, json.dumps(text)[1:-1], escape(text), escape(text).replace("&#x27;", "&#39;"), quote(text)):
            yield spelt.encode("utf-8", "surrogateescape")
        numbered = "".join(one if ord(one) < 128 else f"&#{ord(one)};" for one in text)
        yield numbered.encode("utf-8", "surrogateescape")


def left_of(traces: Traces, roots: Collection[Path]) -> Iterator[str]:
    """Yield what below some folders tells of a visitor, by path relative to its root."""
    for root in roots:
        for path in _everything(root, traces):
            if tells(path, traces):
                yield path.relative_to(root).as_posix()


def _of_another(folder: Path, traces: Traces) -> set[Path]:
    """Return the files of another visitor's result, by its manifest."""
    manifest = read_manifest(folder) if (folder / RESULT_MARK).is_file() else None
    if manifest is None or not traces.digests.keys().isdisjoint(manifest.inputs.values()):
        return set()
    return {folder / name for name in manifest.outputs}


def _everything(root: Path, traces: Traces) -> Iterator[Path]:
    """Yield every file below a folder once, through links too, but what is listed as somebody else's."""
    seen: set[tuple[int, int]] = set()
    waiting, others = [root], set[Path]()
    while waiting:
        folder = waiting.pop()
        try:
            facts = folder.stat()
            inner = sorted(folder.iterdir(), reverse=True)
        except OSError:
            continue
        if (facts.st_dev, facts.st_ino) in seen:
            continue
        seen.add((facts.st_dev, facts.st_ino))
        others |= _of_another(folder, traces)
        waiting += [path for path in inner if _is(path, stat.S_ISDIR)]
        yield from (path for path in reversed(inner) if path not in others and _is(path, stat.S_ISREG))


def _is(path: Path, kind: object) -> bool:
    try:
        return bool(kind(path.stat().st_mode))  # type: ignore[operator]
    except OSError:
        return False


def tells(path: Path, traces: Traces) -> bool:
    """Return whether a file is one of a visitor's, was made of one, packs one, or speaks of the visitor."""
    if _named_after(path.name, traces.names):
        return True
    try:
        with open_untrusted(path) as stream:
            size = os.fstat(stream.fileno()).st_size
            return _content_tells(stream, path.suffix.lower(), size, traces) or _pack_tells(stream, traces)
    except OSError:
        return False  # nobody can read it: it is told of by whoever may


def _named_after(file: str, names: Collection[str]) -> bool:
    """Return whether a file's name holds one of the names as a word; "anna-2" is somebody else."""
    composed = unicodedata.normalize("NFC", file)
    return any(
        len(name) >= SHORTEST_NAME and re.search(rf"(?<![^\W_]){re.escape(name)}(?![^\W_])(?!-)", composed)
        for name in names
    )


def _content_tells(stream: BinaryIO, suffix: str, size: int, traces: Traces) -> bool:
    wanted = (*traces.anywhere, *traces.in_texts) if suffix in _TEXTS else traces.anywhere
    digest, tail = hashlib.sha256(), b""
    may_be_copy = size in traces.digests.values() or None in traces.digests.values()
    while block := stream.read(_BLOCK):
        if may_be_copy:
            digest.update(block)
        window = tail + block
        if any(one in window for one in wanted):
            return True
        tail = window[-_OVERLAP:]
    return may_be_copy and digest.hexdigest() in traces.digests


def _pack_tells(stream: BinaryIO, traces: Traces) -> bool:
    """Return whether a zip file (a pack, an .npz, a .usdz) holds anything that tells."""
    try:
        stream.seek(0)
        with zipfile.ZipFile(stream) as archive:
            parts = archive.infolist()
            if any(_named_after(piece, traces.names) for part in parts for piece in part.filename.split("/")):
                return True
            if sum(part.file_size for part in parts) > LARGEST_BYTES:
                return False
            for part in parts:
                with archive.open(part) as inner:
                    suffix = Path(part.filename).suffix.lower()
                    if _content_tells(inner, suffix, part.file_size, traces):  # type: ignore[arg-type]
                        return True
    except BROKEN:
        return False  # no pack
    return False
