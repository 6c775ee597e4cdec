"""How good is the head? ``python benchmarks/head.py --heads 30 [--jobs 1] [--resume FOLDER] [--page]``.

Random heads, every second one bent out of the generic's family, are photographed from the front and one side (turned up
to 10 degrees, 0.6 to 2 m away, three lights), fitted by the product's own stages and scored with the rulers of
docs/method, with proposed and with true features. Every finished head is one JSON and one .npz in the folder, so a kill
loses nothing; ``--page`` turns what is there into ``docs/head_benchmark.md``. ``--foreign FOLDER`` scores a head from
outside the family (shared/foreign/ict; not ours to ship). ``--family ict`` draws the heads from the scan-based family
in ``--scans`` instead; the page has a column a family.
"""

from __future__ import annotations

import argparse
import multiprocessing
import sys
import traceback
from concurrent.futures import ProcessPoolExecutor, as_completed
from pathlib import Path
from typing import Any

import numpy as np
from body_people import write_json
from head_foreign import foreign_head
from head_page import write_page
from head_people import KnownHead, known_head
from head_scans import scan_known
from head_steps import measure_head

DEFAULT_FOLDER = Path("/tmp/cloner_head_benchmark")
SCANS = Path("shared/foreign/ict_family.npz")
FAMILIES = ("makehuman", "ict")


def one_head(seed: int, folder: Path, scans: Path | None) -> dict[str, Any]:
    """Score one random head; what goes wrong is written, not raised: one head must not end the run of all.

    ``scans`` is the file of the scan-based family when the head is to be one of it.
    """
    name = f"{seed:03d}_{'scan' if scans is not None else 'bent' if seed % 2 else 'family'}"
    try:
        return keep(known_head(seed, bent=bool(seed % 2)) if scans is None else scan_known(seed, scans), folder)
    except Exception:  # noqa: BLE001 - the batch loop tells it and goes on
        row = {"name": name, "error": traceback.format_exc()}
        write_json(folder / f"{name}.error.json", row)
        return row


def keep(known: KnownHead, folder: Path) -> dict[str, Any]:
    """Score one head and write its JSON, and what identification needs."""
    row, clones, measure = measure_head(known)
    folder.mkdir(parents=True, exist_ok=True)
    if clones:
        marks = {f"mark_{name}": place for name, place in measure.marks.items()}
        made = {f"clone_{name}": clone.astype(np.float32) for name, clone in clones.items()}
        np.savez_compressed(folder / f"{known.name}.npz", points=measure.points, **marks, **made)
    write_json(folder / f"{known.name}.json", row)
    return dict(row)


def told(row: dict[str, Any]) -> str:
    """Return one line about a finished head."""
    if "error" in row:
        return f"{row['name']}: {str(row['error']).strip().splitlines()[-1]}"
    last, first = row["steps"]["finished"], row["steps"]["generic"]
    turned = "".join(f", {view} yaw {deg:+.1f}" for view, deg in row["yaw_deg"].items())
    return (
        f"{row['name']}: {last['similarity_mm']:.2f} / {last['rigid_mm']:.2f}, generic {first['similarity_mm']:.2f}; "
        f"landmarks {last['landmarks_mean_mm']:.1f} / {last['landmarks_worst_mm']:.1f}; {row['seconds']['all']:.0f} s"
        + turned
    )


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--heads", type=int, default=0, help="random heads to have tried in the folder at the end")
    parser.add_argument("--first", type=int, default=0, metavar="SEED")
    parser.add_argument("--family", choices=FAMILIES, default="makehuman", help="whom the random heads are drawn from")
    parser.add_argument("--scans", type=Path, default=SCANS, metavar="FILE", help="the scan-based family")
    parser.add_argument("--foreign", type=Path, default=None, metavar="FOLDER")
    parser.add_argument("--jobs", type=int, default=1)
    parser.add_argument("--resume", type=Path, default=DEFAULT_FOLDER, metavar="FOLDER", help="where the results lie")
    parser.add_argument("--page", action="store_true", help="write docs/head_benchmark.md")
    chosen = parser.parse_args()
    folder: Path = chosen.resume
    scans = chosen.scans.resolve() if chosen.family == "ict" else None
    done = {int(path.name[:3]) for path in folder.glob("[0-9]*.json") if ("scan" in path.name) == (scans is not None)}
    todo = [seed for seed in range(chosen.first, chosen.first + chosen.heads) if seed not in done]
    with ProcessPoolExecutor(chosen.jobs, mp_context=multiprocessing.get_context("spawn")) as pool:
        for future in as_completed([pool.submit(one_head, seed, folder, scans) for seed in todo]):
            sys.stdout.write(f"{told(future.result())}\n")
            sys.stdout.flush()
    if chosen.foreign is not None:
        for name in ("input", "input_clutter"):
            sys.stdout.write(f"{told(keep(foreign_head(chosen.foreign, name), folder))}\n")
    if chosen.page:
        sys.stdout.write(f"{write_page(folder)}\n")


if __name__ == "__main__":
    main()
