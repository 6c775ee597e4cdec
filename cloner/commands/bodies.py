"""``cloner body``, ``undress``, ``dress``: bodies from measures, and what they wear."""

from __future__ import annotations

from pathlib import Path
from typing import Annotated, Final

import typer

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
from cloner.errors import ClonerError
from cloner.terminal import ProgressLine, split_formats

#: What moves cloth: the fast way, and the source's.
INTEGRATORS: Final = ("threads", "elements")


def body(
    out: OutOption,
    identifier: IdOption,
    sex: Annotated[str, typer.Option("--sex", help="f or m.")] = "",
    stature: Annotated[float | None, typer.Option("--stature", help="Barefoot height in cm.")] = None,
    age: Annotated[float | None, typer.Option("--age", help="Years; below 18 a child's body.")] = None,
    bust: Annotated[float | None, typer.Option("--bust", help="Chest girth in cm.")] = None,
    waist: Annotated[float | None, typer.Option("--waist", help="Waist girth in cm.")] = None,
    hip: Annotated[float | None, typer.Option("--hip", help="Hip girth in cm.")] = None,
    measures: Annotated[
        list[str] | None, typer.Option("--measure", help="Any other: NAME=CM, such as inside_leg=78. Repeat it.")
    ] = None,
    source: Annotated[Path | None, typer.Option("--from", help="A clone that is told new measures.")] = None,
    formats: FormatOption = DEFAULT_FORMATS,
    size: SizeOption = DEFAULT_TEXTURE_SIZE,
) -> None:
    """Make a body from measures, or tell a clone new ones."""
    from cloner.bodies.children import USUAL_AGE
    from cloner.bodies.written import body_folder

    measures_cm = {name: value for name, value in (("bust", bust), ("waist", waist), ("hip", hip)) if value is not None}
    for name, value in map(named_number, measures or ()):
        if name in measures_cm:
            raise ClonerError(f"{name} is given twice", "Keep one of both", "--measure")
        measures_cm[name] = value
    with ProgressLine() as progress:
        folder, lines = body_folder(
            out, identifier, sex=sex.lower(), stature_cm=stature, measures_cm=measures_cm,
            formats=split_formats(formats), texture_size=size, age_years=USUAL_AGE if age is None else age,
            source=source, progress=progress,
        )  # fmt: skip
    say(lines)
    typer.echo(str(folder))


def named_number(text: str) -> tuple[str, float]:
    """Return the name and the number of NAME=NUMBER."""
    name, _, value = text.partition("=")
    try:
        return name.strip(), float(value)
    except ValueError as error:
        hint = "Write a name and centimetres, such as --measure inside_leg=78"
        raise ClonerError(f"{text!r} is no measure", hint, "--measure") from error


def undress(
    clone_path: CloneArgument,
    out: OutOption,
    identifier: IdOption = "",
    sex: Annotated[str, typer.Option("--sex", help="f or m; the clone's shape decides without it.")] = "",
    formats: FormatOption = DEFAULT_FORMATS,
) -> None:
    """Make a clone barefoot and in neutral underwear, to be dressed anew; consent must be recorded."""
    from cloner.bodies.undressed import undress_folder

    with ProgressLine() as progress:
        folder = undress_folder(
            clone_path, out, identifier, sex=sex.lower(), formats=split_formats(formats), progress=progress
        )
    typer.echo(str(folder))


def dress(
    clone_path: CloneArgument,
    out: Annotated[
        Path,
        typer.Option(
            "--out",
            help="A result's folder (its cloth flows in crowds), or .glb, .pc2, .usdc, .png (VAT), .gif, .webp, .mp4.",
        ),
    ],
    garment: Annotated[
        str,
        typer.Option(help="skirt, circle-, straight-, long-skirt, cape, tee, dress, coat, trousers or a file of one."),
    ] = "skirt",
    fabric: Annotated[
        str, typer.Option(help="silk, cotton, linen, wool, denim, burlap, or a .toml of KES readings.")
    ] = "cotton",
    motion: Annotated[str, typer.Option(help="walk, or a captured walk (.bvh).")] = "walk",
    length: Annotated[float | None, typer.Option("--length", help="Length in cm.")] = None,
    over: Annotated[
        list[str] | None, typer.Option("--over", help="Worn over it: GARMENT or GARMENT:FABRIC. Repeat it.")
    ] = None,
    integrator: Annotated[
        str, typer.Option("--integrator", help="threads (fast), or elements (more exact, ten times as long).")
    ] = "threads",
    resume: Annotated[
        bool, typer.Option("--resume", help="Keep frames beside --out until it is written, and go on from them.")
    ] = False,
    formats: FormatOption = DEFAULT_FORMATS,
) -> None:
    """Put a garment on a clone and let its cloth flow in a loop with the walk."""
    from cloner.cloth.fitted import ENDING, fit_folder
    from cloner.cloth.written import dress_file

    if integrator not in INTEGRATORS:
        raise ClonerError(
            f"the integrator {integrator!r} is not known", f"Give {' or '.join(INTEGRATORS)}", "--integrator"
        )
    is_fitted = Path(garment).suffix.lower() == ENDING
    if is_fitted and (over or length is not None):
        raise ClonerError("a fitted garment keeps its size and is worn alone", "Dress the result again", garment)
    worn_over = [(name, other or fabric) for name, _, other in (one.partition(":") for one in over or ())]
    with ProgressLine() as progress:
        if is_fitted:
            say(fit_folder(clone_path, Path(garment), out, formats=split_formats(formats), progress=progress))
            return
        lines = dress_file(
            clone_path,
            out,
            garment=garment,
            fabric=fabric,
            motion=motion,
            length_cm=length,
            over=worn_over,
            elements=integrator == INTEGRATORS[1],
            resume=resume,
            formats=split_formats(formats),
            progress=progress,
        )
    say(lines)
