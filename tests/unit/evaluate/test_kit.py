"""People of the generator as visitors: what is read of them, label overlap, texels on another part, and refusals."""

import json
from types import SimpleNamespace

import numpy as np
import pytest
from PIL import Image

from cloner.errors import ClonerError
from cloner.evaluate import kit_scores
from cloner.evaluate.figures.origins import TexelOrigins
from cloner.evaluate.figures.parts import allow_skin_behind, wrong_part_share
from cloner.evaluate.scoreboard import evaluate_visitors
from cloner.evaluate.scores import Score
from cloner.evaluate.truths.baselines import generic_clone
from cloner.evaluate.truths.kit import is_kit_person, kit_people, photos_without_truth, read_kit
from cloner.evaluate.truths.labels import label_ious
from cloner.evaluate.truths.truth import truth_camera
from cloner.frames import ViewId
from cloner.generic.load import load_generic
from cloner.head.jaw import with_open_jaw
from cloner.records.labels import LABELS
from cloner.vision.photographs import pictures
from kit import studio

SIZE = (120, 180)
SKIN, UPPER = LABELS.index("face_skin"), LABELS.index("upper_clothes")
VIEWS = {"body_front": 0.0, "face_front": 0.0, "three_quarter": 45.0}


def seen_body():
    """Return the generic human's body and its triangles."""
    generic = load_generic()
    body = generic.vertex_part == generic.part_names.index("body")
    triangles = generic.triangles()[0].astype(np.int32)
    return generic, generic.vertices_m[body].astype(float), triangles[body[triangles].all(axis=1)]


def is_arm(generic, count):
    """Return (count,) which of the first vertices belong to the arms."""
    names = np.array(generic.segment_names)[generic.vertex_segment[:count]]
    return np.array([name.endswith(("upper_arm", "forearm", "hand")) for name in names])


def drawn_labels(generic, body_m, triangles, camera):
    """Return a label picture of a person in a sleeveless suit: arms of skin, all else upper clothes."""
    arms = is_arm(generic, len(body_m))[triangles].all(axis=1)
    colours = np.where(arms[:, None], (255, 0, 0), (0, 255, 0))
    picture = studio.picture(body_m, triangles, camera, colours=colours, background=(0, 0, 255))
    labels = np.where(picture[..., 0] > picture[..., 1], SKIN, UPPER)
    return np.where(picture[..., 2] == 255, 0, labels).astype(np.uint8)


def write_person(folder, jaw_rad=0.0):
    """Write one person as the generator does, small: the generic human before a wall; the body's photo with its mouth
    open.
    """
    generic, body_m, triangles = seen_body()
    open_m = with_open_jaw(generic, generic.vertices_m.astype(float), generic.joints_m.astype(float), jaw_rad)[
        : len(body_m)
    ]
    folder.mkdir(parents=True)
    names = ("nose_tip", "crotch", "chin_bottom")
    cameras, points = {}, {name: open_m[generic.feature(name)].tolist() for name in names}
    joints = {f"{name}_{side}": [0.0, 1.0, 0.0] for name in ("eye", "hip") for side in "LR"}
    for view, azimuth in VIEWS.items():
        camera = studio.camera(azimuth, size_px=SIZE)
        labels = drawn_labels(generic, body_m, triangles, camera)
        Image.fromarray(labels).convert("P").save(folder / f"{view}_labels.png")
        Image.fromarray(np.full((SIZE[1], SIZE[0], 3), 99, np.uint8)).save(folder / f"{view}.jpg")
        cameras[view] = {
            "width": SIZE[0], "height": SIZE[1], "cx": SIZE[0] / 2, "cy": SIZE[1] / 2, "fx": camera.focal_px,
            "world_to_camera": camera.camera_from_model.tolist(),
        }  # fmt: skip
    marks = {"nose_tip": {"xy": [60.0, 20.0], "visible": True, "in_frame": True}}
    truth = {
        "cameras": cameras, "stature_mm": 1700.0, "sole_height_mm": 20.0, "girths_mm": {"waist": 800.0},
        "measured_in_pose_of": "body_front", "points_3d_m": points, "joints_3d_m": joints,
        "points_3d_m_by_view": dict.fromkeys(VIEWS, points), "joints_3d_m_by_view": dict.fromkeys(VIEWS, joints),
        "features": {view: {"points": marks} for view in VIEWS},
    }  # fmt: skip
    (folder / "truth.json").write_text(json.dumps(truth))
    quads = generic.quads[(generic.quads < len(body_m)).all(axis=1)]
    held = {f"vertices_{view}": (open_m if view == "body_front" else body_m).astype(np.float32) for view in VIEWS}
    np.savez(folder / "truth_body.npz", vertices=body_m, faces=quads, **held)
    return folder


@pytest.fixture
def person(tmp_path):
    return write_person(tmp_path / "people" / "p00001")


def test_a_person_is_found_alone_and_among_others(person, samples):
    assert is_kit_person(person)
    assert kit_people([person]) == [person]
    assert kit_people([person.parent]) == [person]
    assert kit_people([samples / "anna"]) == []


def test_a_clone_sees_the_photos_alone(person):
    with photos_without_truth(person) as folder:
        assert sorted(path.name for path in folder.iterdir()) == ["body_front.jpg", "face_front.jpg"]
        assert folder.name == "p00001"


def test_a_clone_sees_none_of_the_photos_kept_back(person, monkeypatch):
    seen = []

    def refuse(photos, stature_m, out, *, labelled):
        seen.extend(path.name for path in photos.iterdir())
        raise ClonerError("no person found in this photo", "Take it again", "face_front.jpg")

    monkeypatch.setattr(kit_scores, "clone_in_process", refuse)
    evaluate_visitors([person], shown=(ViewId.FACE_FRONT, ViewId.FACE_SIDE))
    assert seen == ["face_front.jpg"]


def test_photos_kept_back_are_scored_as_views_that_no_photo_showed(person, monkeypatch):
    def name_them(subject, generic, views, rotations, keep):
        yield Score("views", " ".join(views), "", 1.0)

    monkeypatch.setattr(kit_scores, "held_out_scores", name_them)
    kit, generic = read_kit(person), load_generic()
    clone = generic_clone(generic, kit.truth.stature_m)
    hidden = kit_scores.held_out_names((ViewId.FACE_FRONT,))
    first = next(kit_scores.subject_scores(clone, SimpleNamespace(clone=clone), generic, kit, hidden, {}))
    assert first.view == "face_three_quarter body_front"


def test_the_truth_is_read_in_our_words(person):
    kit = read_kit(person)
    truth = kit.truth
    assert (truth.stature_m, truth.sole_m, truth.girths_mm) == (1.7, 0.02, {"waist": 800.0})
    assert set(truth.views) == {"body_front", "face_front", "face_three_quarter"}
    assert truth.views["body_front"].marks_px["nose_tip"] == pytest.approx([59.5, 19.5]), "pixel centres are whole"
    assert np.array_equal(truth.views["face_front"].mask, kit.labels["face_front"] > 0)
    heights = truth.surface.points_m[truth.surface.kind == "bare", 1]
    assert heights.max() == pytest.approx(kit.bodies_m["body_front"][:, 1].max(), abs=0.01)
    assert truth.surface.marks_m["crotch"][1] > 0.5


def test_the_truth_of_a_large_photo_is_reduced_with_it(person, monkeypatch):
    whole = read_kit(person).truth.views["body_front"]
    monkeypatch.setattr(pictures, "LONGEST_SIDE_PX", SIZE[1] // 2)
    kit = read_kit(person)
    seen = kit.truth.views["body_front"]
    assert seen.photo.shape[:2] == seen.mask.shape == kit.labels["body_front"].shape == (SIZE[1] // 2, SIZE[0] // 2)
    assert (seen.camera.width_px, seen.camera.height_px) == (SIZE[0] // 2, SIZE[1] // 2)
    assert seen.marks_px["nose_tip"] == pytest.approx([29.5, 9.5])
    top_m = np.array([[0.0, 1.7, 0.0]])
    assert (seen.camera.project(top_m) + 0.5) * 2.0 == pytest.approx(whole.camera.project(top_m) + 0.5)


def test_a_mouth_that_one_photo_shows_open_is_shut_in_the_truth(tmp_path):
    generic, body_m, _ = seen_body()
    kit = read_kit(write_person(tmp_path / "p00002", jaw_rad=0.2))
    shut = body_m[generic.feature("chin_bottom")]
    assert np.linalg.norm(kit.bodies_m["body_front"][generic.feature("chin_bottom")] - shut) > 0.01
    assert kit.truth.surface.marks_m["chin_bottom"] == pytest.approx(shut, abs=1e-5)
    assert kit.truth.surface.bare_m == pytest.approx(body_m, abs=1e-5)


def test_a_lens_beside_the_picture_s_middle_is_refused_and_half_a_pixel_is_none():
    held = {"width": 640, "height": 853, "cx": 320.0, "cy": 426.667, "fx": 900.0, "world_to_camera": np.eye(4)}
    assert truth_camera(held).height_px == 853
    with pytest.raises(ValueError, match="principal point"):
        truth_camera(held | {"cy": 430.0})


def test_a_broken_label_picture_is_refused(person):
    Image.fromarray(np.full((4, 4), 99, np.uint8)).convert("P").save(person / "body_front_labels.png")
    with pytest.raises(ClonerError, match="label"):
        read_kit(person)


def test_overlap_of_labels_is_counted_beside_the_borders():
    true = np.zeros((40, 60), np.uint8)
    true[:, 20:] = LABELS.index("hair")
    shifted = np.roll(true, 2, axis=1)
    shifted[:, :2] = 0
    assert label_ious(shifted, true) == {"background": 1.0, "hair": 1.0}, "two pixels lie in the band"
    half = true.copy()
    half[20:, 30:] = 0  # 20 rows of 30 columns lost: of 40 x 36 judged pixels of hair (3 px off the border are not)
    assert label_ious(half, true)["hair"] == pytest.approx(1.0 - 600 / (40 * 37), abs=0.03)
    assert label_ious(half, true)["background"] == pytest.approx(40 * 17 / (40 * 17 + 600), abs=0.03)


def origins_of(kit, rows):
    """Return texels in the middle of triangles, each from where the front photo truly shows it."""
    _, body_m, triangles = seen_body()
    corners = triangles[rows]
    pixel = kit.truth.views["body_front"].camera.project(body_m[corners].mean(axis=1))
    third = np.full((len(rows), 3), 1.0 / 3.0, np.float32)
    flags = np.zeros(len(rows), bool)
    return TexelOrigins(corners, third, np.zeros(len(rows), int), flags, pixel.astype(np.float32), (ViewId.BODY_FRONT,))


def test_texels_from_another_part_are_counted(person):
    kit, (generic, body_m, triangles) = read_kit(person), seen_body()
    normals = np.cross(*(body_m[triangles[:, k]] - body_m[triangles[:, 0]] for k in (1, 2)))
    front = normals[:, 2] > 0.9 * np.linalg.norm(normals, axis=1)
    arm = front & is_arm(generic, len(body_m))[triangles].all(axis=1)
    names = np.array(generic.segment_names)[generic.vertex_segment[triangles[:, 0]]]
    rows = np.concatenate([np.flatnonzero(arm), np.flatnonzero(front & (names == "torso"))])
    right = origins_of(kit, rows)
    assert wrong_part_share(right, generic, kit) == pytest.approx(0.0, abs=0.02)
    torso, inner = len(rows) - int(arm.sum()), origins_of(kit, rows)
    middle = np.median(right.pixel_px[:10], axis=0)  # a place on an arm
    streak = np.where(np.arange(len(rows))[:, None] >= int(arm.sum()), middle, right.pixel_px).astype(np.float32)
    wrong = TexelOrigins(inner.vertices, inner.barycentric, inner.view, inner.mirrored, streak, inner.views)
    share = torso / len(rows)
    assert wrong_part_share(wrong, generic, kit) == pytest.approx(share, abs=0.15 * share + 0.02)


def test_a_face_behind_hair_is_skin_and_a_beard_is_none():
    bit = {name: 1 << LABELS.index(name) for name in ("hair", "accessory", "beard", "upper_clothes", "body_skin")}
    near = np.array([bit["hair"], bit["hair"] | bit["accessory"], bit["beard"], bit["hair"] | bit["upper_clothes"], 0])
    skin = allow_skin_behind(near, np.ones(5, bool)) & bit["body_skin"]
    assert list(skin > 0) == [True, True, False, False, False]
    assert np.array_equal(allow_skin_behind(near, np.zeros(5, bool)), near)


def test_a_refused_person_is_a_row_and_a_sentence(person, monkeypatch):
    def refuse(photos, stature_m, out, *, labelled):
        assert stature_m == pytest.approx(1.7)
        assert not (photos / "truth.json").exists()
        raise ClonerError("no person found in this photo", "Take it again", "face_side.jpg")

    monkeypatch.setattr(kit_scores, "clone_in_process", refuse)
    told = []
    rows = evaluate_visitors([person.parent], report=told.append)
    assert [(row["visitor"], row["metric"], row["value"]) for row in rows] == [("p00001", "cloned", 0.0)]
    assert told == ["p00001: refused: face_side.jpg: no person found in this photo. Take it again"]


def test_a_defect_costs_one_person_and_no_other_s_rows(person, monkeypatch):
    def fail(photos, stature_m, out, *, labelled):
        raise ZeroDivisionError("somewhere")

    monkeypatch.setattr(kit_scores, "clone_in_process", fail)
    told = []
    rows = evaluate_visitors([person.parent], report=told.append)
    assert [(row["visitor"], row["metric"], row["value"]) for row in rows] == [("p00001", "cloned", 0.0)]
    assert told == ["p00001: not cloned: a defect of Cloner (ZeroDivisionError); report what --verbose says"]
