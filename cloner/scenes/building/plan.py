"""The records of a plan: floors, walls with openings, pillars, lamps, photographs; metres.

The plan's frame is that of scenarios (`docs/behaviour.md`): x to the right, y up on the plan, heights above the floor.
"""

from __future__ import annotations

from dataclasses import dataclass, field
from typing import Final

#: More than this is no room: it bounds what a hostile plan can make us hold.
LARGEST: Final = 360.0  # metres, or degrees
XY = tuple[float, float]
RGB = tuple[float, float, float]
Corners = tuple[XY, XY, XY, XY]


@dataclass(frozen=True, slots=True)
class Sun:
    """The sun's direction, degrees (azimuth clockwise from the plan's up; elevation), and its light.

    Lights are irradiances of a surface that faces them, in units in which a white surface under 1 is shown white.
    """

    towards_deg: float
    elevation_deg: float
    light: RGB


@dataclass(frozen=True, slots=True)
class Sky:
    """The irradiance of a horizontal surface under the whole sky."""

    light: RGB


@dataclass(frozen=True, slots=True)
class Floor:
    """A walkable rectangle."""

    low: XY
    high: XY
    look: str


@dataclass(frozen=True, slots=True)
class Opening:
    """A door (``low`` 0) or a window: its middle along the wall's long side, as a plan coordinate, and heights."""

    at: float
    wide: float
    low: float
    high: float


@dataclass(frozen=True, slots=True)
class Wall:
    """A vertical wall over a rectangle of the plan."""

    low: XY
    high: XY
    height: float
    look: str
    openings: tuple[Opening, ...] = ()


@dataclass(frozen=True, slots=True)
class Ceiling:
    """A flat ceiling over a rectangle, at a height."""

    low: XY
    high: XY
    at: float
    look: str


@dataclass(frozen=True, slots=True)
class Vault:
    """A barrel vault along y over a rectangle, with a springing height and a rise."""

    low: XY
    high: XY
    spring: float
    rise: float
    look: str


@dataclass(frozen=True, slots=True)
class Block:
    """Something that stands on the floor or on something else; a ``pillar`` has a base, a shaft and a capital."""

    name: str
    at: XY
    size: XY
    high: float
    look: str
    low: float = 0.0
    pillar: bool = False


@dataclass(frozen=True, slots=True)
class Lamp:
    """A glowing sphere: its position (x, y, height), its irradiance at one metre, and its radius."""

    at: tuple[float, float, float]
    light: RGB
    radius: float


@dataclass(frozen=True, slots=True)
class Photographed:
    """A look from a photo: the rectified region between four of its corners.

    Attributes
    ----------
    name : what surfaces call it
    file : beside the plan
    corners : pixels of the upright photo: top left, top right, bottom right, bottom left of the surface
    size : how wide and high that is, metres
    texel : side of a texel of what becomes of it, metres
    """

    name: str
    file: str
    corners: Corners
    size: XY
    texel: float = 0.005

    @property
    def texels(self) -> tuple[int, int]:
        """Return its width and height in texels."""
        return round(self.size[0] / self.texel), round(self.size[1] / self.texel)


@dataclass(frozen=True, slots=True)
class Plan:
    """Everything in a room."""

    name: str
    floors: tuple[Floor, ...]
    walls: tuple[Wall, ...] = ()
    ceilings: tuple[Ceiling, ...] = ()
    vaults: tuple[Vault, ...] = ()
    blocks: tuple[Block, ...] = ()
    lamps: tuple[Lamp, ...] = ()
    photos: tuple[Photographed, ...] = ()
    sun: Sun | None = None
    sky: Sky = field(default_factory=lambda: Sky((0.0, 0.0, 0.0)))
