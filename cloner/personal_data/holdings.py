"""Whose data is held below a root of photos and a folder of results.

Photos and results belong together by what a result's manifest says it was made from, whatever they are called.
"""

from __future__ import annotations

import contextlib
from collections import Counter
from collections.abc import Iterable, Sequence
from dataclasses import dataclass
from datetime import UTC, datetime
from pathlib import Path
from typing import Final

from cloner.crowd.packs.held import folders_of, people_in_packs
from cloner.errors import ClonerError, printable
from cloner.project.atomic import partial_results
from cloner.project.claims import claimants
from cloner.project.folder import SUFFIXES, read_consent, safe_identifier
from cloner.project.manifest import DEEPEST, photo_folders
from cloner.project.results import RESULT_MARK, Manifest, file_digest, place_digest, read_manifest
from cloner.untrusted import walk_files

#: Seconds of a day.
_DAY_S: Final = 86_400.0
_SAME: Final = 0.5  # a result is of a folder that has this share of its photos


@dataclass(frozen=True, slots=True)
class Holding:
    """All that is held of one visitor.

    Attributes
    ----------
    identifier : str
        How the visitor is named here; the photo folder's place where two would share a name.
    names : tuple of str
        Every identifier the visitor was cloned under.
    photos, results : tuple of Path
    rests : tuple of Path
        What killed or running clones left.
    packs : tuple of Path
        The visitor's own folders inside the packs of crowds.
    apart : tuple of Path
        Folders below the photos that are not the visitor's: results of everybody.
    files : int
    size_bytes : int
    newest : datetime
        Last change of any file, UTC.
    consent : str
        As written in ``person.toml``; "" where nothing is.
    """

    identifier: str
    names: tuple[str, ...]
    photos: tuple[Path, ...]
    results: tuple[Path, ...]
    rests: tuple[Path, ...]
    packs: tuple[Path, ...]
    apart: tuple[Path, ...]
    files: int
    size_bytes: int
    newest: datetime
    consent: str

    @property
    def folders(self) -> tuple[Path, ...]:
        """The folders that exist."""
        return (*self.photos, *self.results, *self.rests, *self.packs)

    def files_in(self, folder: Path) -> list[Path]:
        """Return the visitor's files below one of the folders; links are none."""
        return _files_of(folder, self.apart)


@dataclass(slots=True)
class _Heap:
    """What is being put together of one visitor."""

    names: set[str]
    photos: list[Path]
    results: list[Path]
    rests: list[Path]


def holdings(photos_root: Path | None, out: Path | None) -> tuple[Holding, ...]:
    """Return the data held below a root of photos and a folder of results, by identifier.

    Raises
    ------
    ClonerError
        If neither is given or a given folder is missing.
    """
    for folder in (photos_root, out):
        if folder is not None and not folder.is_dir():
            raise ClonerError(
                "there is no such folder", "Give --photos and --out as you gave them to batch", folder.name
            )
    if photos_root is None and out is None:
        raise ClonerError("there is nowhere to look", "Give --photos, --out or both", "cloner")
    places = [] if photos_root is None else photo_folders(photos_root, DEEPEST)
    heaps = [_Heap({_name(photos_root, one)}, [one], [], []) for one in places if photos_root is not None]
    shared = {name for name, count in Counter(name for heap in heaps for name in heap.names).items() if count > 1}
    if out is not None:
        for result in _results(out):
            heaps = _with_result(heaps, result, shared)
        for path, name in (*partial_results(out).items(), *((out, name) for name in claimants(out))):
            _heap_of(heaps, name).rests.extend([path] if path != out else [])
        for name in people_in_packs(out):
            _heap_of(heaps, name)
    found = (_held(heap, photos_root, shared, out) for heap in heaps)
    return tuple(sorted(found, key=lambda holding: holding.identifier))


def _results(out: Path) -> list[Path]:
    """Return the folders of results; a link is none: it leads to somebody else's files."""
    found = [path for path in sorted(out.iterdir()) if not path.name.startswith(".") and not path.is_symlink()]
    return [path for path in found if path.is_dir() and (path / RESULT_MARK).is_file()]


def _with_result(heaps: list[_Heap], result: Path, shared: set[str]) -> list[_Heap]:
    """Return the holdings with a result added to its visitor's; holdings that it links are merged."""
    manifest = read_manifest(result)
    mine = [heap for heap in heaps if _belongs(heap, result, manifest, shared)]
    joined = _Heap({result.name}, [], [result], [])
    for heap in mine:
        joined.names |= heap.names
        joined.photos += heap.photos
        joined.results += heap.results
        joined.rests += heap.rests
    return [heap for heap in heaps if heap not in mine] + [joined]


def _belongs(heap: _Heap, result: Path, manifest: Manifest | None, shared: set[str]) -> bool:
    """Return whether a result was made of photos in a heap: of its folder and some photos, or most of them anywhere."""
    if result.name in heap.names and result.name not in shared:
        return True
    wanted = {digest for name, digest in manifest.inputs.items() if "." not in name} if manifest is not None else set()
    if manifest is None or not wanted:
        return False
    for folder in heap.photos:
        common = len(wanted & set(photo_digests(folder)))
        if common >= _SAME * len(wanted) or (common and manifest.source == place_digest(folder)):
            return True
    return False


def _heap_of(heaps: list[_Heap], name: str) -> _Heap:
    for heap in heaps:
        if name in heap.names:
            return heap
    heaps.append(_Heap({name}, [], [], []))
    return heaps[-1]


def _name(root: Path, folder: Path) -> str:
    parts = folder.relative_to(root).parts
    return safe_identifier("-".join(parts) if parts else root.resolve().name)


def _held(heap: _Heap, photos_root: Path | None, shared: set[str], out: Path | None) -> Holding:
    names = sorted(heap.names)
    name = names[0]
    if heap.photos and photos_root is not None:
        name = _name(photos_root, heap.photos[0])
        if name in shared:  # "a b" and "a-b" are two visitors
            name = heap.photos[0].relative_to(photos_root).as_posix()
    apart = [out] if out is not None and any(_lies_in(out, folder) for folder in heap.photos) else []
    packs = [] if out is None else [folder for each in names for folder in folders_of(each, out)]
    return _counted(name, names, (heap.photos, heap.results, heap.rests, packs, apart))


def holding_of(name: str, photos: Path | None, result: Path | None) -> Holding:
    """Return the data held of one visitor in a folder of photos and a folder of results."""
    return _counted(name, [name], ([photos] if photos else [], [result] if result else [], [], [], []))


def _lies_in(inner: Path, folder: Path) -> bool:
    return inner.resolve().is_relative_to(folder.resolve())


def _counted(name: str, names: Iterable[str], folders: Sequence[Sequence[Path]]) -> Holding:
    """Return a holding of its photos, results, rests and what is apart, with its files counted."""
    photos, results, rest, packs, apart = (tuple(some) for some in folders)
    files = [path for folder in (*photos, *results, *rest, *packs) for path in _files_of(folder, apart)]
    facts = []
    for path in files:
        with contextlib.suppress(FileNotFoundError):  # somebody may be at work there
            facts.append(path.stat())
    moment = datetime.fromtimestamp(max((fact.st_mtime for fact in facts), default=0.0), UTC)
    size, consent = sum(fact.st_size for fact in facts), " | ".join(filter(None, map(_consent, photos)))
    return Holding(name, tuple(names), photos, results, rest, packs, apart, len(facts), size, moment, consent)


def _consent(photos: Path) -> str:
    try:
        return printable(read_consent(photos))
    except ClonerError as error:  # who is held must be told even where a file is broken
        return f"unreadable: {error.message}"


def _files_of(folder: Path, apart: Sequence[Path]) -> list[Path]:
    """Return the files below a folder but not below those apart, links left out; the folder itself may be apart's."""
    found = [path for path in walk_files(folder) if path.is_file() and not path.is_symlink()]
    others = [one for one in apart if _lies_in(one, folder) and one.resolve() != folder.resolve()]
    return [path for path in found if not any(_lies_in(path, one) for one in others)]


def find_holding(identifier: str, held: Sequence[Holding]) -> Holding:
    """Return the data held of one visitor.

    Raises
    ------
    ClonerError
        If nothing is.
    """
    for one in held:
        if one.identifier == identifier:
            return one
    for one in held:
        if identifier in one.names:
            return one
    raise ClonerError("nothing is held under this name", "cloner list shows the names", identifier)


def photo_digests(folder: Path) -> list[str]:
    """Return the digests of the photos in a folder, the named views; those that can be read."""
    found = []
    for path in sorted(folder.iterdir()):
        if path.suffix.lower() in SUFFIXES:
            with contextlib.suppress(OSError):
                found.append(file_digest(path))
    return found


def older_than(held: Sequence[Holding], days: float, now: datetime | None = None) -> tuple[Holding, ...]:
    """Return data last changed more than some number of days ago."""
    limit = (now or datetime.now(UTC)).timestamp() - days * _DAY_S
    return tuple(one for one in held if one.newest.timestamp() < limit)


def table(held: Sequence[Holding]) -> str:
    """Return the holdings as a table of text."""
    width = max((len(one.identifier) for one in held), default=7)
    lines = [f"{'visitor':{width}}  photos  result  interrupted  files      MB  last change (UTC)  consent"]
    for one in held:
        has = [("yes" if folders else "-") for folders in (one.photos, one.results, one.rests)]
        lines.append(
            f"{one.identifier:{width}}  {has[0]:6}  {has[1]:6}  {has[2]:11}  {one.files:5}  "
            f"{one.size_bytes / 1e6:6.1f}  {one.newest:%Y-%m-%d %H:%M}   {one.consent or 'not recorded'}"
        )
    return "\n".join(lines)
