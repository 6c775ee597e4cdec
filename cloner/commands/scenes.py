"""The command line's ``cloner scene``: rooms from plans, their light, and clones in them."""

from __future__ import annotations

from pathlib import Path
from typing import Annotated

import typer

from cloner.commands.options import at_once, say
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

    say(make_folder(plan, out))


@scenes.command("light")
def _light(folder: FolderArgument) -> None:
    """Work out a room's light: light maps in room.glb, and probes for figures."""
    from cloner.scenes.written import light_folder

    with ProgressLine() as progress:
        lines = light_folder(folder, progress)
    say(lines)


@scenes.command("sound")
def _sound(folder: FolderArgument) -> None:
    """Work out how a room sounds: an impulse response for each floor, as WAV files."""
    from cloner.scenes.written import sound_folder

    with ProgressLine() as progress:
        lines = sound_folder(folder, progress)
    say(lines)


@scenes.command("build")
def _build(
    folder: FolderArgument,
    walk: Annotated[Path, typer.Option("--walk", help="What crowd run wrote, or a scenario's text.")],
    pack: Annotated[Path, typer.Option("--pack", help="What cloner crowd --feelings wrote.")],
    out: Annotated[Path, typer.Option("--out", help="Folder of the new pack, whose page shows it.")],
    seconds: Annotated[float, typer.Option("--seconds", help="How long, for a scenario.")] = 60.0,
    seed: Annotated[int, typer.Option("--seed", help="As for crowd run, for a scenario.")] = 0,
) -> None:
    """Let a pack's clones act in a lit room, in a page for browsers."""
    from cloner.scenes.inhabited import build_folder

    with ProgressLine() as progress:
        lines = build_folder(folder, walk, pack, out, seconds=seconds, seed=seed, progress=progress)
    say(lines)


@scenes.command("film")
def _film(
    sequence: Annotated[Path, typer.Argument(metavar="FILM", help="Its lines, such as samples/awakening.film.")],
    room: Annotated[Path, typer.Option("--room", help="What scene light wrote.")],
    pack: Annotated[Path, typer.Option("--pack", help="What cloner crowd --feelings wrote, --statues or --faces too.")],
    out: Annotated[Path | None, typer.Option("--out", help="film.mp4, .webp or .gif, or a folder for PNGs.")] = None,
    page: Annotated[Path | None, typer.Option("--page", help="Folder of a pack whose page plays the film.")] = None,
) -> None:
    """Play a film of clones in a lit room: into a file, pictures, or a page."""
    from cloner.scenes.filmed import film_file

    with ProgressLine() as progress:
        lines = film_file(sequence, room, pack, out, page, progress)
    say(lines)


@scenes.command("serve")
def _serve(
    built: Annotated[Path, typer.Argument(metavar="SCENE", help="What scene build wrote.")],
    clones: Annotated[Path, typer.Option("--clones", help="An event's folder, or a folder of results.")],
    host: Annotated[
        str, typer.Option("--host", help="This machine's address in a network whose machines may show it too.")
    ] = "127.0.0.1",
    port: Annotated[int, typer.Option("--port", help="Any free one by default.")] = 0,
    lent: Annotated[bool, typer.Option("--lent", help="Other booths may lend their visitors' clones.")] = False,
) -> None:
    """Show a built scene in a browser of this machine; finished clones come into it. Ctrl+C ends it."""
    from cloner.booth.scene_access import finished_clones, pin_check
    from cloner.scenes.served.lending import accept_lent_clones
    from cloner.scenes.served.serving import serve_folder

    opens, way = pin_check(clones), accept_lent_clones if lent else None
    serve_folder(built, finished_clones(clones), opens, host=host, port=port, lent=way, said=at_once)


@scenes.command("lend")
def _lend(
    address: Annotated[
        str, typer.Argument(metavar="ADDRESS", help="What scene serve --lent printed at another booth.")
    ],
    clones: Annotated[Path, typer.Option("--clones", help="An event's folder, or a folder of results.")],
) -> None:
    """Lend this booth's clones to another booth's scene for as long as this runs. Ctrl+C ends it."""
    from cloner.booth.scene_access import finished_clones
    from cloner.scenes.served.lending import lend_folder

    lend_folder(address, finished_clones(clones), at_once)
