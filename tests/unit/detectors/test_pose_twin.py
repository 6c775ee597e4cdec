"""A misread back takes the front's pose, seen in the mirror; a pose that its outline bears out stays."""

from __future__ import annotations

import cv2
import numpy as np

from cloner.detectors.body.pose_twin import fits, mirrored_onto, twins_put_right
from cloner.detectors.nets import pose_rows as net
from cloner.frames import ViewId
from cloner.records.points import Proposal
from cloner.vision.segmentation.outline_walk import figure_of

HEIGHT, WIDTH = 600, 400
#: Joints of a front photo, px; the right side is the left one's mirror image about column 200.
LEFT = {net.SHOULDERS: (250, 140), net.ELBOWS: (290, 230), net.WRISTS: (320, 310), net.HIPS: (225, 310),
        net.KNEES: (240, 430), net.ANKLES: (250, 540)}  # fmt: skip


def front_pose() -> np.ndarray:
    pose = np.full((33, 2), 200.0)
    for pair, (column, row) in LEFT.items():
        pose[pair[0]], pose[pair[1]] = (column, row), (400 - column, row)
    return pose


def drawn(pose: np.ndarray) -> np.ndarray:
    """Return the mask of a figure with limbs 30 px thick round a pose, a trunk and a head."""
    mask = np.zeros((HEIGHT, WIDTH), np.uint8)
    for chain in ((net.SHOULDERS, net.ELBOWS, net.WRISTS), (net.HIPS, net.KNEES, net.ANKLES)):
        for side in (net.LEFT, net.RIGHT):
            line = np.array([pose[pair[side]] for pair in chain], np.int32)
            cv2.polylines(mask, [line], isClosed=False, color=255, thickness=30)
    middle = pose[[*net.SHOULDERS]].mean(axis=0)
    cv2.circle(mask, (int(middle[0]), int(middle[1]) - 60), 30, 255, -1)
    cv2.fillConvexPoly(mask, pose[[*net.SHOULDERS, *net.HIPS[::-1]]].astype(np.int32), 255)
    return mask


def proposal(view: ViewId, pose: np.ndarray, mask: np.ndarray) -> Proposal:
    return Proposal(view, pose, np.ones(33), np.zeros((468, 2)), np.zeros(468), 0.0, mask, np.zeros_like(mask))


def back_of(pose: np.ndarray) -> np.ndarray:
    """Return the same person seen from behind, a little smaller and aside."""
    return np.column_stack([190.0 - 0.8 * (pose[:, 0] - 200.0), 0.8 * pose[:, 1] + 60.0])


def behind(pose: np.ndarray) -> np.ndarray:
    """Return the mask of `back_of` a pose."""
    turn = np.array([[-0.8, 0.0, 350.0], [0.0, 0.8, 60.0]])
    return cv2.warpAffine(drawn(pose), turn, (WIDTH, HEIGHT))


def test_a_back_read_as_a_side_takes_the_front_s_pose() -> None:
    truth = back_of(front_pose())
    misread = truth.copy()
    for pair in (net.ELBOWS, net.WRISTS, net.HIPS, net.KNEES, net.ANKLES):
        misread[list(pair), 0] = 190.0
    front = proposal(ViewId.BODY_FRONT, front_pose(), drawn(front_pose()))
    back = proposal(ViewId.BODY_BACK, misread, behind(front_pose()))
    out = twins_put_right({ViewId.BODY_FRONT: front, ViewId.BODY_BACK: back})
    assert out[ViewId.BODY_FRONT] is front
    rows = [row for pair in LEFT for row in pair]
    assert np.abs(out[ViewId.BODY_BACK].pose_px[rows] - truth[rows]).max() < 8.0


def test_a_pose_that_mostly_lies_on_the_person_is_its_own() -> None:
    off = back_of(front_pose())
    off[list(net.ANKLES), 0] = 190.0
    views = {
        ViewId.BODY_FRONT: proposal(ViewId.BODY_FRONT, front_pose(), drawn(front_pose())),
        ViewId.BODY_BACK: proposal(ViewId.BODY_BACK, off, behind(front_pose())),
    }
    assert twins_put_right(views) == views


def test_a_back_that_its_outline_bears_out_is_kept() -> None:
    truth = back_of(front_pose())
    views = {
        ViewId.BODY_FRONT: proposal(ViewId.BODY_FRONT, front_pose(), drawn(front_pose())),
        ViewId.BODY_BACK: proposal(ViewId.BODY_BACK, truth, behind(front_pose())),
    }
    assert twins_put_right(views) == views


def test_one_that_stands_otherwise_is_not_taken() -> None:
    """Arms raised in the back photo: the front's pose would lie beside the person there."""
    raised = front_pose()
    for pair, row in ((net.ELBOWS, 90.0), (net.WRISTS, 40.0)):
        raised[list(pair), 1] = row
    truth = back_of(raised)
    views = {
        ViewId.BODY_FRONT: proposal(ViewId.BODY_FRONT, front_pose(), drawn(front_pose())),
        ViewId.BODY_BACK: proposal(ViewId.BODY_BACK, truth, behind(raised)),
    }
    assert twins_put_right(views) == views


def test_a_figure_cut_by_its_picture_tells_nothing_of_the_other() -> None:
    cut = drawn(front_pose())[:500]
    views = {
        ViewId.BODY_FRONT: proposal(ViewId.BODY_FRONT, front_pose(), cut),
        ViewId.BODY_BACK: proposal(ViewId.BODY_BACK, np.full((33, 2), 190.0), behind(front_pose())),
    }
    assert twins_put_right(views) == views


def test_sides_count_in_the_fit() -> None:
    figure = figure_of(drawn(front_pose()))
    assert figure is not None
    assert fits(front_pose(), figure, 1.0) > 0.9
    assert fits(front_pose(), figure, -1.0) < 0.1
    assert np.allclose(mirrored_onto(front_pose(), figure, figure)[net.WRISTS[0]], front_pose()[net.WRISTS[1]], atol=3)
