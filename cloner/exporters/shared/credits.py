"""Credits in every exported file."""

from __future__ import annotations

from typing import Final

GENERIC_CREDITS: Final = "Generic human, weights and face units: MakeHuman community, CC0 1.0"
CREDITS: Final = f"Made by Cloner (photo-cloner, Apache-2.0) from the person's photographs. {GENERIC_CREDITS}."
