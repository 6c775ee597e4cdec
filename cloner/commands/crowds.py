"""The commands of ``cloner crowd``: packs of clones, and scenarios that they act."""

from __future__ import annotations

from functools import partial
from pathlib import Path
from typing import Annotated, Any

import typer
import typer.core

from cloner.commands.options import at_once, say
from cloner.terminal import ProgressLine


class _Makes(typer.core.TyperGroup):
    """``cloner crowd RESULTS...`` makes a pack: the word ``make`` may be left out."""

    def parse_args(self, ctx: Any, args: list[str]) -> list[str]:
        """Add the word, unless another command or help is asked for."""
        if args and args[0] not in {*self.commands, "--help"}:
            args = ["make", *args]
        return super().parse_args(ctx, args)


crowds = typer.Typer(
    cls=_Makes, no_args_is_help=True, rich_markup_mode=None,
    help="Crowds of clones, and scenarios that they act: cloner crowd RESULTS... --out PACK makes a crowd.",
)  # fmt: skip
ScenarioArgument = Annotated[Path, typer.Argument(metavar="SCENARIO", help="Its text, such as samples/museum.crowd.")]


@crowds.command("make")
def _make(
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
    feelings: Annotated[bool, typer.Option("--feelings", help="Walks of feelings and acts, for crowd bake.")] = False,
    classic: Annotated[bool, typer.Option("--classic", help="Impostors of the plain kind, to compare with.")] = False,
    compressed: Annotated[bool, typer.Option("--compressed", help="A third of a card's memory, less fine.")] = False,
    mirror: Annotated[bool, typer.Option("--mirror", help="Impostors of one side where both look alike.")] = False,
    statues: Annotated[str, typer.Option("--statues", help="Everybody in this material too: stone, clay ...")] = "",
    faces: Annotated[bool, typer.Option("--faces", help="Faces that show feelings and can speak in films.")] = False,
) -> None:
    """Make a crowd of finished clones: a page for browsers, levels and impostors for engines.

    The word make may be left out.
    """
    from cloner.crowd.packs.pack import make_pack
    from cloner.crowd.packs.wanted import PackOptions, parse_rings

    carved = None
    if statues:
        from cloner.statues.carved import check_material, statue_of

        check_material(statues)
        carved = partial(statue_of, material=statues)
    wanted = PackOptions(
        people,
        views,
        poses,
        parse_rings(rings),
        looks,
        scene,
        vat,
        tuple(walks or ()),
        feelings,
        classic,
        compressed,
        mirror,
        carved,
        faces,
    )
    make_pack(results, out, wanted, lambda name, k, n: typer.echo(f"{k}/{n} {name}", err=True))
    typer.echo(str(out / "player.html"))


@crowds.command("check")
def _check(
    path: Annotated[Path, typer.Argument(metavar="SCENARIO", help="A scenario, or a folder that cloner crowd wrote.")],
) -> None:
    """Say what a scenario holds, or what is wrong with it and where; or whether a crowd's folder is whole."""
    if path.is_dir():
        from cloner.crowd.packs.check import check_pack

        say(check_pack(path))
    else:
        from cloner.behaviour.written import check_file

        say(check_file(path))


@crowds.command("run")
def _run(
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
    say(lines)


@crowds.command("guide")
def _guide(
    scenario: ScenarioArgument,
    out: Annotated[Path, typer.Option("--out", help="The file of trajectories to write at the end.")],
    seconds: Annotated[float, typer.Option("--seconds", help="How long at most.")] = 3600.0,
    seed: Annotated[int, typer.Option("--seed", help="As for run.")] = 0,
    port: Annotated[int, typer.Option("--port", help="Of this machine only; any free one by default.")] = 0,
) -> None:
    """Let a scenario's people walk by the clock, guided by other programs of this machine."""
    from cloner.behaviour.written import guide_file

    for line in guide_file(scenario, out, seconds=seconds, seed=seed, port=port, report=at_once):
        typer.echo(line)


@crowds.command("bake")
def _bake(
    source: Annotated[Path, typer.Argument(metavar="WALK", help="What crowd run wrote, or a scenario's text.")],
    pack: Annotated[Path, typer.Option("--pack", help="What cloner crowd --feelings wrote.")],
    out: Annotated[Path, typer.Option("--out", help="Folder of the new pack, whose page plays it.")],
    seconds: Annotated[float, typer.Option("--seconds", help="How long, for a scenario.")] = 60.0,
    seed: Annotated[int, typer.Option("--seed", help="As for run, for a scenario.")] = 0,
) -> None:
    """Let a pack's clones act a scenario in a page for browsers."""
    from cloner.acting.written import bake_file

    with ProgressLine() as progress:
        lines = bake_file(source, pack, out, seconds=seconds, seed=seed, progress=progress)
    say(lines)
