"""What visitors take home besides files: a printed card, and a draft of an e-mail."""

from __future__ import annotations

import functools
from collections.abc import Callable
from pathlib import Path
from typing import Final

from PySide6.QtCore import QBuffer, QByteArray, QIODevice, QRectF, Qt
from PySide6.QtGui import QImage, QPainter, QPixmap, QShowEvent
from PySide6.QtWidgets import QFileDialog, QLabel, QWidget

from cloner.booth.handover.takeaway import qr_modules
from cloner.booth.opened import Cloned
from cloner.booth.stage import public_name
from cloner.booth.visitors.names import first_name, number_of
from cloner.booth.visitors.person_file import consent_language
from cloner.booth.visitors.visits import read_visit
from cloner.errors import ClonerError
from cloner.records.clones import Clone
from cloner_gui.background.newest import shared_latest
from cloner_gui.event.booth import Booth
from cloner_gui.language.letters_home import letter_text
from cloner_gui.language.words import translate
from cloner_gui.widgets.pieces import Card, button, label, set_accessible_name
from cloner_gui.widgets.printed_card import (
    CARD_MM,
    DOTS_PER_INCH,
    MM_PER_INCH,
    CardContent,
    card_image,
    paint_true_size,
    picture_room,
    save_card,
)

_SHOWN_PX: Final = 190  # height of the card on the page
_JPEG_QUALITY: Final = 90


class Keepsakes(Card):
    """The card as it will be printed, and its actions.

    Parameters
    ----------
    booth : Booth
    link : callable
        Returns what the code of the open visitor holds; "" for none.
    """

    def __init__(self, booth: Booth, link: Callable[[], str], parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self._booth, self._link = booth, link
        self._picture: QImage | None = None
        self._of: Cloned | None = None
        self._told: tuple[object, ...] | None = None
        self.heading, self.shown, self.note = label("heading"), QLabel(), label("dim")
        self.print_button, self.save_button, self.mail_button = button(), button(), button()
        self.shown.setFixedSize(round(_SHOWN_PX * CARD_MM[0] / CARD_MM[1]), _SHOWN_PX)
        self.column.addWidget(self.heading)
        self.column.addWidget(self.shown, 0, Qt.AlignmentFlag.AlignHCenter)
        for one in (self.print_button, self.save_button, self.mail_button, self.note):
            self.column.addWidget(one)
        self.column.addStretch(1)
        self.print_button.clicked.connect(self.print_card)
        self.save_button.clicked.connect(self.save)
        self.mail_button.clicked.connect(self.save_letter)
        booth.session.opened.connect(lambda: self.note.setText(""))

    def speak(self) -> None:
        """Say everything in the window's language."""
        self.heading.setText(translate("keepsakes", "Card and e-mail"))
        self.print_button.setText(translate("keepsakes", "Pr&int the card…"))
        self.save_button.setText(translate("keepsakes", "Sa&ve the card as a file…"))
        self.mail_button.setText(translate("keepsakes", "E-&mail as a draft…"))
        set_accessible_name(self.shown, translate("keepsakes", "The card as it will be printed"))
        self.show_card()

    def showEvent(self, event: QShowEvent) -> None:
        """Draw the card when it is first seen."""
        super().showEvent(event)
        self.show_card()

    def show_card(self) -> None:
        """Show the card of the open visitor; its picture is drawn beside the window's work."""
        outcome = self._booth.session.outcome
        if outcome is not self._of:
            self._of, self._picture = outcome, None
            if not self.isVisible():
                self._of = None  # drawn when it is seen
            elif outcome is not None:
                work = functools.partial(_drawn, outcome.values["clone"])
                shared_latest().ask(self, "card", work, functools.partial(self._take, outcome), self._booth.failed.emit)
        content = self.content()
        for one in (self.print_button, self.save_button, self.mail_button):
            one.setEnabled(content is not None)
        message = (
            None if content is None else (content.title, content.name, content.note, self._link(), content.picture)
        )
        if message != self._told:  # asked for with everything that changes on the page
            self._told = message
            self.shown.setPixmap(QPixmap() if content is None else self._small(content))

    def _take(self, outcome: Cloned, picture: QImage) -> None:
        if outcome is self._of:
            self._picture = picture
            self.show_card()

    def _small(self, content: CardContent) -> QPixmap:
        density = self.devicePixelRatioF()
        whole = QPixmap.fromImage(card_image(content, 150))
        size = (self.shown.size() * density).expandedTo(self.shown.size())
        small = whole.scaled(size, Qt.AspectRatioMode.KeepAspectRatio, Qt.TransformationMode.SmoothTransformation)
        small.setDevicePixelRatio(density)
        return small

    def content(self) -> CardContent | None:
        """Return what stands on the card of the open visitor; None before it is drawn."""
        folder, settings, root = self._booth.session.folder, self._booth.settings, self._booth.root
        if folder is None or self._picture is None or self._booth.session.outcome is not self._of:
            return None
        called = public_name(folder, read_visit(folder), self._booth.typed_name(folder))
        if called == number_of(folder) != folder.name:
            called = translate("visitor", "Visitor {n}").format(n=called)
        link = self._link()
        try:
            code = qr_modules(link) if link else None
        except ClonerError:
            code = None
        told = translate("keepsakes", "Your files: {folder}").format(folder=folder.name)
        if code is not None:
            told = translate("keepsakes", "Scan to see yourself turn and to take your files home.")
        logo = QImage(settings.logo) if settings.logo else QImage()
        title = settings.title or ("" if root is None else root.name)
        return CardContent(self._picture, title, called, told, code, None if logo.isNull() else logo)

    # --- what the operator does -------------------------------------------------------

    def print_card(self) -> None:
        """Print the card through the system's own dialogue."""
        from PySide6.QtGui import QPageSize
        from PySide6.QtPrintSupport import QPrintDialog, QPrinter  # asks the system for printers: only when wanted

        content = self.content()
        if content is None:
            return
        printer = QPrinter(QPrinter.PrinterMode.HighResolution)
        printer.setPageSize(QPageSize(QPageSize.PageSizeId.A6))
        dialog = QPrintDialog(printer, self)
        dialog.setAttribute(Qt.WidgetAttribute.WA_DeleteOnClose)
        dialog.accepted.connect(lambda: self._print(printer, content))
        dialog.setModal(True)
        dialog.show()

    def _print(self, printer: object, content: CardContent) -> None:
        from PySide6.QtPrintSupport import QPrinter

        assert isinstance(printer, QPrinter)
        painter = QPainter()
        if not painter.begin(printer):
            hint = "Is it switched on, with paper in it? A file can be printed elsewhere"
            self._booth.failed.emit(ClonerError("the printer does not answer", hint, "Printer"))
            return
        page = QRectF(printer.pageRect(QPrinter.Unit.DevicePixel))
        paint_true_size(painter, QRectF(0.0, 0.0, page.width(), page.height()), printer.resolution(), content)
        painter.end()

    def save(self) -> None:
        """Ask for a file and write the card."""
        content = self.content()
        path = self._ask(".pdf", "PDF (*.pdf);;PNG (*.png)")
        if content is not None and path is not None:
            self._guard(lambda: save_card(content, path), path)

    def save_letter(self) -> None:
        """Ask for a file and write the draft of an e-mail, in the language in which the visitor agreed."""
        folder, picture = self._booth.session.folder, self._picture
        path = self._ask(".eml", "E-mail (*.eml)")
        if folder is None or picture is None or path is None:
            return
        from cloner.booth.handover.email import email_draft  # Python's own e-mail library: seldom wanted

        code = consent_language(self._booth.session.consent) or self._booth.settings.language
        called, event = first_name(self._booth.typed_name(folder)), self._booth.settings.title
        subject, text = letter_text(code, called, event, self._link())
        self._guard(lambda: _write(path, email_draft(subject, text, jpeg_of(picture))), path)

    def _ask(self, suffix: str, kinds: str) -> Path | None:
        folder = self._booth.session.folder
        start = "" if folder is None else f"{folder.name}{suffix}"
        target, _ = QFileDialog.getSaveFileName(self, translate("takeaway", "Save as"), start, kinds)
        if not target:
            return None
        known = tuple(one for one in (".pdf", ".png", ".eml") if one in kinds)
        path = Path(target)
        return path if path.suffix.lower() in known else path.with_name(path.name + suffix)

    def _guard(self, write: Callable[[], None], path: Path) -> None:
        try:
            write()
        except ClonerError as error:
            self._booth.failed.emit(error)
        else:
            self.note.setText(translate("takeaway", "Written: {place}").format(place=path.name))


def _drawn(clone: Clone) -> QImage:
    """Return the clone's picture in the card's own size; runs on another thread."""
    from cloner_gui.canvas.clones.greeting import (
        greeting_picture,  # drawing and motion: not paid for before there is a clone
    )

    room = picture_room()
    width, height = (round(side / MM_PER_INCH * DOTS_PER_INCH) for side in (room.width(), room.height()))
    return greeting_picture(clone, width, height)


def _write(path: Path, data: bytes) -> None:
    try:
        path.write_bytes(data)
    except OSError as error:
        raise ClonerError("it cannot be written there", "Is the stick full or write-protected?", path.name) from error


def jpeg_of(picture: QImage) -> bytes:
    """Return a picture as a JPEG file's bytes."""
    data = QByteArray()
    buffer = QBuffer(data)
    buffer.open(QIODevice.OpenModeFlag.WriteOnly)
    picture.save(buffer, "JPG", _JPEG_QUALITY)  # type: ignore[call-overload]
    return bytes(data.data())
