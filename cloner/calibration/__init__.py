"""Calibrated numbers as data: one file a room, one entry a number.

A file is named for its room and holds a table a module: ``body.toml``'s ``[bone_checks.longest]`` is read in
``cloner/body/bone_checks.py``. An entry says its value, its unit (`cloner.calibration.loader.UNITS`), what it is, where
it comes from in one word (`cloner.calibration.loader.ORIGINS`) and in a sentence, and the commit that brought it.
What fills arrays lies in ``cloner_models/*.npz`` and is learnt by ``generic_models/build/calibrate_*.py``.
"""
