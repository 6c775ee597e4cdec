"""Captures, faces, sounds, phonemes and clones that are broken."""

from __future__ import annotations

import io
import json
import struct
import zipfile
from collections.abc import Callable
from pathlib import Path
from typing import Any

import numpy as np

from cloner.project.clone_file import save_clone
from hostile.cases import Case, file
from kit.clones import toy_clone

JOINT = "OFFSET 0 0 0\nCHANNELS 3 Zrotation Xrotation Yrotation\nEnd Site\n{\nOFFSET 0 1 0\n}\n"
HEAD = f"HIERARCHY\nROOT hips\n{{\n{JOINT}}}\n"
MOTION = "MOTION\nFrames: 2\nFrame Time: 0.04\n0 0 0\n1 2 3\n"
BROKEN = "the capture is broken"
#: FAP 3 alone, the jaw: 1 and 2 take more than one value.
MASK = " ".join(["0", "0", "1", *["0"] * 65])
FAP = f"2.1 face 25 2\n{MASK}\n0 5\n{MASK}\n1 6\n"
NO_FAP = "the FAP file is broken"


def _bvh(name: str, text: bytes | str, words: str = BROKEN, *, command: bool = False) -> Case:
    return Case(f"bvh: {name}", "bvh", file("walk.bvh", text), words, "Export|Give|Cut" if words else "",
                "walk.bvh" if words else "", command)  # fmt: skip


_BVH = (
    Case("bvh: missing", "bvh", lambda folder: folder / "walk.bvh", "cannot be read", ".bvh", "walk.bvh"),
    Case("bvh: a folder", "bvh", lambda folder: folder, "cannot be read", ".bvh"),
    _bvh("good", HEAD + MOTION, ""),
    _bvh("empty", "", command=True),
    _bvh("noise", bytes(range(256))),
    _bvh("only a head", HEAD),
    _bvh("only motion", MOTION),
    _bvh("no bracket", HEAD.replace("}\n}", "}") + MOTION),
    _bvh("a bracket too many", HEAD + "}" + MOTION),
    _bvh("brackets only", "HIERARCHY } } }" + MOTION),
    _bvh("two roots", HEAD + HEAD.replace("HIERARCHY", "") + MOTION),
    _bvh("a joint first", HEAD.replace("ROOT", "JOINT") + MOTION),
    _bvh("words for an offset", HEAD.replace("OFFSET 0 0 0", "OFFSET a b c") + MOTION),
    _bvh("nan as offset", HEAD.replace("OFFSET 0 0 0", "OFFSET nan 0 0") + MOTION),
    _bvh("infinite offset", HEAD.replace("OFFSET 0 1 0", "OFFSET 0 1e999 0") + MOTION),
    _bvh("two numbers as offset", HEAD.replace("OFFSET 0 0 0", "OFFSET 0 0") + MOTION),
    _bvh("minus two channels", HEAD.replace("CHANNELS 3", "CHANNELS -2") + MOTION, command=True),
    _bvh("no channels", HEAD.replace("CHANNELS 3 Zrotation Xrotation Yrotation", "CHANNELS 0") + MOTION),
    _bvh("a promise without channels", HEAD.replace("CHANNELS 3 Zrotation Xrotation Yrotation", "")
         + MOTION.replace("Frames: 2", "Frames: 10000000"), command=True),
    _bvh("an unknown channel", HEAD.replace("Zrotation", "Wrotation") + MOTION),
    _bvh("too few numbers", HEAD + MOTION.replace("1 2 3", "1 2")),
    _bvh("nan", HEAD + MOTION.replace("1 2 3", "nan 2 3")),
    _bvh("words for numbers", HEAD + MOTION.replace("1 2 3", "a b c")),
    _bvh("no frames", HEAD + MOTION.replace("Frames: 2", "Frames: 0")),
    _bvh("minus one frame", HEAD + MOTION.replace("Frames: 2", "Frames: -1")),
    _bvh("ever so many frames", HEAD + MOTION.replace("Frames: 2", "Frames: " + "9" * 30)),
    _bvh("digits without end", HEAD + MOTION.replace("Frames: 2", "Frames: " + "9" * 5000)),
    _bvh("no time", HEAD + MOTION.replace("0.04", "0")),
    _bvh("time nan", HEAD + MOTION.replace("0.04", "nan")),
    _bvh("nothing after motion", HEAD + "MOTION"),
    _bvh("joints without end", "HIERARCHY ROOT a {" + "JOINT b { OFFSET 0 0 0" * 2000 + "}" * 2001 + MOTION),
)  # fmt: skip


def _fap(name: str, text: bytes | str, words: str = NO_FAP, *, command: bool = False) -> Case:
    return Case(f"fap: {name}", "fap", file("face.fap", text), words, "Write|Give|Cut" if words else "",
                "face.fap" if words else "", command)  # fmt: skip


_FAP = (
    Case("fap: missing", "fap", lambda folder: folder / "face.fap", "cannot be read", ".fap", "face.fap"),
    _fap("good", FAP, ""),
    _fap("empty", "", command=True),
    _fap("another version", FAP.replace("2.1", "9.9")),
    _fap("noise", bytes(range(256))),
    _fap("half a head", "2.1 face"),
    _fap("words as rate", FAP.replace(" 25 ", " fast ")),
    _fap("rate nan", FAP.replace(" 25 ", " nan ")),
    _fap("rate nought", FAP.replace(" 25 ", " 0 ")),
    _fap("more frames than lines", FAP.replace("25 2", "25 99")),
    _fap("frames without end", FAP.replace("25 2", "25 " + "9" * 5000)),
    _fap("a short mask", FAP.replace(MASK, "1 0 0")),
    _fap("a mask of huge numbers", FAP.replace(MASK, MASK.replace("1", "9" * 40, 1)), command=True),
    _fap("a value too many", FAP.replace("0 5", "0 5 6")),
    _fap("nan", FAP.replace("0 5", "0 nan"), command=True),
    _fap("infinity", FAP.replace("0 5", "0 1e999")),
)


def wav(rate: int = 16_000, data: bytes = b"", *, kind: int = 1, channels: int = 1, bits: int = 16) -> bytes:
    """Return a WAV file with whatever header one likes."""
    block = max(channels * bits // 8, 1)
    head = struct.pack("<HHIIHH", kind, channels, rate, (rate * block) % 2**32, block, bits)
    body = b"WAVEfmt " + struct.pack("<I", len(head)) + head + b"data" + struct.pack("<I", len(data)) + data
    return b"RIFF" + struct.pack("<I", len(body)) + body


SOUND = (8000 * np.sin(np.arange(16_000) / 9.0)).astype("<i2").tobytes()
NO_SOUND = "the sound cannot be read"
SILENT = "nothing to hear"


def _wav(name: str, data: bytes, words: str = NO_SOUND, *, command: bool = False) -> Case:
    return Case(f"wav: {name}", "wav", file("talk.wav", data), words, "Give|Record|Cut" if words else "",
                "talk.wav" if words else "", command)  # fmt: skip


_WAV = (
    Case("wav: missing", "wav", lambda folder: folder / "talk.wav", "cannot be read", ".wav", "talk.wav"),
    _wav("good", wav(data=SOUND), ""),
    _wav("empty", b"", command=True),
    _wav("noise", bytes(range(256))),
    _wav("a header", wav()[:30]),
    _wav("no samples", wav(), f"{SILENT}|{NO_SOUND}"),
    _wav("silence", wav(data=bytes(40_000)), SILENT, command=True),
    _wav("too short", wav(data=SOUND[:100]), SILENT),
    _wav("no rate", wav(0, SOUND), command=True),
    _wav("a rate beyond reason", wav(2**32 - 1, SOUND), command=True),
    _wav("a prime rate", wav(2_147_483_647, SOUND)),
    _wav("one sample a second", wav(1, SOUND), f"{NO_SOUND}|longer"),
    _wav("longer than ten minutes", wav(1000, bytes(2 * 700_000)), "longer than 10 minutes"),
    _wav("an unknown coding", wav(data=SOUND, kind=0x1234)),
    _wav("no channels", wav(data=SOUND, channels=0)),
    _wav("nan samples", wav(data=np.full(16_000, np.nan, "<f4").tobytes(), kind=3, bits=32), f"{SILENT}|{NO_SOUND}"),
)


def _phonemes(name: str, text: bytes | str, words: str, *, command: bool = False) -> Case:
    return Case(f"phonemes: {name}", "phonemes", file("talk.txt", text), words, "ARPAbet|Give|Write|Cut", "", command)


_PHONEMES = (
    _phonemes("empty", "", "no phoneme", command=True),
    _phonemes("an unknown one", "QQ 0.1", "'QQ' is not known"),
    _phonemes("no time", "AA1", "no phoneme with its seconds"),
    _phonemes("words as time", "AA1 long", "no phoneme with its seconds"),
    _phonemes("less than nothing", "AA1 -1", "lasts -1"),
    _phonemes("nan", "AA1 nan", "lasts nan"),
    _phonemes("an hour", "AA1 3600", "lasts 3600"),
    _phonemes("days", "AA1 10\n" * 100_000, "longer than 10 minutes", command=True),
    _phonemes("not text", b"\xff\xfe", "cannot be read"),
    _phonemes("escape codes", "\x1b[2J 0.1", "is not known"),
    Case("phonemes: missing", "phonemes", lambda folder: folder / "talk.txt", "cannot be read", "text", "talk.txt"),
)

NO_CLONE = "not a readable clone"


def changed(**arrays: Any) -> Callable[[Path], Path]:
    """Return a maker of a clone's file with some arrays replaced; None leaves one out."""

    def make(folder: Path) -> Path:
        path = folder / "clone.npz"
        save_clone(toy_clone(), path)
        with np.load(path) as archive:
            parts = {name: archive[name] for name in archive.files} | arrays
        np.savez(path, **{name: value for name, value in parts.items() if value is not None})
        return path

    return make


def facts(**told: Any) -> Callable[[Path], Path]:
    """Return a maker of a clone's file with some facts replaced."""

    def make(folder: Path) -> Path:
        path = changed()(folder)
        with np.load(path) as archive:
            parts = {name: archive[name] for name in archive.files}
        known = json.loads(parts["facts_json"].tobytes()) | told
        parts["facts_json"] = np.frombuffer(json.dumps(known).encode(), np.uint8)
        np.savez(path, **parts)
        return path

    return make


def cut(share: float) -> Callable[[Path], Path]:
    def make(folder: Path) -> Path:
        path = changed()(folder)
        path.write_bytes(path.read_bytes()[: int(share * path.stat().st_size)])
        return path

    return make


def npy_bomb(folder: Path) -> Path:
    """A few bytes that promise a terabyte."""
    path = folder / "clone.npz"
    head = io.BytesIO()
    np.lib.format.write_array_header_1_0(head, {"descr": "<f8", "fortran_order": False, "shape": (10**11,)})
    with zipfile.ZipFile(path, "w") as archive:
        archive.writestr("facts_json.npy", head.getvalue())
    return path


def picture_bomb() -> np.ndarray:
    from hostile.cases_photos import png_of

    return np.frombuffer(png_of(60_000, 60_000), np.uint8)


def _clone(name: str, make: Callable[[Path], Path], words: str = NO_CLONE, *, command: bool = False) -> Case:
    return Case(f"clone: {name}", "clone", make, words, "Clone|Give", "", command)


_CLONES = (
    _clone("missing", lambda folder: folder / "clone.npz", "no clone", command=True),
    _clone("an empty folder", lambda folder: folder, "no clone"),
    _clone("empty", file("clone.npz", b""), command=True),
    _clone("text", file("clone.npz", "hello")),
    _clone("half", cut(0.5), command=True),
    _clone("nearly whole", cut(0.99)),
    _clone("another zip", lambda folder: _zip(folder, "readme.txt", b"hi")),
    _clone("pickled", lambda folder: _zip(folder, "facts_json.npy", _pickled())),
    _clone("a promise of a terabyte", npy_bomb, command=True),
    _clone("a bomb as skin", changed(atlas_rgb_png=picture_bomb()), command=True),
    _clone("no skin", changed(atlas_rgb_png=None)),
    _clone("a skin of text", changed(atlas_rgb_png=np.frombuffer(b"hello", np.uint8))),
    _clone("facts that are none", changed(facts_json=np.frombuffer(b"[1]", np.uint8))),
    _clone("facts of words", changed(facts_json=np.array(["a"]))),
    _clone("of a newer version", facts(version=99), "newer version", command=True),
    _clone("a version in words", facts(version="new")),
    _clone("another program's", facts(format="other"), f"newer|{NO_CLONE}"),
    _clone("five vertices", changed(vertices_m=np.zeros((5, 3))), command=True),
    _clone("nan vertices", changed(vertices_m=np.full((19_158, 3), np.nan))),
    _clone("three joints", changed(joints_m=np.zeros((3, 3)))),
    _clone("morphs out of bounds", changed(morph_index=np.array([10**6], np.int32))),
    _clone("words as height", facts(stature_m="tall")),
    _clone("a height of nan", facts(stature_m=float("nan"))),
    _clone("names without end", facts(feature_names=["x"])),
    _clone("a view that is none", facts(views={"above": {}})),
)


def _zip(folder: Path, name: str, data: bytes) -> Path:
    with zipfile.ZipFile(folder / "clone.npz", "w") as archive:
        archive.writestr(name, data)
    return folder / "clone.npz"


def _pickled() -> bytes:
    stream = io.BytesIO()
    np.save(stream, np.array([{"a": 1}], dtype=object), allow_pickle=True)
    return stream.getvalue()


CASES = (*_BVH, *_FAP, *_WAV, *_PHONEMES, *_CLONES)
