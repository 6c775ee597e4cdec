"""How good is the hair? ``python benchmarks/hair.py [--people N] [--first SEED] [--visitors DIR] [--pictures DIR]``

Random people in six kinds of hair (short, full, long, tied, bald, under a cap) are photographed five times and cloned
by the product's own stages; the finished clone's visible hair is laid on the true hair of every photo: overlap, how far
the head outline lies off at the crown, and the overlap of the photo's own labels. "True skin" is the hair stage on the
true body, poses and cameras: what the hair itself loses. ``--visitors shared/visitors`` scores the sample visitors too
(their textured truth is not shipped).
"""

from __future__ import annotations

import argparse
import sys
import time
from collections.abc import Iterator
from dataclasses import replace
from pathlib import Path
from typing import Any, Final

import cv2
import numpy as np
from hair_people import HairCase, random_case, visitor_case, visitor_names
from numpy.typing import NDArray

from cloner.errors import ClonerError
from cloner.frames import BODY_VIEWS, FACE_VIEWS, ViewId, m_from_mm, mm_from_m
from cloner.generic.layers import Layer, clone_layers
from cloner.generic.load import load_generic
from cloner.paint.details.tucking import tuck_scalp
from cloner.records.clones import Clone
from cloner.records.labels import Label
from cloner.render import coverage, draw
from cloner.testing import STAGE_NAMES, first_values, run_stages, untextured

Bools = NDArray[np.bool_]
Values = dict[str, Any]

#: The crown: this far to either side of the head's middle, which is taken this far below the top, mm.
CROWN_MM, BELOW_MM = 50.0, 60.0
LEFT_OUT: Final = ("hair", "textures", "regions", "measures")


def before_hair(case: HairCase) -> Values:
    """Return the values of all stages before the hair."""
    return run_stages(first_values(case.photos, case.person), set(STAGE_NAMES).difference(LEFT_OUT))[0]


def with_hair(values: Values) -> tuple[Clone, float]:
    """Return the untextured clone with its hair, and the hair stage's CPU seconds."""
    begin = time.process_time()
    found, _ = run_stages(values, ("hair",))
    seconds = time.process_time() - begin
    shells: Any = found["shells"]
    joined = values["obeyed"]
    tucked = replace(joined, vertices_m=tuck_scalp(load_generic(), joined.vertices_m, shells))
    return untextured(tucked, shells), seconds


def only_hair(clone: Clone, layers: list[Layer]) -> list[Layer]:
    """Return the layers with hair white and all else black, alpha kept."""
    found = []
    kinds = [""] * (len(layers) - len(clone.shells)) + [shell.kind for shell in clone.shells]
    for layer, kind in zip(layers, kinds, strict=True):
        value = 255 if kind == "hair" else 0
        texture = layer.texture
        if texture is not None and texture.shape[2] == 4:
            texture = np.dstack([np.full((*texture.shape[:2], 3), value, np.uint8), texture[..., 3]])
        else:
            texture = None
        found.append(replace(layer, texture=texture, colour=(value / 255.0,) * 3))
    return found


def overlap(first: Bools, second: Bools) -> float:
    """Return intersection over union."""
    return float((first & second).sum() / max((first | second).sum(), 1))


def crown_mm(found: Bools, true: Bools, pixel_mm: float) -> float:
    """Return how much lower the found outline runs over the crown than the true one, mm."""
    top = int(np.flatnonzero(true.any(axis=1))[0])
    middle = int(np.median(np.flatnonzero(true[top + round(BELOW_MM / pixel_mm)])))
    reach = round(CROWN_MM / pixel_mm)
    columns = slice(max(middle - reach, 0), middle + reach)
    tops = [np.where(m[:, columns].any(axis=0), m[:, columns].argmax(axis=0), np.nan) for m in (found, true)]
    return float(np.nanmean(tops[0] - tops[1]) * pixel_mm)


def score(case: HairCase, clone: Clone, values: Values, pictures: Path | None) -> Iterator[dict[str, Any]]:
    """Yield a row a photo; on a bald head ``hair`` is minus the share of the person that the clone's hair covers."""
    skull = clone.joints_m[load_generic().joint("skullbase")]
    rows = []
    for view in (view for view in (*BODY_VIEWS, *FACE_VIEWS) if view in clone.views and view in case.hair):
        posed, true = clone.views[view], case.hair[view]
        layers = clone_layers(clone, posed.rotations)
        hair = draw(only_hair(clone, layers), posed.camera, background=(0, 0, 0))[..., 0] > 127
        labels = values["proposals"].views[view].labels == Label.HAIR
        pixel_mm = mm_from_m(posed.camera.metres_per_pixel(skull))
        bald = -float(hair.sum() / case.mask[view].sum())
        yield {
            "view": view.value,
            "hair": overlap(hair, true) if true.any() else bald,
            "labels": overlap(labels, true) if true.any() else np.nan,
            "crown_mm": crown_mm(coverage(layers, posed.camera) > 0.5, case.mask[view], pixel_mm),
        }
        rows.append(shown(case, view, hair, m_from_mm(pixel_mm)))
    if pictures is not None and rows:
        pictures.mkdir(parents=True, exist_ok=True)
        cv2.imwrite(str(pictures / f"{case.name}.png"), np.hstack(rows)[..., ::-1])


def shown(case: HairCase, view: ViewId, hair: Bools, pixel_m: float, height_px: int = 480) -> NDArray[np.uint8]:
    """Return the head with hair only the truth has in red, and only the clone has in blue."""
    picture, true, mask = (case.photos.photos[view].rgb * 0.5 + 64).astype(np.uint8), case.hair[view], case.mask[view]
    picture[true & ~hair], picture[hair & ~true] = (255, 0, 0), (0, 0, 255)
    top = int(np.flatnonzero(mask.any(axis=1))[0])
    middle = int(np.median(np.flatnonzero(mask[min(top + round(0.06 / pixel_m), len(mask) - 1)])))
    air, half = round(0.02 / pixel_m), round(0.2 / pixel_m)
    part = picture[max(top - air, 0) : top + 2 * half, max(middle - half, 0) : middle + half]
    width = max(1, round(part.shape[1] * height_px / part.shape[0]))
    return np.asarray(cv2.resize(part, (width, height_px), interpolation=cv2.INTER_AREA), np.uint8)


def told(rows: list[dict[str, Any]]) -> str:
    """Return one line of figures by photo."""
    return " | ".join(f"{r['view']} {r['hair']:.3f} ({r['labels']:.3f}) {r['crown_mm']:+.1f} mm" for r in rows)


def all_cases(chosen: argparse.Namespace) -> Iterator[HairCase]:
    """Yield the people asked for."""
    for seed in range(chosen.first, chosen.first + chosen.people):
        yield random_case(seed)
    if chosen.visitors is not None:
        for name in visitor_names():
            who, what = name.split("/")
            yield visitor_case(chosen.visitors / who, what)


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--people", type=int, default=6)
    parser.add_argument("--first", type=int, default=0, metavar="SEED")
    parser.add_argument("--visitors", type=Path, default=None, metavar="FOLDER")
    parser.add_argument("--pictures", type=Path, default=None, metavar="FOLDER")
    chosen = parser.parse_args()
    table: dict[tuple[str, str], list[dict[str, Any]]] = {}
    for case in all_cases(chosen):
        try:
            values = before_hair(case)
        except ClonerError as error:
            sys.stdout.write(f"{case.name}: refused, {error.message} ({error.where})\n")
            continue
        starts = {"fitted skin": values}
        if case.skin_m is not None:
            true = replace(values["obeyed"], vertices_m=case.skin_m, joints_m=case.joints_m, views=case.views)
            starts["true skin"] = {**values, "obeyed": true}
        for name, start in starts.items():
            clone, seconds = with_hair(start)
            rows = list(score(case, clone, values, chosen.pictures if name == "fitted skin" else None))
            sys.stdout.write(f"{case.name} {name} {seconds:.1f} CPU s: {told(rows)}\n")
            sys.stdout.flush()
            for row in rows:
                table.setdefault((name, row["view"]), []).append(row)
    for (name, view), rows in table.items():
        hairy = [row for row in rows if row["hair"] > 0.0]
        if hairy:
            hair, labels = (float(np.median([row[key] for row in hairy])) for key in ("hair", "labels"))
            crown = float(np.median(np.abs([row["crown_mm"] for row in rows])))
            sys.stdout.write(
                f"{name:12} {view:10} {len(hairy)} people: median overlap {hair:.3f}, worst "
                f"{min(row['hair'] for row in hairy):.3f}, labels {labels:.3f}, crown off by {crown:.1f} mm\n"
            )


if __name__ == "__main__":
    main()
