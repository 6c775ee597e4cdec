"""The metrics of the scoreboard, each a pure function of arrays."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Final, Protocol

import numpy as np
from numpy.typing import NDArray
from scipy.ndimage import binary_erosion, distance_transform_edt
from skimage.color import deltaE_ciede2000, rgb2gray, rgb2lab
from skimage.metrics import structural_similarity

from cloner.geometry.meshes.alignment import similarity_alignment
from cloner.records.arrays import Array
from cloner.vision.segmentation.pieces import box_around

Mask = NDArray[np.bool_]

#: Outline errors are told for photos of this height (rulers).
OUTLINE_HEIGHT_PX: Final = 1800.0
#: What stands where a person is not, when two pictures of people are compared.
_BACKDROP: Final = 127


class Surface(Protocol):
    """Anything that tells the nearest point of itself."""

    def closest(self, points: Array) -> tuple[Array, Array, NDArray[np.int64]]:
        """Return nearest points (N, 3), distances (N,) and element numbers (N,)."""


@dataclass(frozen=True, slots=True)
class DistanceSummary:
    """Summary of distances, in their unit."""

    mean: float
    median: float
    p95: float


def summarise(distances: Array) -> DistanceSummary:
    """Return mean, median and 95th percentile."""
    return DistanceSummary(float(np.mean(distances)), float(np.median(distances)), float(np.percentile(distances, 95)))


def mask_iou(first: Mask, second: Mask) -> float:
    """Return the intersection over union of two masks of one size; 1.0 when both are empty."""
    if first.shape != second.shape:
        raise ValueError(f"masks differ in size: {first.shape} and {second.shape}")
    union = int(np.count_nonzero(first | second))
    return 1.0 if union == 0 else float(np.count_nonzero(first & second) / union)


def outline_distances_px(found: Mask, truth: Mask) -> Array:
    """Return distances between two masks' boundaries, both ways, at 1,800 px photo height.

    Parameters
    ----------
    found, truth : (H, W) bool
        Boundary pixels on the photo's border (a person cut off) are left out.

    Raises
    ------
    ValueError
        If a mask has no boundary.
    """
    found_edge, truth_edge = boundary(found), boundary(truth)
    if not found_edge.any() or not truth_edge.any():
        raise ValueError("a mask has no boundary inside the photo")
    to_truth = distance_transform_edt(~truth_edge)[found_edge]
    to_found = distance_transform_edt(~found_edge)[truth_edge]
    return np.asarray(np.concatenate([to_truth, to_found]) * (OUTLINE_HEIGHT_PX / found.shape[0]))


def boundary(mask: Mask) -> Mask:
    """Return the mask's outermost pixels, without those on the picture's border."""
    edge = mask & ~binary_erosion(mask, border_value=1)
    edge[[0, -1]] = False
    edge[:, [0, -1]] = False
    return np.asarray(edge, dtype=bool)


def fit_similarity(source: Array, target: Array, *, scale: bool) -> Array:
    """Return the (4, 4) ``target_from_source`` of least squares.

    Parameters
    ----------
    source, target : (N, 3) float64, corresponding points
    scale : bool
        Whether a uniform scale is free (similarity) or one (rigid).
    """
    factor, rotation, shift = similarity_alignment(source, target)
    transform = np.eye(4)
    transform[:3, :3] = factor * rotation if scale else rotation
    transform[:3, 3] = shift if scale else target.mean(axis=0) - rotation @ source.mean(axis=0)
    return transform


def transform_points(transform: Array, points: Array) -> Array:
    """Return (N, 3) points moved by a (4, 4) transform."""
    return np.asarray(points @ transform[:3, :3].T + transform[:3, 3])


def inverse_transform(transform: Array) -> Array:
    """Return the (4, 4) transform back."""
    return np.asarray(np.linalg.inv(transform), dtype=np.float64)


def landmark_distances(found: Array, truth: Array) -> Array:
    """Return (N,) distances of named points after rigid alignment on all of them."""
    away = transform_points(fit_similarity(found, truth, scale=False), found) - truth
    return np.asarray(np.linalg.norm(away, axis=1))


def align_by_nearest(points: Array, surface: Surface, *, scale: bool, keep: float = 0.95, turns: int = 40) -> Array:
    """Return ``points_from_surface``: iterated closest points on the best share of pairs.

    Parameters
    ----------
    points : (N, 3) float64
        The truth's points, which stay where they are.
    surface : Surface
        What is moved, in its own frame near the points.
    scale : bool
        Whether a uniform scale is free.
    keep : float
        Share of pairs, the nearest, that vote in each turn.
    turns : int
        Largest number of turns; stops when the mean moves by less than a micrometre.
    """
    total, last = np.eye(4), np.inf
    for _ in range(turns):
        nearest, distance, _ = surface.closest(transform_points(inverse_transform(total), points))
        best = distance <= np.quantile(distance, keep)
        total = fit_similarity(nearest[best], points[best], scale=scale)
        mean = float(distance[best].mean())
        if abs(last - mean) < 1e-6:
            break
        last = mean
    return total


def picture_similarity(
    clone: NDArray[np.uint8], clone_mask: Mask, photo: NDArray[np.uint8], mask: Mask
) -> tuple[float, float]:
    """Return SSIM (grey, -1..1) and mean CIEDE2000 over the person's true mask.

    Parameters
    ----------
    clone, photo : (H, W, 3) uint8, sRGB
    clone_mask, mask : (H, W) bool
        Where the clone is drawn; where the person truly is. Both pictures get
        the same grey backdrop outside their own mask, so that a limb missing
        from the clone counts against it and the room does not count at all.
    """
    left = np.where(clone_mask[..., None], clone, _BACKDROP).astype(np.uint8)
    right = np.where(mask[..., None], photo, _BACKDROP).astype(np.uint8)
    box = box_around(mask, 8)
    left, right, inside = left[box], right[box], mask[box]
    _, similar = structural_similarity(rgb2gray(left), rgb2gray(right), data_range=1.0, full=True)
    difference = deltaE_ciede2000(rgb2lab(left), rgb2lab(right))
    return float(similar[inside].mean()), float(difference[inside].mean())


def colour_jumps(colours: NDArray[np.integer] | NDArray[np.floating], edges: NDArray[np.int64]) -> Array:
    """Return (E,) CIEDE2000 between the ends of (E, 2) edges, from the sRGB levels (V, 3) of their vertices."""
    lab = rgb2lab(np.asarray(colours, dtype=np.float64)[None] / 255.0)[0]
    return np.asarray(deltaE_ciede2000(lab[edges[:, 0]], lab[edges[:, 1]]))


def seam_ratio(jumps: Array, crossing: Mask, inside: Mask) -> float | None:
    """Return how much colours jump across a border, relative to inside the surface.

    Parameters
    ----------
    jumps : (E,) float64
        From :func:`colour_jumps`, of edges of about one length.
    crossing, inside : (E,) bool
        Edges that cross the border, and edges of the same surface that do not.

    Returns
    -------
    float or None
        Mean jump over crossing edges divided by that inside; None without edges.
    """
    if not crossing.any() or not inside.any():
        return None
    return float(jumps[crossing].mean() / max(float(jumps[inside].mean()), 1e-6))
