"""``cloner gui``, ``doctor``, ``cluster``, ``evaluate``: the window, this machine, a cluster, and evaluation."""

from __future__ import annotations

import json
from pathlib import Path
from typing import Annotated

import typer

from cloner.commands.options import SeedOption
from cloner.frames import ViewId
from cloner.terminal import EXIT_SOME_FAILED, ProgressLine

clusters = typer.Typer(no_args_is_help=True, rich_markup_mode=None, help="What a cluster of machines needs.")


@clusters.command("keys")
def _cluster_keys(folder: Annotated[Path, typer.Argument(help="New folder for certificates and settings.")]) -> None:
    """Make certificates: only who holds them speaks with scheduler and workers, and encrypted."""
    from cloner.machines.cluster_keys import DAYS, SETTINGS, make_keys

    settings = next(path for path in make_keys(folder) if path.name == SETTINGS)
    typer.echo(f"{folder}: certificates for {DAYS} days. Copy the folder to the same place on every machine, then:")
    typer.echo(f"  DASK_CONFIG={settings} dask scheduler --protocol tls --dashboard-address 127.0.0.1:0")
    typer.echo(f"  DASK_CONFIG={settings} dask worker tls://HOST:8786 --nthreads 1")
    typer.echo(f"  cloner batch ... --scheduler tls://HOST:8786 --cluster-keys {folder}")


@clusters.callback()
def _cluster() -> None:
    """Keep "keys" a word of its own: a group of one command would swallow it."""


def gui(
    folder: Annotated[Path | None, typer.Argument(help="The event's folder, or one visitor's.")] = None,
) -> None:
    """Open the window."""
    from cloner_gui.app import run_app

    raise typer.Exit(run_app(folder))


def doctor(
    brief: Annotated[bool, typer.Option("--brief", help="Say only what is missing.")] = False,
    folders: Annotated[
        list[Path] | None, typer.Option("--folder", help="A folder of photos or results: who else may read it?")
    ] = None,
) -> None:
    """Say what is missing on this machine and the line that fixes it."""
    from cloner.machines.doctor import examine
    from cloner.machines.permissions import examine_folder

    findings = (*examine(), *(finding for folder in folders or () for finding in examine_folder(folder)))
    for finding in findings:
        if not brief or not finding.fine:
            typer.echo(finding.line())
    if all(finding.fine for finding in findings):
        typer.echo("Everything Cloner needs is here.")
    elif any(finding.needed and not finding.fine for finding in findings):
        raise typer.Exit(EXIT_SOME_FAILED)


def evaluate(
    visitors: Annotated[
        list[Path], typer.Argument(help="Visitors or generated people with truth, such as samples/anna.")
    ],
    sets: Annotated[list[str] | None, typer.Option("--set", help="plain, booth or handheld; all by default.")] = None,
    out: Annotated[Path | None, typer.Option("--out", help="Keep the clones in this folder.")] = None,
    photos: Annotated[
        list[ViewId] | None, typer.Option("--photo", help="Clone generated people from this photo; all by default.")
    ] = None,
    seed: SeedOption = 0,
    as_json: Annotated[bool, typer.Option("--json", help="Print the rows as JSON.")] = False,
) -> None:
    """Score clones of visitors whose truth is known."""
    from cloner.evaluate import evaluate_visitors, format_table
    from cloner.evaluate.truths.truth import SETS

    sentences: list[str] = []
    with ProgressLine() as progress:
        rows = evaluate_visitors(
            visitors,
            tuple(sets or SETS),
            out,
            shown=tuple(photos or ViewId),
            progress=progress,
            report=sentences.append,
            seed=seed,
        )
    for sentence in sentences:
        typer.echo(sentence, err=True)
    typer.echo(json.dumps(rows, indent=1) if as_json else format_table(rows))
