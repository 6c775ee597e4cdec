"""The shipped statistics of measures: bodies, clothes and errors of the fit; no sample visitor took part.

``benchmarks/measure_table.py`` writes it from the people of ``benchmarks/measure_samples.py``.
"""

from __future__ import annotations

import functools
import importlib.resources
from dataclasses import fields

import numpy as np

from cloner.geometry.measurement.measuring import ALL_KEYS
from cloner.geometry.measurement.prior import MeasurePrior

FILE = "measures.npz"


@functools.cache
def load_measure_prior() -> MeasurePrior:
    """Return the table, in the order of `ALL_KEYS`.

    Raises
    ------
    ValueError
        If the table was made for other measures.
    """
    place = importlib.resources.files("cloner_models") / FILE
    with place.open("rb") as stream, np.load(stream, allow_pickle=False) as archive:
        if tuple(archive["keys"].tolist()) != ALL_KEYS:
            raise ValueError(f"{FILE} was made for other measures: run benchmarks/measure_table.py")
        arrays = {field.name: archive[field.name] for field in fields(MeasurePrior)}
        temper, gap_mm = float(arrays.pop("temper")), float(arrays.pop("gap_mm"))
        garment = arrays.pop("garment")
        return MeasurePrior(**arrays, garment=garment, temper=temper, gap_mm=gap_mm)
