"""Put a bill of materials into a wheel, where PEP 770 wants it: ``python release/add_sbom.py WHEEL sbom.json``."""

from __future__ import annotations

import base64
import hashlib
import sys
import zipfile
from pathlib import Path


def main() -> None:
    wheel, bill = Path(sys.argv[1]), Path(sys.argv[2]).read_bytes()
    made = wheel.with_suffix(".new")
    with zipfile.ZipFile(wheel) as old, zipfile.ZipFile(made, "w", zipfile.ZIP_DEFLATED) as new:
        record = next(name for name in old.namelist() if name.endswith(".dist-info/RECORD"))
        name = record.replace("/RECORD", "/sboms/photo-cloner.cdx.json")
        for part in old.infolist():
            if part.filename not in (record, name):
                new.writestr(part, old.read(part))
        told = zipfile.ZipInfo(name, (1980, 1, 1, 0, 0, 0))  # the same bytes from the same parts
        new.writestr(told, bill, zipfile.ZIP_DEFLATED)
        digest = base64.urlsafe_b64encode(hashlib.sha256(bill).digest()).rstrip(b"=").decode()
        lines = [line for line in old.read(record).decode().splitlines() if not line.startswith(f"{name},")]
        lines.insert(-1, f"{name},sha256={digest},{len(bill)}")
        new.writestr(old.getinfo(record), "\n".join(lines) + "\n")
    made.replace(wheel)


if __name__ == "__main__":
    main()
