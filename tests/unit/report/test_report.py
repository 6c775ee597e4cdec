"""What a report tells, on a clone whose outline is known exactly."""

from __future__ import annotations

import json
from pathlib import Path

import numpy as np
import pytest

from cloner.frames import ViewId
from cloner.generic.tape import load_tape_rules
from cloner.geometry.measurement.measuring import measures_mm
from cloner.pipeline import StageReport
from cloner.records.clones import Clone
from cloner.records.heads import HeadFit
from cloner.records.measures import MEASURE_KEYS, Cover
from cloner.records.photos import Person, Photo, PhotoSet
from cloner.records.points import ObeyedPoint, PointSet, ViewPoints
from cloner.records.proposals import Proposal, Proposals
from cloner.records.results import Residual
from cloner.records.silhouettes import Silhouette, SilhouetteSet
from cloner.records.views import View, ViewSet
from cloner.render import render_mask
from cloner.report.agreement import PhotoAgreement, agreements, compare
from cloner.report.build import Run, build_report
from cloner.report.page import page
from cloner.report.weak import group_warnings, is_grey, photo_weaknesses
from cloner.report.write import write_page, write_report
from cloner.stages.measures import estimate_measures, measures_of_mesh
from cloner.vision.retouching.open_mouth import INNER_LIPS
from kit.clones import toy_clone

pytestmark = pytest.mark.gl


@pytest.fixture(scope="module")
def clone() -> Clone:
    return toy_clone()


@pytest.fixture(scope="module")
def values(clone: Clone) -> dict[str, object]:
    front = clone.views[ViewId.BODY_FRONT]
    size = (front.camera.height_px, front.camera.width_px)
    mask = render_mask(clone, front.camera, front.rotations)
    outline = Silhouette(ViewId.BODY_FRONT, (), mask, (("crotch-knee", "edges", 0.8), ("rest", "mask", 0.0)))
    photo = Photo(
        ViewId.BODY_FRONT, np.full((*size, 3), (10, 60, 110), dtype=np.uint8), 50.0, "ab" * 32, "body_front.jpg"
    )
    named = ViewPoints(
        ViewId.BODY_FRONT, ("crotch", "waist_left"), np.array([[10.0, 20.0], [30.5, 40.0]]), [0.4, 1.0], [False, True]
    )
    person = Person("toy", "<b>Tö & y</b>", 1.70, False, "", (("waist_girth", 712.0),))
    covers = {f"{side}_forearm": Cover((False,) * 8, 0.9) for side in ("left", "right")}
    shown = measures_mm(clone.vertices_m, clone.joints_m, load_tape_rules())
    measures, _ = estimate_measures({**shown, "waist_girth": 760.0}, person, covers)
    head = HeadFit(np.zeros((1, 3)), {}, np.zeros(3), 0.006, "")
    return {
        "person": person,
        "measures": measures,
        "photos": PhotoSet({ViewId.BODY_FRONT: photo}),
        "clone": clone,
        "silhouettes": SilhouetteSet({ViewId.BODY_FRONT: outline}),
        "obeyed_silhouettes": SilhouetteSet({ViewId.BODY_FRONT: outline}),
        "obeyed_points": (ObeyedPoint(ViewId.BODY_FRONT, "waist_left", "outline", 12.25, 0.04, 13.0),),
        "body_points": PointSet({ViewId.BODY_FRONT: named}),
        "face_points": PointSet({}),
        "views": ViewSet({ViewId.BODY_FRONT: View(ViewId.BODY_FRONT, front.camera, "front", True)}),
        "head": head,
        "proposals": Proposals({}),
    }


@pytest.fixture(scope="module")
def run() -> Run:
    stage = StageReport(
        "views", 1.5, 1.2, 300.0, (Residual("gap", 2.5, "mm", "body_front"),), ("soft edge in face_side", "again")
    )
    return Run(9.0, 7.0, 400.0, (stage,), 3, ("glb",), ("No height was given", "again"))


@pytest.fixture(scope="module")
def report(values: dict[str, object], run: Run) -> dict[str, object]:
    seen = agreements(values["clone"], values["obeyed_silhouettes"])
    return build_report(values, run, seen, ["clone.glb", "previews/beside_body_front.jpg", "report.json"])


def test_a_clone_agrees_with_its_own_outline(report: dict) -> None:
    assert report["silhouette_iou"]["body_front"] > 0.99
    assert report["outline_rms"]["body_front"]["px"] < 0.7, "only the drawing's own fineness may differ"


def test_corrected_points_are_told_before_and_after(report: dict) -> None:
    (told,) = report["corrections"]
    assert (told["view"], told["name"], told["kind"]) == ("body_front", "waist_left", "outline")
    assert (told["px_before"], told["px_after"], told["moved_mm"]) == (12.25, 0.04, 13.0)
    assert "Corrected points" in page(report)
    assert "Corrected points" not in page({**report, "corrections": []})


def test_a_shifted_outline_is_measured(clone: Clone, values: dict) -> None:
    outline = values["silhouettes"].views[ViewId.BODY_FRONT]
    shifted = Silhouette(outline.view, (), np.roll(outline.mask, 4, axis=1), ())
    found = agreements(clone, SilhouetteSet({ViewId.BODY_FRONT: shifted}))[ViewId.BODY_FRONT]
    assert 0.8 < found.iou < 0.97
    assert 2.0 < found.outline_rms_px <= 4.1
    camera = clone.views[ViewId.BODY_FRONT].camera
    scale_mm = 1e3 * camera.metres_per_pixel(clone.vertices_m.mean(axis=0))
    assert found.outline_rms_mm == pytest.approx(found.outline_rms_px * scale_mm)


def test_masks_of_squares_have_the_known_overlap() -> None:
    first, second = np.zeros((2, 60, 60), dtype=bool)
    first[10:50, 10:50] = True
    second[10:50, 20:60] = True
    assert compare(first, second, 2.0).iou == pytest.approx(30 / 50)
    assert compare(first, first, 2.0).outline_rms_mm == 0.0
    assert compare(first, np.zeros_like(first), 1.0).iou == 0.0


def test_everything_has_its_origin(report: dict, clone: Clone) -> None:
    assert report["features"]["body_front"]["waist_left"] == {
        "x_px": 30.5,
        "y_px": 40.0,
        "confidence": 1.0,
        "source": "corrected",
    }
    assert report["features"]["body_front"]["crotch"]["source"] == "proposed"
    assert [piece["source"] for piece in report["outline_segments"]["body_front"]] == ["edges", "mask"]
    assert report["residuals"] == [{"stage": "views", "name": "gap", "view": "body_front", "value": 2.5, "unit": "mm"}]
    assert report["warnings"] == [
        "No height was given",
        "again",
        "soft edge in face_side",
        "No photo shows the head from the side or behind: the hair there is a guess",
    ]
    assert report["side_shown"] == {"body_side": None, "face_side": None}
    np.testing.assert_allclose(report["features_m"]["head_top"], clone.features_m["head_top"], atol=1e-5)
    assert all(len(digest) == 64 for digest in report["models"].values())


def test_every_measure_is_told_with_its_uncertainty_and_in_plain_words(report: dict) -> None:
    assert report["stature"]["known"] is False
    assert report["stature"]["plus_minus_m"] > 0
    told = report["measures_mm"]
    assert set(told["values"]) == set(MEASURE_KEYS)
    assert all(measure["plus_minus"] > 0 for measure in told["values"].values())
    waist = told["values"]["waist_girth"]
    assert (waist["value"], waist["taped"], waist["plus_minus"]) == (712.0, True, 5.0)
    assert sum(told["clothes"]["above_waist"].values()) == pytest.approx(1.0, abs=0.01)
    words = " ".join(told["clothes"]["words"])
    assert "Bare skin: forearms." in words
    assert f"waist {waist['over_clothes'] - 712:.0f} mm" in words, "what exceeds the tape is cloth"
    html = page(report)
    assert "Inside leg" in html or "inside leg" in html
    assert "by tape" in html


def test_without_a_body_photo_measures_are_said_to_be_generic(values: dict, run: Run, clone: Clone) -> None:
    shown = measures_mm(clone.vertices_m, clone.joints_m, load_tape_rules())
    report = build_report(
        {**values, "obeyed_silhouettes": SilhouetteSet({}), "measures": measures_of_mesh(shown)}, run, {}
    )
    assert report["measures_mm"]["measured"] is False
    assert "generic" in report["measures_mm"]["note"]
    assert all(measure["plus_minus"] is None for measure in report["measures_mm"]["values"].values())
    assert "generic" in page(report)


def test_the_page_escapes_what_people_wrote(report: dict) -> None:
    html = page(report)
    assert "<b>" not in html
    assert "&lt;b&gt;Tö &amp; y&lt;/b&gt;" in html
    assert 'src="previews/beside_body_front.jpg"' in html
    assert "height was given" in html
    assert "<li>Soft edge in face side.</li>" in html, "notes are sentences in plain words"


def test_files_are_json_and_html(report: dict, tmp_path: Path) -> None:
    shown, told = write_page(report, tmp_path), write_report(report, tmp_path)
    assert json.loads(told.read_text(encoding="utf-8"))["person"]["name"] == "<b>Tö & y</b>"
    assert shown.read_text(encoding="utf-8").startswith("<!doctype html>")


def portrait(eyes_px: float, lips_px: float) -> Proposal:
    points = np.zeros((468, 2))
    points[33], points[263] = (100.0, 100.0), (100.0 + eyes_px, 100.0)
    across = np.linspace(150.0 - eyes_px / 4.0, 150.0 + eyes_px / 4.0, 11)
    for border, row_px in zip(INNER_LIPS, (200.0, 200.0 + lips_px), strict=True):
        points[list(border)] = np.column_stack([across, np.full(11, row_px)])
    pose = np.zeros((33, 2))
    small = np.zeros((4, 4), dtype=np.uint8)
    return Proposal(ViewId.FACE_FRONT, pose, np.ones(33), points, np.zeros(468), 1.0, small, small)


@pytest.mark.parametrize(
    ("eyes_px", "lips_px", "words"),
    [(300.0, 0.0, []), (60.0, 0.0, ["small"]), (300.0, 30.0, ["open"]), (60.0, 6.0, ["small", "open"])],
)
def test_weak_face_photos_are_said(values: dict, eyes_px: float, lips_px: float, words: list[str]) -> None:
    photo = values["photos"].photos[ViewId.BODY_FRONT]
    photos = PhotoSet({ViewId.BODY_BACK: photo})
    told = photo_weaknesses(photos, Proposals({ViewId.FACE_FRONT: portrait(eyes_px, lips_px)}), {})
    assert len(told) == len(words)
    assert all(word in sentence for word, sentence in zip(words, told, strict=True))


def test_a_badly_covered_outline_is_said() -> None:
    bad, fine = PhotoAgreement(0.82, 9.0, 9.0), PhotoAgreement(0.97, 1.0, 1.0)
    told = photo_weaknesses(PhotoSet({}), Proposals({}), {ViewId.BODY_SIDE: bad, ViewId.BODY_BACK: fine})
    assert [each for each in told if "outline" in each] == [
        "body_side: the clone covers the person's outline only to 82 percent"
    ]


def test_what_is_said_of_several_photos_is_said_once() -> None:
    told = ["No height", "body_front: dark", "face_side: dark", "body_front: dark", "No height", "hint: dark"]
    assert group_warnings(told) == ("No height", "body_front, face_side: dark", "hint: dark")


def test_black_and_white_photos_are_known() -> None:
    grey = np.repeat(np.arange(64, dtype=np.uint8)[:, None, None].repeat(64, axis=1), 3, axis=2)
    spotted = grey.copy()
    spotted[32, 32] = (200, 30, 30)
    assert is_grey(Photo(ViewId.FACE_SIDE, grey, None, "", "face_side.png"))
    assert not is_grey(Photo(ViewId.FACE_SIDE, spotted, None, "", "face_side.png"))
