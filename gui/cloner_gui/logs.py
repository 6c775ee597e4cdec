"""The log file for the maintainer: in the event's folder, short, and without names, faces or home paths."""

from __future__ import annotations

import logging
from logging.handlers import RotatingFileHandler
from pathlib import Path
from typing import Final

from cloner.booth.events.event import LOG_FILE

_BYTES: Final = 500_000
_OLD: Final = 2


class PathShortener(logging.Formatter):
    """Removes the path to the home folder and the event from logged paths."""

    def __init__(self, *private: Path) -> None:
        super().__init__("%(asctime)s %(levelname)s %(name)s: %(message)s")
        self._private = sorted({str(path) for path in private if str(path) != path.anchor}, key=len, reverse=True)

    def format(self, record: logging.LogRecord) -> str:
        """Return the line, home and event folders taken out, also of traces."""
        text = super().format(record)
        for path in self._private:
            text = text.replace(path, "…")
        return text


def log_to(folder: Path) -> logging.Handler:
    """Write the log into an event's folder from now on, instead of the previous one."""
    for old in [one for one in logging.getLogger().handlers if isinstance(one, RotatingFileHandler)]:
        logging.getLogger().removeHandler(old)
        old.close()
    handler = RotatingFileHandler(folder / LOG_FILE, maxBytes=_BYTES, backupCount=_OLD, encoding="utf-8", delay=True)
    handler.setFormatter(PathShortener(Path.home(), folder.resolve(), folder))
    handler.setLevel(logging.INFO)
    logging.getLogger().addHandler(handler)
    logging.getLogger("cloner").setLevel(logging.INFO)
    logging.getLogger("cloner_gui").setLevel(logging.INFO)
    return handler
