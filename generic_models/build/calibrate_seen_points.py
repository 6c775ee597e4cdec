"""How far the label net's joints and points lie from the true ones: ``calibrate_seen_points.py PEOPLE [PEOPLE ...]``.

PEOPLE are folders of the generator of photographed synthetic people, none of whom taught the net or judges anybody.
Prints the tables of ``[seen_points.*]`` in ``cloner/calibration/generic.toml``: medians of the distances over 1.1774
(a Rayleigh distribution's), left and right together, by what the photo shows of the point.
"""

from __future__ import annotations

import argparse
from collections import defaultdict
from pathlib import Path

import numpy as np

from cloner.evaluate.measures.posing import JOINTS
from cloner.evaluate.truths.kit import kit_people, read_kit, side_shown
from cloner.frames import BODY_VIEWS
from cloner.generic.body_net import SIDES
from cloner.generic.seen_points import NAMES, kind_and_aspect
from cloner.project.folder import load_photos
from cloner.stages.figures import find_figure

TRUE_NAMES = {ours: name for name, ours in JOINTS.items()}


def main() -> None:
    """Look, compare, print."""
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("people", type=Path, nargs="+")
    far = defaultdict(list)
    for person in kit_people(parser.parse_args().people):
        truth = read_kit(person).truth
        for view, photo in load_photos(person).photos.items():
            if view not in BODY_VIEWS:
                continue
            seen, camera = truth.views[view].joints_m | dict(truth.views[view].points_m), truth.views[view].camera
            shown = side_shown(truth.views[view])
            for name, point in zip(NAMES, find_figure(photo).seen_px, strict=True):
                true = seen[TRUE_NAMES.get(name, name)]
                away = np.linalg.norm(point - camera.project(true[None])[0]) * camera.metres_per_pixel(true)
                kind, side = kind_and_aspect(name, shown)
                far[side, kind].append(away / truth.stature_m)
    for side in SIDES:
        own = {kind: np.median(away) / 1.1774 for (at, kind), away in far.items() if at == side}
        print(f"[seen_points.spread_{side}]\nvalue = {{ " + ", ".join(f"{k} = {v:.4f}" for k, v in own.items()) + " }")
        told = {kind: round(1700 * v, 1) for kind, v in own.items()}
        print("# mm at 1.70 m:", told, "people", len(far[side, "crotch"]), flush=True)


if __name__ == "__main__":
    main()
