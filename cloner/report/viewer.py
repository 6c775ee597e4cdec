"""A page that shows the clone in any browser, from the disk and without a network."""

from __future__ import annotations

import base64
import importlib.resources
from html import escape
from pathlib import Path
from typing import Final

from cloner.exporters.shared.files import write_bytes
from cloner.report.policy import VIEWER, policy

FILE: Final = "viewer.html"
_STYLE: Final = """
html, body { margin: 0; height: 100%; overflow: hidden; background: #e2e4e6; font: 15px/1.4 system-ui, sans-serif; }
canvas { display: block; width: 100%; height: 100%; touch-action: none; outline-offset: -3px; }
.bar { position: fixed; left: .6rem; display: flex; flex-wrap: wrap; gap: .3rem; }
#views { top: .6rem; } #moods { bottom: .6rem; } #status { position: fixed; inset: 45% 0 auto; text-align: center; }
button { font: inherit; padding: .25rem .7rem; border: 1px solid #8888; border-radius: .5rem; background: #fffc;
  color: #222; cursor: pointer; } button[aria-pressed=true] { background: #357; color: #fff; }
"""


def viewer_page(title: str, glb: bytes) -> str:
    """Return the HTML of a page that holds and shows a clone.

    Parameters
    ----------
    title : str
        Plain text.
    glb : bytes
        The clone as a binary glTF.
    """
    web = importlib.resources.files("cloner.report") / "web"
    three, viewer = ((web / name).read_text(encoding="utf-8") for name in ("three.min.js", "viewer.js"))
    return (
        '<!doctype html>\n<html lang="en"><head><meta charset="utf-8">'
        '<meta name="viewport" content="width=device-width, initial-scale=1">'
        f"{policy(VIEWER)}"
        f"<title>{escape(title)}</title><style>{_STYLE}</style></head>\n<body>\n"
        f'<canvas tabindex="0" aria-label="{escape(title)}, in three dimensions"></canvas>'
        '<div class="bar" id="views"></div><div class="bar" id="moods"></div><p id="status">Loading…</p>\n'
        f'<script type="application/octet-stream" id="clone">{base64.b64encode(glb).decode("ascii")}</script>\n'
        f"<script>{three}</script>\n<script>{viewer}</script>\n</body></html>\n"
    )


def write_viewer(title: str, glb: Path) -> Path:
    """Write the viewer beside a binary glTF and return its path.

    Raises
    ------
    ClonerError
        If the folder cannot be written to.
    """
    path = glb.with_name(FILE)
    write_bytes(path, viewer_page(title, glb.read_bytes()).encode("utf-8"))
    return path
