"""Install a wheel into a clean environment and clone somebody with it, outside the repository: ``make wheel``.

    python release/check_wheel.py dist/photo_cloner-0.2.0-py3-none-any.whl

Fails with a line that says what is missing.
"""

from __future__ import annotations

import json
import os
import shutil
import subprocess
import sys
import tempfile
from collections.abc import Sequence
from pathlib import Path

ROOT = Path(__file__).resolve().parents[1]
WANTED = ("clone.glb", "clone.wrl", "clone.npz", "viewer.html", "report.html", "report.json", "previews/face.jpg")


def run(command: Sequence[str | Path], folder: Path) -> str:
    """Run a command outside the repository and return what it says."""
    environment = {name: value for name, value in os.environ.items() if not name.startswith("PYTHON")}
    done = subprocess.run(command, cwd=folder, env=environment, capture_output=True, text=True, check=False)
    if done.returncode:
        sys.exit(f"{' '.join(map(str, command[:4]))}: {done.stdout[-2000:]}{done.stderr[-2000:]}")
    return done.stdout


def main() -> None:
    wheel = Path(sys.argv[1]).resolve()
    with tempfile.TemporaryDirectory(prefix="cloner-wheel-") as name:
        folder = Path(name)
        run([sys.executable, "-m", "venv", folder / "venv"], folder)
        python, cloner = folder / "venv" / "bin" / "python", folder / "venv" / "bin" / "cloner"
        lines = (ROOT / "constraints.txt").read_text(encoding="utf-8").splitlines()
        pins = [line.removesuffix("\\").strip() for line in lines if "==" in line and not line.startswith((" ", "#"))]
        (folder / "pins.txt").write_text("\n".join(pins) + "\n", encoding="utf-8")  # our own wheel has no hash there
        run([python, "-m", "pip", "install", "--quiet", "--constraint", folder / "pins.txt", wheel], folder)
        bill = "import importlib.metadata as told; files = told.files('photo-cloner')\n"
        bill += "print(next(file for file in files if 'sboms/' in str(file)).read_text())"
        if json.loads(run([python, "-c", bill], folder))["bomFormat"] != "CycloneDX":
            sys.exit("the wheel lacks its bill of materials")
        print(run([cloner, "--version"], folder).strip())
        where = run([python, "-c", "import cloner, cloner_gui, cloner_models; print(cloner.__file__)"], folder)
        if str(folder) not in where:
            sys.exit(f"not the wheel's own code was found: {where}")
        run([cloner, "doctor", "--brief"], folder)
        photos = shutil.copytree(ROOT / "samples" / "anna" / "plain", folder / "anna")
        run([cloner, "clone", photos, "--out", folder / "out", "--size", "512"], folder)
        missing = [file for file in WANTED if not (folder / "out" / "anna" / file).is_file()]
        if missing:
            sys.exit(f"the clone lacks {', '.join(missing)}")
    print(f"{wheel.name} installs into a clean environment and clones")


if __name__ == "__main__":
    main()
