"""The studio's jobs in their process: cloth is shown frame by frame, a job that is cancelled ends at once."""

import time

import numpy as np
import pytest

from cloner.bodies.made import clone_of_measures
from cloner.bodies.telling import BodySpecification
from cloner.booth.studio.jobs import StudioJobs
from cloner.booth.studio.values import BodyWish, Outfit, StatueWish, received
from cloner.booth.worker import Worker
from cloner.errors import Cancelled, ClonerError
from cloner.picture import load_clone_at
from cloner.project.clone_file import save_clone


def quiet(step, fraction):
    pass


@pytest.fixture(scope="module")
def eva(tmp_path_factory):
    folder = tmp_path_factory.mktemp("eva") / "eva"
    folder.mkdir()
    save_clone(clone_of_measures(BodySpecification("f", 1.68, {}), 512), folder / "clone.npz")
    return folder


def test_cloth_is_seen_as_it_hangs_and_a_walk_is_stopped_at_once(eva):
    worker = Worker("cloner.booth.studio.jobs:StudioJobs")
    try:
        outfit, shown = Outfit(eva, garment="straight-skirt"), []
        arranged = worker.call("arrange", outfit, progress=quiet)
        worker.call("hang", outfit, progress=quiet, show=shown.append)
        assert len(shown) == 24
        assert not received(arranged.below).atlas.rgb.flags.writeable
        assert np.abs(shown[-1].places_m - arranged.draped.places_m).max() > 0.005
        until = []

        def stop(step, fraction):
            if step == "cloth":
                until.append(worker._process)
                raise Cancelled

        with pytest.raises(Cancelled):
            worker.call("walk", outfit, progress=stop)
        assert len(until) == 1
        assert not until[0].is_alive(), "it does not walk on"
    finally:
        worker.stop()


def test_every_window_gets_its_clone_through_the_pipe(eva, samples):
    worker = Worker("cloner.booth.studio.jobs:StudioJobs")
    try:
        base, sex = worker.call("begin_body", BodyWish("", 168.0, {}, eva), progress=quiet)
        assert (base.stature_m, sex) == (1.68, "f")
        assert base.measures_mm == load_clone_at(eva).measures_mm
        carved = worker.call("carve", eva, "stone", "rest", progress=quiet)
        assert carved.atlas.shine.size
        photo = worker.call("mark_photo", samples / "anna" / "plain" / "face_front.jpg", eva, progress=quiet)
        assert photo.found
        painted = worker.call("paint_photo", photo.rgb, photo.focal_px, photo.markers, eva, "", progress=quiet)
        assert painted.vertices_m.shape == base.vertices_m.shape
        clone, blobs = worker.call("begin_blobs", eva, progress=quiet)
        laid = worker.call("place_blobs", eva, blobs, progress=quiet)
        assert laid.vertices_m.shape == clone.vertices_m.shape
    finally:
        worker.stop()


def test_who_did_not_consent_is_not_undressed(eva, tmp_path):
    from dataclasses import replace

    folder = tmp_path / "anna"
    folder.mkdir()
    save_clone(replace(load_clone_at(eva), consent=False), folder / "clone.npz")
    with pytest.raises(ClonerError, match="consent"):
        StudioJobs().arrange(Outfit(folder, bare=True), quiet)


def test_a_clone_that_was_made_again_is_read_again(eva, tmp_path):
    folder, jobs = tmp_path / "ida", StudioJobs()
    folder.mkdir()
    save_clone(load_clone_at(eva), folder / "clone.npz")
    first, _ = jobs.begin_body(BodyWish("", 168.0, {}, folder), quiet)
    time.sleep(0.01)
    save_clone(clone_of_measures(BodySpecification("f", 1.8, {}), 512), folder / "clone.npz")
    second, _ = jobs.begin_body(BodyWish("", 168.0, {}, folder), quiet)
    assert (first.stature_m, second.stature_m) == (1.68, 1.8)


def test_a_job_that_is_stopped_leaves_no_folder(eva, tmp_path):
    def stop(step, fraction):
        if step == "export":
            raise Cancelled

    wish = StatueWish("clay", tmp_path / "out", "eva-clay", ("glb",), 512)
    with pytest.raises(Cancelled):
        StudioJobs().save_carved(eva, "rest", wish, stop)
    assert not (tmp_path / "out").exists()
