"""Jobs for a worker's process that tests can tell apart."""

import logging
import os
import threading
import time

import numpy as np

from cloner.errors import ClonerError


class OddJobs:
    """Counts, sleeps, fails and dies on demand."""

    def __init__(self, show):
        self.count = 0
        self.show = show

    def add(self, number, progress):
        progress("adding", 0.5)
        self.count += number
        return self.count, os.getpid()

    def paint(self, size, progress):
        """Show a large picture while another thread logs."""
        noise = threading.Thread(target=lambda: [logging.getLogger("cloner.odd").info("n") for _ in range(200)])
        noise.start()
        for number in range(5):
            self.show(np.full(size, number, np.float32))
        noise.join()

    def sleep(self, seconds, progress):
        progress("asleep", 0.1)
        time.sleep(seconds)

    def wait_for(self, path, progress):
        """Go on once a file is there."""
        progress("asleep", 0.1)
        while not path.exists():
            time.sleep(0.01)

    def refuse(self, progress):
        raise ClonerError("too dark", "Light", "photo")

    def stumble(self, progress):
        logging.getLogger("cloner.odd").warning("stumbling")
        raise ZeroDivisionError

    def die(self, progress):
        os._exit(3)
