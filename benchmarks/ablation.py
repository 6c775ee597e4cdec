"""What each step of the method is worth: people of the generator with one step left out or replaced, paired.

    python benchmarks/ablation.py PEOPLE --count 60 --keep DIR --workers 2 [--page]

PEOPLE holds folders as the generator writes them, with the body seen from 45 degrees. A person's photos are read
once; then outlines, body, head and places in the photos are made in every way that ``WAYS`` names, and scored. What
is kept is not made again. ``--page`` writes ``docs/ablation.md``.
"""

from __future__ import annotations

import argparse
import json
import random
from collections.abc import Callable, Iterator, Mapping
from concurrent.futures import ProcessPoolExecutor
from contextlib import ExitStack, contextmanager
from dataclasses import dataclass, replace
from functools import partial
from multiprocessing import get_context
from pathlib import Path
from typing import Any, Final
from unittest.mock import patch

import numpy as np
from ablation_figures import Figures, apart_mm, body_figures, curve_figures, head_figures, outline_figures
from ablation_page import ALL, table, write_page
from body_people import commit, write_json
from numpy.typing import NDArray
from skimage import measure

from cloner.detectors.face import face_curves
from cloner.errors import ClonerError
from cloner.evaluate.truths.kit import KitTruth, kit_people, photos_without_truth, read_kit
from cloner.evaluate.truths.truth import given_height_m
from cloner.generic.load import load_generic
from cloner.paint.lookups.sources import Source
from cloner.pipeline import STAGES
from cloner.records.proposals import Proposals
from cloner.records.silhouettes import SilhouetteSet
from cloner.records.views import Camera, View, ViewSet
from cloner.stages import fine, head, rough, skeleton, textures
from cloner.testing import folder_values, run_stages, up_to
from cloner.vision.contours import paths, tracing

Array = NDArray[np.float64]
Values = dict[str, Any]

#: What follows from the outlines, and from the phenotype.
BODY: Final = ("skeleton", "rough", "fine")
FIT: Final = ("phenotype", *BODY)


@dataclass(frozen=True, slots=True)
class Way:
    """One way to leave a step out: stages that run again, from which changed values, with what in a step's place.

    Attributes
    ----------
    again : tuple of str
        Stages; what they give is forgotten first.
    instead : tuple of (module, name, what stands in its place)
    change : callable
        Gives the values that the stages begin with.
    """

    again: tuple[str, ...]
    instead: tuple[tuple[Any, str, Any], ...] = ()
    change: Callable[[Values], Values] = dict


class _Seen(Exception):
    """The photos' sources, before they meet."""

    def __init__(self, sources: list[Source]) -> None:
        super().__init__()
        self.sources = sources


def random_path(near: paths.Candidates, *, longest_bridge_px: float) -> paths.Path | None:
    """Return any of the longer half of the paths that links make instead of the one of highest G^P.

    With the shorter ones, which cover a pixel or two each, one person took five minutes.
    """
    following, preceding = paths.best_successors(
        near, longest_bridge_px=longest_bridge_px, smoothness_rad=paths.SMOOTHNESS_RAD
    )
    grown = sorted({paths.grow_path(seed, following, preceding) for seed in range(len(following))})
    if not grown:
        return None
    grown.sort(key=lambda path: int(near.counts[list(path)].sum()))
    members = np.array(random.Random(len(grown)).choice(grown[len(grown) // 2 :]), dtype=np.intp)
    return paths.Path(members, paths.score_path(members, near))


def orthographic(values: Values) -> Values:
    """Return the values with the paper's cameras at infinite distance, each with the scale at the person's middle."""
    views = {}
    for view, seen in values["views"].views.items():
        old = seen.camera
        depth = float(old.to_camera(np.array([[0.0, 0.9, 0.0]]))[0, 2])
        camera = Camera(old.width_px, old.height_px, old.focal_px, old.camera_from_model, old.focal_px / depth)
        views[view] = View(view, camera, seen.side_shown, seen.focal_known)
    return {**values, "views": ViewSet(views)}


def mask_only(values: Values) -> Values:
    """Return the values with the contours of the net's mask instead of linked edges."""
    found, views = values["silhouettes"].views, {}
    for view, proposal in values["proposals"].views.items():
        padded = np.pad(proposal.mask.astype(np.float64), 1)
        contours = sorted(
            (line[:-1, ::-1] - 1.0 for line in measure.find_contours(padded, 127.5)), key=len, reverse=True
        )
        kept = tuple(line for line in contours if len(line) > 0.05 * len(contours[0]))
        if view in found:
            views[view] = replace(found[view], contours_px=kept, mask=proposal.person(), sources=())
    return {**values, "silhouettes": SilhouetteSet({**found, **views})}


def unseen_joints(values: Values) -> Values:
    """Return the values without the joints that the label net saw under the clothes."""
    views = {view: replace(one, seen_px=one.seen_px[:0]) for view, one in values["proposals"].views.items()}
    return {**values, "proposals": Proposals(views)}


def no_shift(*_: object) -> Array:
    """Move no joint to the middle of its limb."""
    return np.zeros(3)


def as_it_is(mesh: Any, *_: object) -> Any:
    """Return the body as it was before the step."""
    return mesh


NO_SKELETON: Final = (skeleton, "key_shift", no_shift)
NO_END_SLICES: Final = (rough, "shape_slices", as_it_is)
NO_SLICES: Final = (fine, "shape_slices", as_it_is)
#: Steps left out or replaced.
WAYS: Final[Mapping[str, Way]] = {
    "outlines are the mask's contour": Way((*FIT, "head"), change=mask_only),
    "outlines are random paths": Way(("silhouettes", *FIT, "head"), ((tracing, "best_path", random_path),)),
    "without joints seen under clothes": Way((*FIT, "head"), change=unseen_joints),
    "cameras at infinite distance": Way(FIT, change=orthographic),
    "without skeleton": Way(BODY, (NO_SKELETON,)),
    "without slices at the parts' ends": Way(BODY, (NO_END_SLICES,)),
    "without slices of the skin": Way(BODY, (NO_SLICES,)),
    "without skeleton and all slices": Way(BODY, (NO_SKELETON, NO_END_SLICES, NO_SLICES)),
    "without turning limbs, hands and feet": Way(
        BODY, ((fine, "fit_extremities", lambda mesh, photos, *_: (mesh, photos)),)
    ),
    "without settling": Way(BODY, ((fine, "settle_on_outlines", as_it_is),)),
    "without the snake": Way(
        ("proposals", "points", "head"),
        ((face_curves, "run_snake", lambda picture, curve, params: (curve.points_px, np.zeros(len(curve.points_px)))),),
    ),
    "without DFFD of what is left over": Way(
        ("head",), ((head, "add_relief", lambda model, fitted, *_: (fitted, np.zeros((1, 3)))),)
    ),
}
#: What photos do not meet without: asked of their places alone.
APART: Final = "without the meeting of feature lines"
#: The figure that each step is there for.
OWN: Final = {
    "outlines are the mask's contour": "outline px",
    "outlines are random paths": "outline px",
    "without joints seen under clothes": "joints mm",
    "cameras at infinite distance": "45 degrees IoU",
    "without skeleton": "joints mm",
    "without slices at the parts' ends": "input IoU",
    "without slices of the skin": "input IoU",
    "without skeleton and all slices": "input IoU",
    "without turning limbs, hands and feet": "input IoU",
    "without settling": "input IoU",
    "without the snake": "lids and lips %",
    "without DFFD of what is left over": "face mm",
    APART: "photos apart mm",
}


@contextmanager
def replaced(way: Way) -> Iterator[None]:
    """Put other functions in the place of a way's steps for a while."""
    with ExitStack() as undo:
        for module, name, instead in way.instead:
            undo.enter_context(patch.object(module, name, instead))
        yield


def sources_of(values: Values) -> list[Source]:
    """Return the photos as sources of colour, before they meet."""

    def stop(_: object, sources: list[Source]) -> list[Source]:
        raise _Seen(sources)

    with replaced(Way((), ((textures, "align_feature_lines", stop),))):
        try:
            run_stages(values, up_to("textures"))
        except _Seen as seen:
            return seen.sources
    raise ValueError("no photo shows the body")


def judge(person: Path, keep: Path) -> dict[str, Any]:
    """Score one person in every way, keep the figures and return them."""
    kept = keep / f"{person.name}.json"
    if kept.is_file():
        return dict(json.loads(kept.read_text()))
    kit = read_kit(person)
    with photos_without_truth(person) as folder:
        values = folder_values(folder)
    values["person"] = replace(values["person"], stature_m=given_height_m(person), stature_is_known=True)
    values, _ = run_stages(values, up_to("head"))
    asked = (outline_figures, body_figures, curve_figures, head_figures)
    ways = {ALL: {name: value for ask in asked for name, value in ask(values, kit).items()}}
    for name, way in WAYS.items():
        ways[name] = figures(way, values, kit)
    places = sources_of(values)
    ways[ALL]["photos apart mm"] = apart_mm(textures.align_feature_lines(load_generic(), places), kit)
    ways[APART] = {"photos apart mm": apart_mm(places, kit)}
    row = {"name": person.name, "commit": commit(), "ways": ways}
    write_json(kept, row)
    return row


def figures(way: Way, values: Values, kit: KitTruth) -> Figures:
    """Return the figures of a person made in one way: those that may be others than the product's."""
    forgotten = {name for stage in STAGES if stage.name in way.again for name in stage.gives}
    left = {name: value for name, value in way.change(values).items() if name not in forgotten}
    with replaced(way):
        made, _ = run_stages(left, way.again)
    found = outline_figures(made, kit) if made["silhouettes"] is not values["silhouettes"] else {}
    if made["body"] is not values["body"]:
        found |= body_figures(made, kit)
    if "proposals" in way.again:
        found |= curve_figures(made, kit)
    if made["head"] is not values["head"]:
        found |= head_figures(made, kit)
    return found


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("people", type=Path)
    parser.add_argument("--count", type=int, default=60)
    parser.add_argument("--keep", type=Path, required=True)
    parser.add_argument("--workers", type=int, default=1)
    parser.add_argument("--page", action="store_true")
    told = parser.parse_args()
    todo = kit_people([told.people])[: told.count]
    rows = []
    with ProcessPoolExecutor(told.workers, get_context("spawn")) as pool:
        for row in pool.map(partial(guarded, keep=told.keep), todo):
            rows += [row] if row else []
    print(table(rows))
    if told.page:
        write_page(rows, OWN, f"python benchmarks/ablation.py PEOPLE --count {told.count} --keep DIR --page")


def guarded(person: Path, keep: Path) -> dict[str, Any] | None:
    """Return one person's figures, None for who is refused."""
    try:
        return judge(person, keep)
    except ClonerError as error:
        print(f"{person.name}: refused: {error}")
        return None


if __name__ == "__main__":
    main()
