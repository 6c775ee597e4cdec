"""The head's own data: face shape space, 52 ARKit units and 15 visemes."""

from __future__ import annotations

import numpy as np
import population
import shape_basis
from cage import Cage
from source import FloatArray, IntArray, Source

FACES = 60
UNITS = "faceunits01/targets/faceunits"
GAZE_DEG = {"Out": 30.0, "In": 30.0, "Up": 20.0, "Down": 26.0}  # reach of a human eye in comfort; taste
SMALLEST_M = 2e-5  # a move below this is dropped from sparse units

ARKIT = (
    "browDownLeft browDownRight browInnerUp browOuterUpLeft browOuterUpRight cheekPuff cheekSquintLeft "
    "cheekSquintRight eyeBlinkLeft eyeBlinkRight eyeLookDownLeft eyeLookDownRight eyeLookInLeft eyeLookInRight "
    "eyeLookOutLeft eyeLookOutRight eyeLookUpLeft eyeLookUpRight eyeSquintLeft eyeSquintRight eyeWideLeft "
    "eyeWideRight jawForward jawLeft jawOpen jawRight mouthClose mouthDimpleLeft mouthDimpleRight mouthFrownLeft "
    "mouthFrownRight mouthFunnel mouthLeft mouthLowerDownLeft mouthLowerDownRight mouthPressLeft mouthPressRight "
    "mouthPucker mouthRight mouthRollLower mouthRollUpper mouthShrugLower mouthShrugUpper mouthSmileLeft "
    "mouthSmileRight mouthStretchLeft mouthStretchRight mouthUpperUpLeft mouthUpperUpRight noseSneerLeft "
    "noseSneerRight tongueOut"
).split()

# Mouth shapes as mixtures of ARKit units ("+" stands for Left and Right) and three tongue moves of our own.
# Weights are ours, set by eye on the rendered head.
VISEMES: dict[str, dict[str, float]] = {
    "viseme_sil": {},
    "viseme_PP": {"mouthPress+": 0.5, "mouthRollLower": 0.35, "mouthRollUpper": 0.3, "mouthPucker": 0.1},
    "viseme_FF": {"mouthRollLower": 0.6, "mouthUpperUp+": 0.35, "jawOpen": 0.06},
    "viseme_TH": {"jawOpen": 0.16, "mouthLowerDown+": 0.2, "mouthUpperUp+": 0.15, "tongueOut": 0.35},
    "viseme_DD": {"jawOpen": 0.12, "mouthLowerDown+": 0.3, "mouthUpperUp+": 0.2, "tongueTipUp": 1.0},
    "viseme_kk": {"jawOpen": 0.2, "mouthLowerDown+": 0.2, "mouthStretch+": 0.1, "tongueBackUp": 1.0},
    "viseme_CH": {"jawOpen": 0.08, "mouthFunnel": 0.6, "mouthPucker": 0.15, "tongueTipUp": 0.6},
    "viseme_SS": {"jawOpen": 0.05, "mouthStretch+": 0.35, "mouthLowerDown+": 0.35, "mouthUpperUp+": 0.2},
    "viseme_nn": {"jawOpen": 0.16, "mouthLowerDown+": 0.2, "mouthUpperUp+": 0.1, "tongueTipUp": 1.0},
    "viseme_RR": {"jawOpen": 0.12, "mouthFunnel": 0.35, "mouthPucker": 0.25, "tongueCurl": 1.0},
    "viseme_aa": {"jawOpen": 0.6, "mouthLowerDown+": 0.2, "mouthUpperUp+": 0.1},
    "viseme_E": {"jawOpen": 0.28, "mouthStretch+": 0.3, "mouthSmile+": 0.25, "mouthLowerDown+": 0.2},
    "viseme_I": {"jawOpen": 0.14, "mouthStretch+": 0.35, "mouthSmile+": 0.35, "mouthLowerDown+": 0.2},
    "viseme_O": {"jawOpen": 0.36, "mouthFunnel": 0.55, "mouthPucker": 0.2},
    "viseme_U": {"jawOpen": 0.14, "mouthPucker": 0.75, "mouthFunnel": 0.35},
}

_SKIP = ("head-age", "head-trans", "eye-push", "ear-shape-pointed", "eyefold-c")  # doubles of macros; caricatures
_FOLDERS = {
    "head": 0.35,
    "forehead": 0.3,
    "eyes": 0.5,
    "eyebrows": 0.5,
    "nose": 0.5,
    "mouth": 0.4,
    "chin": 0.5,
    "cheek": 0.5,
    "ears": 0.4,
    "asym": 0.18,
}  # reach of the random weights; taste, short of caricature
_OPPOSITES = (
    ("decr", "incr"),
    ("down", "up"),
    ("in", "out"),
    ("backward", "forward"),
    ("concave", "convex"),
    ("compress", "uncompress"),
    ("l", "r"),
)


def face_pairs(source: Source) -> tuple[tuple[str, str, float], ...]:
    """Return the head's local target pairs (negative, positive, reach), "{s}" for a side; negative may be ""."""
    pairs: list[tuple[str, str, float]] = []
    for folder, reach in _FOLDERS.items():
        stems = {
            f.rsplit("/", 1)[1].removesuffix(".target.gz")
            for f in source.folder(f"mpfb2/targets/{folder}")
            if f.endswith(".target.gz")
        }
        done: set[str] = set()
        for stem in sorted(stems):
            if stem in done or any(s in stem for s in _SKIP) or stem.startswith(("r-", "asymm")):
                continue
            start, _, end = stem.rpartition("-")
            other = next((b for a, b in _OPPOSITES if end == a and f"{start}-{b}" in stems), None)
            if other is None and any(end == b and f"{start}-{a}" in stems for a, b in _OPPOSITES):
                continue  # comes with its negative
            name = f"{folder}/{{s}}{stem[1:]}" if stem.startswith("l-") else f"{folder}/{stem}"
            if other is None:
                pairs.append(("", name, reach))
            else:
                pairs.append((name, name[: len(name) - len(end)] + other, reach))
            done.add(stem)
    return tuple(pairs)


def blend_weights(vertices_m: FloatArray) -> FloatArray:
    """Return (V,) weights: 1 on the head, falling smoothly to 0 at the neck base of the mean body of 1.70 m.

    Both ends are planes leaning forward: neck base from the throat's pit to the nape, rising towards the shoulders;
    head from under the chin to below the occiput. Metres, read off the mean body.
    """
    z, y = vertices_m[:, 2], vertices_m[:, 1]
    base = 1.418 - 0.16 * (z - 0.062) + 0.4 * np.abs(vertices_m[:, 0])
    top = 1.467 - 0.48 * (z - 0.080)
    t = np.clip((y - base) / np.maximum(top - base, 1e-3), 0.0, 1.0)
    t[y < 1.38] = 0.0
    return t * t * (3.0 - 2.0 * t)


def _align(moved: FloatArray, fixed: FloatArray, rows: IntArray) -> FloatArray:
    """Return ``moved`` after the similarity that brings its ``rows`` closest to those of ``fixed``."""
    a, b = moved[rows].astype(np.float64), fixed[rows]
    ca, cb = a.mean(axis=0), b.mean(axis=0)
    u, s, vt = np.linalg.svd((b - cb).T @ (a - ca))
    flip = np.array([1.0, 1.0, np.sign(np.linalg.det(u @ vt))])
    turn = u @ (flip[:, None] * vt)
    scale = (s * flip).sum() / ((a - ca) ** 2).sum()
    return scale * (moved - ca) @ turn.T + cb


def _keep_eyes_round(cage: Cage, offsets: FloatArray, mean_m: FloatArray) -> None:
    """Reduce the eyeballs' offsets (N, V, 3) in place to a shift and a change of size: no bend, no turn of gaze."""
    for part in ("eye_left", "eye_right"):
        rows = cage.part(part)
        spokes = mean_m[rows] - mean_m[rows].mean(axis=0)
        shift = offsets[:, rows].mean(axis=1, keepdims=True)
        size = ((offsets[:, rows] - shift) * spokes).sum(axis=(1, 2)) / (spokes**2).sum()
        offsets[:, rows] = shift + size[:, None, None] * spokes


def face_basis(
    source: Source,
    cage: Cage,
    bodies_m: FloatArray,
    mean_m: FloatArray,
    blend: FloatArray,
    *,
    rng: np.random.Generator,
) -> tuple[FloatArray, FloatArray]:
    """Return (F, V, 3) unit-variance face directions, similarity removed, fading over the neck, and their shares.

    Parameters
    ----------
    bodies_m : (N, V, 3) random normalised adults, whose heads bring age, sex and descent.
    mean_m : (V, 3) the mean body.
    """
    pairs = face_pairs(source)
    names, weights = population.pair_weights(pairs, bodies_m.shape[0], rng=rng, asymmetry=0.12)
    units = np.stack([cage.build(source.mpfb_target(n)) for n in names]).astype(np.float32)
    head = np.flatnonzero(blend > 0)
    core = np.flatnonzero((blend >= 1.0) & (cage.vertex_part == 0))
    flat = units[:, head].reshape(len(names), -1)
    offsets = np.empty((bodies_m.shape[0], head.size, 3), dtype=np.float32)
    for row, body in enumerate(bodies_m):
        moved = body.astype(np.float64)
        moved[head] += (weights[row].astype(np.float32) @ flat).reshape(-1, 3)
        offsets[row] = (_align(moved, mean_m, core)[head] - mean_m[head]) * blend[head, None]
    centre = offsets.mean(axis=0)
    basis, _, share = shape_basis.principal(offsets.reshape(len(offsets), -1), centre.reshape(-1), FACES)
    out = np.zeros((FACES, *mean_m.shape))
    out[:, head] = basis.reshape(FACES, -1, 3)
    _keep_eyes_round(cage, out, mean_m)
    return out, share


def _mirrored(offsets: FloatArray, mirror: IntArray) -> FloatArray:
    return offsets[mirror] * np.array([-1.0, 1.0, 1.0])


def _swap_side(name: str) -> str:
    if "Left" in name:
        return name.replace("Left", "Right")
    return name.replace("Right", "Left")


def _gaze(cage: Cage, mean_m: FloatArray, part: str, word: str) -> FloatArray:
    """Return an eyeball's offsets when it turns; "Out" is away from the nose."""
    rows = cage.part(part)
    spokes = mean_m[rows] - cage.eye_centre(mean_m, part.removeprefix("eye_"))
    angle = np.radians(GAZE_DEG[word])
    if word in ("Out", "In"):
        angle *= (1 if word == "Out" else -1) * (1 if part == "eye_left" else -1)
        turn = np.array([[np.cos(angle), 0, np.sin(angle)], [0, 1, 0], [-np.sin(angle), 0, np.cos(angle)]])
    else:
        angle *= -1 if word == "Up" else 1
        turn = np.array([[1, 0, 0], [0, np.cos(angle), -np.sin(angle)], [0, np.sin(angle), np.cos(angle)]])
    out = np.zeros_like(mean_m)
    out[rows] = spokes @ turn.T - spokes
    return out


def _rigid(rest_m: FloatArray, offsets: FloatArray, points_m: FloatArray) -> FloatArray:
    """Return the offsets of ``points_m`` under the rigid motion nearest to ``offsets`` of ``rest_m``, (N, 3) each."""
    if not offsets.any():
        return np.zeros_like(points_m)
    middle, moved = rest_m.mean(axis=0), (rest_m + offsets).mean(axis=0)
    u, _, vt = np.linalg.svd((rest_m + offsets - moved).T @ (rest_m - middle))
    turn = u @ np.diag([1.0, 1.0, np.linalg.det(u @ vt)]) @ vt
    centre = points_m.mean(axis=0)
    return (points_m - centre) @ turn.T + centre + (moved - middle) - points_m


def arkit_units(source: Source, cage: Cage, mean_m: FloatArray, base_m: FloatArray) -> dict[str, FloatArray]:
    """Return the 52 units as (V, 3) offsets in metres on the mean head; left and right ones mirror each other.

    Parameters
    ----------
    base_m : (V, 3) the undeformed product mesh, only to bring the targets to the mean head's size.
    """
    head = np.flatnonzero((cage.vertex_part == 0) & (mean_m[:, 1] > 1.5))
    scale = np.sqrt(
        ((mean_m[head] - mean_m[head].mean(0)) ** 2).sum() / ((base_m[head] - base_m[head].mean(0)) ** 2).sum()
    )
    raw = {n: scale * cage.build(source.target(f"{UNITS}/{n}.target")) for n in ARKIT}
    eyes = np.isin(cage.vertex_part, [1, 2])
    out = {}
    for name in ARKIT:
        offsets = (raw[name] + _mirrored(raw[_swap_side(name)], cage.mirror)) / 2
        offsets[eyes] = 0.0
        teeth = cage.part("teeth_lower")
        offsets[teeth] = _rigid(base_m[teeth] * scale, offsets[teeth], mean_m[teeth])
        if name.startswith("eyeLook"):
            word = name.removeprefix("eyeLook").removesuffix("Left").removesuffix("Right")
            side = "eye_left" if name.endswith("Left") else "eye_right"
            offsets += _gaze(cage, mean_m, side, word)
        out[name] = offsets
    return out


def tongue_moves(cage: Cage, mean_m: FloatArray) -> dict[str, FloatArray]:
    """Return three tongue moves that ARKit lacks: tip up, back up, curled; (V, 3) offsets in metres."""
    rows = cage.part("tongue")
    z = mean_m[rows, 2]
    along = (z - z.min()) / np.ptp(z)  # 0 at the root, 1 at the tip
    moves = {}
    for name, lift, pull in (
        ("tongueTipUp", 0.009 * np.clip(along - 0.35, 0, 1) / 0.65, 0.0),
        ("tongueBackUp", 0.009 * np.exp(-(((along - 0.3) / 0.25) ** 2)), 0.003),
        ("tongueCurl", 0.008 * np.clip(along - 0.5, 0, 1) / 0.5, 0.008),
    ):
        out = np.zeros_like(mean_m)
        out[rows, 1] = lift
        out[rows, 2] = -pull * along
        moves[name] = out
    return moves


def visemes(units: dict[str, FloatArray]) -> dict[str, FloatArray]:
    """Return the 15 mouth shapes as (V, 3) offsets, mixtures of face units and tongue moves."""
    some = next(iter(units.values()))
    out = {}
    for name, mix in VISEMES.items():
        total = np.zeros_like(some)
        for unit, weight in mix.items():
            for part in [unit[:-1] + "Left", unit[:-1] + "Right"] if unit.endswith("+") else [unit]:
                total += weight * units[part]
        out[name] = total
    return out


def sparse_pack(units: dict[str, FloatArray]) -> tuple[IntArray, IntArray, FloatArray]:
    """Return (start (K+1,), vertex (N,), offset (N, 3)) of stacked units."""
    start, index, delta = [0], [], []
    for offsets in units.values():
        rows = np.flatnonzero(np.linalg.norm(offsets, axis=1) > SMALLEST_M)
        index.append(rows)
        delta.append(offsets[rows])
        start.append(start[-1] + rows.size)
    return (
        np.array(start, dtype=np.int32),
        np.concatenate(index).astype(np.int32),
        np.concatenate(delta).astype(np.float16),
    )
