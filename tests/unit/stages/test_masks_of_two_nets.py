"""Where one net is sure of what the other denies, neither is believed: the photo's colours decide."""

import numpy as np

from cloner.stages.figures import merge_masks, veto_by_labels

POSED = np.array([[0.95, 0.95, 0.05, 0.05, 0.6]], np.float32)


def test_a_body_is_the_pose_nets_unless_the_label_net_is_sure_of_the_opposite():
    labelled = np.array([[0.05, 0.45, 0.95, 0.55, 0.05]], np.float32)
    np.testing.assert_allclose(veto_by_labels(POSED, labelled), [[0.5, 0.95, 0.5, 0.05, 0.5]])


def test_a_face_is_more_the_label_nets_than_the_others():
    labelled = np.array([[0.05, 0.95, 0.95, 0.05, 0.6]], np.float32)
    found = merge_masks(POSED, labelled)
    assert found[0, 0] < 0.5 < found[0, 2]
    np.testing.assert_allclose(found[0, [1, 3, 4]], [0.95, 0.05, 0.6], atol=1e-6)
