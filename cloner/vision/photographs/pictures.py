"""Decode photographs: upright, 8-bit sRGB, at a size the rest can hold."""

from __future__ import annotations

import hashlib
import io
import logging
import struct
import warnings
import zlib
from dataclasses import dataclass
from importlib.util import find_spec
from pathlib import Path
from typing import Final

import numpy as np
from numpy.typing import NDArray
from PIL import ExifTags, Image, ImageCms, UnidentifiedImageError

from cloner.errors import ClonerError
from cloner.untrusted import UnsuitableFile, read_untrusted

if find_spec("pillow_heif") is not None:  # optional: photos as iPhones store them
    import pillow_heif

    pillow_heif.register_heif_opener()

log = logging.getLogger(__name__)

LONGEST_SIDE_PX: Final = 2600  # taste: 2000 px photos stay whole, 100 MP ones shrink
LARGEST_PIXELS: Final = 400_000_000  # taste: no camera gives more; guards the memory
LARGEST_WHOLE_PIXELS: Final = 120_000_000  # measured: 3 bytes each stay under 600 MB
LARGEST_BYTES: Final = 1_000_000_000  # taste: above any camera's uncompressed TIFF
SMALLEST_SIDE_PX: Final = 64  # taste: below this there is no face to find
_FORMATS: Final = ("JPEG", "MPO", "PNG", "WEBP", "TIFF", "BMP", "GIF", "HEIF", "AVIF")
_RETAKE: Final = "Copy the photo from the camera again, or retake it"
_SMALLER: Final = "Save it smaller, 12 megapixels are plenty"
Image.MAX_IMAGE_PIXELS = LARGEST_PIXELS  # pillow's own guard, raised to ours
#: EXIF's orientations as quarter turns and mirrors.
_TURNS: Final = {
    2: Image.Transpose.FLIP_LEFT_RIGHT,
    3: Image.Transpose.ROTATE_180,
    4: Image.Transpose.FLIP_TOP_BOTTOM,
    5: Image.Transpose.TRANSPOSE,
    6: Image.Transpose.ROTATE_270,
    7: Image.Transpose.TRANSVERSE,
    8: Image.Transpose.ROTATE_90,
}
#: What decoders raise over files that are damaged or made to hurt.
_BROKEN: Final = (
    OSError, SyntaxError, ValueError, EOFError, LookupError, TypeError, AttributeError, ArithmeticError, RuntimeError,
    struct.error, zlib.error,
)  # fmt: skip
_SRGB: Final = ImageCms.createProfile("sRGB")


@dataclass(frozen=True, slots=True, eq=False)
class Picture:
    """One decoded photograph.

    Parameters
    ----------
    rgb : (H, W, 3) uint8
        sRGB, upright, read-only; long side at most `LONGEST_SIDE_PX`.
    focal_35mm : float or None
        35 mm equivalent focal length of the EXIF; f_px = focal_35mm / 36 * max(H, W).
    digest : str
        sha256 of the file's bytes, hexadecimal.
    original_size : (int, int)
        Width and height in px of the upright photo before any reduction.
    """

    rgb: NDArray[np.uint8]
    focal_35mm: float | None
    digest: str
    original_size: tuple[int, int]

    def __post_init__(self) -> None:
        rgb = np.ascontiguousarray(self.rgb)
        if rgb.ndim != 3 or rgb.shape[2] != 3 or rgb.dtype != np.uint8:
            raise ValueError(f"rgb must be (H, W, 3) uint8, not {rgb.shape} {rgb.dtype}")
        if rgb is self.rgb and rgb.flags.writeable:
            rgb = rgb.copy()
        rgb.flags.writeable = False
        object.__setattr__(self, "rgb", rgb)


def read_picture(path: Path) -> Picture:
    """Decode one photograph, upright, in sRGB, at most `LONGEST_SIDE_PX` long.

    Parameters
    ----------
    path : Path
        JPEG, PNG, WebP, TIFF, BMP, GIF, or HEIF where `pillow_heif` is installed.

    Returns
    -------
    Picture
        The pixels, the focal length of the EXIF if any, and the file's digest.

    Raises
    ------
    ClonerError
        The file is missing, empty, not an image, broken, too small or too large.
    """
    where = path.name
    data = _read_bytes(path, where)
    digest = hashlib.sha256(data).hexdigest()
    try:
        with warnings.catch_warnings():
            warnings.simplefilter("ignore")  # our own size check replaces pillow's
            with Image.open(io.BytesIO(data), formats=_known_formats()) as image:
                _check_size(image, where)
                _check_whole(image.format, data)
                focal_35mm = _read_focal(image)
                rgb, size = _decode(image)
    except Image.DecompressionBombError as error:  # beyond twice our limit
        message = f"the photo has more than {2 * LARGEST_PIXELS / 1e6:.0f} megapixels"
        raise ClonerError(message, _SMALLER, where) from error
    except UnidentifiedImageError as error:
        raise ClonerError("this file is not a photo that can be read", _hint(path), where) from error
    except _BROKEN as error:
        log.debug("decoding failed: %s", error)
        raise ClonerError("the photo is damaged or cut short", _RETAKE, where) from error
    return Picture(rgb=rgb, focal_35mm=focal_35mm, digest=digest, original_size=size)


def _known_formats() -> list[str]:
    Image.init()
    return [name for name in _FORMATS if name in Image.OPEN]


def _hint(path: Path) -> str:
    if path.suffix.lower() in {".heic", ".heif"}:
        return "Install pillow-heif, or let the phone save photos as JPEG"
    return "Use a JPEG, PNG, TIFF or WebP photo"


def _read_bytes(path: Path, where: str) -> bytes:
    """Return the file's bytes, or say why there are none."""
    try:
        data = read_untrusted(path, LARGEST_BYTES)
    except FileNotFoundError as error:
        raise ClonerError("the photo is missing", "Put it into the photos folder", where) from error
    except UnsuitableFile as error:
        message = f"the photo cannot be opened: {error.strerror}"
        raise ClonerError(message, "Put the photo itself there", where) from error
    except OSError as error:
        raise ClonerError("the photo cannot be opened", "Check its permissions", where) from error
    if not data:
        raise ClonerError("the photo is empty (0 bytes)", _RETAKE, where)
    return data


def _check_whole(kind: str | None, data: bytes) -> None:
    """Refuse a PNG whose checksums are wrong: decoding alone would fill the damaged rows with anything."""
    if kind == "PNG":
        with Image.open(io.BytesIO(data), formats=["PNG"]) as image:
            image.verify()


def _check_size(image: Image.Image, where: str) -> None:
    """Refuse photos no camera makes, before a pixel is decoded."""
    width, height = image.size
    reduced = image.format in {"JPEG", "MPO"}  # decoded at half, quarter, eighth scale
    limit = LARGEST_PIXELS if reduced else LARGEST_WHOLE_PIXELS
    if width * height > limit:
        kind = "the photo" if reduced else f"this {image.format} photo"
        message = f"{kind} has {width * height / 1e6:.0f} megapixels, more than the {limit / 1e6:.0f} that can be read"
        raise ClonerError(message, _SMALLER, where)
    if min(width, height) < SMALLEST_SIDE_PX:
        message = f"the photo is only {width} x {height} pixels"
        raise ClonerError(message, "Use the original photo, not a thumbnail", where)


def _read_focal(image: Image.Image) -> float | None:
    """Return FocalLengthIn35mmFilm, or None where it is absent or senseless."""
    try:
        value = image.getexif().get_ifd(ExifTags.IFD.Exif).get(ExifTags.Base.FocalLengthIn35mmFilm)
        focal = float(value) if value is not None else 0.0
    except (ValueError, TypeError, KeyError, OSError, SyntaxError, ZeroDivisionError):
        return None
    return focal if 8.0 <= focal <= 1000.0 else None


def _decode(image: Image.Image) -> tuple[NDArray[np.uint8], tuple[int, int]]:
    """Return upright sRGB pixels and the upright size before reduction."""
    width, height = image.size
    if image.format in {"JPEG", "MPO"}:
        scale = LONGEST_SIDE_PX / max(width, height)
        # draft never goes below what is asked for, so quality is kept
        image.draft(None, (max(1, int(width * scale)), max(1, int(height * scale))))
    image.load()
    orientation = image.getexif().get(ExifTags.Base.Orientation, 1)
    profile = image.info.get("icc_profile")
    flat = _eight_bit(image)
    if max(flat.size) > LONGEST_SIDE_PX:
        flat.thumbnail((LONGEST_SIDE_PX, LONGEST_SIDE_PX), Image.Resampling.LANCZOS)
    flat = _to_srgb(_over_white(flat), profile)
    turn = _TURNS.get(orientation)
    upright = flat if turn is None else flat.transpose(turn)
    size = (height, width) if orientation in {5, 6, 7, 8} else (width, height)
    return np.asarray(upright, np.uint8), size


def _eight_bit(image: Image.Image) -> Image.Image:
    """Return the image with 8 bits a channel; 16-bit grey is scaled, not clipped."""
    if image.mode.startswith("I"):
        values = np.asarray(image)
        deep = values.max() > 255
        return Image.fromarray((values.clip(0, 65535) >> (8 if deep else 0)).astype(np.uint8))
    if image.mode == "F":
        floats = np.asarray(image)
        span = max(float(floats.max() - floats.min()), 1e-6)
        return Image.fromarray(((floats - floats.min()) * (255.0 / span)).astype(np.uint8))
    if image.mode == "P":
        return image.convert("RGBA" if "transparency" in image.info else "RGB")
    if image.mode == "1":
        return image.convert("L")
    return image


def _over_white(image: Image.Image) -> Image.Image:
    """Return the image composited over white."""
    if image.mode in {"RGBA", "LA", "PA", "La", "RGBa"}:
        layered = image.convert("RGBA")
        white = Image.new("RGBA", layered.size, (255, 255, 255, 255))
        return Image.alpha_composite(white, layered).convert("RGB")
    return image


def _to_srgb(image: Image.Image, profile: bytes | None) -> Image.Image:
    """Return an sRGB image; a profile that cannot be used is ignored."""
    if profile and image.mode in {"RGB", "CMYK", "L"}:
        try:
            source = ImageCms.ImageCmsProfile(io.BytesIO(profile))
            turned = ImageCms.profileToProfile(image, source, _SRGB, outputMode="RGB")
        except (ImageCms.PyCMSError, OSError, ValueError):
            log.info("colour profile ignored")
        else:
            if turned is not None:
                return turned
    return image.convert("RGB")
