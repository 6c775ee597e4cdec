"""A dressed clone as a result of its own: its garments are a shell, their motion is stored beside it.

Every program that shows clones shows it dressed; crowds let the cloth flow (`cloner.crowd.clones.flowing`).
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import replace
from pathlib import Path
from typing import Any, Final

import numpy as np
from numpy.typing import NDArray
from scipy import sparse
from scipy.spatial import cKDTree

from cloner.cloth.dressing import DressedClone
from cloner.cloth.simulation.covered import deeply_covered
from cloner.cloth.simulation.fabrics import Fabric
from cloner.cloth.simulation.moving import SETTLE
from cloner.cloth.simulation.wearer import make_wearer
from cloner.errors import ClonerError
from cloner.exporters.table import check_formats
from cloner.generic.load import load_generic
from cloner.geometry.articulation.skinning import dense_weights, strongest_weights
from cloner.geometry.meshes.triangles import edges_of
from cloner.pipeline import Progress
from cloner.project.atomic import result_folder
from cloner.project.flow_file import FLOW_FILE, save_flow
from cloner.project.folder import safe_identifier
from cloner.records.arrays import Array
from cloner.records.clones import Clone
from cloner.records.flows import Flow
from cloner.records.heads import Shell
from cloner.report.derived import make_manifest, write_result

#: Side of a garment's picture, texels, and how much lighter or darker its threads are, 0..1 (taste).
PICTURE_PX, THREADS = 256, 0.02
#: Times that a shell's weights are evened with their neighbours': cloth between the thighs follows both.
EVENED: Final = 30
SHELL: Final = "cloth"
#: Skin counts as covered so far under the nearest cloth, metres: the cloth's corners lie between the skin's.
UNDER_M: Final = -0.003


def check_folder(out: Path, clone_path: Path, formats: Sequence[str]) -> None:
    """Refuse a folder that cannot become a result, before any work.

    Raises
    ------
    ClonerError
        If it is the clone's own folder, no name of a result, or a format is not known.
    """
    check_formats(formats)
    safe_identifier(out.name)
    if out.resolve() in (clone_path.resolve(), clone_path.resolve().parent):
        raise ClonerError("the clone would be replaced by itself dressed", "Choose another name", out.name)


def write_garments_as_result(
    found: DressedClone, clone: Clone, source: Path, out: Path, garments: Sequence[str], formats: Sequence[str],
    progress: Progress,
) -> None:  # fmt: skip
    """Write a clone in its garments as a result of the same visitor.

    Parameters
    ----------
    found : DressedClone
    clone : Clone
        As its file holds it.
    source : Path
        Its folder or file.
    out : Path
        The new folder.
    garments : sequence of str
        Names of what it wears, the innermost first.
    formats : sequence of str
        Names of exporters.
    progress : callable

    Raises
    ------
    ClonerError
        If something cannot be written.
    """
    worn, flow = with_garment_shell(found, clone)
    progress("export", 0.9)
    fabrics = [one.fabric.name for one in found.layers]
    options = {"garment": list(garments), "fabric": fabrics, "motion": found.motion.name}
    write_shell_as_result(worn, source, out, options, formats, flow)
    progress("done", 1.0)


def write_shell_as_result(
    worn: Clone, source: Path, out: Path, options: Mapping[str, Any], formats: Sequence[str], flow: Flow | None = None
) -> None:
    """Write a clone with a worn shell, and the shell's motion, as a result of its source's visitor.

    Raises
    ------
    ClonerError
        If something cannot be written.
    """
    name = safe_identifier(out.name)
    with result_folder(out.parent, name) as folder:
        if flow is not None:
            save_flow(flow, folder / FLOW_FILE)
        write_result(worn, folder, f"Body {name}", formats, make_manifest(worn, "dressed", options, source))


def with_garment_shell(found: DressedClone, clone: Clone) -> tuple[Clone, Flow]:
    """Return a clone whose garments form one shell in place of its photographed loose clothes, and their motion."""
    layers = found.layers
    starts = np.cumsum([0, *(len(one.worn.cloth.flat_m) for one in layers)])
    triangles = np.concatenate(
        [one.worn.cloth.triangles + start for one, start in zip(layers, starts[:-1], strict=True)]
    )
    hung = np.concatenate([one.put_m[SETTLE - 1][one.worn.cloth.vertex] for one in layers])
    frames = np.concatenate([one.loop.frames_m[:, one.worn.cloth.vertex] for one in layers], axis=1)
    joints, weights = _skin_weights(found, hung, triangles)
    shell = Shell(
        hung, triangles, np.concatenate([_uv(one, k, len(layers)) for k, one in enumerate(layers)]), joints, weights,
        np.concatenate([_picture(one.fabric, len(layers)) for one in layers], axis=1), SHELL,
    )  # fmt: skip
    hidden = np.any([deeply_covered(one.worn, one.loop.frames_m, UNDER_M) for one in layers], axis=0)
    root, rotations = (each.astype(np.float32) for each in (found.worn.root_m, found.worn.rotations))
    kept = tuple(one for one in clone.shells if one.kind != SHELL)
    return replace(clone, shells=(*kept, shell)), Flow(frames.astype(np.float32), root, rotations, hidden)


def _skin_weights(found: DressedClone, hung_m: Array, triangles: NDArray[np.int64]) -> tuple[NDArray[np.int32], Array]:
    """Return joints (N, 4) and weights (N, 4) of the nearest skin, smoothed over the cloth."""
    generic, rows = load_generic(), make_wearer(found.clone, whole=True).rows
    near = rows[cKDTree(found.clone.vertices_m[rows]).query(hung_m)[1]]
    _, weld = np.unique(np.round(hung_m, 6), axis=0, return_inverse=True)
    weld = weld.reshape(-1)
    count = int(weld.max()) + 1
    dense = np.zeros((count, len(generic.joint_parents)))
    given = np.maximum(generic.skin_weights[near], 0.0)
    np.add.at(dense, weld, dense_weights(generic.skin_joints[near], given, dense.shape[1]))
    ends = edges_of(weld[triangles].astype(np.int32))[0]
    ends = ends[ends[:, 0] != ends[:, 1]]
    ones = np.ones(2 * len(ends))
    both = (np.concatenate([ends[:, 0], ends[:, 1]]), np.concatenate([ends[:, 1], ends[:, 0]]))
    beside = sparse.csr_matrix((ones, both), shape=(count, count)) + sparse.identity(count)
    beside = sparse.diags(1.0 / np.asarray(beside.sum(axis=1)).ravel()) @ beside
    dense /= dense.sum(axis=1, keepdims=True)
    for _ in range(EVENED):
        dense = beside @ dense
    joints, weights = strongest_weights(dense)
    return joints[weld], weights[weld]


def _uv(one: DressedClone, place: int, count: int) -> Array:
    """Return (W, 2) texture coordinates: the pieces as they were cut, each garment in its column of the picture."""
    flat, segment = one.worn.cloth.flat_m, one.worn.cloth.segment
    pieces = int(segment.max()) + 1
    sizes = np.array([np.ptp(flat[segment == k], axis=0) for k in range(pieces)]).max(axis=0)
    low = np.array([flat[segment == k].min(axis=0) for k in range(pieces)])
    share = (flat - low[segment]) / sizes
    u = (place + (segment + 0.05 + 0.9 * share[:, 0]) / pieces) / count
    return np.column_stack([u, 0.02 + 0.96 * (1.0 - share[:, 1])])


def _picture(fabric: Fabric, count: int) -> NDArray[np.uint8]:
    """Return (PICTURE_PX, PICTURE_PX / count, 4) of a fabric: its colour, thread by thread."""
    wide = PICTURE_PX // count
    noise = np.random.default_rng(24)
    woven = noise.normal(size=(PICTURE_PX, 1)) + noise.normal(size=(1, wide))
    shade = np.clip(1.0 + THREADS / 2.0 * woven, 1.0 - 2.0 * THREADS, 1.0 + 2.0 * THREADS)
    rgb = np.clip(np.array(fabric.rgb) * shade[:, :, None], 0, 255)
    return np.dstack([rgb, np.full((PICTURE_PX, wide), 255.0)]).round().astype(np.uint8)
