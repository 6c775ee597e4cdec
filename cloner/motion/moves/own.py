"""The motions exported with every clone."""

from __future__ import annotations

from collections.abc import Callable, Sequence

from cloner.caching import cached_per_object
from cloner.motion.limbs.body import body_of
from cloner.motion.moves.gait import idle, walk
from cloner.motion.moves.styles import REGULAR, suited
from cloner.records.clones import Clone
from cloner.records.motions import Motion

#: Makes the motions of a clone as it is given: with its joints, in its rest pose.
Moves = Callable[[Clone], Sequence[Motion]]


@cached_per_object
def own_motions(clone: Clone) -> tuple[Motion, ...]:
    """Return walk and idle in the clone's own proportions, the walk by its sex and age where given."""
    body = body_of(clone)
    return walk(body, suited(REGULAR, clone.sex, clone.age_years)), idle(body)
