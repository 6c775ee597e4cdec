"""``cloner list``, ``export-data``, ``forget``: personal data."""

from __future__ import annotations

from pathlib import Path
from typing import Annotated

import typer

from cloner.errors import ClonerError, printable
from cloner.terminal import EXIT_SOME_FAILED

PhotosRootOption = Annotated[
    Path | None, typer.Option("--photos", help="Folder that holds the visitors' folders of photos.")
]
ResultsOption = Annotated[Path | None, typer.Option("--out", help="Folder that holds the results.")]


def list_held(photos: PhotosRootOption = None, out: ResultsOption = None) -> None:
    """Say what is held of whom."""
    from cloner.personal_data.holdings import holdings, table

    typer.echo(table(holdings(photos, out)))


def export_data(
    identifier: Annotated[str, typer.Argument(help="As cloner list shows it.")],
    to: Annotated[Path, typer.Option("--to", help="The .zip file to write.")],
    photos: PhotosRootOption = None,
    out: ResultsOption = None,
) -> None:
    """Hand out everything that is held of a visitor."""
    from cloner.personal_data.holdings import find_holding, holdings
    from cloner.personal_data.privacy import export_data

    typer.echo(str(export_data(find_holding(identifier, holdings(photos, out)), to)))


def forget_some(
    identifiers: Annotated[list[str] | None, typer.Argument(help="As cloner list shows them.")] = None,
    older_days: Annotated[
        float | None, typer.Option("--older-than", min=0, help="Everybody whose last change is so many days ago.")
    ] = None,
    photos: PhotosRootOption = None,
    out: ResultsOption = None,
) -> None:
    """Delete photos, results and batch rows of visitors, for good."""
    from cloner.personal_data.holdings import find_holding, holdings, older_than
    from cloner.personal_data.privacy import forget

    held = holdings(photos, out)
    gone = [find_holding(name, held) for name in identifiers or []]
    gone += [one for one in (older_than(held, older_days) if older_days is not None else ()) if one not in gone]
    if not gone:
        raise ClonerError("nobody is to be forgotten", "Name visitors, or give --older-than DAYS", "cloner forget")
    left: list[str] = []
    for holding in gone:
        found = forget(holding, photos, out)
        left += found
        typer.echo(f"{holding.identifier}: {'not all is gone' if found else f'{holding.files} files deleted'}")
    if left:
        left_files = ", ".join(printable(one) for one in sorted(set(left)))
        typer.echo(f"still there, or telling of them: {left_files}", err=True)
        raise typer.Exit(EXIT_SOME_FAILED)
