"""Mouth shapes of speech, from its sound or from its phonemes.

Sound: per frame the linear prediction of the signal, its pitch and its zero crossings (the tutorial's features). They
tell vowels by their first two formants, hissing by its brightness, and closures by silence between sounds. No word is
understood.

References
----------
Tutorial "Inhabited Virtual Heritage", Eurographics 2001, speech. G. Peterson, H. Barney 1952 (formants of vowels).
"""

from __future__ import annotations

import io
import struct
import warnings
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path
from types import MappingProxyType
from typing import Final

import numpy as np
from numpy.typing import NDArray
from scipy.io import wavfile
from scipy.linalg import solve_toeplitz
from scipy.ndimage import gaussian_filter1d
from scipy.signal import resample_poly

from cloner.errors import ClonerError
from cloner.motion.contact import runs
from cloner.outside import UnfitFile, read_outside, text_outside
from cloner.records.arrays import freeze

Array = NDArray[np.float64]

#: Samples a second, length and step of a frame, order of the linear prediction and range of voices: usual in the
#: analysis of speech, not tried against others.
RATE_HZ: Final = 16_000
FRAME_S: Final = 0.025
STEP_S: Final = 0.01
LPC_ORDER: Final = 14
PITCH_HZ: Final = (70.0, 400.0)
#: Longest speech, seconds (taste).
LONGEST_S: Final = 600.0
#: What scipy raises over headers that are damaged; a NameError where it finds no samples (1.17).
_BROKEN: Final = (
    OSError, ValueError, EOFError, ArithmeticError, MemoryError, TypeError, LookupError, NameError, struct.error,
)  # fmt: skip
RATES_HZ: Final = (1_000, 400_000)  # of any microphone
LARGEST_BYTES: Final = 10_000_000  # of a list of phonemes
LARGEST_SOUND_BYTES: Final = 500_000_000  # ten minutes of two channels of 32 bits at 96 kHz
VISEMES: Final = ("sil", "PP", "FF", "TH", "DD", "kk", "CH", "SS", "nn", "RR", "aa", "E", "I", "O", "U")
#: First and second formant of the vowels, hertz, between men's and women's.
_VOWELS: Final[Mapping[str, tuple[float, float]]] = MappingProxyType({
    "aa": (780.0, 1250.0), "E": (570.0, 1950.0), "I": (310.0, 2450.0), "O": (560.0, 900.0), "U": (350.0, 950.0),
    "RR": (490.0, 1400.0), "nn": (260.0, 1500.0),
})  # fmt: skip
_VOWEL_BARK: Final = 1.0  # spread of a vowel's formants between people, Bark
#: Higher than this no vowel has its first formant; what is found there is the second one, hertz.
HIGHEST_FIRST_HZ: Final = 1000.0
MERGED_FIRST_HZ: Final = 300.0
#: Against the loudest frames: nasals hum below this, and their spectrum's middle lies below that, hertz; weaker than
#: the last are only closing consonants. Read off two synthetic voices.
HUM: Final = 0.45
HUM_HZ: Final = 450.0
WEAK: Final = 0.17
FAINT: Final = 0.09
BURST_HZ: Final = 2600.0
_QUIET: Final = 0.02  # of the loudest frames: silence
_CLOSURE_S: Final = 0.16  # shorter silences between sounds are closed lips or a stopped tongue
_HEARD_S: Final = 0.015  # what a net hears from one hundredth second to the next is evened over this time
_MUST_MEET: Final = 2.0
#: From one phoneme's shape to the next a mouth goes within this time of their border, seconds, or middle to middle.
_GLIDE_S: Final = 0.08
#: Lips stay shut for a p, b or m from this long before its middle to this long after, seconds, so that 30 pictures a
#: second show it, and lower lip and teeth meet for an f or v; they come and go within `_SHUTS_S`.
_SHUT_S: Final = MappingProxyType({"PP": 0.03, "FF": 0.015})
_SHUTS_S: Final = 0.04
#: Consonants that leave the lips free take so much of the rounding of a vowel beside them; taste.
_ROUNDED: Final = 0.35
_FREE: Final = ("TH", "DD", "kk", "CH", "SS", "nn", "RR")
#: ARPAbet phonemes by mouth shape.
_PHONEMES: Final[Mapping[str, str]] = MappingProxyType({
    "sil": "SIL SP", "PP": "P B M", "FF": "F V", "TH": "TH DH", "DD": "T D", "kk": "K G NG HH", "CH": "CH JH SH ZH",
    "SS": "S Z", "nn": "N L", "RR": "R ER", "aa": "AA AE AH AY AW", "E": "EH EY", "I": "IH IY Y", "O": "OW AO OY",
    "U": "UW UH W",
})  # fmt: skip
_VISEME_OF: Final = {phoneme: viseme for viseme, row in _PHONEMES.items() for phoneme in row.split()}
#: The alphabet of phonetics (IPA), without length and stress; what has two letters goes before its first letter.
_IPA: Final[Mapping[str, str]] = MappingProxyType({
    "PP": "p b m ɱ", "FF": "f v pf ʋ", "TH": "θ ð", "DD": "t d ɾ ʈ ɖ", "kk": "k ɡ g ŋ x ç h ɦ ɣ χ ʔ q c ɟ",
    "CH": "tʃ dʒ ʃ ʒ tɕ ɕ", "SS": "s z ts dz", "nn": "n l ɫ ɲ ʎ ɬ", "RR": "r ɹ ɻ ʁ ʀ ɚ ɝ ɜ", "aa": "a ɑ æ ʌ ɐ ä",
    "E": "e ɛ ə ɘ", "I": "i ɪ ᵻ j ɨ ɯ", "O": "o ɔ ɒ ø œ ɵ ɤ", "U": "u ʊ w y ʏ ʉ ɥ",
})  # fmt: skip
_IPA_OF: Final = {phoneme: viseme for viseme, row in _IPA.items() for phoneme in row.split()}


@dataclass(frozen=True, slots=True, eq=False)
class SpeechFrames:
    """What is measured of sound, one row every `STEP_S` seconds.

    Attributes
    ----------
    energy : (F,) root mean square
    crossings : (F,) share of samples at which the sign changes
    pitch_hz : (F,) 0 where the sound has none
    lpc : (F, LPC_ORDER) coefficients of the linear prediction
    brightness_hz : (F,) middle of the spectrum
    """

    energy: Array
    crossings: Array
    pitch_hz: Array
    lpc: Array
    brightness_hz: Array

    def __post_init__(self) -> None:
        count = len(self.energy)
        freeze(
            self,
            energy=(np.float64, (count,)),
            crossings=(np.float64, (count,)),
            pitch_hz=(np.float64, (count,)),
            lpc=(np.float64, (count, LPC_ORDER)),
            brightness_hz=(np.float64, (count,)),
        )


def read_wav(path: Path) -> Array:
    """Return the sound of a WAV file as one channel of `RATE_HZ` samples a second, -1..1.

    Raises
    ------
    ClonerError
        If the file is missing, no WAV, silent or longer than ten minutes.
    """
    try:
        with warnings.catch_warnings():
            warnings.simplefilter("ignore", wavfile.WavFileWarning)  # of chunks nobody needs
            rate, data = wavfile.read(io.BytesIO(read_outside(path, LARGEST_SOUND_BYTES)))
        if not RATES_HZ[0] <= rate <= RATES_HZ[1] or data.dtype.kind not in "uif" or data.dtype.itemsize > 8:
            raise ValueError(f"{rate} samples a second of {data.dtype}")
    except UnfitFile as error:
        told = f"the sound cannot be read: {error.strerror}"
        raise ClonerError(told, "Give a .wav file with 16-bit samples, cut into pieces", path.name) from error
    except _BROKEN as error:
        raise ClonerError("the sound cannot be read", "Give a .wav file with 16-bit samples", path.name) from error
    if len(data) / rate > LONGEST_S:
        raise ClonerError(f"the sound is longer than {LONGEST_S / 60:.0f} minutes", "Cut it into pieces", path.name)
    sound = np.asarray(data, dtype=np.float64)
    if data.dtype.kind == "u":
        sound = sound - 128.0
    if sound.ndim == 2:
        sound = sound.mean(axis=1)
    if len(sound) < RATE_HZ * FRAME_S or not 0.0 < np.abs(sound).max() < np.inf:  # neither nan
        raise ClonerError("there is nothing to hear in the sound", "Record it again", path.name)
    divisor = int(np.gcd(rate, RATE_HZ))
    sound = resample_poly(sound, RATE_HZ // divisor, rate // divisor)
    return np.asarray(sound / np.abs(sound).max())


def frame_features(sound: Array) -> SpeechFrames:
    """Return the features of a sound of `RATE_HZ` samples a second."""
    size, step = int(FRAME_S * RATE_HZ), int(STEP_S * RATE_HZ)
    count = max((len(sound) - size) // step + 1, 1)
    padded = np.pad(sound, (0, max(size + (count - 1) * step - len(sound), 0)))
    frames = np.lib.stride_tricks.sliding_window_view(padded, size)[::step][:count]
    energy = np.sqrt((frames**2).mean(axis=1))
    crossings = (np.diff(np.signbit(frames), axis=1)).mean(axis=1)
    power = np.abs(np.fft.rfft(frames * np.hanning(size), 2 * size)) ** 2
    hertz = np.fft.rfftfreq(2 * size, 1.0 / RATE_HZ)
    brightness = (power * hertz).sum(axis=1) / np.maximum(power.sum(axis=1), 1e-12)
    sharpened = np.diff(padded, prepend=0.0) * 0.95 + 0.05 * padded  # voices lose 6 dB an octave at the lips
    whitened = np.lib.stride_tricks.sliding_window_view(sharpened, size)[::step][:count] * np.hamming(size)
    return SpeechFrames(energy, crossings, _pitch(frames), np.array([_lpc(row) for row in whitened]), brightness)


def _lpc(frame: Array) -> Array:
    """Return the coefficients of the linear prediction of one windowed frame (autocorrelation method)."""
    correlation = np.correlate(frame, frame, "full")[len(frame) - 1 : len(frame) + LPC_ORDER]
    if correlation[0] < 1e-9:
        return np.zeros(LPC_ORDER)
    correlation[0] *= 1.0001
    return np.asarray(solve_toeplitz(correlation[:-1], correlation[1:]))


def _pitch(frames: Array) -> Array:
    """Return (F,) pitches, hertz, 0 where the strongest repetition explains less than a third of the energy."""
    spectrum = np.fft.rfft(frames - frames.mean(axis=1, keepdims=True), 2 * frames.shape[1])
    repeated = np.fft.irfft(np.abs(spectrum) ** 2)[:, : frames.shape[1]]
    first, last = int(RATE_HZ / PITCH_HZ[1]), int(RATE_HZ / PITCH_HZ[0])
    lag = first + repeated[:, first:last].argmax(axis=1)
    strength = repeated[np.arange(len(frames)), lag] / np.maximum(repeated[:, 0], 1e-12)
    return np.where(strength > 0.33, RATE_HZ / lag, 0.0)


def formants(lpc: Array) -> tuple[float, float]:
    """Return the first two formants of a linear prediction, hertz; 0 where there is none."""
    roots = np.roots(np.concatenate([[1.0], -lpc]))
    roots = roots[(roots.imag > 0.0) & (np.abs(roots) > 0.7)]
    hertz = np.sort(np.angle(roots) * RATE_HZ / (2.0 * np.pi))
    hertz = hertz[(hertz > 180.0) & (hertz < 3800.0)]
    if len(hertz) < 2:
        return 0.0, 0.0
    if hertz[0] > HIGHEST_FIRST_HZ:  # a low first formant has merged with the voice
        return MERGED_FIRST_HZ, float(hertz[0])
    return float(hertz[0]), float(hertz[1])


def _bark(hertz: Array) -> Array:
    return np.asarray(26.81 * hertz / (1960.0 + hertz) - 0.53)


def sound_visemes(frames: SpeechFrames) -> Array:
    """Return (F, 15) shares of the mouth shapes; rows sum to one."""
    shares = np.zeros((len(frames.energy), len(VISEMES)))
    loud = frames.energy / np.percentile(frames.energy, 98)
    silent = loud < _QUIET
    vowels = list(_VOWELS)
    places = _bark(np.array([_VOWELS[name] for name in vowels]))
    for row in range(len(shares)):
        if silent[row]:
            shares[row, 0] = 1.0
        elif made := _consonant(frames, row, float(loud[row])):
            shares[row, [VISEMES.index(name) for name in made]] = 1.0 / len(made)
        else:
            away = ((places - _bark(np.array(formants(frames.lpc[row])))) ** 2).sum(axis=1)
            own = np.exp(-0.5 * (away - away.min()) / _VOWEL_BARK**2)
            shares[row, [VISEMES.index(name) for name in vowels]] = own / own.sum()
    for first, last in runs(silent):
        inside = first > 0 and last < len(silent) - 1
        if inside and (last - first + 1) * STEP_S < _CLOSURE_S:
            shares[first : last + 1] = 0.0
            shares[first : last + 1, [VISEMES.index("PP"), VISEMES.index("DD")]] = (0.7, 0.3)
    return shares


def _consonant(frames: SpeechFrames, row: int, loud: float) -> tuple[str, ...]:
    """Return the mouth shapes that a frame between vowels may come from, none for a vowel.

    A closed mouth hums: what is voiced and dull is a nasal, or more quietly a voiced stop or lip's buzz.
    """
    bright, voiced = float(frames.brightness_hz[row]), frames.pitch_hz[row] > 0.0
    if frames.crossings[row] > 0.22 and (not voiced or bright > 3000.0):
        return _hiss(bright, loud)
    if not voiced and loud < WEAK:
        return ("DD", "kk", "PP")
    if voiced and loud < WEAK:
        return ("SS", "TH") if frames.crossings[row] > 0.27 else ("PP", "FF", "TH", "DD", "kk")
    return ("PP", "nn") if bright < HUM_HZ and loud < HUM else ()


def _hiss(brightness_hz: float, loud: float) -> tuple[str, ...]:
    """Return the shapes a hiss may come from: faint ones from the teeth on lip or tongue, dull ones from a burst."""
    if loud < FAINT:
        return ("FF", "TH")
    if brightness_hz < BURST_HZ:
        return ("kk", "CH")
    return ("SS", "DD") if brightness_hz > 4800.0 and loud < WEAK else ("SS",) if brightness_hz > 4800.0 else ("CH",)


def viseme_of(phoneme: str) -> str:
    """Return the mouth shape of a phoneme, in ARPAbet or in the alphabet of phonetics (IPA).

    Raises
    ------
    ClonerError
        If the phoneme is not known.
    """
    found = _VISEME_OF.get(phoneme.rstrip("012").upper())
    for letters in (phoneme[:2], phoneme[:1]):
        found = found or _IPA_OF.get(letters)
    if found is None:
        hint = f"Use IPA or ARPAbet: {' '.join(_VISEME_OF)}"
        raise ClonerError(f"the phoneme {phoneme!r} is not known", hint, "phonemes")
    return found


def phoneme_visemes(phonemes: Sequence[tuple[str, float]]) -> Array:
    """Return (F, 15) shares of the mouth shapes of phonemes with their lengths in seconds; each leads at its middle.

    Raises
    ------
    ClonerError
        If a phoneme is not known or a length is not between 0 and 10 seconds.
    """
    shapes: list[int] = []
    for phoneme, seconds in phonemes:
        shapes.append(VISEMES.index(viseme_of(phoneme)))
        if not 0.0 < seconds <= 10.0:
            raise ClonerError(f"{phoneme} lasts {seconds} s", "Give lengths between 0 and 10 seconds", "phonemes")
    if not shapes:
        raise ClonerError("there is no phoneme", 'Write lines like "AA1 0.12"', "phonemes")
    lengths = np.array([seconds for _, seconds in phonemes])
    if lengths.sum() > LONGEST_S:
        raise ClonerError(f"they last longer than {LONGEST_S / 60:.0f} minutes", "Cut them", "phonemes")
    return _glided(shapes, lengths)


def _glided(shapes: Sequence[int], lengths: Array) -> Array:
    """Return (F, 15) shares that go from every shape to the next in a half wave about their border."""
    ends = np.cumsum(lengths)
    times = (np.arange(max(round(float(ends[-1]) / STEP_S), 1)) + 0.5) * STEP_S
    shares = np.zeros((len(times), len(VISEMES)))
    half = np.minimum(lengths / 2.0, _GLIDE_S)
    rising = np.ones_like(times)
    for number, shape in enumerate(shapes):
        falling = np.ones_like(times)
        if number + 1 < len(shapes):
            first, last = ends[number] - half[number], ends[number] + half[number + 1]
            place = np.clip((times - first) / (last - first), 0.0, 1.0)
            falling = 0.5 + 0.5 * np.cos(np.pi * place)
        own = rising * falling
        beside = [shapes[near] for near in (number - 1, number + 1) if 0 <= near < len(shapes)]
        rounds = [near for near in beside if VISEMES[near] in ("O", "U")]
        if rounds and VISEMES[shape] in _FREE:
            shares[:, rounds[-1]] += _ROUNDED * own
            own = (1.0 - _ROUNDED) * own
        shares[:, shape] += own
        rising = 1.0 - falling
    return np.asarray(shares / shares.sum(axis=1, keepdims=True))


def read_phonemes(path: Path) -> list[tuple[str, float]]:
    """Return the phonemes of a text file: one a line with its length in seconds, "AA1 0.12".

    Raises
    ------
    ClonerError
        If the file is missing or a line is not that.
    """
    text = text_outside(path, "the phonemes", "Give a text file", LARGEST_BYTES)
    try:
        lines = [line.split() for line in text.splitlines() if line.strip()]
        return [(line[0], float(line[1])) for line in lines]
    except (ValueError, IndexError) as error:
        raise ClonerError(
            "a line holds no phoneme with its seconds", 'Write lines like "AA1 0.12"', path.name
        ) from error


def mouth_weights(shares: Array, frames_per_s: float) -> tuple[Array, dict[str, Array]]:
    """Return times (F,), seconds, and the weights of the viseme targets: lips that meet do so wholly and in time."""
    shut = _shut(shares)
    duration = len(shares) * STEP_S
    times = np.arange(round(duration * frames_per_s) + 1) / frames_per_s
    own = (np.arange(len(shares)) + 0.5) * STEP_S
    weights = {
        f"viseme_{name}": np.interp(times, own, shut[:, column]) for column, name in enumerate(VISEMES) if column > 0
    }
    for values in weights.values():
        values[[0, -1]] = 0.0  # a mouth begins and ends at rest
    return times, weights


def _shut(shares: Array) -> Array:
    """Return the shares with every closure whole: at its middle nothing else moves the lips."""
    out, times = shares.copy(), (np.arange(len(shares)) + 0.5) * STEP_S
    leads = shares.argmax(axis=1)
    for name, half in _SHUT_S.items():
        column = VISEMES.index(name)
        closed = np.zeros(len(shares))
        for first, last in runs(leads == column):
            away = np.abs(times - (times[first] + times[last]) / 2.0)
            closed = np.maximum(closed, np.clip((half + _SHUTS_S - away) / _SHUTS_S, 0.0, 1.0))
        out *= 1.0 - closed[:, None]
        out[:, column] = np.maximum(out[:, column] + closed, closed)
    return np.asarray(np.clip(out, 0.0, 1.0))


def smoothed(shares: Array) -> Array:
    """Return shares that were heard, as smooth as mouths move; lips that may meet count double: they must not gape."""
    weighed = shares * np.where(np.isin(VISEMES, list(_SHUT_S)), _MUST_MEET, 1.0)
    weighed /= weighed.sum(axis=1, keepdims=True)
    return np.asarray(gaussian_filter1d(weighed, _HEARD_S / STEP_S, axis=0, mode="nearest"))
