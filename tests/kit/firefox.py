"""Firefox that opens one page from the disk on a screen of its own: WebDriver BiDi, no other library."""

from __future__ import annotations

import asyncio
import json
import os
import shutil
import subprocess
import time
from pathlib import Path
from typing import Any

import websockets

FIREFOX = shutil.which("firefox-esr") or shutil.which("firefox")
SCREEN = shutil.which("Xvfb")  # without a screen Firefox has no software WebGL
_SETTINGS = (("webgl.force-enabled", "true"), ("remote.active-protocols", 1), ("app.update.enabled", "false"))


def opened(path: Path, scratch: Path, ready: str, wanted: list[str], seconds: float = 240.0) -> dict[str, Any]:
    """Return the values of expressions in a page once ``ready`` holds, every address it asked for and its errors."""
    scratch.mkdir()
    (scratch / "user.js").write_text("".join(f'user_pref("{name}", {value});\n' for name, value in _SETTINGS))
    display, port = f":{70 + os.getpid() % 400}", 9500 + os.getpid() % 400
    env = {**os.environ, "DISPLAY": display, "LIBGL_ALWAYS_SOFTWARE": "1", "HOME": str(scratch)}
    quiet: dict[str, Any] = {"stdout": subprocess.DEVNULL, "stderr": subprocess.DEVNULL}
    screen = subprocess.Popen([str(SCREEN), display, "-screen", "0", "1280x800x24", "-nolisten", "tcp"], **quiet)
    command = [str(FIREFOX), "--no-remote", "--profile", scratch, "--remote-debugging-port", str(port), "about:blank"]
    program = subprocess.Popen(command, env=env, **quiet)
    try:
        return asyncio.run(_looked(path, port, ready, wanted, time.monotonic() + seconds))
    finally:
        for one in (program, screen):
            one.kill()
            one.wait()


async def _looked(path: Path, port: int, ready: str, wanted: list[str], end: float) -> dict[str, Any]:
    socket = await _connected(port, end)
    events: list[dict[str, Any]] = []
    number = 0

    async def ask(method: str, **params: Any) -> dict[str, Any]:
        nonlocal number
        number += 1
        await socket.send(json.dumps({"id": number, "method": method, "params": params}))
        while True:
            answer = json.loads(await socket.recv())
            if answer.get("id") == number:
                if "error" in answer:
                    raise RuntimeError(f"{method}: {answer['message']}")
                return dict(answer["result"])
            events.append(answer)

    await ask("session.new", capabilities={})
    await ask("session.subscribe", events=["log.entryAdded", "network.beforeRequestSent"])
    context = (await ask("browsingContext.getTree"))["contexts"][0]["context"]
    await ask("browsingContext.navigate", context=context, url=path.resolve().as_uri(), wait="complete")

    async def value(expression: str) -> Any:
        found = await ask("script.evaluate", expression=f"JSON.stringify({expression})", target={"context": context},
                          awaitPromise=True)  # fmt: skip
        if found["type"] == "exception":
            raise RuntimeError(found["exceptionDetails"]["text"])
        return json.loads(found["result"].get("value", "null"))

    while not await value(f"Boolean({ready})"):
        if time.monotonic() > end:
            raise TimeoutError(f"{ready} did not become true")
        await asyncio.sleep(0.3)
    values = [await value(expression) for expression in wanted]
    await socket.close()
    told = {name: [e["params"] for e in events if e.get("method") == name]
            for name in ("network.beforeRequestSent", "log.entryAdded")}  # fmt: skip
    return {
        "values": values,
        "requests": [one["request"]["url"] for one in told["network.beforeRequestSent"]],
        "errors": [one["text"] for one in told["log.entryAdded"] if one["level"] == "error"],
    }


async def _connected(port: int, end: float) -> Any:
    while True:
        try:
            return await websockets.connect(f"ws://127.0.0.1:{port}/session", max_size=1 << 28)
        except (OSError, websockets.WebSocketException):
            if time.monotonic() > end:
                raise
            await asyncio.sleep(0.5)
