"""The motions that every clone leaves with."""

from __future__ import annotations

from collections.abc import Callable, Sequence

from cloner.motion.limbs.body import body_of
from cloner.motion.moves.gait import idle, walk
from cloner.records.clones import Clone
from cloner.records.motions import Motion
from cloner.remembered import once_each

#: Makes the motions of a clone as it is given: with its joints, in its rest pose.
Moves = Callable[[Clone], Sequence[Motion]]


@once_each
def own_motions(clone: Clone) -> tuple[Motion, ...]:
    """Return walk and idle in the clone's own proportions."""
    body = body_of(clone)
    return walk(body), idle(body)
