"""Names and states in plain words."""

from __future__ import annotations

from collections.abc import Collection
from typing import Final

from cloner.frames import BODY_VIEWS, FACE_VIEWS, ViewId
from cloner.refitting import Refitted

_SIDES: Final = {"L": "left", "R": "right", "left": "left", "right": "right"}
_FIRST: Final = {"l": "left", "r": "right"}
VIEW_TITLES: Final = {
    ViewId.BODY_FRONT: "Body, front",
    ViewId.BODY_SIDE: "Body, side",
    ViewId.BODY_BACK: "Body, back",
    ViewId.FACE_FRONT: "Face, front",
    ViewId.FACE_SIDE: "Face, side",
}
#: What the progress bar says for a step's name.
STEPS: Final = {
    "photos": "Reading the photos",
    "proposals": "Finding the person in the photos",
    "points": "Placing feature points",
    "views": "Placing the cameras",
    "silhouettes": "Drawing outlines",
    "phenotype": "Choosing the nearest build and pose",
    "skeleton": "Fitting the skeleton",
    "rough": "Fitting the body",
    "fine": "Fitting the outlines",
    "head": "Fitting the head",
    "join": "Joining head and body",
    "obeyed": "Following corrected points",
    "measures": "Measuring the body",
    "hair": "Growing the hair",
    "textures": "Painting skin and clothes",
    "regions": "Telling skin from clothes",
    "export": "Writing the files",
    "previews": "Drawing previews",
    "report": "Writing the report",
    "done": "Done",
}


def spoken(name: str) -> str:
    """Return a point's name as people say it: ``eye_inner_L`` is "eye inner, left"."""
    words = name.split("_")
    if len(words) > 1 and words[-1] in _SIDES:
        return f"{' '.join(words[:-1])}, {_SIDES[words[-1]]}"
    if len(words) > 1 and words[0] in _FIRST:
        return f"{' '.join(words[1:])}, {_FIRST[words[0]]}"
    return " ".join(words)


def spoken_step(step: str) -> str:
    """Return what a step does."""
    return STEPS.get(step, step.capitalize())


def spoken_refit(refitted: Refitted) -> str:
    """Return what became of the corrected points on the last clone's body."""
    failed = [f"{VIEW_TITLES[one.view]}, {spoken(one.name)}: {one.note}." for one in refitted.obeyed if one.is_missed]
    told = " ".join(failed) or "The body follows; hair and textures will when you clone again."
    return told if refitted.is_whole else f"{told} Clone again: this changes more than is shown."


def what_is_missing(views: Collection[ViewId]) -> str:
    """Return what the photos of a folder allow, and what is missing for more."""
    missing = [view for view in ViewId if view not in views]
    if not missing:
        return "All five photos are here."
    if not views:
        return "No photos yet. Choose or drop the folder that holds them."
    names = ", ".join(f"{view}.jpg" for view in missing)
    if not any(view in views for view in BODY_VIEWS):
        return f"Only the head can be cloned, on a body of matching build. Missing: {names}."
    if not any(view in views for view in FACE_VIEWS):
        return f"The face will come from the body photos and be coarse. Missing: {names}."
    return f"The clone will be less exact. Missing: {names}."
