"""Six fabrics, and user-defined ones, from Kawabata (KES) measurements.

The numbers of the six are typical of the kind, chosen within the ranges that textile literature prints for KES-F; none
was measured here. A fabric of one's own is a file of the same form, with the 21 readings of a KES-F sheet; those of
compression (T, LC, WC) may stand in it and change nothing: layers keep farther apart than they are thick.

References
----------
S. Kawabata, The Standardization and Analysis of Hand Evaluation, 2nd edition, 1980 (the five tests and their units).
"""

from __future__ import annotations

import importlib.resources
import re
import tomllib
from dataclasses import dataclass
from pathlib import Path
from types import MappingProxyType
from typing import Any, Final

from cloner.errors import ClonerError
from cloner.project.texts import read_text

#: gf cm²/cm in N m, gf/(cm degree) in N/m, and the force at which extension is read (500 gf/cm) in N/m.
BENDING_N_M: Final = 9.81e-5
SHEARING_N_M: Final = 56.2
FULL_N_M: Final = 490.0
#: Widths of loops: gf cm/cm of bending in newtons, gf/cm of shearing in N/m.
LOOP_N: Final = 9.81e-3
LOOP_N_M: Final = 0.981


@dataclass(frozen=True, slots=True)
class Fabric:
    """One fabric. Pairs are of warp and weft.

    Attributes
    ----------
    name : str
    weight_kg_m2 : float
        W.
    extension, linearity, resilience : (float, float)
        EM, the share of its length that it gains under 500 gf/cm; LT, the work of that beside a straight line's; RT,
        the share of the work that it gives back.
    bending, bending_hysteresis : (float, float)
        B, gf cm²/cm; 2HB, gf cm/cm.
    shearing, shearing_hysteresis, shearing_hysteresis_5 : (float, float)
        G, gf/(cm degree); 2HG and 2HG5, gf/cm, at half a degree and at five.
    friction : float
        MIU against the body.
    air : float
        Share of air that does not pass, 0..1.
    rgb : (int, int, int)
        sRGB that it is drawn in.
    """

    name: str
    weight_kg_m2: float
    extension: tuple[float, float]
    linearity: tuple[float, float]
    resilience: tuple[float, float]
    bending: tuple[float, float]
    bending_hysteresis: tuple[float, float]
    shearing: tuple[float, float]
    shearing_hysteresis: tuple[float, float]
    shearing_hysteresis_5: tuple[float, float]
    friction: float
    air: float
    rgb: tuple[int, int, int]

    def linear_rgb(self) -> tuple[float, float, float]:
        """Return the colour in linear light, 0..1."""
        red, green, blue = ((value / 255.0) ** 2.2 for value in self.rgb)
        return red, green, blue

    def stretch_n_m(self) -> tuple[float, float, float]:
        """Return stiffness along warp and weft, and against shearing, N/m."""
        warp, weft = (FULL_N_M / share for share in self.extension)
        return warp, weft, sum(self.shearing) / 2.0 * SHEARING_N_M

    def bend_n_m(self) -> float:
        """Return the mean bending stiffness, N m."""
        return BENDING_N_M * sum(self.bending) / 2.0


@dataclass(frozen=True, slots=True)
class _Reading:
    """One line of a fabric's sheet: the record's field, its unit, and the accepted range."""

    word: str
    unit: float
    least: float
    most: float
    paired: bool = True


#: Lines of a fabric's file. Bounds are wide: gauze to canvas.
_READINGS: Final = MappingProxyType({
    "W": _Reading("weight_kg_m2", 0.01, 1.0, 200.0, paired=False),
    "EM": _Reading("extension", 0.01, 0.5, 60.0),
    "LT": _Reading("linearity", 1.0, 0.3, 1.2),
    "RT": _Reading("resilience", 0.01, 10.0, 100.0),
    "B": _Reading("bending", 1.0, 0.001, 20.0),
    "2HB": _Reading("bending_hysteresis", 1.0, 0.0, 20.0),
    "G": _Reading("shearing", 1.0, 0.02, 30.0),
    "2HG": _Reading("shearing_hysteresis", 1.0, 0.0, 60.0),
    "2HG5": _Reading("shearing_hysteresis_5", 1.0, 0.0, 60.0),
    "MIU": _Reading("friction", 1.0, 0.0, 1.0, paired=False),
    "air": _Reading("air", 1.0, 0.0, 1.0, paired=False),
})  # fmt: skip
#: Lines that a sheet has beside them.
_UNREAD: Final = ("T", "LC", "WC", "RC", "WT", "MMD", "SMD", "name", "colour")
_HINT: Final = "See docs/cloth.md for the form of a fabric's file"


def _fabric(name: str, text: str, where: str) -> Fabric:
    """Return the fabric of a file's text.

    Raises
    ------
    ClonerError
        If it is none, or a reading is missing or beyond what cloth has.
    """
    try:
        data: dict[str, Any] = tomllib.loads(text)
    except (ValueError, RecursionError) as error:  # also a number of 5,000 digits
        raise ClonerError("the file is no fabric", _HINT, where) from error
    for key in data:
        if key not in _READINGS and key not in _UNREAD:
            raise ClonerError(f"the fabric has a reading {key!r}, which is not known", _HINT, where)
    values: dict[str, Any] = {}
    for key, reading in _READINGS.items():
        given: Any = data.get(key)
        numbers = given if isinstance(given, list) else [given] * (2 if reading.paired else 1)
        if len(numbers) != (2 if reading.paired else 1) or not all(
            isinstance(number, int | float) and reading.least <= number <= reading.most for number in numbers
        ):
            hint = f"Write {reading.least:g} to {reading.most:g}" + (", of warp and weft" if reading.paired else "")
            raise ClonerError(f"the fabric's {key} is missing or no such number", hint, where)
        scaled = tuple(float(number) * reading.unit for number in numbers)
        values[reading.word] = scaled if reading.paired else scaled[0]
    colour = re.fullmatch(r"#([0-9a-fA-F]{2})([0-9a-fA-F]{2})([0-9a-fA-F]{2})", str(data.get("colour", "#c8c4b8")))
    if colour is None:
        raise ClonerError("the fabric's colour is none", 'Write it as "#dcd8c8"', where)
    red, green, blue = (int(part, 16) for part in colour.groups())
    return Fabric(name=str(data.get("name", name))[:40], rgb=(red, green, blue), **values)


def read_fabric(path: Path) -> Fabric:
    """Return the fabric in a TOML file.

    Raises
    ------
    ClonerError
        If the file is none.
    """
    return _fabric(path.stem, read_text(path), path.name)


def _all() -> dict[str, Fabric]:
    folder = importlib.resources.files("cloner.cloth.simulation") / "fabrics"
    names = ("silk", "cotton", "linen", "wool", "denim", "burlap")
    return {name: _fabric(name, (folder / f"{name}.toml").read_text(encoding="utf-8"), name) for name in names}


FABRICS: Final = MappingProxyType(_all())
