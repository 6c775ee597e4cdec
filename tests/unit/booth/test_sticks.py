"""Sticks are told from the computer's own drives, and let go by whatever program is installed."""

import json

import pytest

from cloner.booth.handover.sticks import Stick, eject, mounted_sticks, parse_lsblk
from cloner.errors import ClonerError
from kit.odd_programs import install


def drive(name, *, rm=False, tran=None, mounts=(None,), children=(), **more):
    """One drive or part as lsblk of util-linux 2.38 tells it."""
    told = {"name": name, "path": f"/dev/{name}", "rm": rm, "hotplug": False, "tran": tran, "mountpoints": list(mounts),
            "label": None, "fsavail": None, "ro": False, "vendor": None, "model": None}  # fmt: skip
    return told | more | ({"children": list(children)} if children else {})


def told(*drives):
    return json.dumps({"blockdevices": drives})


DISK = drive("sda", tran="sata", children=[drive("sda1", mounts=["/boot/efi"]), drive("sda2", mounts=["/"])])
STICK = drive(
    "sdb", rm=True, tran="usb", vendor="Kingston ", model="DataTraveler",
    children=[drive("sdb1", rm=True, mounts=["/media/op/FAIR"], label="FAIR", fsavail=12_000_000_000)],
)  # fmt: skip


def test_a_stick_is_found_and_the_computers_own_drive_is_not():
    assert [str(one.mount) for one in parse_lsblk(told(DISK, STICK))] == ["/media/op/FAIR"]
    stick = parse_lsblk(told(STICK))[0]
    assert (stick.label, stick.device, stick.drive) == ("FAIR", "/dev/sdb1", "/dev/sdb")
    assert stick.free_bytes == 12_000_000_000


def test_a_system_that_was_started_from_a_stick_is_no_stick():
    system = drive("sdc", rm=True, tran="usb", children=[
        drive("sdc1", rm=True, mounts=["/"]), drive("sdc2", rm=True, mounts=["/media/op/rest"])])  # fmt: skip
    assert parse_lsblk(told(system)) == ()


def test_a_stick_without_parts_or_name_and_one_that_is_not_mounted():
    whole = drive("sdd", tran="usb", vendor="Kingston ", model="DataTraveler", mounts=["/mnt/x"], ro=True)
    resting = drive("sde", rm=True, tran="usb", children=[drive("sde1", rm=True)])
    found = parse_lsblk(told(whole, resting))
    assert [(one.label, one.read_only) for one in found] == [("Kingston DataTraveler", True)]


def test_a_system_that_does_not_tell_is_told(monkeypatch, tmp_path):
    monkeypatch.setenv("PATH", str(tmp_path))
    with pytest.raises(ClonerError, match="does not tell"):
        mounted_sticks()
    install(tmp_path, monkeypatch, lsblk="echo not json")
    with pytest.raises(ClonerError, match="does not tell"):
        mounted_sticks()


STICK_NOW = Stick(mount=None, label="FAIR", device="/dev/sdb1", drive="/dev/sdb", free_bytes=1, read_only=False)


def test_it_is_let_go_and_switched_off(monkeypatch, tmp_path):
    log = tmp_path / "log"
    monkeypatch.setenv("PATH", "")
    install(tmp_path, monkeypatch, udisksctl=f'echo "$*" >> {log}; [ "$1" = unmount ]')
    eject(STICK_NOW)  # a drive that cannot be switched off may be pulled out all the same
    assert log.read_text().splitlines() == [
        "unmount --no-user-interaction -b /dev/sdb1", "power-off --no-user-interaction -b /dev/sdb",
    ]  # fmt: skip


def test_one_that_is_still_in_use_or_cannot_be_ejected_is_told(monkeypatch, tmp_path):
    monkeypatch.setenv("PATH", str(tmp_path))
    with pytest.raises(ClonerError, match="no program that ejects"):
        eject(STICK_NOW)
    install(tmp_path, monkeypatch, gio="exit 2")
    with pytest.raises(ClonerError, match="cannot be ejected"):
        eject(STICK_NOW)
