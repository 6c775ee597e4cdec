"""The page that turns the clone works from the disk in a real browser and asks nobody for anything."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest

from cloner.exporters.table import EXPORTERS
from cloner.report.viewer import FILE, viewer_page, write_viewer
from kit.browser import CHROMIUM, browser
from kit.clones import toy_clone

needs_browser = pytest.mark.skipif(CHROMIUM is None, reason="no Chromium on this machine: the viewer is not opened")
BACKDROP = (226, 228, 230)


@pytest.fixture(scope="module")
def folder(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """A result with a viewer, and a page that frames it as the report does."""
    made = tmp_path_factory.mktemp("viewer")
    EXPORTERS.get("glb")(toy_clone(), made)
    write_viewer("Clone of <Anna & Co>", made / "clone.glb")
    (made / "frame.html").write_text(f'<!doctype html><iframe src="{FILE}" width="600" height="600"></iframe>')
    return made


def press(page, text: str) -> None:
    page.value(f"[...document.querySelectorAll('button')].find(b => b.textContent === {text!r}).click()")


def far_from_backdrop(picture: np.ndarray) -> np.ndarray:
    return np.abs(picture.astype(int) - BACKDROP).max(axis=2) > 24


@needs_browser
@pytest.mark.slow
def test_the_viewer_shows_turns_and_smiles_without_a_network(folder: Path, tmp_path: Path) -> None:
    """The person stands upright in the picture, looks different from behind, and only the face moves in a smile."""
    with browser(tmp_path / "profile") as page:
        page.open(folder / FILE, 600, 600)
        page.wait_for("document.body && document.body.dataset.ready")
        press(page, "turn")
        shots = {}
        for name in ("front", "back"):
            press(page, name)
            page.value("new Promise(done => setTimeout(done, 1500))")
            shots[name] = page.picture()
        press(page, "front")
        press(page, "face")
        page.value("new Promise(done => setTimeout(done, 1500))")
        still = page.picture()
        press(page, "open mouth")
        page.value("new Promise(done => setTimeout(done, 500))")
        moved = np.abs(page.picture().astype(int) - still).max(axis=2) > 24
        press(page, "open mouth")
        press(page, "face")
        press(page, "walk")
        page.value("new Promise(done => setTimeout(done, 400))")
        early = page.picture()
        page.value("new Promise(done => setTimeout(done, 350))")
        walking = np.abs(page.picture().astype(int) - early).max(axis=2)[60:540] > 24
        person = far_from_backdrop(shots["front"])[60:540]
        rows, columns = np.flatnonzero(person.any(axis=1)), np.flatnonzero(person.any(axis=0))
        assert len(rows) > 400
        assert len(rows) > 1.3 * len(columns)  # upright
        assert (np.abs(shots["front"].astype(int) - shots["back"]).max(axis=2) > 24).sum() > 500  # another side
        moved[:60], moved[540:] = False, False  # the buttons themselves change colour
        assert 100 < moved.sum() < 0.25 * moved.size
        assert walking.sum() > 300
        assert not page.complaints()
        assert all(address.startswith(("file:", "blob:", "data:", "about:")) for address in page.requests())


@needs_browser
@pytest.mark.slow
def test_the_viewer_works_in_the_frame_of_a_report(folder: Path, tmp_path: Path) -> None:
    with browser(tmp_path / "profile") as page:
        page.open(folder / "frame.html", 700, 700)
        seen = 0
        for _ in range(100):
            page.value("new Promise(done => setTimeout(done, 200))")
            seen = int((page.picture()[200:500, 100:500] == (60, 90, 160)).all(axis=2).sum())
            shown = far_from_backdrop(page.picture()[100:550, 200:400])
            if shown.sum() > 4000:
                break
        assert shown.sum() > 4000, seen


def test_names_cannot_leave_their_place() -> None:
    page = viewer_page("</title><script>alert(1)</script>", b"glTF")
    assert "<script>alert" not in page
    assert "&lt;script&gt;alert" in page


def test_the_shipped_script_is_the_one_of_the_record() -> None:
    import hashlib
    import json

    import cloner.report

    web = Path(cloner.report.__file__).parent / "web"
    (row,) = json.loads((web / "PROVENANCE.json").read_text())
    assert hashlib.sha256((web / row["file"]).read_bytes()).hexdigest() == row["sha256"]
