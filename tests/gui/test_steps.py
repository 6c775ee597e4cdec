"""What the window says while a stage works."""

import pytest

from cloner.pipeline import STAGES
from cloner_gui.language.words import STEPS

pytestmark = pytest.mark.gui


def test_every_stage_has_its_words() -> None:
    assert [stage.name for stage in STAGES if stage.name not in STEPS] == []
