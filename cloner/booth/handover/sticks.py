"""Detection and ejection of removable drives, on Linux by the system's own programs."""

from __future__ import annotations

import json
import shutil
import subprocess
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Any, Final

from cloner.errors import ClonerError

_COLUMNS: Final = "NAME,PATH,RM,HOTPLUG,TRAN,MOUNTPOINTS,LABEL,FSAVAIL,RO,VENDOR,MODEL"
#: A drive that holds one of these is the computer's own, even where it hangs on USB.
_SYSTEM: Final = ("/", "/boot", "/boot/efi", "/usr", "/var", "/home", "/nix", "[SWAP]")
_BUSES: Final = ("usb", "mmc", "sdio", "ieee1394")
#: How long a program of the system may take, seconds: a stick writes what is left of it when it is ejected.
_LIST_S: Final = 10.0
_EJECT_S: Final = 120.0


@dataclass(frozen=True, slots=True)
class Stick:
    """A mounted folder of a removable drive.

    Attributes
    ----------
    mount : Path
        Where its files are seen.
    label : str
        What people call it.
    device, drive : str
        The part that is mounted, and the whole drive: ``/dev/sdb1`` and ``/dev/sdb``.
    free_bytes : int
    read_only : bool
    """

    mount: Path
    label: str
    device: str
    drive: str
    free_bytes: int
    read_only: bool


def mounted_sticks() -> tuple[Stick, ...]:
    """Return the mounted sticks and memory cards.

    Raises
    ------
    ClonerError
        If the system does not tell.
    """
    hint = "Choose the stick's folder by hand"
    program = shutil.which("lsblk")
    if program is None:
        raise ClonerError("this system does not tell which sticks are plugged in", hint, "Stick")
    command = [program, "--json", "--bytes", "--output", _COLUMNS]
    try:
        output = subprocess.run(command, capture_output=True, text=True, timeout=_LIST_S, check=True).stdout
        return parse_lsblk(output)
    except (OSError, subprocess.SubprocessError, ValueError) as error:
        raise ClonerError("this system does not tell which sticks are plugged in", hint, "Stick") from error


def parse_lsblk(output: str) -> tuple[Stick, ...]:
    """Return the sticks in the output of ``lsblk --json``.

    Raises
    ------
    ValueError
        If it is not that.
    """
    read = json.loads(output)
    drives = read.get("blockdevices", []) if isinstance(read, dict) else []
    if not isinstance(drives, list):
        raise ValueError("blockdevices must be a list")
    return tuple(one for drive in drives if _is_pluggable(drive) for one in _mounted(drive, drive))


def _is_pluggable(drive: Mapping[str, Any]) -> bool:
    mounts = [mount for part in _parts(drive) for mount in _mounts(part)]
    comes_out = bool(drive.get("rm") or drive.get("hotplug") or drive.get("tran") in _BUSES)
    return comes_out and not any(mount in _SYSTEM for mount in mounts)


def _mounted(part: Mapping[str, Any], drive: Mapping[str, Any]) -> Iterator[Stick]:
    for one in _parts(part):
        for mount in _mounts(one)[:1]:  # one place of each is enough
            model = " ".join(str(drive.get(key) or "").strip() for key in ("vendor", "model")).strip()
            yield Stick(
                Path(mount),
                str(one.get("label") or model or Path(mount).name),
                str(one.get("path") or ""),
                str(drive.get("path") or ""),
                int(one.get("fsavail") or 0),
                bool(one.get("ro") or drive.get("ro")),
            )


def _parts(drive: Mapping[str, Any]) -> Iterator[Mapping[str, Any]]:
    """Yield a drive and its partitions."""
    yield drive
    for child in drive.get("children") or ():
        yield from _parts(child)


def _mounts(part: Mapping[str, Any]) -> list[str]:
    return [str(mount) for mount in part.get("mountpoints") or () if mount]


def eject(stick: Stick) -> None:
    """Unmount a stick and power it off, so that it can be unplugged.

    Raises
    ------
    ClonerError
        If something still uses it, or no program here can.
    """
    udisks, gio = shutil.which("udisksctl"), shutil.which("gio")
    if udisks is not None:
        _run([udisks, "unmount", "--no-user-interaction", "-b", stick.device], stick)
        _run([udisks, "power-off", "--no-user-interaction", "-b", stick.drive], stick, must=False)
    elif gio is not None:
        _run([gio, "mount", "-e", str(stick.mount)], stick)
    else:
        hint = "Eject it with the desktop's own files window before it is pulled out"
        raise ClonerError("no program that ejects sticks is installed", hint, stick.label)


def _run(command: Sequence[str], stick: Stick, *, must: bool = True) -> None:
    """Run a system program; without ``must`` its failure is ignored, as an unmounted stick may be unplugged."""
    try:
        done = subprocess.run(command, capture_output=True, timeout=_EJECT_S, check=False).returncode == 0
    except (OSError, subprocess.SubprocessError):
        done = False
    if must and not done:
        hint = "Close every window that shows its files, then eject it again"
        raise ClonerError("the stick cannot be ejected", hint, stick.label)
