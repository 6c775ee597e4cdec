"""Values of the pipeline come back as they were; a foreign or broken file gives nothing and runs nothing."""

import json

import numpy as np
import pytest

from cloner.frames import ViewId
from cloner.project.values_file import load_values, save_values
from cloner.records.points import PhotoState, PointSet, StateKind, ViewPoints
from cloner.report.agreement import PhotoAgreement


def some_points():
    state = PhotoState(StateKind.EXCHANGED, "left", "exchanged", 0.5, (1.0, 2.0))
    inner = ViewPoints(ViewId.BODY_FRONT, ("a",), np.ones((1, 2)), np.ones(1), np.zeros(1, bool))
    points = ViewPoints(
        ViewId.BODY_FRONT, ("a", "b"), np.array([[1.5, 2], [3, 4]]), np.array([0.1, 0.9]), np.array([True, False]),
        inner, (state,),
    )  # fmt: skip
    return PointSet({ViewId.BODY_FRONT: points})


def test_records_come_back_with_every_bit(tmp_path):
    shared = np.arange(6, dtype=np.float32).reshape(2, 3)
    values = {"points": some_points(), "twice": (shared, shared), "plain": {"a": None, "b": [1, 2.5, "x", True]}}
    save_values(values, tmp_path / "work" / "values.npz")
    back = load_values(tmp_path / "work" / "values.npz")
    points, before = back["points"].views[ViewId.BODY_FRONT], values["points"].views[ViewId.BODY_FRONT]
    assert isinstance(points, ViewPoints)
    assert points.names == ("a", "b")
    assert np.array_equal(points.points_px, before.points_px)
    assert points.corrected.dtype == bool
    assert points.states == before.states
    assert points.states[0].kind is StateKind.EXCHANGED
    assert points.proposed.names == ("a",)
    assert back["twice"][0].dtype == np.float32
    assert np.array_equal(back["twice"][1], shared)
    assert back["plain"] == {"a": None, "b": (1, 2.5, "x", True)}


@pytest.mark.parametrize(
    "told",
    [
        {"format": 1, "values": {"record": "os:system", "fields": {"command": "touch hacked"}}},
        {"format": 1, "values": {"record": "cloner.records.points:np", "fields": {}}},
        {"format": 1, "values": {"enum": "cloner.frames:Array", "value": 1}},
        {"format": 1, "values": {"record": "cloner.project.atomic:write_text", "fields": {"path": "x", "text": "y"}}},
        {"format": 2, "values": {"map": []}},
        {"format": 1, "values": {"map": [["a", {"array": 7}]]}},
        {"values": 3},
    ],
)
def test_what_is_no_record_of_ours_is_never_made(tmp_path, monkeypatch, told):
    monkeypatch.chdir(tmp_path)
    np.savez(tmp_path / "v.npz", skeleton_json=np.frombuffer(json.dumps(told).encode(), np.uint8))
    assert load_values(tmp_path / "v.npz") == {}
    assert [path.name for path in tmp_path.iterdir()] == ["v.npz"]


@pytest.mark.parametrize("data", [b"", b"PK\x03\x04 broken", b"not a zip"])
def test_broken_files_give_nothing(tmp_path, data):
    (tmp_path / "v.npz").write_bytes(data)
    assert load_values(tmp_path / "v.npz") == {}
    assert load_values(tmp_path / "missing.npz") == {}


def test_pickles_are_never_read(tmp_path):
    np.savez(tmp_path / "v.npz", skeleton_json=np.array([{"a": 1}], dtype=object))
    assert load_values(tmp_path / "v.npz") == {}


def test_what_cannot_be_kept_is_a_programmers_mistake(tmp_path):
    with pytest.raises(TypeError, match="cannot be kept"):
        save_values({"a": object()}, tmp_path / "v.npz")


def test_a_record_that_could_not_be_read_again_is_not_kept(tmp_path):
    with pytest.raises(TypeError, match="Agreement cannot be kept"):
        save_values({"seen": PhotoAgreement(0.9, 1.0, 2.0, 3.0)}, tmp_path / "work" / "values.npz")
