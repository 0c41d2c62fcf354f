"""Values of JSON with one part replaced, and what both checkers say of them."""

from __future__ import annotations

import json
import random
from collections.abc import Iterable, Iterator, Sequence
from fractions import Fraction
from functools import reduce
from operator import getitem
from pathlib import Path
from typing import Any

from minkref.reports.evidence.certificates.checkers import in_cpp, in_python, verdicts
from thoroughness import draws

SEED, FEW = 71, 60


Value = dict[str, Any]
Change = tuple[Value, Value]  # certificate, case


def replaced(value: Any, path: Sequence[Any], new: Any) -> Any:
    """A copy in which something else is at the end of the path; it shares all that is beside."""
    if not path:
        return new
    made = value.copy()
    made[path[0]] = replaced(value[path[0]], path[1:], new)
    return made


def places(value: Any, path: tuple[Any, ...] = ()) -> Iterator[tuple[Any, ...]]:
    if path:
        yield path
    if not isinstance(value, dict | list):
        return
    for name in value if isinstance(value, dict) else range(len(value)):
        yield from places(value[name], (*path, name))


def others(value: Any) -> Iterator[Any]:
    """Replacements for a value: near numbers, shorter, longer and reordered lists."""
    if isinstance(value, int):
        yield from (value - 1, value + 1, -value, value + 7, str(value))
    elif isinstance(value, str):
        if value.lstrip("-").replace("/", "").isdigit():
            number = Fraction(value)
            changed = (number + 1, number - 1, -number, number + Fraction(1, 1 << 70))
            yield from map(str, (*changed, number * 2, number / 2))
        yield from (value + "0", value[:-1])
    elif isinstance(value, list):
        yield from (value[1:], value[:-1], [*value, *value[-1:]], [*value[1:], *value[:1]])
        yield from (value[::-1], [*value[1:2], *value[:1], *value[2:]], [])


def changed(value: Any) -> Iterator[Any]:
    """Each place in each way; an integer may stand for the text of it."""
    for path in places(value):
        present = reduce(getitem, path, value)
        for other in others(present):
            if other != present:
                yield replaced(value, path, other)


def sample(values: Iterable[Change], most: int | None = None) -> list[Change]:
    """Some of them where few are drawn; else all, or so many."""
    every = list(values)
    count = min(len(every), draws(FEW, most or len(every)))
    print(f"{count} of {len(every)} changes, seed {SEED}")
    return random.Random(SEED).sample(every, count)


def verdicts_on(folder: Path, given: Sequence[tuple[Any, Any]]) -> list[int]:
    """The codes on certificates and cases, on which the two checkers agree."""
    files = []
    for number, (certificate, case) in enumerate(given):
        inside = folder / str(number)
        inside.mkdir()
        (inside / "case.json").write_text(json.dumps(case), encoding="utf-8")
        files.append(inside / "it.cert.json")
        files[-1].write_text(json.dumps(certificate), encoding="utf-8")
    python = verdicts(in_python(), files)
    cpp = verdicts(in_cpp(), files)
    for file, one, other in zip(files, python, cpp, strict=True):
        assert one.code == other.code, (file.read_text(encoding="utf-8"), one.why, other.why)
    return [one.code for one in python]
