"""Teach the label decoder: ``python generic_models/build/train_labels.py WORK --minutes 60`` after ``label_crops.py``.

Wants torch (not a dependency of the product); writes ``cloner_models/label_net.npz``, which
``cloner.labels.decoder`` computes with numpy and OpenCV. The pose and selfie nets stay as their makers taught them: of
features learned here alone painted people taught clothes on plain walls of real photographs. The committed arrays were
taught by this script's first form (130d01d: windows of the crops, no mean of steps) for 42 minutes without the people
of `APART` (mean IoU of 11 classes on them .773 at 256 px), then for 18 with everyone (``--everyone --onward``).

Rare and easily missed classes weigh more; half of the loss is an overlap (soft IoU), as small classes vanish in a
mean over pixels. What is kept is the mean of the last steps' weights (Polyak). People who wear the assets in `APART`
are kept out unless ``--everyone`` is asked for, and told separately.
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
from torch.optim.swa_utils import AveragedModel, get_ema_multi_avg_fn

#: Sides and channels of the features, in the order of ``litert.label_features``.
SHAPES = (
    (128, 8), (64, 32), (32, 56), (16, 160), (64, 48), (128, 8), (64, 16), (32, 24), (16, 32), (256, 1), (256, 1),
)  # fmt: skip
OFFSETS = np.cumsum([0] + [side * side * channels for side, channels in SHAPES])
CLASSES = 11
#: Weight of each class in the cross-entropy (taste, after looking at what was missed).
WEIGHTS = (1.0, 1.5, 1.3, 1.8, 1.1, 1.3, 1.5, 2.5, 2.0, 1.3, 2.2)
#: Sides of the decoder; which features enter there (9 and 10 are masks); its channels and blocks.
LEVELS = {16: (3, 8), 32: (2, 7), 64: (1, 4, 6), 128: (0, 5), 256: (9, 10)}
WIDTHS, BLOCKS = (96, 64, 56, 40, 24), (2, 2, 2, 2, 1)
#: Crops a step, the highest rate, the memory of the mean over steps.
BATCH, RATE, MEMORY = 16, 1.5e-3, 0.995
#: Spread of the light that the decoder's own look at the picture is given, each channel alone.
LIGHT = 0.08
#: Share of the features' channels that a step leaves out.
DROPPED = 0.05
APART = {"male_casualsuit03", "female_sportsuit01", "ponytail01", "short03"}
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
        inputs = (192, 80 + WIDTHS[0], 96 + WIDTHS[1], 28 + WIDTHS[2], 12 + WIDTHS[3])
        for side, entering, width, blocks in zip(LEVELS, inputs, WIDTHS, BLOCKS, strict=True):
            setattr(self, f"i{side}", nn.Conv2d(entering, width, 1))
            setattr(self, f"b{side}", nn.ModuleList([Separable(width, 5 if side < 64 else 3) for _ in range(blocks)]))
        self.r128 = nn.Conv2d(3, 12, 3, padding=1)
        self.r256 = nn.Conv2d(3, 10, 3, padding=1)
        self.o = nn.Conv2d(WIDTHS[4], CLASSES, 1)

    def forward(self, features: list[Tensor], rgb: Tensor) -> Tensor:
        x: Tensor | None = None
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
        assert x is not None
        return self.o(x)

    def standardised(self, k: int, planes: Tensor) -> Tensor:
        """Return features in their own spread, as the product has them; masks as they are."""
        if k >= 9:
            return planes
        mean, scale = getattr(self, f"m{k}").to(planes.dtype), getattr(self, f"d{k}").to(planes.dtype)
        return torch.clamp((planes - mean) * scale, -6, 6)


class Crops:
    """All crops on disk; features are mapped (1.9 MB a crop), the rest is held."""

    def __init__(self, work: Path, device: str) -> None:
        self.features, self.rgb, self.labels, self.others, self.apart = [], [], [], [], []
        self.device = device
        for file in sorted((work / "crops").glob("*.npz")):
            kind, name = file.stem.split("_")
            person = json.loads((work / kind / name / "truth.json").read_text())["person"]
            own = {person["outfit"].get("suit", {}).get("name"), person["hair"].get("asset")}
            with np.load(file) as arrays:
                self.rgb.append(arrays["rgb"])
                self.labels.append(arrays["labels"])
            self.features.append(np.load(file.with_suffix(".npy"), mmap_mode="r"))
            rows = [(len(self.rgb) - 1, k) for k in range(len(self.rgb[-1]))]
            (self.apart if own & APART else self.others).extend(rows)

    def batch(self, rows: list[tuple[int, int]]) -> tuple[list[Tensor], Tensor, Tensor]:
        """Return features, rgb in -1..1 and labels of some crops; planes first."""
        packed = torch.from_numpy(np.stack([self.features[i][k] for i, k in rows])).to(self.device)
        planes = [
            packed[:, low:high].reshape(-1, side, side, channels).permute(0, 3, 1, 2).to(torch.bfloat16)
            for (side, channels), low, high in zip(SHAPES, OFFSETS[:-1], OFFSETS[1:], strict=True)
        ]
        rgb = torch.from_numpy(np.stack([self.rgb[i][k] for i, k in rows])).to(self.device).permute(0, 3, 1, 2)
        labels = torch.from_numpy(np.stack([self.labels[i][k] for i, k in rows])).to(self.device)
        return planes, rgb.float() / 127.5 - 1.0, labels.long()

    def scores(self, net: nn.Module, planes: list[Tensor], rgb: Tensor) -> Tensor:
        """Return a decoder's scores, its products in bfloat16."""
        with torch.autocast(self.device, dtype=torch.bfloat16):
            return net(planes, rgb).float()


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


def overlaps(net: nn.Module, crops: Crops, rows: list[tuple[int, int]]) -> NDArray[np.float64]:
    """Return (11,) IoU of every class over whole crops."""
    counts = np.zeros((CLASSES, CLASSES), np.int64)
    with torch.no_grad():
        for row in rows:
            planes, rgb, labels = crops.batch([row])
            found, true = crops.scores(net, planes, rgb).argmax(1).ravel(), labels.ravel()
            pair = (true * CLASSES + found)[true < CLASSES].cpu().numpy()
            counts += np.bincount(pair, minlength=CLASSES**2).reshape(CLASSES, CLASSES)
    hit = np.diag(counts)
    return np.asarray(hit / np.maximum(counts.sum(0) + counts.sum(1) - hit, 1))


def train(net: Decoder, crops: Crops, rows: list[tuple[int, int]], minutes: float) -> nn.Module:
    """Teach a decoder for some minutes, its rate falling as a cosine; return the mean of its last steps."""
    rng = np.random.default_rng(7)
    mean = AveragedModel(net, multi_avg_fn=get_ema_multi_avg_fn(MEMORY))
    optimiser = torch.optim.AdamW(net.parameters(), lr=RATE, weight_decay=1e-3)
    start, step, order, losses = time.monotonic(), 0, [], []
    while (share := (time.monotonic() - start) / (60.0 * minutes)) < 1.0:
        for group in optimiser.param_groups:
            group["lr"] = RATE * min(1.0, (step + 1) / 100) * (0.02 + 0.49 * (1.0 + np.cos(np.pi * share)))
        if len(order) < BATCH:
            order = list(rng.permutation(len(rows)))
        planes, rgb, labels = crops.batch([rows[order.pop()] for _ in range(BATCH)])
        light = torch.tensor(rng.normal(1.0, LIGHT, (BATCH, 3, 1, 1)), dtype=torch.float32, device=rgb.device)
        scores = crops.scores(net, planes, (rgb + 1.0) * light - 1.0)
        y, x = rng.integers(2, size=2)  # every second pixel judges: half of a step's time was the loss
        loss = loss_of(scores[:, :, y::2, x::2], labels[:, y::2, x::2])
        optimiser.zero_grad()
        loss.backward()
        nn.utils.clip_grad_norm_(net.parameters(), 5.0)
        optimiser.step()
        mean.update_parameters(net)
        step += 1
        losses.append(loss.item())
        if step % 100 == 0:
            print(f"step {step}, {100 * share:.0f} % of the time, loss {np.mean(losses[-100:]):.3f}", flush=True)
    return mean.module.eval()


def statistics(crops: Crops) -> tuple[list[NDArray[np.float32]], list[NDArray[np.float32]]]:
    """Return mean and 1 / deviation of every channel that is no mask, from up to 300 crops."""
    every = crops.others + crops.apart
    rows = np.random.default_rng(0).choice(len(every), min(300, len(every)), replace=False)
    planes, _, _ = crops.batch([every[row] for row in rows])
    flat = [x.float().permute(0, 2, 3, 1).flatten(0, 2)[::7] for x in planes[:9]]
    means, deviations = [x.mean(0).cpu().numpy() for x in flat], [x.std(0).cpu().numpy() for x in flat]
    return means, [1.0 / (x + 1e-3) for x in deviations]


def taught_before(file: Path) -> Decoder:
    """Return a decoder with the arrays of a file; blocks that it lacks add nothing yet."""
    with np.load(file) as arrays:
        net = Decoder([arrays[f"m{k}"] for k in range(9)], [arrays[f"d{k}"] for k in range(9)])
        for name, value in net.state_dict().items():
            if name in arrays or not name.startswith("b"):
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


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("work", type=Path)
    parser.add_argument("--minutes", type=float, default=60.0)
    parser.add_argument("--everyone", action="store_true", help="teach on the people apart too")
    parser.add_argument("--onward", type=Path, metavar="NET", help="go on from the arrays of this file")
    parser.add_argument("--out", type=Path, default=OUT)
    given = parser.parse_args()
    torch.manual_seed(0)
    device = "cuda" if torch.cuda.is_available() else "cpu"
    crops = Crops(given.work, device)
    rows = crops.others + (crops.apart if given.everyone else [])
    print(f"{len(rows)} crops teach, {len(crops.apart)} are apart", flush=True)
    net = taught_before(given.onward) if given.onward else Decoder(*statistics(crops))
    taught = train(net.to(device, memory_format=torch.channels_last), crops, rows, given.minutes)
    ious = overlaps(taught, crops, crops.apart[::2])
    print("IoU on people apart:", np.round(ious, 3), f"mean {ious.mean():.3f}", flush=True)
    np.savez(given.out, **arrays_of(taught))


if __name__ == "__main__":
    main()
