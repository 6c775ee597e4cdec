"""How long a clone's files take, and how large they are.

    python benchmarks/exports.py RESULT [--format glb,wrl,...]

CPU seconds of one process, first round included (it reads the generic human); the bar is 6 s for all formats together.
"""

from __future__ import annotations

import argparse
import sys
import tempfile
import time
from pathlib import Path

from cloner.exporters.table import EXPORTERS
from cloner.picture import load_clone_at


def main() -> None:
    """Print the table."""
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("result", type=Path)
    parser.add_argument("--format", default=",".join(EXPORTERS))
    asked = parser.parse_args()
    clone, total = load_clone_at(asked.result), 0.0
    sys.stdout.write("| format | CPU s | KiB | files |\n" + "| --- " * 4 + "|\n")
    with tempfile.TemporaryDirectory() as scratch:
        for name in asked.format.split(","):
            start = time.process_time()
            files = EXPORTERS.get(name)(clone, Path(scratch) / name)
            spent = time.process_time() - start
            total += spent
            size = sum(path.stat().st_size for path in files) / 1024.0
            sys.stdout.write(f"| {name} | {spent:.2f} | {size:.0f} | {len(files)} |\n")
    sys.stdout.write(f"| all | {total:.2f} | | |\n")


if __name__ == "__main__":
    main()
