"""The command line ``cloner``: its commands by name, and how it starts and ends."""

from __future__ import annotations

import logging
import os
import signal
import sys
from types import FrameType
from typing import Annotated

import typer

import cloner
from cloner.commands import bodies, clones, crowds, held, machine
from cloner.commands.scenes import scenes
from cloner.commands.statues import statues
from cloner.terminal import run_command

app = typer.Typer(
    name="cloner",
    help="Five photographs and a height in, an animatable textured human out. Offline; nothing leaves this machine.",
    no_args_is_help=True,
    add_completion=False,
    pretty_exceptions_enable=False,
    rich_markup_mode=None,
)


@app.callback(invoke_without_command=True)
def _common(
    verbose: Annotated[bool, typer.Option("--verbose", "-v", help="Log every stage with its time.")] = False,
    version: Annotated[bool, typer.Option("--version", help="Say the version and stop.")] = False,
) -> None:
    """Set up logging; the commands do the work."""
    level = logging.INFO if verbose else logging.WARNING
    logging.basicConfig(level=level, format="%(levelname)s %(name)s: %(message)s", stream=sys.stderr)
    if version:
        typer.echo(f"cloner {cloner.__version__}")
        raise typer.Exit


app.command("clone")(clones.clone)
app.command("batch")(clones.batch)
app.command("render")(clones.render)
app.command("animate")(clones.animate)
app.command("body")(bodies.body)
app.command("undress")(bodies.undress)
app.command("dress")(bodies.dress)
app.add_typer(statues, name="statue")
app.add_typer(crowds.crowds, name="crowd")
app.add_typer(scenes, name="scene")
app.command("evaluate")(machine.evaluate)
app.command("list")(held.list_held)
app.command("export-data")(held.export_data)
app.command("forget")(held.forget_some)
app.command("gui")(machine.gui)
app.command("doctor")(machine.doctor)
app.add_typer(machine.clusters, name="cluster")


def main() -> None:
    """Run the command line and exit with its code."""
    for name in ("SIGTERM", "SIGHUP"):  # a closed terminal ends a command as tidily as Ctrl-C; Windows has no SIGHUP
        number = getattr(signal, name, None)
        if number is not None and signal.getsignal(number) is not signal.SIG_IGN:  # nohup is obeyed
            signal.signal(number, _stop)
    os.umask(0o077)  # results hold a person's likeness: nobody else's business on a shared machine
    sys.exit(run_command(lambda: app(standalone_mode=False)))


def _stop(number: int, frame: FrameType | None) -> None:
    """Treat a request to end like Ctrl-C, so that temporary folders are removed."""
    raise KeyboardInterrupt
