"""A painted body gets its colours back from its photographs."""

import numpy as np
import pytest

from cloner.frames import ViewId
from cloner.generic.charts import generic_atlas
from cloner.generic.load import load_generic
from cloner.records.clones import Joined
from cloner.records.heads import HeadFit, Shell
from cloner.records.photos import PhotoSet
from cloner.records.proposals import Proposals
from cloner.records.silhouettes import SilhouetteSet
from cloner.stages import textures
from kit import painted, people, studio

SIZE = 512
SKIN = (200, 60, 50)
CLOTH = (40, 60, 190)


def eyes():
    return HeadFit(np.zeros((1, 3)), {}, np.array([70.0, 90.0, 60.0]), 0.0058, "right")


def bake(fit, colours, *, believed=None, exposure=None, worn=None):
    """Photograph a painted fit and bake it; ``believed`` is the fit the stage is given, ``worn`` a shell in SKIN."""
    pictures, proposals, outlines = {}, {}, {}
    before = None if worn is None else (worn.vertices_m, worn.triangles, SKIN)
    for view in fit.views:
        rgb, mask = painted.photograph(fit, colours, view, before=before)
        pictures[view] = np.clip(rgb * (exposure or {}).get(view, 1.0), 0, 255).astype(np.uint8)
        proposals[view] = studio.empty_proposal(view, mask)
        outlines[view] = studio.silhouette_record(view, mask)
    return textures.run(
        photos=studio.photo_set(pictures), proposals=Proposals(proposals), silhouettes=SilhouetteSet(outlines),
        joined=believed or fit, shells=() if worn is None else (worn,), head=eyes(), tick=lambda part: None,
        rng=np.random.default_rng(0),
        params=textures.Params(size=SIZE),
    )  # fmt: skip


def on_texels(values):
    """Return texel indices and interpolated vertex values of the skin."""
    generic = load_generic()
    atlas = generic_atlas(generic, SIZE)
    skin = generic.vertex_part == generic.part_names.index("body")
    rows = atlas.rows_of(skin[atlas.triangles].all(axis=1))
    return atlas.texel[rows], atlas.interpolate(values, rows)


@pytest.fixture(scope="module")
def gradient():
    person = people.known_person(11)
    x, y, z = person.vertices_m.T
    # Left and right alike, as the stage assumes of the half that no side photo shows.
    bands = [128 + 90 * np.sin(7 * y), 128 + 80 * np.sin(9 * np.abs(x) + 2 * y), 120 + 70 * np.cos(8 * z)]
    colours = np.column_stack(bands)
    fit = painted.joined(person, {view: people.known_pose(20 + k) for k, view in enumerate(painted.BODY)})
    return fit, colours, bake(fit, colours)


def test_a_gradient_comes_back_within_levels(gradient):
    _, colours, result = gradient
    atlas = result.values["painted"].atlas
    texel, expected = on_texels(colours)
    seen = atlas.coverage.reshape(-1)[texel] > 0
    wrong = np.abs(atlas.rgb.reshape(-1, 3)[texel].astype(float) - expected).mean(axis=1)
    assert 0.5 < seen.mean() <= 1.0
    assert np.median(wrong[seen]) < 4.0  # the painter's flat triangles are themselves 2-4 levels off the gradient
    assert np.percentile(wrong[seen], 95) < 12.5  # 11.95 laid down perfectly: lines of flat triangles are followed
    assert np.median(wrong[~seen]) < 40.0  # filled from neighbours, not from nowhere


def test_no_background_shows_on_the_body(gradient):
    fit, _, _ = gradient
    result = bake(fit, np.tile(np.float64(CLOTH), (len(fit.vertices_m), 1)))
    texel, _ = on_texels(np.zeros((len(fit.vertices_m), 1)))
    rgb = result.values["painted"].atlas.rgb.reshape(-1, 3)[texel].astype(int)
    mouth = on_texels(load_generic().region("mouth_interior").astype(float)[:, None])[1][:, 0] > 0.0
    assert np.mean(np.abs(rgb[~mouth] - CLOTH).max(axis=1) > 8) < 0.01


@pytest.mark.parametrize("error_deg", [0.0, 2.0])
def test_an_arm_before_the_hip_is_not_painted_on_the_hip(error_deg):
    generic = load_generic()
    person = people.known_person(12, spread=0.5)
    arms = np.isin(
        generic.vertex_segment,
        [k for k, n in enumerate(generic.segment_names) if n.endswith(("upper_arm", "forearm", "hand"))],
    )
    colours = np.where(arms[:, None], SKIN, CLOTH).astype(float)
    rotations = people.known_pose(31, spread=0.0)
    fit = painted.joined(person, dict.fromkeys(painted.BODY, rotations))
    wrong = rotations.copy()  # the fit believes the arm a little elsewhere than it was
    wrong[generic.joint("r_shoulder")] += np.radians([error_deg, 0.0, 0.0])
    views = {v: type(p)(p.view, p.camera, wrong if v == ViewId.BODY_SIDE else rotations) for v, p in fit.views.items()}
    believed = Joined(
        fit.vertices_m, fit.joints_m, views, fit.morph_names, fit.morph_index, fit.morph_delta_m, fit.morph_start,
        fit.features_m, fit.stature_m, fit.sole_m,
    )  # fmt: skip
    result = bake(fit, colours, believed=believed)
    low = [k for k, n in enumerate(generic.segment_names) if n == "pelvis" or n.endswith("thigh")]
    texel, hip = on_texels(np.isin(generic.vertex_segment, low).astype(float)[:, None])
    rgb = result.values["painted"].atlas.rgb.reshape(-1, 3)[texel[hip[:, 0] > 0.99]].astype(int)
    assert np.mean(rgb[:, 0] > rgb[:, 2]) < 0.005


@pytest.mark.parametrize(("kind", "share"), [("beard", (0.0, 0.02)), ("glasses", (0.5, 1.0))])
def test_a_chest_behind_a_beard_is_no_beard_and_behind_a_lens_as_it_is_seen(kind, share):
    person = people.known_person(12, spread=0.5)
    fit = painted.joined(person, dict.fromkeys(painted.BODY, np.zeros((94, 3))))
    chest = person.vertices_m[load_generic().segment("torso")]
    top, front = chest[:, 1].max() - 0.1, chest[:, 2].max() + 0.04
    corners = np.array([[x, y, front] for y in (top, top - 0.16) for x in (-0.09, 0.09)])
    shell = Shell(
        corners, np.array([[0, 2, 1], [1, 2, 3]], np.int32), np.array([[0.0, 0.0], [1, 0], [0, 1], [1, 1]]),
        np.zeros((4, 4), np.int32), np.tile([1.0, 0.0, 0.0, 0.0], (4, 1)), np.full((8, 8, 4), 255, np.uint8), kind,
    )  # fmt: skip
    result = bake(fit, np.tile(np.float64(CLOTH), (len(person.vertices_m), 1)), worn=shell)
    behind = (np.abs(person.vertices_m[:, 0]) < 0.06) & (person.vertices_m[:, 2] > front - 0.12)
    behind &= np.abs(person.vertices_m[:, 1] - (top - 0.08)) < 0.05
    texel, inside = on_texels(behind.astype(float)[:, None])
    rgb = result.values["painted"].atlas.rgb.reshape(-1, 3)[texel[inside[:, 0] > 0.99]].astype(int)
    assert len(rgb) > 300
    assert share[0] <= np.mean(rgb[:, 0] > rgb[:, 2]) <= share[1]


def test_a_darker_back_photo_is_evened(gradient):
    fit, colours, _ = gradient
    result = bake(fit, colours, exposure={ViewId.BODY_BACK: 0.85})
    found = {(r.name, r.view): r.value for r in result.residuals}
    before, after = (found[name, "body_back"] for name in ("photo_disagreement_raw", "photo_disagreement"))
    assert before > 8.0
    assert after < 0.6 * before


def test_without_photos_the_body_has_one_colour_and_the_report_says_so(gradient):
    fit, _, _ = gradient
    nothing = {"photos": PhotoSet({}), "proposals": Proposals({}), "silhouettes": SilhouetteSet({})}
    result = textures.run(
        **nothing, joined=fit, shells=(), head=eyes(), tick=lambda part: None, rng=np.random.default_rng(0),
        params=textures.Params(size=SIZE),
    )  # fmt: skip
    assert "No photo" in result.warnings[0]
    assert not result.values["painted"].atlas.coverage.any()
