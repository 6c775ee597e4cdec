"""What the wheel must hold besides code, and what its pages say about versions."""

from __future__ import annotations

import fnmatch
import json
import os
import subprocess
import sys
import tomllib
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


def test_the_constraints_are_within_what_the_project_asks_for() -> None:
    lines = [line for line in (ROOT / "constraints.txt").read_text().splitlines() if line and line[0] != "#"]
    pinned = dict(line.split("==") for line in lines)
    for requirement in map(Requirement, PROJECT["project"]["dependencies"]):
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
