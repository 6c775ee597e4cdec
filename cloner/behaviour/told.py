"""Events of a running scenario in words, from the engine's rows (`core/minds/told.ts`)."""

from __future__ import annotations

from collections.abc import Iterator
from typing import Final

from cloner.behaviour.tables import Names
from cloner.records.arrays import Array

#: What rows tell: the numbers of core/minds/told.ts.
_AWAKENS, _SLEEPS, _HAPPENS, _FREE, _JOINED, _LED, _SPLITS, _PART = range(8)
_SAID: Final = {
    _AWAKENS: "{thing} awakens", _SLEEPS: "{thing} sleeps", _HAPPENS: "event {event}", _FREE: "{point} is free again",
    _JOINED: "{many} joined {group}", _LED: "{group} has another leader",
}  # fmt: skip


def sentences(rows: Array, names: Names) -> Iterator[tuple[float, str]]:
    """Yield time, seconds, and sentence of rows (k, 4): time, what, which, how many."""
    lists = {"thing": names.things, "event": names.events, "point": names.points, "group": names.groups}
    k = 0
    while k < len(rows):
        when, what, which, many = float(rows[k, 0]), *(int(one) for one in rows[k, 1:])
        k += 1
        if what == _SPLITS:
            parts = [str(int(one)) for one in rows[k : k + many, 3]]
            k += many
            yield when, f"{names.groups[which]} splits into {', '.join(parts)}"
            continue
        found = {kind: some[which] for kind, some in lists.items() if which < len(some)}
        yield when, _SAID[what].format(many=many, **found)
