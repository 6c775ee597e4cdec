"""``cloner clone``, ``batch``, ``render``, ``animate``: from photographs to a moving person."""

from __future__ import annotations

import time
from pathlib import Path
from typing import TYPE_CHECKING, Annotated, Final

import typer

from cloner.commands.options import (
    DEFAULT_FORMATS,
    DEFAULT_TEXTURE_SIZE,
    CloneArgument,
    FormatOption,
    OutOption,
    SeedOption,
    SizeOption,
)
from cloner.terminal import EXIT_SOME_FAILED, ProgressLine, split_formats

# Commands import their part when they run: `doctor` must work where a library is missing.
if TYPE_CHECKING:
    from cloner.records.batches import BatchRow

UNPROTECTED: Final = "--unprotected-cluster-lets-anybody-on-the-network-run-code"
HeightOption = Annotated[
    float | None, typer.Option("--height-cm", help="Barefoot height in cm; wins over person.toml.")
]


def clone(
    photos_dir: Annotated[Path, typer.Argument(help="Folder with body_front.jpg, body_side.jpg, ...")],
    out: OutOption,
    height_cm: HeightOption = None,
    formats: FormatOption = DEFAULT_FORMATS,
    seed: SeedOption = 0,
    size: SizeOption = DEFAULT_TEXTURE_SIZE,
    identifier: Annotated[str | None, typer.Option("--id", help="Name of the result's folder.")] = None,
) -> None:
    """Clone one person from a folder of photos."""
    from cloner.cloning import clone_folder

    with ProgressLine() as progress:
        outcome = clone_folder(
            photos_dir,
            out,
            height_cm=height_cm,
            formats=split_formats(formats),
            seed=seed,
            identifier=identifier,
            texture_size=size,
            progress=progress,
        )
    for warning in outcome.warnings:
        typer.echo(f"note: {warning}", err=True)
    typer.echo(f"{outcome.folder}: done in {outcome.report['timings']['seconds']:.0f} s")
    typer.echo(f"{outcome.folder / 'report.html'}")


def batch(
    photos_root: Annotated[
        Path, typer.Argument(help="Folder that holds one folder of photos a visitor, or a .csv/.toml manifest.")
    ],
    out: OutOption,
    formats: FormatOption = DEFAULT_FORMATS,
    seed: SeedOption = 0,
    size: SizeOption = DEFAULT_TEXTURE_SIZE,
    again: Annotated[bool, typer.Option("--again", help="Clone those with a current result once more.")] = False,
    workers: Annotated[int, typer.Option("--workers", min=1, help="Processes on this machine.")] = 1,
    scheduler: Annotated[str, typer.Option("--scheduler", help="Address of a Dask cluster that clones instead.")] = "",
    cluster_keys: Annotated[
        Path | None, typer.Option("--cluster-keys", help="Folder that `cloner cluster keys` made.")
    ] = None,
    unprotected: Annotated[
        bool,
        typer.Option(UNPROTECTED, help="Use a cluster without certificates: whoever reaches it reads everything."),
    ] = False,
    shard: Annotated[str, typer.Option("--shard", help="i/n: only every n-th visitor from the i-th (0..n-1) on.")] = "",
    retries: Annotated[int, typer.Option("--retries", min=0, help="Tries more when a worker dies.")] = 1,
    timeout: Annotated[float, typer.Option("--timeout", min=0, help="Seconds a visitor may take; 0: any.")] = 0.0,
) -> None:
    """Clone every visitor below a folder; one failure does not stop the rest."""
    from cloner.batch import BatchOptions, batch_folder, summary_table

    cluster = (scheduler, cluster_keys, unprotected)
    options = BatchOptions(split_formats(formats), seed, size, again, workers, *cluster, shard, retries, timeout)
    start = time.monotonic()

    def tell(row: BatchRow, done: int, total: int) -> None:
        typer.echo(f"{done}/{total} {row.identifier}: {row.message}{pace(done, total, start)}", err=True)

    rows = batch_folder(photos_root, out, options, report=tell)
    typer.echo(summary_table(rows))
    if any(row.status == "failed" for row in rows):
        raise typer.Exit(EXIT_SOME_FAILED)


def pace(done: int, total: int, start: float) -> str:
    """Return rate and time left of a batch, from its second visitor on."""
    spent = time.monotonic() - start
    if done < 2 or done == total or spent <= 0.0:
        return ""
    left = spent / done * (total - done)
    return f"  ({3600 * done / spent:.0f} an hour, {left / 60:.0f} min left)"


def render(
    clone_path: CloneArgument,
    out: Annotated[Path, typer.Option("--out", help="PNG file to write.")],
    view: Annotated[str, typer.Option("--view", help="front, side, left, back, three_quarter, face, ...")] = "front",
    size: Annotated[str, typer.Option("--size", help="Width x height in pixels.")] = "800x1200",
) -> None:
    """Draw a finished clone, or a crowd from its pack."""
    from cloner.crowd.packs.still import draw_pack, is_pack
    from cloner.picture import draw_file

    (draw_pack if is_pack(clone_path) else draw_file)(clone_path, view, out, size)
    typer.echo(str(out))


def animate(
    clone_path: CloneArgument,
    sources: Annotated[
        list[Path],
        typer.Argument(
            metavar="SOURCE...", help="Captures (.bvh, .amc), speech (.wav, text, phonemes: .txt), face (.fap, .toml)."
        ),
    ],
    out: Annotated[Path, typer.Option("--out", help="The file to write: .glb, .vrm, .wrl, .x3d or .usdz.")],
    cycles: Annotated[bool, typer.Option("--cycle", help="Make an endless walk on the spot of each capture.")] = False,
    emotion: Annotated[str, typer.Option(help="Mood of a speech: joy, sadness, anger, fear, disgust, surprise.")] = "",
) -> None:
    """Lay motion captures, speech and facial animation on a finished clone."""
    from cloner.animating import animate_file

    for path in animate_file(clone_path, sources, out, cycles=cycles, emotion=emotion):
        typer.echo(str(path))
