"""What packs hold of whom: for listing, handing out and forgetting. See :func:`folders_of`.

A pack holds a person's face many times over, inside its pictures and inside its page; there is no taking one person out
of it by hand. So whoever is forgotten takes the pack along: it is deleted, and made again without the person.
"""

from __future__ import annotations

from collections.abc import Iterator
from pathlib import Path
from typing import Final

from cloner.errors import ClonerError

#: The file that makes a folder a pack.
MARK: Final = "crowd.json"
#: Where a pack keeps what is one person's.
PEOPLE = "people"


def packs_below(root: Path) -> Iterator[Path]:
    """Yield the packs below a folder, three folders deep, in order of their names."""
    patterns = (MARK, f"*/{MARK}", f"*/*/{MARK}", f"*/*/*/{MARK}")
    yield from sorted({found.parent for pattern in patterns for found in root.glob(pattern)})


def packs_of(identifier: str, root: Path) -> tuple[Path, ...]:
    """Return the packs below a folder that show a person; those that cannot be read count, as nobody can say no."""
    return tuple(pack for pack in packs_below(root) if identifier in shown_in(pack, otherwise=(identifier,)))


def shown_in(pack: Path, otherwise: tuple[str, ...] = ()) -> tuple[str, ...]:
    """Return who is in a pack, ``otherwise`` where its description is broken."""
    from cloner.crowd.reading import read_facts  # with all that draws crowds: a second that no window's start has

    try:
        return tuple(str(row["id"]) for row in read_facts(pack)["people"])
    except ClonerError:
        return otherwise


def people_in_packs(root: Path) -> tuple[str, ...]:
    """Return everybody in the packs below a folder, by name."""
    return tuple(sorted({name for pack in packs_below(root) for name in shown_in(pack)}))


def folders_of(identifier: str, root: Path) -> tuple[Path, ...]:
    """Return a person's own folders inside the packs below a folder."""
    return tuple(pack / PEOPLE / identifier for pack in packs_of(identifier, root))


def pack_of(folder: Path) -> Path:
    """Return the pack of a person's folder: it goes whole when the person is forgotten."""
    return folder.parent.parent
