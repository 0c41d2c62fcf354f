"""The map of the house names places that are there."""

from __future__ import annotations

import re
from pathlib import Path

import pytest

ROOT = Path(__file__).resolve().parents[2]
PAGE = (ROOT / "docs" / "architecture.md").read_text(encoding="utf-8")
#: Where a path may begin: the page leaves out what the sentence before has named.
BEGINS = ("", "reference", "reference/plane")
PATHS = sorted(set(re.findall(r"`([\w./]+/[\w./]*)`", PAGE)))


@pytest.mark.parametrize("path", PATHS)
def test_a_place_of_the_map_exists(path: str) -> None:
    assert any((ROOT / begin / path).exists() for begin in BEGINS)


def test_the_map_names_a_line_that_decides_for_each_way() -> None:
    for name, file in re.findall(r"\*\*`(\w+)` in `([\w./]+)` decides", PAGE):
        places = [ROOT / begin / file for begin in BEGINS]
        (there,) = [place for place in places if place.is_file()]
        assert re.search(rf"\b{name}\(", there.read_text(encoding="utf-8")), (name, file)
    assert len(re.findall(r"decides\W*\*\*", PAGE)) == PAGE.count("\n## ") == 3
