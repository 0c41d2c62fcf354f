"""The text of a new adapter."""

from __future__ import annotations

import re
from pathlib import Path

from minkref.errors import Refusal, choice

TEMPLATES = Path(__file__).parent / "templates"
HEADER = Path(__file__).parent / "minkref_adapter.h"
PLACE = "NAME"
VERIFY = "minkref verify {stem} --seconds 30"
# Language: the template, the file's ending, the commands that build and start it.
LANGUAGES = {
    "python": ("template.py", ".py", ("minkref verify {program} --seconds 30",)),
    "c++": ("template.cpp", ".cpp", ("c++ -std=c++17 -O2 {file} -o {stem}", VERIFY)),
    "c": (
        "template.c",
        ".c",
        (
            'cc -std=c11 -O2 -shared -fPIC -include "$(minkref adapter header)" {file} '
            "-o {stem}.so",
            "minkref verify so:{stem}.so:minkowski_sum --seconds 30",
        ),
    ),
    "javascript": ("template.js", ".js", ('minkref verify "cmd:node {file}" --seconds 30',)),
    "rust": ("template.rs", ".rs", ("rustc -O {file} -o {stem}", VERIFY)),
}


def template(name: str, language: str, folder: Path) -> tuple[Path, str, list[str]]:
    """Returns the adapter's path, its text, and the commands that test it. Refuses other names and
    languages."""
    if language not in LANGUAGES:
        raise Refusal(
            f"there is no template in {language[:40]!r}", "--language", choice(language, LANGUAGES)
        )
    if not re.fullmatch(r"[A-Za-z][A-Za-z0-9_-]{0,59}", name):
        raise Refusal(
            "this is no name of an adapter",
            name[:80],
            "use letters, digits, - and _, a letter first",
        )
    source, ending, commands = LANGUAGES[language]
    file = folder / f"{name}_adapter{ending}"
    text = (TEMPLATES / source).read_text(encoding="utf-8").replace(PLACE, name)
    stem = str(folder / f"{name}_adapter")
    stem = stem if "/" in stem else f"./{stem}"
    program = str(file) if "/" in str(file) else f"./{file}"
    return file, text, [c.format(file=file, stem=stem, program=program) for c in commands]
