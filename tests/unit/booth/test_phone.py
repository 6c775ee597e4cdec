"""The page for telephones: one link a visitor that nobody guesses or lists, that ends and goes with the visitor."""

import http.client
import shutil
import socket
import ssl
from datetime import UTC, datetime, timedelta

import numpy as np
import pytest
from PIL import Image

from cloner.booth.events import retention
from cloner.booth.events.event import new_visitor, visitor_folders
from cloner.booth.phone import parcel, server
from cloner.booth.phone.certificate import make_certificate
from cloner.booth.phone.limits import RateLimit
from cloner.booth.phone.page import WORDS, page, policy
from cloner.booth.phone.tickets import Ticket, issue_ticket, read_ticket, visitor_of
from cloner.evaluate.truths.baselines import generic_clone
from cloner.generic.load import load_generic
from cloner.project.clone_file import save_clone

NOW = datetime.now(UTC)


@pytest.fixture
def fair(tmp_path):
    """An event of two visitors whose parcels lie ready."""
    for number in (1, 2):
        folder = new_visitor(tmp_path, "now")
        (folder / "phone").mkdir()
        for name in parcel.FILES:
            (folder / "phone" / name).write_bytes(f"{name} of {number}".encode())
    return tmp_path


@pytest.fixture
def served(fair):
    phone = server.PhoneServer(lambda: visitor_folders(fair), "de", "127.0.0.1", 0)
    yield phone
    phone.stop()


def ask(phone, path, method="GET", context=None):
    host, port = phone.base.split("/")[2].split(":")
    if context is None:
        connection = http.client.HTTPConnection(host, int(port), timeout=10)
    else:
        connection = http.client.HTTPSConnection(host, int(port), timeout=10, context=context)
    connection.request(method, path)
    answer = connection.getresponse()
    content = answer.read()
    connection.close()
    return answer.status, content, dict(answer.getheaders())


def test_a_visitors_link_gives_the_page_and_its_files_and_nothing_else(fair, served):
    first, second = visitor_folders(fair)
    token, other = issue_ticket(first, NOW, 24).token, issue_ticket(second, NOW, 24).token
    assert len(token) >= 22, "sixteen bytes of chance"
    assert token != other
    status, content, headers = ask(served, f"/{token}/")
    assert status == 200
    assert WORDS["de"][0].encode() in content
    assert headers["Cache-Control"] == "no-store"
    assert "default-src 'none'" in headers["Content-Security-Policy"]
    assert ask(served, f"/{token}/clone.glb")[:2] == (200, b"clone.glb of 1")
    assert ask(served, f"/{other}/clone.glb")[1] == b"clone.glb of 2"
    assert ask(served, f"/{token}/clone.glb", "HEAD")[1] == b""
    for path in ("/", f"/{token}", f"/{token}/phone.json", f"/{token}/../visit.json", "/visitor-001/", "/robots.txt"):
        assert ask(served, path)[:2] == (404, b""), path


def test_a_link_ends_and_goes_with_the_visitor(fair, served):
    first, second = visitor_folders(fair)
    token = issue_ticket(first, NOW - timedelta(hours=25), 24).token
    assert ask(served, f"/{token}/")[0] == 404, "its hours are over"
    fresh = issue_ticket(first, NOW, 24).token
    assert fresh != token
    assert ask(served, f"/{fresh}/")[0] == 200
    assert issue_ticket(first, NOW, 24).token == fresh, "one link a visitor"
    retention.forget_visitors((first,), fair)
    assert ask(served, f"/{fresh}/")[0] == 404
    assert not [path for path in fair.rglob("*") if "001" in path.name], "the page's copies are gone too"
    mine = issue_ticket(second, NOW, 1)
    assert visitor_of(mine.token, visitor_folders(fair), NOW) == second


def test_guessing_is_soon_refused_also_with_the_right_link(fair, served):
    token = issue_ticket(visitor_folders(fair)[0], NOW, 24).token
    answers = [ask(served, f"/{number:022d}/")[0] for number in range(12)]
    assert answers[:10] == [404] * 10
    assert answers[10:] == [429, 429]
    assert ask(served, f"/{token}/")[0] == 429


def test_a_budget_drips_full_again_and_forgets_who_was_quiet():
    clock = [0.0]
    budget = RateLimit(3.0, 0.5, lambda: clock[0])
    assert [budget.spend("a") for _ in range(4)] == [True, True, True, False]
    assert budget.spend("b")
    clock[0] = 2.0
    assert [budget.spend("a") for _ in range(2)] == [True, False]


def test_nothing_listens_after_it_is_switched_off(fair):
    phone = server.PhoneServer(lambda: (), "en", "127.0.0.1", 0)
    port = int(phone.base.rsplit(":", 1)[1].strip("/"))
    with socket.create_connection(("127.0.0.1", port), timeout=5):
        pass
    phone.stop()
    with pytest.raises(ConnectionRefusedError):
        socket.create_connection(("127.0.0.1", port), timeout=5)


def test_an_encrypted_page_has_the_booths_own_certificate(fair):
    pytest.importorskip("cryptography")
    keys = make_certificate(fair, "127.0.0.1")
    assert keys[1].stat().st_mode & 0o077 == 0
    phone = server.PhoneServer(lambda: visitor_folders(fair), "en", "127.0.0.1", 0, keys)
    try:
        token = issue_ticket(visitor_folders(fair)[0], NOW, 24).token
        trusting = ssl.create_default_context(cafile=str(keys[0]))
        assert phone.link(token).startswith("https://127.0.0.1:")
        assert ask(phone, f"/{token}/", context=trusting)[0] == 200
    finally:
        phone.stop()


def test_a_broken_ticket_opens_nothing(fair):
    folder = visitor_folders(fair)[0]
    for text in ("", "[]", '{"token": "", "expires": "2100-01-01T00:00:00+00:00"}', '{"token": "x"}'):
        (folder / "phone.json").write_text(text)
        assert read_ticket(folder) is None
    assert isinstance(issue_ticket(folder, NOW, 1), Ticket)


def test_the_page_is_one_file_and_may_do_nothing_but_show_its_pictures():
    text = page("fr", "<b>").decode()
    assert "<b>" not in text
    assert "http" not in text, "nothing from elsewhere"
    assert "Votre clone" in text
    assert policy().count("sha256-") == 2


def test_a_parcel_holds_pictures_from_all_sides_a_film_and_the_clone(tmp_path, monkeypatch):
    monkeypatch.setattr(parcel, "SIZE_PX", (48, 72))
    monkeypatch.setattr(parcel, "LARGE_PX", (96, 144))
    result = tmp_path / "visitor-001" / "clones" / "visitor-001"
    result.mkdir(parents=True)
    save_clone(generic_clone(load_generic(), 1.7), result / "clone.npz")
    visitor = tmp_path / "visitor-001"
    assert not parcel.is_packed(visitor, result)
    place = parcel.pack(visitor, result, lambda step, fraction: None)
    assert {path.name for path in place.iterdir()} == set(parcel.FILES)
    with Image.open(place / "film.webp") as film:
        assert film.n_frames == parcel.SIDES
    front, side = (np.asarray(Image.open(place / f"side_{number:02d}.jpg")).astype(int) for number in (0, 6))
    person = [np.abs(one - one[0, 0]).sum(axis=2) > 60 for one in (front, side)]
    wide = [np.ptp(np.flatnonzero(one.any(axis=0))) for one in person]
    assert wide[1] < 0.8 * wide[0], "a quarter turn shows the side, which is narrower"
    assert parcel.is_packed(visitor, result)
    shutil.rmtree(place)
    assert [path.name for path in visitor.iterdir()] == ["clones"]
