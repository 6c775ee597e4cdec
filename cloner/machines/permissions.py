"""Other users of this machine who may read, change or delete files in a folder."""

from __future__ import annotations

import os
import shlex
import stat
from collections.abc import Iterator
from pathlib import Path
from typing import Final

from cloner.machines.doctor import Finding

_READ: Final = stat.S_IRGRP | stat.S_IROTH | stat.S_IXGRP | stat.S_IXOTH
_WRITE: Final = stat.S_IWGRP | stat.S_IWOTH


def examine_folder(folder: Path) -> tuple[Finding, ...]:
    """Look at a folder, all in it, and the folders above it; changes nothing."""
    name = f"folder {folder.name or folder}"
    try:
        if not folder.is_dir():
            return (Finding(name, False, "it is not there", "Give a folder of photos or results"),)
        place = folder.resolve()
        closed = _closed_above(place) or not place.stat().st_mode & (_READ | _WRITE)
        files = [place, *place.rglob("*")]
        findings = [_open_to_others(name, folder, files, closed=closed), _of_others(name, folder, files)]
        return (*findings, *_above(name, place))
    except OSError as error:
        return (Finding(name, False, f"it cannot be looked at ({error.strerror})", "Ask its owner"),)


def _closed_above(place: Path) -> bool:
    """Return whether a folder above is closed to all others."""
    through = stat.S_IXGRP | stat.S_IXOTH
    return any(not parent.stat().st_mode & through for parent in place.parents)


def _open_to_others(name: str, folder: Path, files: list[Path], *, closed: bool) -> Finding:
    """Say whether other users may read or change anything, and the line that ends it."""
    modes = [path.lstat().st_mode for path in files if not path.is_symlink()]
    read, written = (sum(bool(mode & bits) for mode in modes) for bits in (_READ, _WRITE))
    if closed or not (read or written):
        return Finding(f"{name}: who reads it", True, "its owner alone")
    message = f"other users may read {read} and change {written} of {len(modes)} files and folders"
    return Finding(f"{name}: who reads it", False, message, f"chmod -R go= {shlex.quote(str(folder))}", needed=False)


def _of_others(name: str, folder: Path, files: list[Path]) -> Finding:
    """Say whether anything belongs to another user: he can read and change it whatever its permissions."""
    mine = os.getuid() if hasattr(os, "getuid") else 0
    foreign = sum(hasattr(os, "getuid") and path.lstat().st_uid not in (mine, 0) for path in files)
    if not foreign:
        return Finding(f"{name}: whose it is", True, "all of it yours or the system's")
    fix = f"sudo chown -R $USER {shlex.quote(str(folder))}"
    return Finding(f"{name}: whose it is", False, f"{foreign} files and folders are another user's", fix, needed=False)


def _above(name: str, place: Path) -> Iterator[Finding]:
    """Yield a finding for each folder above in which others may rename what lies there."""
    for parent in place.parents:
        mode = parent.stat().st_mode
        if mode & _WRITE and not mode & stat.S_ISVTX:
            fix = f"chmod go-w {shlex.quote(str(parent))}"
            message = f"other users may move it away: they may write in {parent.name or parent}"
            yield Finding(f"{name}: what lies above", False, message, fix, needed=False)
