"""The command line from outside: good ways, and every bad input with one clear sentence."""

from __future__ import annotations

import json
import os
import shutil
import signal
import subprocess
import sys
import time
from collections.abc import Callable
from pathlib import Path

import numpy as np
import pygltflib
import pytest
from PIL import Image, ImageFile

from cloner import cli, cloning, terminal
from cloner.cloning import CloneOutcome
from cloner.commands import options
from cloner.making import DEFAULT_TEXTURE_SIZE

Command = Callable[..., tuple[int, str, str]]


@pytest.fixture
def run(monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]) -> Command:
    """Return a function that runs ``cloner ARGUMENTS`` here and gives exit code, stdout and stderr."""

    def command(*arguments: object) -> tuple[int, str, str]:
        monkeypatch.setattr(sys, "argv", ["cloner", *(str(argument) for argument in arguments)])
        before = signal.getsignal(signal.SIGTERM)
        try:
            with pytest.raises(SystemExit) as caught:
                cli.main()
        finally:
            signal.signal(signal.SIGTERM, before)
        told = capsys.readouterr()
        return int(caught.value.code or 0), told.out, told.err

    return command


def copy_photos(source: Path, target: Path, *names: str) -> Path:
    target.mkdir()
    for name in names:
        shutil.copy(source / name, target / name)
    return target


def complaint(stderr: str) -> str:
    """Return the one line of complaint; progress lines are no complaint."""
    lines = [line for line in stderr.splitlines() if line.startswith("cloner: ")]
    assert len(lines) == 1, stderr
    assert "Traceback" not in stderr
    return lines[0]


def refused(run: Command, photos: Path, out: Path, *options: object) -> str:
    """Run ``cloner clone``, check that it refuses without a trace, and return its sentence."""
    code, _, stderr = run("clone", photos, "--out", out, *options)
    assert code == terminal.EXIT_INPUT
    assert not out.exists(), "something was left behind"
    return complaint(stderr)


def test_help_and_version(run: Command) -> None:
    code, out, _ = run("--help")
    assert code == 0
    assert all(name in out for name in ("clone", "batch", "render", "evaluate", "gui", "doctor"))
    assert run("--version")[1].startswith("cloner ")


def test_wrong_options_are_one_line(run: Command) -> None:
    code, _, stderr = run("clone", "--nonsense")
    assert code == 2
    assert "--nonsense" in complaint(stderr)


def test_no_usable_photos(run: Command, tmp_path: Path) -> None:
    (tmp_path / "empty").mkdir()
    assert "body_front.jpg" in refused(run, tmp_path / "empty", tmp_path / "out")
    assert "no such folder" in refused(run, tmp_path / "nowhere", tmp_path / "out")


def test_the_folder_above_the_photos_names_the_folder_below(run: Command, tmp_path: Path, samples: Path) -> None:
    sentence = refused(run, samples / "anna", tmp_path / "out")
    assert "(booth, handheld, plain)" in sentence
    assert "cloner batch" in sentence


def test_unreadable_and_truncated_files(run: Command, tmp_path: Path, samples: Path) -> None:
    photos = copy_photos(samples / "anna" / "plain", tmp_path / "anna", "body_front.jpg")
    whole = (photos / "body_front.jpg").read_bytes()
    for damage, words in ((whole[: len(whole) // 2], "damaged"), (b"hello", "not a photo"), (b"", "empty")):
        (photos / "body_front.jpg").write_bytes(damage)
        sentence = refused(run, photos, tmp_path / "out")
        assert words in sentence
        assert "body_front.jpg" in sentence


def test_too_many_megapixels_are_refused_unread(run: Command, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    photos = tmp_path / "huge"
    photos.mkdir()
    Image.new("L", (13_000, 10_000)).save(photos / "body_front.png", compress_level=1)
    monkeypatch.setattr(ImageFile.ImageFile, "load", lambda _: pytest.fail("it was read"))
    assert "megapixels" in refused(run, photos, tmp_path / "out")


@pytest.mark.parametrize(("height", "words"), [("17.2", "outside 60 to 250 cm"), ("1720", "outside 60 to 250 cm")])
def test_absurd_heights(run: Command, tmp_path: Path, samples: Path, height: str, words: str) -> None:
    sentence = refused(run, samples / "anna" / "plain", tmp_path / "out", "--height-cm", height)
    assert words in sentence
    assert "--height-cm" in sentence


def test_unknown_formats_are_refused_before_any_work(run: Command, tmp_path: Path, samples: Path) -> None:
    sentence = refused(run, samples / "anna" / "plain", tmp_path / "out", "--format", "glb,fbx")
    assert "'fbx'" in sentence
    assert "glb, small" in sentence


def test_odd_texture_sizes_are_refused(run: Command, tmp_path: Path, samples: Path) -> None:
    assert "512, 1024" in refused(run, samples / "anna" / "plain", tmp_path / "out", "--size", 1000)


def test_the_command_lines_defaults_are_the_programs() -> None:
    assert terminal.split_formats(options.DEFAULT_FORMATS) == cloning.DEFAULT_FORMATS
    assert options.DEFAULT_TEXTURE_SIZE == DEFAULT_TEXTURE_SIZE


def test_unwritable_output(run: Command, tmp_path: Path, samples: Path) -> None:
    (tmp_path / "file").write_text("x")
    sentence = refused(run, samples / "anna" / "plain", tmp_path / "file" / "out")
    assert "cannot be written" in sentence
    assert "--out" in sentence


def test_a_photo_without_a_person(run: Command, tmp_path: Path) -> None:
    photos = tmp_path / "nobody"
    photos.mkdir()
    ramp = np.linspace(80, 200, 1200, dtype=np.uint8)
    Image.fromarray(np.repeat(np.tile(ramp, (1600, 1))[..., None], 3, axis=2)).save(photos / "body_front.jpg")
    sentence = refused(run, photos, tmp_path / "out")
    assert "no person" in sentence
    assert "body_front.jpg" in sentence


def test_two_people_in_one_photo(run: Command, tmp_path: Path, samples: Path) -> None:
    photos = tmp_path / "pair"
    photos.mkdir()
    first, second = (Image.open(samples / name / "plain" / "body_front.jpg") for name in ("anna", "boris"))
    pair = Image.new("RGB", (first.width + second.width, first.height))
    pair.paste(first, (0, 0))
    pair.paste(second, (first.width, 0))
    pair.save(photos / "body_front.jpg")
    sentence = refused(run, photos, tmp_path / "out")
    assert "2 people" in sentence
    assert "body_front.jpg" in sentence


@pytest.mark.parametrize(
    ("first", "second", "words"),
    [
        ("body_front.jpg", "body_side.jpg", "body_front.jpg: this photo shows the person from the side"),
        ("body_front.jpg", "body_back.jpg", "body_front.jpg: this photo shows the person's back"),
        ("face_front.jpg", "face_side.jpg", "face_front.jpg: this photo shows the face from the side"),
        ("body_front.jpg", "face_front.jpg", "body_front.jpg: this photo shows only the upper part"),
    ],
)
def test_exchanged_photos(run: Command, tmp_path: Path, samples: Path, first: str, second: str, words: str) -> None:
    photos = tmp_path / "exchanged"
    photos.mkdir()
    source = samples / "anna" / "plain"
    shutil.copy(source / first, photos / second)
    shutil.copy(source / second, photos / first)
    sentence = refused(run, photos, tmp_path / "out")
    assert words in sentence
    assert "Rename or retake" in sentence


def test_two_faces_in_a_face_photo(run: Command, tmp_path: Path, samples: Path) -> None:
    photos = tmp_path / "pair"
    photos.mkdir()
    first, second = (Image.open(samples / name / "plain" / "face_front.jpg") for name in ("anna", "boris"))
    pair = Image.new("RGB", (first.width + second.width, first.height))
    pair.paste(first, (0, 0))
    pair.paste(second, (first.width, 0))
    pair.save(photos / "face_front.jpg")
    assert "face_front.jpg: 2 people" in refused(run, photos, tmp_path / "out")


def test_malformed_corrections(run: Command, tmp_path: Path, samples: Path) -> None:
    photos = copy_photos(samples / "anna" / "plain", tmp_path / "anna", "body_front.jpg")
    (photos / "corrections.json").write_text("{")
    assert "corrections.json" in refused(run, photos, tmp_path / "out")
    entry = {"format": 1, "views": {"body_front": {"crotch": {"x": 99999, "y": 5}}}}
    (photos / "corrections.json").write_text(json.dumps(entry))
    assert "outside the photo" in refused(run, photos, tmp_path / "out")
    entry = {"format": 1, "views": {"body_front": {"third_elbow": {"x": 5, "y": 5}}}}
    (photos / "corrections.json").write_text(json.dumps(entry))
    assert "body_front.third_elbow" in refused(run, photos, tmp_path / "out")


@pytest.mark.slow
@pytest.mark.parametrize("number", [signal.SIGINT, signal.SIGTERM])
def test_stopping_leaves_nothing(tmp_path: Path, samples: Path, number: signal.Signals) -> None:
    out = tmp_path / "out"
    # a background job of a shell inherits a deaf ear for Ctrl-C; a terminal's does not
    listen = "import signal; signal.signal(signal.SIGINT, signal.default_int_handler)"
    command = [sys.executable, "-c", f"{listen}; from cloner.cli import main; main()", "clone"]
    environment = {**os.environ, "PYTHONPATH": os.pathsep.join(sys.path)}
    process = subprocess.Popen(
        [*command, str(samples / "anna" / "plain"), "--out", str(out)],
        env=environment,
        stderr=subprocess.PIPE,
        stdout=subprocess.PIPE,
        text=True,
    )
    deadline = time.monotonic() + 60
    while not list(out.glob(".*.partial-*")) and time.monotonic() < deadline and process.poll() is None:
        time.sleep(0.05)
    process.send_signal(number)
    _, stderr = process.communicate(timeout=60)
    assert process.returncode == terminal.EXIT_CANCELLED, stderr
    assert "stopped" in complaint(stderr)
    assert not out.exists()


@pytest.mark.slow
def test_a_killed_run_leaves_nothing_visible_and_the_next_one_sweeps(
    run: Command, tmp_path: Path, samples: Path
) -> None:
    out = tmp_path / "out"
    photos = copy_photos(samples / "anna" / "plain", tmp_path / "anna", "face_front.jpg")
    command = [sys.executable, "-c", "from cloner.cli import main; main()", "clone", str(photos), "--out", str(out)]
    environment = {**os.environ, "PYTHONPATH": os.pathsep.join(sys.path)}
    process = subprocess.Popen(command, env=environment, stderr=subprocess.DEVNULL)
    deadline = time.monotonic() + 60
    while not list(out.glob(".*.partial-*")) and time.monotonic() < deadline:
        time.sleep(0.02)
    process.kill()
    process.wait()
    left = list(out.iterdir())
    assert left, "killed before it began: the test shows nothing"
    assert all(path.name.startswith(".") for path in left)
    (photos / "face_front.jpg").write_bytes(b"")
    code, _, stderr = run("clone", photos, "--out", out)
    assert (code, "empty" in complaint(stderr)) == (terminal.EXIT_INPUT, True)
    assert not list(out.iterdir())


def test_render_refuses_what_it_cannot_draw(run: Command, tmp_path: Path) -> None:
    code, _, stderr = run("render", tmp_path, "--out", tmp_path / "a.png")
    assert (code, "no clone" in complaint(stderr)) == (terminal.EXIT_INPUT, True)


@pytest.mark.slow
def test_render_draws_a_clone(run: Command, tmp_path: Path, cloned_anna: CloneOutcome) -> None:
    picture = tmp_path / "side.png"
    code, _, stderr = run("render", cloned_anna.folder, "--view", "side", "--out", picture, "--size", "200x300")
    assert code == 0, stderr
    drawn = np.asarray(Image.open(picture).convert("L"), dtype=float)
    assert drawn.shape == (300, 200)
    assert drawn.std() > 20.0, "the picture is empty"
    code, _, stderr = run("render", cloned_anna.folder, "--view", "above", "--out", tmp_path / "above.png")
    assert code == terminal.EXIT_INPUT
    assert "front" in complaint(stderr)
    assert [path.name for path in tmp_path.iterdir()] == ["side.png"]


def test_animate_adds_speech_and_a_face_and_refuses_other_files(
    run: Command, tmp_path: Path, cloned_anna: CloneOutcome
) -> None:
    phonemes = tmp_path / "mama.txt"
    phonemes.write_text("M 0.1\nAA1 0.2\nM 0.1\nAA1 0.2\n")
    out = tmp_path / "anna.glb"
    code, told, stderr = run("animate", cloned_anna.folder, phonemes, "--out", out)
    assert code == 0, stderr
    fap = tmp_path / "anna_mama.fap"
    assert told.split() == [str(out), str(fap)]
    again = tmp_path / "again.glb"
    code, _, stderr = run("animate", cloned_anna.folder, fap, "--out", again)
    assert code == 0, stderr
    names = [animation.name for animation in pygltflib.GLTF2().load_binary(str(again)).animations]
    assert names == ["anna_mama", "walk", "idle"]
    code, _, stderr = run("animate", cloned_anna.folder, tmp_path / "song.mp3", "--out", tmp_path / "song.glb")
    assert code == terminal.EXIT_INPUT
    assert ".wav" in complaint(stderr)


def test_doctor_says_one_line_a_thing(run: Command) -> None:
    code, out, _ = run("doctor")
    assert code == 0, out
    assert "numpy" in out
    assert "drawing (EGL)" in out
    assert out.count("fix:") == out.count("MISSING") + out.count("optional ")
