"""What packs hold of whom: for listing, handing out and forgetting. One call: :func:`packs_of`.

A pack holds a person's face many times over, inside its pictures and inside its page; there is no taking one person out
of it by hand. So whoever is forgotten takes the pack along: it is deleted, and made again without the person.
"""

from __future__ import annotations

import shutil
from collections.abc import Iterator
from pathlib import Path

from cloner.crowd.files import MARK
from cloner.crowd.reading import read_facts
from cloner.errors import ClonerError


def packs_below(root: Path) -> Iterator[Path]:
    """Yield the packs below a folder, three folders deep, in order of their names."""
    patterns = (MARK, f"*/{MARK}", f"*/*/{MARK}", f"*/*/*/{MARK}")
    yield from sorted({found.parent for pattern in patterns for found in root.glob(pattern)})


def packs_of(identifier: str, root: Path) -> tuple[Path, ...]:
    """Return the packs below a folder that show a person; those that cannot be read count, as nobody can say no."""
    return tuple(pack for pack in packs_below(root) if identifier in shown_in(pack, otherwise=(identifier,)))


def shown_in(pack: Path, otherwise: tuple[str, ...] = ()) -> tuple[str, ...]:
    """Return who is in a pack, ``otherwise`` where its description is broken."""
    try:
        return tuple(str(row["id"]) for row in read_facts(pack)["people"])
    except ClonerError:
        return otherwise


def files_of(identifier: str, pack: Path) -> tuple[Path, ...]:
    """Return the files of a pack that are one person's, for handing out; the page is everybody's and stays."""
    return tuple(sorted(path for path in (pack / "people" / identifier).rglob("*") if path.is_file()))


def forget_packs(identifier: str, root: Path) -> tuple[str, ...]:
    """Delete every pack below a folder that shows a person and return their names.

    Raises
    ------
    ClonerError
        If one cannot be deleted.
    """
    gone = []
    for pack in packs_of(identifier, root):
        aside = pack.with_name(f".forgotten-{pack.name}")
        try:
            pack.rename(aside)
            shutil.rmtree(aside)
        except OSError as error:
            raise ClonerError("a crowd could not be deleted", "Check its permissions and repeat", pack.name) from error
        gone.append(pack.name)
    return tuple(gone)
