"""Hair, headwear and beards of people of the generator from a side that no clone has seen.

``python benchmarks/hair_kit.py PEOPLE --held-out DIR [--saved DIR] [--pictures DIR]`` clones everybody in PEOPLE as far
as the hair, lays the clone's head on the true one in the pose of the 45 degree portrait in DIR (``make_people.py``, the
same seeds, ``--views three_quarter``) and compares what it shows there with that portrait's true labels: overlap of
hair with headwear, of the beard, and of the head's whole silhouette with all that grows and sits on it. ``--saved``
reads pickles of the pipeline's values before the hair instead of cloning.
"""

from __future__ import annotations

import argparse
import pickle
import sys
import time
import zlib
from collections.abc import Iterator, Mapping
from dataclasses import replace
from pathlib import Path
from typing import Any, Final

import cv2
import numpy as np
from hair import before_hair, overlap, with_hair
from hair_people import HairCase
from numpy.typing import NDArray

from cloner.errors import ClonerError
from cloner.evaluate.measures.posing import moved_camera
from cloner.evaluate.measures.rulers import fit_similarity
from cloner.evaluate.truths.kit import KitTruth, kit_people, read_kit
from cloner.generic.layers import Layer, clone_layers
from cloner.generic.load import load_generic
from cloner.generic.surfaces import load_surfaces
from cloner.hair.volumes.headwear import headwear
from cloner.project.folder import load_photos, read_person
from cloner.records.clones import Clone
from cloner.records.labels import FACE, Label, shows
from cloner.render import draw

Bools = NDArray[np.bool_]

VIEW: Final = "face_three_quarter"
#: What a surface is drawn in: hair and headwear red, beards green, the rest of the head blue, all else black.
HAIR, BEARD, FACE_RGB = (255, 0, 0), (0, 255, 0), (0, 0, 255)


def saved_values(path: Path, person: Path) -> dict[str, Any]:
    """Return the values of a pickle, with the photos of the person."""
    values: dict[str, Any] = pickle.loads(zlib.decompress(path.read_bytes()))
    return {"photos": load_photos(person), **values}


def coloured(clone: Clone) -> list[Layer]:
    """Return a clone's meshes in the colours of what they are."""
    generic, surfaces = load_generic(), load_surfaces()
    own = generic.region("face") | generic.region("scalp") | generic.region("ear_left") | generic.region("ear_right")
    layers = clone_layers(clone)
    found = []
    for layer, surface in zip(layers, surfaces, strict=False):
        head = own[surface.vertex] if surface.name == "body" else np.ones(len(surface.vertex), bool)
        two = np.array([[(0, 0, 0), FACE_RGB]], np.uint8)
        uv = np.column_stack([np.where(head, 0.75, 0.25), np.full(len(head), 0.5)])
        found.append(replace(layer, texture=two, uv=uv))
    kinds: Mapping[str, tuple[int, int, int]] = {"hair": HAIR, "beard": BEARD}
    for layer, shell in zip(layers[len(surfaces) :], clone.shells, strict=True):
        if shell.kind == "glasses":
            continue
        flat = np.empty_like(shell.rgba)
        flat[..., :3], flat[..., 3] = kinds.get(shell.kind, (0, 0, 0)), shell.rgba[..., 3]
        found.append(replace(layer, texture=flat))
    return found


def shown(clone: Clone, kit: KitTruth) -> NDArray[np.uint8]:
    """Return the (H, W, 3) picture of what the clone shows in the held-out portrait, its face laid on the true one."""
    generic = load_generic()
    face = np.flatnonzero(generic.region("face")[: len(kit.bodies_m[VIEW])])
    lay = fit_similarity(clone.vertices_m[face], kit.bodies_m[VIEW][face], scale=False)
    return draw(coloured(clone), moved_camera(kit.truth.views[VIEW].camera, lay), background=(0, 0, 0))


def figures(picture: NDArray[np.uint8], labels: NDArray[np.uint8]) -> dict[str, float]:
    """Return the overlaps of hair, beard and head; NaN where neither shows any."""
    hair = shows(labels, Label.HAIR) | headwear(labels)
    beard = shows(labels, Label.BEARD)
    pairs = {
        "hair": (picture[..., 0] > 127, hair),
        "beard": (picture[..., 1] > 127, beard),
        "head": (picture.max(axis=2) > 127, hair | shows(labels, *FACE)),
    }
    return {name: overlap(*pair) if (pair[0] | pair[1]).any() else np.nan for name, pair in pairs.items()}


def sheet(picture: NDArray[np.uint8], kit: KitTruth) -> NDArray[np.uint8]:
    """Return the portrait beside its true labels and the clone's, in the same colours."""
    labels = kit.labels[VIEW]
    true = np.zeros((*labels.shape, 3), np.uint8)
    true[shows(labels, *FACE)], true[shows(labels, Label.BEARD)] = FACE_RGB, BEARD
    true[shows(labels, Label.HAIR) | headwear(labels)] = HAIR
    whole = np.hstack([kit.truth.views[VIEW].photo, true, picture])
    return np.asarray(cv2.resize(whole, None, fx=0.5, fy=0.5), np.uint8)


def all_values(people: Path, saved: Path | None, held_out: Path) -> Iterator[tuple[str, dict[str, Any]]]:
    """Yield name and values before the hair of everybody whose held-out portrait is there."""
    for person in kit_people([people]):
        kept = None if saved is None else saved / f"{person.name}.pkl.z"
        if not (held_out / person.name / "truth_body.npz").is_file() or (kept is not None and not kept.is_file()):
            continue
        if kept is not None:
            yield person.name, saved_values(kept, person)
            continue
        try:
            yield person.name, before_hair(HairCase(person.name, load_photos(person), read_person(person), {}, {}))
        except ClonerError as error:
            sys.stdout.write(f"{person.name}: refused, {error.message}\n")


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("people", type=Path)
    parser.add_argument("--held-out", type=Path, required=True, metavar="DIR")
    parser.add_argument("--saved", type=Path, metavar="DIR")
    parser.add_argument("--pictures", type=Path, metavar="DIR")
    parser.add_argument("--only", nargs="*", default=[], metavar="NAME")
    parser.add_argument("--seconds", type=float, default=np.inf, help="begin no person after so many CPU seconds")
    chosen = parser.parse_args()
    rows: list[dict[str, float]] = []
    for name, values in all_values(chosen.people, chosen.saved, chosen.held_out):
        if (chosen.only and name not in chosen.only) or time.process_time() > chosen.seconds:
            continue
        clone, seconds = with_hair(values)
        kit = read_kit(chosen.held_out / name)
        picture = shown(clone, kit)
        rows.append({**figures(picture, kit.labels[VIEW]), "seconds": seconds})
        sys.stdout.write(f"{name} " + " ".join(f"{key} {value:.3f}" for key, value in rows[-1].items()) + "\n")
        sys.stdout.flush()
        if chosen.pictures is not None:
            chosen.pictures.mkdir(parents=True, exist_ok=True)
            cv2.imwrite(str(chosen.pictures / f"{name}.png"), sheet(picture, kit)[..., ::-1])
    for key in rows[0] if rows else ():
        every = np.array([row[key] for row in rows])
        every = every[np.isfinite(every)]
        if every.size:
            sys.stdout.write(f"{key}: {every.size} people, mean {every.mean():.4f}, worst {every.min():.3f}\n")


if __name__ == "__main__":
    main()
