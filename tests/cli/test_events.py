"""`minkref events`: documents, tables, windows."""

from __future__ import annotations

from collections.abc import Callable
from fractions import Fraction
from pathlib import Path
from typing import Any

import jsonschema
import pyarrow.parquet
import pytest
from minkref.schemas import result_schema, schema

Minkref = Callable[..., Any]


def test_document_follows_the_published_schema(minkref: Minkref) -> None:
    jsonschema.Draft202012Validator.check_schema(schema("events"))
    for extra in ([], ["--kind", "parallel"], ["--form", "printed"], ["--arithmetic", "mpfr:24"]):
        ran = minkref("events", "g3", "disc1", "--json", *extra)
        assert (ran.code, ran.err) == (0, "")
        jsonschema.validate(ran.json, result_schema("events"))


def test_events_ascend_and_equal_scales_have_equal_ranks(minkref: Minkref) -> None:
    value = minkref("events", "g1", "g2", "--json").json
    scales = [Fraction(event["s"]) for event in value["events"]]
    ranks = [event["rank"] for event in value["events"]]
    assert value["count"] == len(scales) > 1000
    assert scales == sorted(scales)
    assert value["distinct"] == len(set(scales)) == ranks[-1] + 1
    assert all(
        (s == t) == (i == j)
        for s, t, i, j in zip(scales, scales[1:], ranks, ranks[1:], strict=False)
    )


def test_a_closed_window_holds_the_events_at_its_ends(minkref: Minkref) -> None:
    every = minkref("events", "g1", "g2", "--json").json["events"]
    first, last = every[100]["s"], every[900]["s"]
    within = minkref("events", "g1", "g2", "--from", first, "--to", last, "--json").json["events"]
    expected = [e for e in every if Fraction(first) <= Fraction(e["s"]) <= Fraction(last)]
    assert [(e["s"], e["parents"]) for e in within] == [(e["s"], e["parents"]) for e in expected]


def test_sides_that_always_lie_on_one_line_have_no_events(
    minkref: Minkref, squares: tuple[Path, Path]
) -> None:
    value = minkref("events", *squares, "--kind", "parallel", "--json").json
    assert (value["parallel_pairs"], value["events"]) == (4, [])


def test_steps_of_equal_height_come_to_one_line(minkref: Minkref, tmp_path: Path) -> None:
    # The steps of an L lie at heights 1 and 2: s + 2 = 2 s + 1 at s = 1 only.
    steps = tmp_path / "steps.wkt"
    steps.write_text("POLYGON((0 0,2 0,2 1,1 1,1 2,0 2,0 0))", encoding="utf-8")
    events = minkref("events", steps, steps, "--kind", "parallel", "--json").json["events"]
    assert events
    assert {event["s"] for event in events} == {"1"}
    assert {event["change"] for event in events} <= {"touch", "overlap"}


def test_parquet_and_json_hold_the_same_events(minkref: Minkref, tmp_path: Path) -> None:
    path = tmp_path / "events.parquet"
    ran = minkref("events", "g3", "disc1", "-o", path)
    assert ran.code == 0
    rows = pyarrow.parquet.read_table(path).to_pylist()
    events = minkref("events", "g3", "disc1", "--json").json["events"]
    assert len(rows) == len(events)
    for row, event in zip(rows, events, strict=True):
        assert (row["s"], row["rank"], row["change"]) == (
            event["s"],
            event["rank"],
            event["change"],
        )
        for side, parent in zip("ab", event["parents"], strict=True):
            assert row[f"{side}_kind"] == parent["kind"]
            assert [row[f"{side}_edge_ring"], row[f"{side}_edge"]] == parent["edge"]
            assert [row[f"{side}_vertex_ring"], row[f"{side}_vertex"]] == parent["vertex"]
        assert row["s_double"] == float(Fraction(event["s"]))


@pytest.mark.parametrize(
    ("options", "word"),
    [
        (["--from", "0"], "zero"),
        (["--from", "2", "--to", "1"], "empty"),
        (["--to", "x"], "not a number"),
        (["--kind", "quadruple"], "kind"),
        (["--form", "other"], "form"),
        (["--arithmetic", "float"], "arithmetic"),
        (["-o", "events.csv"], "ending"),
    ],
)
def test_a_bad_option_is_refused_with_a_mend(
    minkref: Minkref, options: list[str], word: str
) -> None:
    ran = minkref("events", "g1", "g2", *options)
    assert (ran.code, ran.out) == (2, "")
    assert word in ran.err
    assert "fix:" in ran.err


def test_the_printed_form_misses_events_and_says_that_it_is_printed(minkref: Minkref) -> None:
    printed = minkref("events", "g1", "g2", "--form", "printed", "--json").json
    corrected = minkref("events", "g1", "g2", "--json").json
    assert printed["form"] == "printed"
    assert printed["count"] != corrected["count"]


def test_an_arithmetic_reports_what_it_got_beside_what_is_true(minkref: Minkref) -> None:
    value = minkref("events", "g1", "g2", "--arithmetic", "mpfr:24", "--json").json
    trial = value["trial"]
    assert trial["events"] == value["count"]
    assert trial["missed"] + trial["invented"] > 0


def test_the_least_precision_of_a_case(minkref: Minkref, tmp_path: Path) -> None:
    # No end of an edge stays on the line of another but at common ends; coordinates are integers.
    for name, ring in (("P", "0 0,7 1,3 5,0 0"), ("Q", "0 0,5 -2,4 6,0 0")):
        (tmp_path / f"{name}.wkt").write_text(f"POLYGON(({ring}))", encoding="utf-8")
    operands = (tmp_path / "P.wkt", tmp_path / "Q.wkt")
    found = minkref("events", *operands, "--least-precision", "--json").json["least_precision"]
    bits = found["bits"]
    assert 2 <= bits <= found["most_tried"]
    enough = minkref("events", *operands, "--arithmetic", f"mpfr:{bits}", "--json").json["trial"]
    assert enough["all_right"]


def test_no_precision_is_enough_where_edges_only_touch(minkref: Minkref) -> None:
    ran = minkref("events", "g1", "g2", "--least-precision", "--json").json
    assert ran["touching_pairs"] > 0
    assert ran["least_precision"]["bits"] is None


def test_what_a_birth_of_a_pair_event_is_is_said_in_words(minkref: Minkref) -> None:
    """This birth is no birth of a hole, which most people look for."""
    ran = minkref("events", "g1", "g2", "--from", "1/2", "--to", "1")
    assert "two edges of the convolution start" in ran.out and "--kind topology" in ran.out
