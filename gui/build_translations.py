"""Renew the window's translations with Qt's own tools: python gui/build_translations.py.

Finds every text in the sources (lupdate), keeps what translators wrote in ``translations/cloner_XX.ts``, and packs
the ``.qm`` files that the program loads (lrelease). Both tools come with PySide6. ``--check`` changes nothing and
fails where a text is not translated.
"""

from __future__ import annotations

import subprocess
import sys
import tempfile
import xml.etree.ElementTree as ElementTree
from collections.abc import Sequence
from pathlib import Path
from typing import Final

HERE: Final = Path(__file__).parent / "cloner_gui"
FOLDER: Final = HERE / "translations"
LANGUAGES: Final = ("de", "fr", "tr")


def main(arguments: Sequence[str]) -> int:
    """Renew, or check with ``--check``; return the exit code."""
    checking = "--check" in arguments
    missing = 0
    with tempfile.TemporaryDirectory() as room:
        for code in LANGUAGES:
            kept = FOLDER / f"cloner_{code}.ts"
            path = Path(room) / kept.name if checking else kept
            if checking:
                path.write_bytes(kept.read_bytes())
            update(path, code)
            texts = unfinished(path)
            missing += len(texts)
            sys.stdout.writelines(f"{code}: {text}\n" for text in texts)
            if not checking:
                run("lrelease", str(path), "-qm", str(path.with_suffix(".qm")))
    return 1 if missing else 0


def update(path: Path, code: str) -> None:
    """Bring a translators' file up to date with the sources; texts that went are dropped."""
    sources = [str(one) for one in sorted(HERE.rglob("*.py"))]
    language = ("-source-language", "en", "-target-language", code)
    run("lupdate", *sources, "-ts", str(path), "-no-obsolete", "-locations", "none", *language)


def run(tool: str, *arguments: str) -> None:
    """Run one of Qt's tools as PySide6 brings it."""
    beside = Path(sys.executable).parent / f"pyside6-{tool}"
    subprocess.run([str(beside), *arguments], check=True, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)


def unfinished(path: Path) -> list[str]:
    """Return the texts of a translators' file that are not translated."""
    messages = ElementTree.parse(path).getroot().iter("message")
    return [one.findtext("source", "") for one in messages if not finished(one)]


def finished(message: ElementTree.Element) -> bool:
    """Return whether a text is translated, in all its numbers."""
    translation = message.find("translation")
    if translation is None or translation.get("type") == "unfinished":
        return False
    forms = [form.text for form in translation.iter("numerusform")] or [translation.text]
    return all(forms)


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
