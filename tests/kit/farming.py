"""Stand-ins for cloning that worker processes can import: fast, and bad on demand."""

from __future__ import annotations

import os
import time
from pathlib import Path

from cloner.batch import BatchOptions
from cloner.farm import watchdog
from cloner.project.atomic import result_folder
from cloner.project.manifest import Visitor
from cloner.records.batches import CLONED, BatchRow


def pretend(visitor: Visitor, out: Path, options: BatchOptions) -> BatchRow:
    """Write a result; those called "crash" kill their worker, "once" only the first time, "hang" never ends."""
    with watchdog(options.timeout_s):
        name = visitor.identifier
        tried = out / f".{name}.tried"
        first = not tried.exists()
        out.mkdir(parents=True, exist_ok=True)
        tried.touch()
        if name.startswith("crash") or (name.startswith("once") and first):
            os._exit(9)
        if name.startswith("hang"):
            time.sleep(600)
        with result_folder(out, name) as folder:
            (folder / "report.json").write_text("{}")
        return BatchRow(name, CLONED, 0.0, 0, f"by {os.getpid()}")
