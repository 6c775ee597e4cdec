"""Tell skin, hair and cloth apart round the head."""

from __future__ import annotations

from typing import Final

import cv2
import numpy as np
from numpy.typing import NDArray

from cloner.vision.hair_edge import draw_edge
from cloner.vision.head_frame import HeadFrame, face_area, find_head

Floats = NDArray[np.float64]
Flags = NDArray[np.bool_]

BACKGROUND: Final = 0
SKIN: Final = 1
HAIR: Final = 2
CLOTH: Final = 3

WORK_HEAD_PX: Final = 150.0  # taste: strands vanish, the hairline stays
_REACH: Final = 1.9  # half width and lower reach of the looked-at region, in heads
_BALD_DISTANCE: Final = 3.0  # Mahalanobis: a crown this near to the skin is skin
_UNLIKE: Final = 16.0  # Lab, lightness weighted: painted hair 20-80 (median 31), shaded bald crowns up to 12
# Gaussians a class and the least log density; cloth may have any colour
_MIXTURES: Final = ((2, -22.0), (3, -22.0), (4, -13.0))
_LIGHTNESS: Final = 0.6  # weight of L in Lab: light falls unevenly, colour stays


def head_hair_labels(
    rgb: NDArray[np.uint8],
    mask: NDArray[np.float32],
    face_points: Floats | None,
    view: str,
    *,
    pose_points: Floats | None = None,
) -> NDArray[np.uint8]:
    """Label the person's pixels near the head as skin, hair or cloth.

    Colour models are learned from places that are sure (cheeks, crown, shoulders),
    joined with where each thing may be, smoothed along edges, learned again.

    Parameters
    ----------
    rgb : (H, W, 3) uint8
    mask : (H, W) float32, 0..1
        The refined person probability.
    face_points : (468, 2) float64 or None
        Face mesh in px; None for sides and backs.
    view : str or ViewId
        Tells front, side and back apart.
    pose_points : (33, 2) float64, optional
        Pose points in px; wanted for sides and backs.

    Returns
    -------
    (H, W) uint8
        0 background, 1 skin, 2 hair, 3 cloth or anything else of the person (also all
        that lies far from the head). A bald head has no 2.
    """
    person = np.asarray(mask > 0.5)
    labels = np.where(person, CLOTH, BACKGROUND).astype(np.uint8)
    if not person.any():
        return labels
    head = find_head(person, face_points, str(view), pose_points)
    scale = WORK_HEAD_PX / max(head.head_px, 8.0)
    x0 = int(max(head.x_px - _REACH * head.head_px, 0))
    x1 = int(min(head.x_px + _REACH * head.head_px, rgb.shape[1]))
    y0 = int(max(head.top_px - 0.15 * head.head_px, 0))
    y1 = int(min(head.chin_px + _REACH * head.head_px, rgb.shape[0]))
    if x1 - x0 < 4 or y1 - y0 < 4:
        return labels
    size = (max(4, round((x1 - x0) * scale)), max(4, round((y1 - y0) * scale)))
    small = np.asarray(cv2.resize(rgb[y0:y1, x0:x1], size, interpolation=cv2.INTER_AREA), np.uint8)
    inside = cv2.resize(person[y0:y1, x0:x1].astype(np.float32), size, interpolation=cv2.INTER_AREA)
    shift = np.array([x0, y0], np.float64)
    top, chin, x, ear = head.top_px - y0, head.chin_px - y0, head.x_px - x0, head.ear_px - y0
    small_head = HeadFrame(top * scale, chin * scale, x * scale, ear * scale, head.facing)
    small_face = None if face_points is None else (face_points[:, :2] - shift) * scale
    small_pose = None if pose_points is None else (pose_points[:, :2] - shift) * scale
    hints = _skin_hint(rgb, person, pose_points)
    scores = _classify(small, inside > 0.5, small_head, small_face, small_pose, hints, str(view))
    whole = np.stack([cv2.resize(s, (x1 - x0, y1 - y0)) for s in scores])
    part = np.where(whole[2] > whole[0], np.uint8(CLOTH), np.uint8(SKIN))
    hair = whole[1] / np.maximum(whole[1] + np.maximum(whole[0], whole[2]), 1e-6)
    face = None if small_face is None else small_face / scale
    fine = draw_edge(rgb[y0:y1, x0:x1], hair, person[y0:y1, x0:x1], face, head.head_px, head.ear_px - y0)
    part[fine] = HAIR
    labels[y0:y1, x0:x1] = np.where(person[y0:y1, x0:x1], part, BACKGROUND)
    return labels


def _skin_hint(rgb: NDArray[np.uint8], person: Flags, pose_points: Floats | None) -> Floats:
    """Return Lab colours (N, 3) of the hands, where a body photo shows them."""
    found = []
    if pose_points is not None:
        for wrist, index in ((15, 19), (16, 20)):
            x, y = np.round((pose_points[wrist] + pose_points[index]) / 2).astype(int)
            if 4 <= x < rgb.shape[1] - 4 and 4 <= y < rgb.shape[0] - 4 and person[y, x]:
                found.append(rgb[y - 4 : y + 5, x - 4 : x + 5][person[y - 4 : y + 5, x - 4 : x + 5]])
    if not found:
        return np.zeros((0, 3))
    pixels = np.ascontiguousarray(np.concatenate(found)[None], np.uint8)
    return np.asarray(cv2.cvtColor(pixels, cv2.COLOR_RGB2Lab)[0], np.float64)


def _seeds(
    lab: Floats, inside: Flags, head: HeadFrame, face: Floats | None, pose: Floats | None, view: str
) -> tuple[Flags, Flags, Flags]:
    """Return where skin, crown and cloth are sure."""
    height, width = inside.shape
    ys, xs = np.mgrid[:height, :width].astype(np.float64)
    unit = head.head_px
    skin = np.zeros_like(inside)
    if face is not None:
        skin = face_area(face, inside.shape)[1] & inside
    elif pose is not None and head.facing:
        front = (pose[0] + pose[[9, 10]].mean(axis=0)) / 2
        cheek = 0.6 * front + 0.4 * pose[[7, 8]].mean(axis=0)
        skin = (np.hypot(xs - cheek[0], ys - cheek[1]) < 0.13 * unit) & inside
    core = cv2.erode(inside.astype(np.uint8), np.ones((5, 5), np.uint8)) > 0
    crown = core & (ys < head.top_px + (0.16 if face is not None else 0.3) * unit)
    if face is not None:
        crown &= ys < face[10, 1]
    if head.facing:  # the forehead is no crown: stay behind it
        crown &= (xs - head.x_px) * head.facing < 0.1 * unit
        rear = core & (ys < head.ear_px) & ((head.x_px - xs) * head.facing > 0.2 * unit)
        crown |= rear & (ys > head.top_px + 0.1 * unit)
    if view.endswith("back"):
        crown = core & (ys < head.ear_px - 0.1 * unit)
    below = ys > head.chin_px + 0.75 * unit
    cloth = core & below & ((np.abs(xs - head.x_px) > 0.45 * unit) | view.endswith("front"))
    return skin, crown, cloth


def _fit(colours: Floats, *, noise: float = 3.0) -> tuple[Floats, Floats] | None:
    """Return the mean and inverse covariance of (N, 3) colours, outliers left out."""
    if len(colours) < 12:
        return None
    middle = np.median(colours, axis=0)
    far = np.abs(colours - middle).max(axis=1)
    kept = colours[far <= np.quantile(far, 0.85)]
    cov = np.cov(kept.T) + noise * noise * np.eye(3)
    return np.asarray(kept.mean(axis=0), np.float64), np.asarray(np.linalg.inv(cov), np.float64)


def _square(planes: Floats, mean: Floats, inverse: Floats) -> NDArray[np.float32]:
    """Return the squared Mahalanobis distance (H, W) of colours (3, H, W); one product, in single precision."""
    root = np.linalg.cholesky(inverse).T.astype(np.float32)
    # centred before the product: single precision loses the difference of large numbers
    x, y, z = root @ (planes.reshape(3, -1) - mean[:, None]).astype(np.float32)
    return np.asarray((x * x + y * y + z * z).reshape(planes.shape[1:]), np.float32)


def _unlike_skin(lab: Floats, skin: Flags, crown: Flags) -> Flags:
    """Return the crown's pixels that are nearer to its own colour than to the skin's, where the two are far apart.

    Light from aside spreads the skin's colours so far that its Gaussian holds dark hair too; middles do not move so.
    """
    own, other = np.median(lab[crown], axis=0), np.median(lab[skin], axis=0)
    nearer = np.linalg.norm(lab - own, axis=-1) < np.linalg.norm(lab - other, axis=-1)
    return np.asarray(crown & nearer & (float(np.linalg.norm(own - other)) > _UNLIKE))


def _mixture(lab: Floats, planes: Floats, where: Flags, parts: int, floor: float) -> Floats:
    """Return the log density of all pixels under a Gaussian mixture of the seeds."""
    samples = lab[where]
    samples = samples[:: max(1, len(samples) // 2000)]
    if len(samples) < 8 * parts:
        return np.full(lab.shape[:2], 0.7 * floor)
    # start from equal shares along lightness: no random start, same photo same labels
    order = np.argsort(np.argsort(samples[:, 0], kind="stable"), kind="stable")
    member = (order * parts // len(samples)).astype(np.int32)[:, None]
    ends = (cv2.TERM_CRITERIA_COUNT + cv2.TERM_CRITERIA_EPS, 12, 0.5)
    cv2.kmeans(samples.astype(np.float32), parts, member, ends, 1, cv2.KMEANS_USE_INITIAL_LABELS)
    best: NDArray[np.float32] | None = None
    for part in range(parts):
        chosen = samples[member[:, 0] == part]
        if len(chosen) < 6:
            continue
        cov = np.cov(chosen.T) + 16.0 * np.eye(3)
        square = _square(planes, chosen.mean(axis=0), np.asarray(np.linalg.inv(cov), np.float64))
        weight = np.float32(np.log(len(chosen) / len(samples)) - 0.5 * np.log(np.linalg.det(cov)))
        density = weight - np.float32(0.5) * square
        best = density if best is None else _log_sum(best, density)
    return np.full(lab.shape[:2], floor) if best is None else np.asarray(np.maximum(best, floor), np.float64)


def _log_sum(first: NDArray[np.float32], second: NDArray[np.float32]) -> NDArray[np.float32]:
    """Return the logarithm of a sum of exponentials, as ``np.logaddexp`` does, in a quarter of its time."""
    smaller = np.exp(-np.abs(first - second))
    return np.asarray(np.maximum(first, second) + np.log(np.float32(1.0) + smaller), np.float32)


def _classify(
    small: NDArray[np.uint8],
    inside: Flags,
    head: HeadFrame,
    face: Floats | None,
    pose: Floats | None,
    hints: Floats,
    view: str,
) -> NDArray[np.float32]:
    """Return (3, h, w) smoothed scores for skin, hair and cloth."""
    lab = cv2.cvtColor(cv2.GaussianBlur(small, (0, 0), 1.0), cv2.COLOR_RGB2Lab).astype(np.float64)
    lab *= (_LIGHTNESS, 1.0, 1.0)
    planes = np.ascontiguousarray(lab.transpose(2, 0, 1))
    hints = hints * (_LIGHTNESS, 1.0, 1.0)
    skin, crown, cloth = _seeds(lab, inside, head, face, pose, view)
    skin_fit = _fit(lab[skin]) or _fit(hints, noise=8.0)
    if skin_fit is not None:
        distance = np.sqrt(_square(planes, *skin_fit))
        hair = crown & (distance > (_BALD_DISTANCE if skin.any() else 1.0))
        if skin.any() and crown.any():
            hair |= _unlike_skin(lab, skin, crown)
        cloth &= distance > 2.0
        bald = hair.sum() < 0.25 * max(crown.sum(), 1)
        if face is None and not bald:
            hair = crown  # highlights are hair too; a front crown holds forehead
        if not skin.any():
            skin = inside & (distance < 2.0) & ~crown
    else:
        hair, bald = crown, False
    prior = _prior(inside.shape, head, face, view, bald=bool(bald))
    seeds = [skin, hair, cloth]
    scores = np.zeros((3, *inside.shape))
    # 4 px of 150 a head: about 6 mm; 1e-3: contrasts above 8 grey levels stay edges
    along = cv2.ximgproc.createGuidedFilter(small.astype(np.float32) / 255.0, 4, 1e-3)
    for _ in range(3):
        for k, where in enumerate(seeds):
            scores[k] = _mixture(lab, planes, where, *_MIXTURES[k]) + prior[k]
        smooth = _smooth(along, scores)
        label = smooth.argmax(axis=0)
        sure = smooth.max(axis=0) > 0.8
        seeds = [inside & (label == k) & sure for k in range(3)]
        seeds[0] |= skin
    return _connected(smooth, inside, skin, head)


def _prior(shape: tuple[int, int], head: HeadFrame, face: Floats | None, view: str, *, bald: bool) -> Floats:
    """Return (3, h, w) log weights: where skin, hair and cloth may be."""
    ys, xs = np.mgrid[: shape[0], : shape[1]].astype(np.float64)
    prior = np.zeros((3, *shape))
    below = (ys - head.chin_px) / head.head_px
    aside = np.abs(xs - head.x_px) / head.head_px
    prior[2] -= 8.0 * np.clip((0.18 - below) / 0.12, 0.0, 1.0)
    prior[0] -= 6.0 * ((aside > 0.55) & (below > 0.1))  # shoulders are dressed
    prior[1] -= np.clip(3.0 * (below + 0.1), 0.0, 3.0)
    prior[0] -= 3.0 * np.clip(below - 0.6, 0.0, 1.0)  # a neck is half a head long
    upper = ys < head.ear_px - 0.1 * head.head_px
    if face is not None:
        oval = face_area(face, shape)[0]
        brows = float(face[[105, 334], 1].min())
        prior[1] -= 8.0 * (oval & (ys > brows))
        forehead = max(float(face[10, 1]) - head.top_px, 1.0)
        prior[0] -= 6.0 * np.clip((face[10, 1] - ys) / forehead, 0.0, 1.0)
        prior[0] -= 5.0 * (~oval & (ys < brows)) * np.clip((aside - 0.2) / 0.1, 0.0, 1.0)
    elif head.facing:
        ahead = (xs - head.x_px) * head.facing / head.head_px
        prior[1] -= 8.0 * ((ahead > 0.15) & (ys > head.ear_px - 0.12 * head.head_px))
        prior[0] -= 8.0 * ((ahead < 0.0) & upper)
        prior[0] -= 8.0 * ((ahead < 0.2) & (ys < head.top_px + 0.2 * head.head_px))
        prior[0] -= 5.0 * (ahead < -0.35)  # behind the neck only hair hangs
        prior[1] -= 6.0 * ((np.abs(ahead) < 0.2) & (below > -0.2))  # a neck in shadow
    elif view.endswith("back"):
        prior[0] -= 8.0 * upper
        prior[0] -= 2.0 * (np.abs(xs - head.x_px) < 0.15 * head.head_px)
    if bald:
        prior[1] -= 40.0
        prior[0] += np.where(below < 0.0, 20.0, 0.0)
    return prior


def _smooth(along: cv2.ximgproc.GuidedFilter, scores: Floats) -> Floats:
    """Return class probabilities smoothed along the photo's edges."""
    shares = np.exp((scores - scores.max(axis=0)).astype(np.float32))
    shares /= shares.sum(axis=0)
    smooth = along.filter(np.ascontiguousarray(shares.transpose(1, 2, 0)))
    return np.ascontiguousarray(smooth.transpose(2, 0, 1), np.float64)


def _connected(shares: Floats, inside: Flags, sure_skin: Flags, head: HeadFrame) -> NDArray[np.float32]:
    """Return the shares with hair in one piece and no skin islands within it."""
    skin = ((shares.argmax(axis=0) == 0) & inside).astype(np.uint8)
    _, pieces, stats, _ = cv2.connectedComponentsWithStats(skin, connectivity=4)
    rooted = np.union1d(np.unique(pieces[sure_skin & (skin > 0)]), [0])
    middle = stats[:, cv2.CC_STAT_TOP] + stats[:, cv2.CC_STAT_HEIGHT] / 2.0
    high = np.flatnonzero(middle < head.ear_px - 0.08 * head.head_px)  # an ear may stand alone
    island = np.isin(pieces, np.setdiff1d(high, rooted))
    shares[0] = np.where(island, 0.0, shares[0])
    hair = ((shares.argmax(axis=0) == 1) & inside).astype(np.uint8)
    count, pieces, stats, _ = cv2.connectedComponentsWithStats(hair, connectivity=8)
    if count > 1:
        areas = stats[1:, cv2.CC_STAT_AREA]
        near = stats[1:, cv2.CC_STAT_TOP] < head.ear_px + 0.3 * head.head_px  # locks hang from behind the ears
        good = 1 + np.flatnonzero(near & (areas > 0.04 * areas.max()))
        shares[1] = np.where((hair > 0) & ~np.isin(pieces, good), 0.0, shares[1])
    return shares.astype(np.float32)
