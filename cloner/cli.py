"""The command line: ``cloner clone``, ``batch``, ``render``, ``animate``, ``body``, ``gui``, ``doctor`` and others."""

from __future__ import annotations

import json
import logging
import os
import signal
import sys
import time
from functools import partial
from pathlib import Path
from types import FrameType
from typing import TYPE_CHECKING, Annotated, Final

import typer

import cloner
from cloner.cli_scenes import scenes
from cloner.cli_statues import statues
from cloner.errors import ClonerError, plain
from cloner.terminal import EXIT_CANCELLED, EXIT_INPUT, EXIT_SOME_FAILED, ProgressLine, ended, split_formats

# The commands import their part when they run: `doctor` must work where a library is missing.
if TYPE_CHECKING:
    from cloner.records.batches import BatchRow

__all__ = ["EXIT_CANCELLED", "EXIT_INPUT", "app", "main", "split_formats"]
DEFAULT_FORMATS: Final = "glb,wrl"
DEFAULT_TEXTURE_SIZE: Final = 2048
UNPROTECTED: Final = "--unprotected-cluster-lets-anybody-on-the-network-run-code"

app = typer.Typer(
    name="cloner",
    help="Five photographs and a height in, an animatable textured human out. Offline; nothing leaves this machine.",
    no_args_is_help=True,
    add_completion=False,
    pretty_exceptions_enable=False,
    rich_markup_mode=None,
)

HeightOption = Annotated[
    float | None, typer.Option("--height-cm", help="Barefoot height in cm; wins over person.toml.")
]
FormatOption = Annotated[
    str,
    typer.Option(
        "--format",
        help="Formats, with commas: glb,small,mixamo,unity,unreal,wrl,hanim,flat,x3d,vrm,vrma,usdz,obj,ply,regions.",
    ),
]
SeedOption = Annotated[int, typer.Option("--seed", help="The same photos and seed give the same clone.")]
SizeOption = Annotated[
    int, typer.Option("--size", "--texture-size", help="Side of the texture in texels: 512, 1024, 2048 or 4096.")
]
OutOption = Annotated[Path, typer.Option("--out", help="Folder that receives the results.")]


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


@app.command("clone")
def _clone(
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


@app.command("batch")
def _batch(
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

    rows = batch_folder(photos_root, out, options, told=tell)
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


@app.command("render")
def _render(
    clone_path: Annotated[Path, typer.Argument(metavar="CLONE", help="A result's folder or its clone.npz.")],
    out: Annotated[Path, typer.Option("--out", help="PNG file to write.")],
    view: Annotated[str, typer.Option("--view", help="front, side, left, back, three_quarter, face, ...")] = "front",
    size: Annotated[str, typer.Option("--size", help="Width x height in pixels.")] = "800x1200",
) -> None:
    """Draw a finished clone, or a crowd from its pack."""
    from cloner.crowd.still import draw_pack, is_pack
    from cloner.picture import draw_file

    (draw_pack if is_pack(clone_path) else draw_file)(clone_path, view, out, size)
    typer.echo(str(out))


@app.command("animate")
def _animate(
    clone_path: Annotated[Path, typer.Argument(metavar="CLONE", help="A result's folder or its clone.npz.")],
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


@app.command("body")
def _body(
    out: OutOption,
    identifier: Annotated[str, typer.Option("--id", help="Name of the result's folder.")],
    sex: Annotated[str, typer.Option("--sex", help="f or m.")] = "",
    stature: Annotated[float | None, typer.Option("--stature", help="Barefoot height in cm.")] = None,
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
    from cloner.bodies.written import body_folder

    told = {name: value for name, value in (("bust", bust), ("waist", waist), ("hip", hip)) if value is not None}
    for name, value in map(named_number, measures or ()):
        if name in told:
            raise ClonerError(f"{name} is given twice", "Keep one of both", "--measure")
        told[name] = value
    with ProgressLine() as progress:
        folder, lines = body_folder(
            out, identifier, sex=sex.lower(), stature_cm=stature, measures_cm=told, formats=split_formats(formats),
            texture_size=size, source=source, progress=progress,
        )  # fmt: skip
    for line in lines:
        typer.echo(line)
    typer.echo(str(folder))


@app.command("undress")
def _undress(
    clone_path: Annotated[Path, typer.Argument(metavar="CLONE", help="A result's folder or its clone.npz.")],
    out: OutOption,
    identifier: Annotated[str, typer.Option("--id", help="Name of the result's folder.")] = "",
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


@app.command("dress")
def _dress(
    clone_path: Annotated[Path, typer.Argument(metavar="CLONE", help="A result's folder or its clone.npz.")],
    out: Annotated[Path, typer.Option("--out", help="The file: .glb, .pc2, .usdc, or a film: .gif, .webp, .mp4.")],
    garment: Annotated[
        str,
        typer.Option(help="skirt, circle-, straight-, long-skirt, cape, tee, dress, coat, trousers, .json or .svg."),
    ] = "skirt",
    fabric: Annotated[str, typer.Option(help="silk, cotton, linen, wool, denim or burlap.")] = "cotton",
    motion: Annotated[str, typer.Option(help="walk, or a captured walk (.bvh).")] = "walk",
    length: Annotated[float | None, typer.Option("--length", help="Length in cm.")] = None,
    over: Annotated[
        list[str] | None, typer.Option("--over", help="Worn over it: GARMENT or GARMENT:FABRIC. Repeat it.")
    ] = None,
) -> None:
    """Put a garment on a clone and let its cloth flow in a loop with the walk."""
    from cloner.cloth.written import dress_file

    worn_over = [(name, other or fabric) for name, _, other in (one.partition(":") for one in over or ())]

    with ProgressLine() as progress:
        lines = dress_file(
            clone_path,
            out,
            garment=garment,
            fabric=fabric,
            motion=motion,
            length_cm=length,
            over=worn_over,
            progress=progress,
        )
    for line in lines:
        typer.echo(line)


app.add_typer(statues, name="statue")


@app.command("crowd")
def _crowd(
    results: Annotated[list[Path], typer.Argument(metavar="RESULTS...", help="Result folders, or a batch's output.")],
    out: Annotated[Path, typer.Option("--out", help="Folder of the pack to write.")],
    people: Annotated[int, typer.Option("--people", help="How many people the player starts with.")] = 5000,
    views: Annotated[int, typer.Option("--views", help="Impostors around a clone; 0: 22, or 40 for broad ones.")] = 0,
    poses: Annotated[int, typer.Option("--poses", help="Poses a walk: 8, 12, 16 or 24.")] = 16,
    rings: Annotated[str, typer.Option("--rings", help="Elevations of the impostors, degrees, with commas.")] = "5",
    looks: Annotated[Path | None, typer.Option("--looks", help="Palettes and wardrobe: looks.toml.")] = None,
    scene: Annotated[str, typer.Option("--scene", help="walk, plaza or stadium.")] = "plaza",
    vat: Annotated[bool, typer.Option("--vat", help="Vertex animation textures for engines too.")] = False,
    walks: Annotated[list[Path] | None, typer.Option("--walk", help="A captured walk (.bvh, .amc) more.")] = None,
    feelings: Annotated[bool, typer.Option("--feelings", help="Walks of feelings and acts, for behave bake.")] = False,
    classic: Annotated[bool, typer.Option("--classic", help="Impostors of the plain kind, to compare with.")] = False,
    statues: Annotated[str, typer.Option("--statues", help="Everybody in this material too: stone, clay ...")] = "",
) -> None:
    """Make a crowd of finished clones: a page for browsers, levels and impostors for engines."""
    from cloner.crowd.pack import Wanted, make_pack, rings_of

    carved = None
    if statues:
        from cloner.statues.carved import check_material, statue_of

        check_material(statues)
        carved = partial(statue_of, material=statues)
    wanted = Wanted(
        people, views, poses, rings_of(rings), looks, scene, vat, tuple(walks or ()), feelings, classic, carved
    )
    make_pack(results, out, wanted, lambda name, k, n: typer.echo(f"{k}/{n} {name}", err=True))
    typer.echo(str(out / "player.html"))


@app.command("crowd-check")
def _crowd_check(pack: Annotated[Path, typer.Argument(metavar="PACK", help="Folder that cloner crowd wrote.")]) -> None:
    """Say whether a crowd's pack is whole, and what is in it."""
    from cloner.crowd.check import check_pack

    for line in check_pack(pack):
        typer.echo(line)


app.add_typer(scenes, name="scene")
behaves = typer.Typer(no_args_is_help=True, rich_markup_mode=None, help="Crowds with a mind: scenarios.")
app.add_typer(behaves, name="behave")
ScenarioArgument = Annotated[Path, typer.Argument(metavar="SCENARIO", help="Its text, such as samples/museum.crowd.")]


@behaves.command("check")
def _behave_check(scenario: ScenarioArgument) -> None:
    """Say what a scenario holds, or what is wrong with it and where."""
    from cloner.behaviour.written import check_file

    for line in check_file(scenario):
        typer.echo(line)


@behaves.command("run")
def _behave_run(
    scenario: ScenarioArgument,
    out: Annotated[Path, typer.Option("--out", help="The file of trajectories to write.")],
    seconds: Annotated[float, typer.Option("--seconds", help="How long.")] = 60.0,
    seed: Annotated[int, typer.Option("--seed", help="The same scenario and seed: the same steps.")] = 0,
    picture: Annotated[Path | None, typer.Option("--picture", help="The end from above (.png).")] = None,
    film: Annotated[Path | None, typer.Option("--film", help="All from above (.mp4, .gif, .webp).")] = None,
) -> None:
    """Let a scenario's people walk."""
    from cloner.behaviour.written import run_file

    with ProgressLine() as progress:
        lines = run_file(scenario, out, seconds=seconds, seed=seed, picture=picture, film=film, progress=progress)
    for line in lines:
        typer.echo(line)


@behaves.command("guide")
def _behave_guide(
    scenario: ScenarioArgument,
    out: Annotated[Path, typer.Option("--out", help="The file of trajectories to write at the end.")],
    seconds: Annotated[float, typer.Option("--seconds", help="How long at most.")] = 3600.0,
    seed: Annotated[int, typer.Option("--seed", help="As for run.")] = 0,
    port: Annotated[int, typer.Option("--port", help="Of this machine only; any free one by default.")] = 0,
) -> None:
    """Let a scenario's people walk by the clock, guided by other programs of this machine."""
    from cloner.behaviour.written import guide_file

    for line in guide_file(scenario, out, seconds=seconds, seed=seed, port=port, told=_at_once):
        typer.echo(line)


def _at_once(line: str) -> None:
    """Print a line that another program may be waiting for."""
    typer.echo(line)
    sys.stdout.flush()


@behaves.command("bake")
def _behave_bake(
    source: Annotated[Path, typer.Argument(metavar="WALK", help="What behave run wrote, or a scenario's text.")],
    pack: Annotated[Path, typer.Option("--pack", help="What cloner crowd --feelings wrote.")],
    out: Annotated[Path, typer.Option("--out", help="Folder of the new pack, whose page plays it.")],
    seconds: Annotated[float, typer.Option("--seconds", help="How long, for a scenario.")] = 60.0,
    seed: Annotated[int, typer.Option("--seed", help="As for run, for a scenario.")] = 0,
) -> None:
    """Let a pack's clones act a scenario in a page for browsers."""
    from cloner.acting.written import bake_file

    with ProgressLine() as progress:
        lines = bake_file(source, pack, out, seconds=seconds, seed=seed, progress=progress)
    for line in lines:
        typer.echo(line)


@app.command("evaluate")
def _evaluate(
    visitors: Annotated[
        list[Path], typer.Argument(help="Visitors or generated people with truth, such as samples/anna.")
    ],
    sets: Annotated[list[str] | None, typer.Option("--set", help="plain, booth or handheld; all by default.")] = None,
    out: Annotated[Path | None, typer.Option("--out", help="Keep the clones in this folder.")] = None,
    seed: SeedOption = 0,
    as_json: Annotated[bool, typer.Option("--json", help="Print the rows as JSON.")] = False,
) -> None:
    """Score clones of visitors whose truth is known."""
    from cloner.evaluate import evaluate_visitors, format_table
    from cloner.evaluate.truth import SETS

    sentences: list[str] = []
    with ProgressLine() as progress:
        rows = evaluate_visitors(
            visitors, tuple(sets or SETS), out, progress=progress, told=sentences.append, seed=seed
        )
    for sentence in sentences:
        typer.echo(sentence, err=True)
    typer.echo(json.dumps(rows, indent=1) if as_json else format_table(rows))


PhotosRootOption = Annotated[
    Path | None, typer.Option("--photos", help="Folder that holds the visitors' folders of photos.")
]
ResultsOption = Annotated[Path | None, typer.Option("--out", help="Folder that holds the results.")]


@app.command("list")
def _list(photos: PhotosRootOption = None, out: ResultsOption = None) -> None:
    """Say what is held of whom."""
    from cloner.holdings import holdings, table

    typer.echo(table(holdings(photos, out)))


@app.command("export-data")
def _export_data(
    identifier: Annotated[str, typer.Argument(help="As cloner list shows it.")],
    to: Annotated[Path, typer.Option("--to", help="The .zip file to write.")],
    photos: PhotosRootOption = None,
    out: ResultsOption = None,
) -> None:
    """Hand out everything that is held of a visitor."""
    from cloner.holdings import find_holding, holdings
    from cloner.privacy import export_data

    typer.echo(str(export_data(find_holding(identifier, holdings(photos, out)), to)))


@app.command("forget")
def _forget(
    identifiers: Annotated[list[str] | None, typer.Argument(help="As cloner list shows them.")] = None,
    older_days: Annotated[
        float | None, typer.Option("--older-than", min=0, help="Everybody whose last change is so many days ago.")
    ] = None,
    photos: PhotosRootOption = None,
    out: ResultsOption = None,
) -> None:
    """Delete photos, results and batch rows of visitors, for good."""
    from cloner.holdings import find_holding, holdings, older_than
    from cloner.privacy import forget

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
        told = ", ".join(plain(one) for one in sorted(set(left)))
        typer.echo(f"still there, or telling of them: {told}", err=True)
        raise typer.Exit(EXIT_SOME_FAILED)


@app.command("gui")
def _gui(
    folder: Annotated[Path | None, typer.Argument(help="The event's folder, or one visitor's.")] = None,
) -> None:
    """Open the window."""
    from cloner_gui.app import run_app

    raise typer.Exit(run_app(folder))


@app.command("doctor")
def _doctor(
    brief: Annotated[bool, typer.Option("--brief", help="Say only what is missing.")] = False,
    folders: Annotated[
        list[Path] | None, typer.Option("--folder", help="A folder of photos or results: who else may read it?")
    ] = None,
) -> None:
    """Say what is missing on this machine and the line that fixes it."""
    from cloner.doctor import examine
    from cloner.permissions import examine_folder

    findings = (*examine(), *(finding for folder in folders or () for finding in examine_folder(folder)))
    for finding in findings:
        if not brief or not finding.fine:
            typer.echo(finding.line())
    if all(finding.fine for finding in findings):
        typer.echo("Everything Cloner needs is here.")
    elif any(finding.needed and not finding.fine for finding in findings):
        raise typer.Exit(EXIT_SOME_FAILED)


clusters = typer.Typer(no_args_is_help=True, rich_markup_mode=None, help="What a cluster of machines needs.")
app.add_typer(clusters, name="cluster")


@clusters.command("keys")
def _cluster_keys(folder: Annotated[Path, typer.Argument(help="New folder for certificates and settings.")]) -> None:
    """Make certificates: only who holds them speaks with scheduler and workers, and encrypted."""
    from cloner.cluster_keys import DAYS, SETTINGS, make_keys

    settings = next(path for path in make_keys(folder) if path.name == SETTINGS)
    typer.echo(f"{folder}: certificates for {DAYS} days. Copy the folder to the same place on every machine, then:")
    typer.echo(f"  DASK_CONFIG={settings} dask scheduler --protocol tls --dashboard-address 127.0.0.1:0")
    typer.echo(f"  DASK_CONFIG={settings} dask worker tls://HOST:8786 --nthreads 1")
    typer.echo(f"  cloner batch ... --scheduler tls://HOST:8786 --cluster-keys {folder}")


@clusters.callback()
def _cluster() -> None:
    """Keep "keys" a word of its own: a group of one command would swallow it."""


def named_number(text: str) -> tuple[str, float]:
    """Return the name and the number of NAME=NUMBER."""
    name, _, value = text.partition("=")
    try:
        return name.strip(), float(value)
    except ValueError as error:
        hint = "Write a name and centimetres, such as --measure inside_leg=78"
        raise ClonerError(f"{text!r} is no measure", hint, "--measure") from error


def main() -> None:
    """Run the command line and exit with its code."""
    for name in ("SIGTERM", "SIGHUP"):  # a closed terminal ends a command as tidily as Ctrl-C; Windows has no SIGHUP
        number = getattr(signal, name, None)
        if number is not None and signal.getsignal(number) is not signal.SIG_IGN:  # nohup is obeyed
            signal.signal(number, _stop)
    os.umask(0o077)  # results hold a person's likeness: nobody else's business on a shared machine
    sys.exit(ended(lambda: app(standalone_mode=False)))


def _stop(number: int, frame: FrameType | None) -> None:
    """Treat a request to end like Ctrl-C, so that temporary folders are removed."""
    raise KeyboardInterrupt
