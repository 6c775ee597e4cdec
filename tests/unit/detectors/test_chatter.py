"""What a native library writes to the terminal."""

from __future__ import annotations

import logging
import os

from cloner.detectors.nets.chatter import chatter_logged
from cloner.detectors.nets.litert import _net


def test_a_new_net_writes_nothing_to_the_terminal(capfd):
    _net.cache_clear()
    _net("face_landmark.tflite")
    assert capfd.readouterr().err == ""


def test_greetings_are_debug_and_complaints_warnings(capfd, caplog):
    with caplog.at_level(logging.DEBUG, logger="cloner.detectors.nets.chatter"), chatter_logged():
        os.write(2, b"INFO: hello\nERROR: no such tensor\n")
    os.write(2, b"after\n")
    assert capfd.readouterr().err == "after\n"
    assert [(record.levelname, record.message) for record in caplog.records] == [
        ("DEBUG", "INFO: hello"),
        ("WARNING", "ERROR: no such tensor"),
    ]
