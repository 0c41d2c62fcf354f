"""Compaction: many small parts become few large files, with exact counts beside them and all rows
on cases that any target got wrong, so that questions need not read every row.

Crash-safe: a file counts once the list names it (place.py), and parts are removed afterwards.
Memory is bounded by ROWS, whatever the ledger's size.
"""

from __future__ import annotations

import fcntl
import os
import secrets
from collections.abc import Iterator, Sequence
from contextlib import contextmanager
from dataclasses import dataclass
from pathlib import Path
from typing import Any

from minkref.errors import Refusal
from minkref.fuzz.ledgers import place as places
from minkref.fuzz.ledgers.file import chunks_of, columns, keep_names, read_table, writer
from minkref.fuzz.ledgers.heard import heard, heard_batches, run
from minkref.fuzz.ledgers.place import Compacted, Place
from minkref.fuzz.ledgers.views import AMISS, COUNTS, MERGED, connection, rows_view

ROWS = 4_000_000  # in a compacted file, about
GROUP = 1 << 17  # rows in a group of a file
DUE = 200  # loose parts from which compaction pays
MEMORY = 2048  # MiB


@dataclass(frozen=True)
class Done:
    """Numbers of files that a compaction wrote, and of rows and chunks in them."""

    files: int
    rows: int
    chunks: int


def compact(folder: Path, rows: int = ROWS) -> Done:
    """Compacts all loose parts. Readers and writers go on meanwhile. Refuses damaged parts, and a
    ledger that is being compacted."""
    with _alone(folder) as is_alone:
        if not is_alone:
            what = "this ledger is being compacted"
            raise Refusal(what, str(folder), "wait for the other one", "busy")
        return _compact(folder, rows)


def compact_if_due(folder: Path, due: int = DUE) -> bool:
    """Compacts if there are many loose parts, and nobody else does. Tells whether it did."""
    if len(places.look(folder).loose) < due:
        return False
    with _alone(folder) as is_alone:
        if is_alone:
            _compact(folder, ROWS)
        return is_alone


def _compact(folder: Path, rows: int) -> Done:
    files = count = chunks = 0
    while True:
        place = places.look(folder)
        taken = _next(place, rows)
        if not taken.loose:
            break
        made = _write(place, taken)
        kept = [each for each in place.compacted if each not in taken.small]
        places.write_list(folder, [*kept, made])
        files, count, chunks = files + 1, count + made.rows, chunks + len(made.chunks)
        places.sweep(folder)
    places.sweep(folder)
    return Done(files, count, chunks)


@dataclass(frozen=True)
class _Taken:
    """Sources of the next file: loose parts, and compacted files that are small."""

    small: list[Compacted]
    loose: list[Path]


def _next(place: Place, rows: int) -> _Taken:
    small = [each for each in place.compacted if each.rows < rows // 2] if place.loose else []
    total, loose = sum(each.rows for each in small), []
    for path in place.loose:
        if total >= rows:
            break
        total += sum(chunk.rows for chunk in chunks_of(path).values())
        loose.append(path)
    return _Taken(small, loose)


def _write(place: Place, taken: _Taken) -> Compacted:
    folder = places.compacted_folder(place.folder)
    folder.mkdir(parents=True, exist_ok=True)
    name = f"{len(place.inside):010d}-{secrets.token_hex(6)}"
    sources = [*(s.path(place.folder, "results") for s in taken.small), *taken.loose]
    chunks = {n: c for path in sources for n, c in chunks_of(path).items()}
    paths = {kind: folder / f"{name}.{kind}.parquet" for kind in places.KINDS}
    with _written(paths["results"], columns(), chunks) as out:
        for table in _tables(sources):
            out.write_table(table, row_group_size=GROUP)
    with connection(MEMORY, folder / f".scratch-{name}") as con:
        rows_view(con, "rows", [paths["results"]])
        old = [each.path(place.folder, "counts") for each in taken.small]
        _counts(con, taken.loose, old, paths["counts"])
        _disputed(con, place, taken, paths["disputed"])
    keep_names(folder)
    sizes = {kind: path.stat().st_size for kind, path in paths.items()}
    plain = {n: list(vars(chunk).values()) for n, chunk in chunks.items()}
    return Compacted(name, sum(chunk.rows for chunk in chunks.values()), plain, sizes)


def _tables(sources: Sequence[Path]) -> Iterator[Any]:
    """The rows of all files, with their checksums verified, some thousand at a time."""
    import pyarrow as pa

    waiting: list[Any] = []
    for path in sources:
        waiting.append(read_table(path))
        if sum(table.num_rows for table in waiting) >= GROUP:
            yield pa.concat_tables(waiting).unify_dictionaries()
            waiting = []
    if waiting:
        yield pa.concat_tables(waiting).unify_dictionaries()


def _counts(con: Any, loose: Sequence[Path], old: Sequence[Path], path: Path) -> None:
    """The counts of all rows of the new file."""
    run(con, "ALTER VIEW rows RENAME TO every_row")
    rows_view(con, "rows", loose)
    run(con, f"CREATE TABLE fresh AS {COUNTS}")
    run(con, "CREATE VIEW all_counts AS FROM fresh")
    if old:
        rows_view(con, "old_counts", old)
        run(con, "CREATE OR REPLACE VIEW all_counts AS FROM fresh UNION ALL FROM old_counts")
    _copy(con, MERGED, path)


def _disputed(con: Any, place: Place, taken: _Taken, path: Path) -> None:
    """All rows on cases that any target got wrong, as far as no other file has them: of the new
    parts; and of all older files on cases on which nobody was wrong before."""
    others = [each for each in place.compacted if each not in taken.small]
    rows_view(con, "known", place.files("disputed"))
    rows_view(con, "kept", [each.path(place.folder, "disputed") for each in taken.small])
    old = [each.path(place.folder, "results") for each in others]
    old += [each.path(place.folder, "results") for each in taken.small]
    rows_view(con, "old", old)
    run(con, 'CREATE TABLE known_cases AS SELECT DISTINCT "case" FROM known')
    run(
        con,
        f'CREATE TABLE fresh_cases AS SELECT DISTINCT "case" FROM rows WHERE {AMISS} '
        "EXCEPT FROM known_cases",
    )
    both = "(FROM known_cases UNION ALL FROM fresh_cases)"
    query = f'FROM kept UNION ALL SELECT * FROM rows WHERE target IS NOT NULL AND "case" IN {both}'
    ((fresh,),) = run(con, "SELECT count(*) FROM fresh_cases")
    if fresh:
        query += ' UNION ALL SELECT * FROM old WHERE target IS NOT NULL AND "case" IN '
        query += "(FROM fresh_cases)"
    _copy(con, query, path)


def _copy(con: Any, query: str, path: Path) -> None:
    """Writes the rows of a query with checksums, some at a time."""
    reader = heard(con, lambda: con.sql(query).to_arrow_reader(GROUP))
    with _written(path, reader.schema, {}) as out:
        for batch in heard_batches(con, reader):
            out.write_batch(batch)


@contextmanager
def _written(path: Path, schema: Any, chunks: Any) -> Iterator[Any]:
    """A writer to a new file, to last through a loss of power once closed."""
    try:
        with path.open("xb") as stream:
            with writer(stream, schema, chunks) as out:
                yield out
            stream.flush()
            os.fsync(stream.fileno())
    except OSError as error:
        what = f"the ledger cannot be written: {error.strerror}"
        raise Refusal(what, str(path), "free some space", "cannot-write") from error


@contextmanager
def _alone(folder: Path) -> Iterator[bool]:
    """Whether no other process compacts this ledger."""
    try:
        path = folder / "ledger" / "compaction.lock"
        if places.is_ledger(folder):
            path.parent.mkdir(exist_ok=True)
        file = os.open(path, os.O_RDWR | os.O_CREAT | os.O_CLOEXEC, 0o644)
    except OSError as error:
        what = f"the ledger cannot be written: {error.strerror}"
        raise Refusal(what, str(folder), "name the folder of a campaign", "no-ledger") from error
    try:
        fcntl.flock(file, fcntl.LOCK_EX | fcntl.LOCK_NB)
        yield True
    except BlockingIOError:
        yield False
    finally:
        os.close(file)
