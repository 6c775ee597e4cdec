"""Rebuild ``cloner/report/web/three.min.js``: the part of three.js that the report's viewer needs, as one plain script.

Fetch the two npm packages with the ordinary client and give their folder::

    npm install --prefix FOLDER three@0.187.0 esbuild@0.28.2
    python generic_models/build/vendor_three.py FOLDER

A page opened from the disk may not load modules, so the viewer inlines a script that sets ``window.THREE``.
Package, version, sha256 and licence go into ``PROVENANCE.json`` beside it.
"""

from __future__ import annotations

import argparse
import hashlib
import json
import subprocess
import tempfile
from pathlib import Path

WEB = Path(__file__).resolve().parents[2] / "cloner" / "report" / "web"
ENTRY = """
export {
  AmbientLight, AnimationMixer, Box3, Color, DirectionalLight, HemisphereLight, PerspectiveCamera, Scene, Timer,
  Vector3, WebGLRenderer,
} from "three";
export { OrbitControls } from "three/examples/jsm/controls/OrbitControls.js";
export { GLTFLoader } from "three/examples/jsm/loaders/GLTFLoader.js";
"""


def bundled(packages: Path) -> bytes:
    """Return the named parts of three.js as one minified script."""
    with tempfile.TemporaryDirectory(dir=packages) as folder:
        entry, script = Path(folder) / "entry.js", Path(folder) / "three.min.js"
        entry.write_text(ENTRY, encoding="utf-8")
        esbuild = packages / "node_modules" / ".bin" / "esbuild"
        options = ["--bundle", "--minify", "--format=iife", "--global-name=THREE", "--target=es2020", "--charset=ascii"]
        subprocess.run([esbuild, entry, *options, f"--outfile={script}"], check=True)
        return script.read_bytes()


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("packages", type=Path, help="folder that holds node_modules")
    packages = parser.parse_args().packages.resolve()
    script = bundled(packages)
    three = packages / "node_modules" / "three"
    WEB.mkdir(exist_ok=True)
    (WEB / "three.min.js").write_bytes(script)
    (WEB / "LICENSE-three.txt").write_bytes((three / "LICENSE").read_bytes())
    row = {
        "file": "three.min.js",
        "package": "three",
        "version": json.loads((three / "package.json").read_text())["version"],
        "sha256": hashlib.sha256(script).hexdigest(),
        "licence": "MIT",
        "made_with": "esbuild " + json.loads((three.parent / "esbuild" / "package.json").read_text())["version"],
    }
    (WEB / "PROVENANCE.json").write_text(json.dumps([row], indent=1) + "\n", encoding="utf-8")
    print(f"{len(script)} bytes")


if __name__ == "__main__":
    main()
