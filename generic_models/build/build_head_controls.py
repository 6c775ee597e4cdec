"""Choose the DFFD control points of the generic head: ``python generic_models/build/build_head_controls.py``.

Movable controls lie spread over the face, on the calibrated net points and on the midline; anchors on skull, ears and
neck stay. Sibson weights of all head vertices are computed once and kept sparse in ``cloner_models/head_controls.npz``.
"""

from __future__ import annotations

from pathlib import Path

import numpy as np
from archives import save
from calibrate_face_net import exposed_triangles
from numpy.typing import NDArray
from scipy.sparse import csr_matrix
from scipy.spatial import cKDTree

from cloner.detectors.face.face_net import load_face_net
from cloner.generic.load import GenericHuman, load_generic
from cloner.geometry.deformation.dffd import enclosing_points, sibson_weights

Array = NDArray[np.float64]
OUT = Path(__file__).resolve().parent.parent / "cloner_models" / "head_controls.npz"
FACE_GAP_M = 0.0055  # gives about 190 controls on the face, as was found necessary (parts)
ANCHOR_GAP_M = 0.024
FACE_TO_ANCHOR_M = 0.020


def spread(points: Array, gap: float, taken: Array) -> NDArray[np.int64]:
    """Return the points, in order, that lie at least ``gap`` from all before them and from ``taken``."""
    chosen: list[int] = []
    for index, point in enumerate(points):
        near = np.vstack([taken, points[chosen]])
        if len(near) == 0 or np.linalg.norm(near - point, axis=1).min() >= gap:
            chosen.append(index)
    return np.array(chosen, dtype=np.int64)


def face_controls(generic: GenericHuman) -> tuple[list[str], Array]:
    """Return names and places (K, 3) of the movable controls."""
    vertices = generic.vertices_m.astype(np.float64)
    net = load_face_net()
    places = net.places.at(vertices)
    # The middle first, so that the profile has its own controls; then the steadiest net points.
    low, high = vertices[generic.feature("chin_bottom"), 1] - 0.012, vertices[generic.feature("glabella"), 1] + 0.045
    body = generic.vertex_part == generic.part_names.index("body")
    shown = np.zeros(len(vertices), dtype=bool)
    triangles, _ = generic.triangles()
    shown[triangles[exposed_triangles(generic, triangles)]] = True
    front = vertices[:, 2] > vertices[generic.feature("neck_front_base"), 2]
    middle = np.flatnonzero(body & shown & front & (np.abs(vertices[:, 0]) < 1e-4)
                            & (vertices[:, 1] > low) & (vertices[:, 1] < high))  # fmt: skip
    middle = middle[np.argsort(vertices[middle, 1])]
    middle = middle[spread(vertices[middle], FACE_GAP_M, np.zeros((0, 3)))]
    order = np.argsort(net.sigma_m)
    order = order[spread(places[order], FACE_GAP_M, vertices[middle])]
    names = [f"middle_{v}" for v in middle] + [f"net_{n:03d}" for n in order]
    return names, np.vstack([vertices[middle], places[order]])


def main() -> None:
    """Choose, weigh, write."""
    generic = load_generic()
    vertices = generic.vertices_m.astype(np.float64)
    head = generic.head_vertices
    names, movable = face_controls(generic)
    body = head[generic.vertex_part[head] == generic.part_names.index("body")]
    inside = np.zeros(len(vertices), dtype=bool)
    inside[generic.region("mouth_interior")] = True
    outer = vertices[body[~inside[body]]]
    far = outer[cKDTree(movable).query(outer)[0] > FACE_TO_ANCHOR_M]
    # Forward of the ears a vertex without a control should follow its neighbours, not stand still.
    anchors = far[spread(far, ANCHOR_GAP_M, movable)]
    names += [f"anchor_{k:03d}" for k in range(len(anchors))]
    hull = enclosing_points(np.vstack([vertices[head], movable]))
    controls = np.vstack([movable, anchors, hull])
    weights = csr_matrix(sibson_weights(vertices[head], controls))
    weights.data[weights.data < 1e-5] = 0.0
    weights.eliminate_zeros()
    save(OUT, {"names": np.array(names, dtype=np.str_), "controls_m": controls[: len(names)].astype(np.float32),
               "movable": np.arange(len(names)) < len(movable), "data": weights.data.astype(np.float32),
               "indices": weights.indices.astype(np.int32), "indptr": weights.indptr.astype(np.int32),
               "shape": np.array(weights.shape, dtype=np.int32)})  # fmt: skip
    print(f"{len(movable)} movable, {len(anchors)} anchors, {weights.nnz / len(head):.1f} weights a vertex")


if __name__ == "__main__":
    main()
