"""Foot correction of captured motions: soles flat and still on the floor during contacts, jumps unchanged."""

from __future__ import annotations

from dataclasses import replace
from typing import Final

import numpy as np
from scipy.ndimage import gaussian_filter1d, minimum_filter1d

from cloner.motion.limbs import turns
from cloner.motion.limbs.body import FOOT, SIDES, Body
from cloner.motion.moves.contact import NEAR_M, Mask, foot_contacts, on_ground, runs
from cloner.records.arrays import Array
from cloner.records.motions import Motion

#: Nobody flies longer than this, seconds: the longest jumps of athletes.
FLIGHT_S: Final = 1.2
#: Lower rises of the lower sole are no jumps, metres; captured walks on other legs wander by 5 cm.
RISE_M: Final = 0.08
#: The root follows the floor within this time, seconds: no knocks where one foot takes over; taste.
SMOOTH_S: Final = 0.04
#: A standing foot's usual tilt below this is the marker set's, radians (15 degrees); high heels are left alone.
ASKEW_RAD: Final = 0.26
#: Tilts below this of a sole near to the floor are taken off whole, those of twice as much not at all, radians.
FLAT_RAD: Final = 0.07
#: On a treadmill people stay within this, metres, and soles rest on the laboratory's floor for less than this share.
ON_THE_SPOT_M: Final = 0.6
RESTS: Final = 0.25
#: Within one stand a sole that turns by less than this is held, radians (34 degrees; hips turn by 40), and let go
#: within this time. Who turns on the spot does so by 50 to 110 degrees in one stand.
PIVOT_RAD: Final = 0.6
STEADY_S: Final = 0.12


def belt_speed(body: Body, motion: Motion) -> float:
    """Return the treadmill's speed below a captured person, m/s; 0 without one.

    Such a person stays within a step, and soles near to the floor hardly ever rest.
    """
    rests = np.mean([flags.mean() for flags in foot_contacts(body, motion)])
    if rests > RESTS or np.ptp(motion.root_m[:, [0, 2]], axis=0).max() > ON_THE_SPOT_M:
        return 0.0
    speeds = []
    for sole in body.sole_points(body.world(motion), motion.root_m):
        touching = (sole[1:, :, 1] + sole[:-1, :, 1]).argmin(axis=1)
        way, rows = np.diff(sole, axis=0), np.arange(len(touching))
        near = np.minimum(sole[1:, :, 1].min(axis=1), sole[:-1, :, 1].min(axis=1)) < NEAR_M
        speeds.append(-way[rows, touching, 2][near] / np.diff(motion.times_s)[near])
    return max(float(np.median(np.concatenate(speeds))), 0.0)


def flattened(body: Body, motion: Motion) -> Motion:
    """Return the motion with soles that lie flat wherever they nearly do while they stand.

    Marker sets hold feet askew by some degrees, the same all the time: the usual tilt of a quietly standing foot is
    taken off all frames. What is left of a small tilt while the sole is near to the floor is noise and goes too.
    """
    world = body.world(motion)
    soles = body.sole_points(world, motion.root_m)
    for side, stands, sole in zip(SIDES, foot_contacts(body, motion), soles, strict=True):
        ankle, toes = body.joint(f"{side}_ankle"), body.joint(f"{side}_metatarsal")
        tilt = tilt_of(world[:, ankle])
        usual = np.median(tilt[stands], axis=0) if stands.any() else np.zeros(3)
        if np.linalg.norm(usual) < ASKEW_RAD:
            level = turns.matrices(-usual)
            for name in (*FOOT, "metatarsal"):
                world[:, body.joint(f"{side}_{name}")] = world[:, body.joint(f"{side}_{name}")] @ level
        near = np.clip(2.0 - sole[..., 1].min(axis=1) / NEAR_M, 0.0, 1.0)
        for joints in (tuple(body.joint(f"{side}_{name}") for name in FOOT), (toes,)):
            tilt = tilt_of(world[:, joints[0]])
            size = np.linalg.norm(tilt, axis=1)
            flat = near * (1.0 - np.clip((size - FLAT_RAD) / FLAT_RAD, 0.0, 1.0))
            back = turns.matrices(-flat[:, None] * tilt)
            for joint in joints:
                world[:, joint] = world[:, joint] @ back
            steady = _steadied(motion, world[:, joints[0]], stands, stands & (flat > 0.5))
            for joint in joints:
                world[:, joint] = steady @ world[:, joint]
    return replace(motion, rotations=turns.local_from_world(world, body.parents))


def _steadied(motion: Motion, world: Array, stands: Mask, flat: Mask) -> Array:
    """Return (F, 3, 3) turns about the vertical with which a sole keeps its heading for as long as it stands.

    A sole on the floor cannot turn without rubbing. Who turns by more than `PIVOT_RAD` in one stand is held while the
    sole lies flat; who turns by more even then, on the spot, keeps doing so.
    """
    heading = np.unwrap(np.arctan2(world[:, 0, 2], world[:, 2, 2]))
    ease = max(round(STEADY_S / float(np.diff(motion.times_s).mean())), 1)
    change = np.zeros(len(stands))
    held = stands.copy()
    for first, last in runs(stands):
        if np.ptp(heading[first : last + 1]) > PIVOT_RAD:
            held[first : last + 1] = flat[first : last + 1]
    for first, last in runs(held):
        own = heading[first : last + 1]
        if np.ptp(own) > PIVOT_RAD:
            continue
        change[first : last + 1] = np.median(own) - own
        for edge, step in ((first, -1), (last, 1)):
            for k in range(1, ease):
                row = edge + step * k
                if not 0 <= row < len(held) or held[row]:
                    break
                change[row] += (1.0 - k / ease) * change[edge]
    return turns.rotations_about(1, change)


def tilt_of(world: Array) -> Array:
    """Return (F, 3) the rotation vectors, in the foot's own axes, that tilt soles with orientations (F, 3, 3)."""
    up = np.array([0.0, 1.0, 0.0])
    return turns.vectors(turns.rotations_between(up, np.swapaxes(world, -1, -2) @ up)) * -1.0


def settled(body: Body, motion: Motion) -> Motion:
    """Return the motion raised or lowered so that the lower sole lies on the floor; jumps stay jumps.

    The height at which limbs of other lengths leave the soles wanders by centimetres, and floors of captures tilt. Only
    what rises by more than `RISE_M` above all within `FLIGHT_S` is flight. Frames that would still sink are lifted.
    """
    step = float(np.diff(motion.times_s).mean())
    low = motion.root_m[:, 1] - on_ground(body, motion).root_m[:, 1]
    near = minimum_filter1d(low, max(round(FLIGHT_S / step), 1), mode="nearest")
    stands = np.flatnonzero(low <= near + RISE_M)
    floor = gaussian_filter1d(np.interp(np.arange(len(low)), stands, low[stands]), SMOOTH_S / step, mode="nearest")
    root = motion.root_m.copy()
    root[:, 1] += np.maximum(low - floor, 0.0) - low
    return replace(motion, root_m=root)
