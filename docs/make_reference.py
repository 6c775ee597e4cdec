"""Write ``docs/commands.md`` and ``docs/api_reference.md`` from the code: ``python docs/make_reference.py``.

A test compares both with the code (``tests/unit/test_docs.py``).
"""

from __future__ import annotations

import importlib
import inspect
import re
from enum import EnumType
from pathlib import Path
from typing import Any

import typer.main

from cloner.cli import app
from cloner.exporters.table import EXPORTERS
from cloner.pipeline import STAGES

DOCS = Path(__file__).parent
CODE = DOCS.parent / "cloner"
#: What a program that uses Cloner needs, by subject.
INTERFACE = {
    "From photos to a clone": (
        "cloner.making:clone", "cloner.records.clones:Clone", "cloner.records.clones:TextureAtlas",
        "cloner.records.heads:Shell", "cloner.records.bodies:PosedView", "cloner.records.views:Camera",
        "cloner.frames:ViewId", "cloner.errors:ClonerError", "cloner.errors:Cancelled",
    ),
    "Folders of results": (
        "cloner.cloning:clone_folder", "cloner.cloning:CloneOutcome", "cloner.batch:batch_folder",
        "cloner.batch:BatchOptions", "cloner.records.batches:BatchRow", "cloner.project.clone_file:save_clone",
        "cloner.project.clone_file:load_clone",
    ),
    "Pictures and motions": (
        "cloner.render:render", "cloner.render:render_rgba", "cloner.picture:draw_file", "cloner.picture:turntable",
        "cloner.animating:animate_file", "cloner.records.motions:Motion",
    ),
    "Bodies, clothes, statues": (
        "cloner.bodies.made:clone_of_measures", "cloner.bodies.made:remeasured_clone",
        "cloner.bodies.undressed:undressed_clone", "cloner.cloth.dressing:dress_clone",
        "cloner.statues.carved:statue_of",
    ),
    "Running stages alone": (
        "cloner.making:clone_photos", "cloner.pipeline:run", "cloner.pipeline:Stage", "cloner.pipeline:StageReport",
        "cloner.records.results:StageResult", "cloner.records.results:Residual",
    ),
}  # fmt: skip


def commands_page() -> str:
    """Return the page of all commands."""
    parts = [
        "# Commands\n\nMade from the code by `python docs/make_reference.py`; `cloner COMMAND --help` says the same. "
        "[Exit codes](exit_codes.md), [what comes out](results.md).\n"
    ]
    parts += list(_commands(typer.main.get_command(app), "cloner"))
    return "\n".join(parts)


def _commands(command: Any, name: str) -> list[str]:
    if hasattr(command, "commands"):
        return [page for word, one in command.commands.items() for page in _commands(one, f"{name} {word}")]
    arguments = [one for one in command.params if one.param_type_name == "argument"]
    words = [_named(one) for one in arguments]
    rows = [f"| `{_named(one)}` | {_told(one)} |" for one in arguments]
    rows += [
        f"| `{', '.join(one.opts)}` | {_told(one)} |"
        for one in command.params
        if one not in arguments and not one.hidden
    ]
    text = " ".join((command.help or "").split())
    table = "\n".join(["| | |", "| --- | --- |", *rows]) if rows else "Takes nothing."
    return [f"## `{' '.join([name, *words])}`\n\n{text}\n\n{table}\n"]


def _named(argument: Any) -> str:
    word = argument.metavar or (argument.name or "").upper()
    return f"{word.rstrip('.')}..." if argument.nargs == -1 else word


def _told(one: Any) -> str:
    """Return an option's sentence and what it is unless told."""
    sentence = " ".join((getattr(one, "help", "") or "").split()).replace("|", "\\|")
    if one.required:
        return f"{sentence} Needed.".strip()
    plain = one.default in (None, "", False, ()) or callable(one.default) or isinstance(one.default, list)
    return sentence if plain else f"{sentence} Unless told: `{one.default}`.".strip()


def interface_page() -> str:
    """Return the page of the interface for programs: docstrings, stages, formats and rooms."""
    parts = [
        "# The Python interface\n\nMade from docstrings by `python docs/make_reference.py`; [api.md](api.md) shows its "
        "use, with examples that run in the tests. `clone`, fields of `Clone`, `ClonerError` and the names of views, "
        "joints, formats and face targets stay within a major version; everything else may move.\n"
    ]
    for subject, names in INTERFACE.items():
        parts.append(f"## {subject}\n")
        parts += [_object(name) for name in names]
    parts.append(
        "## Formats\n\n`cloner.exporters.table.EXPORTERS.get(NAME)(clone, folder)` writes and returns the paths:"
    )
    parts.append(", ".join(f"`{name}`" for name in EXPORTERS) + ". What each is: [results.md](results.md).\n")
    parts.append("## Stages\n\nIn their order; `cloner.pipeline.STAGES`.\n")
    parts.append("| stage | what | needs | gives |\n| --- | --- | --- | --- |")
    for stage in STAGES:
        module = importlib.import_module(f"cloner.stages.{stage.name}")
        cells = (f"`{stage.name}`", _first(module), ", ".join(stage.needs), ", ".join(stage.gives))
        parts.append(f"| {' | '.join(cells)} |")
    parts.append("\n## Rooms\n\n| room | what |\n| --- | --- |")
    for place in sorted(CODE.rglob("__init__.py")):
        name = ".".join(place.relative_to(CODE.parent).parent.parts)
        parts.append(f"| `{name}` | {_first(importlib.import_module(name))} |")
    return "\n".join(parts) + "\n"


def _first(module: object) -> str:
    """Return the first sentence of a docstring."""
    return (inspect.getdoc(module) or "").split("\n\n")[0].replace("\n", " ").replace("``", "`")


def _object(name: str) -> str:
    module, _, word = name.partition(":")
    found = getattr(importlib.import_module(module), word)
    shown = f"{module}.{word}"
    if inspect.isfunction(found):
        shown += _signature(found)
    if isinstance(found, EnumType):
        shown += f"  # {', '.join(one.value for one in found)}"
    methods = [
        f"- `{one}{_signature(what)}`: {_first(what)}"
        for one, what in vars(found).items()
        if isinstance(found, type) and inspect.isfunction(what) and not one.startswith("_") and what.__doc__
    ]
    return "\n".join(
        [f"### `{word}`\n", f"```python\n{shown}\n```\n", _markdown(inspect.getdoc(found) or ""), *methods, ""]
    )


class _Word:
    """What is written in a signature as it stands."""

    def __init__(self, text: str) -> None:
        self.text = text

    def __repr__(self) -> str:
        return self.text


def _signature(function: Any) -> str:
    """Return a signature as it is written: types without quotes, long defaults as dots."""
    signature = inspect.signature(function)
    given = []
    for one in signature.parameters.values():
        default = one.default
        if callable(default) and default is not one.empty:
            default = _Word(default.__name__ if default.__name__.isidentifier() else "...")
        elif default is not one.empty and len(repr(default)) > 30:
            default = _Word("...")
        kind = one.annotation if one.annotation is one.empty else _Word(str(one.annotation))
        given.append(one.replace(default=default, annotation=kind))
    return str(signature.replace(parameters=given, return_annotation=_Word(str(signature.return_annotation))))


def _markdown(text: str) -> str:
    """Return a numpydoc docstring as Markdown: headings bold, entries as a list."""
    lines, out, listed = text.split("\n"), [], False
    for k, line in enumerate(lines):
        under = k + 1 < len(lines) and re.fullmatch("-{3,}", lines[k + 1])
        if re.fullmatch("-{3,}", line):
            continue
        if under:
            out += [f"**{line}**", ""]
            listed = line in ("Parameters", "Attributes", "Returns", "Raises", "Yields")
        elif listed and line and not line.startswith(" "):
            out.append(f"- `{line}`" if " : " in line or len(line.split()) < 4 else line)
        else:
            out.append(line.rstrip() if not listed else f"  {line.strip()}".rstrip())
    return re.sub(r":\w+:`~?([\w.]+)`", r"`\1`", "\n".join(out)).replace("``", "`") + "\n"


#: The pages by name.
PAGES = {"commands.md": commands_page, "api_reference.md": interface_page}


if __name__ == "__main__":
    for page, written in PAGES.items():
        (DOCS / page).write_text(written(), encoding="utf-8")
