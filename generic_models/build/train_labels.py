"""Teach the label decoder: ``python generic_models/build/train_labels.py WORK --minutes 60`` after ``label_crops.py``.

Wants torch (not a dependency of the product); writes ``cloner_models/label_net.npz``, which
``cloner.labels.decoder`` computes with numpy and OpenCV. The pose and selfie nets stay as their makers taught them: of
features learned here alone painted people taught clothes on plain walls of real photographs. The committed arrays were
taught for 42 minutes without the people of `APART` (mean IoU of 11 classes on them .773 at 256 px), then for 18 with
everyone (``--everyone --onward``).

Rare and easily missed classes weigh more; half of the loss is an overlap (soft IoU), as small classes vanish in a
mean over pixels. People who wear the assets in `APART` are kept out and told separately.
"""

from __future__ import annotations

import argparse
import json
import time
from pathlib import Path

import numpy as np
import torch
import torch.nn.functional as F
from numpy.typing import NDArray
from torch import Tensor, nn

#: Sides and channels of the features, in the order of ``litert.label_features``.
SHAPES = (
    (128, 8), (64, 32), (32, 56), (16, 160), (64, 48), (128, 8), (64, 16), (32, 24), (16, 32), (256, 1), (256, 1),
)  # fmt: skip
OFFSETS = np.cumsum([0] + [side * side * channels for side, channels in SHAPES])
CLASSES = 11
#: Weight of each class in the cross-entropy (taste, after looking at what was missed).
WEIGHTS = (1.0, 1.5, 1.3, 1.8, 1.1, 1.3, 1.5, 2.5, 2.0, 1.3, 2.2)
#: Channels of the decoder at sides 16, 32, 64, 128, 256.
WIDTHS = (96, 64, 56, 40, 24)
#: Side of the windows that teach, of 256: the features see the whole crop anyway, and a quarter costs a quarter.
WINDOW, BATCH, RATE = 128, 16, 3e-3
APART = {"male_casualsuit03", "female_sportsuit01", "ponytail01", "short03"}
OUT = Path(__file__).resolve().parent.parent / "cloner_models" / "label_net.npz"


class Separable(nn.Module):
    """A residual block: each plane filtered by itself, then all mixed."""

    def __init__(self, channels: int, size: int) -> None:
        super().__init__()
        self.dw = nn.Conv2d(channels, channels, size, padding=size // 2, groups=channels)
        self.pw = nn.Conv2d(channels, channels, 1)

    def forward(self, x: Tensor) -> Tensor:
        return x + self.pw(F.relu(self.dw(x)))


class Decoder(nn.Module):
    """What ``cloner.labels.decoder`` computes; its names of arrays are the names of modules here."""

    def __init__(self, means: list[NDArray[np.float32]], scales: list[NDArray[np.float32]]) -> None:
        super().__init__()
        for k, (mean, scale) in enumerate(zip(means, scales, strict=True)):
            self.register_buffer(f"m{k}", torch.tensor(mean).view(1, -1, 1, 1))
            self.register_buffer(f"d{k}", torch.tensor(scale).view(1, -1, 1, 1))
        inputs = (192, 80 + WIDTHS[0], 96 + WIDTHS[1], 28 + WIDTHS[2], 12 + WIDTHS[3])
        for side, entering, width in zip((16, 32, 64, 128, 256), inputs, WIDTHS, strict=True):
            setattr(self, f"i{side}", nn.Conv2d(entering, width, 1))
            blocks = 1 if side == 256 else 2
            setattr(self, f"b{side}", nn.ModuleList([Separable(width, 5 if side < 64 else 3) for _ in range(blocks)]))
        self.r128 = nn.Conv2d(3, 12, 3, padding=1)
        self.r256 = nn.Conv2d(3, 10, 3, padding=1)
        self.o = nn.Conv2d(WIDTHS[4], CLASSES, 1)

    def forward(self, features: list[Tensor], rgb: Tensor) -> Tensor:
        known = [
            torch.clamp((x - getattr(self, f"m{k}")) * getattr(self, f"d{k}"), -6, 6) if k < 9 else x
            for k, x in enumerate(features)
        ]
        levels = {16: (3, 8), 32: (2, 7), 64: (1, 4, 6), 128: (0, 5), 256: (9, 10)}
        x: Tensor | None = None
        for side, entering in levels.items():
            joined = [known[k] for k in entering]
            if side >= 128:
                seen = rgb if side == 256 else F.avg_pool2d(rgb, 2)
                joined.append(F.relu(getattr(self, f"r{side}")(seen)))
            if x is not None:
                joined.append(F.interpolate(x, scale_factor=2, mode="bilinear", align_corners=False))
            x = F.relu(getattr(self, f"i{side}")(torch.cat(joined, 1)))
            for block in getattr(self, f"b{side}"):
                x = block(x)
        assert x is not None
        return self.o(x)


class Crops:
    """All crops on disk; features are mapped, the rest is held."""

    def __init__(self, work: Path, *, everyone: bool) -> None:
        self.features, self.rgb, self.labels, self.rows, self.apart = [], [], [], [], []
        for file in sorted((work / "crops").glob("*.npz")):
            kind, name = file.stem.split("_")
            person = json.loads((work / kind / name / "truth.json").read_text())["person"]
            own = {person["outfit"].get("suit", {}).get("name"), person["hair"].get("asset")}
            with np.load(file) as arrays:
                self.rgb.append(arrays["rgb"])
                self.labels.append(arrays["labels"])
            self.features.append(np.load(file.with_suffix(".npy"), mmap_mode="r"))
            rows = [(len(self.rgb) - 1, k) for k in range(len(self.rgb[-1]))]
            (self.apart if own & APART else self.rows).extend(rows)
        self.rows += self.apart if everyone else []

    def planes(self, row: tuple[int, int], box: tuple[slice, slice]) -> list[NDArray[np.float32]]:
        """Return the features of a crop in a window, channels first."""
        packed, found = self.features[row[0]][row[1]], []
        for k, (side, channels) in enumerate(SHAPES):
            step = 256 // side
            part = tuple(slice(s.start // step, s.stop // step) for s in box)
            plane = packed[OFFSETS[k] : OFFSETS[k + 1]].reshape(side, side, channels)[part]
            found.append(np.ascontiguousarray(plane.transpose(2, 0, 1), np.float32))
        return found

    def batch(
        self, rows: list[tuple[int, int]], boxes: list[tuple[slice, slice]]
    ) -> tuple[list[Tensor], Tensor, Tensor]:
        """Return features, rgb in -1..1 and labels of some crops' windows."""
        planes = [self.planes(row, box) for row, box in zip(rows, boxes, strict=True)]
        features = [torch.from_numpy(np.stack(each)) for each in zip(*planes, strict=True)]
        rgb = np.stack([self.rgb[i][k][box].transpose(2, 0, 1) for (i, k), box in zip(rows, boxes, strict=True)])
        labels = np.stack([self.labels[i][k][box] for (i, k), box in zip(rows, boxes, strict=True)])
        return (
            features,
            torch.from_numpy(rgb.astype(np.float32) / 127.5 - 1.0),
            torch.from_numpy(labels.astype(np.int64)),
        )

    def window(self, row: tuple[int, int], rng: np.random.Generator) -> tuple[slice, slice]:
        """Return a window, preferably one that shows some of the person."""
        for _ in range(3):
            top, left = (16 * int(v) for v in rng.integers((256 - WINDOW) // 16 + 1, size=2))
            box = (slice(top, top + WINDOW), slice(left, left + WINDOW))
            shown = self.labels[row[0]][row[1]][box]
            if ((shown > 0) & (shown < CLASSES)).mean() > 0.12:
                break
        return box


def loss_of(scores: Tensor, labels: Tensor) -> Tensor:
    """Return weighted cross-entropy and half the soft overlap's loss; 255 is no label."""
    known = (labels < CLASSES)[:, None]
    entropy = F.cross_entropy(
        scores, torch.where(labels < CLASSES, labels, -100), weight=torch.tensor(WEIGHTS), ignore_index=-100
    )
    shares = scores.softmax(1)
    true = F.one_hot(labels.clamp(max=CLASSES - 1), CLASSES).permute(0, 3, 1, 2) * known
    common = (shares * true).sum((0, 2, 3))
    either = ((shares + true) * known).sum((0, 2, 3)) - common
    present = true.sum((0, 2, 3)) > 30
    return entropy + 0.5 * (1.0 - (common + 1.0) / (either + 1.0))[present].mean()


def overlaps(net: Decoder, crops: Crops, rows: list[tuple[int, int]]) -> NDArray[np.float64]:
    """Return (11,) IoU of every class over whole crops."""
    counts = np.zeros((CLASSES, CLASSES), np.int64)
    whole = (slice(0, 256), slice(0, 256))
    with torch.no_grad():
        for row in rows:
            features, rgb, labels = crops.batch([row], [whole])
            found, true = net(features, rgb).argmax(1).ravel(), labels.ravel()
            pair = (true * CLASSES + found)[true < CLASSES].numpy()
            counts += np.bincount(pair, minlength=CLASSES**2).reshape(CLASSES, CLASSES)
    hit = np.diag(counts)
    return np.asarray(hit / np.maximum(counts.sum(0) + counts.sum(1) - hit, 1))


def train(crops: Crops, minutes: float, *, onward: bool) -> Decoder:
    """Return a decoder taught for some minutes of wall time, its rate falling as a cosine.

    ``onward`` goes on from the committed arrays at half the rate.
    """
    torch.manual_seed(0)
    rng = np.random.default_rng(int(onward))
    net = Decoder(*statistics(crops, rng)).to(memory_format=torch.channels_last)
    if onward:
        load_arrays(net)
    highest = RATE / 2 if onward else RATE
    optimiser = torch.optim.AdamW(net.parameters(), lr=highest, weight_decay=1e-3)
    start, step = time.monotonic(), 0
    while (share := (time.monotonic() - start) / (60.0 * minutes)) < 1.0:
        for group in optimiser.param_groups:
            group["lr"] = highest * min(1.0, step / 100) * (0.02 + 0.49 * (1.0 + np.cos(np.pi * share)))
        rows = [crops.rows[k] for k in rng.integers(len(crops.rows), size=BATCH)]
        features, rgb, labels = crops.batch(rows, [crops.window(row, rng) for row in rows])
        with torch.autocast("cpu", dtype=torch.bfloat16):
            scores = net(features, rgb.contiguous(memory_format=torch.channels_last))
        loss = loss_of(scores.float(), labels)
        optimiser.zero_grad()
        loss.backward()
        torch.nn.utils.clip_grad_norm_(net.parameters(), 5.0)
        optimiser.step()
        step += 1
        if step % 200 == 0:
            print(f"step {step}, {100 * share:.0f} % of the time, loss {loss.item():.3f}", flush=True)
    return net


def statistics(crops: Crops, rng: np.random.Generator) -> tuple[list[NDArray[np.float32]], list[NDArray[np.float32]]]:
    """Return mean and 1 / deviation of every channel that is no mask, from 300 crops."""
    whole = (slice(0, 256), slice(0, 256))
    some = [crops.rows[k] for k in rng.choice(len(crops.rows), min(300, len(crops.rows)), replace=False)]
    planes = list(zip(*[crops.planes(row, whole) for row in some], strict=True))[:9]
    flat = [np.concatenate([plane.reshape(len(plane), -1)[:, ::7] for plane in each], axis=1) for each in planes]
    return [x.mean(axis=1) for x in flat], [1.0 / (x.std(axis=1) + 1e-3) for x in flat]


def load_arrays(net: Decoder) -> None:
    """Fill a decoder with the committed arrays."""
    with np.load(OUT) as arrays:
        state = {name: torch.tensor(arrays[name]).view(value.shape) for name, value in net.state_dict().items()}
    net.load_state_dict(state)


def arrays_of(net: Decoder) -> dict[str, NDArray[np.float32]]:
    """Return the arrays that the product reads: 1 x 1 convolutions as matrices, separable ones as a filter a plane."""
    found = {}
    for name, value in net.state_dict().items():
        array = value.float().numpy()
        if name[0] in "md" and name[1:].isdigit():
            array = array.ravel()
        elif array.ndim == 4 and array.shape[2:] == (1, 1):
            array = array[:, :, 0, 0]
        elif array.ndim == 4 and ".dw." in name:
            array = array[:, 0]
        found[name] = array.astype(np.float32)
    return found


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("work", type=Path)
    parser.add_argument("--minutes", type=float, default=60.0)
    parser.add_argument("--everyone", action="store_true", help="teach on the people kept apart, too")
    parser.add_argument("--onward", action="store_true", help="go on from the committed arrays")
    given = parser.parse_args()
    torch.set_num_threads(1)
    crops = Crops(given.work, everyone=given.everyone)
    net = train(crops, given.minutes, onward=given.onward).eval()
    told = overlaps(net, crops, crops.apart[::2])
    print("IoU on people apart:", np.round(told, 3), f"mean {told.mean():.3f}")
    np.savez(OUT, **arrays_of(net))


if __name__ == "__main__":
    main()
