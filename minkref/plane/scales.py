"""Lists of scales: evenly spaced, or from a file."""

from __future__ import annotations

from collections.abc import Callable
from fractions import Fraction
from pathlib import Path
from typing import TypeVar

from minkref.errors import Refusal
from minkref.exact import read_scale
from minkref.file_text import text_of_file
from minkref.output.terminal import escaped

S = TypeVar("S")

MOST_SCALES = 1_000_000


def evenly_spaced(first: str, last: str, count: int) -> list[str]:
    """Return `count` scales from `first` to `last`, both included (a single scale is `first`),
    exact."""
    if count == 1:
        return [first]
    begin, end = Fraction(first), Fraction(last)
    return [str(begin + (end - begin) * i / (count - 1)) for i in range(count)]


def read_scales(path: Path) -> list[str]:
    """Read the scales in a file, one per line, in file order. A # begins a comment; lines may be
    blank. Refusals name file and line."""
    return lines_of_scales(path, read_scale)


def lines_of_scales(path: Path, read: Callable[[str, str], S]) -> list[S]:
    """Apply `read` to each line in a file of scales."""
    name = escaped(str(path))
    scales: list[S] = []
    for number, line in enumerate(_text(path, name).splitlines(), start=1):
        scale = line.partition("#")[0].strip()
        if not scale:
            continue
        if len(scales) == MOST_SCALES:
            mend = "split the file"
            raise Refusal(f"there are more than {MOST_SCALES:,} scales", name, mend, "limit")
        try:
            scales.append(read(scale, "the scale"))
        except Refusal as refusal:
            where = f"{name}, line {number}, {escaped(refusal.where)}"
            raise Refusal(refusal.what, where, refusal.mend, refusal.code) from refusal
    if not scales:
        raise Refusal("there is no scale in the file", name, "write one a line", "no-scales")
    return scales


def _text(path: Path, name: str) -> str:
    mend = "name a text file with one scale a line"
    if path.is_dir():
        raise Refusal("this is a folder", name, mend, "not-a-file")
    return text_of_file(path, name, mend).removeprefix("\ufeff")
