"""The head stage gets a known synthetic head back from exact points and its profile."""

from __future__ import annotations

import json
from dataclasses import replace
from pathlib import Path

import cv2
import numpy as np
import pytest

from cloner.detectors.face.face_net import load_face_net
from cloner.detectors.face.face_points import propose_face_points
from cloner.detectors.nets import litert
from cloner.evaluate.measures import face_motion
from cloner.frames import ViewId
from cloner.generic.face_grids import eye_grid, eyeball
from cloner.generic.load import load_generic
from cloner.geometry.meshes.alignment import similarity_alignment
from cloner.head.ears import ear_modes
from cloner.head.modes import load_head_modes
from cloner.records.bodies import Phenotype
from cloner.records.photos import Photo, PhotoSet
from cloner.records.points import PointSet, ViewPoints
from cloner.records.proposals import Proposal, Proposals
from cloner.records.silhouettes import SilhouetteSet
from cloner.records.views import Camera
from cloner.stages import head
from kit.scripts import script

WIDTH, HEIGHT, FOCAL_35MM = 900, 1200, 80.0
STATURE_M = 1.70
FRONT_NAMES = ("eye_inner_L", "eye_inner_R", "nose_tip", "nasion", "mouth_corner_L", "mouth_corner_R", "chin_front")
LIPS = ("lip_top", "stomion", "lip_bottom")
SIDE_NAMES = ("glabella", "nasion", "nose_tip", "subnasale", *LIPS, "chin_front", "chin_bottom")


def camera(azimuth_deg: float, target: np.ndarray) -> Camera:
    azimuth = np.radians(azimuth_deg)
    c, s = np.cos(azimuth), np.sin(azimuth)
    pose = np.eye(4)
    pose[:3, :3] = np.array([[c, 0, -s], [0, -1, 0], [-s, 0, -c]])
    pose[:3, 3] = np.array([0.01, 0.02, 1.15]) - pose[:3, :3] @ target
    return Camera(WIDTH, HEIGHT, FOCAL_35MM / 36.0 * HEIGHT, pose)


def true_person(seed: int):
    """Return vertices (V, 3) of a random face on the mean body, metres."""
    generic = load_generic()
    vertices, _ = generic.shape(np.zeros(1), STATURE_M)
    rng = np.random.default_rng(seed)
    coefficients = rng.normal(size=len(generic.face_basis))
    vertices[generic.head_vertices] += np.tensordot(coefficients, generic.face_basis, axes=1)
    return vertices


def mask_of(vertices: np.ndarray, view: Camera) -> np.ndarray:
    generic = load_generic()
    triangles, _ = generic.triangles()
    inside = np.zeros(len(vertices), dtype=bool)
    inside[generic.head_vertices] = True
    inside |= (vertices[:, 1] > 1.25) & (np.abs(vertices[:, 0]) < 0.2)
    mask = np.zeros((HEIGHT * 2, WIDTH * 2), dtype=np.uint8)
    pixels = np.round((view.project(vertices) + 0.5) * 2 - 0.5).astype(np.int32)
    for corners in triangles[inside[triangles].all(axis=1)]:
        cv2.fillConvexPoly(mask, pixels[corners], 255)
    return cv2.resize(mask, (WIDTH, HEIGHT), interpolation=cv2.INTER_AREA)


def photographed(vertices: np.ndarray, *, noise_px: float = 0.0, side: bool = True, azimuth_deg: float = -90.0,
                 ears: tuple[tuple[str, ...], tuple[str, ...]] = ((), ())):  # fmt: skip
    """Return the stage's inputs for exact (or noisy) points of known vertices; ``ears`` names more, front and side."""
    generic, net, rng = load_generic(), load_face_net(), np.random.default_rng(0)
    target = vertices[generic.feature("nasion")] - [0.0, 0.03, 0.06]
    photos, proposals, points = {}, {}, {}
    for view, names, seen in (
        (ViewId.FACE_FRONT, FRONT_NAMES + ears[0], camera(0.0, target)),
        (ViewId.FACE_SIDE, SIDE_NAMES + ears[1], camera(azimuth_deg, target)),
    ):
        if view is ViewId.FACE_SIDE and not side:
            continue
        face = net.places.at(vertices) if view is ViewId.FACE_FRONT else np.zeros((468, 3))
        face_px = seen.project(face) if view is ViewId.FACE_FRONT else np.zeros((468, 2))
        if view is ViewId.FACE_FRONT:  # points as the net is known to draw them, not where they truly are
            made = script("calibrate_head_net")
            coefficients, _, turned = made.coefficients_of(made.fitted_shapes(), vertices[generic.head_vertices])
            drawn = load_head_modes().errors_m(coefficients, made.rest_camera(seen, turned))
            face_px = face_px + drawn / seen.metres_per_pixel(face.mean(axis=0))
        face_px = face_px + noise_px * rng.normal(size=face_px.shape)
        mask = mask_of(vertices, seen)
        presence = 1.0 if view is ViewId.FACE_FRONT else 0.0
        photos[view] = Photo(view, np.zeros((HEIGHT, WIDTH, 3), np.uint8), FOCAL_35MM, "", str(view))
        proposals[view] = Proposal(
            view, np.zeros((33, 2)), np.zeros(33), face_px, np.zeros(468), presence, mask, np.zeros_like(mask)
        )
        named = seen.project(vertices[[generic.feature(n) for n in names]])
        points[view] = ViewPoints(view, names, named, np.full(len(names), 0.8), np.zeros(len(names), dtype=bool))
    return PhotoSet(photos), Proposals(proposals), PointSet(points)


def fit(photos, proposals, points, *, stature_m=STATURE_M):
    return head.run(
        photos=photos, proposals=proposals, face_points=points, silhouettes=SilhouetteSet({}),
        phenotype=Phenotype(np.zeros(1), stature_m, 0.02, {}, {}),
        tick=lambda fraction: None,
    )  # fmt: skip


def face_error_mm(found: np.ndarray, true: np.ndarray) -> float:
    """Return the mean distance of face vertices after a similarity (the photos tell no size), mm."""
    generic = load_generic()
    face = generic.region("face")[generic.head_vertices] & ~generic.region("mouth_interior")[generic.head_vertices]
    source, target = found[face], true[generic.head_vertices][face]
    scale, rotation, shift = similarity_alignment(source, target)
    return 1000.0 * float(np.linalg.norm(scale * source @ rotation.T + shift - target, axis=1).mean())


@pytest.mark.parametrize(("seed", "azimuth_deg", "shown"), [(1, -90.0, "right"), (2, 84.0, "left")])
def test_a_known_face_comes_back(seed, azimuth_deg, shown):
    true = true_person(seed)
    generic = load_generic()
    result = fit(*photographed(true, azimuth_deg=azimuth_deg))
    fitted = result.values["head"]
    start = generic.shape(np.zeros(1), STATURE_M)[0][generic.head_vertices]
    error = face_error_mm(fitted.vertices_m, true)
    assert fitted.side_shown == shown
    # a millimetre of doubt in points on photographs, and faces outside the family, leave this much of an exact one
    assert error < 1.45, f"seed {seed}: {error:.2f} mm"
    assert error < 0.52 * face_error_mm(start, true)  # heads of two families are expected, not of this one alone
    front = fitted.cameras[ViewId.FACE_FRONT]
    assert np.linalg.norm(front.position_m - camera(0.0, true[generic.feature("nasion")]).position_m) < 0.12


def test_ears_go_where_both_photos_show_them():
    """Ears some 11 mm off where this face usually has them come nearer; the rest may be a turn of the side photo."""
    generic = load_generic()
    names = ("ear_top", "ear_lobe", "ear_outer")
    both, near = tuple(f"{n}_{s}" for n in names for s in "LR"), tuple(f"{n}_R" for n in names)
    true, fields = true_person(8), ear_modes(generic)
    true[generic.head_vertices] += 3.0 * fields[1] - 3.0 * fields[2] + 2.0 * fields[4]
    rows = [int(np.flatnonzero(generic.head_vertices == generic.feature(name))[0]) for name in both]
    face = generic.region("face")[generic.head_vertices]
    away = {}
    for kind, ears in (("named", (both, near)), ("unnamed", ((), ()))):
        found = fit(*photographed(true, ears=ears)).values["head"].vertices_m
        scale, rotation, shift = similarity_alignment(found[face], true[generic.head_vertices][face])
        error = scale * found[rows] @ rotation.T + shift - true[generic.head_vertices][rows]
        away[kind] = np.linalg.norm(error, axis=1).mean()
    assert away["unnamed"] > 0.004
    assert away["named"] < 0.75 * away["unnamed"]


@pytest.mark.parametrize("turn_deg", [-9.0, 9.0])
def test_a_side_photo_beside_the_profile_is_seen_as_turned(turn_deg):
    """Ear, eye, wing and mouth corner tell how far the head turned from 90 degrees; the outline alone does not."""
    inside = ("ear_top", "ear_lobe", "ear_back", "ear_outer", "eye_outer", "ala", "mouth_corner")
    true = true_person(5)
    ears = ((), tuple(f"{name}_R" for name in inside))
    cameras = fit(*photographed(true, azimuth_deg=-90.0 + turn_deg, ears=ears)).values["head"].cameras
    front, side = (cameras[view].camera_from_model[2, :3] for view in (ViewId.FACE_FRONT, ViewId.FACE_SIDE))
    between = np.degrees(np.arctan2(side[0], side[2]) - np.arctan2(front[0], front[2]))
    turned = (between + 90.0 + 180.0) % 360.0 - 180.0
    assert turned == pytest.approx(turn_deg, abs=4.5)


def test_noise_stays_noise():
    true = true_person(3)
    exact = face_error_mm(fit(*photographed(true)).values["head"].vertices_m, true)
    # 3 px are 1 mm here; 468 points and the prior average it, so the face may lose less than half of it.
    noisy = face_error_mm(fit(*photographed(true, noise_px=3.0)).values["head"].vertices_m, true)
    assert noisy < exact + 0.5


def test_wrong_points_make_no_monster():
    true = true_person(4)
    photos, proposals, points = photographed(true)
    front = proposals.views[ViewId.FACE_FRONT]
    wrong = np.array(front.face_px)
    wrong[::12] += 150.0  # 39 of 468 points, by two eye distances
    broken = Proposal(
        front.view, front.pose_px, front.pose_visibility, wrong, front.face_depth, 1.0, front.mask, front.labels
    )
    result = fit(photos, Proposals({**proposals.views, front.view: broken}), points)
    assert face_error_mm(result.values["head"].vertices_m, true) < 2.0


def test_without_a_side_photo_it_warns_and_stays_human():
    true = true_person(5)
    result = fit(*photographed(true, side=False))
    fitted = result.values["head"]
    assert fitted.side_shown == ""
    assert any("side photo" in w for w in result.warnings)
    assert face_error_mm(fitted.vertices_m, true) < 2.5


def test_a_profile_laid_on_something_else_is_not_believed():
    """The side photo's points stand where hair hangs: a face twice as tall as the one in the front photo."""
    true = true_person(5)
    photos, proposals, points = photographed(true)
    beside = points.views[ViewId.FACE_SIDE]
    nose = beside.points_px[beside.names.index("nose_tip")]
    tall = nose + (beside.points_px - nose) * [0.3, 2.2]
    wrong = replace(beside, points_px=tall)
    result = fit(photos, proposals, PointSet({**points.views, ViewId.FACE_SIDE: wrong}))
    fitted = result.values["head"]
    assert fitted.side_shown == ""
    assert ViewId.FACE_SIDE not in fitted.cameras
    assert sum("no profile was found in the side photo" in warning for warning in result.warnings) == 1


def test_without_any_face_it_gives_the_generic_head_and_says_so():
    generic = load_generic()
    result = fit(PhotoSet({}), Proposals({}), PointSet({}))
    start = generic.shape(np.zeros(1), STATURE_M)[0][generic.head_vertices]
    skin = generic.vertex_part[generic.head_vertices] == generic.part_names.index("body")  # the tongue is laid anew
    away = np.linalg.norm(result.values["head"].vertices_m - start, axis=1)[skin]
    # half way to the canonical face, nothing of a person's own
    assert np.median(away) < 0.0025
    assert away.max() < 0.008
    assert any("generic" in w for w in result.warnings)


def test_a_correction_wins_and_takes_its_neighbours_along():
    true = true_person(6)
    generic = load_generic()
    photos, proposals, points = photographed(true)
    before = fit(photos, proposals, points).values["head"]
    view = points.views[ViewId.FACE_FRONT]
    row = view.names.index("mouth_corner_L")
    moved, fixed = np.array(view.points_px), np.array(view.corrected)
    moved[row] += [6.0, 0.0]  # about 2.5 mm towards the person's left
    fixed[row] = True
    corrected = ViewPoints(view.view, view.names, moved, view.confidence, fixed)
    after = fit(photos, proposals, PointSet({**points.views, view.view: corrected})).values["head"]
    at = np.flatnonzero(generic.head_vertices == generic.feature("mouth_corner_L"))
    seen = after.cameras[ViewId.FACE_FRONT].project(after.vertices_m[at])[0]
    assert np.linalg.norm(seen - moved[row]) < 2.5
    far = np.flatnonzero(generic.head_vertices == generic.feature("eye_outer_R"))
    there = [h.cameras[ViewId.FACE_FRONT].project(h.vertices_m[far])[0] for h in (before, after)]
    assert np.linalg.norm(there[0] - there[1]) < 2.5


def test_eyeballs_have_the_size_of_people_and_lie_behind_the_lids():
    generic = load_generic()
    whole = generic.shape(np.zeros(1), STATURE_M)[0]
    whole[generic.head_vertices] = fit(*photographed(true_person(7))).values["head"].vertices_m
    for side in ("left", "right"):
        assert np.ptp(whole[generic.part(f"eye_{side}")][:, 0]) == pytest.approx(
            0.024, rel=0.02
        )  # its widest ring is no great circle
        assert face_motion.eyeball_protrusion_m(side, whole, whole) < 0.0
        margin = whole[eye_grid(side).ring(0)]
        assert np.median(eyeball(whole, side).outside(margin)) < 0.0015


@pytest.mark.parametrize("visitor", ["anna", "boris"])
def test_a_sample_visitor_keeps_its_front_landmarks(visitor):
    folder = Path(__file__).parents[2] / "samples" / visitor
    truth = json.loads((folder / "truth.json").read_text())
    photos, proposals, points = {}, {}, {}
    for view in (ViewId.FACE_FRONT, ViewId.FACE_SIDE):
        rgb = cv2.imread(str(folder / "plain" / f"{view}.jpg"))[..., ::-1]
        mask = cv2.imread(str(folder / f"truth_mask_{view}.png"), cv2.IMREAD_GRAYSCALE)
        face, pose = litert.detect_face(rgb), litert.detect_pose(rgb)
        photos[view] = Photo(view, rgb, 79.0, "", str(view))
        proposals[view] = Proposal(
            view, pose.points_px, pose.visibility,
            np.zeros((468, 2)) if face is None else face.points_px,
            np.zeros(468) if face is None else face.depth_px,
            0.0 if face is None else face.presence, mask, np.zeros_like(mask),
        )  # fmt: skip
        points[view] = propose_face_points(photos[view], proposals[view])
    result = fit(PhotoSet(photos), Proposals(proposals), PointSet(points))
    generic, fitted = load_generic(), result.values["head"]
    figures = {r.name: r.value for r in result.residuals if r.unit == "percent"}
    assert figures["front named points"] < 3.0  # percent of the eye distance: the bar of the issue
    row = {int(v): k for k, v in enumerate(generic.head_vertices)}
    seen = {n: np.array(p["xy"]) - 0.5 for n, p in truth["features"]["face_front"]["points"].items()}
    eyes = np.linalg.norm(seen["pupil_L"] - seen["pupil_R"])
    names = [n for n in points[ViewId.FACE_FRONT].names if n in seen and not n.startswith(("ear", "pupil"))]
    vertices = fitted.vertices_m[[row[generic.feature(n)] for n in names]]
    error = np.linalg.norm(fitted.cameras[ViewId.FACE_FRONT].project(vertices) - [seen[n] for n in names], axis=1)
    assert 100.0 * error.mean() / eyes < 4.5, f"{visitor}: {100.0 * error.mean() / eyes:.1f} %"  # measured 3.0-3.4
    assert fitted.side_shown == "right"
    assert next(r.value for r in result.residuals if r.name == "profile") < 1.5  # mm


@pytest.mark.parametrize(("stature_m", "usual_mm"), [(1.60, 61.4), (1.70, 62.7), (1.85, 64.6)])
def test_without_a_body_photo_the_head_has_the_usual_size(stature_m, usual_mm):
    """Eye distances of many people are 62.7 mm at 1.70 m and change by a third as much as statures (ANSUR II)."""
    generic, found = load_generic(), []
    for seed in (1, 2):
        photos = photographed(true_person(seed), side=False)
        whole = generic.shape(np.zeros(1), stature_m)[0]
        whole[generic.head_vertices] = fit(*photos, stature_m=stature_m).values["head"].vertices_m
        found.append(1e3 * np.linalg.norm(whole[generic.feature("pupil_L")] - whole[generic.feature("pupil_R")]))
    assert np.mean(found) == pytest.approx(usual_mm, rel=0.07)
