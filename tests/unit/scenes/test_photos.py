"""Photos of a plan: put straight, in metres, once over what they are meant for; wrong ones in one sentence."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest
from PIL import Image

from cloner.errors import ClonerError
from cloner.scenes.building.charts import make_charts
from cloner.scenes.building.gltf import make_meshes
from cloner.scenes.building.looks import Look, procedural_look, texture_sheet
from cloner.scenes.building.photos import rectify
from cloner.scenes.building.reading import parse_plan
from cloner.scenes.building.solids import build_room
from cloner.scenes.written import make_folder, read_built_room

SIZE_M, PHOTO_PX, FOCAL_PX = (1.6, 1.2), (900, 700), 800.0
TURN = np.radians(38.0)
SQUARE = [[10, 10], [400, 20], [390, 300], [20, 310]]
FLOOR = '[[floor]]\nfrom = [0, 0]\nto = [4, 3]\nlook = "flags"\n'
WALL = '[[wall]]\nfrom = [0, 3]\nto = [4, 3.3]\nhigh = 3\nlook = "LOOK"\n'
PAINTING = '[[block]]\nname = "a"\nat = [2, 2.97]\nsize = [1.6, 0.06]\nlow = 0.9\nhigh = 2.1\nlook = "oil"\n'


def told(corners: object, **more: object) -> str:
    """Return a plan's table of a photo."""
    row = {"name": '"oil"', "file": '"oil.png"', "corners": corners, "size": list(SIZE_M), "texel": 0.01, **more}
    return "[[photo]]\n" + "".join(f"{key} = {value}\n" for key, value in row.items())


def painted(x: np.ndarray, y: np.ndarray) -> np.ndarray:
    """Return what is painted at metres from the top left corner: (..., 3), 0..255; smooth, and nowhere the same."""
    return np.stack([40 + 110 * x, 230 - 150 * y, 128 + 90 * np.sin(4 * x) * np.cos(5 * y)], axis=-1)


def taken() -> tuple[np.ndarray, np.ndarray]:
    """Return a photo of the painting from aside by a pinhole camera, and where its four corners lie, pixels."""
    along, down = np.array([np.cos(TURN), 0.0, np.sin(TURN)]), np.array([0.1, 1.0, 0.05])
    down = down - along * (down @ along)
    down /= np.linalg.norm(down)
    corner = np.array([0.0, 0.0, 2.2]) - along * 0.8 - down * 0.6
    x, y = np.meshgrid(np.arange(PHOTO_PX[0]), np.arange(PHOTO_PX[1]))
    rays = np.stack([(x - 450) / FOCAL_PX, (y - 350) / FOCAL_PX, np.ones(x.shape)], axis=-1)
    far = (corner @ np.cross(along, down)) / (rays @ np.cross(along, down))
    at = rays * far[..., None] - corner
    rgb = np.clip(painted(at @ along, at @ down), 0, 255).astype(np.uint8)
    ends = np.array(
        [corner + along * u * SIZE_M[0] + down * v * SIZE_M[1] for u, v in ((0, 0), (1, 0), (1, 1), (0, 1))]
    )
    return rgb, ends[:, :2] / ends[:, 2:] * FOCAL_PX + (450, 350)


@pytest.fixture
def plan(tmp_path: Path) -> Path:
    rgb, corners = taken()
    Image.fromarray(rgb).save(tmp_path / "oil.png")
    path = tmp_path / "hall.toml"
    path.write_text(FLOOR + WALL.replace("LOOK", "plaster") + PAINTING + told(corners.tolist()))
    return path


@pytest.mark.parametrize("texel_m", [0.004, 0.02])
def test_a_photo_from_aside_shows_what_is_painted_where_it_is(texel_m: float) -> None:
    rgb, corners = taken()
    size = round(SIZE_M[0] / texel_m), round(SIZE_M[1] / texel_m)
    out = rectify(rgb, corners, size)
    assert out.shape == (size[1], size[0], 3)
    x, y = np.meshgrid((np.arange(size[0]) + 0.5) * texel_m, (np.arange(size[1]) + 0.5) * texel_m)
    off = np.abs(out - painted(x, y))
    assert off.mean() < 1.0
    assert off.max() < 4.0


def test_it_hangs_there_once_the_right_way_up_and_is_kept_with_the_room(plan: Path) -> None:
    make_folder(str(plan), plan.parent / "room")
    (plan.parent / "oil.png").unlink()
    room = read_built_room(plan.parent / "room")
    look = room.looks["oil"]
    assert look.pixels.shape == (120, 160, 3)
    mean = painted(*np.meshgrid(np.linspace(0, 1.6, 200), np.linspace(0, 1.2, 150))).mean(axis=(0, 1))
    assert look.pixels.mean(axis=(0, 1)) == pytest.approx(mean, abs=1.5)
    [mesh] = [one for one in make_meshes(*make_charts(room), room.looks) if one.look == "oil"]
    front = mesh.normals[:, 2] > 0.99  # towards who stands in the hall and looks at it
    places, uv = mesh.places[front], mesh.uv[front]
    assert uv[:, 0] == pytest.approx((places[:, 0] - 1.2) / 1.6, abs=1e-6)
    assert uv[:, 1] == pytest.approx((0.9 - places[:, 1]) / 1.2, abs=1e-6)  # the texture repeats: -1 is its top


def test_on_a_wall_with_a_door_it_goes_on_beyond_the_door() -> None:
    hole = "openings = [{ at = 2, wide = 1, low = 0, high = 2 }]\n"
    made = parse_plan(FLOOR + WALL.replace("LOOK", "oil") + hole + told(SQUARE), "hall.toml")
    room = build_room(made, {"oil": Look(procedural_look("stone").pixels, SIZE_M, np.ones(3), fits=True)})
    [mesh] = [one for one in make_meshes(*make_charts(room), room.looks) if one.look == "oil"]
    front = mesh.normals[:, 2] > 0.99
    assert mesh.uv[front, 0] == pytest.approx(mesh.places[front, 0] / SIZE_M[0], abs=1e-6)
    assert mesh.uv[front, 1] == pytest.approx(-mesh.places[front, 1] / SIZE_M[1], abs=1e-6)


def test_the_pages_textures_have_one_side_and_procedural_ones_still_no_border() -> None:
    photo = Look(np.full((300, 900, 3), 90, np.uint8), SIZE_M, np.ones(3), fits=True)
    sheet = texture_sheet([procedural_look("flags"), photo])
    assert sheet.shape == (2048, 1024, 3)
    flags = sheet[:1024].astype(float)
    inner = np.abs(np.diff(flags, axis=1)).mean()
    assert np.abs(flags[:, 0] - flags[:, -1]).mean() < 2.0 * inner
    assert np.abs(flags.mean(axis=(0, 1)) - procedural_look("flags").pixels.mean(axis=(0, 1))).max() < 0.5
    assert texture_sheet([procedural_look("flags"), procedural_look("stone")]).shape == (512, 256, 3)


@pytest.mark.parametrize(
    ("text", "said"),
    [
        (told(SQUARE[::-1]), "top left, top right"),
        (told([SQUARE[0], SQUARE[2], SQUARE[1], SQUARE[3]]), "top left, top right"),
        (told([[5, 5]] * 4), "top left, top right"),
        (told(SQUARE[:3]), "four places"),
        (told([[10, 10], [400, 20], [390, "nan"], [20, 310]]).replace("'nan'", "nan"), "four places"),
        (told(SQUARE, size=[-1, 1]), "texels each way"),
        (told(SQUARE, texel=1e-300), "texels each way"),
        (told(SQUARE, size=[30, 30], texel=0.001), "texels each way"),
        (told(SQUARE, name='"flags"'), "another look's name"),
        (told(SQUARE, name='"../x"'), "another look's name"),
        (told(SQUARE, file='"../oil.png"'), "beside the plan"),
        (told(SQUARE) * 2, "another look's name"),
        (told(SQUARE).replace("corners", "edges"), "'edges'"),
    ],
)
def test_wrong_photos_are_refused_in_one_sentence(text: str, said: str) -> None:
    with pytest.raises(ClonerError) as error:
        parse_plan(FLOOR + text, "hall.toml")
    assert said in str(error.value)


@pytest.mark.parametrize(
    ("corners", "said"), [([[10, 10], [2000, 20], [390, 300], [20, 310]], "900 x 700"), (SQUARE, "")]
)
def test_corners_outside_and_photos_that_are_none_are_told_with_their_name(
    plan: Path, corners: list, said: str
) -> None:
    plan.write_text(FLOOR + told(corners))
    if not said:
        (plan.parent / "oil.png").write_bytes(b"no photo")
    with pytest.raises(ClonerError) as error:
        make_folder(str(plan), plan.parent / "room")
    assert "oil" in str(error.value)
    assert said in str(error.value)
    assert not (plan.parent / "room").exists()
