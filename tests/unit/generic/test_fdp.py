"""Named face points carry their MPEG-4 numbers, sides as the standard counts them."""

from __future__ import annotations

import csv
from pathlib import Path

import pytest

from cloner.detectors.face.face_net import load_face_net
from cloner.generic.fdp import fdp_names

REFERENCE = Path("/work/shared/reference/mpeg4_feature_points.csv")


def test_the_net_and_profile_points_have_their_numbers():
    known = fdp_names()
    assert known["nose_tip"] == "9.3"
    assert (known["mouth_corner_L"], known["mouth_corner_R"]) == ("8.3", "8.4")
    assert (known["eye_outer_L"], known["eye_outer_R"]) == ("3.7", "3.12")
    assert (known["eye_inner_L"], known["eye_inner_R"]) == ("3.11", "3.8")
    assert known["hairline_top"] == "11.1"
    without = [name for name in load_face_net().names if name not in known]
    assert len(without) <= 6, without  # nasion, glabella, lower lids, outermost ears have no vertex in common


@pytest.mark.skipif(not REFERENCE.is_file(), reason="the table of MPEG-4 points is not here")
def test_sides_agree_with_the_table():
    rows = csv.DictReader(line for line in REFERENCE.read_text().splitlines() if not line.startswith("#"))
    side = {row["id"]: row["side"].lower()[:1] for row in rows}
    for name, number in fdp_names().items():
        if name.endswith(("_L", "_R")) and number in side:
            assert side[number] == name[-1].lower(), (name, number)
