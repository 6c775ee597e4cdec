"""Jobs for a worker's process that tests can tell apart."""

import logging
import os
import time

from cloner.errors import ClonerError


class OddJobs:
    """Counts, sleeps, fails and dies on demand."""

    def __init__(self):
        self.count = 0

    def add(self, number, progress):
        progress("adding", 0.5)
        self.count += number
        return self.count, os.getpid()

    def sleep(self, seconds, progress):
        progress("asleep", 0.1)
        time.sleep(seconds)

    def refuse(self, progress):
        raise ClonerError("too dark", "Light", "photo")

    def stumble(self, progress):
        logging.getLogger("cloner.odd").warning("stumbling")
        raise ZeroDivisionError

    def die(self, progress):
        os._exit(3)
