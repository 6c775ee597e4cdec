"""Run the product where there is no network, and hear of every attempt to reach one."""

from __future__ import annotations

import os
import subprocess
import sys
from collections.abc import Mapping
from functools import cache
from pathlib import Path

#: Runs at the start of every Python below, workers too: whatever leaves this machine is written down.
_GUARD = """
import os, sys
def _hear(event, told):
    if event.startswith("socket.") and event.split(".")[1] in ("connect", "sendto", "sendmsg", "getaddrinfo",
                                                                "gethostbyname", "gethostbyaddr"):
        where = repr(told[1:] if event in ("socket.connect", "socket.sendto", "socket.sendmsg") else told)
        if not any(own in where for own in ("127.0.0.1", "'localhost'", "'::1'")) and "('" in where + "('":
            with open(os.environ["CLONER_HEARD"], "a") as heard:
                heard.write(f"{event} {where} {sys.argv[:3]}\\n")
    elif event in ("urllib.Request", "http.client.connect", "ftplib.connect", "smtplib.connect"):
        with open(os.environ["CLONER_HEARD"], "a") as heard:
            heard.write(f"{event} {told}\\n")
sys.addaudithook(_hear)
"""
#: Brings the loopback up inside a new namespace, as any machine has it; then the program.
_ENTER = """
import fcntl, socket, struct, sys, os
with socket.socket(socket.AF_INET, socket.SOCK_DGRAM) as one:
    fcntl.ioctl(one, 0x8914, struct.pack("16sh14x", b"lo", 0x49))
os.execv(sys.executable, [sys.executable, *sys.argv[1:]])
"""


@cache
def namespace() -> tuple[str, ...]:
    """Return the command that enters a namespace without a network; () where this machine does not allow it."""
    for command in (("unshare", "--net"), ("unshare", "--map-root-user", "--net")):
        try:
            done = subprocess.run([*command, sys.executable, "-c", _ENTER, "-c", ""], capture_output=True, check=False)
        except OSError:
            continue
        if done.returncode == 0:
            return command
    return ()


def run_apart(
    code: str, *arguments: object, heard: Path, extra: Mapping[str, str] | None = None
) -> subprocess.CompletedProcess[str]:
    """Run Python code without a network; ``heard`` receives a line for every attempt to reach one."""
    guard = heard.parent / "guard"
    guard.mkdir(exist_ok=True)
    (guard / "sitecustomize.py").write_text(_GUARD)
    environment = {
        **os.environ,
        "PYTHONPATH": os.pathsep.join([str(guard), *sys.path]),
        "CLONER_HEARD": str(heard),
        "QT_QPA_PLATFORM": "offscreen",
        **(extra or {}),
    }
    command = [sys.executable, "-c", code, *map(str, arguments)]
    if namespace():
        command = [*namespace(), sys.executable, "-c", _ENTER, *command[1:]]
    return subprocess.run(command, env=environment, capture_output=True, text=True, check=False, timeout=900)
