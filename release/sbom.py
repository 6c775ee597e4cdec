"""Print a bill of materials (CycloneDX 1.6, JSON) of Cloner, its packages and its models: ``make sbom``.

The same environment gives the same bytes: no time inside, and a serial number made of the content.

References
----------
OWASP CycloneDX 1.6 (ECMA-424).
"""

from __future__ import annotations

import hashlib
import json
import sys
import uuid
from importlib.metadata import Distribution
from pathlib import Path
from typing import Any

from closure import ROOT, closure, project
from packaging.utils import canonicalize_name

_SUFFIXES = (".npz", ".tflite", ".min.js")


def bill() -> dict[str, Any]:
    """Return the whole bill as JSON values."""
    told = project()
    own = {
        "type": "application", "name": told["name"], "version": told["version"], "purl": reference(told["name"],
        told["version"]), "bom-ref": told["name"], "licenses": [{"license": {"id": told["license"]}}],
    }  # fmt: skip
    parts = [package(one) for one in closure()] + files()
    needs = [{"ref": own["bom-ref"], "dependsOn": [part["bom-ref"] for part in parts]}]
    content = json.dumps(parts, sort_keys=True)
    serial = uuid.uuid5(uuid.NAMESPACE_URL, hashlib.sha256(content.encode()).hexdigest())
    return {
        "bomFormat": "CycloneDX", "specVersion": "1.6", "serialNumber": f"urn:uuid:{serial}", "version": 1,
        "metadata": {"component": own}, "components": parts, "dependencies": needs,
    }  # fmt: skip


def reference(name: str, number: str) -> str:
    return f"pkg:pypi/{canonicalize_name(name)}@{number}"


def package(one: Distribution) -> dict[str, Any]:
    """Return one installed distribution with its licence as its own metadata says it."""
    name = canonicalize_name(one.metadata["Name"])
    told = one.metadata.get("License-Expression")
    classified = [
        line.rsplit(" :: ", 1)[-1]
        for line in one.metadata.get_all("Classifier") or ()
        if line.startswith("License :: ") and not line.endswith("OSI Approved")
    ]
    named = classified or [(one.metadata.get("License") or "see its own files").splitlines()[0][:80]]
    licences = [{"expression": told}] if told else [{"license": {"name": text}} for text in named]
    return {
        "type": "library", "name": name, "version": one.version, "bom-ref": reference(name, one.version),
        "purl": reference(name, one.version), "licenses": licences,
    }  # fmt: skip


def files() -> list[dict[str, Any]]:
    """Return the models and scripts of others that lie in the packages."""
    folders = (ROOT / "generic_models" / "cloner_models", ROOT / "cloner" / "report" / "web")
    every = [path for folder in folders for path in sorted(folder.rglob("*")) if path.name.endswith(_SUFFIXES)]
    return [shipped(path) for path in every]


def shipped(path: Path) -> dict[str, Any]:
    digest = hashlib.sha256(path.read_bytes()).hexdigest()
    licence = "MIT" if path.suffix == ".js" else "Apache-2.0" if path.suffix == ".tflite" else "CC0-1.0"
    if path.name in ("canonical_face.npz", "face_net.npz", "face_regions.npz"):
        licence = "Apache-2.0"
    kind = "library" if path.suffix == ".js" else "machine-learning-model" if path.suffix == ".tflite" else "data"
    return {
        "type": kind, "name": path.relative_to(ROOT).as_posix(), "version": digest[:16], "bom-ref": f"sha256:{digest}",
        "hashes": [{"alg": "SHA-256", "content": digest}], "licenses": [{"license": {"id": licence}}],
    }  # fmt: skip


def main() -> None:
    sys.stdout.write(json.dumps(bill(), indent=1) + "\n")


if __name__ == "__main__":
    main()
