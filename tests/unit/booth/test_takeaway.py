"""What is handed out is whole or not there; the code says what it should."""

import json
import zipfile

import cv2
import numpy as np
import pytest

from cloner import cloning
from cloner.booth.handover import handing, takeaway
from cloner.booth.visitors import cached_work
from cloner.errors import Cancelled, ClonerError
from cloner.evaluate.truths.baselines import generic_clone
from cloner.generic.load import load_generic
from cloner.project.clone_file import save_clone


def quiet(step, fraction):
    pass


@pytest.fixture(scope="module")
def result(tmp_path_factory):
    folder = tmp_path_factory.mktemp("clones") / "visitor-001"
    (folder / "previews").mkdir(parents=True)
    (folder / "previews" / "front.png").write_bytes(b"png")
    (folder / "report.html").write_text("<p>fine")
    (folder / "report.json").write_text(json.dumps({"name": "secret"}))
    save_clone(generic_clone(load_generic(), 1.7), folder / "clone.npz")
    return folder


def test_a_folder_with_the_chosen_formats(result, tmp_path):
    assert handing.hand_over(result, tmp_path / "anna", ("ply",), quiet) == tmp_path / "anna"
    names = sorted(path.relative_to(tmp_path / "anna").as_posix() for path in (tmp_path / "anna").rglob("*"))
    assert names == ["clone.ply", "previews", "previews/front.png", "report.html"]


def test_the_window_looks_for_the_clone_where_cloning_puts_it():
    assert cached_work.CLONE_FILE == cloning.CLONE_FILE


def test_one_zip_file(result, tmp_path):
    path = handing.hand_over(result, tmp_path / "anna.zip", ("ply",), quiet)
    with zipfile.ZipFile(path) as archive:
        assert sorted(archive.namelist()) == ["anna/clone.ply", "anna/previews/front.png", "anna/report.html"]
        assert archive.testzip() is None
    assert list(tmp_path.iterdir()) == [path]


def test_nothing_is_overwritten_and_nothing_is_left_of_a_stopped_one(result, tmp_path):
    (tmp_path / "anna").mkdir()
    with pytest.raises(ClonerError, match="there already"):
        handing.hand_over(result, tmp_path / "anna", ("ply",), quiet)
    assert takeaway.free_name(tmp_path, "anna") == tmp_path / "anna-2"

    def stop(step, fraction):
        raise Cancelled

    with pytest.raises(Cancelled):
        handing.hand_over(result, tmp_path / "boris", ("ply",), stop)
    assert [path.name for path in tmp_path.iterdir()] == ["anna"]


def test_a_killed_process_leaves_nothing_behind_when_it_is_cleaned_up(result, tmp_path):
    """The window kills its worker wherever it is, so that nobody in there can clean up."""
    stick, made = tmp_path / ".anna [1].partial-77", result.parent / ".take-away.partial-77"
    for room in (stick, made, tmp_path / ".boris.partial-77"):
        room.mkdir()
        (room / "half.glb").write_bytes(b"x")
    handing.clean_up(result, tmp_path / "anna [1]")
    assert [path.name for path in tmp_path.iterdir()] == [".boris.partial-77"], "another's copy goes on"
    assert not made.exists()


def test_without_a_clone_there_is_nothing(tmp_path):
    with pytest.raises(ClonerError, match="not there"):
        handing.hand_over(tmp_path, tmp_path / "x", ("ply",), quiet)


def test_a_telephone_reads_the_code():
    text = "https://booth.example/take/visitor-001"
    modules = takeaway.qr_modules(text)
    assert not modules[:4].any(), "the white border is there"
    picture = np.where(modules, 0, 255).astype(np.uint8).repeat(6, 0).repeat(6, 1)
    assert cv2.QRCodeDetector().detectAndDecode(picture)[0] == text
    with pytest.raises(ClonerError, match="too long"):
        takeaway.qr_modules("x" * 700)


def test_the_code_says_the_events_link_for_the_visitor():
    assert takeaway.link_text("http://x/{id}.zip", "visitor-007") == "http://x/visitor-007.zip"
    assert takeaway.link_text("", "visitor-007") == ""
