"""Make ``cloner/crowd/data/levels.npz``: the crowd's levels of detail as lists of the generic human's own vertices.

Fetch the npm package with the ordinary client and give its folder::

    npm install --prefix FOLDER meshoptimizer@1.3.0
    python generic_models/build/build_crowd_levels.py FOLDER

meshoptimizer keeps original vertices, so a list made once holds for every clone: weights, texture coordinates and
morph targets stay bit for bit. Each level is made from the finer one, so its vertices are among the finer one's.
The places of all vertices in bent poses are attributes of the error: where skin bends, triangles stay denser.
"""

from __future__ import annotations

import argparse
import hashlib
import json
import subprocess
import tempfile
from pathlib import Path

import numpy as np

from cloner.generic.load import GenericHuman, load_generic
from cloner.generic.surfaces import load_surfaces, surface_normals
from cloner.geometry.articulation.skinning import joint_transforms, linear_blend_skinning

DATA = Path(__file__).resolve().parents[2] / "cloner" / "crowd" / "data"
SURFACES = ("body", "eyes")  # lips and lids cover the rest at the sizes of a crowd
#: Triangles of each level, body and eyes: those wanted less the hair (4000, 2700, 1000, 500). Eyes of a person
#: of 256 px have three pixels.
TARGETS = {"body": (12_000, 6_700, 2_872, 1_440), "eyes": (1_536, 128, 128, 60)}
#: Bends of the poses whose places count, degrees about model axes.
BENDS = (
    {"l_hip": (-28, 0, 0), "r_hip": (14, 0, 0), "l_knee": (12, 0, 0), "r_knee": (60, 0, 0),
     "l_elbow": (-40, 0, 0), "r_elbow": (-14, 0, 0), "l_shoulder": (25, 0, -50), "r_shoulder": (-25, 0, 50)},
    {"r_hip": (-28, 0, 0), "l_hip": (14, 0, 0), "r_knee": (12, 0, 0), "l_knee": (60, 0, 0),
     "r_elbow": (-40, 0, 0), "l_elbow": (-14, 0, 0), "r_shoulder": (25, 0, 50), "l_shoulder": (-25, 0, -50)},
)  # fmt: skip
# A pose counts in metres, a normal in 2 cm. Tried: normals from 5 mm to 10 cm, poses from a quarter, the
# texture's places too (knees then lose their triangles): SSIM moves by .0005.
POSE_WEIGHT, NORMAL_WEIGHT = 1.0, 0.02
NODE = """
import { MeshoptSimplifier as S } from "meshoptimizer";
import { readFileSync, writeFileSync } from "node:fs";
const job = JSON.parse(readFileSync(process.argv[2]));
await S.ready;
let indices = new Uint32Array(job.indices);
const places = new Float32Array(job.places), attributes = new Float32Array(job.attributes);
const levels = job.targets.map((target) => {
  if (indices.length > 3 * target)
    [indices] = S.simplifyWithAttributes(
      indices, places, 3, attributes, job.weights.length, job.weights, null, 3 * target, 1e9, ["ErrorAbsolute"]);
  return Array.from(indices);
});
writeFileSync(process.argv[3], JSON.stringify(levels));
"""


def bent(generic: GenericHuman) -> list[np.ndarray]:
    """Return the (V, 3) vertices in each of the bent poses, metres."""
    found = []
    for bends in BENDS:
        rotations = np.zeros((len(generic.joint_names), 3))
        for name, degrees in bends.items():
            rotations[generic.joint(name)] = np.radians(degrees)
        transforms = joint_transforms(
            generic.joints_m.astype(np.float64), generic.joint_parents.astype(np.int32), rotations
        )
        weights = generic.skin_weights.astype(np.float64)
        found.append(
            linear_blend_skinning(generic.vertices_m.astype(np.float64), transforms, generic.skin_joints, weights)
        )
    return found


def chain(packages: Path, surface: object, poses: list[np.ndarray], targets: tuple[int, ...]) -> list[np.ndarray]:
    """Return the (T, 3) wedge triangles of each level of one surface."""
    places = load_generic().vertices_m.astype(np.float64)
    normals = surface_normals(places)
    vertex = surface.vertex
    attributes = np.hstack([normals[vertex], *(pose[vertex] for pose in poses)])
    job = {
        "indices": surface.triangles.ravel().tolist(),
        "places": places[vertex].ravel().tolist(),
        "attributes": attributes.ravel().tolist(),
        "weights": [NORMAL_WEIGHT] * 3 + [POSE_WEIGHT] * 3 * len(poses),
        "targets": targets,
    }
    with tempfile.TemporaryDirectory(dir=packages) as folder:
        script, asked, told = (Path(folder) / name for name in ("run.mjs", "asked.json", "told.json"))
        script.write_text(NODE, encoding="utf-8")
        asked.write_text(json.dumps(job), encoding="utf-8")
        subprocess.run(["node", script, asked, told], check=True)
        return [np.array(level, np.int32).reshape(-1, 3) for level in json.loads(told.read_text())]


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("packages", type=Path, help="folder that holds node_modules")
    packages = parser.parse_args().packages.resolve()
    poses = bent(load_generic())
    arrays = {}
    for surface in load_surfaces():
        if surface.name in SURFACES:
            for level, triangles in enumerate(chain(packages, surface, poses, TARGETS[surface.name])):
                arrays[f"{surface.name}_{level}"] = triangles
                print(surface.name, level, len(triangles), "triangles,", len(np.unique(triangles)), "vertices")
    DATA.mkdir(exist_ok=True)
    np.savez_compressed(DATA / "levels.npz", **arrays)
    version = json.loads((packages / "node_modules" / "meshoptimizer" / "package.json").read_text())["version"]
    row = {
        "file": "levels.npz",
        "made_with": f"meshoptimizer {version} (npm, MIT), generic_models/build/build_crowd_levels.py",
        "source": "cloner_models/body.npz (CC0; see its PROVENANCE.json)",
        "sha256": hashlib.sha256((DATA / "levels.npz").read_bytes()).hexdigest(),
        "licence": "CC0, as its source",
    }
    (DATA / "PROVENANCE.json").write_text(json.dumps([row], indent=1) + "\n", encoding="utf-8")


if __name__ == "__main__":
    main()
