"""The tables that questions are asked of, in DuckDB: made of the files of a ledger that count, for
reading alone."""

from __future__ import annotations

import json
import re
from collections.abc import Iterator, Sequence
from contextlib import contextmanager
from pathlib import Path
from typing import Any

from minkref.errors import Refusal, cut
from minkref.fuzz.ledgers.file import chunks_of, columns, pyarrow
from minkref.fuzz.ledgers.heard import run
from minkref.fuzz.ledgers.place import Place, is_ledger, look, reading

GOOD = "('pass', 'pass-within')"
AMISS = "verdict NOT IN ('pass', 'pass-within', 'skipped')"
SUBJECT = "regexp_replace(target, '@v?[0-9][^@]*$', '')"
GROUPS = "campaign, target, version, setting, question, family, position, flags, verdict, was, kind"
COUNTS = f"""SELECT {GROUPS}, count(*) AS cases, sum(seconds) AS seconds,
    max(seconds) AS most_seconds, arg_max("case", seconds) AS slowest,
    min(judged_at) AS first_at, max(judged_at) AS last_at,
    arg_min("case", {{'size': length("case"), 'name': "case"}}) FILTER (WHERE {AMISS}) AS example
    FROM rows WHERE target IS NOT NULL GROUP BY {GROUPS}"""
MERGED = f"""SELECT {GROUPS}, sum(cases)::BIGINT AS cases, sum(seconds) AS seconds,
    max(most_seconds) AS most_seconds, arg_max(slowest, most_seconds) AS slowest,
    min(first_at) AS first_at, max(last_at) AS last_at,
    arg_min(example, {{'size': length(example), 'name': example}}) AS example
    FROM all_counts GROUP BY {GROUPS}"""
MEMORY = 2048  # MiB


@contextmanager
def opened(folder: Path, memory: int = MEMORY) -> Iterator[Any]:
    """A connection of DuckDB to the views of a ledger: `results`, `findings`, `counts`, `disputed`,
    `versions`, `campaigns`. It can read nothing else, and write nothing. `memory`: MiB. Refuses a
    folder without ledger, torn and foreign parts."""
    if not is_ledger(folder):
        mend = "name the folder of a campaign: minkref campaign run FILE.toml"
        raise Refusal("there is no ledger in this folder", str(folder), mend, "no-ledger")
    with reading(folder):
        place = look(folder)
        for path in place.loose:
            chunks_of(path)
        with connection(memory) as con:
            _make_views(con, place)
            _close_doors(con, place)
            yield con


@contextmanager
def connection(memory: int = MEMORY, scratch: Path | None = None) -> Iterator[Any]:
    """A DuckDB without files. `scratch`: a folder for what does not fit into the memory."""
    try:
        import duckdb
    except ImportError as error:
        mend = "pip install 'minkref[campaign]'"
        what = "a ledger is asked by duckdb, which is not installed"
        raise Refusal(what, "minkref campaign", mend, "missing-package") from error
    settings: dict[str, str | bool | int | float | list[str]] = {
        "memory_limit": f"{memory}MiB",
        "temp_directory": str(scratch or ""),
        "autoinstall_known_extensions": False,
        "autoload_known_extensions": False,
        "python_enable_replacements": False,
        "preserve_insertion_order": False,
    }
    con = duckdb.connect(":memory:", config=settings)
    try:
        run(con, "SET enable_progress_bar = false")  # it would go to standard output
        yield con
    finally:
        con.abort()  # an answer that a signal left unread
        con.close()


def rows_view(con: Any, name: str, paths: Sequence[Path], like: Any = None) -> None:
    """Makes a view of all rows of these files, which are alike; an empty one of no file."""
    if paths:
        files = ", ".join(_quoted(str(path)) for path in paths)
        run(con, f"CREATE VIEW {name} AS SELECT * FROM read_parquet([{files}])")
    else:
        pa = pyarrow()
        table = pa.schema(like or columns()).empty_table()
        con.register(f"{name}_empty", table)
        run(con, f"CREATE TABLE {name} AS SELECT * FROM {name}_empty")
        con.unregister(f"{name}_empty")


def _make_views(con: Any, place: Place) -> None:
    rows_view(con, "compacted", place.files("results"))
    rows_view(con, "loose", place.loose)
    rows_view(con, "compacted_disputed", place.files("disputed"))
    run(con, "CREATE VIEW rows AS SELECT * FROM loose")
    run(con, f"CREATE VIEW loose_counts AS {COUNTS}")
    if place.compacted:
        files = ", ".join(_quoted(str(path)) for path in place.files("counts"))
        all_counts = f"SELECT * FROM read_parquet([{files}]) UNION ALL FROM loose_counts"
    else:
        all_counts = "FROM loose_counts"
    run(con, f"CREATE VIEW all_counts AS {all_counts}")
    # Small, asked again and again: a table.
    source = f"({MERGED})" if place.compacted or place.loose else "loose_counts"
    table = f"CREATE TABLE counts AS SELECT {SUBJECT} AS subject, * FROM {source}"
    run(con, table)
    run(
        con,
        f"CREATE VIEW results AS SELECT {SUBJECT} AS subject, * EXCLUDE (finding) "
        "FROM (FROM compacted UNION ALL FROM loose) WHERE target IS NOT NULL",
    )
    _make_disputed(con)
    members = {
        name: f"json_extract_string(finding, '$.{name}')" for name in ("P", "Q", "expected")
    } | {
        name: f"json_extract_string(finding, '$.outcomes[0].{name}')"
        for name in ("got", "signal", "witness", "log")
    }
    told = ", ".join(f"{text} AS {name}" for name, text in members.items())
    run(con, f"CREATE VIEW findings AS SELECT *, {told} FROM disputed_whole WHERE {AMISS}")
    run(con, "CREATE VIEW disputed AS SELECT * EXCLUDE (finding) FROM disputed_whole")
    _make_versions(con)
    _make_campaigns(con, place.folder)


def _make_disputed(con: Any) -> None:
    """All rows on cases that any target got wrong. Compacted rows are looked through only if a
    loose part has a wrong answer on a case on which nobody was known to be wrong."""
    table = f"""CREATE TABLE late AS SELECT DISTINCT "case" FROM loose WHERE {AMISS}
        EXCEPT SELECT DISTINCT "case" FROM compacted_disputed"""
    run(con, table)
    ((late,),) = run(con, "SELECT count(*) FROM late")
    known = '(SELECT "case" FROM late UNION ALL SELECT "case" FROM compacted_disputed)'
    sources = [
        "SELECT * FROM compacted_disputed",
        f'SELECT * FROM loose WHERE target IS NOT NULL AND "case" IN {known}',
    ]
    if late:
        sources.append('SELECT * FROM compacted WHERE target IS NOT NULL AND "case" IN (FROM late)')
    run(
        con,
        f"CREATE VIEW disputed_whole AS SELECT {SUBJECT} AS subject, * "
        f"FROM ({' UNION ALL '.join(sources)})",
    )


def _make_versions(con: Any) -> None:
    """The versions of each subject, in order: numbers in them count as numbers."""
    pairs = run(con, "SELECT DISTINCT subject, version FROM counts")
    pairs.sort(key=lambda pair: (pair[0], version_key(pair[1])))
    ranks: dict[str, int] = {}
    run(con, "CREATE TABLE versions (subject VARCHAR, version VARCHAR, place INTEGER)")
    for subject, version in pairs:
        ranks[subject] = ranks.get(subject, 0) + 1
        run(con, "INSERT INTO versions VALUES (?, ?, ?)", [subject, version, ranks[subject]])


def version_key(version: str) -> list[tuple[int, str]]:
    """Orders versions: 3.9 before 3.12."""
    words = re.findall(r"[0-9]+|[A-Za-z]+", version)
    return [(int(w), "") if w.isdigit() else (-1, w) for w in words]


def _make_campaigns(con: Any, folder: Path) -> None:
    """The heads of campaigns, as the engine wrote them."""
    run(
        con,
        "CREATE TABLE heads (campaign VARCHAR, name VARCHAR, seed VARCHAR, minkref VARCHAR, "
        "head VARCHAR)",
    )
    for path in sorted((folder / "campaigns").glob("*.json")):
        try:
            value: Any = json.loads(path.read_text(encoding="utf-8"))
            told = [value.get("name"), value.get("seed"), value.get("minkref")]
        except (OSError, ValueError, AttributeError, RecursionError) as error:
            what = f"this is no head of a campaign: {cut(str(error))}"
            mend = "remove it, and go on with the campaign"
            raise Refusal(what, str(path), mend, "bad-ledger") from error
        words = [None if each is None else str(each) for each in told]
        run(con, "INSERT INTO heads VALUES (?, ?, ?, ?, ?)", [path.stem, *words, str(value)])
    run(
        con,
        "CREATE VIEW campaigns AS SELECT c.campaign, name, seed, minkref, results, targets, "
        "first_at, last_at FROM (SELECT campaign, sum(cases)::BIGINT AS results, "
        "count(DISTINCT target) AS targets, min(first_at) AS first_at, max(last_at) AS last_at "
        "FROM counts GROUP BY campaign) AS c LEFT JOIN heads USING (campaign)",
    )


def _close_doors(con: Any, place: Place) -> None:
    paths = [*place.loose, *(p for kind in ("results", "disputed") for p in place.files(kind))]
    run(con, f"SET allowed_paths = [{', '.join(_quoted(str(path)) for path in paths)}]")
    run(con, "SET enable_external_access = false")
    run(con, "SET lock_configuration = true")


def _quoted(text: str) -> str:
    return "'" + text.replace("'", "''") + "'"
