"""The index of all radii as the commands use it: built, or proven again from its file."""

from __future__ import annotations

import json
from collections.abc import Callable
from pathlib import Path
from typing import Any, TypeVar

from minkref import _core
from minkref.errors import Refusal, refusing
from minkref.file_text import text_of_file
from minkref.plane.commands.scale_index import cores
from minkref.plane.operand import Operand

MOST = 1 << 32  # features and branches are numbers below
LONGEST = 1 << 30  # bytes of a file


Places = list[tuple[int, int, int, int]]
Found = TypeVar("Found")


def disc_index_of(path: Path | None, P: Operand, threads: int | None = None) -> _core.DiscIndex:
    return from_places(path, P, lambda places: _core.disc_index(P.set, threads or cores(), places))


def from_places(path: Path | None, P: Operand, make: Callable[[Places | None], Found]) -> Found:
    """The result of `make`: without a file anew, else with the file's places of events. Each place
    is proven again, and also that none is missing: a file that tells lies is refused."""
    if path is None:
        return refusing(P.name, lambda: make(None))
    places = _places(path)
    try:
        return make(places)
    except _core.BadInput as error:
        raise Refusal(
            f"the index does not belong to {P.name}",
            str(path),
            "give the set that it was built from, or build another",
            "other-operands",
        ) from error


def _places(path: Path) -> Places:
    mend = "write one: minkref index P disc -o FILE.json"
    text = text_of_file(path, str(path), mend, LONGEST)

    def refused(why: str) -> Refusal:
        return Refusal(f"this is no index of all radii: {why}", str(path), mend, "not-an-index")

    try:
        value: Any = json.loads(text)
    except (ValueError, RecursionError) as error:
        raise refused("it is not JSON") from error
    rows = value.get("places") if isinstance(value, dict) else None
    if not isinstance(rows, list) or not all(map(_is_place, rows)):
        raise refused("it has no list of places")
    return [tuple(row) for row in rows]


def _is_place(row: Any) -> bool:
    return (
        isinstance(row, list)
        and len(row) == 4
        and all(type(number) is int and 0 <= number < MOST for number in row)
    )
