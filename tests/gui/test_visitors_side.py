"""What visitors see and take: the reveal, their own screen, the page on telephones; and the gallery of the day."""

import urllib.error
import urllib.request

import pytest
from PySide6.QtCore import Qt
from PySide6.QtWidgets import QApplication

from cloner.booth.events import trash
from cloner.booth.events.pin import PinLock, hash_pin
from cloner.booth.phone import parcel
from cloner.booth.visitors.visits import State, Visit, read_visit, write_visit
from cloner.evaluate.truths.baselines import generic_clone
from cloner.frames import ViewId
from cloner.generic.load import load_generic
from cloner.project.clone_file import save_clone
from cloner_gui.canvas.clones.reveal import ACTS
from cloner_gui.main_window import CLONE, TAKEAWAY
from cloner_gui.pages.gallery import CLONED, TRASHED, GalleryWindow
from cloner_gui.pages.stage import StageWindow
from kit.stand_ins import drop

from .test_flow import begin, event, settled  # noqa: F401  (event is a fixture)

pytestmark = pytest.mark.gui
LEFT = Qt.MouseButton.LeftButton


def with_result(folder, **visit):
    """Leave a finished clone in a visitor's folder, as the worker does."""
    result = folder / "clones" / folder.name
    result.mkdir(parents=True, exist_ok=True)
    save_clone(generic_clone(load_generic(), 1.7), result / "clone.npz")
    (result / "report.json").write_text("{}")
    write_visit(folder, Visit(state=State.CLONED, **visit))


def cloned(window, qtbot, samples):
    """Take a visitor as far as a clone, without a click on any page between."""
    folder = begin(window, qtbot)
    window.go(1)
    drop(window.photos, samples / "anna" / "plain" / f"{ViewId.BODY_FRONT}.jpg")
    settled(window, qtbot)
    with qtbot.waitSignal(window.session.cloned):
        qtbot.mouseClick(window.next, LEFT)
    qtbot.waitUntil(lambda: not window.session.cloning)
    return folder


def test_a_new_clone_turns_walks_waves_and_smiles_until_a_hand_takes_it(event, qtbot, samples):  # noqa: F811
    cloned(event, qtbot, samples)
    assert event.stack.currentIndex() == CLONE
    reveal = event.clone.reveal
    assert reveal.active
    assert [act.motion for act in ACTS] == ["idle", "walk", "wave", "smile"]
    seen = []
    for _ in ACTS:
        seen.append(event.clone.preview.motion_kind)
        reveal._go_on()
    assert seen == ["idle", "walk", "wave", "smile"]
    assert event.clone.preview.motion_kind == "stand", "then it stands again"
    qtbot.mouseClick(event.clone.reveal_button, LEFT)
    assert reveal.active
    qtbot.keyClick(event.clone.preview, Qt.Key.Key_Left)
    assert not reveal.active
    event.booth.change(calm=True)
    event.session.cloned.emit()
    assert not reveal.active, "nothing moves by itself where that is not wanted"


def test_the_waving_hand_is_above_the_shoulder_and_the_circle_is_closed():
    from cloner.motion.limbs.body import body_of
    from cloner.motion.moves.wave import UP_S, wave

    body = body_of(generic_clone(load_generic(), 1.7))
    motion = wave(body)
    places = body.places(motion)
    hand, shoulder = (places[:, body.joint(name), 1] for name in ("r_wrist", "r_shoulder"))
    up = (motion.times_s > UP_S[1]) & (motion.times_s < UP_S[2])
    assert (hand[up] > shoulder[up]).all()
    assert hand[0] < shoulder[0] - 0.3
    assert abs(places[0] - places[-1]).max() < 0.001
    assert abs(places[up][:, body.joint("l_wrist"), 1].max() - places[0, body.joint("l_wrist"), 1]) < 0.05


def test_the_screen_for_visitors_shows_who_agreed_and_forgets_who_goes(event, qtbot):  # noqa: F811
    seen, unseen = begin(event, qtbot), begin(event, qtbot)
    event.booth.save_person("Boris", None)
    with_result(seen, shown=True)
    with_result(unseen, shown=False)
    stage = StageWindow(event.booth)  # it deletes itself when it is closed
    stage.show()
    qtbot.waitUntil(lambda: stage._shown == seen)
    assert stage.who.text() == "1", "no name was given"
    stage.welcome(unseen)
    assert stage._shown == seen
    stage.go_on()
    qtbot.waitUntil(lambda: stage._shown == seen)
    event.booth.forget(seen)
    assert not seen.exists(), "at once"
    qtbot.waitUntil(lambda: stage._shown is None)
    assert stage.preview._clone is None
    write_visit(unseen, Visit(state=State.WAITING, queued="1"))
    event.booth.visits_changed.emit()
    assert stage.queue.text() == "Next: 2", "who did not agree is called by number"
    stage.close()


def test_who_may_walk_in_the_scene_is_asked_apart_and_only_where_there_is_one(event, qtbot):  # noqa: F811
    folder = begin(event, qtbot)
    form = event.visitor.form
    assert form.inhabits_box.isHidden()
    event.booth.change(scene="museum")
    assert not form.inhabits_box.isHidden()
    assert "museum" in form.inhabits_words.text()
    assert not read_visit(folder).inhabits, "nobody walks there unasked"
    qtbot.mouseClick(form.inhabits_box, LEFT)
    assert read_visit(folder).inhabits
    with_result(folder, inhabits=True)
    event.booth.visits_changed.emit()
    assert "museum" in event.takeaway.held_label.text()
    form._take_consent(False)
    assert not read_visit(folder).inhabits


def test_the_page_for_telephones_is_off_until_it_is_switched_on_and_takes_its_copies_along(
    event,  # noqa: F811
    qtbot,
    samples,
    monkeypatch,
):
    monkeypatch.setattr("cloner_gui.event.phone.local_addresses", lambda: ("127.0.0.1",))
    monkeypatch.setattr("cloner_gui.event.phone.PORT", 0)
    monkeypatch.setattr(parcel, "SIZE_PX", (24, 36))
    monkeypatch.setattr(parcel, "LARGE_PX", (24, 36))
    folder = cloned(event, qtbot, samples)
    with_result(folder)
    event.go(TAKEAWAY)
    page = event.takeaway
    assert not event.phone.is_on
    assert "nothing leaves" in page.phone_note.text()
    assert page.code.isHidden()
    page.phone_box.click()
    assert event.phone.is_on
    qtbot.waitUntil(lambda: page.code_note.text().startswith("http"))
    link = event.phone.link()
    assert page.code_note.text() == link
    assert not page.code.pixmap().isNull()
    with urllib.request.urlopen(f"{link}picture.jpg", timeout=10) as answer:
        assert answer.read()[:2] == b"\xff\xd8"
    event.booth.forget(folder)
    with pytest.raises(urllib.error.HTTPError, match="404"):
        urllib.request.urlopen(link, timeout=10)
    page.phone_box.click()
    assert not event.phone.is_on
    with pytest.raises(urllib.error.URLError):
        urllib.request.urlopen(link, timeout=10)


def test_the_gallery_finds_throws_away_and_brings_back(event, qtbot):  # noqa: F811
    for name in ("Anna Long", "Boris"):
        begin(event, qtbot)
        event.visitor.form.name_field.setText(name)
        event.visitor.form.save()
    anna, boris = event.booth.visits()
    with_result(boris)
    gallery = GalleryWindow(event.booth, event)
    gallery.show()
    assert gallery.list.count() == 2
    qtbot.keyClicks(gallery.search, "long")
    assert [item.text().splitlines()[0] for item in items(gallery)] == ["Anna Long (1)"]
    gallery.search.clear()
    gallery.which.setCurrentIndex(CLONED)
    assert [item.text().splitlines()[0] for item in items(gallery)] == ["Boris (2)"]
    gallery.which.setCurrentIndex(0)
    gallery.list.item(0).setSelected(True)
    qtbot.mouseClick(gallery.trash_button, LEFT)
    qtbot.waitUntil(lambda: not anna.exists() and gallery.list.count() == 1)
    qtbot.waitUntil(lambda: "Anna Long (1) lies in the trash for 2 days" in event.notice.text.text())
    gallery.which.setCurrentIndex(TRASHED)
    assert "deleted for good on" in gallery.list.item(0).text()
    gallery.list.item(0).setSelected(True)
    qtbot.mouseClick(gallery.back_button, LEFT)
    qtbot.waitUntil(lambda: anna.exists() and gallery.list.count() == 0)
    assert trash.trashed_visitors(event.booth.root) == ()
    gallery.which.setCurrentIndex(0)
    gallery.list.item(1).setSelected(True)
    assert not read_visit(boris).queued
    qtbot.mouseClick(gallery.again_button, LEFT)
    qtbot.waitUntil(lambda: read_visit(boris).queued != "")  # he waits for an instant: nobody else is cloned
    QApplication.processEvents()
    gallery.close()


def items(gallery):
    return [gallery.list.item(row) for row in range(gallery.list.count())]


def test_from_a_new_visitor_to_the_take_away_in_a_few_clicks(event, jobs, qtbot, samples, tmp_path):  # noqa: F811
    """Counted as the operator's effort is: with a camera's folder four, with files four and the file dialog's three."""
    from cloner_gui.event.effort import ClickCounter

    camera = tmp_path / "camera"
    camera.mkdir()
    event.booth.change(camera_folder=str(camera))
    counter = ClickCounter(event.booth)
    QApplication.instance().installEventFilter(counter)
    try:
        clicks = 0
        with qtbot.waitSignal(event.booth.page_wanted):
            qtbot.mouseClick(event.visitor.new_button, LEFT)
        clicks += 1
        qtbot.mouseClick(event.visitor.form.agree_button, LEFT)
        assert event.stack.currentWidget() is event.photos
        for view in (ViewId.BODY_FRONT, ViewId.FACE_FRONT):
            (camera / f"{view}.jpg").write_bytes((samples / "anna" / "plain" / f"{view}.jpg").read_bytes())
        qtbot.waitUntil(lambda: len(event.session.photos.photos) == 2)
        settled(event, qtbot)
        with qtbot.waitSignal(event.session.cloned):
            qtbot.mouseClick(event.next, LEFT)
        qtbot.waitUntil(lambda: not event.session.cloning)
        qtbot.mouseClick(event.next, LEFT)
        assert event.stack.currentWidget() is event.takeaway
        assert clicks + event.booth.clicks <= 4
    finally:
        QApplication.instance().removeEventFilter(counter)


def test_a_kiosk_hides_the_others_and_asks_for_the_number(event, qtbot, monkeypatch):  # noqa: F811
    folder = begin(event, qtbot)
    event.kiosk.toggle()
    assert not event.kiosk.on, "without a number nobody could get out"
    assert "number" in event.notice.text.text()
    event.booth.change(pin=hash_pin("2468"))
    assert "2468" not in (event.booth.root / "event.json").read_text()
    event.kiosk.toggle()
    assert event.isFullScreen()
    assert event.menuBar().isHidden()
    assert event.visitor.list.isHidden()
    typed = ["", "1111", "2468"]
    monkeypatch.setattr("cloner_gui.kiosk.ask_number", lambda parent: typed.pop(0))
    event.go(TAKEAWAY)
    event.takeaway._forget()
    event.close()
    assert event.isVisible(), "neither nothing nor a wrong number lets anybody out"
    assert folder.exists()
    event.kiosk.toggle()
    assert not event.kiosk.on
    assert not event.visitor.list.isHidden()


def test_after_five_wrong_numbers_the_right_one_has_to_wait():
    clock = [0.0]
    door, kept = PinLock(lambda: clock[0]), hash_pin("2468")
    assert kept != hash_pin("2468"), "salted"
    assert [door.accepts("1", kept) for _ in range(5)] == [False] * 5
    assert not door.accepts("2468", kept)
    clock[0] = 31.0
    assert door.accepts("2468", kept)


def test_who_hears_that_the_clone_is_ready_can_take_it_away_at_once(event, qtbot, samples):  # noqa: F811
    heard = []
    event.session.cloned.connect(lambda: heard.append((event.session.cloning, event.next.text().replace("&", ""))))
    cloned(event, qtbot, samples)
    assert heard == [(False, "Next")], "no next visitor is begun by who presses it quickly"
