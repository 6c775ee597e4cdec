"""A worker's process remembers, tells, fails in words, ends at once when told to, and never outlives its caller."""

import logging
import os
import subprocess
import sys
import threading
import time

import pytest

from cloner.booth.worker import Worker
from cloner.errors import Cancelled, ClonerError


def quiet(step, fraction):
    pass


@pytest.fixture(scope="module")
def worker():
    made = Worker("kit.odd_jobs:OddJobs")
    yield made
    made.stop()


def alive(pid):
    try:
        os.kill(pid, 0)
    except ProcessLookupError:
        return False
    with open(f"/proc/{pid}/stat") as stream:
        return stream.read().split()[2] != "Z"


def test_it_remembers_between_jobs_and_tells_its_steps(worker):
    told = []
    first, pid = worker.call("add", 2, progress=lambda *step: told.append(step))
    second, same = worker.call("add", 3, progress=quiet)
    assert (second - first, same) == (3, pid)
    assert pid != os.getpid()
    assert ("adding", 0.5) in told


def test_it_shows_what_it_has_so_far_whole_and_in_order_while_threads_talk(worker):
    shown = []
    worker.call("paint", 60000, progress=quiet, show=shown.append)
    assert [(len(one), set(one.tolist())) for one in shown] == [(60000, {float(k)}) for k in range(5)]


def test_who_waits_behind_another_job_may_give_up(worker, tmp_path):
    begun, done = threading.Event(), []

    def tell(step, fraction):
        begun.set()

    def long():
        done.append(worker.call("wait_for", tmp_path / "end", progress=tell))

    other = threading.Thread(target=long)
    other.start()
    assert begun.wait(20)

    def stop(step, fraction):
        raise Cancelled

    with pytest.raises(Cancelled):
        worker.call("add", 1, progress=stop)
    assert not done, "who is cancelled waits for nobody"
    (tmp_path / "end").touch()
    other.join()
    assert len(done) == 1, "the other job goes on"


def test_failures_come_in_words_and_the_process_goes_on(worker, caplog):
    _, pid = worker.call("add", 1, progress=quiet)
    with pytest.raises(ClonerError) as told:
        worker.call("refuse", progress=quiet)
    assert (told.value.message, told.value.hint, told.value.where) == ("too dark", "Light", "photo")
    with caplog.at_level(logging.WARNING), pytest.raises(ClonerError, match=r"did not expect .ZeroDivisionError"):
        worker.call("stumble", progress=quiet)
    assert "stumbling" in caplog.text, "what the process logs reaches the caller's log"
    assert worker.call("add", 1, progress=quiet)[1] == pid


def test_a_cancelled_job_ends_at_once_and_the_next_one_has_a_new_process(worker):
    _, pid = worker.call("add", 1, progress=quiet)

    def stop(step, fraction):
        if step == "asleep":
            raise Cancelled

    with pytest.raises(Cancelled):
        worker.call("sleep", 60.0, progress=stop)
    assert not alive(pid), "it does not sleep on"
    assert worker.call("add", 1, progress=quiet)[1] != pid


def test_a_process_that_dies_is_told_and_replaced(worker):
    with pytest.raises(ClonerError, match="process ended"):
        worker.call("die", progress=quiet)
    assert worker.call("add", 5, progress=quiet)[0] == 5


def test_it_ends_with_its_caller_even_in_the_middle_of_a_job():
    code = (
        "import os, threading, time\nfrom cloner.booth.worker import Worker\n"
        "if __name__ == '__main__':\n"
        "    worker = Worker('kit.odd_jobs:OddJobs')\n"
        "    print(worker.call('add', 1, progress=lambda *_: None)[1], flush=True)\n"
        "    job = lambda: worker.call('sleep', 60.0, progress=lambda *_: None)\n"
        "    threading.Thread(target=job, daemon=True).start()\n"
        "    time.sleep(0.5)\n"
        "    os.kill(os.getpid(), 9)\n"
    )
    environment = {**os.environ, "PYTHONPATH": os.pathsep.join(sys.path)}
    done = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, env=environment, timeout=60)
    pid = int(done.stdout)
    end = time.monotonic() + 10.0
    while alive(pid) and time.monotonic() < end:
        time.sleep(0.05)
    assert not alive(pid)
