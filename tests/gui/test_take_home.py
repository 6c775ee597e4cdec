"""What visitors take home besides the window's own files: the card, the draft of an e-mail, and the stick by itself."""

import email
import email.policy
import json
import re
import threading

import cv2
import numpy as np
import pytest
from PySide6.QtCore import Qt
from PySide6.QtGui import QImage

from cloner.booth.visitors.visits import Visit, write_visit
from cloner_gui.background.newest import shared_latest
from cloner_gui.main_window import TAKEAWAY
from cloner_gui.widgets.letters import mnemonic_of, with_mnemonics
from cloner_gui.widgets.printed_card import card_image
from kit.odd_programs import install

from .test_flow import event  # noqa: F401  (a fixture)
from .test_visitors_side import cloned

pytestmark = pytest.mark.gui
LEFT = Qt.MouseButton.LeftButton


@pytest.fixture
def taken(event, qtbot, samples):  # noqa: F811
    """The window on the last page, a visitor cloned, the card drawn."""
    cloned(event, qtbot, samples)
    event.visitor.form.name_field.setText("Anna Long")
    event.visitor.form.save()
    event.go(TAKEAWAY)
    qtbot.waitUntil(lambda: event.takeaway.keepsakes.content() is not None)
    return event


def grey(image: QImage):
    image = image.convertToFormat(QImage.Format.Format_Grayscale8)
    return np.frombuffer(image.constBits(), np.uint8).reshape(image.height(), image.bytesPerLine())[:, : image.width()]


def said_in(image):
    pixels = grey(image)
    corner = pixels[round(0.76 * len(pixels)) :, pixels.shape[1] // 2 :]
    return cv2.QRCodeDetector().detectAndDecode(np.ascontiguousarray(corner))[0]


def saved_as(monkeypatch, path):
    monkeypatch.setattr("cloner_gui.event.keepsakes.QFileDialog.getSaveFileName", lambda *_: (str(path), ""))


def test_the_card_says_what_the_visitor_agreed_to_and_its_code_can_be_scanned(taken):
    keepsakes, folder = taken.takeaway.keepsakes, taken.session.folder
    content = keepsakes.content()
    assert (content.name, content.code) == ("Visitor 1", None), "who did not agree to be seen is a number"
    assert folder.name in content.note
    assert said_in(card_image(content)) == ""
    write_visit(folder, Visit(shown=True))
    taken.booth.change(title="Fair", link="https://booth.example/{id}")
    content = keepsakes.content()
    assert (content.name, content.title) == ("Anna", "Fair")
    assert said_in(card_image(content)) == "https://booth.example/visitor-001"
    assert np.ptp(grey(content.picture)) > 100, "the clone is on its picture"


def test_the_card_as_a_page_and_as_a_picture(taken, qtbot, tmp_path, monkeypatch):
    keepsakes = taken.takeaway.keepsakes
    saved_as(monkeypatch, tmp_path / "card")
    qtbot.mouseClick(keepsakes.save_button, LEFT)
    page = (tmp_path / "card.pdf").read_bytes()
    box = re.search(rb"/MediaBox \[0 0 ([\d.]+) ([\d.]+)\]", page)
    points = [float(one) for one in box.groups()]
    assert points == pytest.approx([105 / 25.4 * 72, 148 / 25.4 * 72], abs=1.5), "A6, in points of 1/72 inch"
    saved_as(monkeypatch, tmp_path / "card.png")
    qtbot.mouseClick(keepsakes.save_button, LEFT)
    assert QImage(str(tmp_path / "card.png")).size().toTuple() == (1240, 1748), "A6 at 300 dots an inch"
    assert "card.png" in keepsakes.note.text()
    saved_as(monkeypatch, tmp_path / "missing" / "card.png")
    qtbot.mouseClick(keepsakes.save_button, LEFT)
    assert "cannot be written" in taken.notice.text.text()


def test_the_card_goes_through_the_systems_own_printing(taken, qtbot, tmp_path):
    from PySide6.QtPrintSupport import QPrintDialog

    keepsakes = taken.takeaway.keepsakes
    qtbot.mouseClick(keepsakes.print_button, LEFT)
    dialog = keepsakes.findChild(QPrintDialog)
    assert dialog.isVisible()
    dialog.printer().setOutputFileName(str(tmp_path / "printed.pdf"))
    dialog.done(1)
    assert (tmp_path / "printed.pdf").read_bytes()[:5] == b"%PDF-"
    assert (tmp_path / "printed.pdf").stat().st_size > 10_000, "with the picture"


def test_an_e_mail_is_a_draft_in_the_visitors_language_and_nothing_is_sent(taken, qtbot, tmp_path, monkeypatch):
    taken.booth.agree("Ich stimme zu.", "de")
    saved_as(monkeypatch, tmp_path / "anna.eml")
    qtbot.mouseClick(taken.takeaway.keepsakes.mail_button, LEFT)
    read = email.message_from_bytes((tmp_path / "anna.eml").read_bytes(), policy=email.policy.default)
    assert read["X-Unsent"] == "1"
    assert read["To"] is None
    assert read["Subject"] == "Ihr Klon"
    text = read.get_body(("plain",)).get_content()
    assert text.startswith("Guten Tag Anna,")
    assert "http" not in text, "there is no page to go to"
    attached = next(read.iter_attachments())
    assert attached.get_content_type() == "image/jpeg"
    picture = cv2.imdecode(np.frombuffer(attached.get_content(), np.uint8), cv2.IMREAD_COLOR)
    assert picture.shape[0] > 1000


def lsblk(stick):
    part = {
        "path": "/dev/sdz1",
        "rm": True,
        "mountpoints": [str(stick)],
        "label": "FAIR & CO",
        "fsavail": 7_500_000_000,
    }
    drive = {"path": "/dev/sdz", "rm": True, "tran": "usb", "mountpoints": [None], "children": [part]}
    return "cat <<END\n" + json.dumps({"blockdevices": [drive]}) + "\nEND"


def test_a_stick_is_found_by_itself_written_read_back_and_let_go(taken, qtbot, tmp_path, monkeypatch):
    stick, log = tmp_path / "stick", tmp_path / "log"
    stick.mkdir()
    mounts = tmp_path / "mountinfo"
    mounts.write_text("nothing yet")
    monkeypatch.setattr("cloner_gui.widgets.stick_row.MOUNTS", mounts)
    install(tmp_path, monkeypatch, lsblk="echo '{}'", udisksctl=f'echo "$*" >> {log}')
    row = taken.takeaway.sticks
    row.look()
    qtbot.waitUntil(lambda: shared_latest().idle)
    assert row.copy_button.isHidden()
    assert "No stick" in row.note.text()
    install(tmp_path, monkeypatch, lsblk="exit 1")
    mounts.write_text("something odd")
    qtbot.waitUntil(lambda: "does not tell" in row.note.text())
    install(tmp_path, monkeypatch, lsblk=lsblk(stick))
    mounts.write_text("one more")
    qtbot.waitUntil(lambda: row.copy_button.isVisible())
    assert row.copy_button.text().replace("&&", "+").replace("&", "") == "Copy to FAIR + CO"
    assert row.note.text() == "7.5 GB are free."
    qtbot.wait(50)
    letters = [mnemonic_of(one.text()) for one in with_mnemonics(taken.takeaway) if one.isVisible()]
    assert len(letters) == len(set(letters)), "a stick that comes by itself takes nobody's letter"
    qtbot.mouseClick(row.copy_button, LEFT)
    qtbot.waitUntil(lambda: not taken.takeaway.handing.busy)
    assert (stick / "visitor-001" / "clone.glb").is_file()
    assert "stick/visitor-001" in taken.takeaway.status.text()
    install(tmp_path, monkeypatch, lsblk="echo '{}'")
    qtbot.mouseClick(row.eject_button, LEFT)
    qtbot.waitUntil(lambda: row.note.text() == "FAIR & CO can be pulled out.")
    qtbot.waitUntil(lambda: not row.busy and row.copy_button.isHidden())
    assert log.read_text().splitlines()[0].startswith("unmount")


def test_copying_is_stopped_by_a_button_and_nothing_is_left(taken, qtbot, tmp_path, jobs, monkeypatch):
    page, stick = taken.takeaway, tmp_path / "stick"
    stick.mkdir()
    monkeypatch.setattr("cloner_gui.pages.takeaway.QFileDialog.getExistingDirectory", lambda *_: str(stick))
    jobs.hold_copies = threading.Event()
    assert not page.stop_button.isVisible()
    qtbot.mouseClick(page.folder_button, LEFT)
    qtbot.waitUntil(lambda: page.handing.step == "copy")
    assert page.stop_button.isVisible()
    qtbot.mouseClick(page.stop_button, LEFT)
    qtbot.waitUntil(lambda: not page.handing.busy)
    assert page.status.text() == "Stopped: nothing of it was left there."
    assert list(stick.iterdir()) == []
    assert not taken.notice.isVisible(), "that was no error"
    jobs.hold_copies = None
    qtbot.mouseClick(page.folder_button, LEFT)
    qtbot.waitUntil(lambda: not page.handing.busy)
    assert (stick / "visitor-001" / "clone.glb").is_file()
    assert "stick/visitor-001" in page.status.text()
    assert not page.stop_button.isVisible()


def test_where_sticks_cannot_be_found_it_is_said(taken, qtbot, tmp_path, monkeypatch):
    row = taken.takeaway.sticks
    install(tmp_path, monkeypatch, lsblk="exit 1")
    row._known = None
    row.look()
    qtbot.waitUntil(lambda: "does not tell" in row.note.text())
    monkeypatch.setattr("cloner_gui.widgets.stick_row.MOUNTS", tmp_path / "none")
    row.look()
    assert "Linux only" in row.note.text()
    assert taken.takeaway.folder_button.isEnabled(), "by hand as ever"
