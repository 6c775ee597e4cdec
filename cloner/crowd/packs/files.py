"""Files of a pack: binary arrays, WebP pictures, and the folder written atomically."""

from __future__ import annotations

import contextlib
import errno
import hashlib
import io
import math
import os
import shutil
import zlib
from collections.abc import Iterator, Mapping
from pathlib import Path
from typing import Any, Final

import numpy as np
from numpy.typing import NDArray
from PIL import Image

from cloner.crowd.drawing.impostors import Tiles
from cloner.crowd.packs.held import MARK as MARK
from cloner.errors import ClonerError
from cloner.project.atomic import partial_path

Pixels = NDArray[np.uint8]

FORMAT: Final = "cloner-crowd"
#: Version of the pack's format, and JPEG quality of its pictures of shape (taste).
VERSION: Final = 6
COLOUR_QUALITY: Final = 90  # SSIM at the switch .001 below all values; 80 is .003 below
SHAPE_QUALITY: Final = 60  # .001 below; 88 had the same
FINE_QUALITY: Final = 75  # of folds of cloth: 60 is .001 below, 85 .0006 above for a quarter more bytes
SHELL_QUALITY: Final = 88
#: A clone's numbers have 3 MB, its largest page 4096 x 4096 texels and the normals' planes below one another.
LARGEST_NUMBERS_BYTES: Final = 200_000_000
LARGEST_PICTURE_PIXELS: Final = 3 * 4096 * 4096
_METHOD: Final = 4
_TROUBLE: Final = {errno.ENOSPC, errno.EDQUOT, errno.EROFS, errno.EIO, errno.EACCES, errno.EPERM, errno.EFBIG}


def pack_arrays(arrays: Mapping[str, NDArray[Any]]) -> tuple[bytes, dict[str, Any]]:
    """Return arrays concatenated, little-endian, aligned to 8 bytes, deflated; and the offset of each."""
    chunks, layout, at = [], {}, 0
    for name, values in arrays.items():
        data = np.ascontiguousarray(values, values.dtype.newbyteorder("<")).tobytes()
        layout[name] = {"at": at, "type": values.dtype.name, "shape": list(values.shape)}
        chunks += [data, b"\0" * (-len(data) % 8)]
        at += len(data) + (-len(data) % 8)
    return zlib.compress(b"".join(chunks), 9), layout


def unpack_arrays(data: bytes, parsed: Mapping[str, Any]) -> dict[str, NDArray[Any]]:
    """Return the arrays of :func:`pack_arrays`.

    Raises
    ------
    ValueError
        If the bytes are damaged, or more or fewer than what is told of them.
    """
    found = {}
    ends = [one["at"] + math.prod(one["shape"]) * np.dtype(one["type"]).itemsize for one in parsed.values()]
    try:
        if max(ends, default=0) > LARGEST_NUMBERS_BYTES:
            raise ValueError("more numbers than a clone has")
        data = zlib.decompressobj().decompress(data, max(ends, default=0) + 8)
    except zlib.error as error:
        raise ValueError("numbers that cannot be read") from error
    for name, one in parsed.items():
        count = math.prod(one["shape"])
        found[name] = np.frombuffer(data, np.dtype(one["type"]).newbyteorder("<"), count, one["at"]).reshape(
            one["shape"]
        )
    return found


def encode_webp(pixels: Pixels, quality: int | None) -> bytes:
    """Return an (H, W) or (H, W, 3) picture as WebP; lossless without a quality."""
    rgb = pixels if pixels.ndim == 3 else np.dstack([pixels] * 3)
    stream = io.BytesIO()
    options = {"lossless": True, "quality": 80} if quality is None else {"quality": quality}
    Image.fromarray(np.ascontiguousarray(rgb)).save(stream, "WEBP", method=_METHOD, **options)
    return stream.getvalue()


def small_png(pixels: Pixels) -> bytes:
    """Return a picture as the smallest PNG of several encodings."""
    stream = io.BytesIO()
    Image.fromarray(pixels).save(stream, "PNG", optimize=True)
    return stream.getvalue()


def decode_webp(data: bytes) -> Pixels:
    """Return the (H, W, 3) pixels of a WebP file; ValueError for more than a pack's pages can have."""
    with Image.open(io.BytesIO(data), formats=["WEBP"]) as image:
        if image.width * image.height > LARGEST_PICTURE_PIXELS:
            raise ValueError("a picture larger than any page")
        return np.asarray(image.convert("RGB"))


def tile_files(tiles: Tiles) -> dict[str, bytes]:
    """Return a clone's impostors as three pictures.

    ``colours`` luma and two differences of colour under one another, grey: WebP halves the size of colours, which took
    .016 of SSIM from a person in blue jeans; ``shapes`` normal x, normal y and depth likewise, half or whole size;
    ``covers`` coverage, and below it at half size the codes, without loss.
    """
    height, width = tiles.colours.shape[:2]
    covers = np.zeros((height + height // 2, width), np.uint8)
    covers[:height] = tiles.colours[..., 3]
    fine = tiles.shapes.shape[1] == width
    covers[height:, : width // 2] = tiles.shapes[:: 1 + fine, :: 1 + fine, 3]
    quality = FINE_QUALITY if fine else SHAPE_QUALITY
    return {
        "colours.webp": encode_webp(np.concatenate(_to_ycocg(tiles.colours)), COLOUR_QUALITY),
        "shapes.webp": encode_webp(np.concatenate([tiles.shapes[..., k] for k in range(3)]), quality),
        "covers.webp": encode_webp(covers, None),
    }


def _to_ycocg(rgb: Pixels) -> tuple[Pixels, Pixels, Pixels]:
    """Return Y, Co and Cg of colours (Malvar and Sullivan 2003), the differences about 128."""
    red, green, blue = (rgb[..., k].astype(np.float32) for k in range(3))
    parts = (red + 2 * green + blue) / 4, (red - blue) / 2 + 128, (2 * green - red - blue) / 4 + 128
    y, co, cg = (np.clip(np.round(part), 0, 255).astype(np.uint8) for part in parts)
    return y, co, cg


def _from_ycocg(y: Pixels, co: Pixels, cg: Pixels) -> Pixels:
    """Return the (H, W, 3) colours of :func:`_to_ycocg`."""
    luma, orange, green = y.astype(np.int16), co.astype(np.int16) - 128, cg.astype(np.int16) - 128
    rgb = np.dstack([luma - green + orange, luma + green, luma - green - orange])
    return np.clip(rgb, 0, 255).astype(np.uint8)


def tiles_from(files: Mapping[str, bytes], rows: NDArray[np.float32]) -> Tiles:
    """Return the tiles of :func:`tile_files`."""
    parts, covers = decode_webp(files["colours.webp"])[..., 0], decode_webp(files["covers.webp"])[..., 0]
    shapes = decode_webp(files["shapes.webp"])[..., 0]
    height, width = len(parts) // 3, parts.shape[1]
    fine = shapes.shape[1] == width
    tall = height if fine else height // 2
    colours = _from_ycocg(*(parts[k * height : (k + 1) * height] for k in range(3)))
    planes = [shapes[k * tall : (k + 1) * tall] for k in range(3)]
    codes = covers[height:, : width // 2].repeat(1 + fine, axis=0).repeat(1 + fine, axis=1)
    return Tiles(rows, (), 0, np.dstack([colours, covers[:height]]), np.dstack([*planes, codes]))


def shell_bytes(shell: Pixels) -> bytes:
    """Return hair and cloth as one picture: colours above, alpha below."""
    return encode_webp(np.concatenate([shell[..., :3], np.dstack([shell[..., 3]] * 3)]), SHELL_QUALITY)


def shell_from(data: bytes) -> Pixels:
    """Return the (B, 2 B, 4) shell of :func:`shell_bytes`."""
    both = decode_webp(data)
    half = len(both) // 2
    return np.dstack([both[:half], both[half:, :, 0]])


def digest(data: bytes) -> str:
    """Return the sha256 of a file's content."""
    return hashlib.sha256(data).hexdigest()


@contextlib.contextmanager
def pack_folder(out: Path) -> Iterator[Path]:
    """Yield a temporary folder beside ``out`` that replaces it when the block succeeds.

    Raises
    ------
    ClonerError
        If something else of that name is there, or the disk refuses.
    """
    if out.is_symlink() or (out.exists() and not ((out / MARK).is_file() or (out.is_dir() and not any(out.iterdir())))):
        raise ClonerError("something that is no crowd is in the way", "Choose another --out folder", out.name)
    partial = partial_path(out.parent, out.name)
    made = [folder for folder in (out.parent, *out.parent.parents) if not folder.exists()]
    try:
        out.parent.mkdir(parents=True, exist_ok=True)
        _sweep(out)
        partial.mkdir(mode=0o700)
        inside = partial / "pack"
        inside.mkdir()
        yield inside
        if out.exists():
            out.rename(partial / "replaced")
        try:
            inside.rename(out)
        except OSError:
            if (partial / "replaced").exists():
                (partial / "replaced").rename(out)
            raise
    except OSError as error:
        if error.errno in _TROUBLE:
            hint = "Choose another --out folder, or check its permissions and free space"
            raise ClonerError("the crowd cannot be written there", hint, out.name) from error
        raise
    finally:
        shutil.rmtree(partial, ignore_errors=True)
        for folder in made:
            with contextlib.suppress(OSError):
                folder.rmdir()


def _sweep(out: Path) -> None:
    """Remove what killed processes left of a pack; a temporary folder's name contains the process number."""
    for rest in out.parent.glob(f".{out.name}.partial-*"):
        number = rest.name.removeprefix(f".{out.name}.partial-").split("-")[0]
        if not (number.isdigit() and is_running(int(number))):
            if (rest / "replaced").is_dir() and not out.exists():
                (rest / "replaced").rename(out)
            shutil.rmtree(rest, ignore_errors=True)


def is_running(number: int) -> bool:
    """Return whether a process of this number runs."""
    try:
        os.kill(number, 0)
    except ProcessLookupError:
        return False
    except OSError:  # somebody else's
        return True
    return True
