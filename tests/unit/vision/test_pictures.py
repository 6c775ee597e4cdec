"""Photos come out upright, sRGB and bounded; broken ones say so."""

from __future__ import annotations

import hashlib
import io
import subprocess
import sys
from pathlib import Path

import numpy as np
import pytest
from PIL import Image, ImageCms
from skimage.util import random_noise

from cloner.errors import ClonerError
from cloner.vision.photographs.pictures import LONGEST_SIDE_PX, read_picture
from kit.visitors import visitor_folder

RED_TOP = np.zeros((120, 80, 3), np.uint8)
RED_TOP[:60, :, 0] = 230
RED_TOP[60:, :, 2] = 230


def is_red_on_top(rgb: np.ndarray) -> bool:
    top, bottom = rgb[5:50, 5:-5].mean(axis=(0, 1)), rgb[-50:-5, 5:-5].mean(axis=(0, 1))
    return bool(top[0] > 150 > top[2] and bottom[2] > 150 > bottom[0])


@pytest.mark.parametrize("orientation", range(1, 9))
def test_every_exif_orientation_comes_out_upright(tmp_path: Path, orientation: int) -> None:
    image = Image.fromarray(RED_TOP)
    undo = {2: 0, 3: 3, 4: 1, 5: 5, 6: 2, 7: 6, 8: 4}  # Transpose that the tag will undo
    stored = image.transpose(Image.Transpose(undo[orientation])) if orientation > 1 else image
    exif = Image.Exif()
    exif[0x0112] = orientation
    path = tmp_path / "turned.jpg"
    stored.save(path, exif=exif, quality=95)
    picture = read_picture(path)
    assert picture.rgb.shape == (120, 80, 3), orientation
    assert picture.original_size == (80, 120)
    assert is_red_on_top(picture.rgb), orientation


def test_visitor_photo_keeps_focal_length_and_digest() -> None:
    path = visitor_folder("anna", "handheld") / "body_side.jpg"  # stored with Orientation 6
    picture = read_picture(path)
    assert picture.rgb.shape == (2000, 1500, 3)
    assert picture.focal_35mm == 49.0
    assert picture.digest == hashlib.sha256(path.read_bytes()).hexdigest()
    assert read_picture(visitor_folder("anna", "booth") / "body_side.jpg").focal_35mm is None
    assert not picture.rgb.flags.writeable


@pytest.mark.parametrize("mode", ["CMYK", "L", "P", "RGBA", "LA", "1"])
def test_other_colour_kinds(tmp_path: Path, mode: str) -> None:
    image = Image.fromarray(RED_TOP).convert("L" if mode == "LA" else "RGB").convert(mode)
    path = tmp_path / ("photo.jpg" if mode in {"CMYK", "L"} else "photo.png")
    image.save(path)
    rgb = read_picture(path).rgb
    assert rgb.shape == (120, 80, 3)
    assert rgb.dtype == np.uint8
    if mode in {"CMYK", "P", "RGBA"}:
        assert is_red_on_top(rgb), mode
    else:
        assert abs(float(rgb[20, 20, 0]) - float(rgb[20, 20, 2])) <= 1


def test_alpha_is_laid_over_white(tmp_path: Path) -> None:
    clear = np.zeros((80, 80, 4), np.uint8)
    clear[:40] = (10, 200, 10, 255)
    Image.fromarray(clear).save(tmp_path / "clear.png")
    rgb = read_picture(tmp_path / "clear.png").rgb
    assert (rgb[60, 40] == 255).all()
    assert (rgb[20, 40] == (10, 200, 10)).all()


def test_sixteen_bit_grey_is_scaled_not_clipped(tmp_path: Path) -> None:
    ramp = np.linspace(0, 65535, 256).astype(np.uint16)[None].repeat(100, axis=0)
    for name in ("ramp.png", "ramp.tiff"):
        Image.fromarray(ramp).save(tmp_path / name)
        rgb = read_picture(tmp_path / name).rgb
        assert np.abs(rgb[50, :, 0].astype(int) - np.arange(256)).max() <= 1, name


@pytest.mark.parametrize("name", ["p.webp", "p.tiff", "p.bmp", "p.png"])
def test_other_formats(tmp_path: Path, name: str) -> None:
    Image.fromarray(RED_TOP).save(tmp_path / name)
    assert is_red_on_top(read_picture(tmp_path / name).rgb)


def test_srgb_profile_changes_nothing_and_a_broken_one_is_ignored(tmp_path: Path) -> None:
    profile = ImageCms.ImageCmsProfile(ImageCms.createProfile("sRGB")).tobytes()
    for data in (profile, b"not a profile"):
        Image.fromarray(RED_TOP).save(tmp_path / "icc.png", icc_profile=data)
        rgb = read_picture(tmp_path / "icc.png").rgb.astype(int)
        assert np.abs(rgb - RED_TOP).max() <= 2


def broken_files() -> dict[str, tuple[bytes, str]]:
    noise = (random_noise(np.full((200, 200, 3), 0.5), rng=1) * 255).astype(np.uint8)
    buffer = io.BytesIO()
    Image.fromarray(noise).save(buffer, "JPEG")
    png = io.BytesIO()
    Image.fromarray(noise).save(png, "PNG")
    tiny = io.BytesIO()
    Image.fromarray(noise[:20, :20]).save(tiny, "PNG")
    return {
        "cut.jpg": (buffer.getvalue()[:4000], "damaged"),
        "cut.png": (png.getvalue()[:4000], "damaged"),
        "empty.jpg": (b"", "empty"),
        "text.jpg": (b"this is a shopping list\n" * 20, "not a photo"),
        "head.jpg": (buffer.getvalue()[:12], "damaged"),
        "tiny.png": (tiny.getvalue(), "only 20 x 20"),
    }


@pytest.mark.parametrize("name", sorted(broken_files()))
def test_broken_files_get_one_sentence(tmp_path: Path, name: str) -> None:
    data, words = broken_files()[name]
    (tmp_path / name).write_bytes(data)
    with pytest.raises(ClonerError) as caught:
        read_picture(tmp_path / name)
    assert caught.value.where == name
    assert words in caught.value.message
    assert caught.value.hint
    assert str(caught.value) == f"{name}: {caught.value.message}. {caught.value.hint}"


def test_missing_photo_and_folder(tmp_path: Path) -> None:
    for path in (tmp_path / "none.jpg", tmp_path):
        with pytest.raises(ClonerError, match="missing"):
            read_picture(path)


def test_absurd_sizes_are_refused_before_decoding(tmp_path: Path) -> None:
    for side, words in ((12000, "144 megapixels"), (30000, "megapixels")):
        Image.new("1", (side, side)).save(tmp_path / "vast.png")
        with pytest.raises(ClonerError, match=words):
            read_picture(tmp_path / "vast.png")


@pytest.mark.slow
@pytest.mark.skipif(not Path("/proc/self/status").exists(), reason="reads Linux' peak memory")
def test_hundred_megapixels_stay_small_in_memory(tmp_path: Path) -> None:
    path = tmp_path / "big.jpg"
    Image.new("RGB", (12000, 9000), (200, 120, 60)).save(path, quality=80)
    code = (
        "import sys\nfrom pathlib import Path\n"
        "from cloner.vision.photographs.pictures import read_picture\n"
        "p = read_picture(Path(sys.argv[1]))\n"
        "lines = Path('/proc/self/status').read_text().splitlines()\n"
        "peak = next(int(x.split()[1]) for x in lines if x.startswith('VmHWM')) // 1024\n"
        "print(*p.rgb.shape, *p.original_size, *p.rgb[0, 0], peak)\n"
    )
    root = Path(__file__).resolve().parents[3]
    done = subprocess.run([sys.executable, "-c", code, str(path)], cwd=root, capture_output=True, text=True, check=True)
    height, width, _, *rest = map(int, done.stdout.split())
    assert max(height, width) <= LONGEST_SIDE_PX
    assert rest[:2] == [12000, 9000]
    assert np.abs(np.array(rest[2:5]) - (200, 120, 60)).max() <= 3
    assert rest[5] < 600, f"peak {rest[5]} MB"
