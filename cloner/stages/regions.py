"""Stage: a region label for every triangle: skin, hair, eyes, mouth, upper clothes, lower clothes or shoes.

The generic human knows where eyes, mouth and scalp are and what people wear where; the photos' labels say what this
person wears where, and the painted colours where exactly skin ends and one garment meets the next.

References
----------
L. Grady, Multilabel random walker image segmentation using prior models, CVPR 2005, equation 8.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping
from dataclasses import dataclass, replace
from types import MappingProxyType
from typing import Final

import numpy as np
from numpy.typing import NDArray
from scipy.sparse import coo_matrix, diags
from scipy.sparse.csgraph import connected_components
from scipy.sparse.linalg import splu
from skimage.color import rgb2lab

from cloner.calibration.loader import calibrated
from cloner.generic.load import GenericHuman, load_generic
from cloner.geometry.meshes.triangles import areas, paired_edges
from cloner.records.arrays import Array
from cloner.records.clones import Clone
from cloner.records.labels import SURFACES
from cloner.records.regions import REGIONS
from cloner.records.results import Residual, StageResult

#: What each number is and where it comes from: ``cloner/calibration/stages.toml``.
_CALIBRATED: Final = calibrated("stages.regions")


#: The regions that photos decide.
WORN: Final = ("skin", "hair", "upper_clothes", "lower_clothes", "shoes")
#: What people show or wear there where no photo tells, for `WORN`; taste, between bathing suit and winter coat.
_USUAL: Final[Mapping[str, tuple[float, ...]]] = MappingProxyType({
    "head": (0.99, 0.0, 0.01, 0.0, 0.0),
    "torso": (0.1, 0.0, 0.85, 0.05, 0.0),
    "pelvis": (0.03, 0.0, 0.3, 0.67, 0.0),
    "upper_arm": (0.4, 0.0, 0.6, 0.0, 0.0),
    "forearm": (0.5, 0.0, 0.5, 0.0, 0.0),
    "hand": (0.9, 0.0, 0.1, 0.0, 0.0),
    "thigh": (0.25, 0.0, 0.05, 0.7, 0.0),
    "calf": (0.35, 0.0, 0.0, 0.55, 0.1),
    "foot": (0.1, 0.0, 0.0, 0.06, 0.84),
})  # fmt: skip
_UNTOLD: Final = _CALIBRATED.number("untold", "factor")

SURE: Final = _CALIBRATED.number("sure", "share")
ISLAND: Final = _CALIBRATED.number("island", "share")


@dataclass(frozen=True, slots=True)
class Params:
    """Settings of the regions.

    Its numbers: ``cloner/calibration/stages.toml``, ``[regions.*]``.
    """

    contrast: float = _CALIBRATED.number("contrast", "lab")
    trust: float = _CALIBRATED.number("trust", "factor")


def run(
    *,
    painted: Clone,
    surfaces: Array,
    tick: Callable[[float], None],
    params: Params | None = None,
) -> StageResult:
    """Return the clone with labelled triangles.

    ``surfaces`` (V, 6) are the shares of ``SURFACES`` that the photos show at each vertex; zeros tell nothing.

    Residuals: how sure the labels of the colours are, percent of the surface above nine in ten.
    """
    params = params or Params()
    generic = load_generic()
    labels, sure = label_triangles(generic, painted, surfaces, params)
    tick(1.0)
    residual = Residual("regions_sure", 100.0 * sure, "percent")
    return StageResult({"clone": replace(painted, triangle_regions=labels)}, (residual,))


def label_triangles(
    generic: GenericHuman, clone: Clone, surfaces: Array, params: Params
) -> tuple[NDArray[np.uint8], float]:
    """Return the labels (T,) of the generic human's triangles (places in `REGIONS`), and the share of skin that is
    certain.
    """
    triangles, uv_triangles = generic.triangles()
    parts = np.array(generic.part_names)[generic.vertex_part[triangles[:, 0]]]
    on_body = parts == "body"
    colours = triangle_colours(clone.atlas.rgb, generic.uv.astype(np.float64)[uv_triangles])
    area = areas(clone.vertices_m, triangles)
    links = neighbour_links(triangles, colours, params.contrast)
    likely = _likelihoods(generic, triangles, surfaces)
    shares = random_walk(links, likely, params.trust * area / np.median(area[on_body]))
    worn = without_islands(shares.argmax(axis=1), links, area)
    labels = np.array([REGIONS.index(name) for name in WORN])[worn]
    for name, chosen in _certain_regions(generic, clone, triangles, parts):
        labels[chosen] = REGIONS.index(name)
    sure = shares[on_body].max(axis=1) > SURE
    return labels.astype(np.uint8), float(area[on_body][sure].sum() / area[on_body].sum())


def _likelihoods(generic: GenericHuman, triangles: NDArray[np.integer], surfaces: Array) -> Array:
    """Return the likelihoods (T, 5) of `WORN` by the photos' labels and by position; rows sum to one."""
    segments = [name.removeprefix("left_").removeprefix("right_") for name in generic.segment_names]
    place = np.array(segments)[generic.vertex_segment[triangles[:, 0]]]
    seen = surfaces[:, [SURFACES.index(name) for name in WORN]].copy()
    seen[:, WORN.index("upper_clothes")] += surfaces[:, SURFACES.index("accessory")]  # scarves, caps
    likely = seen[triangles].mean(axis=1) + _UNTOLD * np.array([_USUAL[name] for name in place])
    return np.asarray(likely / likely.sum(axis=1, keepdims=True))


def _certain_regions(
    generic: GenericHuman, clone: Clone, triangles: NDArray[np.integer], parts: NDArray[np.str_]
) -> Iterator[tuple[str, NDArray[np.bool_]]]:
    """Yield regions that need no colour: names and triangles, later ones win."""
    for part in generic.part_names:
        if part != "body":
            name = {"eye": "eyes", "lashes": "hair"}.get(part.split("_")[0], "mouth")
            yield name, parts == part
    yield "mouth", (parts == "body") & generic.region("mouth_interior")[triangles].all(axis=1)
    if any(shell.kind == "hair" for shell in clone.shells):
        yield "hair", (parts == "body") & generic.region("scalp")[triangles].all(axis=1)


def triangle_colours(rgb: NDArray[np.uint8], corners_uv: Array) -> Array:
    """Return (T, 3) CIELAB colours of triangles: the mean of their middle and of three places half way to the corners.

    Parameters
    ----------
    rgb : (S, S, 3) uint8, sRGB
    corners_uv : (T, 3, 2), v downwards
    """
    size = len(rgb)
    middle = corners_uv.mean(axis=1, keepdims=True)
    places = np.concatenate([middle, (middle + corners_uv) / 2.0], axis=1)
    texels = np.clip(np.floor(places * size).astype(int), 0, size - 1)
    taken = rgb[texels[..., 1], texels[..., 0]].astype(np.float64).mean(axis=1)
    return np.asarray(rgb2lab(taken[None] / 255.0)[0])


def neighbour_links(triangles: NDArray[np.integer], colours: Array, contrast: float) -> coo_matrix:
    """Return (T, T) symmetric weights of triangles that share an edge: near 1 for equal colours, small at borders."""
    first, second = paired_edges(triangles)[1].T
    apart = ((colours[first] - colours[second]) * (0.5, 1.0, 1.0) / contrast) ** 2
    weight = np.exp(-apart.sum(axis=1)) + 1e-3
    count = len(triangles)
    half = coo_matrix((weight, (first, second)), shape=(count, count))
    return half + half.T


def without_islands(labels: NDArray[np.integer], links: coo_matrix, area: Array) -> NDArray[np.integer]:
    """Return the labels with components smaller than `ISLAND` of their label's total given to their surroundings."""
    links = links.tocoo()
    inside = labels[links.row] == labels[links.col]
    kept = coo_matrix((inside[inside], (links.row[inside], links.col[inside])), shape=links.shape)
    count, part = connected_components(kept, directed=False)
    part_area = np.bincount(part, area, count)
    whole = np.bincount(labels, area, labels.max() + 1)
    first = np.zeros(count, dtype=np.int64)
    first[part] = labels
    small = part_area < ISLAND * whole[first]
    votes = np.zeros((count, labels.max() + 1))
    np.add.at(votes, (part[links.row[~inside]], labels[links.col[~inside]]), area[links.col[~inside]])
    taken = np.where(small & votes.any(axis=1), votes.argmax(axis=1), first)
    return np.asarray(taken[part])


def random_walk(links: coo_matrix, likely: Array, trust: Array) -> Array:
    """Return the probabilities (T, K) of a random walker's first label, with prior models (Grady 2005, equation 8).

    Parameters
    ----------
    links : (T, T) sparse symmetric weights
    likely : (T, K) rows sum to one
    trust : (T,) weights of the priors
    """
    laplacian = diags(np.asarray(links.sum(axis=1)).ravel()) - links
    system = (laplacian + diags(trust + 1e-9)).tocsc()
    return np.asarray(splu(system).solve((trust + 1e-9)[:, None] * likely))
