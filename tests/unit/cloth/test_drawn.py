"""A garment drawn as SVG is cut as it was drawn, and a bad drawing is refused in one sentence."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest

from cloner.cloth.drafting.cut import triangulate
from cloner.cloth.drafting.drawn import garment_from_svg, read_svg
from cloner.cloth.drafting.pattern import Pattern, length_m
from cloner.errors import ClonerError

HEAD = '<svg xmlns="http://www.w3.org/2000/svg" width="800mm" viewBox="0 0 800 800" data-seams="{seams}">'
FRONT = '<path id="front" data-edges="top left hem right" d="M 0,0 L 400,0 V 600 H 0 Z"/>'
BACK = '<path id="back" data-edges="top right hem left" d="m 0 0 h 400 c 50,200 50,400 0 600 l -400 0 z"/>'
SEAMS = "front.left back.left; front.right back.right"


def drawing(folder: Path, *paths: str, seams: str = SEAMS, head: str = HEAD) -> Path:
    path = folder / "skirt.svg"
    path.write_text(head.format(seams=seams) + "".join(paths) + "</svg>")
    return path


def read_drawing(path: Path) -> Pattern:
    return garment_from_svg(read_svg(path), path.stem, path.name)


def test_edges_have_the_drawn_lengths_in_metres(tmp_path: Path) -> None:
    pattern = read_drawing(drawing(tmp_path, FRONT, BACK))
    assert length_m(pattern.edge("front.top")) == pytest.approx(0.4)
    assert length_m(pattern.edge("front.left")) == pytest.approx(0.6)
    assert length_m(pattern.edge("back.right")) == pytest.approx(0.609, abs=0.004)  # bulges by 3.75 cm
    assert pattern.seams == (("front.left", "back.left"), ("front.right", "back.right"))
    outline = np.concatenate([edge[:1] for edge in pattern.segments[0].edges.values()])
    following = np.roll(outline, -1, axis=0)
    assert (outline[:, 0] * following[:, 1] - outline[:, 1] * following[:, 0]).sum() / 2.0 == pytest.approx(0.24)
    assert triangulate(pattern, 0.05).count > 100


def test_pixels_are_a_ninety_sixth_of_an_inch(tmp_path: Path) -> None:
    head = '<svg xmlns="http://www.w3.org/2000/svg" width="3200" data-seams="">'
    pattern = read_drawing(drawing(tmp_path, FRONT, head=head))
    assert length_m(pattern.edge("front.top")) == pytest.approx(400 * 0.0254 / 96.0)


@pytest.mark.parametrize(
    ("paths", "seams", "names"),
    [
        ((FRONT.replace("V 600", "A 5 5 0 0 1 9 9"),), "", "command 'A'"),
        ((FRONT.replace("L 400,0", "L 400"),), "", "ends early"),
        ((FRONT.replace("top left", "top"),), "", "4 edges and 3 names"),
        ((FRONT.replace('id="front"', 'id="front" transform="scale(2)"'),), "", "transformed"),
        ((FRONT,), "front.left", "two edges"),
        ((FRONT,), "front.left back.left", "in no piece"),
        ((FRONT.replace("V 600", "V 9"),), "", "no garment"),
        ((), "", "1 to 60 pieces"),
    ],
)
def test_bad_drawings_are_refused(tmp_path: Path, paths: tuple[str, ...], seams: str, names: str) -> None:
    with pytest.raises(ClonerError, match=names):
        read_drawing(drawing(tmp_path, *paths, seams=seams))


@pytest.mark.parametrize("text", ["", "<svg", "<!DOCTYPE x [<!ENTITY a 'b'>]><svg/>", "<svg/>", "<a>" * 500])
def test_files_that_are_no_drawing_are_refused(tmp_path: Path, text: str) -> None:
    path = tmp_path / "x.svg"
    path.write_text(text)
    with pytest.raises(ClonerError):
        read_drawing(path)
