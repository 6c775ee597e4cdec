"""What the window needs of Qt's binding beside its functions."""

import sys

import pytest
from PySide6.QtGui import QColor, QPainter, QPixmap

pytestmark = pytest.mark.gui


def test_calls_that_return_nothing_leave_none_alone(qapp):
    """PySide6 6.12.0 takes a reference from None with each on Python 3.11: an hour of painting ends in an abort."""
    picture = QPixmap(8, 8)
    painter = QPainter(picture)
    before = sys.getrefcount(None)
    for _ in range(2000):
        painter.setPen(QColor(1, 2, 3))
    painter.end()
    assert sys.getrefcount(None) > before - 200
