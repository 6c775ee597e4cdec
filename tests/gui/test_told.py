"""What goes wrong is said in the operator's language: no English sentence reaches a German or Turkish window."""

import pytest
from PySide6.QtWidgets import QApplication

from cloner.errors import ClonerError
from cloner.generic.load import load_generic
from cloner_gui.language.languages import set_language, translator_of
from cloner_gui.language.point_names import NAMES, is_point, point_label
from cloner_gui.language.told import template_of, translated, translated_error
from kit.sentences import PLACE, ROOT, sentences

pytestmark = pytest.mark.gui

#: What no operator of the window can meet: other ways in, files that people write by hand, and motion files.
ELSEWHERE = (
    "cloner/animating.py", "cloner/batch.py", "cloner/cli.py", "cloner/commands/", "cloner/evaluate/",
    "cloner/machines/farm.py", "cloner/machines/cluster", "cloner/behaviour/", "cloner/crowd/", "cloner/untrusted.py",
    "cloner/acting/", "cloner/scenes/", "cloner/exporters/vat.py",
    "cloner/cloth/simulation/fabrics.py", "cloner/cloth/fitted.py", "cloner/project/flow_file.py",
    "cloner/statues/carved.py", "cloner/statues/clay_heads.py", "cloner/statues/markers.py",
    "cloner/exporters/shared/obj_files.py", "cloner/statues/poses.py", "cloner/terminal.py",
    "cloner/motion/", "cloner/picture.py", "cloner/project/manifest.py", "cloner/project/tape.py",
)  # fmt: skip
#: What `cloner.clone` says to programs alone.
TO_PROGRAMS = ("one front photo is needed", "Give body_front, face_front or both", "□ is no view", "The views are □")


@pytest.fixture
def german(qtbot):
    assert QApplication.instance() is not None
    set_language("de")
    yield
    set_language("en")


def on_the_path():
    for folder in ("cloner", "gui"):
        for path in sorted((ROOT / folder).rglob("*.py")):
            name = path.relative_to(ROOT).as_posix()
            if not name.startswith(ELSEWHERE):
                told = sentences(path)
                yield from (
                    (name, line, text) for line, text in told if name != "cloner/making.py" or text not in TO_PROGRAMS
                )


def test_every_error_on_the_booths_path_has_its_translation():
    said = list(on_the_path())
    assert len(said) > 120, "the sources are read"
    unknown = [f"{name}:{line}: {text}" for name, line, text in said if template_of(text.replace(PLACE, "X7")) is None]
    assert not unknown, "add them to SENTENCES in cloner_gui/language/told.py:\n" + "\n".join(unknown)


@pytest.mark.parametrize("code", ["de", "fr", "tr"])
def test_every_sentence_and_point_is_said_in_every_language(qtbot, code):
    from cloner_gui.language.told import SENTENCES

    translator = translator_of(code)
    for context, texts in (("told", SENTENCES), ("names", [NAMES._words[key] for key in NAMES])):
        missing = [text for text in texts if not translator.translate(context, str(text))]
        assert not missing, code
    for text in SENTENCES:
        places = {f"%{n}" for n in range(1, 5) if f"%{n}" in text}
        assert all(place in translator.translate("told", text) for place in places), f"{code}: {text}"


def test_values_find_their_places_in_another_language(german):
    error = ClonerError("the photo is only 30 x 40 pixels", "Use the original photo, not a thumbnail", "body_front")
    assert (
        translated_error(error)
        == "Körper, vorn: das Foto hat nur 30 x 40 Pixel. Nehmen Sie das Original, kein Vorschaubild."
    )
    warning = "body_side: the corrected point waist_left could not be obeyed: no outline of the clone is seen there, " \
        "so the point was left out"  # fmt: skip
    assert translated(warning).startswith("Körper, Seite: dem berichtigten Punkt Taille, links")
    assert translated(warning).endswith("der Punkt wurde ausgelassen")
    assert translated("what nobody wrote") == "what nobody wrote"


def test_every_point_has_a_name_that_people_use(german):
    names = load_generic().feature_names
    assert [name for name in names if not is_point(name)] == []
    assert point_label("eye_inner_L") == "innerer Augenwinkel, links"
    assert point_label("l_knee") == "Kniegelenk, links"
    assert point_label("ankle_outer_right") == "Knöchel außen, rechts"
    assert point_label("outline_3") == "Umrisspunkt"
