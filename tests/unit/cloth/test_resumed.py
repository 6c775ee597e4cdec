"""A simulation that was stopped goes on where it was and ends as if it never had been."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest

from cloner.bodies.made import clone_of_measures
from cloner.bodies.telling import BodySpecification
from cloner.cloth import written
from cloner.cloth.drafting.blocks import BLOCKS, draft_block
from cloner.cloth.dressing import Dressing
from cloner.cloth.resumed import read_checkpoint, simulation_digest, write_checkpoint
from cloner.cloth.simulation.fabrics import FABRICS
from cloner.cloth.simulation.moving import place_garment, simulate
from cloner.cloth.simulation.placing import body_ring
from cloner.cloth.written import dress_file
from cloner.errors import Cancelled
from cloner.motion.limbs.rig import centre_joints
from cloner.motion.moves.own import own_motions
from cloner.project.clone_file import save_clone
from cloner.records.clones import Clone


@pytest.fixture(scope="module")
def eva() -> Clone:
    return centre_joints(clone_of_measures(BodySpecification("f", 1.68, {"waist_girth": 740.0}), 512))


def skirt(eva: Clone, path: Path | None, fabric: str = "cotton") -> Dressing:
    ring = body_ring(eva, "natural_waist")
    pattern = draft_block(BLOCKS["skirt"], ring.girth_m, 0.4)
    motion = own_motions(eva)[0]
    return Dressing(eva, pattern, "natural_waist", FABRICS[fabric], motion, cycles=4, step_m=0.12, resumed=path)


@pytest.mark.parametrize("elements", [False, True])
def test_the_state_between_two_frames_is_all_that_counts(eva: Clone, tmp_path: Path, elements: bool) -> None:
    ring = body_ring(eva, "natural_waist")
    pattern = draft_block(BLOCKS["skirt"], ring.girth_m, 0.4)
    worn = place_garment(eva, pattern, ring, FABRICS["wool"], own_motions(eva)[0], 0.12, elements=elements)
    states = [state for _, state in simulate(worn, 1)]
    write_checkpoint(tmp_path / "frames", "mine", "stamp of eva", [state.places_m for state in states[:30]], states[29])
    assert (tmp_path / "frames").stat().st_mode & 0o077 == 0, "nobody else reads a visitor's shape"
    assert b"stamp of eva" in (tmp_path / "frames").read_bytes(), "what is left of a visitor is found by it"
    found = read_checkpoint(tmp_path / "frames", "mine")
    assert found is not None
    again = list(simulate(worn, 1, len(found[0]), found[1]))
    assert len(again) == len(states) - 30
    for (_, state), before in zip(again[:8], states[30:], strict=False):
        np.testing.assert_array_equal(state.places_m, before.places_m)
    assert read_checkpoint(tmp_path / "frames", "another's") is None


def test_a_walk_that_was_stopped_ends_as_one_that_was_not(eva: Clone, tmp_path: Path) -> None:
    path = tmp_path / ".skirt.0.frames"
    seen: list[float] = []

    def stop(_: str, fraction: float) -> None:
        if fraction > 0.5:
            raise Cancelled

    with pytest.raises(Cancelled):
        skirt(eva, path).simulate_walk(progress=stop)
    assert path.exists()
    resumed = skirt(eva, path).simulate_walk(lambda places, root, turned: seen.append(float(root[2])))
    whole = skirt(eva, None).simulate_walk()
    np.testing.assert_array_equal(resumed.loop.frames_m, whole.loop.frames_m)
    np.testing.assert_array_equal(resumed.put_m, whole.put_m)
    assert 0 < len(seen) < 0.75 * 4 * len(whole.worn.rotations), "what was kept is not simulated again"


def test_another_fabric_and_a_damaged_file_begin_anew(eva: Clone, tmp_path: Path) -> None:
    one, other = skirt(eva, None), skirt(eva, None, "silk")
    assert simulation_digest(one.worn, 4) != simulation_digest(other.worn, 4)
    assert simulation_digest(one.worn, 4) != simulation_digest(one.worn, 5)
    assert simulation_digest(one.worn, 4) == simulation_digest(skirt(eva, None).worn, 4)
    for data in (b"", b"PK\x03\x04", b"no frames"):
        (tmp_path / "frames").write_bytes(data)
        assert read_checkpoint(tmp_path / "frames", "mine") is None


def test_the_command_keeps_frames_only_where_told_and_takes_them_away(
    eva: Clone, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    save_clone(eva, tmp_path / "clone.npz")
    monkeypatch.setattr(written, "STEP_M", 0.12)
    monkeypatch.setattr(Dressing.__init__, "__kwdefaults__", Dressing.__init__.__kwdefaults__ | {"cycles": 4})

    def stop(step: str, fraction: float) -> None:
        if step == "cloth" and fraction > 0.3:
            raise Cancelled

    out = tmp_path / "skirt.pc2"
    for resume, left in ((False, []), (True, [".skirt.pc2.0.frames"])):
        with pytest.raises(Cancelled):
            dress_file(tmp_path, out, garment="skirt", fabric="wool", resume=resume, progress=stop)
        assert sorted(path.name for path in tmp_path.iterdir()) == [*left, "clone.npz"]
    dress_file(tmp_path, out, garment="skirt", fabric="wool", resume=True)
    assert sorted(path.name for path in tmp_path.iterdir()) == ["clone.npz", "skirt.obj", "skirt.pc2"]
