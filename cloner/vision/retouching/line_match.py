"""Dense registration of photos of one surface: smooth, limited displacements anchored at shared lines.

What two photos share are lines: where skin ends and hair or cloth begins, and stripes, prints, brows and folds. Light
is not shared. So pictures of lines are matched (:func:`line_pictures`), coarse to fine, by windowed least squares.

References
----------
B. Lucas and T. Kanade 1981, "An iterative image registration technique"; method notes section 9 (feature lines).
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Final

import cv2
import numpy as np
from numpy.typing import NDArray
from scipy.sparse import csr_array

from cloner.records.arrays import Array
from cloner.records.labels import SURFACE_OF, Label
from cloner.vision.photographs.blending import push_pull
from cloner.vision.retouching.aligning import sample

Image = NDArray[np.float32]

#: Places of ``SURFACES`` in a space of three axes, any two kinds at least sqrt(2) apart: skin against hair, upper
#: against lower clothes, shoes against accessories. The last row is what tells nothing.
_CODES: Final = np.array([[1, 0, 0], [-1, 0, 0], [0, 1, 0], [0, -1, 0], [0, 0, 1], [0, 0, -1], [0, 0, 0]], np.float32)
#: Logarithm by which plain skin and cloth vary after noise and JPEG: weaker structure is no evidence (measured on
#: cheeks of the sample visitors).
FLOOR: Final = 0.04
DARK_LEVELS: Final = 8.0  # added before the logarithm, so that noise in black is no structure
BACKGROUND_SIGMAS: Final = 4.0  # structure is what is finer than so many times the blur
WORK_SIGMAS: Final = 1.5  # a blur of so many pixels is enough to match at
SCALES: Final = (4.0, 2.0, 1.0)  # coarse to fine, of the finest blur
ROUNDS: Final = 2  # of least squares a scale
NODE_SHARE: Final = 2.0  # finest blurs between two nodes of a displacement
WINDOW_NODES: Final = 3.0  # standard deviation of the window within which a displacement hardly changes
AROUND_NODES: Final = 10  # three windows: beyond them nothing is displaced
SAMPLES: Final = 12.0  # independent looks in a window
STRUCTURE: Final = 0.7  # of brightness against borders of kinds: folds and shade are structure too
NOISE: Final = 0.5  # of matched lines against another photo of them, in units of a full border
OUTLIER: Final = 1.0  # a residual of a full border counts a quarter
FEW: Final = 0.05  # of a full window: fewer points tell less
LEAST_GAIN: Final = 0.2  # of the mismatch: a displacement that mends less is believed by so much less


@dataclass(frozen=True, slots=True)
class MatchScales:
    """Resolution of the registration, and its largest displacement, metres.

    Attributes
    ----------
    blur_m : float
        Finest blur.
    usual_m : float
        Standard deviation of what the fit is wrong by.
    most_m : float
        Farther displacements are wrong matches.
    """

    blur_m: float
    usual_m: float
    most_m: float


@dataclass(frozen=True, slots=True, eq=False)
class LinePicture:
    """Line features of a photo at one scale.

    Attributes
    ----------
    image : (h, w, 4) float32
        Where kinds border on each other, and structure of brightness.
    per_px : float
        Pixels of the image a photo pixel.
    """

    image: Image
    per_px: float

    def at(self, places_px: NDArray[np.floating]) -> Image:
        """Return the features (N, 4) at photo pixels (N, 2)."""
        return sample(self.image, (places_px + 0.5) * self.per_px - 0.5)


def line_pictures(
    rgb: NDArray[np.uint8],
    labels: NDArray[np.uint8],
    inside: NDArray[np.bool_],
    metres_per_pixel: float,
    reach: MatchScales,
) -> list[LinePicture]:
    """Return a photo's line features at all `SCALES`.

    Parameters
    ----------
    rgb : (H, W, 3), with the background painted over by the person's nearest colours
    labels : (H, W) of ``Label``
    inside : (H, W) the person; outlines are no lines of the surface
    metres_per_pixel : float
        Of a photo pixel.
    reach : Reach
    """
    finest = min(WORK_SIGMAS * metres_per_pixel / reach.blur_m, 1.0)
    own = np.where(inside, labels, np.uint8(Label.BACKGROUND))
    kind = SURFACE_OF[_downscaled(own, min(2.0 * finest, 1.0), cv2.INTER_NEAREST)]
    grey = cv2.cvtColor(rgb, cv2.COLOR_RGB2GRAY)
    known = (kind >= 0).astype(np.float32)
    code = _CODES.take(kind, axis=0, mode="wrap")  # nothing is the last row: zeros
    found = []
    for scale in SCALES[::-1]:
        per_px = min(finest / scale, 1.0)
        height, width = rgb.shape[:2]
        size = (max(round(width * per_px), 1), max(round(height * per_px), 1))
        grey, known, code = (cv2.resize(each, size, interpolation=cv2.INTER_AREA) for each in (grey, known, code))
        found.append(
            LinePicture(_line_features(grey, code, known, scale * reach.blur_m / metres_per_pixel * per_px), per_px)
        )
    return found[::-1]


def _downscaled(picture: NDArray[np.uint8], share: float, how: int) -> NDArray[np.uint8]:
    """Return a picture (H, W) at a share of its size."""
    size = (max(round(picture.shape[1] * share), 1), max(round(picture.shape[0] * share), 1))
    return np.asarray(cv2.resize(picture, size, interpolation=how), np.uint8)


def _line_features(grey: NDArray[np.uint8], code: Image, known: Image, sigma: float) -> Image:
    """Return line features (h, w, 4) of a small picture, blurred by sigma pixels."""
    wide = BACKGROUND_SIGMAS * sigma
    level = np.log(grey.astype(np.float32) + DARK_LEVELS)
    fine = cv2.GaussianBlur(level, (0, 0), sigma) - cv2.GaussianBlur(level, (0, 0), wide)
    contrast = np.sqrt(cv2.GaussianBlur(fine * fine, (0, 0), wide) + FLOOR**2)
    whole = push_pull(
        np.asarray(code / np.maximum(known, 1e-6)[..., None], np.float32), (known > 0.5).astype(np.float32)
    )
    return np.dstack([cv2.GaussianBlur(whole, (0, 0), sigma), STRUCTURE * fine / contrast])


@dataclass(frozen=True, slots=True, eq=False)
class SharedSamples:
    """The same surface points as two photos show them before registration.

    Attributes
    ----------
    moved_px, fixed_px : (N, 2)
        Places in the photo that is to be displaced and in the other one.
    weight : (N,) in 0..1
    """

    moved_px: NDArray[np.floating]
    fixed_px: NDArray[np.floating]
    weight: NDArray[np.floating]


@dataclass(frozen=True, slots=True, eq=False)
class Displacement:
    """A smooth displacement of a photo's lookups.

    Attributes
    ----------
    nodes : (h, w, 2) float32
        Photo pixels, right and down.
    corner_px : (2,)
        Place of the first node; around the outer ones nothing is displaced.
    step_px : float
        Between two nodes.
    """

    nodes: Image
    corner_px: Array
    step_px: float

    def at(self, places_px: NDArray[np.floating]) -> NDArray[np.float32]:
        """Return (N, 2) displacements at (N, 2) places, photo pixels."""
        return sample(self.nodes, (places_px - self.corner_px) / self.step_px)


def match_lines(
    moved: list[LinePicture],
    others: list[tuple[list[LinePicture], SharedSamples]],
    metres_per_pixel: float,
    reach: MatchScales,
) -> Displacement:
    """Return the displacement of a photo's lookups that brings its lines on to those of other photos.

    Parameters
    ----------
    moved : list of LinePicture
        Of the photo to be displaced.
    others : list of (list of LinePicture, Looked)
        Photos that stay, and what they share with it.
    metres_per_pixel : float
        Of a pixel of the moved photo.
    reach : Reach
    """
    places = np.concatenate([look.moved_px for _, look in others])
    weight = np.concatenate([look.weight for _, look in others])
    net = _NodeGrid.around(places, np.asarray(weight, np.float32), NODE_SHARE * reach.blur_m / metres_per_pixel)
    nodes = np.zeros((*net.shape, 2), np.float32)
    prior, most = (reach.usual_m / metres_per_pixel) ** -2, reach.most_m / metres_per_pixel
    for k, picture in enumerate(moved):
        goal = np.concatenate([pictures[k].at(look.fixed_px) for pictures, look in others])
        for _ in range(ROUNDS):
            nodes += _step(picture, goal, net, nodes, prior)
            size = np.linalg.norm(nodes, axis=2, keepdims=True)
            nodes *= np.minimum(1.0, most / np.maximum(size, 1e-9))
    return net.displacement(nodes * _improvement(picture, goal, net, nodes))


@dataclass(frozen=True, slots=True, eq=False)
class _NodeGrid:
    """Nodes around the samples at which two photos are compared.

    Attributes
    ----------
    places_px : (N, 2); weight : (N,)
    of_node : (h * w, N) sparse
        1 for every node's own places.
    shape : (int, int)
    corner_px : (2,) of the first node
    step_px : float
    """

    places_px: Array
    weight: Image
    of_node: csr_array
    shape: tuple[int, int]
    corner_px: Array
    step_px: float

    @classmethod
    def around(cls, places: NDArray[np.floating], weight: Image, step: float) -> _NodeGrid:
        """Return the grid with all windows in which samples (N, 2) have weight."""
        first = np.floor(places.min(axis=0) / step) - AROUND_NODES
        node = np.rint(places / step - first).astype(np.int64)
        width, height = node.max(axis=0) + AROUND_NODES + 1
        rows, count = node[:, 1] * width + node[:, 0], len(places)
        own = csr_array((np.ones(count, np.float32), (rows, np.arange(count))), shape=(height * width, count))
        return cls(np.asarray(places, np.float64), weight, own, (int(height), int(width)), first * step, step)

    def displacement(self, nodes: Image) -> Displacement:
        """Return the nodes' displacements (h, w, 2) as a field."""
        return Displacement(nodes, self.corner_px, self.step_px)

    def means(self, values: NDArray[np.floating], weight: Image) -> Image:
        """Return the weighted means (h, w, C) of values (N, C) in the window of every node."""
        table = np.column_stack([weight[:, None] * values, weight, np.ones_like(weight)]).astype(np.float32)
        sums = cv2.GaussianBlur((self.of_node @ table).reshape(*self.shape, -1), (0, 0), WINDOW_NODES)
        full = FEW * float(sums[..., -1].max())
        return np.asarray(sums[..., :-2] / (sums[..., -2:-1] + full + 1e-9), np.float32)


def _step(picture: LinePicture, goal: Image, net: _NodeGrid, nodes: Image, prior: float) -> Image:
    """Return the update (h, w, 2) of the nodes' displacements, photo pixels."""
    here = net.places_px + net.displacement(nodes).at(net.places_px)
    ahead = 1.0 / picture.per_px
    across, down = ((picture.at(here + way) - picture.at(here - way)) / (2.0 * ahead) for way in ahead * np.eye(2))
    rest = goal - picture.at(here)
    pairs = ((across, across), (across, down), (down, down), (across, rest), (down, rest))
    sums = np.stack([np.einsum("nc,nc->n", *pair) for pair in pairs], axis=1)
    trust = net.weight / (1.0 + np.einsum("nc,nc->n", rest, rest) / OUTLIER**2) ** 2
    xx, xy, yy, gx, gy = SAMPLES / NOISE**2 * np.moveaxis(net.means(sums, trust), 2, 0)
    gx, gy = gx - prior * nodes[..., 0], gy - prior * nodes[..., 1]
    xx, yy = xx + prior, yy + prior
    scale = 1.0 / (xx * yy - xy * xy)
    return np.asarray(np.dstack([scale * (yy * gx - xy * gy), scale * (xx * gy - xy * gx)]), np.float32)


def _improvement(picture: LinePicture, goal: Image, net: _NodeGrid, nodes: Image) -> Image:
    """Return the weight (h, w, 1) in 0..1 with which the displacement improves the match."""
    moved = net.places_px + net.displacement(nodes).at(net.places_px)
    gaps = [goal - picture.at(here) for here in (net.places_px, moved)]
    errors = np.stack([np.einsum("nc,nc->n", gap, gap) for gap in gaps], axis=1)
    before, after = np.moveaxis(net.means(errors, net.weight), 2, 0)
    gain = (before - after) / np.maximum(before, 1e-9)
    return np.asarray(cv2.GaussianBlur(np.clip(gain / LEAST_GAIN, 0.0, 1.0), (0, 0), WINDOW_NODES)[..., None])
