"""How well a talking mouth keeps the time of known phonemes, and a film strip of it.

    python benchmarks/talk.py [--speech FOLDER] [--clone RESULT --out docs/pictures/talk.jpg]
    PYTHONPATH=tests python benchmarks/talk.py --clone RESULT --voices en-us en de de+f3 en-us+f5 de+m8 slt rms

FOLDER holds pairs NAME.wav and NAME.txt (phonemes with their lengths); by default the project's own test speech. A
phoneme is met if within 60 ms of its middle its mouth shape is the leading one, or at least half as strong as that.
"Phonemes" moves the mouth by the list, "sound" by the sound alone.

Voices of espeak-ng, or of flite (awb, kal16, rms, slt), speak sentences that nothing was taught with: how often lips
meet for p, b and m, and how often the shape of a phoneme leads at its middle, by sound and by the phonemes themselves.
"""

from __future__ import annotations

import argparse
import sys
import tempfile
from dataclasses import replace
from pathlib import Path
from typing import Final

import cv2
import numpy as np
from numpy.typing import NDArray
from scipy.io import wavfile

from cloner.generic.framing import standard_camera
from cloner.motion.face.espeak import spoken
from cloner.motion.face.speech import STEP_S, VISEMES, mouth_weights, phoneme_visemes, read_phonemes, viseme_of
from cloner.motion.face.talk import FRAMES_PER_S, spoken_visemes, talk
from cloner.motion.limbs.body import body_of
from cloner.motion.limbs.rig import centre_joints
from cloner.picture import load_clone_at
from cloner.records.clones import Clone
from cloner.render import render

sys.path.insert(0, str(Path(__file__).resolve().parents[1] / "generic_models" / "build"))

Array = NDArray[np.float64]

SPEECH: Final = Path(__file__).resolve().parents[1] / "tests" / "kit" / "speech"
NEAR_S: Final = 0.06
HALF: Final = 0.5
STRIP: Final = 16  # pictures
FLITE: Final = ("awb", "kal16", "rms", "slt")
#: Shapes that are seen: lips that meet, rounded and open vowels.
SALIENT: Final = ("PP", "O", "U", "aa")
SENTENCES: Final = {
    "en": (
        "My mum may buy a big blue map before summer.",
        "Pat and Bob both moved the big blue boat, which pleased Sue very much.",
        "Hello, my name is Anna. Five photographs of me became this figure.",
        "Whenever people come home from the market they bring bread, plums and beer.",
        "Two good cooks who knew the moon put small brown boxes upon the table.",
        "Far above the harbour a lamp burned all night; nobody saw who put it there.",
        "The proud old farmer ploughs, whistles and hopes for warm weather tomorrow.",
    ),
    "de": (
        "Oma backt Brot und kocht Suppe mit Bohnen.",
        "Fünf Fotos machen aus mir diese Figur, und sie bewegt beim Sprechen den Mund.",
        "Am Bahnhof warten Paul und Bärbel auf ihren blauen Bus.",
        "Der Müller mahlt morgens Mehl, abends zupft er Blumen.",
        "Über der Brücke wohnte früher ein böser, stummer König.",
        "Papa kommt bald aus Bremen zurück und bringt Bücher mit.",
    ),
}


def met(shares: Array, phonemes: list[tuple[str, float]]) -> list[tuple[str, bool]]:
    """Return every phoneme and whether the mouth made its shape in time."""
    times, weights = mouth_weights(shares, FRAMES_PER_S)
    mouth = np.column_stack([weights.get(f"viseme_{name}", np.zeros(len(times))) for name in VISEMES])
    mouth[:, 0] = np.clip(1.0 - mouth.sum(axis=1), 0.0, 1.0)
    found, start = [], 0.0
    for phoneme, length in phonemes:
        middle, start = start + length / 2.0, start + length
        near = mouth[np.abs(times - middle) <= NEAR_S]
        own = near[:, VISEMES.index(viseme_of(phoneme))]
        found.append((phoneme, bool((own >= HALF * near.max(axis=1)).any())))
    return found


def voice_row(clone: Clone, voice: str) -> str:
    """Return a voice's row: by sound and by phonemes, how many lips meet and how many shapes lead at their middle."""
    from visemes import by_flite

    from kit.lips import closed

    told: dict[str, list[list[bool]]] = {"sound": [[], [], []], "phonemes": [[], [], []]}
    with tempfile.TemporaryDirectory() as scratch:
        for text in SENTENCES["de" if voice.startswith("de") else "en"]:
            rate, sound, phonemes = by_flite(voice, text) if voice in FLITE else spoken(text, voice)
            wavfile.write(Path(scratch) / "said.wav", rate, sound)
            for by, shares in (
                ("sound", spoken_visemes(Path(scratch) / "said.wav")),
                ("phonemes", phoneme_visemes(phonemes)),
            ):
                led = leading(shares, phonemes)
                told[by][0] += closed(clone, shares, phonemes)
                told[by][1] += [good for shape, good in led if shape in SALIENT]
                told[by][2] += [good for _, good in led]
    cells = [f"{100.0 * np.mean(row):.0f} %" for by in told for row in told[by]]
    counts = [len(row) for row in told["sound"]]
    return f"| {voice} | {' | '.join(cells)} | {counts[0]}, {counts[1]}, {counts[2]} |\n"


def leading(shares: Array, phonemes: list[tuple[str, float]]) -> list[tuple[str, bool]]:
    """Return every phoneme's mouth shape and whether it leads at the phoneme's middle."""
    times, weights = mouth_weights(shares, 1.0 / STEP_S)
    mouth = np.column_stack([weights.get(f"viseme_{name}", np.zeros(len(times))) for name in VISEMES])
    mouth[:, 0] = np.clip(1.0 - mouth.sum(axis=1), 0.0, 1.0)
    found, start = [], 0.0
    for phoneme, length in phonemes:
        row = mouth[int(np.abs(times - start - length / 2.0).argmin())]
        start += length
        found.append((viseme_of(phoneme), VISEMES[int(row.argmax())] == viseme_of(phoneme)))
    return found


def strip(clone: Clone, speech: Path) -> NDArray[np.uint8]:
    """Return pictures of a speaking face, evenly through the first half of a speech, with the leading mouth shape."""
    motion = talk(body_of(centre_joints(clone)), speech.stem, spoken_visemes(speech))
    rows = np.linspace(0, len(motion.times_s) // 2, STRIP).astype(int)
    camera = standard_camera(clone, "face", 220, 280)
    pictures = []
    for row in rows:
        weights = {name: float(values[row]) for name, values in motion.weights.items()}
        picture = np.ascontiguousarray(render(shaped(clone, weights), camera, shading="soft"))
        said = max((name for name in weights if name.startswith("viseme_")), key=lambda name: weights[name])
        label = f"{motion.times_s[row]:.2f} s {said.removeprefix('viseme_') if weights[said] > 0.2 else '-'}"
        pictures.append(cv2.putText(picture, label, (6, 272), cv2.FONT_HERSHEY_SIMPLEX, 0.5, (20, 20, 20), 1))
    half = STRIP // 2
    return np.vstack([np.hstack(pictures[:half]), np.hstack(pictures[half:])])


def shaped(clone: Clone, weights: dict[str, float]) -> Clone:
    """Return the clone with its morph targets at some weights."""
    vertices = clone.vertices_m.copy()
    for number, name in enumerate(clone.morph_names):
        rows = slice(int(clone.morph_start[number]), int(clone.morph_start[number + 1]))
        vertices[clone.morph_index[rows]] += weights.get(name, 0.0) * clone.morph_delta_m[rows]
    return replace(clone, vertices_m=vertices)


def main() -> None:
    """Print the table and write the strip."""
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--speech", type=Path, default=SPEECH)
    parser.add_argument("--clone", type=Path)
    parser.add_argument("--out", type=Path, default=Path("docs/pictures/talk.jpg"))
    parser.add_argument("--voices", nargs="*", default=[])
    asked = parser.parse_args()
    if asked.voices:
        clone = centre_joints(load_clone_at(asked.clone))
        sys.stdout.write("| voice | by sound: closed | salient lead | all lead | by phonemes: closed | salient | all "
                         "| p b m, salient, all |\n" + "| --- " * 8 + "|\n")  # fmt: skip
        for voice in asked.voices:
            sys.stdout.write(voice_row(clone, voice))
            sys.stdout.flush()
        return
    sounds = sorted(asked.speech.glob("*.wav"))
    sys.stdout.write("| speech | by | phonemes | in time, % | missed |\n" + "| --- " * 5 + "|\n")
    for sound in sounds:
        phonemes = read_phonemes(sound.with_suffix(".txt"))
        for by, path in (("phonemes", sound.with_suffix(".txt")), ("sound", sound)):
            rows = met(spoken_visemes(path), phonemes)
            missed = " ".join(phoneme for phoneme, good in rows if not good)
            share = 100.0 * np.mean([good for _, good in rows])
            sys.stdout.write(f"| {sound.stem} | {by} | {len(rows)} | {share:.0f} | {missed} |\n")
    if asked.clone:
        picture = strip(load_clone_at(asked.clone), sounds[0].with_suffix(".txt"))
        cv2.imwrite(str(asked.out), picture[..., ::-1], [cv2.IMWRITE_JPEG_QUALITY, 85])


if __name__ == "__main__":
    main()
