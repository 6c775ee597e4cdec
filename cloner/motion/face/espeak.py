"""Text to speech by espeak-ng, where installed: the sound, and every phoneme with its time.

The program is somebody else's and stays so: a process of its own speaks, and what comes back is sound and names of
phonemes in the alphabet of phonetics (IPA).

References
----------
espeak-ng 1.51, speak_lib.h (phoneme events).
"""

from __future__ import annotations

import base64
import ctypes.util
import json
import subprocess
import sys
from typing import Final

import numpy as np
from numpy.typing import NDArray

from cloner.errors import ClonerError

LONGEST_TEXT: Final = 5000  # letters: some five minutes
#: Longest that the speaking program may take, seconds (taste).
PATIENCE_S: Final = 120.0
_SPEAKS: Final = """
import base64, ctypes, json, sys
asked = json.load(sys.stdin)
lib = ctypes.CDLL(asked["library"])
class Name(ctypes.Union):
    _fields_ = [("number", ctypes.c_int), ("name", ctypes.c_char_p), ("string", ctypes.c_char * 8)]
class Event(ctypes.Structure):
    _fields_ = [("type", ctypes.c_int), ("one", ctypes.c_uint), ("place", ctypes.c_int), ("length", ctypes.c_int),
                ("audio_ms", ctypes.c_int), ("sample", ctypes.c_int), ("user", ctypes.c_void_p), ("id", Name)]
sound, told = bytearray(), []
@ctypes.CFUNCTYPE(ctypes.c_int, ctypes.POINTER(ctypes.c_short), ctypes.c_int, ctypes.POINTER(Event))
def heard(wave, count, events):
    if wave and count > 0:
        sound.extend(ctypes.string_at(wave, 2 * count))
    row = 0
    while events[row].type != 0:
        if events[row].type == 7:
            told.append((events[row].audio_ms, bytes(events[row].id.string).decode("utf-8", "replace")))
        row += 1
    return 0
rate = lib.espeak_Initialize(1, 500, None, 3)
lib.espeak_SetSynthCallback(heard)
if rate < 0 or lib.espeak_SetVoiceByName(asked["voice"].encode()) != 0:
    sys.exit("voice")
lib.espeak_SetParameter(1, asked["words_a_minute"], 0)
text = asked["text"].encode()
lib.espeak_Synth(text, len(text) + 1, 0, 1, 0, 1, None, None)
lib.espeak_Synchronize()
print(json.dumps({"rate": rate, "sound": base64.b64encode(bytes(sound)).decode(), "phonemes": told}))
"""


def has_espeak() -> bool:
    """Return whether espeak-ng is installed."""
    return ctypes.util.find_library("espeak-ng") is not None


def spoken(
    text: str, voice: str = "en-us", words_a_minute: int = 150
) -> tuple[int, NDArray[np.int16], list[tuple[str, float]]]:
    """Return samples a second, the sound (N,) and the phonemes, each with its seconds, in order and without gaps.

    Parameters
    ----------
    text : str
    voice : str
        A language of espeak-ng, "en-us" or "de" for example, with a variant behind a plus.
    words_a_minute : int

    Raises
    ------
    ClonerError
        If the program is not here, knows no such voice, or has nothing to say.
    """
    library = ctypes.util.find_library("espeak-ng")
    if library is None:
        raise ClonerError(
            "written words need the program espeak-ng", "Install espeak-ng, or give a .wav file or phonemes", "text"
        )
    if not text.strip() or len(text) > LONGEST_TEXT:
        raise ClonerError("there is nothing to say, or far too much", f"Give 1 to {LONGEST_TEXT} letters", "text")
    asked = {"library": library, "voice": voice, "words_a_minute": words_a_minute, "text": text}
    done = subprocess.run([sys.executable, "-c", _SPEAKS], input=json.dumps(asked), capture_output=True, text=True,
                          timeout=PATIENCE_S, check=False)  # fmt: skip
    if done.returncode != 0:
        raise ClonerError(f"espeak-ng cannot speak with the voice {voice!r}", "Use a language that it has", "text")
    data = json.loads(done.stdout)
    sound = np.frombuffer(base64.b64decode(data["sound"]), dtype=np.int16)
    return int(data["rate"]), sound, _lasting(data["phonemes"], 1000.0 * len(sound) / data["rate"])


def _lasting(events: list[tuple[float, str]], end_ms: float) -> list[tuple[str, float]]:
    """Return phonemes with their seconds from events with their beginnings, milliseconds; silence has no name."""
    found: list[tuple[str, float]] = []
    starts = [(start, name or "sil") for start, name in events if not name.startswith("(")]  # "(en)": another language
    if not starts or starts[0][0] > 0:
        starts.insert(0, (0.0, "sil"))
    for (start, name), (after, _) in zip(starts, [*starts[1:], (end_ms, "")], strict=True):
        if after > start:
            found.append((name, (after - start) / 1000.0))
    return found
