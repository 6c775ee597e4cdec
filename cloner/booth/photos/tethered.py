"""A camera on a USB cable, through the program gphoto2 if it is installed: live view and photos.

gphoto2 runs as a process of its own: its drivers may crash, and its licence stays its own. The live picture is the
stream of ``--capture-movie``, JPEG files one after the other; a camera that gives none takes photos all the same.
"""

from __future__ import annotations

import select
import shutil
import subprocess
import tempfile
from pathlib import Path
from typing import Final

import cv2
import numpy as np
from numpy.typing import NDArray

from cloner.errors import ClonerError

#: Patience with the program that talks to cameras, seconds, and bytes read of it at a time (taste).
_FIND_S: Final = 20.0
_SHOOT_S: Final = 30.0
_WAIT_S: Final = 3.0  # for the next live picture
_CHUNK: Final = 1 << 16
_LONGEST: Final = 1 << 24  # bytes without a whole picture: it is no stream of pictures
_BEGIN, _END = b"\xff\xd8", b"\xff\xd9"
_AGAIN: Final = "Is it switched on, and no other program using it? Plug it in again"


class Tethered:
    """The first camera that gphoto2 finds.

    Raises
    ------
    ClonerError
        If gphoto2 is not installed, or finds no camera.
    """

    def __init__(self) -> None:
        program = shutil.which("gphoto2")
        if program is None:
            hint = "Install it, or let the camera's own program write into a folder and watch that"
            raise ClonerError("gphoto2, which speaks with cameras, is not installed", hint, "Camera")
        self._program = program
        if not cameras_of(self._run("--auto-detect", seconds=_FIND_S)):
            raise ClonerError("no camera is found on the cable", _AGAIN, "Camera")
        self._movie: subprocess.Popen[bytes] | None = None
        self._held = b""
        self._begin()

    def read(self) -> NDArray[np.uint8] | None:
        """Return the next live picture; a grey one if the camera gives none."""
        jpeg = self._next_jpeg()
        bgr = None if jpeg is None else cv2.imdecode(np.frombuffer(jpeg, np.uint8), cv2.IMREAD_COLOR)
        if bgr is None:
            return np.full((480, 320, 3), 60, np.uint8)
        return np.asarray(cv2.cvtColor(bgr, cv2.COLOR_BGR2RGB))

    def shoot(self) -> bytes:
        """Take a photo and return the file as the camera wrote it.

        Raises
        ------
        ClonerError
            If it takes none.
        """
        self._end()  # a camera does one thing at a time
        with tempfile.TemporaryDirectory(prefix="cloner-shot-") as room:
            path = Path(room) / "photo.jpg"
            self._run("--capture-image-and-download", "--force-overwrite", "--filename", str(path), seconds=_SHOOT_S)
            if not path.is_file() or not path.stat().st_size:
                raise ClonerError("the camera took no photo", _AGAIN, "Camera")
            data = path.read_bytes()
        self._begin()
        return data

    def close(self) -> None:
        """Release the camera."""
        self._end()

    def _run(self, *arguments: str, seconds: float) -> str:
        try:
            done = subprocess.run(
                [self._program, *arguments], capture_output=True, text=True, timeout=seconds, check=True
            )
        except (OSError, subprocess.SubprocessError, ValueError) as error:
            raise ClonerError("the camera does not answer", _AGAIN, "Camera") from error
        return done.stdout

    def _begin(self) -> None:
        command = [self._program, "--stdout", "--capture-movie"]
        self._held = b""
        self._movie = subprocess.Popen(command, stdout=subprocess.PIPE, stderr=subprocess.DEVNULL)

    def _end(self) -> None:
        if self._movie is not None:
            self._movie.kill()
            self._movie.wait()
            if self._movie.stdout is not None:
                self._movie.stdout.close()
            self._movie = None

    def _next_jpeg(self) -> bytes | None:
        """Return the next complete picture of the stream; None on timeout."""
        stream = None if self._movie is None else self._movie.stdout
        while stream is not None and len(self._held) < _LONGEST:
            begin = self._held.find(_BEGIN)
            end = self._held.find(_END, begin + 2) if begin >= 0 else -1
            if end >= 0:
                jpeg, self._held = self._held[begin : end + 2], self._held[end + 2 :]
                return jpeg
            if not select.select([stream], [], [], _WAIT_S)[0]:
                return None
            chunk = stream.read1(_CHUNK) if hasattr(stream, "read1") else stream.read(_CHUNK)
            if not chunk:
                return None
            self._held += chunk
        self._held = b""
        return None


def cameras_of(output: str) -> tuple[str, ...]:
    """Return the models in the output of ``gphoto2 --auto-detect``: a heading, a line of dashes, then one per row."""
    _, dashes, rows = output.partition("---")
    lines = rows.splitlines()[1:] if dashes else []
    return tuple(line.rpartition("usb:")[0].strip() for line in lines if "usb:" in line)
