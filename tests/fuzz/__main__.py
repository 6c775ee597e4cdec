"""Fuzz the parsers: ``python -m tests.fuzz --seconds 600 [--target bvh ...]``, or ``make fuzz``.

Where atheris is installed (``pip install ".[fuzz]"``) it leads the way by coverage; elsewhere files are changed
blindly. A finding is kept in ``tests/fuzz/findings/TARGET-DIGEST``; every test run tries those again.
"""

from __future__ import annotations

import argparse
import hashlib
import os
import random
import resource
import signal
import subprocess
import sys
import tempfile
import time
import traceback
from importlib.util import find_spec
from pathlib import Path
from types import FrameType

ROOT = Path(__file__).resolve().parents[2]
sys.path[:0] = [str(ROOT), str(ROOT / "tests"), str(ROOT / "gui"), str(ROOT / "generic_models")]
FINDINGS = Path(__file__).parent / "findings"
SLOWEST_S = 20
MOST_BYTES = 6 << 30  # of address space: a bomb ends in MemoryError


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--seconds", type=float, default=600.0, help="of all targets together")
    parser.add_argument("--target", action="append", help="all by default")
    parser.add_argument("--seed", type=int, default=int(time.time()))
    parser.add_argument("--guided", action="store_true", help="one target by atheris, in this process")
    options = parser.parse_args()
    from fuzz.targets import TARGETS

    names = options.target or list(TARGETS)
    resource.setrlimit(resource.RLIMIT_AS, (MOST_BYTES, MOST_BYTES))
    if options.guided:
        guided(names[0], int(options.seconds))
    tried = found = 0
    with_atheris = [
        name for name in names if find_spec("atheris") and name not in ("clone", "photo", "avif", "pack")
    ]  # those are C
    for name in with_atheris:
        found += in_child(name, options.seconds / len(names))
    blind_names = [name for name in names if name not in with_atheris]
    if blind_names:
        tried, worse = blind(blind_names, options.seconds * len(blind_names) / len(names), options.seed)
        found += worse
    print(f"{tried} blind tries, {len(with_atheris)} targets by coverage, {found} findings")
    sys.exit(found > 0)


def in_child(name: str, seconds: float) -> bool:
    """Run one target by coverage in a process of its own and return whether it found something."""
    command = [sys.executable, "-m", "tests.fuzz", "--guided", "--target", name, "--seconds", str(int(seconds))]
    done = subprocess.run(command, cwd=ROOT, capture_output=True, text=True, errors="replace", check=False)
    lines = [line for line in done.stderr.splitlines() if "DONE" in line or "Done" in line or "Error" in line]
    print(f"{name}: {'; '.join(lines[-2:])[:300]}", flush=True)
    if done.returncode:
        print(done.stdout[-3000:] + done.stderr[-3000:])
    return done.returncode != 0


def guided(name: str, seconds: int) -> None:
    """Let atheris find its way through one parser; does not return."""
    import atheris

    with atheris.instrument_imports(include=["tomllib", "json", "csv", "wave", "scipy.io.wavfile"]):
        import csv  # noqa: F401
        import tomllib  # noqa: F401
    from fuzz import targets

    for module in ("project.folder", "project.corrections", "project.manifest", "project.tape", "motion.captures.bvh",
                   "motion.face.faps", "motion.face.speech", "project.stamps", "crowd.packs.reading",
                   "crowd.packs.told"):  # fmt: skip
        for value in list(vars(sys.modules[f"cloner.{module}"]).values()):
            if getattr(value, "__module__", "") == f"cloner.{module}" and hasattr(value, "__code__"):
                atheris.instrument_func(value)
    folder = Path(tempfile.mkdtemp(prefix="cloner-fuzz-"))
    corpus = Path(tempfile.mkdtemp(prefix="cloner-fuzz-"))
    for number, seed in enumerate(targets.TARGETS[name].seeds()):
        (corpus / str(number)).write_bytes(seed)

    def one(data: bytes) -> None:
        tried(name, data, folder)

    arguments = [f"-max_total_time={seconds}", "-max_len=20000", f"-timeout={SLOWEST_S}", "-rss_limit_mb=6000"]
    atheris.Setup([sys.argv[0], str(corpus), *arguments, f"-artifact_prefix={FINDINGS}/{name}-"], one)
    FINDINGS.mkdir(exist_ok=True)
    atheris.Fuzz()


def blind(names: list[str], seconds: float, seed: int) -> tuple[int, int]:
    """Change good files blindly, all targets in turn, and return how many tries there were and how many findings."""
    from fuzz.mutate import mutated
    from fuzz.targets import TARGETS

    rng = random.Random(seed)
    print(f"seed {seed}", flush=True)
    signal.signal(signal.SIGALRM, too_slow)
    seeds = {name: TARGETS[name].seeds() for name in names}
    count = {name: 0 for name in names}
    kinds: set[str] = set()
    with tempfile.TemporaryDirectory(prefix="cloner-fuzz-") as folder:
        start = time.monotonic()
        while (spent := time.monotonic() - start) < seconds:
            name = names[int(len(names) * spent / seconds)]
            data = mutated(rng.choice(seeds[name]), rng, seeds[name])
            count[name] += 1
            try:
                tried(name, data, Path(folder))
            except Exception as error:  # that is what is looked for
                kind = f"{name} {type(error).__name__} {traceback.extract_tb(error.__traceback__)[-1].line}"
                if kind in kinds:
                    continue
                kinds.add(kind)
                FINDINGS.mkdir(exist_ok=True)
                path = FINDINGS / f"{name}-{hashlib.sha256(data).hexdigest()[:12]}"
                path.write_bytes(data)
                print(f"{path}:\n{traceback.format_exc(limit=-4)}", flush=True)
    print(", ".join(f"{name} {tries}" for name, tries in count.items()))
    return sum(count.values()), len(kinds)


def tried(name: str, data: bytes, folder: Path) -> None:
    """Try one input for at most `SLOWEST_S` seconds of processor time a step."""
    from fuzz.targets import check

    if signal.getsignal(signal.SIGALRM) is too_slow:
        signal.alarm(SLOWEST_S)
    try:
        check(name, data, folder)
    finally:
        signal.alarm(0)


def too_slow(number: int, frame: FrameType | None) -> None:
    raise TimeoutError(f"longer than {SLOWEST_S} s")


if __name__ == "__main__":
    os.environ.setdefault("QT_QPA_PLATFORM", "offscreen")
    main()
