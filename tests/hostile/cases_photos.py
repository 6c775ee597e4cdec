"""Photos that are none, and folders that are not what they seem."""

from __future__ import annotations

import io
import os
import struct
import zlib
from collections.abc import Callable
from pathlib import Path

import numpy as np
from PIL import Image

from hostile.cases import Case, file, folder_with

Make = Callable[[Path], Path]


def encoded(kind: str, size: tuple[int, int] = (160, 240), mode: str = "RGB") -> bytes:
    """Return a small noisy picture in a format."""
    noise = np.random.default_rng(1).integers(0, 255, (size[1], size[0], 3), np.uint8)
    stream = io.BytesIO()
    Image.fromarray(noise).convert(mode).save(stream, kind)
    return stream.getvalue()


JPEG, PNG, TIFF, WEBP, BMP, GIF = (encoded(kind) for kind in ("JPEG", "PNG", "TIFF", "WEBP", "BMP", "GIF"))


def chunk(kind: bytes, data: bytes) -> bytes:
    return struct.pack(">I", len(data)) + kind + data + struct.pack(">I", zlib.crc32(kind + data))


def png_of(width: int, height: int, data: bytes = b"") -> bytes:
    """Return a PNG that claims a size and holds next to nothing."""
    head = struct.pack(">IIBBBBB", width, height, 8, 2, 0, 0, 0)
    return b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", head) + chunk(b"IDAT", zlib.compress(data)) + chunk(b"IEND", b"")


def jpeg_of(width: int, height: int) -> bytes:
    """Return a JPEG whose header claims a size."""
    at = JPEG.index(b"\xff\xc0")
    return JPEG[: at + 5] + struct.pack(">HH", height, width) + JPEG[at + 9 :]


def gif_of(width: int, height: int) -> bytes:
    return GIF[:6] + struct.pack("<HH", width, height) + GIF[10:]


def heic() -> bytes:
    return struct.pack(">I", 24) + b"ftypheic\x00\x00\x00\x00mif1heic" + bytes(200)


def grey(size: tuple[int, int] = (400, 600), kind: str = "PNG") -> bytes:
    stream = io.BytesIO()
    Image.new("RGB", size, (128, 128, 128)).save(stream, kind)
    return stream.getvalue()


def animated() -> bytes:
    stream = io.BytesIO()
    frames = [Image.new("RGB", (90, 120), (value, 10, 10)) for value in (10, 90, 200)]
    frames[0].save(stream, "GIF", save_all=True, append_images=frames[1:])
    return stream.getvalue()


def of(*named: tuple[str, bytes]) -> Make:
    """Return a maker of a visitor's folder with these files."""

    def make(folder: Path) -> Path:
        for name, data in named:
            file(f"visitor/{name}", data)(folder)
        return folder / "visitor"

    return make


def linked(target: str) -> Make:
    """Return a maker of a folder whose front photo is a link."""

    def make(folder: Path) -> Path:
        file("elsewhere/body_front.jpg", JPEG)(folder)
        (folder / "visitor").mkdir()
        (folder / "visitor" / "body_front.jpg").symlink_to(target)
        return folder / "visitor"

    return make


def fifo(name: str) -> Make:
    def make(folder: Path) -> Path:
        of(("notes.txt", b"x"))(folder)
        os.mkfifo(folder / "visitor" / name)
        return folder / "visitor"

    return make


def named(name: str | bytes, content: bytes = b"") -> Make:
    """Return a maker of a folder of that name, with a front photo if there is content."""

    def make(folder: Path) -> Path:
        path = folder / os.fsdecode(name)
        path.mkdir()
        if content:
            (path / "body_front.jpg").write_bytes(content)
        return path

    return make


def sub_folder(folder: Path) -> Path:
    (folder / "visitor" / "body_front.jpg").mkdir(parents=True)
    return folder / "visitor"


DAMAGED = "damaged or cut short"
NO_PHOTO = "not a photo that can be read"
FRONT = "one front photo is needed"


def _bad(name: str, data: bytes, words: str, hint: str, suffix: str = "jpg", *, command: bool = False) -> Case:
    path = f"body_front.{suffix}"
    return Case(name, "photos", folder_with(path, data), words, hint, path, command)


_FILES = (
    _bad("empty", b"", "0 bytes", "retake", command=True),
    _bad("one byte", b"\xff", NO_PHOTO, "JPEG"),
    _bad("text", b"hello", NO_PHOTO, "JPEG"),
    _bad("a web page", b"<!doctype html><p>404</p>", NO_PHOTO, "JPEG"),
    _bad("noise", bytes(range(256)) * 20, NO_PHOTO, "JPEG"),
    _bad("zeros", bytes(4000), NO_PHOTO, "JPEG"),
    _bad("a program", b"\x7fELF" + bytes(500), NO_PHOTO, "JPEG"),
    _bad("a pdf", b"%PDF-1.7\n" + bytes(300), NO_PHOTO, "JPEG"),
    _bad("a PostScript file", b"%!PS-Adobe-3.0 EPSF-3.0\n%%BoundingBox: 0 0 99 99\n", NO_PHOTO, "JPEG"),
    _bad("an svg", b'<svg xmlns="http://www.w3.org/2000/svg" onload="alert(1)"/>', NO_PHOTO, "JPEG"),
    _bad("a Photoshop file", b"8BPS\x00\x01" + bytes(300), NO_PHOTO, "JPEG"),
    _bad("a zip", b"PK\x03\x04" + bytes(300), NO_PHOTO, "JPEG"),
    _bad("an icon", b"\x00\x00\x01\x00\x01\x00" + bytes(300), NO_PHOTO, "JPEG"),
    _bad("heic without the extra", heic(), f"{NO_PHOTO}|{DAMAGED}", "pillow-heif|retake", "heic", command=True),
    _bad("heif that is none", b"not heif", NO_PHOTO, "pillow-heif", "heif"),
    _bad("a jpeg's first bytes", JPEG[:20], f"{DAMAGED}|{NO_PHOTO}", "photo"),
    _bad("a tenth of a jpeg", JPEG[: len(JPEG) // 10], f"{DAMAGED}|{NO_PHOTO}", "photo"),
    _bad("half a jpeg", JPEG[: len(JPEG) // 2], DAMAGED, "retake", command=True),
    _bad("nearly a jpeg", JPEG[: -len(JPEG) // 10], DAMAGED, "retake"),
    _bad("half a png", PNG[: len(PNG) // 2], DAMAGED, "retake", "png"),
    _bad("a png with a wrong sum", PNG[:29] + b"\x00\x01\x02\x03" + PNG[33:], f"{DAMAGED}|{NO_PHOTO}", "photo", "png"),
    _bad("a png without pixels", png_of(300, 300), DAMAGED, "retake", "png"),
    _bad("half a tiff", TIFF[: len(TIFF) // 2], f"{DAMAGED}|{NO_PHOTO}", "photo", "tif"),
    _bad("a tiff's header", b"II*\x00\xff\xff\xff\xff", f"{DAMAGED}|{NO_PHOTO}", "photo", "tiff"),
    _bad("half a webp", WEBP[: len(WEBP) // 2], f"{DAMAGED}|{NO_PHOTO}", "photo", "webp"),
    _bad("half a bmp", BMP[: len(BMP) // 2], f"{DAMAGED}|{NO_PHOTO}", "photo"),
    _bad("a gif's header", GIF[:12], f"{DAMAGED}|{NO_PHOTO}", "photo", "png"),
    _bad("a bomb as png", png_of(40_000, 40_000), "megapixels", "smaller", "png", command=True),
    _bad("a larger bomb", png_of(2**31 - 1, 2**31 - 1), f"megapixels|{DAMAGED}|{NO_PHOTO}", "photo|smaller", "png"),
    _bad("a bomb as jpeg", jpeg_of(65_000, 65_000), "megapixels", "smaller"),
    _bad("a bomb as gif", gif_of(65_535, 65_535), "megapixels", "smaller"),
    _bad("a wide strip", png_of(1_000_000, 64), f"megapixels|{DAMAGED}", "photo|retake", "png"),
    _bad("no width", png_of(0, 300), f"only 0|{DAMAGED}|{NO_PHOTO}", "photo", "png"),
    _bad("one pixel", encoded("PNG", (1, 1)), "only 1 x 1 pixels", "thumbnail", "png"),
    _bad("a thumbnail", encoded("JPEG", (63, 90)), "only 63 x 90 pixels", "thumbnail", command=True),
    _bad("a narrow strip", encoded("PNG", (3000, 20)), "only 3000 x 20", "thumbnail", "png"),
)

_FOLDERS = (
    Case("no folder", "photos", lambda folder: folder / "nobody", "no such folder", "photos", "nobody", command=True),
    Case("a file for a folder", "photos", file("anna.jpg", JPEG), "no such folder", "folder", "anna.jpg"),
    Case("a name too long", "photos", lambda folder: folder / ("x" * 300), "no such folder", "folder"),
    Case("a path too long", "photos", lambda folder: folder / "/".join(["xy"] * 2500), "no such folder", "folder"),
    Case("a NUL in the name", "photos", lambda folder: folder / "a\0b", "no such folder", "folder"),
    Case("an empty folder", "photos", named("visitor"), FRONT, "body_front.jpg", "visitor", command=True),
    Case("other names", "photos", of(("front.jpg", JPEG), ("IMG_1.JPG", JPEG)), FRONT, "Name the photos"),
    Case("other suffixes", "photos", of(("body_front.gif", GIF), ("body_front.txt", b"")), FRONT, "png"),
    Case("no front", "photos", of(("body_side.jpg", JPEG), ("body_back.jpg", JPEG)), "only body_side, body_back"),
    Case("two of a view", "photos", of(("body_front.jpg", JPEG), ("BODY_FRONT.png", PNG)), "two photos", "Keep one"),
    Case("a folder named as a photo", "photos", sub_folder, "no photo but a folder", "photo itself",
         "body_front.jpg"),
    Case("a pipe named as a photo", "photos", fifo("body_front.jpg"), "a pipe", "photo itself", "body_front.jpg",
         command=True),
    Case("one good and one empty", "photos", of(("body_front.jpg", JPEG), ("body_back.jpg", b"")), "0 bytes", "retake",
         "body_back.jpg"),
    Case("a link out of the folder", "photos", linked("../elsewhere/body_front.jpg"), "leads out", "file itself",
         "body_front.jpg", command=True),
    Case("a link to a system file", "photos", linked("/etc/passwd"), "leads out", "file itself", "body_front.jpg"),
    Case("a link to a device", "photos", linked("/dev/zero"), "leads out", "file itself", "body_front.jpg"),
    Case("a link to nothing", "photos", linked("nothing.jpg"), "leads out", "file itself", "body_front.jpg"),
    Case("a link to itself", "photos", linked("body_front.jpg"), "leads out", "file itself", "body_front.jpg"),
    Case("a new line in the name", "photos", named("a\nb"), FRONT, "body_front", "a\N{REPLACEMENT CHARACTER}b",
         command=True),
    Case("escape codes in the name", "photos", named("\x1b[31mred"), FRONT, "body_front", r"\[31mred", command=True),
    Case("letters from the right", "photos", named("gpj\u202egnp"), FRONT, "body_front", "gnp"),
    Case("bytes that are no text", "photos", named(b"\xff\xfeanna"), FRONT, "body_front", "anna", command=True),
    Case("a name of 255 bytes", "photos", named("n" * 255), FRONT, "body_front", "nnn"),
    Case("photos one folder deeper", "photos", lambda folder: of(("plain/body_front.jpg", JPEG))(folder), FRONT,
         r"\(plain\)"),
)  # fmt: skip

_TAKEN = (
    Case("a rare name", "photos", named("Zoë 🙂 \u202e", JPEG), ""),
    Case("a moving gif named png", "photos", folder_with("body_front.png", animated()), ""),
    Case("cmyk", "photos", folder_with("body_front.jpg", encoded("JPEG", mode="CMYK")), ""),
    Case("16 bit grey", "photos", folder_with("body_front.png", encoded("PNG", mode="I;16")), ""),
    Case("one bit", "photos", folder_with("body_front.png", encoded("PNG", mode="1")), ""),
    Case("a link inside the folder", "photos", lambda folder: _linked_inside(folder), ""),
)

_SHOWN = (
    Case("nobody", "shown", folder_with("body_front.png", grey()), "no person", "one person", "body_front.png"),
    Case("noise as body", "shown", folder_with("body_back.png", PNG), FRONT, "Name the photos"),
    Case("noise", "shown", folder_with("face_front.png", PNG), "no person", "one person", "face_front.png"),
    Case("a stripe", "shown", folder_with("body_front.png", grey((64, 3000))), "no person", "one person"),
)


def _linked_inside(folder: Path) -> Path:
    file("visitor/originals/IMG_1.jpg", JPEG)(folder)
    (folder / "visitor" / "body_front.jpg").symlink_to("originals/IMG_1.jpg")
    return folder / "visitor"


CASES = (*_FILES, *_FOLDERS, *_TAKEN, *_SHOWN)
