"""Personal data in packs: for listing, export and deletion. See :func:`folders_of`.

A pack holds a person's face many times over, inside its pictures and inside its page; there is no taking one person out
of it by hand. So whoever is forgotten takes the pack along: it is deleted, and made again without the person.
"""

from __future__ import annotations

import mmap
import re
from collections.abc import Iterable, Iterator, Mapping, Set
from pathlib import Path
from typing import Any, Final

from cloner.errors import ClonerError
from cloner.untrusted import open_untrusted, walk_files

#: The file that makes a folder a pack.
MARK: Final = "crowd.json"
#: Where a pack keeps what is one person's.
PEOPLE = "people"
#: How a film or picture of a pack begins to tell of whose photos the clones in it are, and the files that may.
FILMED: Final = "Cloner shows people of photos"
FILMS: Final = (".mp4", ".webp", ".gif", ".png")
_TOKEN: Final = re.compile(r"photos ([0-9a-f]{32})")
_TOKENS: Final = re.compile(FILMED.encode() + rb"((?: [0-9a-f]{32})*)")


def find_packs(root: Path) -> Iterator[Path]:
    """Yield the packs below a folder, three folders deep, sorted by name."""
    patterns = (MARK, f"*/{MARK}", f"*/*/{MARK}", f"*/*/*/{MARK}")
    yield from sorted({found.parent for pattern in patterns for found in root.glob(pattern)})


def packs_of(identifier: str, root: Path) -> tuple[Path, ...]:
    """Return the packs below a folder that show a person; unreadable packs count, as they may."""
    return tuple(pack for pack in find_packs(root) if identifier in people_in_pack(pack, otherwise=(identifier,)))


def people_in_pack(pack: Path, otherwise: tuple[str, ...] = ()) -> tuple[str, ...]:
    """Return who is in a pack, ``otherwise`` if its description is damaged."""
    from cloner.crowd.packs.reading import read_facts  # with all that draws crowds: a second that no window's start has

    try:
        return tuple(str(row["id"]) for row in read_facts(pack)["people"])
    except ClonerError:
        return otherwise


def people_in_packs(root: Path) -> tuple[str, ...]:
    """Return everybody in the packs below a folder, by name."""
    return tuple(sorted({name for pack in find_packs(root) for name in people_in_pack(pack)}))


def folders_of(identifier: str, root: Path) -> tuple[Path, ...]:
    """Return a person's own folders inside the packs below a folder."""
    return tuple(pack / PEOPLE / identifier for pack in packs_of(identifier, root))


def pack_of(folder: Path) -> Path:
    """Return the pack of a person's folder: it is deleted as a whole when the person is forgotten."""
    return folder.parent.parent


def film_tokens(people: Iterable[Mapping[str, Any]]) -> str:
    """Return what a film or picture of a pack's clones records of whom it shows: enough to find it, no name.

    Parameters
    ----------
    people : rows of ``people`` in ``crowd.json``
    """
    tokens = {token for row in people for token in _TOKEN.findall(str(row["stamp"]))}
    return " ".join((FILMED, *sorted(tokens)))


def find_films(root: Path, tokens: Set[str]) -> Iterator[Path]:
    """Yield the films and pictures of packs below a folder that show clones of photos; see `photos_token`."""
    for path in walk_files(root):
        if path.suffix.lower() in FILMS and not path.is_symlink() and not tokens.isdisjoint(_filmed_in(path)):
            yield path


def _filmed_in(path: Path) -> list[str]:
    """Return the tokens in a film or picture; none if it cannot be read."""
    try:
        with open_untrusted(path) as stream, mmap.mmap(stream.fileno(), 0, access=mmap.ACCESS_READ) as content:
            found = _TOKENS.search(content)
            return found[1].decode("ascii").split() if found else []
    except (OSError, ValueError):  # an empty file cannot be mapped
        return []
