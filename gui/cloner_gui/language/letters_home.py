"""The text of the e-mail to a visitor, in the visitor's language, whatever the window's language is."""

from __future__ import annotations

from typing import Final

from PySide6.QtCore import QT_TRANSLATE_NOOP

from cloner_gui.language.languages import LANGUAGE_NAMES, translator_of

_SUBJECT: Final = str(QT_TRANSLATE_NOOP("mail", "Your clone"))
_SUBJECT_OF: Final = str(QT_TRANSLATE_NOOP("mail", "Your clone from {event}"))
_HELLO: Final = str(QT_TRANSLATE_NOOP("mail", "Hello,"))
_HELLO_NAME: Final = str(QT_TRANSLATE_NOOP("mail", "Hello {name},"))
_TEXT: Final = str(
    QT_TRANSLATE_NOOP("mail", "this is the clone that was made of your photos. Its picture is attached.")
)
_LINK: Final = str(
    QT_TRANSLATE_NOOP("mail", "As long as you are on the booth's network you can see it turn and take the files here:")
)
_DELETE: Final = str(
    QT_TRANSLATE_NOOP("mail", "If you want everything that is held of you deleted, answer this message or tell us.")
)
_GOODBYE: Final = str(QT_TRANSLATE_NOOP("mail", "Thank you for your visit."))


def letter_text(code: str, name: str, event: str, link: str) -> tuple[str, str]:
    """Return subject and text.

    Parameters
    ----------
    code : str
        The language; English where it is none of the window's.
    name : str
        First name; "" greets without one.
    event : str
        Its title; "" for none.
    link : str
        Where the visitor's page is; "" for none.
    """
    translator = translator_of(code if code in LANGUAGE_NAMES else "en")

    def say(text: str, **values: str) -> str:
        return (translator.translate("mail", text) or text).format(**values)

    hello = say(_HELLO_NAME, name=name) if name else say(_HELLO)
    parts = [hello, say(_TEXT), *((f"{say(_LINK)}\n{link}",) if link else ()), say(_DELETE), say(_GOODBYE)]
    return say(_SUBJECT_OF, event=event) if event else say(_SUBJECT), "\n\n".join(parts) + "\n"
