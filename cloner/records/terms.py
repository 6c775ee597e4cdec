"""What a person allows others to do with their likeness."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Final

#: Licences a consent may name, the narrowest first; a recorded consent that names none means the first.
LICENCES: Final = ("own", "event", "everyone")
#: Characters of a name that files are written with; taste: a line.
LONGEST_TERM: Final = 200


@dataclass(frozen=True, slots=True)
class Terms:
    """Who is shown, at which event, and what others may do; all empty where no consent was recorded.

    Attributes
    ----------
    name : str
        The person's name or number as it was given; "" where none was.
    event : str
        What the event is called; "" where it is not known.
    licence : str
        One of `LICENCES`; "" allows nobody anything.
    """

    name: str = ""
    event: str = ""
    licence: str = ""

    def __post_init__(self) -> None:
        if self.licence not in ("", *LICENCES):
            raise ValueError(f"the licence {self.licence!r} is not known")
