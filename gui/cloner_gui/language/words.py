"""Names and states in plain words, in the window's language."""

from __future__ import annotations

from collections.abc import Collection, Iterator, Mapping
from typing import Final

from PySide6.QtCore import QT_TRANSLATE_NOOP, QCoreApplication, QTranslator

from cloner.booth.photos.photo_problems import PhotoProblem
from cloner.booth.visitors.visits import State
from cloner.frames import BODY_VIEWS, FACE_VIEWS, ViewId

#: ``translate("page", "Text")``: Qt's own tools find these calls and write them into the translators' files.
translate = QCoreApplication.translate


class TranslatedWords(Mapping[str, str]):
    """Words by key, translated on access."""

    def __init__(self, context: str, words: Mapping[str, object]) -> None:
        self._context, self._words = context, words

    def __getitem__(self, key: str) -> str:
        """Return the words in the window's language."""
        return translate(self._context, str(self._words[key]))

    def by(self, translator: QTranslator, key: str) -> str:
        """Return the words in another language than the window's."""
        text = str(self._words[key])
        return translator.translate(self._context, text) or text

    def __iter__(self) -> Iterator[str]:
        return iter(self._words)

    def __len__(self) -> int:
        return len(self._words)


VIEW_TITLES: Final = TranslatedWords(
    "views",
    {
        ViewId.BODY_FRONT: QT_TRANSLATE_NOOP("views", "Body, front"),
        ViewId.BODY_SIDE: QT_TRANSLATE_NOOP("views", "Body, side"),
        ViewId.BODY_BACK: QT_TRANSLATE_NOOP("views", "Body, back"),
        ViewId.FACE_FRONT: QT_TRANSLATE_NOOP("views", "Face, front"),
        ViewId.FACE_SIDE: QT_TRANSLATE_NOOP("views", "Face, side"),
    },
)
#: What the progress bar says for a step's name.
STEPS: Final = TranslatedWords(
    "steps",
    {
        "look": QT_TRANSLATE_NOOP("steps", "Looking at the photo"),
        "photos": QT_TRANSLATE_NOOP("steps", "Reading the photos"),
        "proposals": QT_TRANSLATE_NOOP("steps", "Finding the person in the photos"),
        "points": QT_TRANSLATE_NOOP("steps", "Placing feature points"),
        "views": QT_TRANSLATE_NOOP("steps", "Placing the cameras"),
        "silhouettes": QT_TRANSLATE_NOOP("steps", "Drawing outlines"),
        "phenotype": QT_TRANSLATE_NOOP("steps", "Choosing the nearest build and pose"),
        "skeleton": QT_TRANSLATE_NOOP("steps", "Fitting the skeleton"),
        "rough": QT_TRANSLATE_NOOP("steps", "Fitting the body"),
        "fine": QT_TRANSLATE_NOOP("steps", "Fitting the outlines"),
        "head": QT_TRANSLATE_NOOP("steps", "Fitting the head"),
        "join": QT_TRANSLATE_NOOP("steps", "Joining head and body"),
        "obeyed": QT_TRANSLATE_NOOP("steps", "Following corrected points"),
        "measures": QT_TRANSLATE_NOOP("steps", "Measuring the body"),
        "hair": QT_TRANSLATE_NOOP("steps", "Growing the hair"),
        "textures": QT_TRANSLATE_NOOP("steps", "Painting skin and clothes"),
        "regions": QT_TRANSLATE_NOOP("steps", "Telling skin from clothes"),
        "export": QT_TRANSLATE_NOOP("steps", "Writing the files"),
        "previews": QT_TRANSLATE_NOOP("steps", "Drawing previews"),
        "report": QT_TRANSLATE_NOOP("steps", "Writing the report"),
        "copy": QT_TRANSLATE_NOOP("steps", "Copying"),
        "body": QT_TRANSLATE_NOOP("steps", "Making the body"),
        "arrange": QT_TRANSLATE_NOOP("steps", "Cutting the pieces"),
        "sew": QT_TRANSLATE_NOOP("steps", "Sewing and hanging"),
        "cloth": QT_TRANSLATE_NOOP("steps", "Walking in it"),
        "loop": QT_TRANSLATE_NOOP("steps", "Closing the loop"),
        "verify": QT_TRANSLATE_NOOP("steps", "Reading back what was written"),
        "done": QT_TRANSLATE_NOOP("steps", "Done"),
    },
)
#: One sentence each: what is wrong with a photo and what to do, for an operator with the visitor still there.
TROUBLES: Final = TranslatedWords(
    "troubles",
    {
        PhotoProblem.NOBODY: QT_TRANSLATE_NOOP(
            "troubles", "Nobody was found: take it again with the person in full view."
        ),
        PhotoProblem.SEVERAL: QT_TRANSLATE_NOOP(
            "troubles", "More than one person: take it again with one person alone."
        ),
        PhotoProblem.LYING: QT_TRANSLATE_NOOP("troubles", "The person lies on the side: turn the photo."),
        PhotoProblem.NO_VIEW: QT_TRANSLATE_NOOP(
            "troubles", "It shows none of the five views: turn the person or retake."
        ),
        PhotoProblem.OTHER_VIEW: QT_TRANSLATE_NOOP("troubles", "It does not show this view: exchange or retake it."),
        PhotoProblem.CUT: QT_TRANSLATE_NOOP("troubles", "The person is cut off: step back and retake."),
        PhotoProblem.SMALL: QT_TRANSLATE_NOOP("troubles", "The person is small: step nearer or zoom in."),
        PhotoProblem.BLURRED: QT_TRANSLATE_NOOP("troubles", "It is blurred: hold still, focus and retake."),
        PhotoProblem.DARK: QT_TRANSLATE_NOOP("troubles", "It is dark: add light or expose longer."),
        PhotoProblem.BRIGHT: QT_TRANSLATE_NOOP("troubles", "It is burnt out: less light or a shorter exposure."),
    },
)
STATES: Final = TranslatedWords(
    "states",
    {
        State.NONE: QT_TRANSLATE_NOOP("states", "in progress"),
        State.WAITING: QT_TRANSLATE_NOOP("states", "waiting for the clone"),
        State.CLONED: QT_TRANSLATE_NOOP("states", "cloned"),
        State.FAILED: QT_TRANSLATE_NOOP("states", "not cloned: look at the photos"),
    },
)
#: Who may use a visitor's files, by licence; and what that means.
LICENCE_NAMES: Final = TranslatedWords(
    "licences",
    {
        "own": QT_TRANSLATE_NOOP("licences", "the visitor alone"),
        "event": QT_TRANSLATE_NOOP("licences", "visitor and event"),
        "everyone": QT_TRANSLATE_NOOP("licences", "everybody"),
    },
)
LICENCE_MEANINGS: Final = TranslatedWords(
    "licences",
    {
        "own": QT_TRANSLATE_NOOP("licences", "Nobody else may use the files or earn money with them."),
        "event": QT_TRANSLATE_NOOP("licences", "The event may use the files too, also in its advertising."),
        "everyone": QT_TRANSLATE_NOOP(
            "licences", "Everybody may use the files, change them and pass them on, but not earn money with them."
        ),
    },
)
#: What visitors agree to, unless the event has a text of its own.
CONSENT: Final = str(
    QT_TRANSLATE_NOOP(
        "consent",
        "I agree that photos of me are taken here, that a three-dimensional likeness is made of them on this computer, "
        "and that both are kept for {days} days and then deleted. I can have everything deleted at any time.",
    )
)
#: The same where an event keeps its visitors until somebody deletes them.
CONSENT_KEPT: Final = str(
    QT_TRANSLATE_NOOP(
        "consent",
        "I agree that photos of me are taken here, that a three-dimensional likeness is made of them on this computer, "
        "and that both are kept until I have them deleted. I can have everything deleted at any time.",
    )
)


def step_text(step: str) -> str:
    """Return the description of a step."""
    return STEPS.get(step or "photos", step.capitalize())


def duration_text(seconds: float) -> str:
    """Return a remaining time, no more exactly than it is known."""
    if seconds < 8:
        return translate("time", "a few seconds")
    if seconds < 90:
        return translate("time", "about {n} s").format(n=5 * round(seconds / 5))
    return translate("time", "about {n} min").format(n=round(seconds / 60))


def what_is_missing(views: Collection[ViewId]) -> str:
    """Return what the photos of a folder allow, and what is missing for more."""
    missing = [view for view in ViewId if view not in views]
    if not missing:
        return translate("photos", "All five photos are here.")
    names = "; ".join(VIEW_TITLES[view] for view in missing)
    if not views:
        return translate("photos", "No photos yet.")
    if ViewId.BODY_FRONT not in views and ViewId.FACE_FRONT not in views:
        return translate("photos", "A front photo is needed. Missing: {names}.").format(names=names)
    if not any(view in views for view in BODY_VIEWS):
        told = translate("photos", "Only the head can be cloned, on a body of matching build. Missing: {names}.")
    elif not any(view in views for view in FACE_VIEWS):
        told = translate("photos", "The face will come from the body photos and be coarse. Missing: {names}.")
    else:
        told = translate("photos", "The clone will be less exact. Missing: {names}.")
    return told.format(names=names)
