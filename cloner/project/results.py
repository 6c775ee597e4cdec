"""Result folders: a manifest that lists everything in them, and digests that identify the visitor.

Nothing is taken for a result, replaced or deleted because of one file's name: a folder with a photo to clone from, or
with any file that its manifest does not list, belongs to somebody.
"""

from __future__ import annotations

import hashlib
import json
import os
import stat
from collections.abc import Mapping
from dataclasses import dataclass
from pathlib import Path
from typing import Any, Final

from cloner.errors import ClonerError
from cloner.frames import ViewId
from cloner.project.texts import read_text
from cloner.untrusted import open_untrusted

#: The manifest: what a result was made from and the digests of its files.
RESULT_MARK: Final = "report.json"
#: Results of earlier versions do not list their page.
_PAGE: Final = "report.html"
_PAGE_LISTED: Final = 3  # since this format of the report
_BLOCK: Final = 1 << 20
FEW: Final = 3  # files named in a sentence; taste


@dataclass(frozen=True, slots=True)
class Manifest:
    """What a result says of itself.

    Attributes
    ----------
    outputs : mapping of str to str
        sha256 of its files by relative path, without the manifest itself.
    inputs : mapping of str to str
        sha256 of what it was made from: photos by view, files beside them by name.
    source : str
        Name of the folder the photos lay in; "" in results of earlier versions.
    stamp : mapping
        Everything that decided what the clone looks like.
    """

    outputs: Mapping[str, str]
    inputs: Mapping[str, str]
    source: str
    stamp: Mapping[str, Any]


def read_manifest(folder: Path) -> Manifest | None:
    """Return the manifest of a result; None where the folder holds none that can be read."""
    if folder.is_symlink():
        return None
    try:
        data = json.loads(read_text(folder / RESULT_MARK))
        stamp = dict(data["stamp"])
        inputs = {**stamp.get("photos", {}), **stamp.get("beside", {})}
        outputs = {str(name): str(digest) for name, digest in data["outputs"].items()}
        if data.get("format", 0) < _PAGE_LISTED:
            outputs.setdefault(_PAGE, "")
        source = str(data.get("source", ""))
    except (ClonerError, OSError, ValueError, LookupError, TypeError, AttributeError, RecursionError):
        return None
    return Manifest(outputs, {str(name): str(digest) for name, digest in inputs.items()}, source, stamp)


def is_result(folder: Path) -> bool:
    """Return whether a folder is a result and nothing but that."""
    return read_manifest(folder) is not None and not foreign_files(folder)


def foreign_files(folder: Path) -> tuple[str, ...]:
    """Return files in a folder that do not belong to a result, by relative path: all of them without a manifest.

    Links and pipes are foreign whatever they are called, and files named as photos: Cloner writes none.
    """
    manifest = read_manifest(folder)
    listed = {RESULT_MARK, *manifest.outputs} if manifest is not None else set()
    above = {parent.as_posix() for name in listed for parent in Path(name).parents}
    found = []
    for path in sorted(folder.rglob("*")):
        name, mode = path.relative_to(folder).as_posix(), path.lstat().st_mode
        ours = name in listed and path.stem.lower() not in set(ViewId)
        if not ((stat.S_ISREG(mode) and ours) or (stat.S_ISDIR(mode) and name in above)):
            found.append(name)
    return tuple(found)


def file_digest(path: Path) -> str:
    """Return the sha256 of a file."""
    digest = hashlib.sha256()
    with open_untrusted(path) as stream:
        while block := stream.read(_BLOCK):
            digest.update(block)
    return digest.hexdigest()


def place_digest(folder: Path) -> str:
    """Return a digest of the photos' location: enough to recognise it, not to reveal it."""
    return hashlib.sha256(os.fsencode(folder.resolve())).hexdigest()


def check_replaceable(final: Path, photos: Path | None = None, *, whole: Path | None = None) -> None:
    """Refuse to replace anything but a result.

    Parameters
    ----------
    final : Path
        Where the new result will lie.
    photos : Path or None
        The folder that is cloned from.
    whole : Path or None
        Where the earlier result lies just now, if not there.

    Raises
    ------
    ClonerError
        If something else is there, it holds anything of somebody's own, the photos lie in it, or it was made of other
        photos from another folder.
    """
    here = final if whole is None else whole
    if not here.is_symlink() and not here.exists():
        return
    hint = "Choose another --out folder or --id, or move those files away"
    if photos is not None and photos.resolve().is_relative_to(final.resolve()):
        raise ClonerError("the photos lie where the result would, and are never replaced", hint, final.name)
    if here.is_dir() and not here.is_symlink():
        foreign = foreign_files(here)
        if not foreign:
            _check_same_visitor(here, final, photos)
            return
        if read_manifest(here) is not None:
            named = ", ".join(foreign[:FEW]) + (", …" if len(foreign) > FEW else "")
            raise ClonerError(f"the earlier result holds files of somebody's own ({named})", hint, final.name)
    message = "something that is no earlier result is in the way and will not be replaced"
    raise ClonerError(message, hint, final.name)


def _check_same_visitor(here: Path, final: Path, photos: Path | None) -> None:
    """Refuse a result made of none of these photos and in another place: two visitors would share one name."""
    manifest = read_manifest(here)
    if manifest is None or photos is None or not manifest.source or final.resolve().is_relative_to(photos.resolve()):
        return
    if manifest.source == place_digest(photos):
        return
    now = [path for path in photos.iterdir() if path.stem.lower() in set(ViewId) and path.is_file()]
    if not {file_digest(path) for path in now} & set(manifest.inputs.values()):
        message = "the result of another visitor is there: other photos, from another folder"
        raise ClonerError(message, "Choose another --id or --out folder, or forget that visitor first", final.name)
