"""MPEG-4 facial definition points (FDP) on the generic head."""

from __future__ import annotations

import numpy as np
import skin_map
from cage import Cage
from names import Figure
from source import FloatArray, IntArray

# Points that are hm08 vertices already named for features or by the rig's brow bones.
_MIDDLE = {
    "2.1": 5296,
    "2.2": 474,
    "2.3": 493,
    "2.10": 5162,
    "8.1": 455,
    "8.2": 492,
    "9.3": 297,
    "9.15": 343,
    "11.4": 881,
}
_LEFT = {
    "3.1": 7774,
    "3.7": 7755,
    "3.11": 7796,
    "4.1": 7006,
    "4.3": 6996,
    "4.5": 6986,
    "8.3": 7129,
    "9.1": 11669,
    "10.1": 12012,
    "10.3": 12018,
    "10.5": 12329,
}
# The right twin of a left point; MPEG-4 does not number sides alike everywhere.
_TWIN = {
    "2.4": "2.5",
    "2.6": "2.7",
    "2.8": "2.9",
    "2.11": "2.12",
    "2.13": "2.14",
    "3.1": "3.2",
    "3.3": "3.4",
    "3.5": "3.6",
    "3.7": "3.12",
    "3.9": "3.10",
    "3.11": "3.8",
    "3.13": "3.14",
    "4.1": "4.2",
    "4.3": "4.4",
    "4.5": "4.6",
    "5.1": "5.2",
    "5.3": "5.4",
    "6.3": "6.4",
    "8.3": "8.4",
    "8.5": "8.6",
    "8.7": "8.8",
    "8.10": "8.9",
    "9.1": "9.2",
    "9.5": "9.4",
    "9.7": "9.6",
    "9.13": "9.14",
    "10.1": "10.2",
    "10.3": "10.4",
    "10.5": "10.6",
    "10.7": "10.8",
    "10.9": "10.10",
    "11.3": "11.2",
}


class _Picker:
    def __init__(self, figure: Figure, head: IntArray) -> None:
        self.v, self.head = figure.vertices_m, head

    def front(self, x: float, y: float, near_z: float = 0.05) -> int:
        """Return the front-most head vertex near a place seen from the front."""
        rows = self.head[self.v[self.head, 2] > near_z]
        away = np.hypot(self.v[rows, 0] - x, self.v[rows, 1] - y) - 0.15 * self.v[rows, 2]
        return int(rows[np.argmin(away)])

    def side(self, y: float, z: float) -> int:
        """Return the left head vertex near a place seen from the side, outermost first."""
        rows = self.head[self.v[self.head, 0] > 0.03]
        away = np.hypot(self.v[rows, 1] - y, self.v[rows, 2] - z) - 0.1 * self.v[rows, 0]
        return int(rows[np.argmin(away)])

    def nearest_x(self, rows: IntArray, x: float) -> int:
        return int(rows[np.argmin(np.abs(self.v[rows, 0] - x))])

    def most(self, rows: IntArray, direction: tuple[float, float, float]) -> int:
        return int(rows[np.argmax(self.v[rows] @ np.array(direction))])


def _mouth_points(pick: _Picker, ring: IntArray) -> dict[str, int]:
    v = pick.v
    out: dict[str, int] = {}
    for number, upper, lower in ((skin_map.INNER_LIP_RING, "2.6", "2.8"), (skin_map.LIP_RINGS, "8.5", "8.7")):
        loop = np.flatnonzero((ring == number) & (v[:, 0] > 1e-4))
        corner = pick.most(loop, (1, 0, 0))
        above = _upper(v, loop, corner)
        out[upper] = pick.nearest_x(loop[above], v[corner, 0] / 2)
        out[lower] = pick.nearest_x(loop[~above], v[corner, 0] / 2)
        if upper == "2.6":
            out["2.4"] = corner
        else:
            bow = loop[above & (v[loop, 0] < 0.014)]
            out["8.10"] = pick.most(bow, (0, 1, 0))
    return out


def _upper(v: FloatArray, loop: IntArray, corner: int) -> np.ndarray:
    return v[loop, 1] > v[corner, 1] + 1e-5


def _eye_points(pick: _Picker, ring: IntArray) -> dict[str, int]:
    v = pick.v
    seam = np.flatnonzero(ring == 1)
    middle = (v[seam, 0].min() + v[seam, 0].max()) / 2
    out = {}
    for name, number, upper in (("3.3", 0, False), ("3.9", skin_map.LID_RINGS, False), ("3.13", 5, True)):
        loop = np.flatnonzero(ring == number)
        half = loop[(v[loop, 1] > v[loop, 1].mean()) == upper]
        out[name] = pick.nearest_x(half, middle)
    return out


def _part_points(pick: _Picker, cage: Cage) -> dict[str, int]:
    v = pick.v
    tongue, upper, lower = cage.part("tongue"), cage.part("teeth_upper"), cage.part("teeth_lower")
    middle = tongue[np.abs(v[tongue, 0]) < 1e-4]
    top = middle[v[middle, 1] > np.median(v[middle, 1])]
    half = (v[tongue, 2].min() + v[tongue, 2].max()) / 2
    out = {
        "6.1": pick.most(middle, (0, 0, 1)),
        "6.2": int(top[np.argmin(np.abs(v[top, 2] - half))]),
        "6.3": pick.most(tongue[np.abs(v[tongue, 2] - half) < 0.012], (1, 0, 0)),
        "3.5": int(cage.part("eye_left")[0]),
    }
    for rows, gum, edge, sign in ((upper, "9.8", "9.10", 1), (lower, "9.9", "9.11", -1)):
        front = rows[np.abs(v[rows, 0]) < np.abs(v[rows, 0]).min() + 1e-4]
        front = front[v[front, 2] > v[front, 2].max() - 0.01]
        out[gum], out[edge] = pick.most(front, (0, sign, 0)), pick.most(front, (0, -sign, 0))
    return out


def place(cage: Cage, figure: Figure, islands: dict[str, IntArray], masks: dict[str, np.ndarray]) -> dict[str, int]:
    """Return FDP number -> vertex, for every point that lies on a surface we have.

    Left out: 7.1 (a joint, ``skullbase``) and 11.5 (on the hair).
    """
    v = figure.vertices_m
    pick = _Picker(figure, np.setdiff1d(islands["head"], np.union1d(islands["mouth"], islands["socket_left"])))
    y = {k: v[i, 1] for k, i in _MIDDLE.items()}
    left = dict(_LEFT)
    left |= _mouth_points(pick, skin_map.mouth_rings(cage, islands))
    left |= _eye_points(pick, skin_map.eye_rings(cage, islands, "left"))
    middle = dict(_MIDDLE)
    for name, vertex in _part_points(pick, cage).items():
        (left if name in _TWIN else middle)[name] = vertex
    eye_x, nasion, lobe = v[7755, 0], v[132], v[12329]
    bump = pick.front(0.0, 0.55 * nasion[1] + 0.45 * y["9.3"])
    middle["9.12"] = bump
    left["2.11"] = pick.front(0.8 * v[7129, 0], y["2.10"])
    left["2.13"] = pick.side(y["8.2"] - 0.004, lobe[2] + 0.012)
    left["5.1"] = pick.front(0.95 * eye_x, (y["9.15"] + y["9.3"]) / 2)
    left["5.3"] = pick.front(1.3 * eye_x, 0.45 * v[7755, 1] + 0.55 * y["9.3"])
    left["9.5"] = pick.front(0.011, y["9.15"] + 0.004)
    left["9.7"] = pick.front(0.009, nasion[1] - 0.003)
    left["9.13"] = pick.front(0.011, v[bump, 1] - 0.004)
    ear = np.flatnonzero(masks["region_ear_left"])
    low, high = v[ear, 1].min(), v[ear, 1].max()
    left["10.7"] = pick.most(ear[v[ear, 1] < low + 0.25 * (high - low)], (-0.3, 0, 1))
    left["10.9"] = pick.most(ear[v[ear, 1] > low + 0.7 * (high - low)], (-0.5, 0, 1))
    sagittal = np.intersect1d(islands["head"], np.flatnonzero(np.abs(v[:, 0]) < 1e-5))
    forehead = sagittal[v[sagittal, 2] > 0.08]
    middle["11.1"] = int(forehead[np.argmin(np.abs(v[forehead, 1] - skin_map.HAIRLINE_Y[-1]))])
    middle["11.6"] = pick.most(sagittal, (0, 0, -1))
    left["11.3"] = pick.side(1.625, 0.083)
    out = dict(middle)
    for name, vertex in left.items():
        out[name], out[_TWIN[name]] = vertex, int(figure.mirror[vertex])
    return dict(sorted(out.items(), key=lambda item: tuple(int(n) for n in item[0].split("."))))
