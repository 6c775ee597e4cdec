"""Skinning weights of hair: the head for what grows there or hangs free; neck, shoulders and chest for what lies on
them.
"""

from __future__ import annotations

from typing import Final

import numpy as np
from numpy.typing import NDArray
from scipy.spatial import cKDTree

from cloner.generic.load import GenericHuman
from cloner.geometry.articulation.skinning import dense_weights, strongest_weights
from cloner.geometry.meshes.graphs import surface_graph
from cloner.hair.volumes.views import HairSkinning
from cloner.records.arrays import Array
from cloner.records.clones import Joined

Skinned = tuple[NDArray[np.int32], Array]

#: Hair nearer to the body's skin than the first lies on it, farther than the second it hangs free, metres: the outside
#: of thick hair moves with its inside.
LYING_M: Final = (0.03, 0.07)
#: Skin vertices whose weights are averaged: hair is as smooth as five of them.
NEAREST: Final = 8
#: Rounds over the hair's own surface, so that locks do not tear where they leave the body.
ROUNDS: Final = 8


def hair_weights(generic: GenericHuman, joined: Joined, vertices_m: Array, triangles: NDArray[np.int32]) -> Skinned:
    """Return joints and weights (N, 4) of a hair's vertices, rest frame, metres; rows of weights sum to one.

    Parameters
    ----------
    generic, joined : the person
    vertices_m : (N, 3)
    triangles : (T, 3) int32
    """
    hanger = HairSkinning.of(generic, joined)
    joints, weights = hanger.weights(vertices_m)
    _, neck_m, chest_m = hanger.heights_m
    below = np.clip((neck_m - vertices_m[:, 1]) / max(neck_m - chest_m, 1e-6), 0.0, 1.0)
    low = np.flatnonzero(below > 0.0)
    if not low.size:
        return joints, weights
    skin = np.flatnonzero(generic.skin)
    gap_m, near = cKDTree(joined.vertices_m[skin]).query(vertices_m[low], k=NEAREST)
    lying = np.zeros(len(vertices_m))
    lying[low] = np.clip((LYING_M[1] - gap_m[:, 0]) / (LYING_M[1] - LYING_M[0]), 0.0, 1.0)
    lying = below * surface_graph(vertices_m, triangles).smooth(lying, ROUNDS)
    whole = dense_weights(joints, (1.0 - lying)[:, None] * weights, len(generic.joint_names))
    closeness = 1.0 / (gap_m + 1e-3)
    closeness *= (lying[low] / closeness.sum(axis=1))[:, None]
    own = skin[near]
    share = closeness[..., None] * generic.skin_weights[own]
    np.add.at(whole, (low[:, None, None], generic.skin_joints[own]), share)
    return strongest_weights(whole)
