"""The examples of docs/api.md and every step of docs/tutorial.md run as they stand."""

from __future__ import annotations

import os
import re
import shlex
import subprocess
import sys
from pathlib import Path

import pytest
from PIL import Image

ROOT = Path(__file__).resolve().parents[2]
TEXT = (ROOT / "docs" / "api.md").read_text(encoding="utf-8")
TUTORIAL = (ROOT / "docs" / "tutorial.md").read_text(encoding="utf-8")
COMMAND = [sys.executable, "-c", "from cloner.cli import main; main()"]

pytestmark = pytest.mark.slow


def blocks(kind: str) -> list[str]:
    return re.findall(rf"```{kind}\n(.*?)```", TEXT, flags=re.DOTALL)


def test_the_examples_of_the_api(tmp_path: Path, samples: Path) -> None:
    folder = tmp_path / "photos" / "anna"
    folder.mkdir(parents=True)
    with Image.open(samples / "anna" / "plain" / "body_front.jpg") as photo:
        photo.resize((600, 900)).save(folder / "body_front.jpg", quality=92)
    environment = {**os.environ, "PYTHONPATH": os.pathsep.join(sys.path)}
    assert len(blocks("python")) == 4
    done = subprocess.run(
        [sys.executable, "-c", "\n".join(blocks("python"))],
        cwd=tmp_path, env=environment, capture_output=True, text=True, check=False, timeout=600,
    )  # fmt: skip
    assert done.returncode == 0, done.stderr
    told = []
    for line in blocks("console")[0].splitlines():
        words = shlex.split(line.removeprefix("$ cloner"))
        done = subprocess.run(
            [*COMMAND, *words], cwd=tmp_path, env=environment, capture_output=True, text=True, check=False, timeout=100
        )
        assert done.returncode == 0, (line, done.stderr)
        told.append(done.stdout)
    assert "anna" in told[0]
    assert (tmp_path / "anna.zip").is_file()
    assert "anna" not in told[-1]


def test_the_tutorial_word_by_word(tmp_path: Path, samples: Path) -> None:
    """Its blocks in their order: commands, the file it writes, Python."""
    (tmp_path / "samples").symlink_to(samples)
    tool = tmp_path / "bin" / "cloner"
    tool.parent.mkdir()
    tool.write_text(f'#!/bin/sh\nexec {shlex.join(COMMAND)} "$@"\n')
    tool.chmod(0o755)
    paths = {"PYTHONPATH": os.pathsep.join(sys.path), "PATH": f"{tool.parent}{os.pathsep}{os.environ['PATH']}"}
    told = []
    for kind, block in re.findall(r"```(\w+)\n(.*?)```", TUTORIAL, flags=re.DOTALL):
        if kind == "toml":
            (tmp_path / block.split()[1]).write_text(block)
            continue
        lines = block.splitlines() if kind == "console" else []
        asked = [["sh", "-c", line.removeprefix("$ ")] for line in lines] or [[sys.executable, "-c", block]]
        for words in asked:
            done = subprocess.run(
                words,
                cwd=tmp_path,
                env={**os.environ, **paths},
                capture_output=True,
                text=True,
                check=False,
                timeout=600,
            )
            assert done.returncode == 0, (words, done.stderr)
            told.append(done.stdout)
    assert "viewer.html" in told[3]
    assert (tmp_path / "anna.png").stat().st_size > 10_000
    assert (tmp_path / "anna_hello.glb").is_file()
    assert "'value': 720.0" in told[-3]
    assert "'taped': True" in told[-3]
    assert not (tmp_path / "results" / "anna").exists()
