"""Learn how a face's proposed points err together: ``python generic_models/build/calibrate_face_errors.py``.

Random painted people, beyond the generic's family as those of ``calibrate_head_net.py``, are photographed from the
front and one side; what the product proposes is compared with the truth. The result, ``cloner_models/face_errors.npz``,
lets a point that an operator places correct its neighbours (``cloner/detectors/propagation.py``). To be repeated when
detectors change (80 people: 6 CPU minutes).
"""

from __future__ import annotations

import argparse
from dataclasses import dataclass
from pathlib import Path
from typing import Final

import numpy as np
from archives import save
from calibrate_head_net import beyond_family
from numpy.typing import NDArray
from painted_faces import EXTRAS, KnownFace, make_sitter, photograph_face
from painted_people_pictures import BACKGROUNDS

from cloner.detectors.face.face_net import load_face_net
from cloner.detectors.face.face_points import propose_face_points
from cloner.detectors.propagation import LEAST, MOST
from cloner.errors import ClonerError
from cloner.frames import FACE_VIEWS, ViewId
from cloner.generic.load import load_generic
from cloner.records.points import expected_face_error
from cloner.stages.proposals import propose

Array = NDArray[np.float64]
OUT = Path(__file__).resolve().parent.parent / "cloner_models" / "face_errors.npz"
FIRST_SITTER: Final = 7000  # far from the seeds of other calibrations, of tests and of benchmarks
EXTRA_EVERY: Final = 4
#: Errors beyond this many expected errors count as that many: one lost ear must not speak for all.
WILD: Final = 4.0
#: Weight of "no point errs with another", in sitters (leave-out likelihood is flat from 5 to 40).
ALONE: Final = 15.0


@dataclass(frozen=True, slots=True, eq=False)
class Proposed:
    """One photo's points (K, 2) by name, confidence (K,), truth, eye distance, all px, and looking left or right.

    ``net_px`` and ``net_true_px`` (468, 2) are the front photo's net points and their places; empty of a side photo.
    """

    names: tuple[str, ...]
    points_px: Array
    confidence: Array
    true_px: Array
    iod_px: float
    facing: int
    net_px: Array
    net_true_px: Array


def show(known: KnownFace) -> Proposed:
    """Return what the product proposes for a photo, and the truth.

    Raises
    ------
    ClonerError
        If the photo is refused.
    """
    generic, proposal = load_generic(), propose(known.photo)
    points = propose_face_points(known.photo, proposal)
    rows = [row for row, name in enumerate(points.names) if name in generic.feature_names]
    names = tuple(points.names[row] for row in rows)
    true = known.camera.project(known.vertices_m[[generic.feature(name) for name in names]].reshape(-1, 3))
    front = known.view is ViewId.FACE_FRONT
    net_true = known.camera.project(load_face_net().places.at(known.vertices_m)) if front else np.zeros((0, 2))
    net = proposal.face_px if front else np.zeros((0, 2))
    return Proposed(names, points.points_px[rows], points.confidence[rows], true, known.iod_px, known.facing, net,
                    net_true)  # fmt: skip


def sitter(seed: int) -> list[Proposed]:
    """Return what is proposed for the photos of one random person that are not refused."""
    extras = () if seed % EXTRA_EVERY else (EXTRAS[seed // EXTRA_EVERY % len(EXTRAS)],)
    person = make_sitter(seed, extras, beyond_m=beyond_family(seed))
    found = []
    for view in FACE_VIEWS:
        try:
            found.append(show(photograph_face(person, view, background=BACKGROUNDS[seed % len(BACKGROUNDS)])))
        except ClonerError:
            continue
    return [one for one in found if one.names]


def mirrored(one: Proposed, twin: NDArray[np.int64]) -> Proposed:
    """Return a front photo's errors as its mirror image has them; ``twin`` are the net's points on the other side."""
    other = [_partner(name) for name in one.names]
    rows = [one.names.index(name) for name in other]
    flip = np.array([-1.0, 1.0])
    return Proposed(one.names, one.points_px[rows] * flip, one.confidence[rows], one.true_px[rows] * flip, one.iod_px,
                    one.facing, one.net_px[twin] * flip, one.net_true_px[twin] * flip)  # fmt: skip


def _partner(name: str) -> str:
    return name[:-1] + {"L": "R", "R": "L"}[name[-1]] if name.endswith(("_L", "_R")) else name


def in_expected(one: Proposed) -> Array:
    """Return (2K,) what has to be added to each point, x and y after each other, in its expected error."""
    expected = np.clip(expected_face_error(one.confidence), LEAST, MOST)
    away = (one.true_px - one.points_px) / one.iod_px * [float(one.facing or 1), 1.0]
    return np.asarray(np.clip(away / expected[:, None], -WILD, WILD).ravel())


def moments(photos: list[Proposed]) -> dict[str, NDArray[np.generic]]:
    """Return layout and mean products of errors of photos that name the same points."""
    errors = np.stack([in_expected(one) for one in photos])
    moment = errors.T @ errors / len(errors)
    share = ALONE / (ALONE + len(errors))
    moment = (1.0 - share) * moment + share * np.diag(np.diag(moment))
    laid = [(one.points_px - one.points_px.mean(axis=0)) / one.iod_px * [float(one.facing or 1), 1.0] for one in photos]
    names = [_plain(name, photos[0].facing) for name in photos[0].names]
    out: dict[str, NDArray[np.generic]] = {
        "names": np.array(names, dtype=np.str_),
        "layout_iod": np.mean(laid, axis=0).astype(np.float32),
        "moment": moment.astype(np.float32),
    }
    if len(photos[0].net_px):
        net = np.stack([(one.net_true_px - one.net_px) / one.iod_px for one in photos])
        out["net"] = ((1.0 - share) * np.einsum("pnx,pk->nxk", net, errors) / len(errors)).astype(np.float16)
    return out


def _plain(name: str, facing: int) -> str:
    return name[:-2] if facing and name.endswith(("_L", "_R")) else name


def calibrate(photos: list[Proposed]) -> dict[str, NDArray[np.generic]]:
    """Return the arrays of ``face_errors.npz``; a front photo counts with its mirror image."""
    mean = load_face_net().places.at(load_generic().vertices_m.astype(np.float64))
    twin = np.linalg.norm((mean * [-1.0, 1.0, 1.0])[:, None] - mean[None], axis=2).argmin(axis=1)
    fronts, sides = [one for one in photos if not one.facing], [one for one in photos if one.facing]
    whole = [one for one in sides if len(one.names) == max(len(side.names) for side in sides)]
    found = {"front": moments(fronts + [mirrored(one, twin) for one in fronts]), "side": moments(whole)}
    return {f"{view}_{name}": array for view, arrays in found.items() for name, array in arrays.items()}


def main() -> None:
    """Photograph, propose, average, write."""
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--sitters", type=int, default=80)
    seeds = range(FIRST_SITTER, FIRST_SITTER + parser.parse_args().sitters)
    photos = [one for seed in seeds for one in sitter(seed)]
    arrays = calibrate(photos)
    save(OUT, arrays)
    print(f"{len(photos)} photos; {OUT.stat().st_size} bytes")


if __name__ == "__main__":
    main()
