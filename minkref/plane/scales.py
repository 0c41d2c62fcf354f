"""Lists of scales: evenly spaced, or from a file."""

from __future__ import annotations

from collections.abc import Callable
from fractions import Fraction
from pathlib import Path
from typing import TypeVar

from minkref.errors import Refusal
from minkref.file_text import text_of_file
from minkref.output.terminal import escaped

S = TypeVar("S")

MOST_SCALES = 1_000_000


def asked_scales(
    first: Fraction | None,
    last: Fraction | None,
    steps: int | None,
    file: Path | None,
    read: Callable[[str, str], S],
) -> list[Fraction] | list[S]:
    """The scales that --from, --to and --steps give together, or --scales, whose lines `read`
    reads."""
    options = (("--from", first), ("--to", last), ("--steps", steps))
    given = [option for option, value in options if value is not None]
    if file is not None:
        if given:
            raise Refusal(
                "the scales are given twice",
                f"--scales and {', '.join(given)}",
                "leave out --scales, or --from, --to and --steps",
            )
        return lines_of_scales(file, read)
    if first is None or steps is None or (last is None and steps != 1):
        missing = ", ".join(option for option, value in options if value is None)
        raise Refusal(
            f"the scales are not given: {missing} missing",
            f"minkref sweep {' '.join(given)}".rstrip(),
            "give --from A --to B --steps N, or --scales FILE",
        )
    if not 1 <= steps <= MOST_SCALES:
        raise Refusal(
            f"there must be 1 to {MOST_SCALES:,} scales", f"--steps {steps}", "choose another N"
        )
    return evenly_spaced(first, first if last is None else last, steps)


def evenly_spaced(first: Fraction, last: Fraction, count: int) -> list[Fraction]:
    """Return `count` scales from `first` to `last`, both included (a single scale is `first`),
    exact."""
    if count == 1:
        return [first]
    return [first + (last - first) * i / (count - 1) for i in range(count)]


def lines_of_scales(path: Path, read: Callable[[str, str], S]) -> list[S]:
    """Read the scales in a file, one per line, in file order, each by `read`. A # begins a comment;
    lines may be blank. Refusals name file and line."""
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
