"""Colours, sizes and shapes of the window: light, dark, high contrast, or the desktop's."""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path
from typing import Final

from PySide6.QtCore import Qt
from PySide6.QtGui import QColor, QPalette
from PySide6.QtWidgets import QApplication

#: Height of buttons and fields, px: for a mouse, and for fingers (taste; 44 is what telephones use).
CONTROL_PX: Final = 30
TOUCH_PX: Final = 48
BIG_TEXT: Final = 1.25
PICTURES: Final = Path(__file__).parent / "pictures"
BASE_POINTS: Final = 10.5  # taste: read at arm's length


@dataclass(frozen=True, slots=True)
class Colours:
    """The colours of one appearance, "#rrggbb"."""

    window: str
    card: str
    text: str
    dim: str
    line: str
    accent: str
    on_accent: str
    warn: str
    warn_back: str
    good: str


LIGHT: Final = Colours(
    "#eef0f3", "#ffffff", "#1c2430", "#5a6472", "#cfd5dd", "#1a63d8", "#ffffff", "#8a4b00", "#fff1d6", "#177545"
)
DARK: Final = Colours(
    "#1b1f26", "#262c35", "#e8ecf2", "#a3adba", "#3d4653", "#5b9dff", "#0c1420", "#ffc66b", "#3a2f19", "#5fd39b"
)
CONTRAST: Final = Colours(
    "#000000", "#000000", "#ffffff", "#ffffff", "#ffffff", "#ffe600", "#000000", "#ffe600", "#000000", "#7dff7d"
)


def colours_of(appearance: str) -> Colours:
    """Return the colours of an appearance; "system" follows the desktop."""
    if appearance == "contrast":
        return CONTRAST
    if appearance == "system":
        dark = QApplication.styleHints().colorScheme() is Qt.ColorScheme.Dark
        return DARK if dark else LIGHT
    return DARK if appearance == "dark" else LIGHT


def palette_of(colours: Colours) -> QPalette:
    """Return a Qt palette in these colours, so that widgets without a style rule follow too."""
    role = QPalette.ColorRole
    palette = QPalette(QColor(colours.card), QColor(colours.window))
    table = {
        role.Window: colours.window, role.Base: colours.card, role.AlternateBase: colours.window,
        role.Text: colours.text, role.WindowText: colours.text, role.ButtonText: colours.text,
        role.Button: colours.card, role.Highlight: colours.accent, role.HighlightedText: colours.on_accent,
        role.ToolTipBase: colours.card, role.ToolTipText: colours.text, role.PlaceholderText: colours.dim,
        role.Mid: colours.line, role.Link: colours.accent,
    }  # fmt: skip
    for which, colour in table.items():
        palette.setColor(which, QColor(colour))
    for which in (role.Text, role.WindowText, role.ButtonText):
        palette.setColor(QPalette.ColorGroup.Disabled, which, QColor(colours.dim))
    return palette


def style_of(colours: Colours, *, control_px: int, points: float) -> str:
    """Return the style sheet: cards, one primary button, steps, quiet bars; a ring shows the keyboard focus."""
    c, radius = colours, 6
    tick, arrow = _picture("tick", c.on_accent), _picture("arrow", c.text)
    return f"""
    QWidget {{ color: {c.text}; }}
    QMainWindow, QDialog, #page {{ background: {c.window}; }}
    #card {{ background: {c.card}; border: 1px solid {c.line}; border-radius: 10px; }}
    #title {{ font-size: {1.45 * points:.1f}pt; font-weight: 600; }}
    #heading {{ font-size: {1.15 * points:.1f}pt; font-weight: 600; }}
    #dim {{ color: {c.dim}; }}
    #warn {{ color: {c.warn}; }}
    #good {{ color: {c.good}; }}
    #notice {{ background: {c.warn_back}; border: 1px solid {c.warn}; border-radius: {radius}px; }}
    #notice QLabel {{ color: {c.warn}; }}
    #news {{ background: {c.card}; border: 2px solid {c.accent}; border-radius: {radius}px; }}
    #news QLabel {{ color: {c.text}; }}
    QPushButton, QToolButton {{ background: {c.card}; border: 1px solid {c.line}; border-radius: {radius}px;
        padding: 2px 14px; min-height: {control_px}px; }}
    QToolButton {{ padding: 2px 8px; }}
    QPushButton:hover, QToolButton:hover {{ border-color: {c.accent}; }}
    QPushButton:disabled, QToolButton:disabled {{ color: {c.dim}; background: transparent; border-style: dashed; }}
    QPushButton#main {{ background: {c.accent}; color: {c.on_accent}; border-color: {c.accent}; font-weight: 600; }}
    QPushButton#main:disabled {{ background: transparent; color: {c.dim}; border-color: {c.line}; }}
    QPushButton#danger {{ color: {c.warn}; border-color: {c.warn}; }}
    QPushButton:focus, QToolButton:focus {{ border: 2px solid {c.accent}; }}
    QPushButton#main:focus {{ border: 2px solid {c.text}; }}
    QPushButton#step {{ background: transparent; border: 2px solid transparent; border-bottom-width: 3px;
        border-radius: 0; padding: 4px 16px; color: {c.dim}; }}
    QPushButton#step:checked {{ color: {c.text}; border-bottom-color: {c.accent}; }}
    QPushButton#step:focus {{ border-color: {c.accent}; }}
    QLineEdit, QDoubleSpinBox, QSpinBox, QComboBox, QPlainTextEdit {{ background: {c.card};
        border: 1px solid {c.line}; border-radius: {radius}px; padding: 2px 8px; min-height: {control_px}px;
        placeholder-text-color: {c.dim}; selection-background-color: {c.accent}; selection-color: {c.on_accent}; }}
    QLineEdit:focus, QDoubleSpinBox:focus, QSpinBox:focus, QComboBox:focus, QPlainTextEdit:focus,
    QListWidget:focus, QTableWidget:focus {{ border: 2px solid {c.accent}; }}
    QListWidget, QTableWidget {{ background: {c.card}; border: 1px solid {c.line}; border-radius: {radius}px; }}
    QListWidget::item {{ padding: 6px 8px; }}
    QListWidget::item:selected {{ background: {c.accent}; color: {c.on_accent}; }}
    QComboBox {{ padding-right: 26px; }}
    QComboBox::drop-down {{ border: none; width: 26px; }}
    QComboBox::down-arrow {{ image: url({arrow}); width: 12px; height: 12px; }}
    QAbstractSpinBox QLineEdit, QAbstractSpinBox QLineEdit:focus {{ border: none; padding: 0 6px;
        min-height: 0; background: transparent; }}
    QAbstractSpinBox::up-button, QAbstractSpinBox::down-button {{ width: 0; border: none; }}
    QDoubleSpinBox, QSpinBox {{ min-width: {5.5 * points:.0f}pt; }}
    QCheckBox::indicator, QTableWidget::indicator {{ width: {1.5 * points:.0f}px; height: {1.5 * points:.0f}px;
        background: {c.card}; border: 2px solid {c.dim}; border-radius: 4px; }}
    QCheckBox::indicator:checked {{ background: {c.accent}; border-color: {c.accent}; image: url({tick}); }}
    QCheckBox::indicator:disabled {{ border-style: dotted; }}
    QCheckBox:focus {{ color: {c.text}; }}
    QCheckBox::indicator:focus {{ border-color: {c.text}; }}
    QScrollBar:vertical {{ background: transparent; width: 12px; }}
    QScrollBar:horizontal {{ background: transparent; height: 12px; }}
    QScrollBar::handle {{ background: {c.dim}; border-radius: 4px; margin: 2px; min-height: 28px; min-width: 28px; }}
    QScrollBar::add-line, QScrollBar::sub-line {{ width: 0; height: 0; }}
    QScrollBar::add-page, QScrollBar::sub-page {{ background: transparent; }}
    QCheckBox, QRadioButton {{ spacing: 8px; min-height: {control_px}px; }}
    QProgressBar {{ background: {c.card}; border: 1px solid {c.line}; border-radius: {radius}px; text-align: center;
        min-height: 18px; }}
    QProgressBar::chunk {{ background: {c.accent}; border-radius: {radius - 1}px; }}
    QScrollArea {{ border: none; background: transparent; }}
    QScrollArea > QWidget > QWidget {{ background: transparent; }}
    """


def _picture(name: str, colour: str) -> str:
    """Return the file of a small sign that is seen beside things of a colour's own lightness."""
    kind = "light" if QColor(colour).lightnessF() > 0.5 else "dark"
    return (PICTURES / f"{name}_{kind}.svg").as_posix()


def apply_theme(app: QApplication, appearance: str, *, big: bool, text_percent: int) -> None:
    """Set the whole program's appearance; text is scaled by the operator's setting and in touch mode.

    Two milliseconds before the window is made, half a second after: Qt polishes every widget anew. What the program
    looks like already is left alone.
    """
    colours = colours_of(appearance)
    points = BASE_POINTS * text_percent / 100.0 * (BIG_TEXT if big else 1.0)
    control_px = max(
        TOUCH_PX if big else CONTROL_PX, round(2.3 * points)
    )  # a line of large text is higher than a mouse needs
    style = style_of(colours, control_px=control_px, points=points)
    if app.styleSheet() == style:
        return
    app.setStyle("Fusion")
    app.setPalette(palette_of(colours))
    font = app.font()
    font.setPointSizeF(points)
    app.setFont(font)
    app.setStyleSheet(style)
