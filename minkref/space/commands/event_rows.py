"""Events in space as rows: JSON, JSON lines or Parquet."""

from __future__ import annotations

import heapq
import json
from collections.abc import Iterable, Iterator, Sequence
from fractions import Fraction
from itertools import chain, islice
from pathlib import Path
from typing import Any

from minkref import _core
from minkref.errors import Refusal
from minkref.exact import rounded
from minkref.output.documents import replacing
from minkref.space.commands.event_parts import Part

ROWS = 1 << 15  # that are in memory, and in one group of a table
Row = dict[str, Any]


def rows_of(part: Part, kind: str) -> Iterator[Row]:
    """Those of a kind."""
    of_pairs = _of_pairs(part) if kind != "triple" else iter(())
    of_more = _of_more(part) if kind != "pair" else iter(())
    if kind != "arrangement":
        return chain(of_pairs, of_more)
    return heapq.merge(of_pairs, of_more, key=lambda row: Fraction(row["s"]))


def as_lines(rows: Iterable[Row]) -> Iterator[str]:
    for row in rows:
        yield json.dumps(row) + "\n"


def write_parquet(rows: Iterator[Row], path: Path) -> None:
    """A row each: what a line of JSON has, and `s_double`, the scale rounded. Group by group;
    written whole or not at all. Refuses without pyarrow."""
    try:
        import pyarrow as pa
        import pyarrow.parquet as parquet
    except ImportError as error:
        raise Refusal(
            "Parquet is written by pyarrow, which is not installed",
            str(path),
            "pip install 'minkref[parquet]', or name a .jsonl file",
            "no-pyarrow",
        ) from error
    vertices = pa.list_(pa.uint32())
    facet = pa.struct([
        ("facet", pa.string()), ("P", vertices), ("Q", vertices), ("corner", pa.uint8()),
        ("side", pa.uint8()),
    ])  # fmt: skip
    schema = pa.schema([
        ("s", pa.string()), ("s_double", pa.float64()), ("kind", pa.string()),
        ("change", pa.string()), ("facets", pa.list_(facet)), ("place", pa.list_(pa.string())),
    ])  # fmt: skip
    with replacing(path) as temporary, parquet.ParquetWriter(temporary, schema) as writer:
        while group := list(islice(rows, ROWS)):
            for row in group:
                row["s_double"] = float(Fraction(row["s"]))
            writer.write_table(pa.Table.from_pylist(group, schema))


def _of_pairs(part: Part) -> Iterator[Row]:
    for s, kind, change, first, of_first, second, of_second, place in part.rows_of_pairs():
        is_side = kind == "edge"
        facets = [
            _facet(part.found, number, None if is_side else at, at if is_side else None)
            for number, at in ((first, of_first), (second, of_second))
        ]
        yield _row(s, kind, change, facets, place)


def _of_more(part: Part) -> Iterator[Row]:
    for s, kind, change, numbers, sides, place in part.rows_of_more():
        facets = [
            _facet(part.found, number, None, side)
            for number, side in zip(numbers, sides, strict=True)
        ]
        yield _row(s, kind, change, facets, place)


def _row(s: str, kind: str, change: str, facets: list[Row], place: Sequence[str] | None) -> Row:
    at = None if place is None else list(place)
    return {"s": s, "kind": kind, "change": change, "facets": facets, "place": at}


def _facet(found: _core.SpaceEvents, number: int, corner: int | None, side: int | None) -> Row:
    facet, of_P, of_Q = found.facet(number)
    return {"facet": facet, "P": of_P, "Q": of_Q, "corner": corner, "side": side}


def in_words(row: Row) -> str:
    touching = " and ".join(
        f"{one['facet']} {'-'.join(map(str, dict.fromkeys(one['P'])))}"
        f" + {'-'.join(map(str, dict.fromkeys(one['Q'])))}"
        for one in row["facets"]
    )
    return f"{rounded(row['s']):>14}  {row['kind']} {row['change']}: {touching}"
