"""The command line's ``cloner statue``: a clone in stone, and what statues are made of."""

from __future__ import annotations

from pathlib import Path
from typing import Annotated, Any, Final

import typer
from typer.core import TyperGroup

from cloner.commands.options import (
    DEFAULT_FORMATS,
    DEFAULT_TEXTURE_SIZE,
    CloneArgument,
    FormatOption,
    IdOption,
    OutOption,
    SizeOption,
    say,
)
from cloner.terminal import ProgressLine, split_formats

#: What ``cloner statue CLONE`` means.
MAKE: Final = "make"


class OrMake(TyperGroup):
    """A group whose first word may be a clone's path instead of a command: then a statue is made of it."""

    def parse_args(self, ctx: Any, args: list[str]) -> list[str]:
        """Put the command's name before anything that is none."""
        if args and args[0] not in self.commands and args[0] not in ("--help", "-h"):
            args = [MAKE, *args]
        return super().parse_args(ctx, args)


statues = typer.Typer(
    cls=OrMake, no_args_is_help=True, rich_markup_mode=None, help="A clone in stone; what statues are made of."
)


@statues.command(MAKE)
def _statue(
    clone_path: CloneArgument,
    out: OutOption,
    material: Annotated[str, typer.Option("--material", help="stone, clay, bronze or marble.")] = "stone",
    pose: Annotated[str, typer.Option("--pose", help="How it rests: rest, standing, guard or hail.")] = "rest",
    identifier: IdOption = "",
    formats: FormatOption = DEFAULT_FORMATS,
) -> None:
    """Make a statue of a clone: one material all over, still rigged."""
    from cloner.statues.written import statue_folder

    with ProgressLine() as progress:
        folder = statue_folder(
            clone_path, out, identifier, material=material, pose=pose, formats=split_formats(formats), progress=progress
        )
    typer.echo(str(folder))


@statues.command("photo")
def _photo(
    photo: Annotated[Path, typer.Argument(metavar="PHOTO", help="A photograph of a statue, or of a face.")],
    markers: Annotated[Path, typer.Option("--markers", help="Which vertex is where in the photo: docs/statues.md.")],
    out: OutOption,
    identifier: IdOption,
    onto: Annotated[Path | None, typer.Option("--onto", help="A clone, or a mesh (.obj); else the usual man.")] = None,
    material: Annotated[str, typer.Option("--material", help="Then cut in stone, clay, bronze or marble.")] = "",
    formats: FormatOption = DEFAULT_FORMATS,
    size: SizeOption = DEFAULT_TEXTURE_SIZE,
) -> None:
    """Fit one photograph to a clone or a mesh by markers; its texture is extended all around."""
    from cloner.statues.photographed import photo_folder

    with ProgressLine() as progress:
        folder, lines = photo_folder(
            photo, markers, out, identifier, onto=onto, material=material, formats=split_formats(formats),
            texture_size=size, progress=progress,
        )  # fmt: skip
    say((*lines, str(folder)))


@statues.command("blobs")
def _blobs(
    clone_path: CloneArgument,
    out: Annotated[Path, typer.Option("--out", help="The .json file to write, to be edited.")],
) -> None:
    """Write the metaballs that make a clone's body."""
    from cloner.statues.blob_bodies import blobs_file

    typer.echo(blobs_file(clone_path, out))
    typer.echo(str(out))


@statues.command("body")
def _body(
    blobs: Annotated[Path, typer.Argument(metavar="BLOBS", help="Metaballs on the skeleton (.json).")],
    out: OutOption,
    identifier: IdOption,
    onto: Annotated[Path | None, typer.Option("--onto", help="Whose head, hands and feet; else the usual man.")] = None,
    material: Annotated[str, typer.Option("--material", help="Then cut in stone, clay, bronze or marble.")] = "",
    formats: FormatOption = DEFAULT_FORMATS,
    size: SizeOption = DEFAULT_TEXTURE_SIZE,
) -> None:
    """Make a body of metaballs; head, hands and feet stay attached, and it is rigged."""
    from cloner.statues.blob_bodies import blob_folder

    with ProgressLine() as progress:
        folder, lines = blob_folder(
            blobs, out, identifier, onto=onto, material=material, formats=split_formats(formats), texture_size=size,
            progress=progress,
        )  # fmt: skip
    say((*lines, str(folder)))
