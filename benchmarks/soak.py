"""A long night with everything against it: killed workers, killed batches, a full disk, times that jump.

    python benchmarks/soak.py FOLDER --photos PEOPLE --visitors 200 --workers 2

PEOPLE holds one folder of photos a visitor (any; a generator of people gives as many as wanted). They are copied, at
most ``--longest-px`` long, and cloned in peace once. Then everybody again while a random worker is killed every
``--kill-every`` seconds, the whole batch ``--parents`` times, the disk is filled once (where this user may mount one of
its own) and the files' times are set to 1971 and 2100. At the end nobody may be lost, no byte differ, nothing be
left over, and a worker's memory in the last quarter may be 1.05 times that of the first.

Prints what it found, writes FOLDER/soak.json, and ends with 1 where a bar is missed. Linux only: it reads /proc. A soak
that was itself interrupted goes on where it was, with what was found in peace and the results that are there.
"""

from __future__ import annotations

import argparse
import json
import os
import random
import shutil
import subprocess
import sys
import threading
import time
from pathlib import Path

from batch_visitors import Watched, digests, memory, statuses, watched
from PIL import Image, ImageOps

VIEWS = ("body_front", "body_side", "body_back", "face_front", "face_side")
LEVEL = 1.05
FULL_S = 10.0  # taste: a few visitors meet the full disk


def copied(people: Path, photos: Path, count: int, longest_px: int) -> None:
    """Copy the photos of so many visitors, made smaller."""
    folders = sorted({path.parent for view in VIEWS for path in people.rglob(f"{view}.*")})
    if len(folders) < count:
        sys.exit(f"{people} holds {len(folders)} visitors, {count} are wanted")
    for number, folder in enumerate(folders[:count]):
        place = photos / f"visitor-{number:03}"
        place.mkdir(parents=True, exist_ok=True)
        for path in [path for path in sorted(folder.iterdir()) if path.stem in VIEWS]:
            with Image.open(path) as image:
                small = ImageOps.exif_transpose(image).convert("RGB")
                small.thumbnail((longest_px, longest_px))
                small.save(place / f"{path.stem}.jpg", quality=92)
        if (folder / "person.toml").is_file():
            shutil.copy(folder / "person.toml", place)


def own_disk(out: Path, mib: int) -> bool:
    """Mount a disk of its own for the results; return whether that is allowed here, or was done before."""
    out.mkdir(parents=True, exist_ok=True)
    if out.is_mount():
        return True
    done = subprocess.run(
        ["mount", "-t", "tmpfs", "-o", f"size={mib}m", "soak", str(out)], capture_output=True, check=False
    )
    return done.returncode == 0


def fill_once(out: Path, after_s: float, stop: threading.Event) -> None:
    """Fill the disk to the last byte for a while."""
    if stop.wait(after_s):
        return
    ballast = out / "ballast"
    try:
        with ballast.open("wb", buffering=0) as stream:
            while True:
                stream.write(bytes(1 << 16))
    except OSError:
        pass
    stop.wait(FULL_S)
    ballast.unlink(missing_ok=True)


def jump(*folders: Path) -> None:
    """Give every file a time long ago or long hence, as a clock that was wrong would have."""
    rng = random.Random(3)
    for path in [path for folder in folders for path in folder.rglob("*") if path.is_file()]:
        moment = rng.choice((31_536_000, 4_102_444_800))  # 1971 and 2100
        os.utime(path, (moment, moment))


def under_fire(
    command: list[str], chosen: argparse.Namespace, calm_s: float, failed: int, out: Path, photos: Path
) -> list[Watched]:
    """Run the batch until everybody is cloned, with everything against it; return every run."""
    runs: list[Watched] = []
    mounted = chosen.disk_mib > 0 and own_disk(out, chosen.disk_mib)
    print("a disk of its own is filled once" if mounted else "no disk of its own could be mounted: it is not filled")
    stop = threading.Event()
    filler = threading.Thread(target=fill_once, args=(out, 0.3 * calm_s, stop), daemon=True)
    if mounted:
        filler.start()
    for number in range(chosen.parents):
        share = calm_s * 0.5 * (number + 1) / chosen.parents
        runs.append(watched(command, meddle=chosen.kill_every, end_after=max(share, 15.0), seed=number))
        jump(photos, out)
        print(f"batch {number + 1} killed after {runs[-1].seconds:.0f} s; the files' times jump", flush=True)
    for number in range(10):
        runs.append(watched(command, meddle=chosen.kill_every, seed=100 + number))
        if statuses(out)["failed"] <= failed:
            break
    stop.set()
    if mounted:
        filler.join()
    return runs


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("folder", type=Path)
    parser.add_argument("--photos", type=Path, required=True, help="one folder of photos a visitor, at any depth")
    parser.add_argument("--visitors", type=int, default=200)
    parser.add_argument("--workers", type=int, default=2)
    parser.add_argument("--longest-px", type=int, default=1200)
    parser.add_argument("--kill-every", type=float, default=12.0)
    parser.add_argument("--parents", type=int, default=3, help="how often the whole batch is killed")
    parser.add_argument("--disk-mib", type=int, default=8192, help="size of the disk that is filled once; 0: none")
    chosen = parser.parse_args()
    photos, calm_out, out = (chosen.folder / name for name in ("photos", "calm", "fire"))
    batch = ["batch", str(photos), "--workers", str(chosen.workers), "--size", "512", "--format", "glb"]
    if not (chosen.folder / "calm.json").is_file():
        for folder in (photos, calm_out, out):
            shutil.rmtree(folder, ignore_errors=True)
        copied(chosen.photos, photos, chosen.visitors, chosen.longest_px)
        run = watched([*batch, "--out", str(calm_out)])
        note = {"seconds": run.seconds, "mib": memory(run.samples, calm_out), **statuses(calm_out)}
        (chosen.folder / "calm.json").write_text(json.dumps(note, indent=1) + "\n")
    calm = json.loads((chosen.folder / "calm.json").read_text())
    first, last = calm["mib"]
    wanted, failed_in_peace = digests(calm_out), calm["failed"]
    print(f"in peace: {calm}", flush=True)
    start = time.monotonic()
    runs = under_fire(
        [*batch, "--out", str(out), "--retries", "1000"], chosen, calm["seconds"], failed_in_peace, out, photos
    )
    found = digests(out)
    told = {
        "visitors": chosen.visitors, "workers": chosen.workers, "kill_every_s": chosen.kill_every,
        "batches": len(runs), "fire_seconds": round(time.monotonic() - start), "failed_in_peace": failed_in_peace,
        "lost": sorted(set(wanted) - set(found)),
        "differ": sorted(name for name in found if found[name] != wanted.get(name)),
        "left": sorted(path.name for path in out.iterdir() if path.name.startswith(".")),
        "first_quarter_mib": round(first), "last_quarter_mib": round(last),
    }  # fmt: skip
    (chosen.folder / "soak.json").write_text(json.dumps(told, indent=1) + "\n")
    print(json.dumps(told, indent=1))
    subprocess.run(["umount", str(out)], capture_output=True, check=False)
    if told["lost"] or told["differ"] or told["left"] or last > LEVEL * first:
        sys.exit(1)


if __name__ == "__main__":
    main()
