"""What the wheel must hold besides code, and what its pages say about versions."""

from __future__ import annotations

import base64
import fnmatch
import hashlib
import json
import os
import re
import subprocess
import sys
import tomllib
import zipfile
from pathlib import Path

import pytest
from packaging.requirements import Requirement
from packaging.utils import canonicalize_name

from cloner import __version__

ROOT = Path(__file__).resolve().parents[2]
PROJECT = tomllib.loads((ROOT / "pyproject.toml").read_text(encoding="utf-8"))
PACKAGES = {"cloner": ROOT / "cloner", "cloner_gui": ROOT / "gui" / "cloner_gui",
            "cloner_models": ROOT / "generic_models" / "cloner_models"}  # fmt: skip
#: Sources of what ships, kept beside it.
LEFT_OUT = ("*.ts", "*.pyc")


@pytest.mark.parametrize("package", PACKAGES)
def test_every_data_file_is_in_the_wheel(package: str) -> None:
    patterns = PROJECT["tool"]["setuptools"]["package-data"].get(package, [])
    files = [path.relative_to(PACKAGES[package]).as_posix() for path in PACKAGES[package].rglob("*") if path.is_file()]
    data = [file for file in files if not file.endswith(".py") and "__pycache__" not in file]
    forgotten = [file for file in data if not any(fnmatch.fnmatch(file, pattern) for pattern in (*patterns, *LEFT_OUT))]
    assert not forgotten, "setuptools would leave these out"


def test_every_folder_of_code_is_a_package() -> None:
    for name, folder in PACKAGES.items():
        for path in folder.rglob("*.py"):
            assert (path.parent / "__init__.py").is_file(), f"{name}: {path.parent} would be left out of the wheel"


def test_the_versions_are_one() -> None:
    assert PROJECT["project"]["version"] == __version__
    changes = (ROOT / "CHANGELOG.md").read_text(encoding="utf-8")
    assert re.findall(r"^## (\S+)", changes, re.M)[0] in (__version__, "Unreleased")
    assert f"\n## {__version__} (" in changes
    assert (ROOT / "docs" / "releases" / f"{__version__}.md").is_file()


def pins() -> dict[str, str]:
    """Return the versions of constraints.txt by name."""
    lines = [line for line in (ROOT / "constraints.txt").read_text().splitlines() if line and line[0] not in "# "]
    return dict(line.partition(" ")[0].split("==") for line in lines)


def test_every_pinned_package_is_known_by_its_bytes() -> None:
    entries = (ROOT / "constraints.txt").read_text().replace("\\\n", " ").splitlines()
    assert len(pins()) > 50
    for entry in entries:
        assert entry.startswith("#") or "--hash=sha256:" in entry, entry[:60]
    assert "--require-hashes -r constraints.txt" in (ROOT / "Makefile").read_text()


def test_the_tools_of_npm_are_locked() -> None:
    folder = ROOT / ".ci" / "npm"
    wanted = json.loads((folder / "package.json").read_text())["dependencies"]
    locked = json.loads((folder / "package-lock.json").read_text())["packages"]
    assert all(locked[f"node_modules/{name}"]["version"] == version for name, version in wanted.items())
    assert all("integrity" in told for name, told in locked.items() if name)
    assert "npm ci" in (ROOT / ".ci" / "run").read_text()


def test_a_wheel_carries_its_bill_of_materials(tmp_path: Path) -> None:
    wheel, bill = tmp_path / "x-1-py3-none-any.whl", tmp_path / "sbom.json"
    bill.write_text('{"bomFormat": "CycloneDX"}')
    with zipfile.ZipFile(wheel, "w") as archive:
        archive.writestr("x.py", "")
        archive.writestr("x-1.dist-info/RECORD", "x.py,,\nx-1.dist-info/RECORD,,\n")
    subprocess.run([sys.executable, ROOT / "release" / "add_sbom.py", wheel, bill], check=True)
    with zipfile.ZipFile(wheel) as archive:
        name = "x-1.dist-info/sboms/photo-cloner.cdx.json"
        assert archive.read(name) == bill.read_bytes()
        digest = base64.urlsafe_b64encode(hashlib.sha256(bill.read_bytes()).digest()).rstrip(b"=").decode()
        assert f"{name},sha256={digest},{bill.stat().st_size}" in archive.read("x-1.dist-info/RECORD").decode()
        assert archive.namelist().count("x-1.dist-info/RECORD") == 1


def test_the_constraints_are_within_what_the_project_asks_for() -> None:
    pinned = pins()
    extras = PROJECT["project"]["optional-dependencies"]
    for requirement in map(Requirement, (*PROJECT["project"]["dependencies"], *extras["cluster"], *extras["dev"])):
        if requirement.marker is not None and not requirement.marker.evaluate():
            continue
        name = canonicalize_name(requirement.name)
        assert name in pinned, f"{name} is not in constraints.txt: make constraints"
        assert requirement.specifier.contains(pinned[name]), name


def test_the_bill_of_materials_names_every_part_with_a_licence() -> None:
    told = [
        subprocess.run([sys.executable, ROOT / "release" / "sbom.py"], capture_output=True, text=True, check=False)
        for _ in range(2)
    ]
    if told[0].returncode:
        pytest.skip(told[0].stderr.strip())  # not everything is installed here
    assert told[0].stdout == told[1].stdout, "a bill must not change by itself"
    bill = json.loads(told[0].stdout)
    assert (bill["bomFormat"], bill["specVersion"]) == ("CycloneDX", "1.6")
    names = {part["name"] for part in bill["components"]}
    assert {"numpy", "ai-edge-litert", "cloner/report/web/three.min.js"} <= names
    assert any(name.endswith("pose_landmark_heavy.tflite") for name in names)
    assert all(part["licenses"] for part in bill["components"])
    assert len({part["bom-ref"] for part in bill["components"]}) == len(bill["components"])


def test_nothing_needs_one_system_alone() -> None:
    """Modules that only one system has are imported behind a question for the system."""
    for folder in PACKAGES.values():
        for path in folder.rglob("*.py"):
            lines = path.read_text(encoding="utf-8").splitlines()
            for line in lines:
                if line.startswith(("import fcntl", "import resource", "import pwd", "import grp", "import msvcrt")):
                    raise AssertionError(f"{path.name}: {line} at the top of the file")


def test_every_process_sums_on_one_thread() -> None:
    """Two threads give other last digits than one, and with them other bytes of every clone."""
    command = "import cloner, os; print(os.environ['OPENBLAS_NUM_THREADS'])"
    environment = {name: value for name, value in os.environ.items() if name != "OPENBLAS_NUM_THREADS"}
    told = subprocess.run([sys.executable, "-c", command], capture_output=True, text=True, env=environment, check=True)
    assert told.stdout.strip() == "1"
