"""Two booths in one scene: clones come over a link of their own, are looked at, and are gone with it."""

from __future__ import annotations

import json
import shutil
import threading
import time
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from functools import partial
from pathlib import Path

import pytest
from websockets.exceptions import ConnectionClosed, InvalidStatus
from websockets.sync.client import connect

from cloner.crowd.clones.people import Found
from cloner.errors import ClonerError
from cloner.scenes.served.lending import MOST_LENT, accept_lent_clones, lend_folder
from cloner.scenes.served.lent import FILES, offer_facts, parse_clone
from cloner.scenes.served.living import RunningScene
from cloner.scenes.served.newcomers import Newcomer, make_newcomer
from cloner.scenes.served.serving import HOST, served
from kit.living import finished, hello_of, shown

#: People of the scenario of `kit.living`.
PARTS = 5
pytestmark = [pytest.mark.gl, pytest.mark.slow]


def wait(what: Callable[[], object], seconds: float = 60.0) -> None:
    end = time.monotonic() + seconds
    while not what():
        assert time.monotonic() < end, "it did not happen"
        time.sleep(0.05)


@pytest.fixture
def scene(built: Path, hot: Path) -> RunningScene:
    return shown(built, hot)[0]


@pytest.fixture
def address(scene: RunningScene) -> Iterator[str]:
    with accept_lent_clones(scene, HOST) as place:
        yield place


@pytest.fixture
def theirs(tmp_path: Path) -> Path:
    (tmp_path / "theirs").mkdir()
    return tmp_path / "theirs"


@pytest.fixture(scope="module")
def newcomer(built: Path, tmp_path_factory: pytest.TempPathFactory) -> tuple[Newcomer, dict]:
    folder = tmp_path_factory.mktemp("booth")
    living = shown(built, folder)[0]
    return make_newcomer(Found("eve", finished(folder, "eve")), offer_facts(living.facts), living.body), living.facts


@contextmanager
def lending(address: str, folder: Path) -> Iterator[list[str]]:
    said: list[str] = []
    over = threading.Event()
    thread = threading.Thread(target=partial(lend_folder, address, folder, said.append, over.is_set))
    thread.start()
    try:
        yield said
    finally:
        over.set()
        thread.join(60)


def there(scene: RunningScene) -> list[dict]:
    return list(hello_of(scene)["newcomers"])


def test_another_booths_clone_is_in_the_scene_as_long_as_its_link(
    scene: RunningScene, address: str, theirs: Path
) -> None:
    with lending(address, theirs) as said:
        finished(theirs, "eve")
        wait(lambda: there(scene))
        [one] = there(scene)
        assert one["who"] >= 0
        assert "eve" not in json.dumps(one), "the other booth is told no name"
        assert scene.file(one["key"], "atlas.webp")
        wait(lambda: "eve is in the scene" in said)
        shutil.rmtree(theirs / "eve")
        wait(lambda: not there(scene))
        finished(theirs, "ada")
        wait(lambda: there(scene))
    wait(lambda: not there(scene))


def test_who_has_recorded_no_consent_is_not_lent(scene: RunningScene, address: str, theirs: Path) -> None:
    finished(theirs, "shy", consent=False)
    with lending(address, theirs) as said:
        wait(lambda: any(one.startswith("not lent") for one in said))
    assert not there(scene)


def test_nobody_lends_without_the_token_and_no_page_does(scene: RunningScene, address: str, theirs: Path) -> None:
    with served(scene, bool) as url:
        page_token = url.rstrip("/").rsplit("/", 1)[1]
        for wrong in ("guess", "", page_token):
            with pytest.raises(InvalidStatus):
                connect(address.rsplit("/", 1)[0] + "/" + wrong, proxy=None)
    with pytest.raises(InvalidStatus):
        connect(address, origin="http://evil.example", proxy=None)
    with pytest.raises(ClonerError, match="nobody lets us in there"):
        lend_folder(address + "x", theirs, print)
    for far in ("ws://8.8.8.8:1/x", "http://127.0.0.1:1/x", "ws://evil.example:1/x", "ws://127.0.0.1/x", ""):
        with pytest.raises(ClonerError, match="network of one's own"):
            lend_folder(far, theirs, print)
    with pytest.raises(ClonerError, match="nobody answers there"):
        lend_folder("ws://127.0.0.1:9/x", theirs, print)
    with pytest.raises(ClonerError, match="no such folder"):
        lend_folder(address, theirs / "none", print)


def test_a_link_that_sends_no_clone_is_told_or_closed(scene: RunningScene, address: str, newcomer) -> None:
    own, _ = newcomer
    sizes = [len(own.files[name]) for name in FILES]
    data = b"".join(own.files[name] for name in FILES)
    good = {"number": 1, "row": dict(own.row), "sizes": sizes}
    for said in ("", "{}", "[1]", "nan", '{"number": true, "gone": 1}', json.dumps({**good, "more": 1}), b"\0"):
        with connect(address, proxy=None) as link:
            assert "wanted" in json.loads(link.recv(timeout=10))
            link.send(said)
            with pytest.raises(ConnectionClosed):
                link.recv(timeout=10)
    with connect(address, proxy=None) as link:
        link.recv(timeout=10)
        for number, (told, files) in enumerate(
            [({**good, "sizes": [*sizes[:-1], 3]}, data), (good, data[:-9]), ({**good, "row": {}}, data),
             (good, bytes(len(data))), ({**good, "row": {**good["row"], "stature_m": 9.0}}, data)]
        ):  # fmt: skip
            link.send(json.dumps({**told, "number": number}))
            link.send(files)
            assert json.loads(link.recv(timeout=10))["error"]
        assert not there(scene)
        assert PARTS < MOST_LENT
        for number in range(100, 100 + PARTS + 1):
            link.send(json.dumps({**good, "number": number}))
            link.send(data)
            error = json.loads(link.recv(timeout=10))["error"]
            assert ("nobody's part is free" in error) == (number == 100 + PARTS)
        link.send(json.dumps({"number": 100, "gone": True}))
        wait(lambda: len(there(scene)) == PARTS - 1)
    wait(lambda: not there(scene))


@pytest.mark.parametrize("name", ["atlas.webp", "shell.webp", "numbers.bin"])
def test_files_of_another_kind_are_named(scene: RunningScene, newcomer, name: str) -> None:
    own, facts = newcomer
    assert parse_clone(own.row, own.files, facts, scene.body).touches.shape == own.touches.shape
    with pytest.raises(ClonerError, match=name.replace(".", r"\.")):
        parse_clone(own.row, {**own.files, name: own.files["codes.webp"][:40]}, facts, scene.body)
