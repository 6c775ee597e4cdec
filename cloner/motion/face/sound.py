"""Mouth shapes of speech from its sound.

Per frame the linear prediction of the signal, its pitch and its zero crossings (the tutorial's features). They tell
vowels by their first two formants, hissing by its brightness, and closures by silence between sounds. No word is
understood.

References
----------
Tutorial "Inhabited Virtual Heritage", Eurographics 2001, speech. G. Peterson, H. Barney 1952 (formants of vowels).
"""

from __future__ import annotations

import io
import struct
import warnings
import wave
from collections.abc import Mapping
from dataclasses import dataclass
from pathlib import Path
from types import MappingProxyType
from typing import Final

import numpy as np
from numpy.typing import NDArray
from scipy.io import wavfile
from scipy.linalg import solve_toeplitz
from scipy.signal import resample_poly

from cloner.errors import ClonerError
from cloner.motion.face.speech import LONGEST_S, STEP_S, VISEMES
from cloner.motion.moves.contact import runs
from cloner.records.arrays import Array, freeze
from cloner.untrusted import UnsuitableFile, read_untrusted

#: Samples a second, length of a frame, order of the linear prediction and range of voices: usual in the
#: analysis of speech, not tried against others.
RATE_HZ: Final = 16_000
FRAME_S: Final = 0.025
LPC_ORDER: Final = 14
PITCH_HZ: Final = (70.0, 400.0)
#: What scipy raises over headers that are damaged; a NameError where it finds no samples (1.17).
_BROKEN: Final = (
    OSError, ValueError, EOFError, ArithmeticError, MemoryError, TypeError, LookupError, NameError, struct.error,
)  # fmt: skip
RATES_HZ: Final = (1_000, 400_000)  # of any microphone
LARGEST_SOUND_BYTES: Final = 500_000_000  # ten minutes of two channels of 32 bits at 96 kHz
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


def resampled(rate: int, sound: Array) -> Array:
    """Return sound of ``rate`` samples a second as one of `RATE_HZ`, -1..1."""
    divisor = int(np.gcd(rate, RATE_HZ))
    sound = resample_poly(sound, RATE_HZ // divisor, rate // divisor)
    return np.asarray(sound / np.abs(sound).max())


def read_sound(path: Path) -> tuple[int, Array]:
    """Return the samples a second of a WAV file and its sound as one channel, in the file's own units.

    Raises
    ------
    ClonerError
        If the file is missing, no WAV, silent or longer than ten minutes.
    """
    try:
        with warnings.catch_warnings():
            warnings.simplefilter("ignore", wavfile.WavFileWarning)  # of chunks nobody needs
            rate, data = wavfile.read(io.BytesIO(read_untrusted(path, LARGEST_SOUND_BYTES)))
        if not RATES_HZ[0] <= rate <= RATES_HZ[1] or data.dtype.kind not in "uif" or data.dtype.itemsize > 8:
            raise ValueError(f"{rate} samples a second of {data.dtype}")
    except UnsuitableFile as error:
        message = f"the sound cannot be read: {error.strerror}"
        raise ClonerError(message, "Give a .wav file with 16-bit samples, cut into pieces", path.name) from error
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
    return int(rate), sound


def wav_bytes(samples: NDArray[np.floating], rate_hz: int) -> bytes:
    """Return (N,) or (N, channels) samples, -1..1, as a WAV file of 16 bits."""
    stream = io.BytesIO()
    with wave.open(stream, "wb") as file:
        file.setnchannels(samples.shape[1] if samples.ndim > 1 else 1)
        file.setsampwidth(2)
        file.setframerate(rate_hz)
        file.writeframes(np.rint(samples * 32767.0).astype("<i2").tobytes())
    return stream.getvalue()


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
