"""The face's profile in a side photo: contour, and the generic profile laid on it.

Face nets fail at 90 degrees, so the profile is found by its shape: the generic midline profile is tried at every
place of the head's front outline, over a range of sizes and tilts, and the best one is refined.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray
from scipy.spatial import cKDTree
from skimage.measure import find_contours

Array = NDArray[np.float64]

#: Height of the skull's top (with some hair) over the nose tip, metres: gives each try its size.
TOP_OVER_NOSE_M = 0.14
#: Sizes tried around it: hair volume and head shape vary by about a quarter (taste).
SIZES = np.linspace(0.78, 1.22, 12)
TILTS = np.radians(np.linspace(-21.0, 21.0, 9))
#: Eye (between its corners) to mouth corner in the mean head's side view: length in metres, and how far forward the
#: mouth lies for an upright head, radians.
EYE_TO_MOUTH_M, EYE_TO_MOUTH_LEAN = 0.068, 0.10
#: The nose tip, the foremost point, lies within this height of a hinted nose; pose nets put it on the side wall.
NOSE_REACH_M, TIP_REACH_M = 0.025, 0.005
HINTED_SIZES = np.geomspace(0.78, 1.28, 9)
#: Error that a profile e times too large or small is worth; taste.
UNUSUAL_SIZE_M = 0.01
HINTED_TILTS = np.radians([-10.0, -5.0, 0.0, 5.0, 10.0])


@dataclass(frozen=True, slots=True, eq=False)
class Template:
    """Midline profiles of the generic head and of random heads around it, forehead to chin.

    Attributes
    ----------
    points_m : (B, M, 2) float64
        Forward and up, metres, relative to the nose tip.
    names : tuple of str
    landmarks_m : (B, K, 2) float64
        Named points of the same profiles.
    """

    points_m: Array
    names: tuple[str, ...]
    landmarks_m: Array


@dataclass(frozen=True, slots=True, eq=False)
class Hints:
    """Rough places of a side face, for example of a pose net.

    Attributes
    ----------
    nose_px, eye_px, mouth_px : (2,) float64
    """

    nose_px: Array
    eye_px: Array
    mouth_px: Array


@dataclass(frozen=True, slots=True, eq=False)
class Profile:
    """A profile found in a photo.

    Attributes
    ----------
    contour_px : (N, 2) float64
        The person's outline in front of the face, hair and throat included.
    facing : int
        +1 when the person looks to the image's right, -1 to the left.
    px_from_m : (2, 3) float64
        Maps the template's (forward, up, 1) to photo px.
    names : tuple of str
    points_px : (K, 2) float64
    error_m : float
        Trimmed mean distance of the laid-on template from the contour, metres.
    """

    contour_px: Array
    facing: int
    px_from_m: Array
    names: tuple[str, ...]
    points_px: Array
    error_m: float


def outline(mask: NDArray[np.uint8]) -> Array:
    """Return the longest closed outline of a person's probability (0..255), (N, 2) px with parts of a pixel."""
    padded = np.pad(mask.astype(np.float32), 1)
    contours = find_contours(padded, 127.5)
    if not contours:
        return np.zeros((0, 2))
    longest = max(contours, key=len)
    return np.asarray(longest[:, ::-1] - 1.0, dtype=np.float64)


def front_contour(contour: Array, facing: int, bottom_px: float) -> Array:
    """Return the outline points with nothing of the person in front of them by more than a deep eye socket."""
    rows = np.round(contour[:, 1]).astype(int)
    ahead = facing * contour[:, 0]
    front = np.full(rows.max() + 1, -np.inf)
    np.maximum.at(front, np.maximum(rows, 0), ahead)
    depth = 0.03 * float(np.ptp(contour[:, 1]))
    keep = (ahead > front[np.maximum(rows, 0)] - depth) & (contour[:, 1] < bottom_px)
    return np.asarray(contour[keep])


def _similarity(facing: int, size: float, tilt: float, nose_px: Array) -> Array:
    """Return the (2, 3) map of (forward, up, 1) metres to px; tilt turns the face upwards."""
    c, s = np.cos(tilt), np.sin(tilt)
    forward, up = size * np.array([facing * c, -s]), size * np.array([-facing * s, -c])
    return np.column_stack([forward, up, nose_px])


def _score(distance: Array) -> Array:
    """Return the mean of the best four fifths along the last axis."""
    keep = int(0.8 * distance.shape[-1])
    return np.asarray(np.partition(distance, keep, axis=-1)[..., :keep].mean(axis=-1))


def _tries(contour: Array, facing: int, top_px: float, hints: Hints | None) -> tuple[Array, Array, Array]:
    """Return noses (N, 2), their sizes (N, S) px per metre, and tilts (T,) to try."""
    if hints is None:
        noses = contour[:: max(1, len(contour) // 150)]
        noses = noses[noses[:, 1] > top_px + 5]
        return noses, SIZES[None] * (noses[:, 1:2] - top_px) / TOP_OVER_NOSE_M, TILTS
    down = hints.mouth_px - hints.eye_px
    by_face = float(np.linalg.norm(down)) / EYE_TO_MOUTH_M
    lean = float(np.arctan2(facing * down[0], down[1])) - EYE_TO_MOUTH_LEAN
    near = contour[np.abs(contour[:, 1] - hints.nose_px[1]) < NOSE_REACH_M * by_face]
    if len(near) == 0:
        return _tries(contour, facing, top_px, None)
    tip = near[int(np.argmax(facing * near[:, 0]))]
    by_head = max(float(tip[1] - top_px), 1.0) / TOP_OVER_NOSE_M
    size = float(np.sqrt(by_face * by_head))
    noses = near[np.linalg.norm(near - tip, axis=1) < TIP_REACH_M * size]
    noses = noses[:: max(1, len(noses) // 9)]
    return noses, np.tile(size * HINTED_SIZES, (len(noses), 1)), lean + HINTED_TILTS


def _search(
    contour: Array, tree: cKDTree, template: Template, facing: int, top_px: float, hints: Hints | None
) -> tuple[Array, int]:
    """Return the best map over all profiles, noses, sizes and tilts, and the profile's number."""
    noses, size, tilts = _tries(contour, facing, top_px, hints)
    middle = float(np.median(size))
    best, found, number = np.inf, np.zeros((2, 3)), 0
    for index, profile in enumerate(template.points_m if hints is not None else template.points_m[:1]):
        coarse = profile[:: max(1, len(profile) // 28)]
        for tilt in tilts:
            flat = coarse @ _similarity(facing, 1.0, float(tilt), np.zeros(2))[:, :2].T
            tried = noses[:, None, None] + size[..., None, None] * flat
            distance, _ = tree.query(tried.reshape(-1, 2))
            error = _score(distance.reshape(*size.shape, len(coarse))) / size
            # Of equal fits the usual size wins: a small profile fits any smooth piece of outline.
            usual = size / middle if hints is not None else np.broadcast_to(SIZES, size.shape)
            error = error + UNUSUAL_SIZE_M * np.log(usual) ** 2
            nose, which = np.unravel_index(int(np.argmin(error)), error.shape)
            if error[nose, which] < best:
                best, number = float(error[nose, which]), index
                found = _similarity(facing, float(size[nose, which]), float(tilt), noses[nose])
    return found, number


def _refine(px_from_m: Array, tree: cKDTree, contour: Array, profile: Array, facing: int) -> tuple[Array, float]:
    """Return the map after laying the profile on its nearest contour points a few times (trimmed ICP)."""
    flat = profile * [facing, -1.0]
    error = np.inf
    for _ in range(3):
        here = profile @ px_from_m[:, :2].T + px_from_m[:, 2]
        distance, index = tree.query(here)
        size = float(np.sqrt(abs(np.linalg.det(px_from_m[:, :2]))))
        error = float(_score(distance)) / size
        keep = distance <= max(np.quantile(distance, 0.85), 1e-9)
        source, target = flat[keep] @ [1, 1j], contour[index[keep]] @ [1, 1j]
        centred, aim = source - source.mean(), target - target.mean()
        factor = (np.conj(centred) @ aim) / (np.conj(centred) @ centred)
        shift = target.mean() - factor * source.mean()
        linear = np.array([[factor.real, -factor.imag], [factor.imag, factor.real]]) @ np.diag([facing, -1.0])
        px_from_m = np.column_stack([linear, [shift.real, shift.imag]])
    return px_from_m, error


def find_profile(
    mask: NDArray[np.uint8], template: Template, *, facing: int | None = None, hints: Hints | None = None
) -> Profile | None:
    """Return the profile found in a side photo's mask, or None without an outline.

    Parameters
    ----------
    mask : (H, W) uint8
        Person probability, 0..255.
    facing : int, optional
        +1 or -1 when known; otherwise the side on which the profile fits better.
    hints : Hints, optional
        Rough places of nose, eye and mouth, which shorten the search and make it safe.
    """
    contour = outline(mask)
    if len(contour) < 50:
        return None
    tried = []
    for side in (1, -1) if facing is None else (facing,):
        front = front_contour(contour, side, float(contour[:, 1].max()) + 1.0)
        tree = cKDTree(front)
        found, number = _search(front, tree, template, side, float(contour[:, 1].min()), hints)
        px_from_m, error = _refine(found, tree, front, template.points_m[number], side)
        tried.append((error, side, px_from_m, front, number))
    error, side, px_from_m, front, number = min(tried, key=lambda t: t[0])
    points = named_points(front, px_from_m, template.names, template.landmarks_m[number])
    return Profile(front, side, px_from_m, template.names, points, error)


#: Tries around a first guess when the profile itself is known well: sizes, tilts, and how far the nose tip may be off.
KNOWN_SIZES = np.geomspace(0.75, 1.33, 19)
KNOWN_TILTS = np.radians(np.linspace(-14.0, 14.0, 9))
KNOWN_TIP_M = 0.007


def lay_profile(contour: Array, profile_m: Array, nose_px: Array, *, size: float, facing: int) -> tuple[Array, float]:
    """Return the (2, 3) map (forward, up, 1) -> px that lays a known profile on a contour, and its error in metres.

    Parameters
    ----------
    contour : (N, 2) px
    profile_m : (M, 2)
        Forward and up from the nose tip, metres.
    nose_px : (2,)
        The nose tip in the photo, roughly.
    size : float
        First guess, px per metre.
    """
    tree = cKDTree(contour)
    near = contour[np.linalg.norm(contour - nose_px, axis=1) < KNOWN_TIP_M * size]
    noses = near[:: max(1, len(near) // 13)] if len(near) else nose_px[None]
    best, found = np.inf, _similarity(facing, size, 0.0, nose_px)
    for tilt in KNOWN_TILTS:
        flat = profile_m @ _similarity(facing, 1.0, float(tilt), np.zeros(2))[:, :2].T
        sizes = size * KNOWN_SIZES
        tried = noses[:, None, None] + sizes[None, :, None, None] * flat
        distance, _ = tree.query(tried.reshape(-1, 2))
        error = _score(distance.reshape(len(noses), len(sizes), len(flat))) / sizes
        nose, which = np.unravel_index(int(np.argmin(error)), error.shape)
        if error[nose, which] < best:
            best, found = float(error[nose, which]), _similarity(facing, float(sizes[which]), float(tilt), noses[nose])
    return _refine(found, tree, contour, profile_m, facing)


#: Where each named point is most extreme, as (forward, up) of the face's own frame; None: nearest contour point.
DIRECTIONS: dict[str, tuple[float, float] | None] = {
    "glabella": None,
    "nasion": (-1.0, 0.0),
    "nose_tip": (1.0, 0.0),
    "subnasale": (-0.8, 0.6),
    "lip_top": (1.0, 0.15),
    "stomion": (-1.0, 0.0),
    "lip_bottom": (1.0, -0.15),
    "chin_front": (1.0, -0.1),
    "chin_bottom": (0.35, -1.0),
}
WINDOW_M = 0.006


def named_points(contour: Array, px_from_m: Array, names: tuple[str, ...], landmarks_m: Array) -> Array:
    """Return the named points: the most extreme contour point within 6 mm of where the template has it."""
    size = float(np.sqrt(abs(np.linalg.det(px_from_m[:, :2]))))
    tree = cKDTree(contour)
    out = np.zeros((len(names), 2))
    for row, (name, place) in enumerate(zip(names, landmarks_m, strict=True)):
        guess = px_from_m[:, :2] @ place + px_from_m[:, 2]
        _, nearest = tree.query(guess)
        direction = DIRECTIONS.get(name)
        near = tree.query_ball_point(contour[nearest], WINDOW_M * size)
        if direction is None or not near:
            out[row] = contour[nearest]
            continue
        away = px_from_m[:, :2] @ np.array(direction) / size
        # A gentle pull to the template's place keeps flat stretches from sliding to the window's end.
        off = np.linalg.norm(contour[near] - guess, axis=1)
        out[row] = contour[near[int(np.argmax(contour[near] @ away - 0.25 * off))]]
    return out
