"""Glasses: the frame is told from caps, rims lie where the photo shows them, temples reach over the ears."""

from __future__ import annotations

from dataclasses import replace
from types import SimpleNamespace

import cv2
import numpy as np
import pytest

from cloner.frames import ViewId
from cloner.generic.load import load_generic
from cloner.labels.glasses import glasses_frame, wears_glasses
from cloner.paint.details.below_glasses import fill_frame, remove_glasses
from cloner.paint.details.glasses import glasses_shell
from cloner.paint.details.glasses_texture import BAND_PX, LENS_PX
from cloner.records.bodies import PosedView
from cloner.records.labels import Label
from cloner.records.proposals import Proposals
from cloner.records.views import Camera
from kit import studio

HEIGHT, WIDTH, FOCAL = 800, 600, 1700.0
SKIN, FRAME = (190, 140, 115), (30, 30, 60)


def joined():
    """Return the generic human before a camera 1.2 m before the face."""
    generic = load_generic()
    eyes = generic.vertices_m[[generic.feature("pupil_L"), generic.feature("pupil_R")]].mean(axis=0)
    flipped = np.diag([1.0, -1.0, -1.0, 1.0])  # camera axes: x right, y down, z forward
    flipped[:3, 3] = -flipped[:3, :3] @ (eyes + (0.0, 0.0, 1.2))
    camera = Camera(WIDTH, HEIGHT, FOCAL, flipped)
    view = PosedView(ViewId.FACE_FRONT, camera, np.zeros((len(generic.joint_names), 3)))
    features = {name: generic.vertices_m[generic.feature(name)] for name in ("nasion",)}
    return generic, SimpleNamespace(
        joints_m=generic.joints_m.astype(float),
        vertices_m=generic.vertices_m.astype(float),
        views={ViewId.FACE_FRONT: view},
        features_m=features,
    )


def ring(picture, middle, value):
    """Draw a round lens' rim."""
    cv2.ellipse(picture, middle, (36, 28), 0, 0, 360, value, 8)


def flat_box(picture, middle, value):
    """Draw the rim of a lens three times as wide as high, with corners."""
    (x, y), (wide, high) = middle, (38, 13)
    cv2.rectangle(picture, (x - wide, y - high), (x + wide, y + high), value, 8)


def portrait(*, cap: bool = False, rim=ring):
    """Return a photo of two rims around the generic's eyes, its proposal, and the camera."""
    generic, person = joined()
    camera = person.views[ViewId.FACE_FRONT].camera
    place = {
        name: camera.project(person.vertices_m[[generic.feature(name)]])[0]
        for name in ("pupil_L", "pupil_R", "eye_outer_L", "eye_outer_R")
    }
    rgb = np.full((HEIGHT, WIDTH, 3), SKIN, np.uint8)
    labels = np.full((HEIGHT, WIDTH), Label.FACE_SKIN, np.uint8)
    mesh = np.tile([[WIDTH / 2, HEIGHT / 2]], (468, 1))
    mesh[33], mesh[263] = place["eye_outer_R"], place["eye_outer_L"]
    mesh[105], mesh[334] = (mesh[k] - (0.0, 25.0) for k in (33, 263))
    for name in ("pupil_L", "pupil_R"):
        middle = tuple(int(v) for v in np.round(place[name]))
        for picture, value in ((rgb, FRAME), (labels, int(Label.ACCESSORY))):
            rim(picture, middle, value)
    if cap:
        labels[:250] = Label.ACCESSORY
    mask = np.full((HEIGHT, WIDTH), 255, np.uint8)
    blank = studio.empty_proposal(ViewId.FACE_FRONT, mask > 0)
    proposal = SimpleNamespace(view=ViewId.FACE_FRONT, labels=labels, face_px=mesh, face_presence=1.0, mask=blank.mask)
    return SimpleNamespace(rgb=rgb), proposal, generic, person


@pytest.mark.parametrize("cap", [False, True])
def test_the_frame_is_found_and_a_cap_is_none_of_it(cap):
    photo, proposal, _, _ = portrait(cap=cap)
    drawn = (photo.rgb == FRAME).all(axis=2)
    assert (glasses_frame(proposal) == drawn).all()


def test_glasses_are_found_whose_temples_touch_a_scarf():
    photo, proposal, _, _ = portrait()
    face = cv2.ellipse(np.zeros((HEIGHT, WIDTH), np.uint8), (300, 400), (130, 190), 0, 0, 360, 1, -1) > 0
    proposal.labels[~face] = Label.ACCESSORY
    row = int(proposal.face_px[33, 1])
    proposal.labels[row - 3 : row + 3, :] = Label.ACCESSORY
    drawn = face & (photo.rgb == FRAME).all(axis=2)
    found = glasses_frame(proposal)
    assert drawn.any()
    assert found[drawn].mean() > 0.97
    assert not found[~face].any()


def test_who_wears_a_cap_alone_wears_no_glasses():
    _, proposal, _, _ = portrait(cap=True)
    proposal.labels[250:] = Label.FACE_SKIN
    assert not wears_glasses(Proposals({ViewId.FACE_FRONT: proposal}))


def drawn_shell(shell, camera):
    """Return where a camera sees a shell."""
    return studio.silhouette(shell.vertices_m, shell.triangles, camera)


def overlap(first, second):
    return (first & second).sum() / (first | second).sum()


@pytest.mark.parametrize("rim", [ring, flat_box])
def test_the_rims_lie_where_the_photo_shows_them(rim):
    photo, proposal, generic, person = portrait(rim=rim)
    shell = glasses_shell(generic, person, photo, proposal)
    assert shell is not None
    assert shell.kind == "glasses"
    camera = person.views[ViewId.FACE_FRONT].camera
    frame = (photo.rgb == FRAME).all(axis=2)
    columns = np.flatnonzero(frame.any(axis=0))
    rims = np.s_[:, columns[0] - 3 : columns[-1] + 4]
    bridge = drawn_shell(shell, camera) & ~cv2.dilate(frame.astype(np.uint8), np.ones((9, 9), np.uint8)).astype(bool)
    assert overlap(drawn_shell(shell, camera)[rims] & ~bridge[rims], frame[rims]) > 0.75
    texels = shell.rgba[: 5 * BAND_PX, :, :3].astype(int)
    assert (np.abs(texels - FRAME).max(axis=2) <= 32).mean() > 0.98  # a fifth of the skin's colour
    assert (texels[3 * BAND_PX :] == FRAME).all()
    face = person.vertices_m[generic.region("face")]
    middle = shell.vertices_m[np.abs(shell.vertices_m[:, 0]) < 0.002]
    assert middle[:, 2].min() > person.features_m["nasion"][2]
    assert shell.vertices_m[:, 2].max() < face[:, 2].max() + 0.02


def test_a_rim_behind_hair_is_the_other_one_mirrored():
    photo, proposal, generic, person = portrait()
    whole = glasses_shell(generic, person, photo, proposal)
    half = proposal.labels.copy()
    half[:, WIDTH // 2 :] = Label.HAIR
    photo.rgb[:, WIDTH // 2 :] = (60, 40, 30)
    hidden = glasses_shell(generic, person, photo, SimpleNamespace(**{**vars(proposal), "labels": half}))
    assert whole is not None
    assert hidden is not None
    camera = person.views[ViewId.FACE_FRONT].camera
    assert overlap(drawn_shell(hidden, camera), drawn_shell(whole, camera)) > 0.6


def test_two_specks_are_no_glasses():
    photo, proposal, generic, person = portrait()
    speck = np.where((proposal.labels == Label.ACCESSORY), int(Label.FACE_SKIN), proposal.labels).astype(np.uint8)
    rows, columns = np.nonzero(proposal.labels == Label.ACCESSORY)
    speck[rows[:40], columns[:40]] = Label.ACCESSORY
    photo.rgb[...] = SKIN
    assert glasses_shell(generic, person, photo, SimpleNamespace(**{**vars(proposal), "labels": speck})) is None


def test_dark_lenses_are_drawn_in_their_colour():
    photo, proposal, generic, person = portrait()
    dark, inside = (60, 50, 40), np.zeros((HEIGHT, WIDTH), np.uint8)
    camera = person.views[ViewId.FACE_FRONT].camera
    for name in ("pupil_L", "pupil_R"):
        middle = camera.project(person.vertices_m[[generic.feature(name)]])[0]
        cv2.ellipse(inside, tuple(int(v) for v in np.round(middle)), (32, 24), 0, 0, 360, 1, -1)
    photo.rgb[inside > 0], proposal.labels[inside > 0] = dark, Label.ACCESSORY
    shell = glasses_shell(generic, person, photo, proposal)
    assert shell is not None
    half = np.linspace(-1.0, 1.0, LENS_PX)
    lens = np.hypot(*np.meshgrid(half, half)) < 0.7  # beyond lies the rim, in front of it
    for side in (0, LENS_PX):
        assert (shell.rgba[5 * BAND_PX :, side : side + LENS_PX, :3][lens] == dark).all()
    seen = drawn_shell(shell, camera)
    assert (seen & (inside > 0)).sum() > 0.95 * (inside > 0).sum()


def test_temples_end_behind_the_ears_outside_the_head():
    photo, proposal, generic, person = portrait()
    shell = glasses_shell(generic, person, photo, proposal)
    assert shell is not None
    head = person.vertices_m[generic.skin & generic.segment("head")]
    for side, sign in (("L", 1.0), ("R", -1.0)):
        ear = person.vertices_m[generic.feature(f"ear_top_{side}")]
        own = shell.vertices_m[sign * shell.vertices_m[:, 0] > 0.02]
        last = own[own[:, 2].argmin()]
        assert last[2] < ear[2]
        assert last[1] < ear[1]
        before = own[(own[:, 2] > ear[2] + 0.03) & (own[:, 2] < ear[2] + 0.06)]
        beside = head[(np.abs(head[:, 1:] - before[:, 1:].mean(axis=0)) < 0.006).all(axis=1)]
        assert (sign * before[:, 0]).max() > (sign * beside[:, 0]).max()


def test_skin_goes_on_below_the_frame():
    photo, proposal, _, _ = portrait()
    blank = studio.empty_proposal(ViewId.FACE_FRONT, proposal.mask > 0)
    proposal = replace(blank, face_px=proposal.face_px, face_presence=1.0, labels=proposal.labels)
    rgb, cleaned = fill_frame(photo.rgb, proposal, glasses_frame(proposal))
    assert np.abs(rgb.astype(int) - SKIN).max() <= 4  # one grey of skin all over, to rounding
    assert (cleaned.labels == Label.FACE_SKIN).all()


def test_what_labels_lose_of_the_frame_is_removed_with_the_drawn_one():
    photo, proposal, generic, person = portrait()
    drawn = (photo.rgb == FRAME).all(axis=2)
    shell = glasses_shell(generic, person, photo, proposal)
    assert shell is not None
    lost = drawn & (np.arange(HEIGHT)[:, None] < np.flatnonzero(drawn.any(axis=1)).mean() - 15)
    blank = studio.empty_proposal(ViewId.FACE_FRONT, proposal.mask > 0)
    labels = np.where(lost, np.uint8(Label.FACE_SKIN), proposal.labels)
    proposal = replace(blank, face_px=proposal.face_px, face_presence=1.0, labels=labels)
    given = studio.photo_set({ViewId.FACE_FRONT: photo.rgb}), Proposals({proposal.view: proposal})
    left = {}
    for name, glasses in (("labels", None), ("both", shell)):
        photos, _ = remove_glasses(generic, person, *given, glasses)
        dark = np.abs(photos.photos[ViewId.FACE_FRONT].rgb.astype(int) - SKIN).max(axis=2) > 40
        left[name] = (dark & lost).sum() / lost.sum()
    assert left["labels"] > 0.5
    assert left["both"] < 0.05
