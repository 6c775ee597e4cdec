"""Relative error of every girth over the sample visitors, for MEASURED_SHARE in cloner/geometry/measures.py.

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
    errors: dict[str, list[float]] = {}
    for path in sorted(chosen.out.glob("*/report.json")):
        truth_file = SAMPLES / path.parent.name.split("-")[0] / "truth.json"
        truth = json.loads(truth_file.read_text())["girths_mm"]
        for name, girth in json.loads(path.read_text())["girths_mm"]["values"].items():
            errors.setdefault(name, []).append(girth["value"] / truth[name] - 1.0)
    for name, values in errors.items():
        each = " ".join(f"{100 * value:+6.1f}" for value in values)
        print(f"{name:10} rms {np.sqrt(np.mean(np.square(values))):.3f}   {each} %")


if __name__ == "__main__":
    main()
