"""Every triangle is told what it is: by the photos' labels, by colour where garments end, by place where none tells."""

from __future__ import annotations

import json
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest
from PIL import Image
from scipy.sparse import coo_matrix

from cloner.exporters.table import EXPORTERS
from cloner.generic.load import load_generic
from cloner.geometry.meshes.graphs import surface_graph
from cloner.records.labels import SURFACES
from cloner.records.regions import REGIONS
from cloner.stages import regions
from kit import clones

#: What the toy clone wears, as photos would show it.
WORN = {
    "torso": "upper_clothes", "upper_arm": "upper_clothes", "pelvis": "lower_clothes", "thigh": "lower_clothes",
    "calf": "lower_clothes", "foot": "shoes",
}  # fmt: skip


def seen(**other):
    """Return (V, 6) shares of surfaces as photos show the toy clone; names of body parts change what they wear."""
    generic = load_generic()
    segments = [name.removeprefix("left_").removeprefix("right_") for name in generic.segment_names]
    worn = np.array([SURFACES.index((WORN | other).get(name, "skin")) for name in segments])[generic.vertex_segment]
    return np.eye(len(SURFACES))[worn]


def label(clone, surfaces=None):
    surfaces = seen() if surfaces is None else surfaces
    result = regions.run(painted=clone, surfaces=surfaces, tick=lambda part: None)
    return result.values["clone"].triangle_regions


@pytest.fixture(scope="module")
def labels():
    return label(clones.toy_clone())


def on(segments):
    generic = load_generic()
    triangles = generic.triangles()[0]
    body = generic.vertex_part[triangles[:, 0]] == generic.part_names.index("body")
    names = np.array(generic.segment_names)[generic.vertex_segment[triangles]]
    return body & np.isin(names, segments).all(axis=1)


@pytest.mark.parametrize(
    ("segments", "name"),
    [
        (("torso", "left_upper_arm", "right_upper_arm"), "upper_clothes"),
        (("left_thigh", "right_thigh", "left_calf", "right_calf"), "lower_clothes"),
        (("left_foot", "right_foot"), "shoes"),
        (("left_forearm", "right_forearm", "right_hand"), "skin"),
    ],
)
def test_painted_garments_are_told_where_they_are(labels, segments, name):
    assert (labels[on(segments)] == REGIONS.index(name)).mean() > 0.97


def test_eyes_mouth_and_scalp_are_known_without_colour(labels):
    generic = load_generic()
    part = np.array(generic.part_names)[generic.vertex_part[generic.triangles()[0][:, 0]]]
    assert (labels[part == "eye_left"] == REGIONS.index("eyes")).all()
    assert (labels[part == "teeth_upper"] == REGIONS.index("mouth")).all()
    scalp = generic.region("scalp")[generic.triangles()[0]].all(axis=1) & (part == "body")
    assert (labels[scalp] == REGIONS.index("hair")).all()
    assert (label(clones.toy_clone(hair=False))[scalp] == REGIONS.index("skin")).mean() > 0.95


def test_short_trousers_end_where_their_colour_ends():
    """Photos show bare calves and, three rings wrong, half bare knees: the border lies where the colour changes."""
    clone = clones.toy_clone()
    generic = load_generic()
    rgb = clone.atlas.rgb.copy()
    texels = regions_texels(on(("left_calf", "right_calf")), len(rgb))
    rgb[texels] = clones.SKIN
    blurred = surface_graph(generic.vertices_m.astype(float), generic.triangles()[0]).smooth(seen(calf="skin"), 3)
    bare = label(replace(clone, atlas=replace(clone.atlas, rgb=rgb)), blurred)
    calves = on(("left_calf", "right_calf"))
    assert (bare[calves] == REGIONS.index("skin")).mean() > 0.9
    assert (bare[on(("left_thigh", "right_thigh"))] == REGIONS.index("lower_clothes")).mean() > 0.95


def test_what_no_photo_shows_is_dressed_as_usual():
    nothing = np.zeros((len(load_generic().vertices_m), len(SURFACES)))
    found = label(clones.toy_clone(), nothing)
    assert (found[on(("torso",))] == REGIONS.index("upper_clothes")).mean() > 0.95
    assert (found[on(("left_thigh", "right_thigh"))] == REGIONS.index("lower_clothes")).mean() > 0.95


def test_a_print_on_the_shirt_stays_shirt():
    clone = clones.toy_clone()
    generic = load_generic()
    middle = clone.vertices_m[generic.triangles()[0]].mean(axis=1)
    chest = on(("torso",)) & (np.linalg.norm(middle - [0.0, 1.25, 0.12], axis=1) < 0.06)
    assert chest.sum() > 10
    rgb = clone.atlas.rgb.copy()
    rgb[regions_texels(chest, len(rgb))] = clones.TROUSERS
    found = label(replace(clone, atlas=replace(clone.atlas, rgb=rgb)))
    assert (found[chest] == REGIONS.index("upper_clothes")).all()


def regions_texels(triangles, size):
    from cloner.generic.charts import generic_atlas

    atlas = generic_atlas(load_generic(), size)
    mask = np.zeros(size * size, dtype=bool)
    mask[atlas.texel[triangles[atlas.triangle]]] = True
    return mask.reshape(size, size)


def test_the_walker_meets_the_prior_on_its_own_side_of_a_weak_link():
    """Four places in a row, the middle link weak: by hand, the shares of the inner two are 0.98 and 0.02 at least."""
    links = coo_matrix(([1.0, 1e-3, 1.0] * 2, ([0, 1, 2, 1, 2, 3], [1, 2, 3, 0, 1, 2])), shape=(4, 4))
    likely = np.array([[1.0, 0.0], [0.5, 0.5], [0.5, 0.5], [0.0, 1.0]])
    shares = regions.random_walk(links, likely, np.array([1.0, 0.0, 0.0, 1.0]))
    assert np.allclose(shares.sum(axis=1), 1.0)
    assert shares[1, 0] > 0.98
    assert shares[2, 0] < 0.02


def test_the_regions_leave_as_a_picture_on_the_atlas(tmp_path: Path):
    clone = clones.toy_clone()
    labelled = replace(clone, triangle_regions=label(clone))
    picture, legend = EXPORTERS.get("regions")(labelled, tmp_path)
    names = json.loads(legend.read_text())["regions"]
    texels = np.asarray(Image.open(picture))
    hand = regions_texels(on(("left_thigh",)), len(texels))
    assert (texels[hand] == names.index("lower_clothes")).mean() > 0.97
    assert (texels == 255).any()
