"""Options that several commands share."""

from __future__ import annotations

import sys
from collections.abc import Iterable
from pathlib import Path
from typing import Annotated, Final

import typer

DEFAULT_FORMATS: Final = "glb,wrl"
#: Side of the texture that nobody chose, texels (taste).
DEFAULT_TEXTURE_SIZE: Final = 2048

CloneArgument = Annotated[Path, typer.Argument(metavar="CLONE", help="A result's folder or its clone.npz.")]
OutOption = Annotated[Path, typer.Option("--out", help="Folder that receives the results.")]
IdOption = Annotated[str, typer.Option("--id", help="Name of the result's folder.")]
FormatOption = Annotated[
    str,
    typer.Option(
        "--format",
        help="With commas: glb,small,lods,mixamo,unity,unreal,wrl,hanim,flat,x3d,vrm,vrma,usdz,obj,ply,regions.",
    ),
]
SeedOption = Annotated[int, typer.Option("--seed", help="The same photos and seed give the same clone.")]
SizeOption = Annotated[
    int, typer.Option("--size", "--texture-size", help="Side of the texture in texels: 512, 1024, 2048 or 4096.")
]


def say(lines: Iterable[str]) -> None:
    """Print lines."""
    for line in lines:
        typer.echo(line)


def at_once(line: str) -> None:
    """Print a line that another program may be waiting for."""
    typer.echo(line)
    sys.stdout.flush()
