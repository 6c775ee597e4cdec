"""Skirts and coats get surfaces of their own; the legs below stay legs; trousers and jackets stay body."""

import functools
import sys
from dataclasses import replace
from pathlib import Path

import numpy as np
import pygltflib
import pytest
import trimesh
from scipy.spatial import cKDTree

from cloner.exporters.gltf import gltf
from cloner.exporters.vrml import vrml97
from cloner.frames import BODY_VIEWS, ViewId
from cloner.generic.load import load_generic
from cloner.geometry.articulation.skinning import joint_transforms, linear_blend_skinning
from cloner.geometry.outlines.contours import outline_field
from cloner.hair.clothing import loose_clothes as loose
from cloner.hair.clothing.loose_views import LegSkinning
from cloner.project.clone_file import load_clone, save_clone
from cloner.records.loose import AROUND_LEGS, HEM_PLACES
from cloner.records.proposals import Proposals
from cloner.records.silhouettes import SilhouetteSet
from cloner.stages.silhouettes import with_cloth
from cloner.vision.segmentation.loose_outline import find_loose
from kit import painted, people, studio
from kit.clones import toy_clone

sys.path.append(str(Path(__file__).parents[2] / "generic_models" / "build"))
import painted_garments

CLOTH, SKIN, WALL = (150, 40, 60), (210, 170, 150), (90, 140, 90)
PAINTED = ("long skirt",)  # drawing takes a second a view
POSE_ROWS = {"shoulder": (11, 12), "elbow": (13, 14), "wrist": (15, 16), "hip": (23, 24), "knee": (25, 26),
             "ankle": (27, 28)}  # fmt: skip


def pose_of(joints_m, seen_by, rng):
    """Return what a pose net says of posed joints, 4 px wrong."""
    generic = load_generic()
    pose, sure = np.zeros((33, 2)), np.zeros(33)
    for name, rows in POSE_ROWS.items():
        for side, row in zip("lr", rows, strict=True):
            pose[row] = seen_by.project(joints_m[[generic.joint(f"{side}_{name}")]])[0] + rng.normal(0.0, 4.0, 2)
            sure[row] = 1.0
    for side, rows in (("l", (17, 19, 21)), ("r", (18, 20, 22))):
        for name, row in zip(("pinky1", "index1", "thumb2"), rows, strict=True):
            pose[row], sure[row] = seen_by.project(joints_m[[generic.joint(f"{side}_{name}")]])[0], 1.0
    return pose, sure


def widened(person, share):
    """Return the person's vertices in trousers and jacket: pushed out by a share of the generic's ease."""
    from cloner.geometry.meshes.wedges import vertex_normals

    return person.vertices_m + share * vertex_normals(person.vertices_m, people.skin_triangles())


@functools.cache
def photographed(kind, seed=3, ease_m=0.0):
    """Return person, garment, fit, photos, proposals and outlines of somebody who re-poses between photos."""
    generic, rng = load_generic(), np.random.default_rng(seed)
    person = people.known_person(seed, spread=0.6)
    garment = None
    if kind:
        garment = painted_garments.make_garment(generic, person.vertices_m, person.joints_m, kind, rng)
    fit = painted.joined(person, {view: people.known_pose(10 * seed + k) for k, view in enumerate(painted.BODY)})
    skin_faces = people.skin_triangles()
    pictures, proposals, outlines = {}, {}, {}
    for view, posed in fit.views.items():
        worn = replace(person, vertices_m=widened(person, ease_m)) if ease_m else person
        vertices, joints = worn.posed(posed.rotations)
        faces = skin_faces
        if garment is not None:
            cloth = painted_garments.posed_garment(generic, person.joints_m, garment, posed.rotations)
            faces = np.vstack([skin_faces, garment.triangles + len(vertices)])
            vertices = np.vstack([vertices, cloth])
        mask = studio.silhouette(vertices, faces, posed.camera)
        pictures[view] = np.where(mask[..., None], CLOTH, WALL).astype(np.uint8)
        if kind in PAINTED:
            colours = np.where(np.arange(len(faces))[:, None] < len(skin_faces), SKIN, CLOTH)
            pictures[view] = painted.draw(vertices, faces, colours, posed.camera, background=WALL)
        pose, sure = pose_of(joints, posed.camera, rng)
        proposals[view] = replace(studio.empty_proposal(view, mask), pose_px=pose, pose_visibility=sure)
        outlines[view] = studio.silhouette_record(view, mask)
    return person, garment, fit, pictures, proposals, outlines


def regions(kind, **options):
    *_, proposals, outlines = photographed(kind, **options)
    return find_loose({v: (outlines[v].mask, p.pose_px, p.pose_visibility) for v, p in proposals.items()})


@functools.cache
def dressed(kind, seed=3):
    """Return person, garment, fit, outlines with their loose regions, and the shells made of them."""
    person, garment, fit, pictures, proposals, outlines = photographed(kind, seed)
    found = regions(kind, seed=seed)
    outlines = {view: replace(one, loose=found.get(view, ())) for view, one in outlines.items()}
    shells = loose.loose_shells(
        load_generic(), fit, studio.photo_set(pictures), Proposals(proposals), SilhouetteSet(outlines),
        loose.Params(size=256),
    )  # fmt: skip
    return person, garment, fit, outlines, shells


def posed_shell(fit, shell, rotations):
    moved = joint_transforms(fit.joints_m, load_generic().joint_parents, rotations)
    return linear_blend_skinning(shell.vertices_m, moved, shell.skin_joints, shell.skin_weights)


@pytest.mark.parametrize("kind", ["short skirt", "long skirt", "coat"])
def test_cloth_around_the_legs_is_found_in_all_photos_with_its_hem(kind):
    _, garment, fit, *_ = photographed(kind)
    found = regions(kind)
    assert set(found) == set(fit.views), kind
    for view, (region,) in found.items():
        assert region.name == AROUND_LEGS
        cloth = painted_garments.posed_garment(load_generic(), fit.joints_m, garment, fit.views[view].rotations)
        lowest = cloth[:, 1] < cloth[:, 1].min() + 0.10
        pixels = fit.views[view].camera.project(cloth[lowest])
        ends = pixels[[pixels[:, 0].argmin(), pixels[:, 0].argmax()]]
        pixel_mm = 1000 * fit.views[view].camera.metres_per_pixel(cloth.mean(axis=0))
        assert np.abs(region.hem_px[[0, -1]] - ends[:, 1]).max() * pixel_mm < 45.0, f"{kind} {view}"


def slit(mask, pose_px, rise):
    """Return a mask without a strip, a ninth as wide as the ankles are apart, up from the ankles by a share of it."""
    hips, ankles = pose_px[[23, 24], 1].mean(), pose_px[[27, 28], 1].mean()
    middle, half = pose_px[[27, 28], 0].mean(), np.abs(np.diff(pose_px[[27, 28], 0]))[0] / 18.0
    torn = mask.copy()
    torn[int(ankles - rise * (ankles - hips)) :, int(middle - half) : int(middle + half) + 1] = False
    return torn


def test_a_slit_in_the_mask_makes_no_trousers_and_is_filled():
    """A dark hem looks like the floor's shadow."""
    *_, proposals, outlines = photographed("long skirt")
    torn = {view: slit(outlines[view].mask, proposal.pose_px, 0.6) for view, proposal in proposals.items()}
    found = find_loose({v: (torn[v], p.pose_px, p.pose_visibility) for v, p in proposals.items()})
    assert set(found) == set(proposals)
    view = ViewId.BODY_FRONT
    whole = with_cloth(replace(outlines[view], mask=torn[view]), found[view])
    assert whole.loose == found[view]
    above = np.arange(len(torn[view]))[:, None] < found[view][0].hem_px.min() - 5.0
    lost = outlines[view].mask & ~torn[view] & above
    assert lost.sum() > 500
    assert whole.mask[lost].all()


@pytest.mark.parametrize(("kind", "ease_m"), [("", 0.0), ("", 0.025), ("bag", 0.0)])
@pytest.mark.parametrize("seed", [3, 4])
def test_legs_trousers_and_bags_are_no_skirt(kind, ease_m, seed):
    assert regions(kind, seed=seed, ease_m=ease_m) == {}


@pytest.mark.parametrize("kind", ["short skirt", "long skirt", "coat"])
def test_the_shell_shows_the_outline_of_the_cloth_in_every_photo(kind):
    person, _, fit, outlines, (shell,) = dressed(kind)
    both = np.vstack([people.skin_triangles(), shell.triangles + len(person.vertices_m)])
    for view, posed in fit.views.items():
        body, _ = person.posed(posed.rotations)
        shown = studio.silhouette(np.vstack([body, posed_shell(fit, shell, posed.rotations)]), both, posed.camera)
        true = outlines[view].mask
        below = slice(outlines[view].loose[0].top_px, None)  # above the waist a coat is body
        overlap = (shown & true)[below].sum() / (shown | true)[below].sum()
        assert overlap > 0.95, f"{kind} {view}: {overlap:.3f}"


def test_a_hem_that_rises_before_the_legs_rises_in_front_and_not_behind():
    _, _, fit, outlines, (shell,) = dressed("long skirt")
    front = outlines[ViewId.BODY_FRONT]
    (region,) = front.loose
    arch_px = 0.03 * np.count_nonzero(front.mask.any(axis=1))
    arched = replace(region, hem_px=region.hem_px - arch_px * (1.0 - HEM_PLACES**2))
    *_, pictures, proposals, _ = photographed("long skirt")
    (raised,) = loose.loose_shells(
        load_generic(), fit, studio.photo_set(pictures), Proposals(proposals),
        SilhouetteSet(outlines | {ViewId.BODY_FRONT: replace(front, loose=(arched,))}), loose.Params(size=256),
    )  # fmt: skip

    def hem_m(one, side):
        near = (np.abs(one.vertices_m[:, 0]) < 0.04) & (side * one.vertices_m[:, 2] > 0.05)
        return one.vertices_m[near, 1].min()

    arch_m = arch_px * fit.views[ViewId.BODY_FRONT].camera.metres_per_pixel(shell.vertices_m.mean(axis=0))
    assert hem_m(raised, 1.0) - hem_m(shell, 1.0) == pytest.approx(2.0 / 3.0 * arch_m, rel=0.25)
    assert abs(hem_m(raised, -1.0) - hem_m(shell, -1.0)) < 0.1 * arch_m


def test_no_leg_pokes_through_at_rest_and_the_top_meets_the_waist():
    person, *_, (shell,) = dressed("short skirt")
    generic = load_generic()
    names = ("left_thigh", "right_thigh", "pelvis")
    legs = np.isin(generic.vertex_segment, [generic.segment_names.index(name) for name in names])
    top, hem = (limit(shell.vertices_m[:, 1]) for limit in (np.max, np.min))
    height = person.vertices_m[:, 1]
    mesh = trimesh.Trimesh(shell.vertices_m, shell.triangles, process=False)
    for point in person.vertices_m[legs & (height > hem + 0.02) & (height < top - 0.04)][::40]:
        section = trimesh.intersections.mesh_plane(mesh, [0.0, 1.0, 0.0], [0.0, point[1], 0.0])[..., [0, 2]]
        middle = section.reshape(-1, 2).mean(axis=0)
        away = point[[0, 2]] - middle
        turned = section.mean(axis=1) - middle
        facing = np.argmax(turned @ away / np.linalg.norm(turned, axis=1))
        assert np.linalg.norm(turned[facing]) > np.linalg.norm(away) + 0.004
    rim = shell.vertices_m[height_is(shell.vertices_m, top)]
    gap = cKDTree(person.vertices_m[people.skin_triangles()].mean(axis=1)).query(rim)[0]
    assert np.median(gap) < 0.02


def height_is(points_m, height_m):
    return np.abs(points_m[:, 1] - height_m) < 1e-4


def test_walking_stretches_the_cloth_and_does_not_tear_it():
    person, *_, (shell,) = dressed("short skirt")
    generic = load_generic()
    step = np.zeros((94, 3))
    step[generic.joint("l_hip"), 0], step[generic.joint("r_hip"), 0] = -np.radians(25), np.radians(25)
    moved = joint_transforms(person.joints_m, generic.joint_parents, step)
    after = linear_blend_skinning(shell.vertices_m, moved, shell.skin_joints, shell.skin_weights)
    edges = np.concatenate([shell.triangles[:, [0, 1]], shell.triangles[:, [1, 2]]])
    length = [np.linalg.norm(p[edges[:, 0]] - p[edges[:, 1]], axis=1) for p in (shell.vertices_m, after)]
    assert (length[1] / length[0]).max() < 4.0
    hem = shell.vertices_m[:, 1] < shell.vertices_m[:, 1].min() + 0.03
    left = after[hem & (shell.vertices_m[:, 0] > 0.1), 2] - shell.vertices_m[hem & (shell.vertices_m[:, 0] > 0.1), 2]
    right = after[hem & (shell.vertices_m[:, 0] < -0.1), 2] - shell.vertices_m[hem & (shell.vertices_m[:, 0] < -0.1), 2]
    assert left.mean() > 0.05  # each side goes with its leg
    assert right.mean() < -0.05
    assert np.allclose(shell.skin_weights.sum(axis=1), 1.0)
    assert (shell.skin_weights > -1e-12).all()


def test_cloth_at_the_sides_hangs_from_its_own_thigh_and_the_waist_from_the_spine():
    person = people.known_person(3, spread=0.6)
    generic = load_generic()
    fit = painted.joined(person, dict.fromkeys(painted.BODY, np.zeros((94, 3))))
    hanging = LegSkinning.of(generic, fit)
    low = hanging.hip_m - 0.4
    points = np.array(
        [[0.25, low, 0.0], [-0.25, low, 0.0], [hanging.middle_m, low, 0.2], [0.0, hanging.levels_m[3], 0.1]]
    )
    joints, weights = hanging.weights(points)
    named = [
        {generic.joint_names[j]: w for j, w in zip(row, share, strict=True) if w > 1e-9}
        for row, share in zip(joints, weights, strict=True)
    ]
    assert named[0]["l_hip"] > 0.9
    assert named[1]["r_hip"] > 0.9
    assert named[2]["l_hip"] == pytest.approx(named[2]["r_hip"])
    assert set(named[3]) <= {"vl4", "vl3", "vl5"}


def test_the_shell_has_the_colour_of_the_cloth():
    *_, (shell,) = dressed("long skirt")
    texel = np.clip((shell.uv * shell.rgba.shape[0] - 0.5).round().astype(int), 0, shell.rgba.shape[0] - 1)
    rgb = shell.rgba[texel[:, 1], texel[:, 0], :3].astype(int)
    assert np.percentile(np.abs(rgb - CLOTH).max(axis=1), 95) < 12
    assert shell.kind == "cloth"


def test_nobody_without_loose_clothing_gets_a_shell():
    *_, shells = dressed("")
    assert shells == ()


def test_outline_samples_on_cloth_are_veiled_and_known_as_draped():
    _, _, _, outlines, _ = dressed("short skirt")
    front = outlines["body_front"]
    nothing = np.zeros_like(front.mask)
    field = outline_field(front.contours_px, front.mask, nothing, cloth=front.loose_mask(), step_px=4.0, reduction=2.0)
    region = front.loose[0]
    rows = (field.samples_px[:, 1] > region.top_px + 20) & (field.samples_px[:, 1] < region.hem_px.min() - 20)
    on_edge = rows & region.covers(field.samples_px, margin_px=3.0)
    assert on_edge.sum() > 50
    assert field.draped[on_edge].mean() > 0.95
    assert (field.veiled >= field.draped).all()
    assert not field.veiled[field.samples_px[:, 1] > region.bottom_px + 10].any()
    assert set(BODY_VIEWS) == {ViewId(view) for view in outlines}


def test_files_name_the_cloth_and_keep_its_weights(tmp_path):
    *_, (shell,) = dressed("short skirt")
    clone = replace(toy_clone(1.64, hair=True), shells=(*toy_clone(1.64, hair=True).shells, shell))
    (glb,) = gltf.export(clone, tmp_path)
    scene = pygltflib.GLTF2().load(str(glb))
    assert [mesh.name for mesh in scene.meshes] == ["Body", "Hair", "Cloth"]
    accessor = scene.accessors[scene.meshes[2].primitives[0].attributes.WEIGHTS_0]
    view = scene.bufferViews[accessor.bufferView]
    start = view.byteOffset + (accessor.byteOffset or 0)
    written = np.frombuffer(scene.binary_blob()[start : start + 16 * accessor.count], np.float32).reshape(-1, 4)
    assert np.allclose(written, shell.skin_weights, atol=1e-5)
    text = vrml97.export(clone, tmp_path)[0].read_text()
    assert "look_cloth_1" in text
    assert (tmp_path / "textures" / "clone_cloth_1.png").exists()
    save_clone(clone, tmp_path / "clone.npz")
    assert [one.kind for one in load_clone(tmp_path / "clone.npz").shells] == ["hair", "cloth"]
