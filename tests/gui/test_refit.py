"""A point dragged after cloning moves the shown body at once; the refit itself is the real one, on a known person."""

import itertools

import numpy as np
import pytest

from cloner.booth.opened import Cloned
from cloner.evaluate.truths.baselines import generic_clone
from cloner.frames import BODY_VIEWS, ViewId
from cloner.generic.load import load_generic
from cloner.records.photos import Photo, PhotoSet
from cloner.records.points import PointSet
from kit import fitted

from .test_points_page import drag

pytestmark = pytest.mark.gui
VIEW = ViewId.BODY_FRONT


@pytest.fixture
def cloned(window, jobs, qtbot):
    """The window on three photos of a known person, proposed and cloned."""
    person, points, outlines = fitted.fitted_person()
    sizes = {view: person.views[view].camera for view in BODY_VIEWS}
    photos = PhotoSet(
        {v: Photo(v, np.full((c.height_px, c.width_px, 3), 90, np.uint8), None, v.value, "") for v, c in sizes.items()}
    )
    session = window.session
    session.photos = photos
    session.opened.emit()
    session.proposed = dict(points.views)
    values = {
        "photos": photos, "body_points": points, "face_points": PointSet({}), "silhouettes": outlines,
        "joined": person, "obeyed": person, "clone": generic_clone(load_generic(), 1.72),
    }  # fmt: skip
    session._take_clone(Cloned(session.folder / "clones" / "anna", values))
    window.show_page(window.points)
    qtbot.waitUntil(lambda: window.points.views[VIEW].isVisible())
    session.points_changed.emit()
    return window


def outline_x(canvas, row_px):
    """Return the columns where the drawn outline crosses a row of the photo."""
    found = []
    for path in canvas._clone.toSubpathPolygons():
        corners = np.array([(p.x(), p.y()) for p in path])
        for (x, y), (next_x, next_y) in itertools.pairwise(corners):
            if min(y, next_y) <= row_px <= max(y, next_y) and y != next_y:
                found.append(x + (next_x - x) * (row_px - y) / (next_y - y))
    return np.array(found)


def test_a_drag_after_cloning_moves_the_shown_body_and_says_so(cloned, qtbot):
    canvas = cloned.points.views[VIEW]
    start = cloned.session.points(VIEW).get("waist_left")
    qtbot.waitUntil(lambda: not canvas._clone.isEmpty())
    before = outline_x(canvas, start[1])
    assert np.abs(before - start[0]).min() < 6.0, "the clone's outline is drawn as soon as there is a clone"
    with qtbot.waitSignal(cloned.session.refitted):
        drag(qtbot, canvas, tuple(start), (start[0] + 10, start[1]), (start[0] + 25, start[1]))
    place = cloned.session.points(VIEW).get("waist_left")
    assert place[0] > start[0] + 20
    qtbot.waitUntil(lambda: np.abs(outline_x(canvas, place[1]) - place[0]).min() < 2.5)
    assert "follows" in cloned.points.status.text()
    moved = cloned.session.clone_now().vertices_m - cloned.session.outcome.values["clone"].vertices_m
    assert 0.02 < np.linalg.norm(moved, axis=1).max() < 0.05, "the turntable shows the bend"
    with qtbot.waitSignal(cloned.session.refitted):
        cloned.undo_action.trigger()
    qtbot.waitUntil(lambda: np.array_equal(outline_x(canvas, start[1]), before))


def test_a_point_that_the_body_cannot_follow_is_told(cloned, qtbot):
    with qtbot.waitSignal(cloned.session.refitted):
        start = cloned.session.points(VIEW).get("waist_left")
        cloned.session.place_point(VIEW, "waist_left", start[0] + 200, start[1])
    assert "waist, left" in cloned.points.status.text()
    assert "off the body" in cloned.points.status.text()


def test_nothing_is_refitted_before_there_is_a_clone(window, qtbot):
    window.session.propose()
    qtbot.waitUntil(lambda: window.session.points(VIEW) is not None and not window.session.busy)
    window.session.place_point(VIEW, "nose_tip", 610.0, 300.0)
    assert window.session.person_now() is None
    assert window.points.views[VIEW]._clone.isEmpty()
