"""Silhouette evidence of the head: bare jaw and cheeks, and the skull under its hair.

Net and profile say little of jaw and vault, and the two photos' sizes and nods hang together by points that sit loosely
along the profile. Both show one head, though: its bare jaw is the outline itself, and the vault lies below the outline
by hair whose thickness is an unknown of the fit, the same in both photos.
"""

from __future__ import annotations

import functools
from collections.abc import Sequence
from dataclasses import dataclass
from typing import Final

import numpy as np
from numpy.typing import NDArray

from cloner.calibration.loader import calibrated
from cloner.fit.shapes import Evidence
from cloner.generic.load import load_generic
from cloner.geometry.meshes.surface import SurfacePoints
from cloner.geometry.meshes.triangles import edges_of
from cloner.geometry.meshes.vectors import unit
from cloner.geometry.outlines.contour_match import farthest_by_sector, occluding_points
from cloner.geometry.outlines.silhouette import vertex_normals
from cloner.head.model import HeadModel
from cloner.head.outline import Outline
from cloner.records.arrays import Array
from cloner.records.views import Camera

#: What each number is and where it comes from: ``cloner/calibration/head.toml``.
_CALIBRATED: Final = calibrated("head.silhouette")

#: Numbers of the hair's thickness: everywhere, more on top, more behind, more at the sides; usual and spread, metres.
HAIR_M: Final = tuple(
    zip(_CALIBRATED.numbers("usual_hair_m", "m"), _CALIBRATED.numbers("hair_spread_m", "m"), strict=True)
)
BARE_M: Final = _CALIBRATED.number("bare_m", "m")
VAULT_M: Final = _CALIBRATED.number("vault_m", "m")
BARE_GATE_M: Final = _CALIBRATED.number("bare_gate_m", "m")
VAULT_GATE_M: Final = _CALIBRATED.number("vault_gate_m", "m")
SECTOR: Final = float(np.radians(_CALIBRATED.number("sector", "deg")))
FOREHEAD_M: Final = _CALIBRATED.number("forehead_m", "m")


@dataclass(frozen=True, slots=True, eq=False)
class HeadSkin:
    """Edges and vertices that can be on the head's silhouette, in rows of ``generic.head_vertices``.

    Attributes
    ----------
    triangles : (T, 3), edges : (E, 2)
        The head's outer skin.
    bare, vault : (H,) bool
        Jaw, cheeks and temples, and the scalp above the ears.
    middle : (2,)
        Both ears' tops, around whose middle the outline lies.
    """

    triangles: NDArray[np.int64]
    edges: NDArray[np.int64]
    bare: NDArray[np.bool_]
    vault: NDArray[np.bool_]
    middle: NDArray[np.int64]


@functools.cache
def head_skin() -> HeadSkin:
    """Return the generic head's skin, prepared once per process."""
    generic = load_generic()
    head, mean = generic.head_vertices, generic.vertices_m
    row = np.full(len(mean), -1, dtype=np.int64)
    outer = generic.skin & ~generic.region("mouth_interior")
    row[head] = np.where(outer[head], np.arange(len(head)), -1)
    triangles = row[generic.triangles()[0]]
    triangles = triangles[(triangles >= 0).all(axis=1)]
    scalp, ears = generic.region("scalp"), generic.region("ear_left") | generic.region("ear_right")
    low = mean[:, 1] < mean[generic.feature("glabella"), 1] + FOREHEAD_M
    bare = (generic.head_blend > 0.95) & ~scalp & ~ears & low
    vault = scalp & ~ears & (mean[:, 1] > mean[ears, 1].mean())
    middle = row[[generic.feature("ear_top_L"), generic.feature("ear_top_R")]]
    return HeadSkin(triangles, edges_of(triangles)[0], bare[head], vault[head], middle)


def silhouette_evidence(
    seen: Sequence[HeadModel],
    coefficients: Array,
    cameras: Sequence[Camera],
    outlines: Sequence[Outline | None],
    before: int,
) -> list[Evidence]:
    """Return the evidence of the photos' outlines for the present head.

    Parameters
    ----------
    seen : K models
        The head as each photo shows it.
    coefficients : (F + before + 4,)
        Of the shape, of other joint errors, and of the hair's thickness.
    cameras : K cameras
    outlines : K outlines or None
        The first is the front photo's: where it shows no hair, jaw and cheeks are followed too.
    before : int
    """
    skin, hair = head_skin(), coefficients[-len(HAIR_M) :]
    out: list[Evidence] = []
    for index, (model, camera, outline) in enumerate(zip(seen, cameras, outlines, strict=True)):
        if outline is None:
            continue
        head = model.head(coefficients[: len(model.basis_m)])
        normals = vertex_normals(head, skin.triangles)
        places = occluding_points(head, normals, skin.edges, camera.position_m)
        middle = camera.project(head[skin.middle]).mean(axis=0)
        places = places.take(farthest_by_sector(camera.project(places.at(head)), middle, SECTOR))
        sight = _HeadView(model, head, normals, camera, index, outline, camera.metres_per_pixel(head[skin.middle[0]]))
        out += _hair_evidence(sight, _on_edges_among(places, skin.vault), hair, before)
        out += _skin_evidence(sight, _on_edges_among(places, skin.bare)) if index == 0 else []
    return out


@dataclass(frozen=True, slots=True, eq=False)
class _HeadView:
    """The head (H, 3) in front of one camera."""

    model: HeadModel
    head: Array
    normals: Array
    camera: Camera
    index: int
    outline: Outline
    metres: float

    def nearest(self, places: SurfacePoints, away_m: Array) -> tuple[Array, NDArray[np.int64]]:
        """Return the distance (N,) metres from points, displaced outwards by (N,) metres, to the outline, and its index
        (N,).
        """
        outwards = places.at(self.normals) @ self.camera.camera_from_model[:2, :3].T
        outwards = unit(outwards)
        seen = self.camera.project(places.at(self.head)) + away_m[:, None] / self.metres * outwards
        gap, which = self.outline.nearest(seen)
        return gap * self.metres, which

    def evidence(self, places: SurfacePoints, which: NDArray[np.int64], sigma_m: float, over_m: Array,
                 drift_m: Array | None = None) -> list[Evidence]:  # fmt: skip
        """Return the evidence that points lie ``over_m`` inside the outline, with common errors (M, N)."""
        if not len(which):
            return []
        base, basis = self.model.head_places(places)
        normal = self.outline.normals[which]
        target = self.outline.places_px[which] - (over_m / self.metres)[:, None] * normal
        drift = None if drift_m is None else (drift_m / self.metres)[:, :, None] * normal
        sigma = np.full(len(which), sigma_m / self.metres)
        return [Evidence(self.index, base, basis, target, sigma, normal_px=normal, outlier=2.0, common_error_px=drift)]


def _on_edges_among(places: SurfacePoints, wanted: NDArray[np.bool_]) -> SurfacePoints:
    """Return the points on edges of which both ends are wanted (H,)."""
    return places.take(np.flatnonzero(wanted[places.corners].all(axis=1)))


def _hair_evidence(sight: _HeadView, places: SurfacePoints, hair: Array, before: int) -> list[Evidence]:
    usual, sigma = np.array(HAIR_M).T
    share = hair_thickness_basis(places.at(sight.normals))
    gap, which = sight.nearest(places, share @ (usual + sigma * hair))
    kept = gap < VAULT_GATE_M
    drift = np.vstack([np.zeros((before, int(kept.sum()))), (share[kept] * sigma).T])
    return sight.evidence(places.take(kept), which[kept], VAULT_M, share[kept] @ usual, drift)


def _skin_evidence(sight: _HeadView, places: SurfacePoints) -> list[Evidence]:
    nothing = np.zeros(len(places.corners))
    gap, which = sight.nearest(places, nothing)
    kept = (gap < BARE_GATE_M) & ~sight.outline.veiled[which]
    return sight.evidence(places.take(kept), which[kept], BARE_M, nothing[kept])


def hair_thickness_basis(normals: Array) -> Array:
    """Return the basis (N, 4) of the hair's thickness at skin with normals (N, 3)."""
    return np.stack([np.ones(len(normals)), normals[:, 1], -normals[:, 2], np.abs(normals[:, 0])], axis=1)
