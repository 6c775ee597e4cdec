"""A native library's terminal output, sent to the log."""

from __future__ import annotations

import logging
import os
import sys
import tempfile
from collections.abc import Iterator
from contextlib import contextmanager

log = logging.getLogger(__name__)


@contextmanager
def chatter_logged() -> Iterator[None]:
    """Send what a native library writes to the terminal into the log instead: greetings as DEBUG, the rest as WARNING.

    LiteRT 2.3 greets on file descriptor 2 and heeds none of its own settings there (tried: TF_CPP_MIN_LOG_LEVEL,
    GLOG_minloglevel); Python's ``redirect_stderr`` does not reach it.
    """
    try:
        kept = os.dup(2)
    except OSError:  # a program without a terminal has no such file
        yield
        return
    sys.stderr.flush()
    with tempfile.TemporaryFile() as caught:
        try:
            os.dup2(caught.fileno(), 2)
            yield
        finally:
            os.dup2(kept, 2)
            os.close(kept)
            caught.seek(0)
            for line in caught.read().decode(errors="replace").splitlines():
                log.log(logging.DEBUG if line.startswith("INFO:") else logging.WARNING, "%s", line)
