"""An outline that follows moved points step by step."""

import numpy as np

from cloner.interactive.relinking import LiveOutline, follow_corrections
from cloner.records.points import Correction
from cloner.vision.contours.outlines import extract_outline
from cloner.vision.contours.stretches import prepare_linking
from kit.drawn import AXES, CENTRE, photograph, rough_mask


def at(degrees, out_px=0.0):
    t = np.deg2rad(degrees)
    place = CENTRE + (AXES + out_px) * np.array([np.cos(t), np.sin(t)])
    return Correction(float(place[0]), float(place[1]))


def gap(step, point):
    return float(np.linalg.norm(np.concatenate(step.contours_px) - [point.x_px, point.y_px], axis=1).min())


def test_every_placed_point_lies_on_the_outline_and_only_what_moved_is_linked_again():
    rgb, mask = photograph(), rough_mask()
    outline = LiveOutline(prepare_linking(rgb, mask), (extract_outline(rgb, mask).loops[0].polygon,))
    placed = {"waist_left": at(0.0, 8.0), "hip_left": at(90.0, -6.0), "l_knee": at(180.0, 40.0)}
    steps = follow_corrections(outline, (), placed)
    assert {step.name for step in steps} == {"waist_left", "hip_left"}, "joints lie on no outline"
    assert all(gap(steps[-1], placed[step.name]) < 0.1 for step in steps)
    moved = placed | {"waist_left": at(2.0, 14.0)}
    first = follow_corrections(outline, steps, moved)
    assert first[-1].name == "waist_left", "what moves stands last"
    again = follow_corrections(outline, first, moved | {"waist_left": at(3.0, 16.0)})
    assert again[0] is first[0], "what stays is not linked again"
    assert gap(again[-1], at(3.0, 16.0)) < 0.1
    assert gap(again[-1], placed["hip_left"]) < 0.1
    assert follow_corrections(outline, again, {}) == ()
