"""Build the engines of crowds and of cloth, `engine.wasm`, of the AssemblyScript beside each.

Fetch the compiler with the ordinary client and give its folder::

    npm install --prefix FOLDER assemblyscript@0.28.20
    python generic_models/build/build_engine.py FOLDER

The same compiler gives the same bytes; ``PROVENANCE.json`` beside the module tells theirs and those of its source, and
``tests/unit/webassembly/test_engines.py`` builds and compares. No code of the compiler's library is in the module.
"""

from __future__ import annotations

import argparse
import hashlib
import json
import subprocess
import tempfile
from pathlib import Path

CLONER = Path(__file__).resolve().parents[2] / "cloner"
#: Where the engines lie, their source beside them, and what both take from.
ENGINES = (CLONER / "behaviour" / "core", CLONER / "cloth" / "simulation" / "core")
SHARED = CLONER / "webassembly"
MODULE = "engine.wasm"
#: No garbage collector and no checks of arrays: an engine takes its memory once and holds numbers only.
OPTIONS = ("-O3", "--runtime", "stub", "--noAssert", "--initialMemory", "1")


def built(core: Path, packages: Path) -> bytes:
    """Return an engine's module, made by the compiler in a folder of npm packages."""
    compiler = packages / "node_modules" / "assemblyscript" / "bin" / "asc.js"
    with tempfile.TemporaryDirectory() as folder:
        module = Path(folder) / MODULE
        subprocess.run(["node", compiler, "engine.ts", *OPTIONS, "--outFile", module], cwd=core, check=True)
        return module.read_bytes()


def provenance(core: Path, module: bytes, packages: Path) -> dict[str, object]:
    """Return what is told of a module: its digest, and of what by what it was made."""
    told = json.loads((packages / "node_modules" / "assemblyscript" / "package.json").read_text(encoding="utf-8"))
    return {
        "file": MODULE,
        "sha256": hashlib.sha256(module).hexdigest(),
        "licence": "Apache-2.0",
        "made_with": f"assemblyscript {told['version']} {' '.join(OPTIONS)}",
        "source": source_digests(core),
    }


def source_digests(core: Path) -> dict[str, str]:
    """Return the sha256 of each file of an engine's source."""
    found = sorted([*core.rglob("*.ts"), *SHARED.glob("*.ts")])
    return {one.relative_to(CLONER).as_posix(): hashlib.sha256(one.read_bytes()).hexdigest() for one in found}


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("packages", type=Path, help="folder that holds node_modules")
    packages = parser.parse_args().packages.resolve()
    for core in ENGINES:
        module = built(core, packages)
        (core / MODULE).write_bytes(module)
        told = json.dumps([provenance(core, module, packages)], indent=1)
        (core / "PROVENANCE.json").write_text(told + "\n", encoding="utf-8")
        print(f"{core.relative_to(CLONER)}: {len(module)} bytes")


if __name__ == "__main__":
    main()
