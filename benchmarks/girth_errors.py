"""Error of every girth over the sample visitors, mm and in units of its own ±.

Give the folder of results that lie beside their truth by name: OUT/<visitor>-<set>/report.json, as
``cloner batch samples --out OUT`` leaves them.
"""

from __future__ import annotations

import argparse
import json
from pathlib import Path

import numpy as np

SAMPLES = Path(__file__).resolve().parents[1] / "samples"


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("out", type=Path)
    chosen = parser.parse_args()
    errors: dict[str, list[tuple[float, float]]] = {}
    for path in sorted(chosen.out.glob("*/report.json")):
        truth_file = SAMPLES / path.parent.name.split("-")[0] / "truth.json"
        truth = json.loads(truth_file.read_text())["girths_mm"]
        for name, girth in json.loads(path.read_text())["girths_mm"]["values"].items():
            errors.setdefault(name, []).append((girth["value"] - truth[name], girth["plus_minus"]))
    for name, pairs in errors.items():
        away, spread = np.array(pairs).T
        each = " ".join(f"{mm:+5.0f}" for mm in away)
        rms = np.sqrt(np.mean(np.square(away)))
        print(f"{name:10} {each} mm   rms {rms:4.0f} mm = {np.sqrt(np.mean((away / spread) ** 2)):.1f} ±")


if __name__ == "__main__":
    main()
