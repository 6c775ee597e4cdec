"""Six fabrics by what Kawabata's machines measure (KES), and what the solver makes of it.

The numbers are typical of the kind, chosen within the ranges that textile literature prints for KES-F; none was
measured here. Units: 1 gf cm²/cm of bending is 9.81e-5 N m²/m; 1 gf/(cm degree) of shearing is 56.2 N/m a radian.

References
----------
S. Kawabata, The Standardization and Analysis of Hand Evaluation, 2nd edition, 1980 (the five tests and their units).
"""

from __future__ import annotations

from dataclasses import dataclass
from types import MappingProxyType
from typing import Final

#: gf cm²/cm in N m, gf/(cm degree) in N/m, and the force at which extension is read (500 gf/cm) in N/m.
BENDING_N_M: Final = 9.81e-5
SHEARING_N_M: Final = 56.2
FULL_N_M: Final = 490.0


@dataclass(frozen=True, slots=True)
class Fabric:
    """One fabric.

    Attributes
    ----------
    name : str
    weight_kg_m2 : float
    extension : (float, float)
        EM of warp and weft: share of its length that it gains under 500 gf/cm.
    bending : (float, float)
        B of warp and weft, gf cm²/cm.
    shearing : float
        G, gf/(cm degree).
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
    bending: tuple[float, float]
    shearing: float
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
        return warp, weft, self.shearing * SHEARING_N_M

    def bend_n_m(self) -> float:
        """Return the mean bending stiffness, N m."""
        return BENDING_N_M * sum(self.bending) / 2.0


#: Typical of each kind, within the ranges printed for KES-F; none was measured here.
_ALL: Final = (
    Fabric("silk", 0.070, (0.030, 0.040), (0.025, 0.020), 0.30, 0.18, 0.90, (150, 38, 52)),
    Fabric("cotton", 0.130, (0.035, 0.060), (0.080, 0.060), 0.90, 0.25, 0.80, (222, 216, 200)),
    Fabric("linen", 0.180, (0.025, 0.045), (0.180, 0.140), 1.00, 0.25, 0.75, (196, 182, 150)),
    Fabric("wool", 0.220, (0.045, 0.070), (0.120, 0.095), 0.65, 0.30, 0.70, (70, 74, 92)),
    Fabric("denim", 0.380, (0.025, 0.050), (0.600, 0.400), 2.40, 0.32, 0.85, (58, 82, 120)),
    Fabric("burlap", 0.330, (0.030, 0.035), (0.900, 0.800), 2.90, 0.40, 0.50, (172, 140, 96)),
)
FABRICS: Final = MappingProxyType({fabric.name: fabric for fabric in _ALL})
