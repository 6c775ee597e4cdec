"""The command line's ``cloner statue``: a clone in stone, and what statues are made of."""

from __future__ import annotations

from pathlib import Path
from typing import Annotated, Any, Final

import typer
from typer.core import TyperGroup

from cloner.terminal import ProgressLine

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
    clone_path: Annotated[Path, typer.Argument(metavar="CLONE", help="A result's folder or its clone.npz.")],
    out: Annotated[Path, typer.Option("--out", help="Folder that receives the results.")],
    material: Annotated[str, typer.Option("--material", help="stone, clay, bronze or marble.")] = "stone",
    pose: Annotated[str, typer.Option("--pose", help="How it rests: rest, standing, guard or hail.")] = "rest",
    identifier: Annotated[str, typer.Option("--id", help="Name of the result's folder.")] = "",
    formats: Annotated[str, typer.Option("--format", help="Formats, with commas, as of cloner clone.")] = "glb,wrl",
) -> None:
    """Make a statue of a clone: one material all over, still rigged."""
    from cloner.statues.written import statue_folder

    names = tuple(dict.fromkeys(name.strip().lower() for name in formats.split(",") if name.strip()))
    with ProgressLine() as progress:
        folder = statue_folder(
            clone_path, out, identifier, material=material, pose=pose, formats=names, progress=progress
        )
    typer.echo(str(folder))
