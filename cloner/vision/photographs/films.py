"""Write pictures as a film that web pages and presentations take."""

from __future__ import annotations

import struct
from collections.abc import Iterable
from itertools import chain
from pathlib import Path
from typing import Any, Final

import cv2
import numpy as np
from numpy.typing import NDArray
from PIL import Image
from PIL.PngImagePlugin import PngInfo

from cloner.vision.photographs.film_sound import add_sound

Pixels = NDArray[np.uint8]

FORMATS: Final = (".gif", ".webp", ".mp4")
WEBP_QUALITY: Final = 80  # taste


def write_film(
    pictures: Iterable[Pixels], per_second: float, path: Path, comment: str = "",
    sound: NDArray[np.floating] | None = None, rate_hz: int = 0,
) -> None:  # fmt: skip
    """Write pictures as a film; GIF and WebP repeat for ever.

    Parameters
    ----------
    pictures : iterable of (H, W, 3) uint8, sRGB
        At least one, all of one size.
    per_second : float
    path : Path
        Its suffix is one of `FORMATS`.
    comment : str
        What the file says of itself, ASCII: a GIF's comment, a WebP's XMP, a free box behind an MPEG-4.
    sound : (N, 2) left and right, -1..1, of ``rate_hz`` samples a second, or None
        MPEG-4 alone keeps it.

    Raises
    ------
    OSError
        If the file cannot be written.
    """
    if path.suffix.lower() == ".mp4":
        _write_mp4(pictures, per_second, path)
        if sound is not None:
            add_sound(path, np.rint(sound * 32767.0).astype(np.int16), rate_hz)
        if comment:
            with path.open("ab") as stream:  # ISO 14496-12, 8.1.2: a free box may stand anywhere, and is skipped
                stream.write(struct.pack(">I4s", 8 + len(comment), b"free") + comment.encode("ascii"))
        return
    frames = [Image.fromarray(picture) for picture in pictures]
    if path.suffix.lower() == ".gif":
        # one palette for all, of pictures from all around: colours must not flicker
        sheet = np.vstack([np.asarray(frame) for frame in frames[:: max(len(frames) // 4, 1)]])
        palette = Image.fromarray(sheet).quantize(256, dither=Image.Dither.NONE)
        frames = [frame.quantize(palette=palette, dither=Image.Dither.FLOYDSTEINBERG) for frame in frames]
    options: dict[str, Any] = {"quality": WEBP_QUALITY} if path.suffix.lower() == ".webp" else {}
    if comment:
        options["xmp" if path.suffix.lower() == ".webp" else "comment"] = comment.encode("ascii")
    rest = frames[1:]
    frames[0].save(path, save_all=True, append_images=rest, duration=round(1000 / per_second), loop=0, **options)


def png_text(comment: str) -> PngInfo:
    """Return the text entries of a picture, for Pillow."""
    info = PngInfo()
    info.add_text("Software", comment)
    return info


def _write_mp4(pictures: Iterable[Pixels], per_second: float, path: Path) -> None:
    """Write MPEG-4 through OpenCV; odd sizes lose their last row or column, as the codec wants it."""
    pictures = iter(pictures)
    first = next(pictures)
    height, width = first.shape[0] // 2 * 2, first.shape[1] // 2 * 2
    writer = cv2.VideoWriter(str(path), cv2.VideoWriter.fourcc(*"mp4v"), per_second, (width, height))
    if not writer.isOpened():
        raise OSError(f"{path.name} cannot be opened")
    try:
        for picture in chain([first], pictures):
            writer.write(np.ascontiguousarray(picture[:height, :width, ::-1]))
    finally:
        writer.release()
