"""Sentences that come from the library in English (errors, warnings, notes), in the window's language."""

from __future__ import annotations

import functools
import re
from typing import TYPE_CHECKING, Final

from PySide6.QtCore import QT_TRANSLATE_NOOP

from cloner.errors import ClonerError
from cloner.frames import ViewId
from cloner_gui.point_names import is_point, spoken
from cloner_gui.words import VIEW_TITLES, translate

if TYPE_CHECKING:
    from cloner.refitting import Refitted


def told(sentence: str) -> str:
    """Return a sentence of the library in the window's language; one that nobody translated stays as it is."""
    found = template_of(sentence)
    if found is None:
        return sentence
    template, parts = found
    text = translate("told", template)
    for number, part in enumerate(parts, start=1):
        text = text.replace(f"%{number}", _told_part(part))
    return text


def told_error(error: ClonerError) -> str:
    """Return what is wrong and what to do, in the window's language."""
    where = VIEW_TITLES.get(error.where, "") or told(error.where)
    hint = told(error.hint)
    return f"{where}: {told(error.message)}. {hint}" + ("" if hint.endswith("?") else ".")


def told_problem(problem: str) -> str:
    """Return why a clone failed, as a visit's file keeps it (``str`` of the error), in the window's language."""
    where, _, rest = problem.partition(": ")
    message, _, hint = rest.partition(". ")
    return told_error(ClonerError(message, hint, where)) if hint else problem


def spoken_refit(refitted: Refitted) -> str:
    """Return what became of the corrected points on the last clone's body."""
    failed = [
        f"{VIEW_TITLES[one.view]}, {spoken(one.name)}: {told(one.note)}." for one in refitted.obeyed if one.is_missed
    ]
    said = " ".join(failed) or translate("points", "The body follows; hair and textures will when you clone again.")
    more = translate("points", "Clone again: this changes more than is shown.")
    return said if refitted.is_whole else f"{said} {more}"


def template_of(sentence: str) -> tuple[str, tuple[str, ...]] | None:
    """Return the known sentence that this one is, and what stands in its places; None for an unknown one."""
    if sentence in SENTENCES:
        return sentence, ()
    for template, pattern in _patterns():
        match = pattern.fullmatch(sentence)
        if match is not None:
            return template, match.groups()
    return None


def _told_part(part: str) -> str:
    if part in list(ViewId):
        return VIEW_TITLES[part]
    return spoken(part) if is_point(part) else told(part)


@functools.cache
def _patterns() -> tuple[tuple[str, re.Pattern[str]], ...]:
    """Return the sentences with places in them as patterns, those that say most themselves first."""
    open_ones = sorted((one for one in SENTENCES if "%1" in one), key=len, reverse=True)
    return tuple((one, re.compile(re.sub(r"%\d", "(.+?)", re.escape(one)))) for one in open_ones)


#: What the library may say on the booth's path, with its places for values; a test looks that none lacks.
SENTENCES: Final[tuple[str, ...]] = tuple(
    str(one)
    for one in (
        QT_TRANSLATE_NOOP("told", "its files were changed while they were read"),
        QT_TRANSLATE_NOOP("told", "the file exists and is not replaced"),
        QT_TRANSLATE_NOOP("told", "Choose another --out file, or delete it"),
        QT_TRANSLATE_NOOP("told", "no file can be called that"),
        QT_TRANSLATE_NOOP("told", "Choose another --out file"),
        QT_TRANSLATE_NOOP("told", "this is no photo but a folder, a pipe or the like"),
        QT_TRANSLATE_NOOP("told", "Put the photo itself there"),
        QT_TRANSLATE_NOOP("told", "Choose another --out folder or --id, or move those files away"),
        QT_TRANSLATE_NOOP("told", "the photos lie where the result would, and are never replaced"),
        QT_TRANSLATE_NOOP("told", "the result of another visitor is there: other photos, from another folder"),
        QT_TRANSLATE_NOOP("told", "Choose another --id or --out folder, or forget that visitor first"),
        QT_TRANSLATE_NOOP("told", "the earlier result holds files of somebody's own (%1)"),
        QT_TRANSLATE_NOOP("told", "this cannot be read: %1"),
        QT_TRANSLATE_NOOP("told", "the photo cannot be opened: %1"),
        QT_TRANSLATE_NOOP("told", "there is no camera"),
        QT_TRANSLATE_NOOP("told", "Plug it in and allow its use, then try again"),
        QT_TRANSLATE_NOOP("told", "the camera gives no pictures any more"),
        QT_TRANSLATE_NOOP("told", "Plug it in again"),
        QT_TRANSLATE_NOOP("told", 'it must be an object with "format": %1'),
        QT_TRANSLATE_NOOP("told", "a setting is out of its range"),
        QT_TRANSLATE_NOOP("told", "there is no such folder"),
        QT_TRANSLATE_NOOP("told", "Choose another, or make it first"),
        QT_TRANSLATE_NOOP("told", "this folder holds other things than visitors"),
        QT_TRANSLATE_NOOP(
            "told", "Choose an empty folder, an event's, or one with photos named body_front.jpg and so on"
        ),
        QT_TRANSLATE_NOOP("told", "the event's settings cannot be read"),
        QT_TRANSLATE_NOOP("told", "Correct %1, or move it away to start with the usual settings"),
        QT_TRANSLATE_NOOP("told", "the key %1 is not known"),
        QT_TRANSLATE_NOOP("told", "The keys are %1"),
        QT_TRANSLATE_NOOP("told", "%1 has a value of the wrong kind"),
        QT_TRANSLATE_NOOP("told", "the folder cannot be read"),
        QT_TRANSLATE_NOOP("told", "Check its permissions"),
        QT_TRANSLATE_NOOP("told", "the visitor's folder cannot be made"),
        QT_TRANSLATE_NOOP("told", "Check permissions and space"),
        QT_TRANSLATE_NOOP("told", "this is there already"),
        QT_TRANSLATE_NOOP("told", "Choose another name or place"),
        QT_TRANSLATE_NOOP("told", "it cannot be written there"),
        QT_TRANSLATE_NOOP("told", "Is the stick full or write-protected?"),
        QT_TRANSLATE_NOOP("told", "there is no photo yet"),
        QT_TRANSLATE_NOOP("told", "Take the photos first"),
        QT_TRANSLATE_NOOP("told", "no photo is stored before the visitor agreed"),
        QT_TRANSLATE_NOOP("told", "Ask the visitor and tick the consent on the first page"),
        QT_TRANSLATE_NOOP("told", "this is no photo"),
        QT_TRANSLATE_NOOP("told", "Use one of %1"),
        QT_TRANSLATE_NOOP("told", "the photo cannot be stored"),
        QT_TRANSLATE_NOOP("told", "Check the folder's permissions and space"),
        QT_TRANSLATE_NOOP("told", "the photo cannot be moved"),
        QT_TRANSLATE_NOOP("told", "the photo cannot be deleted"),
        QT_TRANSLATE_NOOP("told", "the photo cannot be turned"),
        QT_TRANSLATE_NOOP("told", "Turn it with another program"),
        QT_TRANSLATE_NOOP("told", "the text is too long for a code"),
        QT_TRANSLATE_NOOP("told", "%1 characters can be scanned"),
        QT_TRANSLATE_NOOP("told", "something went wrong that the program did not expect (%1)"),
        QT_TRANSLATE_NOOP("told", "something went wrong that the program did not expect"),
        QT_TRANSLATE_NOOP("told", "Try again; if it happens again, send the log file"),
        QT_TRANSLATE_NOOP("told", "Go on; if it happens again, send the log file"),
        QT_TRANSLATE_NOOP("told", "Start it from a terminal with -v and send what it prints"),
        QT_TRANSLATE_NOOP("told", "the worker's process ended"),
        QT_TRANSLATE_NOOP("told", "a texture of %1 texels cannot be made"),
        QT_TRANSLATE_NOOP("told", "The sizes are %1"),
        QT_TRANSLATE_NOOP("told", "the format %1 is not known"),
        QT_TRANSLATE_NOOP("told", "The formats are %1"),
        QT_TRANSLATE_NOOP("told", "The file cannot be written: %1"),
        QT_TRANSLATE_NOOP("told", "Choose another folder or free some space"),
        QT_TRANSLATE_NOOP("told", "USDZ needs a library that is not here"),
        QT_TRANSLATE_NOOP("told", "Install it with: %1"),
        QT_TRANSLATE_NOOP("told", "This machine cannot draw: EGL gives no context"),
        QT_TRANSLATE_NOOP("told", "nothing is held under this name"),
        QT_TRANSLATE_NOOP("told", "cloner list shows the names"),
        QT_TRANSLATE_NOOP("told", "somebody is cloning this visitor just now"),
        QT_TRANSLATE_NOOP("told", "Wait or stop that, and repeat"),
        QT_TRANSLATE_NOOP("told", "there is nowhere to look"),
        QT_TRANSLATE_NOOP("told", "Give --photos, --out or both"),
        QT_TRANSLATE_NOOP("told", "Give --photos and --out as you gave them to batch"),
        QT_TRANSLATE_NOOP("told", "the file exists"),
        QT_TRANSLATE_NOOP("told", "Choose another name"),
        QT_TRANSLATE_NOOP("told", "the zip file cannot be written"),
        QT_TRANSLATE_NOOP("told", "Check the folder and its space"),
        QT_TRANSLATE_NOOP("told", "not everything could be deleted"),
        QT_TRANSLATE_NOOP("told", "Check permissions and repeat"),
        QT_TRANSLATE_NOOP("told", "the results cannot be written there"),
        QT_TRANSLATE_NOOP("told", "Choose another --out folder, or check its permissions and free space"),
        QT_TRANSLATE_NOOP("told", "something that is no earlier result is in the way and will not be replaced"),
        QT_TRANSLATE_NOOP("told", "Choose another --out folder or --id"),
        QT_TRANSLATE_NOOP("told", "the file cannot be written"),
        QT_TRANSLATE_NOOP("told", "The clone was written by a newer version"),
        QT_TRANSLATE_NOOP("told", "Clone the person again with this version of Cloner"),
        QT_TRANSLATE_NOOP("told", "The clone is not there"),
        QT_TRANSLATE_NOOP("told", "Run: cloner clone"),
        QT_TRANSLATE_NOOP("told", "The file is not a readable clone"),
        QT_TRANSLATE_NOOP("told", "%1 must be an object"),
        QT_TRANSLATE_NOOP("told", "Correct the entry, or move the file away to use the proposals alone"),
        QT_TRANSLATE_NOOP("told", 'a point needs numbers "x" and "y" in photo pixels'),
        QT_TRANSLATE_NOOP("told", "this is not valid JSON"),
        QT_TRANSLATE_NOOP("told", "%1 is not a view; the views are %2"),
        QT_TRANSLATE_NOOP("told", "there is no feature point of this name in this view"),
        QT_TRANSLATE_NOOP("told", "the point lies outside the photo of %1"),
        QT_TRANSLATE_NOOP("told", "%1 with a usable name is here, and one front photo is needed"),
        QT_TRANSLATE_NOOP("told", "Give the folder inside it that holds the photos (%1), or use cloner batch for all"),
        QT_TRANSLATE_NOOP("told", "Name the photos %1 (png, webp, tiff and heic work too)"),
        QT_TRANSLATE_NOOP("told", "there is no such folder of photos"),
        QT_TRANSLATE_NOOP("told", "Give the folder that holds the photos"),
        QT_TRANSLATE_NOOP("told", "%1 must be text in quotes"),
        QT_TRANSLATE_NOOP("told", "Put it in quotes"),
        QT_TRANSLATE_NOOP("told", "measures must be a table of centimetres"),
        QT_TRANSLATE_NOOP("told", "Write a line [measures], and below it lines like: waist_girth = 70.2"),
        QT_TRANSLATE_NOOP("told", "the height must be a number of centimetres"),
        QT_TRANSLATE_NOOP("told", "Write height_cm = 172"),
        QT_TRANSLATE_NOOP("told", "a height of %1 cm is outside %2 to %3 cm"),
        QT_TRANSLATE_NOOP("told", "Give the barefoot height in centimetres"),
        QT_TRANSLATE_NOOP("told", "there are two photos for %1: %2 and %3"),
        QT_TRANSLATE_NOOP("told", "Keep one of them"),
        QT_TRANSLATE_NOOP("told", "this is not valid TOML (%1)"),
        QT_TRANSLATE_NOOP("told", "Write lines like: height_cm = 172"),
        QT_TRANSLATE_NOOP("told", "this is a link that leads out of its folder"),
        QT_TRANSLATE_NOOP("told", "Put the file itself there"),
        QT_TRANSLATE_NOOP("told", '"format" must be a whole number'),
        QT_TRANSLATE_NOOP("told", "Write format = %1, as this version does"),
        QT_TRANSLATE_NOOP("told", "it was written by a newer version of Cloner (format %1, this one knows %2)"),
        QT_TRANSLATE_NOOP("told", "Update Cloner, or move the file away"),
        QT_TRANSLATE_NOOP("told", "this is no ordinary file"),
        QT_TRANSLATE_NOOP("told", "Check it or move it away"),
        QT_TRANSLATE_NOOP("told", "the file is larger than %1 MB"),
        QT_TRANSLATE_NOOP("told", "the file cannot be read as text"),
        QT_TRANSLATE_NOOP("told", "the work folder cannot be written"),
        QT_TRANSLATE_NOOP("told", "The picture is too large to draw"),
        QT_TRANSLATE_NOOP("told", "Keep it under %1 pixels"),
        QT_TRANSLATE_NOOP("told", "this photo shows only the upper part of the person, not the whole body"),
        QT_TRANSLATE_NOOP("told", "the feet are outside this photo"),
        QT_TRANSLATE_NOOP("told", "this photo shows the person from the front or back, not from the side"),
        QT_TRANSLATE_NOOP("told", "this photo shows the person from the side, not the %1"),
        QT_TRANSLATE_NOOP("told", "front"),
        QT_TRANSLATE_NOOP("told", "back"),
        QT_TRANSLATE_NOOP("told", "this photo shows the person's back, not the front"),
        QT_TRANSLATE_NOOP("told", "this photo shows the person's front, not the back"),
        QT_TRANSLATE_NOOP("told", "this photo shows the whole body, not the face from near"),
        QT_TRANSLATE_NOOP("told", "this photo shows the face from the side, not from the front"),
        QT_TRANSLATE_NOOP("told", "no face can be seen from the front in this photo"),
        QT_TRANSLATE_NOOP("told", "this photo shows the head from the front or back, not from the side"),
        QT_TRANSLATE_NOOP("told", "Rename or retake the photos so that each shows what its name says"),
        QT_TRANSLATE_NOOP("told", "%1: the corrected point %2 lies off the image"),
        QT_TRANSLATE_NOOP("told", "Drag it back on to the photo"),
        QT_TRANSLATE_NOOP("told", "no person found in this photo"),
        QT_TRANSLATE_NOOP("told", "Take it again with one person in full view"),
        QT_TRANSLATE_NOOP("told", "%1 people found in this photo"),
        QT_TRANSLATE_NOOP("told", "Take it again with one person alone in view"),
        QT_TRANSLATE_NOOP("told", "the person's outline was not found"),
        QT_TRANSLATE_NOOP("told", "Retake the photo before a plain background"),
        QT_TRANSLATE_NOOP("told", "the photo is missing"),
        QT_TRANSLATE_NOOP("told", "Put it into the photos folder"),
        QT_TRANSLATE_NOOP("told", "the photo is empty (0 bytes)"),
        QT_TRANSLATE_NOOP("told", "Copy the photo from the camera again, or retake it"),
        QT_TRANSLATE_NOOP("told", "%1 has %2 megapixels, more than the %3 that can be read"),
        QT_TRANSLATE_NOOP("told", "the photo"),
        QT_TRANSLATE_NOOP("told", "this %1 photo"),
        QT_TRANSLATE_NOOP("told", "the photo has more than %1 megapixels"),
        QT_TRANSLATE_NOOP("told", "Save it smaller, 12 megapixels are plenty"),
        QT_TRANSLATE_NOOP("told", "the photo is only %1 x %2 pixels"),
        QT_TRANSLATE_NOOP("told", "Use the original photo, not a thumbnail"),
        QT_TRANSLATE_NOOP("told", "this file is not a photo that can be read"),
        QT_TRANSLATE_NOOP("told", "Install pillow-heif, or let the phone save photos as JPEG"),
        QT_TRANSLATE_NOOP("told", "Use a JPEG, PNG, TIFF or WebP photo"),
        QT_TRANSLATE_NOOP("told", "the photo is damaged or cut short"),
        QT_TRANSLATE_NOOP("told", "the photo cannot be opened"),
        QT_TRANSLATE_NOOP("told", "the photo cannot be read"),
        QT_TRANSLATE_NOOP("told", "Is the card or the cable still in its place?"),
        QT_TRANSLATE_NOOP("told", "the photos changed while they were cloned"),
        QT_TRANSLATE_NOOP("told", "Clone again"),
        QT_TRANSLATE_NOOP("told", "Consent"),
        QT_TRANSLATE_NOOP("told", "No photo could be laid on the body: it keeps one plain colour"),
        QT_TRANSLATE_NOOP("told", "%1: no focal length in the photo; %2 mm is assumed"),
        QT_TRANSLATE_NOOP("told", "%1: no focal length in the photo; %2 assumed."),
        QT_TRANSLATE_NOOP("told", "no photo shows the face from the front: the head is the generic one of this build"),
        QT_TRANSLATE_NOOP(
            "told", "no usable front photo of the face: the face comes from the small one in the body photo"
        ),
        QT_TRANSLATE_NOOP("told", "%1: depths of the face are those of a usual face of this shape"),
        QT_TRANSLATE_NOOP("told", "there is no side photo of the face"),
        QT_TRANSLATE_NOOP("told", "no profile was found in the side photo of the face"),
        QT_TRANSLATE_NOOP("told", "Loose clothing between hips and knees was given its own surface"),
        QT_TRANSLATE_NOOP("told", "No height was given: %1 cm is assumed, so every length is unscaled; %2"),
        QT_TRANSLATE_NOOP("told", "give --height-cm or height_cm in person.toml"),
        QT_TRANSLATE_NOOP(
            "told", "There is no body photo: the body is the generic one of a matching build, its colours a guess"
        ),
        QT_TRANSLATE_NOOP("told", "There is no front photo of the body: its front is seen by the face photo alone"),
        QT_TRANSLATE_NOOP(
            "told", "There is no side photo of the body: its depths are those of a usual body of this shape"
        ),
        QT_TRANSLATE_NOOP(
            "told", "There is no back photo of the body: its back is coloured from what the other photos show"
        ),
        QT_TRANSLATE_NOOP("told", "corrections.json corrects %1, but there is no such photo: they are not used"),
        QT_TRANSLATE_NOOP("told", "%1 has changed since its points were corrected: check them"),
        QT_TRANSLATE_NOOP("told", "%1: the corrected point %2 could not be obeyed: %3"),
        QT_TRANSLATE_NOOP(
            "told", "it sets the scale of its photo; hair and soles are no skin that could be laid on it"
        ),
        QT_TRANSLATE_NOOP("told", "the face does not follow it, so the clone stays %1 px off it"),
        QT_TRANSLATE_NOOP("told", "the limb does not reach it, so the clone stays %1 px off it"),
        QT_TRANSLATE_NOOP("told", "no outline of the clone is seen there, so the point was left out"),
        QT_TRANSLATE_NOOP("told", "the point lies %1 cm off the body, so it was left out: drag it back to the outline"),
        QT_TRANSLATE_NOOP("told", "the skin would fold, so the clone stays %1 px off it"),
        QT_TRANSLATE_NOOP("told", "it contradicts %1, so the clone stays %2 px off it"),
        QT_TRANSLATE_NOOP("told", "%1: the clone covers the person's outline only to %2 percent"),
        QT_TRANSLATE_NOOP("told", "%1: the clone covers the head's outline only to %2 percent"),
        QT_TRANSLATE_NOOP(
            "told",
            "%1: nobody can be made out in this photo, so it was left out; "
            "retake it with hair, hood or scarf away from the face",
        ),
        QT_TRANSLATE_NOOP(
            "told",
            "%1: the clone would cover only %2 percent of the person in this photo, so it was left out; "
            "check that it shows the same person in the same clothes, straight from the side or from behind",
        ),
        QT_TRANSLATE_NOOP(
            "told",
            "%1: the %2 arm of the clone lies %3 cm beside the arm in this photo; "
            "let the arms hang a little away from the body and retake it",
        ),
        QT_TRANSLATE_NOOP(
            "told",
            "%1: the head is turned by about %2 degrees from where it should look; "
            "retake it with the head turned as the body",
        ),
        QT_TRANSLATE_NOOP(
            "told",
            "%1: the glasses became an object of their own and the skin behind their frame is a guess; "
            "take the face photos without glasses if you can",
        ),
        QT_TRANSLATE_NOOP("told", "%1: headwear hides the hair and becomes part of the head; take it off if you can"),
        QT_TRANSLATE_NOOP("told", "left"),
        QT_TRANSLATE_NOOP("told", "right"),
    )
)
