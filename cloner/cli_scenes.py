"""The command line's ``cloner scene``: rooms from plans, their light, and clones in them."""

from __future__ import annotations

from pathlib import Path
from typing import Annotated

import typer

from cloner.terminal import ProgressLine

scenes = typer.Typer(no_args_is_help=True, rich_markup_mode=None, help="Rooms to walk in: from plans, lit, inhabited.")
FolderArgument = Annotated[Path, typer.Argument(metavar="FOLDER", help="What scene make wrote.")]


@scenes.command("make")
def _make(
    plan: Annotated[str, typer.Argument(metavar="PLAN", help="museum, nave, or a plan's file (docs/scenes.md).")],
    out: Annotated[Path, typer.Option("--out", help="Folder that receives the room.")],
) -> None:
    """Build a room from a plan: plan.toml and room.glb."""
    from cloner.scenes.written import make_folder

    for line in make_folder(plan, out):
        typer.echo(line)


@scenes.command("light")
def _light(folder: FolderArgument) -> None:
    """Work out a room's light: light maps in room.glb, and probes for figures."""
    from cloner.scenes.written import light_folder

    with ProgressLine() as progress:
        lines = light_folder(folder, progress)
    for line in lines:
        typer.echo(line)
