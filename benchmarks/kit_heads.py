"""Faces of people of the generator, and what each kind of evidence costs them.

``python benchmarks/kit_heads.py PEOPLE`` clones everybody in PEOPLE as far as the head and prints similarity, landmarks
and the side camera's turn beside the generic head's. ``--exchange`` puts the truth in place of each kind of evidence:
masks and labels, the net's points, the named points, all. Some 10 CPU seconds a person, 25 with the exchanges.
The photos may be of any size; figures told in the docs are of photos 600 px wide.
"""

from __future__ import annotations

import argparse
from collections.abc import Callable
from dataclasses import dataclass, replace
from pathlib import Path
from typing import Final

import numpy as np
from head_scans import azimuth_error_deg
from head_scores import ruler, score
from head_steps import Values, before_head, finished, true_net_px, true_points
from numpy.typing import NDArray

from cloner.errors import ClonerError
from cloner.evaluate.measures.posing import LANDMARKS
from cloner.evaluate.measures.rulers import fit_similarity
from cloner.evaluate.truths.kit import KitTruth, kit_people, read_kit
from cloner.frames import FACE_VIEWS, ViewId
from cloner.generic.load import load_generic
from cloner.project.folder import load_photos, read_person
from cloner.records.points import PointSet
from cloner.records.proposals import Proposals
from cloner.records.silhouettes import SilhouetteSet

Array = NDArray[np.float64]


@dataclass(frozen=True, slots=True, eq=False)
class KitHead:
    """What is true of one generated person's head: all of it, and the whole body (V, 3) in the pose of each photo."""

    kit: KitTruth

    def vertices_m(self, view: ViewId) -> Array:
        """Return the generic's vertices, those of the naked body where they truly are in a photo's pose."""
        return self.kit.whole_m(view.value)


def with_true_masks(values: Values, head: KitHead) -> Values:
    """Return the values with the true labels and masks of the face photos."""
    views = dict(values["proposals"].views)
    for view in [view for view in FACE_VIEWS if view in views]:
        labels = head.kit.labels[view.value]
        mask = np.where(labels > 0, 255, 0).astype(np.uint8)
        views[view] = replace(views[view], labels=labels, mask=mask)
    kept = {view: one for view, one in values["silhouettes"].views.items() if not view.is_face}
    return {**values, "proposals": Proposals(views), "silhouettes": SilhouetteSet(kept)}


def with_true_net(values: Values, head: KitHead) -> Values:
    """Return the values with the front photo's 468 points where the net draws such a face on the average."""
    views = dict(values["proposals"].views)
    camera = head.kit.truth.views[ViewId.FACE_FRONT.value].camera
    points = true_net_px(head.vertices_m(ViewId.FACE_FRONT), camera)
    views[ViewId.FACE_FRONT] = replace(views[ViewId.FACE_FRONT], face_px=points)
    return {**values, "proposals": Proposals(views)}


def with_true_points(values: Values, head: KitHead) -> Values:
    """Return the values with every found named point of both photos put where it truly is, as an operator would."""
    generic, views = load_generic(), dict(values["face_points"].views)
    for view in [view for view in FACE_VIEWS if view in views]:
        whole, known = head.vertices_m(view), [name for name in views[view].names if name in generic.feature_names]
        marks = {name: whole[generic.feature(name)] for name in known}
        views[view] = true_points(views[view], head.kit.truth.views[view.value].camera.project, marks)
    return {**values, "face_points": PointSet(views)}


Exchange = Callable[[Values, KitHead], Values]
EXCHANGES: Final[dict[str, tuple[Exchange, ...]]] = {
    "found": (),
    "masks": (with_true_masks,),
    "net": (with_true_net,),
    "points": (with_true_points,),
    "all": (with_true_masks, with_true_net, with_true_points),
}


def figures(values: Values, head: KitHead) -> tuple[float, float, float]:
    """Return similarity mm, landmarks mm, and by how much the side camera is turned wrongly, degrees (NaN: none)."""
    generic, truth = load_generic(), head.kit.truth
    vertices, _, _, fit = finished(values)
    told = score(vertices, ruler(truth.surface), generic)
    turned = np.nan
    if ViewId.FACE_SIDE in fit.cameras:
        rows = [generic.feature(name) for name in LANDMARKS if not name.startswith("ear")]
        lay = fit_similarity(head.vertices_m(ViewId.FACE_SIDE)[rows], vertices[rows], scale=False)[:3, :3]
        true = truth.views[ViewId.FACE_SIDE.value].camera
        turned = abs(azimuth_error_deg(lay, fit.cameras[ViewId.FACE_SIDE], true))
    return told["similarity_mm"], told["landmarks_mean_mm"], turned


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("people", type=Path)
    parser.add_argument("--exchange", action="store_true")
    chosen = parser.parse_args()
    rows: list[list[tuple[float, float, float]]] = []
    generic_mm = []
    names = list(EXCHANGES) if chosen.exchange else ["found"]
    for person in kit_people([chosen.people]):
        try:
            values, _ = before_head(load_photos(person), read_person(person))
        except ClonerError as error:
            print(f"{person.name}: {error}", flush=True)
            continue
        head = KitHead(read_kit(person))
        own = []
        for name in names:
            exchanged = values
            for exchange in EXCHANGES[name]:
                exchanged = exchange(exchanged, head)
            own.append(figures(exchanged, head))
        plain, _ = load_generic().shape(np.zeros(0), values["phenotype"].stature_m)
        generic_mm.append(score(plain, ruler(head.kit.truth.surface), load_generic())["similarity_mm"])
        rows.append(own)
        told = "  ".join(
            f"{name} {mm:.2f} mm, {marks:.1f} mm, {turn:.1f} deg"
            for name, (mm, marks, turn) in zip(names, own, strict=True)
        )
        print(f"{person.name}: generic {generic_mm[-1]:.2f}  {told}", flush=True)
    if not rows:
        return
    means, nearer = np.nanmean(rows, axis=0), np.mean(np.array(rows)[:, 0, 0] < generic_mm)
    for name, (mm, marks, turn) in zip(names, means, strict=True):
        print(f"{name}: {mm:.3f} mm, landmarks {marks:.2f} mm, side camera {turn:.1f} degrees")
    print(f"{len(rows)} people; generic {np.mean(generic_mm):.3f} mm, nearer than it {100 * nearer:.0f} %")


if __name__ == "__main__":
    main()
