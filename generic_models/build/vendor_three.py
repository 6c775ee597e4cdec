"""Rebuild the parts of three.js that the report's viewer and the crowd's player need, as one plain script each.

Fetch the two npm packages with the ordinary client and give their folder::

    npm install --prefix FOLDER three@0.187.0 esbuild@0.28.2
    python generic_models/build/vendor_three.py FOLDER

A page opened from the disk may not load modules, so the viewer inlines a script that sets ``window.THREE``.
Package, version, sha256 and licence go into ``PROVENANCE.json`` beside each.
"""

from __future__ import annotations

import argparse
import hashlib
import json
import subprocess
import tempfile
from pathlib import Path

CLONER = Path(__file__).resolve().parents[2] / "cloner"
VIEWER = """
export {
  AmbientLight, AnimationMixer, Box3, Color, DirectionalLight, HemisphereLight, PerspectiveCamera, Scene, Timer,
  Vector3, WebGLRenderer,
} from "three";
export { OrbitControls } from "three/examples/jsm/controls/OrbitControls.js";
export { GLTFLoader } from "three/examples/jsm/loaders/GLTFLoader.js";
"""
CROWD = """
export {
  BufferAttribute, BufferGeometry, ClampToEdgeWrapping, Color, CustomBlending, DataArrayTexture, DataTexture,
  DepthTexture, DoubleSide, FloatType, FrontSide, GLSL3, HalfFloatType, InstancedBufferAttribute,
  InstancedBufferGeometry, LinearFilter,
  LinearMipmapLinearFilter, Matrix4, Mesh, NearestFilter, NoBlending, OneFactor, PerspectiveCamera, RawShaderMaterial,
  RedIntegerFormat, RepeatWrapping, RGBAFormat, RGBAIntegerFormat, Scene, ShortType, UnsignedByteType,
  UnsignedShortType, Vector2, Vector3, WebGLRenderTarget, WebGLRenderer, ZeroFactor, AddEquation,
} from "three";
export { OrbitControls } from "three/examples/jsm/controls/OrbitControls.js";
"""
#: Folder and name of each script, and what it exports.
SCRIPTS = ((CLONER / "report" / "web", "three.min.js", VIEWER), (CLONER / "crowd" / "web", "three.crowd.min.js", CROWD))


def bundled(packages: Path, exports: str) -> bytes:
    """Return the named parts of three.js as one minified script."""
    with tempfile.TemporaryDirectory(dir=packages) as folder:
        entry, script = Path(folder) / "entry.js", Path(folder) / "three.min.js"
        entry.write_text(exports, encoding="utf-8")
        esbuild = packages / "node_modules" / ".bin" / "esbuild"
        options = ["--bundle", "--minify", "--format=iife", "--global-name=THREE", "--target=es2020", "--charset=ascii"]
        subprocess.run([esbuild, entry, *options, f"--outfile={script}"], check=True)
        return script.read_bytes()


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("packages", type=Path, help="folder that holds node_modules")
    packages = parser.parse_args().packages.resolve()
    three = packages / "node_modules" / "three"
    for folder, name, exports in SCRIPTS:
        script = bundled(packages, exports)
        folder.mkdir(exist_ok=True)
        (folder / name).write_bytes(script)
        (folder / "LICENSE-three.txt").write_bytes((three / "LICENSE").read_bytes())
        row = {
            "file": name,
            "package": "three",
            "version": json.loads((three / "package.json").read_text())["version"],
            "sha256": hashlib.sha256(script).hexdigest(),
            "licence": "MIT",
            "made_with": "esbuild " + json.loads((three.parent / "esbuild" / "package.json").read_text())["version"],
        }
        (folder / "PROVENANCE.json").write_text(json.dumps([row], indent=1) + "\n", encoding="utf-8")
        print(f"{name}: {len(script)} bytes")


if __name__ == "__main__":
    main()
