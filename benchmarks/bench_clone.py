"""Time and memory of one clone per stage, beside the floor of the same process.

Stages that run abreast count each other's CPU seconds, so stages do not add up to the clone.

The floor is what no faster code could leave out (``cloner/evaluate/floor.py``): decoding the photos, asking the nets,
encoding every picture that is delivered.
Run with ``make bench``; give a folder of photos to clone another person.
"""

from __future__ import annotations

import argparse
import json
import tempfile
import time
from collections.abc import Callable
from pathlib import Path
from typing import Any

from cloner.cloning import clone_folder
from cloner.evaluate.floor import ask_nets, encode_pictures
from cloner.making import DEFAULT_TEXTURE_SIZE
from cloner.memory import peak_mib
from cloner.project.folder import load_photos

SAMPLE = Path(__file__).resolve().parents[1] / "samples" / "anna" / "plain"


def timed(work: Callable[[], Any]) -> tuple[Any, float, float]:
    """Return the result, wall seconds and CPU seconds."""
    wall, cpu = time.perf_counter(), time.process_time()
    value = work()
    return value, time.perf_counter() - wall, time.process_time() - cpu


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("photos", nargs="?", type=Path, default=SAMPLE)
    parser.add_argument("--texture-size", type=int, default=DEFAULT_TEXTURE_SIZE)
    parser.add_argument("--json", action="store_true")
    chosen = parser.parse_args()

    photos, decode_s, decode_cpu = timed(lambda: load_photos(chosen.photos))
    _, nets_s, nets_cpu = timed(lambda: ask_nets(photos))
    floor_mib = peak_mib()
    begun: dict[str, float] = {}

    def mark(step: str, fraction: float) -> None:
        begun.setdefault(step, time.perf_counter())

    with tempfile.TemporaryDirectory() as out:
        outcome, clone_s, clone_cpu = timed(
            lambda: clone_folder(
                chosen.photos, Path(out), identifier="bench", texture_size=chosen.texture_size, progress=mark
            )
        )
        _, encode_s, encode_cpu = timed(lambda: encode_pictures(outcome.values["clone"], outcome.folder))

    floor_s, floor_cpu = decode_s + nets_s + encode_s, decode_cpu + nets_cpu + encode_cpu
    stages = outcome.report["timings"]["stages"]
    stages_s = begun["previews"] - begun[stages[0]["stage"]]
    rows = [
        {"part": "floor: decode photos", "seconds": decode_s, "cpu_seconds": decode_cpu},
        {"part": "floor: nets", "seconds": nets_s, "cpu_seconds": nets_cpu},
        {"part": "floor: encode pictures", "seconds": encode_s, "cpu_seconds": encode_cpu},
        {"part": "floor", "seconds": floor_s, "cpu_seconds": floor_cpu, "peak_mib": floor_mib},
        *({"part": stage.pop("stage"), **stage} for stage in stages),
        {"part": "all stages", "seconds": stages_s},
        {"part": "read, export, previews, report", "seconds": clone_s - stages_s},
        {"part": "clone", "seconds": clone_s, "cpu_seconds": clone_cpu, "peak_mib": outcome.report["peak_mib"]},
    ]
    if chosen.json:
        print(json.dumps(rows, indent=1))
        return
    print(f"{'part':32} {'s':>7} {'CPU s':>7} {'peak MiB':>9} {'of floor':>9}")
    for row in rows:
        cpu = f"{row['cpu_seconds']:7.2f}" if "cpu_seconds" in row else " " * 7
        peak = f"{row['peak_mib']:9.0f}" if "peak_mib" in row else " " * 9
        print(f"{row['part']:32} {row['seconds']:7.2f} {cpu} {peak} {row['seconds'] / floor_s:8.2f}x")


if __name__ == "__main__":
    main()
