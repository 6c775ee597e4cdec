"""A night of visitors: rate, memory, and what is left when workers are killed.

    python benchmarks/batch_visitors.py FOLDER --visitors 200 --workers 2

Paints random dressed people (one small photo each, kept in FOLDER/photos), then

1. clones a few of them one by one, each in a process of its own, as a script without ``cloner batch`` would;
2. clones all of them in one batch and watches the workers' memory;
3. clones all of them again, killing a random worker every few seconds and, once, the whole batch, which is then started
   again; every output must be the same byte for byte.

Prints what it found and writes it to FOLDER/night.json. Linux only: it reads /proc.
"""

from __future__ import annotations

import argparse
import hashlib
import json
import os
import random
import shutil
import signal
import subprocess
import sys
import threading
import time
from collections.abc import Sequence
from dataclasses import dataclass, field
from pathlib import Path

from PIL import Image

ROOT = Path(__file__).resolve().parents[1]
SIZE_PX = (600, 900)
TEXTURE_PX = 512
SAMPLE_S = 0.25
ENVIRONMENT = {
    **os.environ,
    "PYTHONPATH": os.pathsep.join(str(ROOT / name) for name in ("", "gui", "generic_models")),
    "OMP_NUM_THREADS": "1",
}
COMMAND = (sys.executable, "-c", "from cloner.cli import main; main()")


def paint(folder: Path, count: int) -> None:
    """Paint the visitors that are not there yet."""
    sys.path[:0] = [str(ROOT / "generic_models" / "build"), str(ROOT), str(ROOT / "generic_models")]
    from painted_people import TIGHTNESSES, photograph_once

    for number in range(count):
        path = folder / f"visitor-{number:03}" / "body_front.jpg"
        if path.exists():
            continue
        path.parent.mkdir(parents=True, exist_ok=True)
        shot, body, _ = photograph_once(
            5000 + number, 0.0, tightness=TIGHTNESSES[number % 3], background="plain", size_px=SIZE_PX
        )
        (path.parent / "person.toml").write_text(f"height_cm = {100 * body.stature_m:.1f}\n")
        Image.fromarray(shot.rgb).save(path, quality=92)


@dataclass
class Watched:
    """What a command took, and its children's memory over time."""

    seconds: float = 0.0
    cpu_seconds: float = 0.0
    code: int = 0
    samples: list[tuple[float, float]] = field(default_factory=list)  # seconds since the epoch, peak MiB of the largest


def watched(arguments: Sequence[str], *, meddle: float = 0.0, end_after: float = 0.0, seed: int = 0) -> Watched:
    """Run ``cloner ARGUMENTS``; kill a random child every ``meddle`` seconds, and everything after ``end_after``."""
    found, start, rng = Watched(), time.time(), random.Random(seed)
    process = subprocess.Popen(
        [*COMMAND, *arguments], env=ENVIRONMENT, stdout=subprocess.DEVNULL, stderr=subprocess.PIPE, text=True,
        start_new_session=True,
    )  # fmt: skip
    said: list[str] = []
    assert process.stderr is not None
    reader = threading.Thread(target=lambda: said.extend(process.stderr or ()), daemon=True)
    reader.start()
    last = start
    while (gone := os.wait4(process.pid, os.WNOHANG))[0] == 0:
        workers = [pid for pid in children(process.pid) if rss_mib(pid) > 100.0]
        found.samples.append((time.time(), max(map(peak_mib, workers), default=0.0)))
        if meddle and workers and time.time() - last > meddle:
            os.kill(rng.choice(workers), signal.SIGKILL)
            last = time.time()
        if end_after and time.time() - start > end_after:
            os.killpg(process.pid, signal.SIGKILL)
            end_after = 0.0
        time.sleep(SAMPLE_S)
    found.seconds, found.code = time.time() - start, os.waitstatus_to_exitcode(gone[1])
    found.cpu_seconds = gone[2].ru_utime + gone[2].ru_stime
    if found.code not in (0, -signal.SIGKILL):
        print("".join(said[-15:]))
    return found


def children(pid: int) -> list[int]:
    try:
        own = Path(f"/proc/{pid}/task/{pid}/children").read_text().split()
        tasks = Path(f"/proc/{pid}/task").iterdir()
        every = {int(one) for task in tasks for one in (task / "children").read_text().split()} | {int(p) for p in own}
    except OSError:
        return []
    return [*every, *(inner for one in every for inner in children(one))]


def rss_mib(pid: int) -> float:
    try:
        pages = int(Path(f"/proc/{pid}/statm").read_text().split()[1])
    except (OSError, IndexError):
        return 0.0
    return pages * os.sysconf("SC_PAGE_SIZE") / 2**20


def peak_mib(pid: int) -> float:
    """Return the most memory a process has held since it was last asked: the kernel's own mark, which is then reset."""
    try:
        lines = Path(f"/proc/{pid}/status").read_text().splitlines()
        Path(f"/proc/{pid}/clear_refs").write_text("5")
        return next(int(line.split()[1]) for line in lines if line.startswith("VmHWM:")) / 1024.0
    except (OSError, StopIteration):
        return 0.0


def digests(out: Path) -> dict[str, str]:
    """Return the sha256 of every file of every result; reports hold times, so they are left out."""
    return {
        path.relative_to(out).as_posix(): hashlib.sha256(path.read_bytes()).hexdigest()
        for path in sorted(out.glob("visitor-*/**/*"))
        if path.is_file() and not path.name.startswith("report.")
    }


def memory(samples: Sequence[tuple[float, float]], out: Path) -> tuple[float, float]:
    """Return the largest worker's memory, MiB, while the first quarter of the visitors was cloned, and the last."""
    done = sorted(path.stat().st_mtime for path in out.glob("visitor-*/report.json"))
    quarter = max(len(done) // 4, 1)
    first = [mib for at, mib in samples if at <= done[quarter - 1]]
    last = [mib for at, mib in samples if done[-quarter - 1] <= at <= done[-1]]
    return max(first, default=0.0), max(last, default=0.0)


def statuses(out: Path) -> dict[str, int]:
    rows = json.loads((out / "batch.json").read_text())["rows"]
    return {status: sum(row["status"] == status for row in rows) for status in ("cloned", "skipped", "failed")}


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("folder", type=Path)
    parser.add_argument("--visitors", type=int, default=200)
    parser.add_argument("--workers", type=int, default=2)
    parser.add_argument("--singles", type=int, default=4, help="how many are cloned one by one")
    parser.add_argument("--kill-every", type=float, help="seconds; by default a visitor's time; 0: no killing")
    chosen = parser.parse_args()
    photos, told = chosen.folder / "photos", {"visitors": chosen.visitors, "workers": chosen.workers}
    paint(photos, chosen.visitors)
    for path in sorted(photos.iterdir())[chosen.visitors :]:
        sys.exit(f"{path} is one visitor more than asked for: use another folder")
    options = ("--size", str(TEXTURE_PX), "--format", "glb")
    for name in ("single", "calm", "killed"):
        shutil.rmtree(chosen.folder / name, ignore_errors=True)

    people = sorted(photos.iterdir())[: chosen.singles]
    alone = [watched(["clone", str(one), "--out", str(chosen.folder / "single"), *options]) for one in people]
    each_s = sum(one.seconds for one in alone) / max(len(alone), 1)
    told |= {"single_seconds": each_s, "single_cpu_seconds": sum(one.cpu_seconds for one in alone) / len(alone)}
    print(
        f"alone: {each_s:.1f} s, {told['single_cpu_seconds']:.1f} CPU s each; {3600 / each_s:.0f} an hour", flush=True
    )

    batch = ("batch", str(photos), "--workers", str(chosen.workers), *options)
    calm_out = chosen.folder / "calm"
    calm = watched([*batch, "--out", str(calm_out)])
    first, last = memory(calm.samples, calm_out)
    rate = 3600 * chosen.visitors / calm.seconds
    told |= {
        "batch_seconds": calm.seconds, "batch_cpu_seconds": calm.cpu_seconds, "an_hour": rate,
        "ratio": rate * each_s / 3600, "first_quarter_mib": first, "last_quarter_mib": last, **statuses(calm_out),
    }  # fmt: skip
    print(f"batch: {calm.seconds:.0f} s, {calm.cpu_seconds / chosen.visitors:.1f} CPU s each; {rate:.0f} an hour, "
          f"{told['ratio']:.2f} times as fast; {statuses(calm_out)}")  # fmt: skip
    print(f"memory of the largest worker: {first:.0f} MiB in the first quarter, {last:.0f} in the last", flush=True)
    wanted = digests(calm_out)
    same = all(wanted.get(name) == digest for name, digest in digests(chosen.folder / "single").items())
    told["alone_is_the_same"] = same
    print("cloned alone: " + ("the same bytes" if same else "OTHER BYTES"))
    if chosen.kill_every is None:
        chosen.kill_every = chosen.workers * calm.seconds / chosen.visitors
    if chosen.kill_every:
        told |= killed(chosen, batch, calm.seconds, wanted)
    (chosen.folder / "night.json").write_text(json.dumps(told, indent=1) + "\n")


def killed(
    chosen: argparse.Namespace, batch: Sequence[str], calm_s: float, wanted: dict[str, str]
) -> dict[str, object]:
    """Clone everybody once more under fire and return how that went."""
    out = chosen.folder / "killed"
    command = [*batch, "--out", str(out), "--retries", "1000"]
    shot = watched(command, meddle=chosen.kill_every, end_after=0.4 * calm_s, seed=1)
    done = len(list(out.glob("visitor-*/report.json")))
    again = watched(command, meddle=chosen.kill_every, seed=2)
    found = digests(out)
    lost = sorted(set(wanted) - set(found))
    differ = sorted(name for name in found if found[name] != wanted.get(name))
    rests = sorted(path.name for path in out.iterdir() if path.name.startswith("."))
    print(f"under fire: all killed after {shot.seconds:.0f} s and {done} visitors, then {again.seconds:.0f} s more")
    print(f"{statuses(out)}; {len(lost)} files lost, {len(differ)} differ, {len(rests)} rests {rests[:5]}")
    return {"kill_every": chosen.kill_every, "killed_code": again.code, "lost": lost, "differ": differ, "rests": rests}


if __name__ == "__main__":
    main()
