"""`minkref events` of polyhedra."""

from __future__ import annotations

import json
from collections.abc import Callable
from fractions import Fraction
from pathlib import Path
from typing import Any, cast

import jsonschema
import pytest
from minkref.schemas import schema
from minkref.space.commands.event_parts import EventParts
from minkref.space.commands.event_rows import rows_of
from minkref.space.operand import read_summand
from written_solids import cube, frame, polygon, prism

Minkref = Callable[..., Any]
TENT = prism([(0, 0), (3, 0), (1, 2)], "5/2")


@pytest.fixture
def operands(tmp_path: Path) -> tuple[Path, Path]:
    paths = tmp_path / "P.off", tmp_path / "Q.off"
    for path, text in zip(paths, (frame(), TENT), strict=True):
        path.write_text(text, encoding="utf-8")
    return paths


WINDOW = ("--from", "1/2", "--to", "4")


def test_events_of_a_frame_and_a_tent(minkref: Minkref, operands: tuple[Path, Path]) -> None:
    ran = minkref("events", *operands, *WINDOW, "--json")
    assert ran.code == 0, ran.out
    jsonschema.validate(ran.json, schema("events"))
    value = ran.json
    events = value["events"]
    assert len(events) == value["count"] == sum(value["kinds"].values()) > 0
    scales = [Fraction(event["s"]) for event in events]
    assert scales == sorted(scales) and len(set(scales)) == value["distinct"]
    assert Fraction(1, 2) <= scales[0] and scales[-1] <= 4
    points = {name: _points(path) for name, path in zip("PQ", operands, strict=True)}
    for event in events:
        touching = [one for one in event["facets"] if one["corner"] is not None]
        for one in touching[: 1 if event["kind"] == "parallel" else 2]:
            p, q = (points[name][one[name][one["corner"]]] for name in "PQ")
            s = Fraction(event["s"])
            assert [Fraction(x) for x in event["place"]] == [
                s * a + b for a, b in zip(p, q, strict=True)
            ]


def _points(path: Path) -> list[list[Fraction]]:
    lines = path.read_text(encoding="utf-8").splitlines()
    return [[Fraction(x) for x in line.split()] for line in lines[2 : 2 + int(lines[1].split()[0])]]


def test_a_file_has_them_line_by_line(
    minkref: Minkref, operands: tuple[Path, Path], tmp_path: Path
) -> None:
    path = tmp_path / "events.jsonl"
    ran = minkref("events", *operands, *WINDOW, "-o", path, "--json")
    assert ran.code == 0 and ran.json["events"] is None and ran.json["output"] == str(path)
    lines = path.read_text(encoding="utf-8").splitlines()
    assert len(lines) == ran.json["count"]
    first = minkref("events", *operands, *WINDOW, "--json", "--limit", "1")
    assert first.json["events"] == [json.loads(lines[0])]


def test_a_table_has_them_row_by_row(
    minkref: Minkref, operands: tuple[Path, Path], tmp_path: Path
) -> None:
    parquet = pytest.importorskip("pyarrow.parquet")
    path = tmp_path / "events.parquet"
    ran = minkref("events", *operands, *WINDOW, "-o", path, "--json")
    rows = parquet.read_table(path).to_pylist()
    listed = minkref("events", *operands, *WINDOW, "--json").json["events"]
    assert all(float(Fraction(row["s"])) == row.pop("s_double") for row in rows)
    assert ran.json["events"] is None and rows == listed


def test_parts_of_a_window_follow_each_other(operands: tuple[Path, Path]) -> None:
    """Limits events in memory to very few per thread, many at scales where parts meet."""
    P, Q = (read_summand(str(path)).surface for path in operands)

    def all_of(most: int | None) -> tuple[list[Any], Any, int]:
        parts = EventParts(P, Q, ("1/2", "4"), True, lambda *_: None, most)
        rows = [row for part in parts for row in rows_of(part, "arrangement")]
        return rows, parts.counts, parts.parts

    rows, counts, parts = all_of(None)
    assert parts == 1 and len(rows) > 200
    for most, least in ((50, 2), (7, 5)):
        again, same, more = all_of(most)
        assert again == rows and more >= least
        for name in ("vertex", "edge", "parallel", "triple", "four", "distinct", "facets"):
            assert same[name] == counts[name], name


def test_those_of_three_and_four_facets(minkref: Minkref, operands: tuple[Path, Path]) -> None:
    listed = {}
    for kind in ("pair", "triple", "arrangement"):
        ran = minkref("events", *operands, *WINDOW, "--kind", kind, "--json")
        jsonschema.validate(ran.json, schema("events"))
        assert ran.json["kind"] == kind and ran.json["count"] == len(ran.json["events"])
        listed[kind] = ran.json
    events = listed["triple"]["events"]
    assert {event["kind"] for event in events} <= {"triple", "four"} and events
    for event in events:
        sides = [one for one in event["facets"] if one["side"] is not None]
        assert len(event["facets"]) == (3 if event["kind"] == "triple" else 4)
        assert len(sides) in ((1, 2, 3) if event["kind"] == "triple" else (0,))
        assert event["change"] != "pass" or len(sides) > 1  # two are in one plane always
    every = listed["arrangement"]
    assert every["count"] == listed["pair"]["count"] + listed["triple"]["count"]
    scales = [Fraction(event["s"]) for event in every["events"]]
    assert scales == sorted(scales) and len(set(scales)) == every["distinct"]


def test_the_paper_s_way_on_trial(minkref: Minkref, operands: tuple[Path, Path]) -> None:
    told = {}
    for form, arithmetic in (
        ("printed", "rational"),
        ("printed", "double"),
        ("corrected", "double"),
    ):
        ran = minkref(
            "events", *operands, *WINDOW, "--form", form, "--arithmetic", arithmetic, "--json"
        )
        jsonschema.validate(ran.json, schema("events"))
        told[form, arithmetic] = ran.json["trial"]
        assert told[form, arithmetic]["events"] > 0
    assert told["printed", "rational"]["false_inconsistent"] == 0
    assert told["printed", "rational"]["invented"] > 0  # of facets in one plane, as in the plane
    assert told["printed", "double"]["missed"] >= told["corrected", "double"]["missed"]
    shown = minkref("events", *operands, *WINDOW, "--form", "printed", "--arithmetic", "mpfr:53")
    assert "called inconsistent" in " ".join(shown.out.split())


def test_sentences_of_the_paper_are_read_one_by_one(
    minkref: Minkref, operands: tuple[Path, Path]
) -> None:
    def told(*readings: str) -> dict[str, int]:
        chosen = [word for reading in readings for word in ("--reading", reading)]
        ran = minkref("events", *operands, *WINDOW, *chosen, "--json")
        jsonschema.validate(ran.json, schema("events"))
        assert all(f"{name}={ran.json['readings'][name]}" in readings for name in names(readings))
        return cast(dict[str, int], ran.json["trial"])

    def names(readings: tuple[str, ...]) -> list[str]:
        return [reading.partition("=")[0] for reading in readings]

    lines = told("corner=lines", "crossing=points")
    singular = [lines[why] for why in ("parallel_faces", "parallel_sides", "side_along_plane")]
    assert lines["missed"] == sum(singular) > 0 and lines["invented"] == 0
    right = told("solve=least-squares", "coplanar=turned")
    assert right["missed"] == right["invented"] == 0 < right["parallel_pairs"]
    assert told("ends=lines")["invented"] > 0
    for words, what in (
        (("--reading", "corner=none"), "there is no reading corner = none"),
        (("--reading", "observation=printed"), "there is no reading 'observation'"),
        (("--kind", "triple", "--reading", "corner=lines"), "events of two facets only"),
    ):
        refused = minkref("events", *operands, *WINDOW, *words)
        assert refused.code == 2 and what in refused.err


def test_people_see_the_first_of_them(minkref: Minkref, operands: tuple[Path, Path]) -> None:
    ran = minkref("events", *operands, *WINDOW)
    assert ran.code == 0 and "facets of the convolution" in ran.out and "more (--limit" in ran.out


@pytest.mark.parametrize(
    "words",
    [
        ("--from", "1"),
        ("--to", "2"),
        (*WINDOW, "--kind", "parallel"),
        (*WINDOW, "--form", "printed", "--kind", "triple"),
        (*WINDOW, "--arithmetic", "mpfr:1"),
        (*WINDOW, "--where", "s > 1"),
        ("--from", "2", "--to", "1"),
        (*WINDOW, "-o", "-", "--format", "parquet"),
    ],
)
def test_what_is_not_there_is_refused(
    minkref: Minkref, operands: tuple[Path, Path], words: tuple[str, ...]
) -> None:
    ran = minkref("events", *operands, *words)
    assert ran.code == 2 and ran.err.startswith("minkref: ")


def test_thin_operands_are_refused(minkref: Minkref, tmp_path: Path) -> None:
    (tmp_path / "P.off").write_text(cube(), encoding="utf-8")
    (tmp_path / "Q.off").write_text(polygon([(0, 0), (1, 0), (0, 1)]), encoding="utf-8")
    ran = minkref("events", tmp_path / "P.off", tmp_path / "Q.off", *WINDOW)
    assert ran.code == 2 and "volume" in ran.err
