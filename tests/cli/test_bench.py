"""`minkref bench`: the document, and the laws of its measurements."""

from __future__ import annotations

from collections.abc import Callable
from itertools import pairwise
from typing import Any

import jsonschema
import pytest
from minkref.fuzz.run.catalogue import Catalogue
from minkref.reports.bench import index, pairs, table1, table2
from minkref.reports.bench.rescalings import rescalings
from minkref.reports.bench.spread import least, spread
from minkref.schemas import schema

Minkref = Callable[..., Any]


@pytest.fixture
def few(monkeypatch: pytest.MonkeyPatch) -> None:
    """Two small polygons, and no large pairs; each time is taken once."""
    monkeypatch.setattr(table1, "PASSES", 1)
    monkeypatch.setattr(pairs, "SMALL", ("g1", "g3"))
    monkeypatch.setattr(pairs, "QUICK_LARGE", ())


def test_document_follows_its_schema_and_has_all_pairs(minkref: Minkref, few: None) -> None:
    ran = minkref("bench", "--quick", "--only", "table1", "--seed", "7", "--json")
    assert (ran.code, ran.err) == (0, "")
    jsonschema.validate(ran.json, schema("bench"))
    assert (ran.json["seed"], ran.json["table2"]) == (7, None)
    value = ran.json["table1"]
    names = {f"{P} + {Q}" for P in ("g1", "g3") for Q in ("g1", "g3")}
    assert {pair["name"] for pair in value["pairs"]} == names
    for baseline in ("pairwise", "contacts", "static"):
        rows = [row for row in value["rows"] if row["baseline"] == baseline]
        assert {row["name"] for row in rows} == names
        mean = sum(row["ratio"] for row in rows) / len(rows)
        assert value["mean_ratios"][baseline] == pytest.approx(mean)
    for row in value["rows"]:
        assert row["ours_s"] > 0 and row["ratio"] > 0
        assert row["ratio"] == pytest.approx(row["theirs"]["mean"] / row["ours"]["mean"])
        assert row["rescalings_timed"] == value["rescalings"] == 10
    assert value["wrong"] == []


def test_table_for_people_has_the_papers_figure_and_the_seed(minkref: Minkref, few: None) -> None:
    ran = minkref("bench", "--quick", "--only", "table1")
    assert ran.code == 0
    for text in ("150.68", "seed 1", "g1 + g3", "pairwise", "pays from"):
        assert text in ran.out


def test_table_2_follows_its_schema_and_has_all_pairs_twice(
    minkref: Minkref, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(table2, "MODELS", ("ti", "rod"))
    monkeypatch.setattr(table2, "PASSES", 1)
    run, measured = table2.run, list[table2.Table2]()

    def run_once(*words: Any) -> table2.Table2:
        """Gives the table for people the same measurement."""
        if not measured:
            measured.append(run(*words))
        return measured[0]

    monkeypatch.setattr(table2, "run", run_once)
    ran = minkref("bench", "--quick", "--only", "table2", "--json")
    assert (ran.code, ran.err) == (0, "")
    jsonschema.validate(ran.json, schema("bench"))
    assert ran.json["table1"] is None
    value = ran.json["table2"]
    kinds = [(row["P"], row["Q"], row["kind"]) for row in value["rows"]]
    assert len(set(kinds)) == len(kinds) == 8
    for row in value["rows"]:
        assert row["floor_ratio"] > 1 and row["traversal_ratio"] > 0
        assert row["chains_without_error"] == 0
    assert value["wrong"] == []
    assert "97.41" in minkref("bench", "--quick", "--only", "table2").out


def test_sum_that_differs_is_told_by_the_exit_code(
    minkref: Minkref, few: None, monkeypatch: pytest.MonkeyPatch
) -> None:
    def find(table: table1.Table1, *_: object) -> None:
        table.wrong.append("g1 + g1 at 2")

    monkeypatch.setattr(table1, "_check", find)
    ran = minkref("bench", "--quick", "--only", "table1")
    assert ran.code == 1
    assert "differs from the static one" in ran.out


def test_without_cgal_its_rows_are_left_out_with_a_note(
    minkref: Minkref, few: None, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(Catalogue, "entries", lambda _: [])
    document = minkref("bench", "--quick", "--only", "table1", "--json").json
    jsonschema.validate(document, schema("bench"))
    value = document["table1"]
    assert "cgal-reduced" not in {row["baseline"] for row in value["rows"]}
    assert any(note.startswith("cgal-reduced is left out") for note in value["notes"])


def test_unknown_part_is_refused(minkref: Minkref) -> None:
    ran = minkref("bench", "--only", "table3")
    assert (ran.code, ran.out) == (2, "")
    assert "table1" in ran.err


def test_rescalings_depend_on_the_seed_and_never_stay() -> None:
    scales = rescalings(1, 5000)
    assert scales == rescalings(1, 5000) != rescalings(2, 5000)
    assert rescalings(1, 100) == scales[:100]
    assert all(a != b for a, b in pairwise(scales))
    assert len(set(scales)) == 100
    assert {"1/10", "1", "7/5", "10"} <= set(scales)


def test_spread_and_least() -> None:
    found = spread([4.0, 1.0, 2.0, 3.0, 5.0])
    assert (found.count, found.mean, found.lower, found.median, found.upper) == (5, 3, 2, 3, 4)
    assert spread([2.0]).upper == 2
    assert least([[3.0, 1.0], [2.0, 4.0]]) == [2, 1]


def test_the_index_follows_its_schema(minkref: Minkref, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(index, "SMALL", ("g3",))
    monkeypatch.setattr(index, "QUICK_LARGE", ())
    ran = minkref("bench", "--quick", "--only", "index", "--json")
    assert (ran.code, ran.err) == (0, "")
    jsonschema.validate(ran.json, schema("bench"))
    (row,) = ran.json["index"]["rows"]
    assert row["lazy"]["single_sums"] >= 1
    assert 0 < row["lazy"]["first_seconds"] < row["lazy"]["seconds_when_built"]


def test_queries_pay_from_where_they_are_never_behind_again() -> None:
    assert index.pays_from([1, 2, 3], 2) == 1
    assert index.pays_from([1, 9, 9], 2) == 5
    assert index.pays_from([1, 3, 7, 7.5], 2) == 4
    assert index.pays_from([3, 3, 3], 2) == 2
    assert index.pays_from([1, 9, 18], 2) is None
    assert index.pays_from([1, 2, 6], 3) is None
