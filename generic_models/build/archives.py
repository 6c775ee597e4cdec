"""Write the shipped arrays so that a rebuild gives the same bytes, and tell by how much they moved."""

import hashlib
import io
import json
import zipfile
from pathlib import Path

import numpy as np


def save(path: Path, arrays: dict[str, np.ndarray]) -> None:
    """Write a compressed .npz whose bytes depend on the arrays alone (no dates); print by how much they moved."""
    for line in moved(path, arrays):
        print(line)
    with zipfile.ZipFile(path, "w", zipfile.ZIP_DEFLATED, compresslevel=9) as archive:
        for name, array in arrays.items():
            buffer = io.BytesIO()
            np.lib.format.write_array(buffer, np.ascontiguousarray(array), allow_pickle=False)
            entry = zipfile.ZipInfo(f"{name}.npy", date_time=(1980, 1, 1, 0, 0, 0))
            entry.compress_type = zipfile.ZIP_DEFLATED
            archive.writestr(entry, buffer.getvalue())


def save_told(path: Path, arrays: dict[str, np.ndarray]) -> None:
    """Write an archive as `save` does, and its digest into the ``PROVENANCE.json`` beside it."""
    save(path, arrays)
    place = path.with_name("PROVENANCE.json")
    told = json.loads(place.read_text())
    told["outputs"][path.name] = hashlib.sha256(path.read_bytes()).hexdigest()
    place.write_text(json.dumps(told, indent=1) + "\n")


def moved(path: Path, arrays: dict[str, np.ndarray]) -> list[str]:
    """Return a line an array that differs from the file's: root mean square of the change over that of the old."""
    if not path.exists():
        return [f"{path.name} is new"]
    lines = []
    with np.load(path) as old:
        lines += [f"{path.name}: {name} is gone" for name in old.files if name not in arrays]
        for name, array in arrays.items():
            if name not in old.files:
                lines.append(f"{path.name}: {name} is new")
            elif np.shape(array) != old[name].shape or not np.issubdtype(old[name].dtype, np.number):
                if not np.array_equal(array, old[name]):
                    lines.append(f"{path.name}: {name} is another: {old[name].shape} is now {np.shape(array)}")
            elif (
                change := float(np.sqrt(np.mean((np.asarray(array, float) - old[name]) ** 2)))
                if np.size(array)
                else 0.0
            ):
                size = float(np.sqrt(np.mean(np.asarray(old[name], float) ** 2)))
                lines.append(f"{path.name}: {name} moved by {change / size if size else np.inf:.2%} of its size")
    return lines
