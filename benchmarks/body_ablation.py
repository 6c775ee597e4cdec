"""What each part of the method is worth: the same people with a part left out or broken."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping
from contextlib import contextmanager
from dataclasses import replace
from functools import partial
from pathlib import Path
from typing import Any, Final

import cv2
import numpy as np
from body_people import Case, commit, step_clones, write_json
from body_scores import HELD_OUT, score_step
from skimage import measure

from cloner.generic.load import load_generic
from cloner.records.points import PointSet, Proposals, ViewPoints
from cloner.records.silhouettes import Silhouette, SilhouetteSet
from cloner.records.views import Camera, View, ViewSet
from cloner.stages import fine, rough, skeleton
from cloner.testing import first_values, run_stages

Values = dict[str, Any]

FIRST: Final = ("proposals", "points", "views", "silhouettes")
FIT: Final = ("phenotype", "skeleton", "rough", "fine")
#: A coarse mask is rounded by this share of the photo's height: about 40 mm on the person.
COARSE_SHARE: Final = 0.02
#: How far an injected wrong point lies from its place, share of the photo's height.
WRONG_SHARE: Final = (0.06, 0.12)


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
    views = {}
    for view, proposal in values["proposals"].views.items():
        padded = np.pad(proposal.mask.astype(np.float64), 1)

        contours = sorted(
            (line[:-1, ::-1] - 1.0 for line in measure.find_contours(padded, 127.5)), key=len, reverse=True
        )
        kept = tuple(line for line in contours if len(line) > 0.05 * len(contours[0]))
        views[view] = Silhouette(view, kept, proposal.mask > 127, ())
    return {**values, "silhouettes": SilhouetteSet(views)}


def edges_only(values: Values) -> Values:
    """Return the values with outlines linked in the band of a mask that only roughly says where the person is."""
    coarse = {}
    for view, proposal in values["proposals"].views.items():
        sigma = COARSE_SHARE * len(proposal.mask)
        coarse[view] = replace(proposal, mask=cv2.GaussianBlur(proposal.mask, (0, 0), sigma))
    bare = {name: value for name, value in values.items() if name != "silhouettes"}
    linked, _ = run_stages({**bare, "proposals": Proposals(coarse)}, ("silhouettes",))
    return {**values, "silhouettes": linked["silhouettes"]}


def wrong_points(values: Values, *, count: int) -> Values:
    """Return the values with some proposed points a photo far from their places, with full confidence."""
    rng = np.random.default_rng(count)
    views = {}
    for view, points in values["body_points"].views.items():
        height = values["photos"].photos[view].height_px
        places = points.points_px.copy()
        rows = rng.choice(len(places), count, replace=False)
        turn = rng.uniform(0.0, 2.0 * np.pi, count)
        away = height * rng.uniform(*WRONG_SHARE, count)
        places[rows] += away[:, None] * np.stack([np.cos(turn), np.sin(turn)], axis=1)
        confidence = points.confidence.copy()
        confidence[rows] = np.maximum(confidence[rows], 0.6)
        views[view] = ViewPoints(view, points.names, places, confidence, points.corrected)
    bare = {name: value for name, value in values.items() if name not in ("silhouettes", "body_points")}
    linked, _ = run_stages({**bare, "body_points": PointSet(views)}, ("silhouettes",))
    return linked


def unchanged(values: Values) -> Values:
    """Return the values as they are."""
    return values


@contextmanager
def slices(count: int) -> Iterator[None]:
    """Cut every part into so many slices while the fine skin is fitted."""
    before = fine.Params
    fine.Params = partial(before, slices=count)  # type: ignore[misc,assignment]
    try:
        yield
    finally:
        fine.Params = before  # type: ignore[misc]


#: Steps of the fit, and what leaves the body as it is in their place.
STEPS: Final[Mapping[str, tuple[Any, str, Callable[..., Any]]]] = {
    "joints moved to the limbs' middles": (skeleton, "key_shift", lambda *rest: np.zeros(3)),
    "slices at the parts' ends": (rough, "shape_slices", lambda mesh, *rest: mesh),
    "slices of the skin": (fine, "shape_slices", lambda mesh, *rest: mesh),
    "hands and feet": (fine, "extremities", lambda mesh, photos, sole_m: (mesh, photos)),
    "settling": (fine, "settled", lambda mesh, *rest: mesh),
}


@contextmanager
def without(step: str) -> Iterator[None]:
    """Leave out a step of the fit; "" leaves out none."""
    if not step:
        yield
        return
    module, name, instead = STEPS[step]
    before = getattr(module, name)
    setattr(module, name, instead)
    try:
        yield
    finally:
        setattr(module, name, before)


VARIANTS: Final[Mapping[str, tuple[Callable[[Values], Values], int, str]]] = {
    "all": (unchanged, 16, ""),
    "orthographic cameras": (orthographic, 16, ""),
    "mask only": (mask_only, 16, ""),
    "edges only": (edges_only, 16, ""),
    "8 slices": (unchanged, 8, ""),
    "32 slices": (unchanged, 32, ""),
    "2 wrong points a photo": (partial(wrong_points, count=2), 16, ""),
    "4 wrong points a photo": (partial(wrong_points, count=4), 16, ""),
    **{f"without {step}": (unchanged, 16, step) for step in STEPS},
}


def ablate(case: Case, folder: Path) -> dict[str, Any]:
    """Score one random person's fine body under every variant; writes and returns the JSON."""
    from body_truth import known_truth, photograph

    known = photograph(case.seed, case.tightness, case.background)
    truth, generic = known_truth(known), load_generic()
    values, _ = run_stages(first_values(known.photos, known.person), FIRST)
    variants = {}
    for name, (change, count, left_out) in VARIANTS.items():
        with slices(count), without(left_out):
            fitted, _ = run_stages(change(values), FIT)
        score = score_step(step_clones(fitted, generic)["fine"], generic, truth)
        inputs = [value for view, value in score["below_head_iou"].items() if view != HELD_OUT]
        variants[name] = {
            "surface_mean_mm": score["surface_mean_mm"],
            "surface_p95_mm": score["surface_p95_mm"],
            "below_head_iou": float(np.mean(inputs)),
            "held_out_iou": score["below_head_iou"][HELD_OUT],
        }
    row = {
        "name": f"ablation_{case.name}",
        "tightness": case.tightness,
        "background": case.background,
        "variants": variants,
        "commit": commit(),
    }
    write_json(folder / f"ablation_{case.name}.json", row)
    return row
