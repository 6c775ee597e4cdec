"""Put captured motions, speech and facial animation on a finished clone."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace
from pathlib import Path
from typing import Final

import numpy as np

from cloner.errors import ClonerError
from cloner.exporters.shared.files import write_bytes
from cloner.exporters.table import EXPORTERS
from cloner.motion.captures.acclaim import read_acclaim
from cloner.motion.captures.bvh import read_bvh
from cloner.motion.captures.retarget import retarget
from cloner.motion.face.faps import fap_text, read_fap, rotations_of, stream_of, weights_of
from cloner.motion.face.limits import limited
from cloner.motion.face.score import SILENT, Score, emotion_score, read_score
from cloner.motion.face.speech import STEP_S
from cloner.motion.face.talk import FRAMES_PER_S, scored, spoken_visemes, talk
from cloner.motion.limbs.body import Body, body_of
from cloner.motion.limbs.rig import centre_joints
from cloner.motion.moves.cycle import walk_cycle
from cloner.motion.moves.own import own_motions
from cloner.picture import load_clone_at
from cloner.project.atomic import safe_output
from cloner.records.clones import Clone
from cloner.records.motions import Motion

SPEECH = (".wav", ".txt")
SCORE = ".toml"
#: How an animated clone may leave; every one holds the sources' motions before the clone's own.
FORMATS: Final = {".glb": "glb", ".vrm": "vrm", ".vrma": "vrma", ".wrl": "wrl", ".x3d": "x3d", ".usdz": "usdz"}
CAPTURES = {".bvh": read_bvh, ".amc": read_acclaim}


def animate_file(
    clone_path: Path, sources: Sequence[Path], out: Path, *, cycles: bool = False, emotion: str = ""
) -> tuple[Path, ...]:
    """Write a clone with further animations, the first one first, and the speech's face as FAP files beside it.

    Parameters
    ----------
    clone_path : Path
        ``clone.npz`` or the folder that holds it.
    sources : sequence of Path
        Each becomes an animation with the file's name: .bvh and .amc (its .asf beside it) are laid on the body, .wav
        and .txt (phonemes, or words) are spoken, .fap moves the face, .toml is a score of expressions on tracks. A
        .toml of a speech's name beside it is played with the speech.
    out : Path
        Ends with one of `FORMATS`. A .wrl plays the first animation and, at a click, the second; .vrma, .x3d and
        .usdz hold the first one alone.
    cycles : bool
        Cut every capture down to two steps of walking on the spot, closed into a circle.
    emotion : str
        One of the six expressions; the mood of a speech that has no score.

    Returns
    -------
    tuple of Path
        All written files.

    Raises
    ------
    ClonerError
        If there is no clone, a source cannot be read or laid on, or a file to write exists or cannot be written.
    """
    if out.suffix.lower() not in FORMATS:
        hint = f"Give --out a name that ends with {', '.join(FORMATS)}"
        raise ClonerError(f"no animation is written as {out.suffix or 'this'}", hint, out.name)
    beside = {path: out.with_name(f"{out.stem}_{path.stem}.fap") for path in sources if path.suffix.lower() in SPEECH}
    for file in (out, *beside.values()):
        safe_output(file)
    clone = load_clone_at(clone_path)
    made = [_motion(clone, body_of(centre_joints(clone)), path, cycles=cycles, emotion=emotion) for path in sources]

    def moves(posed: Clone) -> Sequence[Motion]:
        """Return the sources' motions, the first one first, and the clone's own, for any rest pose."""
        body = body_of(posed)
        laid = [_motion(clone, body, path, cycles=cycles, emotion=emotion) for path in sources]
        return *(replace(motion, weights=limited(clone, motion.weights)) for motion in laid), *own_motions(posed)

    written = list(EXPORTERS.get(FORMATS[out.suffix.lower()])(clone, out.parent, name=out.stem, moves=moves))
    for path, motion in zip(sources, made, strict=True):
        if path.suffix.lower() in SPEECH:
            written.append(beside[path])
            weights = limited(clone, motion.weights)
            write_bytes(written[-1], fap_text(stream_of(clone, weights, FRAMES_PER_S), path.stem).encode())
    return tuple(written)


def _motion(clone: Clone, body: Body, path: Path, *, cycles: bool, emotion: str) -> Motion:
    """Return the motion that a file holds."""
    suffix = path.suffix.lower()
    if suffix in CAPTURES:
        motion = retarget(CAPTURES[suffix](path), body, name=path.stem)
        return walk_cycle(body, motion) if cycles else motion
    if suffix in SPEECH:
        shares = spoken_visemes(path)
        return talk(body, path.stem, shares, _score_of(clone, path, emotion, len(shares) * STEP_S))
    if suffix == SCORE:
        return scored(body, path.stem, read_score(path, clone.morph_names))
    if suffix == ".fap":
        stream = read_fap(path)
        times = np.arange(len(stream.values)) / stream.frames_per_s
        rotations = rotations_of(stream, body.names)
        return Motion(path.stem, times, np.zeros((len(times), 3)), rotations, weights_of(clone, stream))
    hint = "Give .bvh, .amc, .wav, .txt, .fap or .toml files"
    raise ClonerError(f"{suffix or 'this'} is no kind of animation", hint, path.name)


def _score_of(clone: Clone, speech: Path, emotion: str, duration_s: float) -> Score:
    """Return the facial score beside a speech: the file of its name, else its mood."""
    beside = speech.with_suffix(SCORE)
    if beside.is_file():
        return read_score(beside, clone.morph_names)
    return emotion_score(emotion, duration_s) if emotion else SILENT
