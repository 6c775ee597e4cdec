"""Teach the label decoder: ``python generic_models/build/train_labels.py WORK --minutes 60`` after ``label_crops.py``.

Wants torch (not a dependency of the product); writes ``cloner_models/label_net.npz``, which
``cloner.labels.decoder`` computes with numpy and OpenCV. The pose and selfie nets stay as their makers taught them: of
features learned here alone painted people taught clothes on plain walls of real photographs. The decoder is taught
three things at once: labels, joints and points under clothes, and parts of the naked body. The committed arrays: 637
people of the generator (12,740 crops, seeds from 20000), 7,600 steps in 3.7 minutes on one H200; on 33 people kept
apart, crops of 256 px: mean overlap of labels .820 and of parts .798, points 1.0 px away in the median. Then taught on
(``--onward``) for 42 and 24 minutes of two cores, 3,000 steps of 16 at rates 6e-4 and 5e-4, by 100 people with bare
shoulders (seeds from 60000) and 220 others (from 21000). Then for 36 minutes, some 2,550 steps at 5e-4, by 100 people
in tops of their skin's colour (from 70000), 90 with bare shoulders (60 of them from 60130) and 210 others (80 of them
from 22000); half of that was kept (``--halfway``). Then for 27 minutes, some 2,050 steps at 5e-4, by 110 people in
tight clothes (from 80000), 70 and 60 of the two kinds before and 140 others; half of that was kept too. Then for 25
minutes, 2,300 steps at 5e-4, by 120 people with covered heads (from 90000), 140 of the three kinds before and 120
others, and from the mean of before and after for 19 minutes, 2,050 steps at 4e-4, by 100 such, 215 of the kinds before
and 65 others; kept is the sum of six tenths of before and two of each.

On two cores set MALLOC_MMAP_THRESHOLD_=4294967296 and MALLOC_TRIM_THRESHOLD_=8589934592: half of the time went into
fetching the memory of every step from the system (0.4 -> 1.9 steps of 16 a second beside one other job).

Rare and easily missed classes weigh more; half of the loss is an overlap (soft IoU), as small classes vanish in a
mean over pixels. What is kept is the mean of the last steps' weights (Polyak).
"""

from __future__ import annotations

import argparse
import time
from pathlib import Path
from typing import NamedTuple

import numpy as np
import torch
import torch.nn.functional as F
from numpy.typing import NDArray
from torch import Tensor, nn
from torch.optim.swa_utils import AveragedModel, get_ema_multi_avg_fn

#: Sides and channels of the features, in the order of ``litert.label_features``.
SHAPES = (
    (128, 8), (64, 32), (32, 56), (16, 160), (64, 48), (128, 8), (64, 16), (32, 24), (16, 32), (256, 1), (256, 1),
)  # fmt: skip
OFFSETS = np.cumsum([0] + [side * side * channels for side, channels in SHAPES])
CLASSES = 11
PARTS, POINTS = 15, 21
#: Weight of each class in the cross-entropy (taste, after looking at what was missed).
WEIGHTS = (1.0, 1.5, 1.3, 1.8, 1.1, 1.3, 1.5, 2.5, 2.0, 1.3, 2.2)
#: Sides of the decoder; which features enter there (9 and 10 are masks); its channels and blocks.
LEVELS = {16: (3, 8), 32: (2, 7), 64: (1, 4, 6), 128: (0, 5), 256: (9, 10)}
WIDTHS, BLOCKS = (192, 128, 96, 48, 24), (3, 3, 3, 2, 1)
#: Side of the maps of points and of parts.
POINT_SIDE, PART_SIDE = 64, 128
#: What parts and points weigh beside the labels.
PART_WEIGHT, POINT_WEIGHT = 0.5, 0.1
#: Crops a step, the highest rate, the memory of the mean over steps.
BATCH, RATE, MEMORY = 32, 2e-3, 0.998
#: Spread of the light that the decoder's own look at the picture is given, each channel alone.
LIGHT = 0.08
#: Share of the features' channels that a step leaves out.
DROPPED = 0.1
#: People with the last seeds do not teach, they are told separately: one in so many.
APART = 20
OUT = Path(__file__).resolve().parent.parent / "cloner_models" / "label_net.npz"


class Separable(nn.Module):
    """A residual block: each plane filtered by itself, then all mixed. A new one adds nothing."""

    def __init__(self, channels: int, size: int) -> None:
        super().__init__()
        self.dw = nn.Conv2d(channels, channels, size, padding=size // 2, groups=channels)
        self.pw = nn.Conv2d(channels, channels, 1)
        nn.init.zeros_(self.pw.weight)
        nn.init.zeros_(self.pw.bias)

    def forward(self, x: Tensor) -> Tensor:
        return x + self.pw(F.relu(self.dw(x)))


class Decoder(nn.Module):
    """What ``cloner.labels.decoder`` computes; its names of arrays are the names of modules here."""

    def __init__(self, means: list[NDArray[np.float32]], scales: list[NDArray[np.float32]]) -> None:
        super().__init__()
        for k, (mean, scale) in enumerate(zip(means, scales, strict=True)):
            self.register_buffer(f"m{k}", torch.tensor(mean).view(1, -1, 1, 1))
            self.register_buffer(f"d{k}", torch.tensor(scale).view(1, -1, 1, 1))
        own = (192, 80, 96, 28, 12)
        inputs = [n + before for n, before in zip(own, (0, *WIDTHS[:-1]), strict=True)]
        for side, entering, width, blocks in zip(LEVELS, inputs, WIDTHS, BLOCKS, strict=True):
            setattr(self, f"i{side}", nn.Conv2d(entering, width, 1))
            setattr(self, f"b{side}", nn.ModuleList([Separable(width, 5 if side < 64 else 3) for _ in range(blocks)]))
        self.r128 = nn.Conv2d(3, 12, 3, padding=1)
        self.r256 = nn.Conv2d(3, 10, 3, padding=1)
        self.p64 = nn.Conv2d(WIDTHS[2], POINTS, 1)
        self.p128 = nn.Conv2d(WIDTHS[3], PARTS, 1)
        self.o = nn.Conv2d(WIDTHS[4], CLASSES, 1)

    def forward(self, features: list[Tensor], rgb: Tensor) -> tuple[Tensor, Tensor, Tensor]:
        """Return the scores of classes (256 px a side), parts (128) and points (64)."""
        x: Tensor | None = None
        others = {}
        for side, entering in LEVELS.items():
            joined = [F.dropout2d(self.standardised(k, features[k]), DROPPED, self.training) for k in entering]
            if side >= 128:
                seen = rgb if side == 256 else F.avg_pool2d(rgb, 2)
                joined.append(F.relu(getattr(self, f"r{side}")(seen)))
            mixing, new = getattr(self, f"i{side}"), torch.cat(joined, 1)
            mixed = F.conv2d(new, mixing.weight[:, : new.shape[1]], mixing.bias)
            if x is not None:  # mixed before it is enlarged: the same, for a quarter of the work
                coarse = F.conv2d(x, mixing.weight[:, new.shape[1] :])
                mixed = mixed + F.interpolate(coarse, scale_factor=2, mode="bilinear", align_corners=False)
            x = F.relu(mixed)
            for block in getattr(self, f"b{side}"):
                x = block(x)
            if side in (POINT_SIDE, PART_SIDE):
                others[side] = getattr(self, f"p{side}")(x)
        assert x is not None
        return self.o(x), others[PART_SIDE], others[POINT_SIDE]

    def standardised(self, k: int, planes: Tensor) -> Tensor:
        """Return features in their own spread, as the product has them; masks as they are."""
        if k >= 9:
            return planes
        mean, scale = getattr(self, f"m{k}").to(planes.dtype), getattr(self, f"d{k}").to(planes.dtype)
        return torch.clamp((planes - mean) * scale, -6, 6)


class Truths(NamedTuple):
    """What crops show: labels (N, 256, 256), parts (N, 128, 128), points (N, P, 2) in px of the crop."""

    labels: Tensor
    parts: Tensor
    points: Tensor


class Crops:
    """All crops of a folder, held where the decoder is taught (1.9 MB a crop)."""

    def __init__(self, work: Path, device: str) -> None:
        files = sorted((work / "crops").glob("p?????.npz"))
        begun = np.load(files[0].with_suffix(".npy"), mmap_mode="r")
        self.device, each = device, len(begun)
        self.features = torch.empty((each * len(files), begun.shape[1]), dtype=torch.float16, device=device)
        rows: dict[str, list[NDArray[np.generic]]] = {name: [] for name in ("rgb", "labels", "parts", "points")}
        for number, file in enumerate(files):
            own = torch.from_numpy(np.load(file.with_suffix(".npy")))
            self.features[number * each : (number + 1) * each] = own.to(device)
            with np.load(file) as arrays:
                for name, kept in rows.items():
                    kept.append(arrays[name])
        held = {name: torch.from_numpy(np.concatenate(kept)).to(device) for name, kept in rows.items()}
        self.rgb, self.labels, self.parts, self.points = held.values()
        apart = each * max(1, len(files) // APART)
        self.rows = np.arange(len(self.features))
        self.others, self.apart = self.rows[:-apart], self.rows[-apart:]

    def batch(self, rows: NDArray[np.int64]) -> tuple[list[Tensor], Tensor, Truths]:
        """Return features, rgb in -1..1 and the truth of some crops; planes first."""
        chosen = torch.from_numpy(rows).to(self.device)
        packed = self.features[chosen]
        planes = [
            packed[:, low:high].reshape(-1, side, side, channels).permute(0, 3, 1, 2).to(torch.bfloat16)
            for (side, channels), low, high in zip(SHAPES, OFFSETS[:-1], OFFSETS[1:], strict=True)
        ]
        rgb = self.rgb[chosen].permute(0, 3, 1, 2).float() / 127.5 - 1.0
        truths = Truths(self.labels[chosen].long(), self.parts[chosen].long(), self.points[chosen].float())
        return planes, rgb, truths

    def scores(self, net: nn.Module, planes: list[Tensor], rgb: Tensor) -> tuple[Tensor, Tensor, Tensor]:
        """Return a decoder's scores, its products in bfloat16."""
        with torch.autocast(self.device, dtype=torch.bfloat16):
            labels, parts, points = net(planes, rgb)
        return labels.float(), parts.float(), points.float()


def loss_of(scores: Tensor, labels: Tensor) -> Tensor:
    """Return weighted cross-entropy and half the soft overlap's loss; 255 is no label."""
    known = (labels < CLASSES)[:, None]
    weight = torch.tensor(WEIGHTS, device=scores.device)
    entropy = F.cross_entropy(scores, torch.where(labels < CLASSES, labels, -100), weight=weight, ignore_index=-100)
    shares = scores.softmax(1)
    true = F.one_hot(labels.clamp(max=CLASSES - 1), CLASSES).permute(0, 3, 1, 2) * known
    common = (shares * true).sum((0, 2, 3))
    either = ((shares + true) * known).sum((0, 2, 3)) - common
    present = true.sum((0, 2, 3)) > 30
    return entropy + 0.5 * (1.0 - (common + 1.0) / (either + 1.0))[present].mean()


def point_loss(scores: Tensor, points: Tensor) -> Tensor:
    """Return the cross-entropy of where points lie; a point between cells belongs to its four neighbours."""
    side = scores.shape[-1]
    place = (points + 0.5) * (side / 256.0) - 0.5
    known = torch.isfinite(place).all(-1) & (place > 0.0).all(-1) & (place < side - 1.0).all(-1)
    place = place[known]
    logs = scores.flatten(2).log_softmax(-1)[known]
    low = place.floor()
    share = place - low
    low = low.long()
    loss = torch.zeros((), device=scores.device)
    for down in (0, 1):
        for across in (0, 1):
            weight = (share[:, 0] if across else 1.0 - share[:, 0]) * (share[:, 1] if down else 1.0 - share[:, 1])
            cell = (low[:, 1] + down) * side + low[:, 0] + across
            loss = loss - (weight * logs.gather(1, cell[:, None])[:, 0]).sum()
    return loss / max(1, int(known.sum()))


def places_of(scores: Tensor) -> Tensor:
    """Return (N, P, 2) where points lie, px of the crop: the mean of the likeliest cell's neighbourhood."""
    side = scores.shape[-1]
    shares = scores.flatten(2).softmax(-1)
    best = shares.argmax(-1)
    grid = torch.arange(side, device=scores.device)
    near = ((grid - (best % side)[..., None]).abs() <= 2)[:, :, None, :]
    near = near & ((grid - (best // side)[..., None]).abs() <= 2)[:, :, :, None]
    kept = shares.unflatten(2, (side, side)) * near
    kept = kept / kept.sum((2, 3), keepdim=True)
    place = torch.stack([(kept.sum(2) * grid).sum(-1), (kept.sum(3) * grid).sum(-1)], -1)
    return (place + 0.5) * (256.0 / side) - 0.5


def overlap(true: Tensor, found: Tensor, classes: int) -> NDArray[np.int64]:
    """Return how often each class (row) was found as each (column)."""
    known = true < classes
    pair = (true[known] * classes + found[known]).flatten()
    return torch.bincount(pair, minlength=classes**2).reshape(classes, classes).cpu().numpy()


def tell(net: nn.Module, crops: Crops, rows: NDArray[np.int64]) -> None:
    """Print the overlap of classes and parts, and how far points lie, over whole crops."""
    labels, parts, away = np.zeros((CLASSES, CLASSES), np.int64), np.zeros((PARTS, PARTS), np.int64), []
    with torch.no_grad():
        for begin in range(0, len(rows), 20):
            planes, rgb, truths = crops.batch(rows[begin : begin + 20])
            scores = crops.scores(net, planes, rgb)
            labels += overlap(truths.labels, scores[0].argmax(1), CLASSES)
            parts += overlap(truths.parts, scores[1].argmax(1), PARTS)
            away.append(torch.linalg.vector_norm(places_of(scores[2]) - truths.points, dim=-1).cpu().numpy())
    for name, counts in (("labels", labels), ("parts", parts)):
        hit = np.diag(counts)
        ious = hit / np.maximum(counts.sum(0) + counts.sum(1) - hit, 1)
        print(f"IoU of {name}:", np.round(ious, 3), f"mean {ious.mean():.4f}", flush=True)
    far = np.concatenate(away)
    print("points away, px, median:", np.round(np.nanmedian(far, axis=0), 2), f"mean {np.nanmean(far):.2f}", flush=True)


def train(net: Decoder, crops: Crops, rows: NDArray[np.int64], minutes: float, rate: float, batch: int) -> nn.Module:
    """Teach a decoder for some minutes, its rate falling as a cosine; return the mean of its last steps."""
    rng = np.random.default_rng(7)
    mean = AveragedModel(net, multi_avg_fn=get_ema_multi_avg_fn(MEMORY))
    optimiser = torch.optim.AdamW(net.parameters(), lr=rate, weight_decay=1e-3)
    start, step, order, losses = time.monotonic(), 0, np.empty(0, np.int64), []
    while (share := (time.monotonic() - start) / (60.0 * minutes)) < 1.0:
        for group in optimiser.param_groups:
            group["lr"] = rate * min(1.0, (step + 1) / 100) * (0.02 + 0.49 * (1.0 + np.cos(np.pi * share)))
        if len(order) < batch:
            order = rng.permutation(rows)
        chosen, order = order[:batch], order[batch:]
        planes, rgb, truths = crops.batch(chosen)
        light = torch.tensor(rng.normal(1.0, LIGHT, (len(chosen), 3, 1, 1)), dtype=torch.float32, device=rgb.device)
        labels, parts, points = crops.scores(net, planes, (rgb + 1.0) * light - 1.0)
        y, x = rng.integers(2, size=2)  # every second pixel judges: half of a step's time was the loss
        shown = F.cross_entropy(parts[:, :, y::2, x::2], truths.parts[:, y::2, x::2])
        loss = loss_of(labels[:, :, y::2, x::2], truths.labels[:, y::2, x::2])
        loss = loss + PART_WEIGHT * shown + POINT_WEIGHT * point_loss(points, truths.points)
        optimiser.zero_grad()
        loss.backward()
        nn.utils.clip_grad_norm_(net.parameters(), 5.0)
        optimiser.step()
        mean.update_parameters(net)
        step += 1
        losses.append(loss.detach())
        if step % 200 == 0:
            told = torch.stack(losses[-200:]).mean().item()
            print(f"step {step}, {100 * share:.0f} % of the time, loss {told:.3f}", flush=True)
    return mean.module.eval()


def statistics(crops: Crops) -> tuple[list[NDArray[np.float32]], list[NDArray[np.float32]]]:
    """Return mean and 1 / deviation of every channel that is no mask, from up to 300 crops."""
    rows = np.random.default_rng(0).choice(crops.rows, min(300, len(crops.rows)), replace=False)
    planes, _, _ = crops.batch(rows)
    flat = [x.float().permute(0, 2, 3, 1).flatten(0, 2)[::7] for x in planes[:9]]
    means, deviations = [x.mean(0).cpu().numpy() for x in flat], [x.std(0).cpu().numpy() for x in flat]
    return means, [1.0 / (x + 1e-3) for x in deviations]


def taught_before(file: Path) -> Decoder:
    """Return a decoder with the arrays of a file; blocks that it lacks add nothing yet."""
    with np.load(file) as arrays:
        net = Decoder([arrays[f"m{k}"] for k in range(9)], [arrays[f"d{k}"] for k in range(9)])
        for name, value in net.state_dict().items():
            if name in arrays:
                value.copy_(torch.from_numpy(arrays[name]).reshape(value.shape))
    return net


def arrays_of(net: nn.Module) -> dict[str, NDArray[np.float32]]:
    """Return the arrays that the product reads: 1 x 1 convolutions as matrices, separable ones as a filter a plane."""
    found = {}
    for name, value in net.state_dict().items():
        array = value.float().cpu().numpy()
        if name[0] in "md" and name[1:].isdigit():
            array = array.ravel()
        elif array.ndim == 4 and array.shape[2:] == (1, 1):
            array = array[:, :, 0, 0]
        elif array.ndim == 4 and ".dw." in name:
            array = array[:, 0]
        found[name] = array.astype(np.float32)
    return found


def halfway(before: Path, taught: dict[str, NDArray[np.float32]]) -> dict[str, NDArray[np.float32]]:
    """Return the mean of a file's arrays and of what was taught on from them; what the file lacks stays as taught.

    It keeps more of what was learned before than it loses of what is new (Wortsman et al., Robust fine-tuning, 2022).
    """
    with np.load(before) as old:
        return {name: (array + old[name]) / 2 if name in old else array for name, array in taught.items()}


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("work", type=Path)
    parser.add_argument("--minutes", type=float, default=60.0)
    parser.add_argument("--everyone", action="store_true", help="teach on the people apart too")
    parser.add_argument("--onward", type=Path, metavar="NET", help="go on from the arrays of this file")
    parser.add_argument("--halfway", action="store_true", help="with --onward: keep the mean of before and after")
    parser.add_argument("--rate", type=float, default=RATE, help="the highest")
    parser.add_argument("--batch", type=int, default=BATCH, help="crops a step")
    parser.add_argument("--out", type=Path, default=OUT)
    given = parser.parse_args()
    torch.manual_seed(0)
    device = "cuda" if torch.cuda.is_available() else "cpu"
    crops = Crops(given.work, device)
    rows = crops.rows if given.everyone else crops.others
    print(f"{len(rows)} crops teach, {len(crops.apart)} are apart", flush=True)
    net = taught_before(given.onward) if given.onward else Decoder(*statistics(crops))
    net = net.to(device, memory_format=torch.channels_last)
    taught = train(net, crops, rows, given.minutes, given.rate, given.batch)
    tell(taught, crops, crops.apart)
    arrays = arrays_of(taught)
    np.savez_compressed(given.out, **(halfway(given.onward, arrays) if given.halfway else arrays))


if __name__ == "__main__":
    main()
