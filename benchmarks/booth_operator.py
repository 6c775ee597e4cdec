"""What a visitor costs the operator: walks with files and with a camera's folder, by a real mouse and keys.

``python benchmarks/booth_operator.py`` walks on four screens in four languages (32 walks with stand-ins for the nets
and the clone, a finished result in their place), then once with everything real at 1280 x 800, and writes
``docs/booth_benchmark.md``. ``--pictures OUT`` keeps what was seen on every page; ``--screens 1024x740,...``,
``--languages en,...`` and ``--no-real`` take less. Needs Xvfb and libXtst.

Counted from *New visitor* to the take-away page, then with the click that copies to the stick; the name and the height
are typed. Seconds of hands are those of the keystroke-level model (`kit.x_hands`), not the machine's.
"""

from __future__ import annotations

import argparse
import json
import os
import shutil
import subprocess
import sys
import tempfile
import textwrap
import time
from pathlib import Path
from typing import Any, Final

import cv2

ROOT: Final = Path(__file__).resolve().parents[1]
SAMPLE: Final = ROOT / "samples" / "anna" / "plain"
PAGE: Final = ROOT / "docs" / "booth_benchmark.md"
#: What is told, the server's pixels, and how many of them are a point.
SCREENS: Final = {
    "1024x740": ("1024x740", "1"), "1280x800": ("1280x800", "1"), "1920x1080": ("1920x1080", "1"),
    "4K at 200 %": ("3840x2160", "2"),
}  # fmt: skip
LANGUAGES: Final = ("en", "de", "fr", "tr")
MOST: Final = {"files": 8, "camera": 4}
VIEWS: Final = ("body_front", "body_side", "face_front")


def main() -> int:
    """Walk, print, and write the page; 1 where a walk takes more clicks than it may."""
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--screens", default=",".join(SCREENS))
    parser.add_argument("--languages", default=",".join(LANGUAGES))
    parser.add_argument("--pictures", type=Path)
    parser.add_argument("--rows", type=Path, help="a file of walks done before, to which these are added")
    parser.add_argument("--no-real", action="store_true")
    parser.add_argument("--ways", default="files,camera", help="files, camera, or both")
    parser.add_argument("--keep", type=Path, help="where the event of the real walks is kept")
    chosen = parser.parse_args()
    told = [] if chosen.rows is None or not chosen.rows.is_file() else json.loads(chosen.rows.read_text())
    for screen in filter(None, chosen.screens.split(",")):
        for walked in walks(screen, chosen.languages, chosen.ways, chosen.pictures, real=False):
            print(screen, json.dumps(walked), flush=True)
            told.append({"screen": screen, "real": False, **walked})
    for walked in [] if chosen.no_real else walks("1280x800", "en", chosen.ways, None, real=True, keep=chosen.keep):
        print("real", json.dumps(walked), flush=True)
        told.append({"screen": "1280x800, real", "real": True, **walked})
    if chosen.rows is not None:
        chosen.rows.write_text(json.dumps(told, indent=1))
    PAGE.write_text(page(told), encoding="utf-8")
    return 1 if any(one["to_takeaway"] > MOST[one["how"]] for one in told) else 0


def walks(
    screen: str, languages: str, ways: str, pictures: Path | None, *, real: bool, keep: Path | None = None
) -> list[dict[str, Any]]:
    """Walk on one screen in all languages, in an X server of its own."""
    size, scale = SCREENS[screen]
    if pictures is not None:
        pictures.mkdir(parents=True, exist_ok=True)
    with tempfile.TemporaryDirectory() as name:
        room = Path(name)
        prepare(room, small=not real)
        read, write = os.pipe()
        server = subprocess.Popen(
            ["Xvfb", "-displayfd", str(write), "-screen", "0", f"{size}x24", "-nolisten", "tcp"],
            pass_fds=[write], stderr=subprocess.DEVNULL,
        )  # fmt: skip
        os.close(write)
        try:
            with os.fdopen(read) as stream:
                display = stream.readline().strip()
            time.sleep(0.3)
            environment = {
                **os.environ, "DISPLAY": f":{display}", "QT_QPA_PLATFORM": "xcb", "QT_SCALE_FACTOR": scale,
                "PATH": os.pathsep.join([str(room / "bin"), os.environ.get("PATH", "")]),
                "PYTHONPATH": os.pathsep.join([str(ROOT), str(ROOT / "gui"), str(ROOT / "tests"), *sys.path]),
            }  # fmt: skip
            command = [sys.executable, "-m", "kit.x_operator", str(room), languages, ways]
            command += ["-" if pictures is None else str(pictures.resolve()), *(["real"] if real else [])]
            done = subprocess.run(
                command, env=environment, cwd=room / "photos", stdout=subprocess.PIPE, text=True, check=True
            )
        finally:
            server.terminate()
            server.wait()
        if keep is not None:
            shutil.copytree(room / "fair", keep)
    return [json.loads(line) for line in done.stdout.splitlines()]


def prepare(room: Path, *, small: bool) -> None:
    """Lay photos ready as a camera names them, and plug a stick in."""
    for name in ("photos", "camera", "bin"):
        (room / name).mkdir()
    names = VIEWS if small else sorted(path.stem for path in SAMPLE.glob("*.jpg"))
    for number, view in enumerate(names):
        photo = cv2.imread(str(SAMPLE / f"{view}.jpg"))
        if small:
            photo = cv2.resize(photo, None, fx=0.2, fy=0.2)
        cv2.imwrite(str(room / "photos" / f"DSC_{number:04d}.jpg"), photo, [cv2.IMWRITE_JPEG_QUALITY, 95])
    (room / "mountinfo").write_text("one")
    part = {"path": "/dev/sdz1", "rm": True, "mountpoints": [str(room / "stick")], "label": "FAIR", "fsavail": 7e9}
    drive = {"path": "/dev/sdz", "rm": True, "tran": "usb", "mountpoints": [None], "children": [part]}
    (room / "stick").mkdir()
    script = room / "bin" / "lsblk"
    script.write_text("#!/bin/sh\ncat <<END\n" + json.dumps({"blockdevices": [drive]}) + "\nEND\n")
    script.chmod(0o755)


def page(told: list[dict[str, Any]]) -> str:
    """Return the page of the documentation, with a row for each walk."""
    told_how = (
        "`python benchmarks/booth_operator.py` (X server, its own mouse and keyboard): *New visitor*, name and height "
        "typed, consent, photos, *Clone*, *Next*, and the click that copies to a stick. Clicks are told to the "
        "take-away page, then in all; keys are the typed name and height and, with files, Ctrl+A and Return in the "
        "dialog. Seconds of hands: keystroke-level model (Card, Moran, Newell 1980), without the machine's time. The "
        "clone of these walks is a finished result, but where the row says that it is real."
    )  # fmt: skip
    lines = [
        "# What a visitor costs the operator", "", *textwrap.wrap(told_how, 120), "",
        "| screen | language | photos | clicks to the take-away | and copied | keys | wheel | hands, s |",
        "| --- | --- | --- | --- | --- | --- | --- | --- |",
    ]  # fmt: skip
    lines += [_row(one) for one in told]
    slowest = ", ".join(f"{one['how']} {one['wall_s']:.0f} s" for one in told if one["real"])
    if slowest:
        lines += ["", f"By the clock, clone included, on a machine with others at work: {slowest}."]
    return "\n".join(lines) + "\n"


def _row(told: dict[str, Any]) -> str:
    clicks = f"{told['to_takeaway']} of {MOST[told['how']]}"
    cells = (
        told["screen"], told["language"], told["how"], clicks, told["clicks"], told["keys"], told["wheels"],
        f"{told['seconds']:.1f}",
    )  # fmt: skip
    return "| " + " | ".join(str(cell) for cell in cells) + " |"


if __name__ == "__main__":
    sys.exit(main())
