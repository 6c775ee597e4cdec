"""Face targets for MPEG-4 parameters: each feature by its own, lids by how far they close.

A least-squares fit over all targets would raise a mouth's corners by a dozen little pulls anywhere in the face. Here
every parameter has the few targets that people move that feature with; a frame's weights come nearest to its points.

References
----------
ISO/IEC 14496-2 (Visual), annex C: groups of FAPs, visemes (FAP 1) and expressions (FAP 2) with their blending.
"""

from __future__ import annotations

from collections.abc import Mapping
from types import MappingProxyType
from typing import Final

import numpy as np
from numpy.typing import NDArray
from scipy.optimize import lsq_linear

from cloner.motion.face.expressions import EXPRESSIONS
from cloner.motion.face.speech import VISEMES
from cloner.records.arrays import Array

#: A lid's parameter of so much takes it all the way to the other one: the distance of the lids is 1024 units.
FULL: Final = 1024.0
#: Weight of doing nothing against a parameter; keeps targets at rest that no parameter asks for.
RIDGE: Final = 0.02
#: A parameter below this asks for nothing.
LEAST: Final = 0.5
#: Smaller weights are numerical dust.
SMALLEST: Final = 0.004
BLEND_FULL: Final = 63.0
#: The standard's numbers 1 to 6.
EXPRESSION_ORDER: Final = ("joy", "sadness", "anger", "fear", "disgust", "surprise")
#: Upper lid, lower lid, side.
LIDS: Final = ((19, 21, "Left"), (20, 22, "Right"))


def _both(*names: str) -> tuple[str, ...]:
    return tuple(f"{name}{side}" for name in names for side in ("Left", "Right"))


#: Targets that move a parameter's feature, wherever the parameter is given.
OWN: Final[Mapping[int, tuple[str, ...]]] = MappingProxyType({
    3: ("jawOpen",), 14: ("jawForward",), 15: ("jawLeft", "jawRight"), 18: ("mouthShrugLower",),
    4: ("mouthRollUpper", "mouthShrugUpper", *_both("mouthUpperUp")),
    5: ("mouthShrugLower", *_both("mouthLowerDown")),
    8: ("mouthUpperUpLeft", "mouthRollUpper"), 9: ("mouthUpperUpRight", "mouthRollUpper"),
    10: ("mouthLowerDownLeft",), 11: ("mouthLowerDownRight",),
    6: ("mouthStretchLeft", "mouthDimpleLeft"), 7: ("mouthStretchRight", "mouthDimpleRight"),
    12: ("mouthSmileLeft", "mouthFrownLeft"), 13: ("mouthSmileRight", "mouthFrownRight"),
    16: ("mouthFunnel", "mouthPucker", "mouthRollLower"), 17: ("mouthFunnel", "mouthPucker", "mouthRollUpper"),
    31: ("browInnerUp", "browDownLeft"), 32: ("browInnerUp", "browDownRight"),
    33: ("browOuterUpLeft", "browDownLeft", "browInnerUp"), 34: ("browOuterUpRight", "browDownRight", "browInnerUp"),
    35: ("browOuterUpLeft", "browDownLeft"), 36: ("browOuterUpRight", "browDownRight"),
    37: ("browDownLeft",), 38: ("browDownRight",),
    39: ("cheekPuff",), 40: ("cheekPuff",), 41: ("cheekSquintLeft",), 42: ("cheekSquintRight",),
    45: ("tongueOut",), 61: ("noseSneerLeft",), 62: ("noseSneerRight",),
})  # fmt: skip
#: The same features at the lips' outer edge.
_OUTER: Final = {51: 4, 52: 5, 53: 6, 54: 7, 55: 8, 56: 9, 57: 10, 58: 11, 59: 12, 60: 13}
#: Targets that serve only where all parameters of a row are given: what they do to one, they do to the others too.
TOGETHER: Final = (
    ((6, 7), ("mouthPucker",)), ((53, 54), ("mouthPucker",)), ((3, 5), ("mouthClose",)), ((3, 52), ("mouthClose",)),
    ((12, 6), ("mouthPressLeft",)), ((13, 7), ("mouthPressRight",)), ((59, 53), ("mouthPressLeft",)),
    ((60, 54), ("mouthPressRight",)),
)  # fmt: skip
#: Parameters of one region are solved together; later ones take what earlier ones have done as given.
REGIONS: Final = (
    (*range(3, 19), *range(51, 61)), tuple(range(31, 39)), tuple(range(39, 43)), tuple(range(43, 48)),
    tuple(range(61, 65)),
)  # fmt: skip


def frame_weights(moves: Array, names: tuple[str, ...], values: Array, given: NDArray[np.bool_]) -> Array:
    """Return the weights 0..1 (N,) of the face's targets that play one frame.

    Parameters
    ----------
    moves : (68, N)
        By how many units a target moves each parameter's point when it is full on.
    names : tuple of str, N targets
    values, given : (68,)
        A frame's parameters, and which of them it names.
    """
    weights = np.zeros(len(names))
    for region in REGIONS:
        rows = np.array([number - 1 for number in region if given[number - 1]], dtype=int)
        asked = {number for number in region if given[number - 1] and abs(values[number - 1]) > LEAST}
        columns = [names.index(name) for name in sorted(_serving(asked)) if name in names]
        if not columns or not len(rows):
            continue
        # parameters of large and small motion count alike; what nothing here moves asks for nothing
        size = np.abs(moves[rows][:, columns]).max(axis=1)
        rows, size = rows[size > 1.0], size[size > 1.0]
        system = np.vstack([moves[rows][:, columns] / size[:, None], RIDGE * np.eye(len(columns))])
        left = values[rows] - moves[rows] @ weights  # the mouth comes first: jaws carry tongues, smiles lift cheeks
        wanted = np.concatenate([left / size, np.zeros(len(columns))])
        weights[columns] = np.maximum(weights[columns], lsq_linear(system, wanted, bounds=(0.0, 1.0)).x)
    for upper, lower, side in LIDS:
        for name, weight in _lids(moves, names, values, (upper, lower), side).items():
            weights[names.index(name)] = weight
    return np.where(weights > SMALLEST, weights, 0.0)


def _serving(asked: set[int]) -> set[str]:
    """Return the targets that may move what the parameters name."""
    inner = asked | {_OUTER[number] for number in asked if number in _OUTER}
    found = {name for number in inner for name in OWN.get(number, ())}
    for needed, targets in TOGETHER:
        if set(needed) <= asked:
            found |= set(targets)
    return found


def _lids(moves: Array, names: tuple[str, ...], values: Array, numbers: tuple[int, int], side: str) -> dict[str, float]:
    """Return the weights of one eye's lids.

    A blink shuts the eye by the upper lid's share and as much of the lower lid's as the upper one has met; what the
    lower lid does beyond is a squint, and a negative upper one opens the eye wide.
    """
    up, low = (float(values[number - 1]) / FULL for number in numbers)
    blink = min(max(up, 0.0) + min(max(low, 0.0), max(up, 0.0)), 1.0)
    wanted = {
        f"eyeBlink{side}": blink,
        f"eyeSquint{side}": (low - max(up, 0.0)) * FULL / _reach(moves, names, f"eyeSquint{side}", numbers[1]),
        f"eyeWide{side}": up * FULL / _reach(moves, names, f"eyeWide{side}", numbers[0]),
    }
    return {name: float(np.clip(weight, 0.0, 1.0)) for name, weight in wanted.items() if name in names and weight > 0.0}


def _reach(moves: Array, names: tuple[str, ...], target: str, number: int) -> float:
    """Return by how many units a target takes its lid, with its sign; one without any takes it nowhere."""
    return float(moves[number - 1, names.index(target)]) if target in names else np.inf


def viseme_weights(selected: Array) -> dict[str, Array]:
    """Return the weights (F,) of the viseme targets of FAP 1: (F, 3) first and second viseme, blend 0 to 63."""
    share = np.clip(selected[:, 2] / BLEND_FULL, 0.0, 1.0)
    found: dict[str, Array] = {}
    for number, name in enumerate(VISEMES):
        weight = np.where(selected[:, 0] == number, share, 0.0) + np.where(selected[:, 1] == number, 1.0 - share, 0.0)
        if number and weight.any():
            found[f"viseme_{name}"] = np.minimum(weight, 1.0)
    return found


def expression_weights(selected: Array) -> dict[str, Array]:
    """Return the weights (F,) of the targets of FAP 2: (F, 4) two expressions, each with an intensity 0 to 63."""
    rest: dict[str, Array] = {}
    for column in (0, 2):
        strength = np.clip(selected[:, column + 1] / BLEND_FULL, 0.0, 1.0)
        for number, name in enumerate(EXPRESSION_ORDER, start=1):
            own = np.where(selected[:, column] == number, strength, 0.0)
            for target, weight in EXPRESSIONS[name].items() if own.any() else ():
                rest[target] = rest.get(target, np.ones(len(own))) * (1.0 - weight * own)
    return {target: 1.0 - left for target, left in rest.items()}
