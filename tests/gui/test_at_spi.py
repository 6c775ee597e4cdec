"""A screen reader's own way to the window: session bus, accessibility bus, X server. Skipped where one lacks."""

import json
import os
import shutil
import subprocess
import sys
from pathlib import Path

import pytest

from .test_x_server import display  # noqa: F401  (a fixture)
from .test_x_server import pytestmark as needs_x

BUS = [
    Path(place) / "at-spi-bus-launcher" for place in ("/usr/libexec", "/usr/lib/at-spi2-core", "/usr/libexec/at-spi2")
]
#: Roles of what is pressed, ticked, typed into or dragged.
DOES = {"push button", "button", "toggle button", "check box", "combo box", "text", "spin box", "slider", "button menu"}
#: Of each page what an operator cannot do without.
ON_PAGES = (
    ("New visitor", "Height in centimetres", "Agrees: on to the photos"),
    ("Add photos…", "Webcam…", "Camera folder…", "What to do with Face, side", "Clone"),
    ("Next doubtful point", "Point before", "Back to proposal", "Whole photo"),
    ("Cover", "Whole person", "Stand", "Photo texture"),
    ("Copy to a folder…", "GLB: games, web, telephone", "Page for telephones on this network", "Next visitor"),
)
pytestmark = [
    *needs_x,
    pytest.mark.skipif(not any(path.exists() for path in BUS), reason="at-spi2-core is not installed"),
    pytest.mark.skipif(shutil.which("dbus-run-session") is None, reason="dbus-run-session is not installed"),
    pytest.mark.skipif(shutil.which("gdbus") is None, reason="gdbus is not installed"),
]


def test_a_screen_reader_finds_the_controls_of_every_page(tmp_path, display):  # noqa: F811
    event = tmp_path / "fair"
    event.mkdir()
    environment = {**os.environ, "DISPLAY": f":{display}", "PYTHONPATH": os.pathsep.join(sys.path)}
    command = ["dbus-run-session", "--", sys.executable, "-m", "kit.at_spi", str(event)]
    done = subprocess.run(command, env=environment, capture_output=True, text=True, timeout=400, check=False)
    assert done.returncode == 0, done.stderr[-2000:]
    pages = [{(role, name) for role, name in page} for page in json.loads(done.stdout.splitlines()[-1])]
    found = pages[0]
    names = {name for _, name in found}
    assert {"Name or number of the visitor", "Language of the consent", "The visitor agrees"} <= names
    pressed = {"push button", "button", "toggle button", "check box", "menu item"}
    assert pressed & roles_of(found, "Step 1: Visitor"), "one that stays pressed"
    assert pressed & roles_of(found, "New visitor")
    assert "text" in roles_of(found, "Name or number of the visitor")
    assert "check box" in roles_of(found, "The visitor agrees")
    assert "combo box" in roles_of(found, "English"), "Qt calls a list by what is chosen; its label names it"
    assert "label" in roles_of(found, "Language of the consent")
    for page, names in zip(pages, ON_PAGES, strict=True):
        for name in names:
            assert DOES & roles_of(page, name), (name, sorted(page))
        assert not [name for role, name in page if role in DOES and "&" in name], "nobody says an ampersand"


def roles_of(found: set[tuple[str, str]], name: str) -> set[str]:
    return {role for role, own in found if own == name}
