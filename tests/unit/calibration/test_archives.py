"""Learning a calibration again tells by how much it moved."""

from __future__ import annotations

import sys
from pathlib import Path

import numpy as np
import pytest

import cloner_models


@pytest.fixture(autouse=True)
def _build_scripts(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.syspath_prepend(str(Path(cloner_models.__file__).parents[1] / "build"))
    monkeypatch.delitem(sys.modules, "archives", raising=False)


def test_a_rebuild_tells_by_how_much_it_moved(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    from archives import save

    path = tmp_path / "net.npz"
    save(path, {"bias": np.full(4, 2.0), "same": np.arange(3), "names": np.array(["a"]), "gone": np.ones(1)})
    assert capsys.readouterr().out == "net.npz is new\n"
    save(path, {"bias": np.full(4, 2.1), "same": np.arange(3), "names": np.array(["b"]), "more": np.ones(1)})
    assert capsys.readouterr().out.splitlines() == [
        "net.npz: gone is gone",
        "net.npz: bias moved by 5.00% of its size",
        "net.npz: names is another: (1,) is now (1,)",
        "net.npz: more is new",
    ]
    before = path.read_bytes()
    save(path, {"bias": np.full(4, 2.1), "same": np.arange(3), "names": np.array(["b"]), "more": np.ones(1)})
    assert capsys.readouterr().out == ""
    assert path.read_bytes() == before
