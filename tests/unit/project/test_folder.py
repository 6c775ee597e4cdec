"""Photos, person and corrections read from folders, good and bad."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest
from PIL import Image

from cloner.errors import ClonerError
from cloner.frames import ViewId
from cloner.project import folder as project
from cloner.records.points import Correction, Corrections
from cloner.records.terms import Terms

#: Round figures of tailors' tables.
AVERAGE_AT_170_MM = {
    "neck_girth": 360, "bust_girth": 930, "waist_girth": 790, "hip_girth": 990, "thigh_girth": 560,
    "calf_girth": 370, "upper_arm_girth": 290, "wrist_girth": 165, "inside_leg_height": 770, "arm_length": 580,
    "back_waist_length": 420, "shoulder_width": 420, "foot_length": 255, "head_girth": 565, "hand_length": 185,
}  # fmt: skip


def put_photo(folder: Path, name: str, size: tuple[int, int] = (80, 120)) -> Path:
    folder.mkdir(parents=True, exist_ok=True)
    path = folder / name
    Image.new("RGB", size, (90, 120, 150)).save(path, format="PNG")
    return path


def test_photos_are_found_by_view_in_any_case_and_suffix(tmp_path: Path) -> None:
    for name in ("Body_Front.PNG", "body_side.webp", "FACE_front.tif", "holiday.png", "body_back.txt"):
        put_photo(tmp_path, name)
    found = project.find_photos(tmp_path)
    assert {view: path.name for view, path in found.items()} == {
        ViewId.BODY_FRONT: "Body_Front.PNG",
        ViewId.BODY_SIDE: "body_side.webp",
        ViewId.FACE_FRONT: "FACE_front.tif",
    }


@pytest.mark.parametrize("names", [("face_front.png", "face_side.png"), ("body_front.png",), ("face_front.png",)])
def test_fewer_photos_are_a_smaller_job(tmp_path: Path, names: tuple[str, ...]) -> None:
    for name in names:
        put_photo(tmp_path, name)
    assert len(project.load_photos(tmp_path).photos) == len(names)


@pytest.mark.parametrize(
    ("names", "words"),
    [
        (("face_front", "face_side"), ["no body photo"]),
        (("body_front",), ["no side photo", "no back photo"]),
        (("body_front", "body_side", "body_back"), []),
        (("face_front", "body_side", "body_back"), ["no front photo"]),
    ],
)
def test_missing_body_photos_are_said(tmp_path: Path, names: tuple[str, ...], words: list[str]) -> None:
    for name in names:
        put_photo(tmp_path, f"{name}.png")
    told = project.photo_warnings(project.load_photos(tmp_path))
    assert len(told) == len(words)
    assert all(word in warning for word, warning in zip(words, told, strict=True))


@pytest.mark.parametrize("names", [(), ("front.png",), ("body_side.png", "body_back.png"), ("face_side.png",)])
def test_no_front_photo_names_the_files_that_are_expected(tmp_path: Path, names: tuple[str, ...]) -> None:
    for name in names:
        put_photo(tmp_path, name)
    with pytest.raises(ClonerError) as caught:
        project.find_photos(tmp_path)
    assert caught.value.where == tmp_path.name
    assert all(f"{view}.jpg" in caught.value.hint for view in ViewId)


def test_two_photos_of_one_view_are_refused(tmp_path: Path) -> None:
    put_photo(tmp_path, "body_front.png")
    put_photo(tmp_path, "BODY_FRONT.jpg")
    with pytest.raises(ClonerError, match="two photos for body_front"):
        project.find_photos(tmp_path)


def test_a_missing_folder_is_named(tmp_path: Path) -> None:
    with pytest.raises(ClonerError) as caught:
        project.find_photos(tmp_path / "nobody")
    assert caught.value.where == "nobody"
    assert str(tmp_path) not in str(caught.value), "messages must not tell home paths"


def test_person_file_gives_name_height_and_measures(tmp_path: Path) -> None:
    text = 'name = "Zoë"\nheight_cm = 171.5\nnotes = "x"\n[measures]\nwaist = 70.2\ninside_leg_height = 78\n'
    (tmp_path / "person.toml").write_text(text, encoding="utf-8")
    person = project.read_person(tmp_path)
    assert (person.name, person.stature_m, person.stature_is_known, person.notes) == ("Zoë", 1.715, True, "x")
    assert person.tape_mm == (("waist_girth", 702.0), ("inside_leg_height", 780.0))
    assert project.person_warnings(person) == ()


@pytest.mark.parametrize(("text", "terms"), [
    ('name = "Zoë"\nlicence = "everyone"', Terms()),
    ('name = "Zoë"\nconsent = "yes"', Terms("Zoë", "", "own")),
    ('consent = "yes"\nevent = "Fair"\nlicence = "event"', Terms("", "Fair", "event")),
    ("", Terms()),
])  # fmt: skip
def test_only_a_recorded_consent_lets_others_do_anything(tmp_path: Path, text: str, terms: Terms) -> None:
    (tmp_path / "person.toml").write_text(text, encoding="utf-8")
    assert project.read_terms(tmp_path) == terms


def test_an_unknown_licence_is_refused(tmp_path: Path) -> None:
    (tmp_path / "person.toml").write_text('licence = "free for all"', encoding="utf-8")
    with pytest.raises(ClonerError, match="not known") as caught:
        project.read_person(tmp_path)
    assert caught.value.where == "person.toml, licence"
    assert "own, event, everyone" in caught.value.hint


def test_height_of_the_command_line_wins(tmp_path: Path) -> None:
    (tmp_path / "person.toml").write_text("height_cm = 171", encoding="utf-8")
    assert project.read_person(tmp_path, 160.0).stature_m == pytest.approx(1.6)


def test_missing_height_is_assumed_and_said(tmp_path: Path) -> None:
    person = project.read_person(tmp_path)
    assert person.stature_m == pytest.approx(1.70)
    assert not person.stature_is_known
    assert "unscaled" in project.person_warnings(person)[0]


@pytest.mark.parametrize("height", ["1.72", "59.9", "251", "nan", "inf", "-170", "1720"])
def test_absurd_heights_are_refused(tmp_path: Path, height: str) -> None:
    (tmp_path / "person.toml").write_text(f"height_cm = {height}", encoding="utf-8")
    with pytest.raises(ClonerError, match="outside 60 to 250 cm") as caught:
        project.read_person(tmp_path)
    assert caught.value.where == "person.toml, height_cm"
    assert "centimetres" in caught.value.hint
    with pytest.raises(ClonerError) as from_line:
        project.read_person(tmp_path, float(height))
    assert from_line.value.where == "--height-cm"


@pytest.mark.parametrize(
    ("line", "words", "hint"),
    [
        ("wiast_girth = 70", "'wiast_girth' is not known", "waist_girth"),
        ("tail = 70", "'tail' is not known", "bust_girth, underbust_girth"),
        ("waist = 702", "cannot be the waist of a person of 170 cm", "millimetres; write waist = 70.2"),
        ("hip_girth = 0.98", "cannot be", "metres; write hip_girth = 98.0"),
        ("arm_length = 22.5", "cannot be", "inches; write arm_length = 57"),
        ("hip = 7", "cannot be", "Measure again"),
        ('hip = "98"', "must be a length", "number of centimetres"),
        ("hip = nan", "must be a length", "number of centimetres"),
        ("hip = -98", "must be a length", "number of centimetres"),
        ("hip = 98\nhip_girth = 99", "given twice", "Keep one"),
    ],
)
def test_bad_tape_measures_get_one_clear_sentence(tmp_path: Path, line: str, words: str, hint: str) -> None:
    (tmp_path / "person.toml").write_text(f"height_cm = 170\n[measures]\n{line}\n", encoding="utf-8")
    with pytest.raises(ClonerError, match=words) as caught:
        project.read_person(tmp_path)
    assert hint in caught.value.hint
    assert caught.value.where == "person.toml, measures"


@pytest.mark.parametrize("height", [60.0, 120.0, 250.0])
def test_usual_measures_of_small_and_tall_people_are_taken(tmp_path: Path, height: float) -> None:
    lines = [f"{key} = {0.1 * mm * height / 170:.1f}" for key, mm in AVERAGE_AT_170_MM.items()]
    (tmp_path / "person.toml").write_text("[measures]\n" + "\n".join(lines), encoding="utf-8")
    assert dict(project.read_person(tmp_path, height).tape_mm).keys() == AVERAGE_AT_170_MM.keys()


@pytest.mark.parametrize(
    ("text", "words"),
    [
        ("height_cm = ", "not valid TOML"),
        ("measures = 3", "table of centimetres"),
        ('height_cm = "172"', "must be a number"),
        ("height_cm = true", "must be a number"),
        ("heigth_cm = 172", "'heigth_cm' is not known"),
        ("name = 7", "name must be text"),
        ('sex = "x"', "the sex 'x' is not known"),
        ("sex = 1", "sex must be text"),
        ('age = "old"', "age must be years"),
        ("age = 300", "age must be years"),
        ("age = nan", "age must be years"),
        ("age = true", "age must be years"),
    ],
)
def test_malformed_person_files_are_refused(tmp_path: Path, text: str, words: str) -> None:
    (tmp_path / "person.toml").write_text(text, encoding="utf-8")
    with pytest.raises(ClonerError, match=words) as caught:
        project.read_person(tmp_path)
    assert caught.value.where.startswith("person.toml")


@pytest.mark.parametrize(
    ("name", "safe"),
    [
        ("anna", "anna"),
        ("Zoë 7", "Zoë-7"),
        ("../../etc/passwd", "etc-passwd"),
        ("..", "visitor"),
        (".hidden", "hidden"),
        ("a/b\\c:d*e?f", "a-b-c-d-e-f"),
        ("-rf", "rf"),
        ("", "visitor"),
        ("con", "visitor-con"),
        ("line\nbreak\x00", "line-break"),
        ("<script>", "script"),
    ],
)
def test_identifiers_of_hostile_names_are_harmless(name: str, safe: str) -> None:
    assert project.safe_identifier(name) == safe


def test_long_identifiers_are_cut() -> None:
    assert len(project.safe_identifier("ü" * 500).encode()) <= project.LONGEST_IDENTIFIER


def test_corrections_survive_the_file(tmp_path: Path) -> None:
    points = {ViewId.FACE_FRONT: {"nose_tip": Correction(10.25, 20.5, "ab")}, ViewId.BODY_BACK: {}}
    project.write_corrections(tmp_path, Corrections(points=points))
    again = project.read_corrections(tmp_path)
    assert again.points[ViewId.FACE_FRONT]["nose_tip"] == Correction(10.25, 20.5, "ab")
    assert [path.name for path in tmp_path.iterdir()] == ["corrections.json"]


def test_no_corrections_file_means_none(tmp_path: Path) -> None:
    assert not project.read_corrections(tmp_path).points


def test_loaded_photos_carry_digest_name_and_pixels(tmp_path: Path) -> None:
    path = put_photo(tmp_path, "body_front.png")
    photo = project.load_photos(tmp_path).photos[ViewId.BODY_FRONT]
    assert (photo.width_px, photo.height_px, photo.name) == (80, 120, path.name)
    np.testing.assert_array_equal(photo.rgb[5, 5], [90, 120, 150])


@pytest.mark.parametrize("kind", ["rotated", "cmyk", "grey16", "grey", "alpha", "palette"])
def test_unusual_but_sane_photos_just_work(tmp_path: Path, samples: Path, kind: str) -> None:
    plain = Image.open(samples / "anna" / "plain" / "body_front.jpg")
    path = tmp_path / ("body_front.jpg" if kind in {"rotated", "cmyk"} else "body_front.png")
    if kind == "rotated":
        exif = Image.Exif()
        exif[0x0112] = 6  # the camera was turned: show it rotated by 90 degrees
        plain.transpose(Image.Transpose.ROTATE_90).save(path, exif=exif, quality=95)
    elif kind == "grey16":
        Image.fromarray(np.asarray(plain.convert("L")).astype(np.uint16) * 257).save(path)
    else:
        turned = (
            plain.quantize(256) if kind == "palette" else plain.convert({"cmyk": "CMYK", "grey": "L"}.get(kind, "RGBA"))
        )
        turned.save(path)
    photo = project.load_photos(tmp_path).photos[ViewId.BODY_FRONT]
    expected = np.asarray(plain.convert("L"), dtype=float)
    assert (photo.width_px, photo.height_px) == plain.size
    found = np.asarray(Image.fromarray(photo.rgb).convert("L"), dtype=float)
    assert np.abs(found - expected).mean() < 6.0, "more than a colour conversion changed"


def test_a_hundred_megapixels_are_read_small(tmp_path: Path, samples: Path) -> None:
    plain = Image.open(samples / "anna" / "plain" / "body_front.jpg")
    plain.resize((8200, 12300)).save(tmp_path / "body_front.jpg", quality=80)
    photo = project.load_photos(tmp_path).photos[ViewId.BODY_FRONT]
    assert 1800 <= photo.height_px <= 2600
    assert photo.width_px / photo.height_px == pytest.approx(2 / 3, rel=0.01)
