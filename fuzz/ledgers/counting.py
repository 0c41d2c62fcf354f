"""Counts and rows of a ledger in Python."""

from __future__ import annotations

from collections.abc import Iterator
from pathlib import Path
from typing import Any

from minkref.fuzz.ledgers.file import TIMES, Chunk, chunks_of, columns, read_table
from minkref.fuzz.ledgers.heard import run
from minkref.fuzz.ledgers.place import Place, look, reading
from minkref.fuzz.ledgers.row import results_of
from minkref.fuzz.ledgers.views import opened
from minkref.fuzz.run.worker import CaseResult


def counts(folder: Path, campaign: str | None = None) -> dict[tuple[str, str], int]:
    """Counts answers by target and verdict, of one campaign or all."""
    with opened(folder) as con:
        found = run(
            con,
            "SELECT target, verdict, sum(cases)::BIGINT FROM counts "
            "WHERE campaign = coalesce(?, campaign) GROUP BY ALL ORDER BY ALL",
            [campaign],
        )
    return {(target, verdict): number for target, verdict, number in found}


class Chunks:
    """The rows of single chunks. Keeps the file that was read last."""

    def __init__(self, place: Place) -> None:
        held = {
            chunk: each.path(place.folder, "results")
            for each in place.compacted
            for chunk in each.chunks
        }
        self._files = held | {path.stem: path for path in place.loose}
        self._path: Path | None = None
        self._rows: dict[str, Any] = {}
        self._told: dict[str, Chunk] = {}

    def __contains__(self, chunk: str) -> bool:
        return chunk in self._files

    def __iter__(self) -> Iterator[str]:
        return iter(self._files)

    def rows(self, chunk: str) -> Any:
        """The rows of a chunk as an Arrow table. KeyError if it is not there."""
        self._read(self._files[chunk])
        return self._rows[chunk]

    def told(self, chunk: str) -> Chunk:
        """The footer's numbers of a chunk. KeyError if it is not there."""
        self._read(self._files[chunk])
        return self._told[chunk]

    def _read(self, path: Path) -> None:
        if path == self._path:
            return
        self._path, table, row = path, read_table(path), 0
        self._told, self._rows = chunks_of(path), {}
        for chunk, known in self._told.items():  # they follow each other in a file
            self._rows[chunk] = table.slice(row, known.rows)
            row += known.rows


def results_in(folder: Path, chunk: str) -> list[CaseResult]:
    """The results of a chunk (row.py says what of them comes back). KeyError if it is not there."""
    with reading(folder):
        return results_of(Chunks(look(folder)).rows(chunk).to_pylist())


def rows_of_ledger(folder: Path, campaign: str | None = None) -> Any:
    """All rows without TIMES, an Arrow table in the order of chunk, number and target: equal for
    two ledgers with the same results. In memory as a whole."""
    import pyarrow as pa

    with reading(folder):
        place = look(folder)
        tables = [read_table(path) for path in [*place.files("results"), *place.loose]]
    plain = [plain_rows(table, campaign) for table in tables]
    if not plain:
        return plain_rows(columns().empty_table())
    order = [("chunk", "ascending"), ("number", "ascending"), ("target", "ascending")]
    return pa.concat_tables(plain).sort_by(order)


def plain_rows(table: Any, campaign: str | None = None) -> Any:
    """A table without dictionaries, which differ from file to file, and without times, those of
    findings too."""
    import pyarrow as pa
    import pyarrow.compute as pc

    if campaign is not None:
        table = table.filter(pc.equal(table["campaign"], campaign))
    table = table.drop_columns(list(TIMES))
    fields = [
        pa.field(f.name, f.type.value_type if pa.types.is_dictionary(f.type) else f.type)
        for f in table.schema
    ]
    table = table.cast(pa.schema(fields))
    at = table.schema.get_field_index("finding")
    bare = pc.replace_substring_regex(table["finding"], r'"seconds":[0-9.e+-]+', '"seconds":0')
    return table.set_column(at, "finding", bare)
