"""Missing requirements of this machine, and the command that installs each."""

from __future__ import annotations

import hashlib
import importlib
import importlib.metadata
import importlib.resources
import json
import os
import subprocess
import sys
import tempfile
from dataclasses import dataclass
from pathlib import Path
from typing import Final

#: Import name -> distribution, in the order of pyproject.toml.
LIBRARIES: Final = {
    "ai_edge_litert": "ai-edge-litert",
    "fast_simplification": "fast-simplification",
    "numpy": "numpy",
    "cv2": "opencv-contrib-python-headless",
    "PIL": "pillow",
    "pygltflib": "pygltflib",
    "scipy": "scipy",
    "skimage": "scikit-image",
    "segno": "segno",
    "trimesh": "trimesh",
    "typer": "typer",
    "PySide6.QtWidgets": "PySide6-Essentials",
}
APT: Final = "sudo apt-get install -y"
#: Drawn through EGL, not by the fallback; run apart, because a broken GL driver may end the process.
_RENDER_TEST: Final = """
import sys
from cloner.errors import ClonerError
from cloner.render import require_gl
try:
    require_gl()
except ClonerError as error:
    sys.exit(error.message)
"""
_QT_TEST: Final = "from PySide6.QtGui import QGuiApplication; QGuiApplication([])"
PATIENCE_S: Final = 60.0


@dataclass(frozen=True, slots=True)
class Finding:
    """One thing looked at.

    Attributes
    ----------
    what : str
    fine : bool
    detail : str
        Version or trouble, one line.
    fix : str
        The one line that mends it; "" when fine.
    needed : bool
        False for what only the window or HEIC photos want.
    """

    what: str
    fine: bool
    detail: str
    fix: str = ""
    needed: bool = True

    def line(self) -> str:
        """Return the finding as one line for people."""
        if self.fine:
            return f"ok       {self.what}: {self.detail}"
        mark = "MISSING " if self.needed else "optional"
        return f"{mark} {self.what}: {self.detail}\n         fix: {self.fix}"


def examine() -> tuple[Finding, ...]:
    """Look at everything Cloner needs; changes nothing."""
    return (_python(), *examine_libraries(), _heic(), _models(), _rendering(), _qt(), _writing())


def examine_libraries() -> tuple[Finding, ...]:
    """Import every library once."""
    return tuple(_library(name) for name in LIBRARIES)


def _python() -> Finding:
    version = ".".join(str(part) for part in sys.version_info[:3])
    fine = (3, 11) <= sys.version_info[:2] < (3, 14)
    return Finding("python", fine, version, "" if fine else "make clean demo PYTHON=python3.11")


def _library(name: str) -> Finding:
    distribution = LIBRARIES[name]
    needed = not name.startswith("PySide6")
    try:
        importlib.import_module(name)
        return Finding(distribution, True, importlib.metadata.version(distribution), needed=needed)
    except (ImportError, OSError) as error:
        return Finding(distribution, False, _one_line(str(error)), _library_fix(str(error), distribution), needed)


def _python_command() -> str:
    """Return the command that starts this Python from the current folder."""
    program = Path(sys.executable)
    return str(program.relative_to(Path.cwd())) if program.is_relative_to(Path.cwd()) else program.name


def _library_fix(trouble: str, distribution: str) -> str:
    """Return the fix for a failed import: a system library by its Debian package, else pip."""
    for start, package in _SYSTEM_LIBRARIES.items():
        if start in trouble:
            return f"{APT} {package}"
    return f'{_python_command()} -m pip install "{distribution}"'


_SYSTEM_LIBRARIES: Final = {
    "libEGL": "libegl1",
    "libGLESv2": "libgles2",
    "libGL.": "libgl1",
    "libxkbcommon": "libxkbcommon0",
    "libdbus": "libdbus-1-3",
    "libfontconfig": "libfontconfig1",
    "libglib": "libglib2.0-0",
}


def _heic() -> Finding:
    try:
        return Finding("HEIC photos", True, importlib.metadata.version("pillow-heif"), needed=False)
    except importlib.metadata.PackageNotFoundError:
        fix = f"{_python_command()} -m pip install pillow-heif"
        return Finding("HEIC photos", False, "pillow-heif is not installed", fix, needed=False)


def _models() -> Finding:
    """Compare the shipped nets with the digests of their provenance."""
    reinstall = f"{_python_command()} -m pip install --force-reinstall photo-cloner"
    try:
        root = importlib.resources.files("cloner_models")
        rows = json.loads((root / "nets" / "PROVENANCE.json").read_text(encoding="utf-8"))
        bad = [
            row["file"]
            for row in rows
            if row["file"].endswith(".tflite")
            and hashlib.sha256((root / "nets" / row["file"]).read_bytes()).hexdigest() != row["sha256"]
        ]
        if not (root / "body.npz").is_file():
            bad.append("body.npz")
    except (ImportError, OSError, ValueError) as error:
        return Finding("models", False, _one_line(str(error)), reinstall)
    if bad:
        return Finding("models", False, f"damaged or missing: {', '.join(bad)}", reinstall)
    return Finding("models", True, f"{len(rows)} files as shipped")


def _rendering() -> Finding:
    trouble = trouble_of(_RENDER_TEST, {})
    fix = f"{APT} libegl1 libgl1 libgles2 libgl1-mesa-dri"
    detail = f"{trouble}; pictures are drawn without it, slower and less smooth" if trouble else "draws"
    return Finding("drawing (EGL)", not trouble, detail, fix if trouble else "", needed=False)


def _qt() -> Finding:
    """Start Qt without a screen, and with one where there is one."""
    screen = bool(os.environ.get("DISPLAY") or os.environ.get("WAYLAND_DISPLAY"))
    trouble = trouble_of(_QT_TEST, {"QT_QPA_PLATFORM": "offscreen"})
    if not trouble and screen and not os.environ.get("QT_QPA_PLATFORM"):
        trouble = trouble_of(_QT_TEST, {})
    fix = f"{APT} libegl1 libxkbcommon0 libdbus-1-3 libfontconfig1 libxcb-cursor0 libxcb-icccm4 libxcb-keysyms1"
    detail = trouble or ("starts" if screen else "starts; no screen here, so `cloner gui` shows nothing")
    return Finding("window (Qt)", not trouble, detail, fix if trouble else "", needed=False)


def _writing() -> Finding:
    try:
        with tempfile.TemporaryFile(dir=Path.cwd()):
            return Finding("this folder", True, "can be written")
    except OSError as error:
        return Finding("this folder", False, f"cannot be written ({error.strerror})", "cd to a folder of your own")


def trouble_of(code: str, environment: dict[str, str]) -> str:
    """Run Python code apart and return the last line of its complaint, "" when all is well."""
    try:
        done = subprocess.run(
            [sys.executable, "-c", code],
            env={**os.environ, **environment},
            capture_output=True,
            text=True,
            timeout=PATIENCE_S,
            check=False,
        )
    except (OSError, subprocess.TimeoutExpired) as error:
        return _one_line(str(error))
    if done.returncode == 0:
        return ""
    return _one_line(done.stderr) or f"ended with code {done.returncode}"


def _one_line(text: str) -> str:
    lines = [line.strip() for line in text.splitlines() if line.strip()]
    return lines[-1][:200] if lines else ""
