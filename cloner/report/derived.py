"""Results that are derived from a clone, or from numbers alone: a folder like any clone's."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import Any, Final

import cloner
from cloner.exporters.table import EXPORTERS
from cloner.project.clone_file import CLONE_FILE, save_clone
from cloner.project.results import read_manifest
from cloner.project.stamps import digest_of_models, output_digests
from cloner.records.clones import Clone
from cloner.report.viewer import write_viewer
from cloner.report.write import write_report

#: Version of the manifest's form.
FORMAT: Final = 1
#: What viewers show.
GLB_FILE: Final = "clone.glb"


def write_result(clone: Clone, folder: Path, title: str, formats: Sequence[str], manifest: Mapping[str, Any]) -> None:
    """Write a clone that no photos were read for into a result's folder: its file, formats, viewer and manifest."""
    save_clone(clone, folder / CLONE_FILE)
    for name in formats:
        EXPORTERS.get(name)(clone, folder)
    if (folder / GLB_FILE).is_file():
        write_viewer(title, folder / GLB_FILE)
    files = [path.relative_to(folder).as_posix() for path in folder.rglob("*") if path.is_file()]
    write_report(dict(manifest) | {"outputs": output_digests(folder, files)}, folder)


def make_manifest(clone: Clone, kind: str, options: Mapping[str, Any], source: Path | None) -> dict[str, Any]:
    """Return the manifest; what derives from a clone belongs to the same visitor."""
    first = read_manifest(source if source.is_dir() else source.parent) if source is not None else None
    kept = {name: first.stamp.get(name, {}) for name in ("photos", "beside")} if first is not None else {}
    return {
        "format": FORMAT,
        "kind": kind,
        "made_by": clone.stamp,
        "stature_m": round(clone.stature_m, 4),
        "measures_mm": dict(clone.measures_mm),
        "source": first.source if first is not None else "",
        "stamp": {
            "cloner": cloner.__version__,
            "models": digest_of_models(),
            "photos": kept.get("photos", {}),
            "beside": kept.get("beside", {}),
            "options": dict(options),
        },
    }
