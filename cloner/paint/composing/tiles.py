"""The atlas cut into tiles, with a margin as wide as any filter."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Final

from cloner.geometry.charts.atlas import Window

#: Side of a tile, texels: the pictures of one take some 60 MiB while it is painted.
TILE: Final = 512
#: Texels around a tile that are worked out with it: more than a blend over few levels reaches.
MARGIN: Final = 32


@dataclass(frozen=True, slots=True)
class Tile:
    """One tile of an atlas.

    Attributes
    ----------
    outer : Window
        The tile with its margin, cut at the atlas' border.
    inner : (slice, slice)
        Rows and columns of the tile itself in ``outer``.
    place : (slice, slice)
        Rows and columns of the tile in the atlas.
    """

    outer: Window
    inner: tuple[slice, slice]
    place: tuple[slice, slice]

    def halved(self) -> Tile:
        """Return the same tile of an atlas with half as many texels a side."""
        window = self.outer
        outer = Window(window.top // 2, window.left // 2, window.height // 2, window.width // 2)
        return Tile(outer, _halved(self.inner), _halved(self.place))


def _halved(part: tuple[slice, slice]) -> tuple[slice, slice]:
    rows, columns = (slice(span.start // 2, span.stop // 2) for span in part)
    return rows, columns


def cut_tiles(size: int) -> list[Tile]:
    """Return the tiles of an atlas of ``size`` texels a side."""
    spans = [_margin_span(start, size) for start in range(0, size, TILE)]
    return [
        Tile(Window(top, left, high, wide), (inner_rows, inner_columns), (rows, columns))
        for top, high, inner_rows, rows in spans
        for left, wide, inner_columns, columns in spans
    ]


def _margin_span(start: int, size: int) -> tuple[int, int, slice, slice]:
    """Return first and count of a tile's texels along one axis with the margin, and its own in both frames."""
    first, last = max(start - MARGIN, 0), min(start + TILE + MARGIN, size)
    end = min(start + TILE, size)
    return first, last - first, slice(start - first, end - first), slice(start, end)
