"""Validation of a clone that another booth lends, before any page receives it.

Nothing of it is written; it is gone with the other booth's link, at the latest.
"""

from __future__ import annotations

import io
from collections.abc import Mapping
from typing import Any, Final

import numpy as np
from PIL import Image

from cloner.crowd.clones.cast import ATLAS_PX, SHELL_PX
from cloner.crowd.clones.faces import face_wedges
from cloner.crowd.clones.levels import BodyLevels, read_budgets
from cloner.crowd.packs.files import unpack_arrays
from cloner.crowd.packs.told import find_invalid_newcomer
from cloner.crowd.staged.footing import CLIP_STEP
from cloner.errors import ClonerError, printable
from cloner.scenes.served.newcomers import Newcomer

#: Sides of its pictures, width and height, pixels.
PICTURES: Final = {
    "atlas.webp": (ATLAS_PX, ATLAS_PX), "codes.webp": (ATLAS_PX, ATLAS_PX), "shell.webp": (2 * SHELL_PX, 2 * SHELL_PX),
}  # fmt: skip
FILES: Final = ("numbers.bin", *PICTURES)
#: Bones more than a clone in simulated cloth has, and metres that no foot is away from its body.
MOST_BONES: Final = 400
FARTHEST_M: Final = 10.0


def offer_facts(facts: Mapping[str, Any]) -> dict[str, Any]:
    """Return the facts of a pack that :func:`~cloner.scenes.served.newcomers.make_newcomer` reads, without names."""
    own = facts["people"][0]
    clips = [{"name": one["name"]} for one in own["clips"]]
    return {
        "people": [{"clips": clips, "stamp": own["stamp"], "views": own["views"]}],
        "impostors": {"poses": facts["impostors"]["poses"]},
        "switch": {"texels_per_m": facts["switch"]["texels_per_m"]},
        "numbers": {"loose": facts["numbers"]["loose"]},
        **({"faces": {}} if "faces" in facts else {}),
    }  # fmt: skip


def parse_clone(row: Any, files: Mapping[str, bytes], facts: Mapping[str, Any], body: BodyLevels) -> Newcomer:
    """Return another booth's clone, if the pages of this pack can show it.

    Parameters
    ----------
    row : Any
        What the other booth says of it, as :class:`Newcomer` has it.
    files : mapping of bytes
        Of the names `FILES`.
    facts, body
        The pack's.

    Raises
    ------
    ClonerError
        If anything of it is no clone's, or another pack's.
    """
    faced = "faces" in facts
    wrong = find_invalid_newcomer(row, faces=faced)
    if wrong:
        raise _refusal(wrong)
    if set(files) != set(FILES):
        raise _refusal("files")
    for name, size in PICTURES.items():
        if _size(files[name]) != size:
            raise _refusal(name)
    try:
        arrays = unpack_arrays(files["numbers.bin"], row["arrays"])
    except ValueError as error:
        raise _refusal("numbers.bin") from error
    frames = arrays["clips"][:, 0]
    loose = len(arrays["vertices"]) - len(body.vertex)
    fits = (
        loose >= 0
        and len(arrays["loose"]) == 2 * loose
        and len(arrays["corners"]) == 3 * sum(read_budgets(facts["numbers"]["loose"]))
        and (not loose or arrays["corners"].max() < loose)
        and all(np.isfinite(arrays[name]).all() for name in ("table", "touches", "clips"))
        and len(frames) == len(arrays["touches"]) == len(facts["people"][0]["clips"])
        and ((frames >= 1) & (frames < CLIP_STEP) & (frames == np.floor(frames))).all()
        and (arrays["clips"][:, 1] > 0.05).all()
        and len(arrays["bones"]) == frames.sum()
        and arrays["bones"].shape[1] <= MOST_BONES
        and np.abs(arrays["touches"]).max() < FARTHEST_M
        and (not faced or arrays["moves"].shape[1] == len(face_wedges(body)))
    )
    if not fits:
        raise _refusal("numbers.bin")
    data = {"arrays": row["arrays"], "stature_m": float(row["stature_m"])}
    return Newcomer(dict(files), data, arrays["touches"], arrays["clips"])


def _size(data: bytes) -> tuple[int, int]:
    """Return a WebP file's width and height, (0, 0) for anything else."""
    try:
        with Image.open(io.BytesIO(data), formats=["WEBP"]) as image:
            return image.size
    except (OSError, ValueError, SyntaxError, Image.DecompressionBombError):
        return 0, 0


def _refusal(name: str) -> ClonerError:
    hint = "Both booths need the same version of Cloner"
    return ClonerError(f"a clone from another booth is unfit: {printable(name)}", hint, "lent")
