"""The product's vertex set: hm08's body, our own eyeballs, teeth, tongue and lashes."""

from __future__ import annotations

import numpy as np
from source import BaseMesh, FloatArray, IntArray

PARTS = ("body", "eye_left", "eye_right", "teeth_upper", "teeth_lower", "tongue", "lashes_left", "lashes_right")
_HELPERS = {
    "teeth_upper": ("helper-upper-teeth",),
    "teeth_lower": ("helper-lower-teeth",),
    "tongue": ("helper-tongue",),
    "lashes_left": ("helper-l-eyelashes-1", "helper-l-eyelashes-2"),
    "lashes_right": ("helper-r-eyelashes-1", "helper-r-eyelashes-2"),
}
BODY_COUNT = 13380

# Polar angles of the eyeball's rings from the gaze axis, degrees. On a 15 mm ball 6.7 is a pupil of 3.5 mm and 23 the
# edge of an iris of 11.7 mm (anatomy); the others follow taste.
EYE_RINGS_DEG = (3.4, 6.7, 11.0, 15.0, 19.0, 23.0, 27.0, 33.0, 41.0, 50.0, 62.0, 76.0, 92.0, 110.0, 130.0, 152.0)
EYE_SECTORS = 24
PUPIL_RING, IRIS_RING = 1, 5
CORNEA_BULGE = 0.03  # of the radius, at the pole; taste, small enough to stay under the lids


def eyeball() -> tuple[FloatArray, FloatArray, IntArray, IntArray]:
    """Return a unit eyeball gazing along +Z.

    Returns
    -------
    points : (386, 3) front pole, then 16 rings of 24, then the back pole.
    uv : (T, 2) in [0, 1], one disc around (0.5, 0.5), front pole in its middle.
    quads, quad_uv : (Q, 4); pole triangles repeat their last index.
    """
    polar = np.radians(EYE_RINGS_DEG)
    # Mirror the sector layout left to right so that both eyes share one template.
    around = 2.0 * np.pi * (np.arange(EYE_SECTORS) + 0.5) / EYE_SECTORS
    bulge = 1.0 + CORNEA_BULGE * np.clip(np.cos(polar / polar[IRIS_RING] * np.pi / 2), 0.0, None) ** 2
    bulge[IRIS_RING:] = 1.0
    ring = np.stack(
        [
            np.outer(np.sin(polar) * bulge, np.cos(around)),
            np.outer(np.sin(polar) * bulge, np.sin(around)),
            np.repeat((np.cos(polar) * bulge)[:, None], EYE_SECTORS, axis=1),
        ],
        axis=-1,
    ).reshape(-1, 3)
    points = np.vstack([[0, 0, 1 + CORNEA_BULGE], ring, [0, 0, -1]])
    radius = np.sin(polar / 2)  # equal-area disc: keeps the iris large
    disc = np.stack([np.outer(radius, np.cos(around)), np.outer(radius, np.sin(around))], axis=-1).reshape(-1, 2)
    middle = around + np.pi / EYE_SECTORS
    back = np.column_stack([np.cos(middle), np.sin(middle)])
    uv = 0.5 + 0.5 * np.vstack([[0, 0], disc, back])
    quads, quad_uv = [], []
    last, count = len(EYE_RINGS_DEG) - 1, EYE_SECTORS
    for k in range(count):
        n = (k + 1) % count
        quads.append([0, 1 + k, 1 + n, 1 + n])
        quad_uv.append([0, 1 + k, 1 + n, 1 + n])
        for r in range(last):
            a, b = 1 + r * count, 1 + (r + 1) * count
            quads.append([a + k, b + k, b + n, a + n])
            quad_uv.append([a + k, b + k, b + n, a + n])
        a = 1 + last * count
        quads.append([a + k, points.shape[0] - 1, a + n, a + n])
        quad_uv.append([a + k, 1 + (last + 1) * count + k, a + n, a + n])
    return points, uv, np.array(quads), np.array(quad_uv)


# hm08's lips part by 1.5 mm and its lower teeth stand in the slit: smaller teeth, set back, leave a dark mouth line.
# Part: scale along (x, y, z) about the middle, in y about the lowest third (so that only the biting edge sinks).
_SHRINK = {"teeth_lower": (0.97, 0.65, 0.97), "teeth_upper": (0.98, 1.0, 0.98), "tongue": (0.97, 0.85, 0.97)}


class Cage:
    """Topology of the product mesh and the linear map from hm08's full vertices to it."""

    def __init__(self, base: BaseMesh, groups: dict[str, IntArray], twin: IntArray) -> None:
        self.base = base
        self.ball, ball_uv, ball_quads, ball_quad_uv = eyeball()
        self.eye_rows = {s: groups[f"helper-{s[0]}-eye"] for s in ("left", "right")}
        self.kept: dict[str, IntArray] = {"body": np.arange(BODY_COUNT)}
        for part, names in _HELPERS.items():
            self.kept[part] = np.sort(np.concatenate([groups[n] for n in names]))
        self.full_of_vertex = np.full(0, -1)  # -1 on eyeballs
        self._assemble(ball_uv, ball_quads, ball_quad_uv)
        self.mirror = self._mirror(twin)

    def _assemble(self, ball_uv: FloatArray, ball_quads: IntArray, ball_quad_uv: IntArray) -> None:
        full, parts, quads, quad_uv, quad_part = [], [], [], [], []
        uv = [self.base.uv]
        uv_count, start = self.base.uv.shape[0], 0
        inverse = np.full(self.base.vertices_m.shape[0], -1)
        for number, part in enumerate(PARTS):
            if part.startswith("eye_"):
                own = np.full(self.ball.shape[0], -1)
                quads.append(ball_quads + start)
                quad_uv.append(ball_quad_uv + uv_count)
                uv.append(ball_uv)
                uv_count += ball_uv.shape[0]
            else:
                own = self.kept[part]
                inverse[:] = -1
                inverse[own] = np.arange(own.size) + start
                inside = (inverse[self.base.quads] >= 0).all(axis=1)
                inside &= self.base.quad_group != "helper-hair"
                quads.append(inverse[self.base.quads[inside]])
                quad_uv.append(self.base.quad_uv[inside])
            full.append(own)
            parts.append(np.full(own.size, number))
            quad_part.append(np.full(quads[-1].shape[0], number))
            start += own.size
        self.full_of_vertex = np.concatenate(full)
        self.vertex_part = np.concatenate(parts)
        self.quads, self.quad_uv = np.vstack(quads), np.vstack(quad_uv)
        self.quad_part = np.concatenate(quad_part)
        used, self.quad_uv = np.unique(self.quad_uv, return_inverse=True)
        self.quad_uv = self.quad_uv.reshape(-1, 4)
        self.uv = np.vstack(uv)[used]

    def _mirror(self, twin: IntArray) -> IntArray:
        """Return each product vertex's twin, (V,)."""
        of_full = np.full(self.base.vertices_m.shape[0], -1)
        known = self.full_of_vertex >= 0
        of_full[self.full_of_vertex[known]] = np.flatnonzero(known)
        mirror = np.arange(self.full_of_vertex.size)
        mirror[known] = of_full[twin[self.full_of_vertex[known]]]
        flipped = self.ball * (-1, 1, 1)
        pair = np.linalg.norm(self.ball[None] - flipped[:, None], axis=-1).argmin(axis=1)
        for here, there in (("eye_left", "eye_right"), ("eye_right", "eye_left")):
            mirror[self.part(here)] = self.part(there)[pair]
        return mirror

    def part(self, name: str) -> IntArray:
        """Return the vertex indices of a part."""
        return np.flatnonzero(self.vertex_part == PARTS.index(name))

    def eye_centre(self, vertices_m: FloatArray, side: str) -> FloatArray:
        """Return an eyeball's centre of rotation (3,), between its poles; the vertices' mean lies too far forward."""
        rows = self.part(f"eye_{side}")
        front = 1.0 + CORNEA_BULGE
        return (vertices_m[rows[0]] + front * vertices_m[rows[-1]]) / (1.0 + front)

    def build(self, full_m: FloatArray) -> FloatArray:
        """Return product vertices (..., V, 3) from full hm08 vertices (..., 19158, 3); linear.

        Eyeballs are never bent: they follow the helper eye's centre and its size along its own rest shape.
        """
        out = np.empty((*full_m.shape[:-2], self.full_of_vertex.size, 3), dtype=full_m.dtype)
        known = self.full_of_vertex >= 0
        out[..., known, :] = full_m[..., self.full_of_vertex[known], :]
        for side, rows in self.eye_rows.items():
            rest = self.base.vertices_m[rows]
            spokes = rest - rest.mean(axis=0)
            radius = np.linalg.norm(spokes, axis=1).mean()
            centre = full_m[..., rows, :].mean(axis=-2)
            size = (full_m[..., rows, :] * spokes).sum(axis=(-2, -1)) / (spokes**2).sum()
            ball = (self.ball * radius).astype(full_m.dtype)
            out[..., self.part(f"eye_{side}"), :] = centre[..., None, :] + size[..., None, None] * ball
        for part, factors in _SHRINK.items():
            rows = self.part(part)
            rest_y = self.base.vertices_m[self.kept[part], 1]
            low = rows[rest_y < rest_y.min() + np.ptp(rest_y) / 3]
            anchor = out[..., rows, :].mean(axis=-2, keepdims=True)
            anchor[..., 1] = out[..., low, 1].mean(axis=-1, keepdims=True)
            out[..., rows, :] = anchor + (out[..., rows, :] - anchor) * np.array(factors, dtype=full_m.dtype)
        return out
