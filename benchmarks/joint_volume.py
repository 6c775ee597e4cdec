"""How much flesh joints keep when they bend, without and with corrective targets.

    python benchmarks/joint_volume.py RESULT... --page docs/joint_volume.md --pictures docs/pictures
        [--capture FILE.bvh...]

RESULT is a result's folder or its clone.npz. Writes a page with one table a clone, joint by angle: what the skin around
the joint holds, over what it holds at rest (holes closed by fans), by linear skinning alone and with the targets as the
files drive them; the same over all frames of the walk and of captures; and a sheet of pictures.
"""

from __future__ import annotations

import argparse
import sys
from dataclasses import replace
from pathlib import Path
from typing import Final

import cv2
import numpy as np
from numpy.typing import NDArray

from cloner.generic.layers import clone_layers
from cloner.generic.load import load_generic
from cloner.generic.morphs import target_offsets
from cloner.geometry.articulation.skinning import joint_transforms, linear_blend_skinning
from cloner.geometry.cameras.viewpoints import framing_cameras
from cloner.motion.captures.bvh import read_bvh
from cloner.motion.captures.retarget import retarget
from cloner.motion.flesh.bending import BENDS, FLESHED, JointBend, bent_rotations, flesh
from cloner.motion.flesh.correctives import drive_correctives, with_correctives
from cloner.motion.flesh.rest import in_t_pose
from cloner.motion.limbs.body import SIDES, body_of
from cloner.motion.limbs.rig import centre_joints
from cloner.motion.moves.own import own_motions
from cloner.picture import load_clone_at
from cloner.records.clones import Clone
from cloner.records.motions import Motion
from cloner.render import draw

Array = NDArray[np.float64]

PANEL: Final = (220, 260)  # pixels
#: Joint, way, degrees, azimuth of the sheet's columns.
SHEET: Final = (
    ("shoulder", "raised", 0, 0.0), ("shoulder", "raised", 90, 0.0), ("shoulder", "raised", 150, 0.0),
    ("shoulder", "forward", 90, 60.0), ("elbow", "bent", 130, 90.0), ("hip", "forward", 90, 90.0),
    ("knee", "bent", 120, 90.0),
)  # fmt: skip
EVERY: Final = 4  # frames of a motion


class Bending:
    """A clone in some rest pose with and without its corrective targets."""

    def __init__(self, clone: Clone) -> None:
        self.clone, self.body = clone, body_of(clone)
        shaped, self.drivers = with_correctives(clone)
        self.targets = {n: o[:-1].copy() for n, o in target_offsets(shaped) if n.startswith("corrective")}
        self.bytes = 14 * (len(shaped.morph_index) - len(clone.morph_index))

    def rest(self, motion: Motion, frame: int) -> Array:
        """Return the vertices at rest with the targets of a frame, metres."""
        points = self.clone.vertices_m.copy()
        for name, own in self.targets.items():
            if motion.weights[name][frame] > 0.0:
                points += motion.weights[name][frame] * own
        return points

    def held(self, rotations: Array, places: tuple[tuple[str, str], ...]) -> Array:
        """Return (2, P, F) what the flesh of (side, joint) places holds over rest, without and with targets."""
        generic, none = load_generic(), np.zeros((len(rotations), 3))
        motion = drive_correctives(Motion("bend", np.arange(float(len(rotations))), none, rotations), self.drivers)
        joints, weights = generic.skin_joints.astype(np.int64), generic.skin_weights.astype(np.float64)
        found = np.zeros((2, len(places), len(rotations)))
        for frame, pose in enumerate(rotations):
            transforms = joint_transforms(self.clone.joints_m, self.body.parents, pose)
            for row, points in enumerate((self.clone.vertices_m, self.rest(motion, frame))):
                for place, (side, joint) in enumerate(places):
                    around = flesh(side, joint)
                    rows = around.rows
                    posed = linear_blend_skinning(points[rows], transforms, joints[rows], weights[rows])
                    found[row, place, frame] = around.volume(posed) / around.volume(self.clone.vertices_m[rows])
        return found


def angles_of(bend: JointBend) -> Array:
    """Return the angles of a bend's range, 15 degrees apart or a little less."""
    low, high = bend.degrees[0], bend.degrees[-1]
    return np.linspace(low, high, int(np.ceil((high - low) / 15.0)) + 1)


def table(bending: Bending) -> list[str]:
    """Return the rows of a clone's table, the worse side of each."""
    lines = ["| joint | angles | linear alone, % | with targets, % | worst, % |", "| --- | --- | --- | --- | --- |"]
    for bend in BENDS:
        angles = angles_of(bend)
        held = np.stack([bending.held(bent_rotations(bending.body, side, bend, angles), ((side, bend.joint),))[:, 0]
                         for side in SIDES])  # fmt: skip
        worse = np.abs(held - 1.0).argmax(axis=0)
        told = 100.0 * np.take_along_axis(held, worse[None], axis=0)[0]
        texts = [" ".join(f"{value:.0f}" for value in row) for row in (angles, *told)]
        worst = np.abs(held[:, 1] - 1.0).max() * 100.0
        lines.append(f"| {bend.joint} {bend.way} | {texts[0]} | {texts[1]} | {texts[2]} | {worst:.1f} |")
    return lines


def motion_rows(bending: Bending, motion: Motion) -> str:
    """Return one row: least to most of all eight joints over a motion's frames."""
    places = tuple((side, joint) for joint in FLESHED for side in SIDES)
    held = 100.0 * bending.held(motion.rotations[::EVERY], places)
    texts = []
    for k in range(0, len(places), 2):
        before, after = held[0, k : k + 2], held[1, k : k + 2]
        texts.append(f"{before.min():.0f}-{before.max():.0f} → {after.min():.0f}-{after.max():.0f}")
    return f"| {motion.name} | {' | '.join(texts)} |"


def sheet(bending: Bending) -> NDArray[np.uint8]:
    """Return pictures: a column a bend, above linear skinning alone, below with targets."""
    rows: list[list[NDArray[np.uint8]]] = [[], []]
    clone, body = replace(bending.clone, shells=()), bending.body
    for joint, way, degrees, azimuth in SHEET:
        (pose,) = poses = bent_rotations(body, "l", JointBend(joint, way, ()), (degrees,))
        motion = drive_correctives(Motion("bend", np.zeros(1), np.zeros((1, 3)), poses), bending.drivers)
        own = body.joint(f"l_{joint}")
        middle = (joint_transforms(clone.joints_m, body.parents, pose)[own] @ [*clone.joints_m[own], 1.0])[:3]
        points = np.vstack([middle + 0.22 * np.array(way) for way in ((1, 1, 1), (-1, -1, -1))])
        (camera,) = framing_cameras(points, [azimuth], *PANEL)
        for row, vertices in zip(rows, (clone.vertices_m, bending.rest(motion, 0)), strict=True):
            layers = clone_layers(replace(clone, vertices_m=vertices), pose)
            row.append(draw(layers, camera, shading="soft", background=(240, 240, 240)))
    return np.vstack([np.hstack(row) for row in rows])


def main() -> None:
    """Write page and pictures."""
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("results", nargs="+", type=Path)
    parser.add_argument("--page", type=Path, default=Path("docs/joint_volume.md"))
    parser.add_argument("--pictures", type=Path, default=Path("docs/pictures"))
    parser.add_argument("--capture", nargs="*", type=Path, default=[])
    asked = parser.parse_args()
    text = [HEAD]
    for result in asked.results:
        name, clone = (result if result.is_dir() else result.parent).name, centre_joints(load_clone_at(result))
        for pose, own in (("A", clone), ("T", in_t_pose(clone))):
            bending = Bending(own)
            targets = f"{len(bending.targets)} targets, {bending.bytes / 1e3:.0f} kB"
            text += [f"## {name}, {pose}-pose ({targets})", "", *table(bending), ""]
            if pose == "A":
                title = f"joints_{name}.jpg"
                cv2.imwrite(str(asked.pictures / title), sheet(bending)[..., ::-1], [cv2.IMWRITE_JPEG_QUALITY, 85])
                captures = (retarget(read_bvh(path), bending.body, name=path.stem) for path in asked.capture)
                text += [f"![{name}](pictures/{title})", "", "| motion | " + " | ".join(FLESHED) + " |",
                         "| --- |" + " --- |" * len(FLESHED),
                         *(motion_rows(bending, motion) for motion in (*own_motions(own), *captures)), ""]  # fmt: skip
    asked.page.write_text("\n".join(text))
    sys.stdout.write(f"{asked.page}\n")


HEAD: Final = """# What joints keep when they bend

`python benchmarks/joint_volume.py RESULT...` prints this page. What the skin around a joint holds, per cent of what it
holds at rest: linear skinning alone, and with the corrective targets of `clone.glb`
(`cloner/motion/flesh/correctives.py`) as their drivers weigh them, both sides, the worse one told. Bar: within 3 %.
Motions: least and most over all frames, both sides, before → after. Pictures: above linear skinning alone, below with
targets.
"""


if __name__ == "__main__":
    main()
