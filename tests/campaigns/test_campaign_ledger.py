"""The ledger of campaigns: what goes in comes out, compacted or not; answers are exact; damage is
refused; SQL reads nothing else."""

from __future__ import annotations

import json
import os
import shutil
import signal
import threading
from collections.abc import Callable
from pathlib import Path
from typing import Any

import pytest
from minkref.errors import Refusal
from minkref.fuzz.cases.case_name import CaseName
from minkref.fuzz.ledgers.compaction import compact, compact_if_due
from minkref.fuzz.ledgers.counting import counts, results_in, rows_of_ledger
from minkref.fuzz.ledgers.merging import merge_parts
from minkref.fuzz.ledgers.part import part_of, store_part, write_part
from minkref.fuzz.ledgers.place import chunks_in, look
from minkref.fuzz.ledgers.questions import QUESTIONS, batches, named
from minkref.fuzz.ledgers.views import opened, version_key
from minkref.fuzz.run.worker import CaseResult
from minkref.fuzz.verdicts.verdict import Outcome, Reason, Verdict, Witness

pytest.importorskip("duckdb")
CASES = 20


def result(number: int, is_wrong: bool) -> CaseResult:
    outcome = Outcome("lib@1.9", Verdict.PASS, seconds=0.25 * number)
    if is_wrong:
        witness = Witness(("1", "2"), True, p=("0", "0"))
        outcome = Outcome("lib@1.9", Verdict.WRONG, (Reason.MISSING,), seconds=1, witness=witness)
    skip = Outcome("other", Verdict.SKIPPED, message="does not declare holes")
    name = CaseName(f"random:1:{number}", "random")
    made = CaseResult(number, name, "3/2", [outcome, skip], "P", "Q", (3, 4, "a"))
    made.family, made.needs, made.dimension = "random", ("holes", "plane"), 2
    made.P = made.Q = "{}" if is_wrong else None
    return made


def fill(folder: Path, chunk: str, version: str, wrong: Callable[[int], bool]) -> list[CaseResult]:
    results = [result(number, wrong(number)) for number in range(CASES)]
    absent = CaseResult(CASES, CaseName("probe:1(x)", "probe"), "1", [], "", "", (0, 0, ""))
    absent.absent = "there is no event"
    head = {"versions": {"lib@1.9": version, "other": None}}
    write_part(folder, chunk, [absent, *reversed(results)], head)
    return [*results, absent]


@pytest.fixture
def ledger(tmp_path: Path) -> Path:
    fill(tmp_path / "a", "aaa-random-0", "1.9", lambda n: n % 7 == 0)  # 0 7 14
    fill(tmp_path / "a", "bbb-random-0", "1.10", lambda n: n % 5 == 0)  # 0 5 10 15
    return tmp_path / "a"


def answers(folder: Path) -> dict[str, list[dict[str, Any]]]:
    found = {}
    with opened(folder) as con:
        for name in QUESTIONS:
            _, rows = batches(con, named(name).sql)
            found[name] = [row for batch in rows for row in batch.to_pylist()]
    return found


def test_results_come_back(tmp_path: Path) -> None:
    """Law: what is amiss comes back whole, everything else with its verdict."""
    given = fill(tmp_path, "aaa-random-0", "1.9", lambda n: n % 7 == 0)
    back = results_in(tmp_path, "aaa-random-0")
    assert [each.number for each in back] == list(range(CASES + 1))
    assert back[7] == given[7] and back[CASES].absent == given[CASES].absent
    assert [o.verdict for o in back[1].outcomes] == [o.verdict for o in given[1].outcomes]
    assert chunks_in(tmp_path, "aaa") == {"aaa-random-0"} and not chunks_in(tmp_path, "bbb")


def test_a_part_is_written_once(ledger: Path) -> None:
    """Law: the order of results does not matter, but for times; a second part changes nothing."""
    results = results_in(ledger, "aaa-random-0")
    head = {"versions": {"lib@1.9": "1.9"}}
    one, other = (part_of("x-1", some, head, at=1.0) for some in (results, results[::-1]))
    assert one == other
    before = rows_of_ledger(ledger)
    store_part(ledger, "aaa-random-0", one)
    assert rows_of_ledger(ledger) == before
    with pytest.raises(Refusal, match="no name of a chunk"):
        store_part(ledger, "../x", one)


def test_compaction_changes_no_answer(ledger: Path) -> None:
    """Law: all questions answer alike before and after, also where a later version is wrong on a
    case on which nobody was, and where an ended compaction left its files."""
    changes = [
        (row["earlier"], row["version"], row["change"], row["cases"], row["example"])
        for row in answers(ledger)["regressions"]
    ]
    # 0 stays wrong; 5, 10, 15 are new; 7 and 14 are right now.
    assert changes == [
        ("1.9", "1.10", "broken", 3, "random:1:5"),
        ("1.9", "1.10", "mended", 2, "random:1:7"),
    ]
    for _ in range(2):
        before, rows = answers(ledger), rows_of_ledger(ledger)
        assert compact(ledger).rows >= 2 * (2 * CASES + 1)
        assert (answers(ledger), rows_of_ledger(ledger)) == (before, rows)
        assert not look(ledger).loose
        (ledger / "ledger" / "compacted" / "left.results.parquet").write_bytes(b"PAR1")
        fill(ledger, "ccc-random-0", "1.11", lambda n: n % 3 == 0)
    assert not compact_if_due(ledger)
    assert counts(ledger, "aaa")["lib@1.9", "wrong"] == 3
    assert sum(counts(ledger).values()) == 3 * 2 * CASES


def test_a_merge_is_the_union(ledger: Path, tmp_path: Path) -> None:
    """Law: whatever the files, all chunks are there once; chunks that differ are told."""
    compact(ledger)
    other = tmp_path / "other"
    fill(other, "ccc-random-0", "1.11", lambda n: False)
    fill(other, "aaa-random-0", "1.9", lambda n: n == 1)
    done = merge_parts([ledger, other], tmp_path / "both")
    assert (done.chunks, done.repeated, done.differing) == (3, 1, ["aaa-random-0"])
    again = merge_parts([ledger, other], tmp_path / "both")
    assert (again.chunks, again.repeated) == (0, 4)
    assert rows_of_ledger(tmp_path / "both", "bbb") == rows_of_ledger(ledger, "bbb")


@pytest.mark.parametrize("damage", ["torn", "foreign", "flipped", "list", "compacted"])
def test_damage_is_refused(ledger: Path, damage: str) -> None:
    """A torn or foreign file names itself and the way out; a changed byte is seen where it is
    read."""
    part = ledger / "ledger" / "parts" / "aaa-random-0.parquet"
    data = bytearray(part.read_bytes())
    if damage in ("list", "compacted"):
        compact(ledger)
        pattern = "list.json" if damage == "list" else "*.results.parquet"
        (path,) = (ledger / "ledger" / "compacted").glob(pattern)
        path.write_bytes(path.read_bytes()[:-3])
        ask: Callable[[Path], Any] = answers
    elif damage == "flipped":
        path, ask = part, compact
        data[60] ^= 1
        path.write_bytes(data)
    else:
        path, ask = part, answers
        other = ledger / "other.parquet"
        pandas = pytest.importorskip("pyarrow")
        pandas.parquet.write_table(pandas.table({"x": [1]}), other)
        path.write_bytes(data[:-9] if damage == "torn" else other.read_bytes())
    with pytest.raises(Refusal) as refused:
        ask(ledger)
    assert str(path) in refused.value.where and refused.value.mend


@pytest.mark.parametrize(
    "sql",
    [
        "COPY results TO '{0}/out.csv'",
        "WITH x AS (SELECT 1) COPY x TO '{0}/out.csv'",
        "SELECT * FROM read_text('{0}/secret')",
        "SELECT * FROM '{0}/secret.csv'",
        "SELECT * FROM glob('{0}/*')",
        "ATTACH '{0}/out.db'",
        "EXPORT DATABASE '{0}/out'",
        "SET enable_external_access = true",
        "SELECT 1; SELECT 2",
        "INSTALL httpfs",
        "FROM Path",
        "SELECT",
    ],
)
def test_sql_reads_and_writes_nothing_else(ledger: Path, tmp_path: Path, sql: str) -> None:
    (tmp_path / "secret").write_text("1\n")
    shutil.copy(tmp_path / "secret", tmp_path / "secret.csv")
    before = sorted(tmp_path.rglob("*"))
    with opened(ledger) as con, pytest.raises(Refusal):
        _, rows = batches(con, sql.format(tmp_path))
        list(rows)
    assert sorted(path for path in tmp_path.rglob("*") if path.name != "readers.lock") == [
        path for path in before if path.name != "readers.lock"
    ]


def test_a_signal_ends_a_question(ledger: Path) -> None:
    """DuckDB would go on for hours."""
    sql = "SELECT count(*) FROM range(100000) a, range(100000) b, range(1000) c WHERE a.range = 7"
    sql += " AND b.range + c.range = random()"
    threading.Timer(0.5, os.kill, (os.getpid(), signal.SIGINT)).start()
    with pytest.raises(KeyboardInterrupt), opened(ledger) as con:
        _, rows = batches(con, sql)
        list(rows)


def test_versions_are_ordered_by_their_numbers() -> None:
    texts = ["3.9", "3.12", "3.12.1", "3.12.1 (Shapely 2.0.7)", "3.12.1 (Shapely 2.1.0)", "10"]
    assert sorted(reversed(texts), key=version_key) == texts


def test_a_finding_has_all_that_it_needs(ledger: Path) -> None:
    compact(ledger)
    with opened(ledger) as con:
        _, rows = batches(con, "FROM findings WHERE number = 7")
        (row,) = [row for batch in rows for row in batch.to_pylist()]
    assert row["P"] == "{}" and json.loads(row["witness"])["point"] == ["1", "2"]
    assert json.loads(row["finding"])["outcomes"][0]["reasons"] == ["missing"]
