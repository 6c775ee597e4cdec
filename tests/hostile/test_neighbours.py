"""Other users of the machine and of the network: a batch opens no port to them, a cluster refuses them."""

from __future__ import annotations

import os
import signal
import stat
import subprocess
import sys
import time
from collections.abc import Iterator
from pathlib import Path

import pytest
from PIL import Image

from cloner import batch
from cloner.batch import BatchOptions, batch_folder
from cloner.errors import ClonerError
from cloner.machines import cluster
from cloner.machines.cluster_keys import make_keys
from kit import farming

NOBODY = 65534
#: A batch of two workers whose clones take long enough to be looked at.
BATCH = """
import sys
from pathlib import Path
from cloner import batch
from kit import farming
if __name__ == "__main__":
    batch.clone_in_worker = farming.dawdle
    batch.batch_folder(Path(sys.argv[1]), Path(sys.argv[2]), batch.BatchOptions(workers=2))
"""
#: Connects to an address and tries what an intruder would; says what it learnt.
INTRUDE = """
import os, sys
from distributed import Client
if os.getuid() == 0:
    os.setuid(65534)
client = Client(sys.argv[1], timeout=4)
print(client.run_on_scheduler(lambda: open(sys.argv[2]).read()))
"""


def visitors(root: Path, *names: str) -> Path:
    for name in names:
        (root / name).mkdir(parents=True)
        Image.new("RGB", (80, 120)).save(root / name / "body_front.jpg")
    return root


def family(pid: int) -> list[int]:
    tasks = list(Path(f"/proc/{pid}/task").iterdir()) if Path(f"/proc/{pid}").exists() else []
    own = {int(child) for task in tasks for child in (task / "children").read_text().split()}
    return [pid, *(inner for child in own for inner in family(child))]


def sockets(pid: int) -> set[str]:
    found = set()
    for link in Path(f"/proc/{pid}/fd").iterdir():
        try:
            told = os.readlink(link)
        except OSError:
            continue
        if told.startswith("socket:["):
            found.add(told[8:-1])
    return found


def listening() -> dict[str, str]:
    """Return the inode of every listening TCP and named UNIX socket, and where it listens."""
    found = {}
    for table in ("tcp", "tcp6"):
        for line in Path(f"/proc/net/{table}").read_text().splitlines()[1:]:
            cells = line.split()
            if cells[3] == "0A":
                found[cells[9]] = f"{table} {cells[1]}"
    for line in Path("/proc/net/unix").read_text().splitlines()[1:]:
        cells = line.split()
        if int(cells[3], 16) & 0x10000:
            found[cells[6]] = f"unix {' '.join(cells[7:])}"
    return found


@pytest.fixture
def running(tmp_path: Path) -> Iterator[subprocess.Popen[bytes]]:
    root = visitors(tmp_path / "photos", "secret-anna", "secret-boris")
    (tmp_path / "batch.py").write_text(BATCH)
    environment = {**os.environ, "PYTHONPATH": os.pathsep.join(sys.path)}
    command = [sys.executable, str(tmp_path / "batch.py"), str(root), str(tmp_path / "out")]
    process = subprocess.Popen(command, env=environment, start_new_session=True)
    over = time.monotonic() + 60
    while len(list((tmp_path / "out").glob(".*.dawdling"))) < 2 and time.monotonic() < over:
        time.sleep(0.1)
    yield process
    os.killpg(process.pid, signal.SIGKILL)
    process.wait()


@pytest.mark.slow
@pytest.mark.skipif(sys.platform != "linux", reason="reads /proc")
def test_a_batch_on_one_machine_listens_nowhere_and_its_neighbours_learn_no_name(
    running: subprocess.Popen[bytes],
) -> None:
    every = family(running.pid)
    assert len(every) >= 3, "a batch and two workers"
    open_to_others = listening()
    for pid in every:
        assert not [open_to_others[one] for one in sockets(pid) if one in open_to_others]
    look = "import sys; [print(open(f'/proc/{pid}/cmdline').read()) for pid in sys.argv[1:]]"
    told = subprocess.run(
        ["python3", "-c", look, *map(str, every)], user=NOBODY if os.getuid() == 0 else None, cwd="/",
        capture_output=True, text=True, check=True,
    )  # fmt: skip
    assert told.stdout.count("multiprocessing") >= 2
    assert "secret-" not in told.stdout


def test_a_cluster_without_certificates_is_refused_in_a_sentence(tmp_path: Path) -> None:
    root = visitors(tmp_path / "photos", "anna", "boris")
    with pytest.raises(ClonerError, match="wants certificates") as caught:
        batch_folder(root, tmp_path / "out", BatchOptions(scheduler="tcp://127.0.0.1:9"))
    assert "cloner cluster keys" in caught.value.hint
    with pytest.raises(ClonerError, match="plain connection"):
        batch_folder(root, tmp_path / "out", BatchOptions(scheduler="tcp://127.0.0.1:9", cluster_keys=tmp_path))
    with pytest.raises(ClonerError, match=r"Dask is not installed|not complete"):
        batch_folder(root, tmp_path / "out", BatchOptions(scheduler="tls://127.0.0.1:9", cluster_keys=tmp_path))


def test_keys_are_the_owners_alone_and_the_authoritys_own_is_nowhere(tmp_path: Path) -> None:
    pytest.importorskip("cryptography", reason="certificates need the extra cluster")
    written = make_keys(tmp_path / "a b: 'keys'")
    assert stat.S_IMODE((tmp_path / "a b: 'keys'").stat().st_mode) == 0o700
    assert {stat.S_IMODE(path.stat().st_mode) for path in written} == {0o600}
    assert sorted(path.name for path in written if "key" in path.name) == [
        "client-key.pem", "scheduler-key.pem", "worker-key.pem",
    ]  # fmt: skip
    yaml = pytest.importorskip("yaml")
    told = yaml.safe_load((tmp_path / "a b: 'keys'" / "dask.yaml").read_text())["distributed"]
    assert told["comm"]["require-encryption"] is True
    assert all(
        Path(told["comm"]["tls"][role][what]).is_file() for role in ("worker", "client") for what in ("cert", "key")
    )
    with pytest.raises(ClonerError, match="there already"):
        make_keys(tmp_path / "a b: 'keys'")


@pytest.mark.slow
def test_a_cluster_with_certificates_works_and_refuses_everybody_else(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    pytest.importorskip("cryptography", reason="certificates need the extra cluster")
    pytest.importorskip("distributed", reason="a cluster needs the extra cluster")
    make_keys(tmp_path / "keys")
    make_keys(tmp_path / "others")
    secret = tmp_path / "secret"
    secret.write_text("a private word")
    started = farming.start_cluster(str(tmp_path / "keys"))
    try:
        place = farming.address(started)
        assert place.startswith("tls://")
        for wrong in (place, place.replace("tls://", "tcp://")):
            done = subprocess.run(
                [sys.executable, "-c", INTRUDE, wrong, str(secret)], cwd="/", capture_output=True, text=True,
                env={"PYTHONPATH": os.pathsep.join(sys.path)}, check=False,
            )  # fmt: skip
            assert done.returncode != 0
            assert "private" not in done.stdout
        monkeypatch.setattr(batch, "clone_in_worker", farming.pretend)
        root = visitors(tmp_path / "photos", "secret-anna", "secret-boris")
        rows = batch_folder(root, tmp_path / "out", BatchOptions(scheduler=place, cluster_keys=tmp_path / "keys"))
        assert {row.status for row in rows} == {"cloned"}
        monkeypatch.setattr(cluster, "PATIENCE_S", 3)
        with pytest.raises(ClonerError, match="no scheduler answers"):
            batch_folder(root, tmp_path / "out2", BatchOptions(scheduler=place, cluster_keys=tmp_path / "others"))
    finally:
        farming.end_cluster(started)


@pytest.mark.slow
def test_an_unprotected_cluster_wants_to_be_asked_for_and_sees_no_names(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    distributed = pytest.importorskip("distributed", reason="a cluster needs the extra cluster")
    started = farming.start_cluster()
    try:
        place = farming.address(started)
        monkeypatch.setattr(batch, "clone_in_worker", farming.pretend)
        root, seen = visitors(tmp_path / "photos", "secret-anna", "secret-boris"), set()

        def told(row: object, done: int, of: int) -> None:
            with distributed.Client(place, set_as_default=False) as other:
                seen.update(other.run_on_scheduler(lambda dask_scheduler: [*dask_scheduler.tasks]))
                seen.update(str(one) for one in other.get_task_stream())

        rows = batch_folder(root, tmp_path / "out", BatchOptions(scheduler=place, unprotected=True), report=told)
        assert {row.status for row in rows} == {"cloned"}
        assert seen
        assert not [name for name in seen if "secret" in str(name)]
        with pytest.raises(ClonerError, match="wants certificates"):
            batch_folder(root, tmp_path / "out", BatchOptions(scheduler=place))
    finally:
        farming.end_cluster(started)
