"""`minkref index` and --index of `sum`, `sweep`, `events` and `view`: the answers are those of the
other routes; what is no index of the operands is refused."""

from __future__ import annotations

import json
import os
import shutil
import signal
import stat
import subprocess
import sys
import time
from collections.abc import Callable
from fractions import Fraction
from pathlib import Path
from typing import Any

import jsonschema
import pytest
from minkref import _core
from minkref.fuzz.families.random_pairs import random_pair
from minkref.operand import read_operand
from minkref.schemas import error_schema, result_schema, schema
from page_decoder import Decoder, data_of, difference, true_polygons

Minkref = Callable[..., Any]
Window = tuple[str | None, str | None]

TRIANGLE = "POLYGON((0 0,1 0,0 1,0 0))"
# Four squares that touch at corners, around a hole.
RING_OF_SQUARES = "MULTIPOLYGON({})".format(
    ",".join(
        f"(({x} {y},{x + 1} {y},{x + 1} {y + 1},{x} {y + 1},{x} {y}))"
        for x, y in ((1, 0), (0, 1), (2, 1), (1, 2))
    )
)
U = "POLYGON((0 0,3 0,3 2,2 2,2 1,1 1,1 2,0 2,0 0))"

# Models, or sets as text.
PAIRS = {
    "letters": ("g1", "g2"),
    "right angles": ("g3", "g1"),
    "convex": ("disc1", "g1"),
    # A hole that dies at 541/186, where no pair event is.
    "dying hole": (
        "POLYGON((-3 -2,4 -1,1 3,-3 -2))",
        "POLYGON((-40 -40,40 -40,40 40,-40 40,-40 -40),(0 20,-19 -9,17 -11,0 20))",
    ),
    # A frame, an island with a hole in it, and a part beside them.
    "islands": (
        "POLYGON((0 0,3 0,1 2,0 0))",
        "MULTIPOLYGON(((0 0,60 0,60 60,0 60,0 0),(5 5,5 55,55 55,55 5,5 5)),"
        "((20 20,40 20,40 40,20 40,20 20),(24 24,24 36,36 36,36 24,24 24)),"
        "((70 0,80 0,70 9,70 0)))",
    ),
    "several components": (
        "MULTIPOLYGON(((0 0,2 0,0 2,0 0)),((5 5,6 5,6 6,5 5)))",
        "MULTIPOLYGON(((0 0,7 0,7 7,0 7,0 0),(2 2,2 5,5 5,5 2,2 2)),((9 0,11 0,11 7,9 0)))",
    ),
    "touching components": (RING_OF_SQUARES, TRIANGLE),
    "touching components second": (TRIANGLE, RING_OF_SQUARES),
    "hole that touches its outer ring": (
        "POLYGON((0 0,2 0,2 1,1 1,1 2,0 2,0 0))",
        "POLYGON((0 0,12 0,12 12,0 12,0 0),(0 0,3 8,8 3,0 0))",
    ),
}
SEVERAL = pytest.mark.parametrize("name", PAIRS)
# With holes that are born, die, merge and split.
EVENTFUL = ("letters", "islands", "several components")
STEPS = ("insertions", "deletions", "swaps", "updated", "event_scales", "update_seconds")
SUM = ("digest", "area", "area_approximate", "components", "holes", "vertices")


def written(folder: Path, name: str, operand: str) -> str:
    """The operand as the command line names it."""
    if operand.isalnum():
        return operand
    path = folder / f"{name}.wkt"
    path.write_text(operand, encoding="utf-8")
    return str(path)


def operands(folder: Path, name: str) -> tuple[str, str]:
    P, Q = PAIRS[name]
    return written(folder, "P", P), written(folder, "Q", Q)


def window_options(window: Window) -> list[str]:
    options = zip(("--from", "--to"), window, strict=True)
    return [text for option, scale in options if scale is not None for text in (option, scale)]


def build(minkref: Minkref, path: Path, P: str, Q: str, *options: str) -> Any:
    """The document of a build that goes well."""
    ran = minkref("index", P, Q, "-o", path, "--json", *options)
    assert (ran.code, ran.err) == (0, "")
    jsonschema.validate(ran.json, result_schema("index"))
    return ran.json


def ask(minkref: Minkref, command: str, *arguments: str | Path) -> Any:
    """The document of a command that goes well."""
    ran = minkref(command, *arguments, "--json")
    assert (ran.code, ran.err) == (0, ""), ran.err or ran.out
    return ran.json


def event_scales(P: str, Q: str, kind: str = "boundary") -> list[str]:
    """By dynamic update; each once."""
    dynamic = _core.DynamicSum(read_operand(P).set, read_operand(Q).set)
    rows: list[Any] = list(
        dynamic.boundary_events() if kind == "boundary" else dynamic.topology_events()
    )
    return list(dict.fromkeys(row[0] for row in rows))


def between(a: str, b: str) -> str:
    return str((Fraction(a) + Fraction(b)) / 2)


@pytest.fixture
def letters(minkref: Minkref, tmp_path: Path) -> Path:
    """The index of g1 and g2 at the scales from 1/4 to 4."""
    path = tmp_path / "letters.index"
    build(minkref, path, "g1", "g2", "--from", "1/4", "--to", "4")
    return path


# The document, the file.


@pytest.mark.parametrize("window", [(None, None), ("1/2", None), (None, "3"), ("1/2", "3")])
def test_document_follows_the_published_schema_and_tells_the_file(
    minkref: Minkref, tmp_path: Path, window: Window
) -> None:
    jsonschema.Draft202012Validator.check_schema(schema("index"))
    path = tmp_path / "sums.index"
    value = build(minkref, path, "g3", "g1", *window_options(window), "--threads", "2")
    assert (value["P"], value["Q"], value["from"], value["to"]) == ("g3", "g1", *window)
    assert (value["output"], value["bytes"]) == (str(path), path.stat().st_size)
    assert value["threads"] == 2
    opened = _core.ScaleSpaceIndex.open(str(path))
    assert opened.window == window
    kinds = [row[0] for row in opened.edges()]
    assert value["segments"] == {kind: kinds.count(kind) for kind in "ST"}
    assert value["statistics"]["tracks"] == len(opened.tracks())
    assert [path.name for path in tmp_path.iterdir()] == ["sums.index"]


def test_without_a_window_all_events_are_counted(minkref: Minkref, tmp_path: Path) -> None:
    statistics = build(minkref, tmp_path / "sums.index", "g1", "g2")["statistics"]
    for kind in ("boundary", "topology"):
        events = ask(minkref, "events", "g1", "g2", "--kind", kind, "--route", "dynamic")
        assert statistics[f"{kind}_events"] == events["count"] > 0


@pytest.mark.parametrize("count", [0, 1, 6])
@pytest.mark.parametrize("window", [(None, None), ("1/3", "2"), ("5", None), (None, "1/1000")])
def test_as_many_scales_of_the_window_are_checked_as_told(
    minkref: Minkref, tmp_path: Path, count: int, window: Window
) -> None:
    value = build(
        minkref, tmp_path / "x", "g3", "g1", *window_options(window), "--check", str(count)
    )
    scales = [Fraction(scale) for scale in value["checked"]["scales"]]
    assert len(scales) == count
    assert all(scale > 0 for scale in scales)
    assert all(scale >= Fraction(window[0]) for scale in scales if window[0])
    assert all(scale <= Fraction(window[1]) for scale in scales if window[1])


def test_people_are_told_what_was_built_and_that_nothing_was_checked(
    minkref: Minkref, tmp_path: Path
) -> None:
    path = tmp_path / "sums.index"
    ran = minkref("index", "g3", "g1", "-o", path, "--from", "1/2", "--check", "0")
    assert (ran.code, ran.err) == (0, "")
    for text in ("g3 + g1", "1/2 to infinity", "edges", "not: --check 0", path.name, "bytes"):
        assert text in ran.out, text


def test_an_index_is_the_same_bytes_however_often_and_by_however_many_threads_it_is_built(
    minkref: Minkref, tmp_path: Path
) -> None:
    for P, Q, window in (("g1", "g2", ()), ("g1", "glyph275", ("--from", "1/2", "--to", "3"))):
        files = []
        for number, threads in enumerate((1, 1, 2, 7)):
            path = tmp_path / f"{number}.index"
            build(minkref, path, P, Q, *window, "--threads", str(threads), "--check", "0")
            files.append(path.read_bytes())
        assert len(files[0]) > 1000
        assert all(file == files[0] for file in files)


def test_an_earlier_file_is_replaced_and_one_that_is_linked_to(
    minkref: Minkref, tmp_path: Path
) -> None:
    path, link = tmp_path / "sums.index", tmp_path / "link"
    path.write_text("an older one", encoding="utf-8")
    link.symlink_to(path)
    build(minkref, path, "g3", "g1")
    whole = path.read_bytes()
    path.write_text("an older one", encoding="utf-8")
    build(minkref, link, "g3", "g1")
    assert link.is_symlink()
    assert path.read_bytes() == whole
    assert sorted(path.name for path in tmp_path.iterdir()) == ["link", "sums.index"]


def test_a_pipe_is_written_to_and_stays_a_pipe(minkref: Minkref, tmp_path: Path) -> None:
    P, Q = written(tmp_path, "P", TRIANGLE), written(tmp_path, "Q", U)
    whole, pipe = tmp_path / "whole.index", tmp_path / "pipe"
    build(minkref, whole, P, Q, "--from", "1", "--to", "1", "--check", "0")
    os.mkfifo(pipe)
    reader = os.open(pipe, os.O_RDONLY | os.O_NONBLOCK)
    try:
        ran = minkref("index", P, Q, "-o", pipe, "--from", "1", "--to", "1", "--check", "0")
        assert stat.S_ISFIFO(pipe.stat().st_mode)
        if ran.code == 0:
            assert os.read(reader, 1 << 20) == whole.read_bytes()
        else:
            assert ran.code == 2
    finally:
        os.close(reader)


@pytest.mark.parametrize("name", ["several components", "touching components"])
def test_documents_of_the_route_index_follow_the_published_schemas(
    minkref: Minkref, tmp_path: Path, name: str
) -> None:
    P, Q = operands(tmp_path, name)
    path = tmp_path / "sums.index"
    build(minkref, path, P, Q)
    sums = ["--from", "1", "--to", "2", "--steps", "2", "-o", str(tmp_path / "sums")]
    for command, *options in (
        ["sum", "--scale", "1"],
        ["sweep", *sums],
        ["events", "--kind", "boundary"],
        ["events", "--kind", "topology", "-o", str(tmp_path / "events.json")],
        ["events", "--kind", "topology"],
        ["view", "-o", str(tmp_path / "page.html")],
    ):
        value = ask(minkref, command, P, Q, *options, "--index", path)
        jsonschema.validate(value, result_schema(command))
        assert value["route"] == "index"


# What is read off it.


def told(minkref: Minkref, *arguments: str | Path) -> dict[str, Any]:
    value = ask(minkref, "sum", *arguments)
    return {name: value[name] for name in (*SUM, "scale", "tight_passages", "result")}


@SEVERAL
def test_sums_are_those_of_the_other_routes(minkref: Minkref, tmp_path: Path, name: str) -> None:
    P, Q = operands(tmp_path, name)
    topology = event_scales(P, Q, "topology")
    events = event_scales(P, Q)
    assert events
    first, last = events[0], str(max(Fraction(events[-1]), Fraction(events[0]) + 1))
    path = tmp_path / "sums.index"
    build(minkref, path, P, Q, "--from", first, "--to", last)
    scales = {first, last, between(first, last), *events[:: 1 + len(events) // 2], *topology[:2]}
    for scale in scales:
        routes = (["--index", path], ["--route", "dynamic"], ["--route", "paper"])
        read_off, moved, static = (
            told(minkref, P, Q, "--scale", scale, *route) for route in routes
        )
        assert read_off == moved == static, scale


def test_a_sum_by_the_route_index_needs_no_file(minkref: Minkref) -> None:
    value = ask(minkref, "sum", "g1", "g2", "--scale", "1/4", "--route", "index")
    assert value["route"] == "index"
    assert value["signs"] is None
    static = ask(minkref, "sum", "g1", "g2", "--scale", "1/4")
    assert static["route"] == "paper"
    assert [value[name] for name in SUM] == [static[name] for name in SUM]


@pytest.mark.parametrize("ending", ["json", "wkt", "svg"])
def test_the_file_of_a_sum_is_that_of_the_static_route(
    minkref: Minkref, letters: Path, tmp_path: Path, ending: str
) -> None:
    files = [tmp_path / f"{name}.{ending}" for name in ("index", "paper")]
    value = ask(minkref, "sum", "g1", "g2", "--scale", "7/5", "--index", letters, "-o", files[0])
    ask(minkref, "sum", "g1", "g2", "--scale", "7/5", "-o", files[1])
    assert value["route"] == "index"
    assert files[0].read_bytes() == files[1].read_bytes()


@pytest.mark.parametrize("number", range(8))
def test_random_pairs_by_the_route_index_and_by_paper(
    minkref: Minkref, tmp_path: Path, number: int
) -> None:
    pair = random_pair(6, 31 * number)
    names = []
    for name, text in (("P", pair.P), ("Q", pair.Q)):
        file = tmp_path / f"{name}.json"
        file.write_text(text, encoding="utf-8")
        names.append(str(file))
    path = tmp_path / "sums.index"
    build(minkref, path, *names)
    events = event_scales(names[0], names[1])
    for scale in {pair.scale, *events[:: 1 + len(events) // 3]}:
        read_off = told(minkref, *names, "--scale", scale, "--index", path)
        assert read_off == told(minkref, *names, "--scale", scale), scale


def test_the_ends_of_an_open_window_are_as_far_as_scales_go(
    minkref: Minkref, tmp_path: Path
) -> None:
    path = tmp_path / "sums.index"
    build(minkref, path, "g3", "g1")
    for scale in ("1e-300", "1e400", "1/340282366920938463463374607431768211507"):
        read_off = told(minkref, "g3", "g1", "--scale", scale, "--index", path)
        assert read_off == told(minkref, "g3", "g1", "--scale", scale), scale


@pytest.mark.parametrize("scale", ["1", "14/29"])
def test_a_window_may_be_one_scale(minkref: Minkref, tmp_path: Path, scale: str) -> None:
    P, Q = operands(tmp_path, "several components")
    path = tmp_path / "sums.index"
    value = build(minkref, path, P, Q, "--from", scale, "--to", scale)
    assert value["from"] == value["to"] == scale
    assert set(value["checked"]["scales"]) == {scale}
    read_off = told(minkref, P, Q, "--scale", scale, "--index", path)
    assert read_off == told(minkref, P, Q, "--scale", scale)
    assert minkref("sum", P, Q, "--scale", "2", "--index", path).code == 2
    for kind in ("boundary", "topology"):
        window = ("--from", scale, "--to", scale, "--kind", kind)
        moved = ask(minkref, "events", P, Q, *window, "--route", "dynamic")
        assert account(ask(minkref, "events", P, Q, "--kind", kind, "--index", path)) == account(
            moved
        )


@pytest.mark.parametrize("window", [("1/3", "4", "5"), ("3", "1/2", "4"), ("1", "1", "1")])
@pytest.mark.parametrize("name", ["letters", "several components"])
def test_rows_of_a_sweep_are_those_by_dynamic_update(
    minkref: Minkref, tmp_path: Path, name: str, window: tuple[str, str, str]
) -> None:
    P, Q = operands(tmp_path, name)
    path = tmp_path / "sums.index"
    build(minkref, path, P, Q, "--from", "1/3", "--to", "4")
    scales = ["--from", window[0], "--to", window[1], "--steps", window[2]]
    by_file = ask(minkref, "sweep", P, Q, *scales, "--index", path)
    by_default = ask(minkref, "sweep", P, Q, *scales)
    moved = ask(minkref, "sweep", P, Q, *scales, "--route", "dynamic")
    assert (by_file["route"], by_default["route"], moved["route"]) == ("index", "index", "dynamic")
    for value in (by_file, by_default):
        assert len(value["rows"]) == int(window[2])
        for row, other in zip(value["rows"], moved["rows"], strict=True):
            assert [row[field] for field in ("scale", *SUM)] == [
                other[field] for field in ("scale", *SUM)
            ]
            assert [row[field] for field in STEPS] == [None] * len(STEPS)
            assert None not in [other[field] for field in STEPS]


def test_a_sweep_by_index_visits_events_in_the_order_of_its_file(
    minkref: Minkref, letters: Path, tmp_path: Path
) -> None:
    events = [s for s in event_scales("g1", "g2") if Fraction(1, 4) <= Fraction(s) <= 4]
    scales = [*events[5::9], "1/4", "4", *events[:20:7]]
    file = tmp_path / "scales.txt"
    file.write_text("\n".join(scales), encoding="utf-8")
    rows = ask(minkref, "sweep", "g1", "g2", "--scales", file, "--index", letters)["rows"]
    assert [row["scale"] for row in rows] == scales
    moved = ask(minkref, "sweep", "g1", "g2", "--scales", file, "--route", "dynamic")["rows"]
    for row, other in zip(rows, moved, strict=True):
        assert [row[field] for field in SUM] == [other[field] for field in SUM], row["scale"]


def test_the_files_of_a_sweep_are_the_same_by_both_routes(
    minkref: Minkref, letters: Path, tmp_path: Path
) -> None:
    scales = ["--from", "1/3", "--to", "3", "--steps", "3"]
    for folder, route in (("a", ["--index", letters]), ("b", ["--route", "dynamic"])):
        value = ask(minkref, "sweep", "g1", "g2", *scales, *route, "-o", tmp_path / folder)
        assert json.loads((tmp_path / folder / "index.json").read_text("utf-8")) == value
    for number in (1, 2, 3):
        name = f"sum-{number:04}.json"
        assert (tmp_path / "a" / name).read_bytes() == (tmp_path / "b" / name).read_bytes()


def account(value: Any, names: bool = True) -> Any:
    """What two routes have to agree on. `names` of features are those of a window: of another
    window they are others, and lives are told without them."""
    of_topology = ("feature", "before", "after", "parts") if names else ("feature", "parts")
    fields = ("s", "rank", "kind", "change")
    if value["kind"] == "topology":
        fields += of_topology
    lives = [
        sorted(
            ([life["id"]] if names else []) + [str(life["birth"]), str(life["death"])]
            for life in value[kind] or []
        )
        for kind in ("holes", "components")
    ]
    return (
        value["from"],
        value["to"],
        value["count"],
        value["distinct"],
        value["segments"],
        [[event[field] for field in fields] for event in value["events"]],
        lives,
    )


@pytest.mark.parametrize("kind", ["boundary", "topology"])
@SEVERAL
def test_events_are_those_by_dynamic_update(
    minkref: Minkref, tmp_path: Path, name: str, kind: str
) -> None:
    P, Q = operands(tmp_path, name)
    path = tmp_path / "sums.index"
    build(minkref, path, P, Q)
    by_default, by_file, alone = (
        ask(minkref, "events", P, Q, "--kind", kind, *route)
        for route in ([], ["--index", path], ["--route", "index"])
    )
    assert (by_default["route"], by_file["route"], alone["route"]) == ("dynamic", "index", "index")
    assert account(by_file) == account(alone) == account(by_default)
    assert by_file["pairs"] is None and by_default["pairs"] > 0
    if name in EVENTFUL:
        assert by_file["count"] >= 5


@pytest.mark.parametrize("kind", ["boundary", "topology"])
@pytest.mark.parametrize("name", EVENTFUL)
def test_events_of_a_window_include_those_at_its_ends(
    minkref: Minkref, tmp_path: Path, name: str, kind: str
) -> None:
    P, Q = operands(tmp_path, name)
    scales = event_scales(P, Q, kind)
    window = (scales[len(scales) // 4], scales[3 * len(scales) // 4])
    path = tmp_path / "sums.index"
    build(minkref, path, P, Q, *window_options(window))
    moved = ask(
        minkref, "events", P, Q, "--kind", kind, *window_options(window), "--route", "dynamic"
    )
    found = ask(minkref, "events", P, Q, "--kind", kind, "--index", path)
    assert account(found) == account(moved)
    assert (found["events"][0]["s"], found["events"][-1]["s"]) == window


@pytest.mark.parametrize("name", EVENTFUL)
def test_a_window_may_be_narrower_than_that_of_the_index(
    minkref: Minkref, tmp_path: Path, name: str
) -> None:
    P, Q = operands(tmp_path, name)
    path = tmp_path / "sums.index"
    build(minkref, path, P, Q)
    scales = event_scales(P, Q, "topology")
    low, high = scales[len(scales) // 3], scales[2 * len(scales) // 3]
    for window in ((low, high), (low, None), (None, high), (between(low, high), "1000")):
        for kind in ("boundary", "topology"):
            options = ("--kind", kind, *window_options(window))
            narrow = ask(minkref, "events", P, Q, *options, "--index", path)
            moved = ask(minkref, "events", P, Q, *options, "--route", "dynamic")
            assert account(narrow, names=False) == account(moved, names=False)
            # A feature keeps the name that it has in the window of the index.
            whole = ask(minkref, "events", P, Q, "--kind", kind, "--index", path)
            kept = [
                {**event, "rank": None}
                for event in whole["events"]
                if (window[0] is None or Fraction(event["s"]) >= Fraction(window[0]))
                and (window[1] is None or Fraction(event["s"]) <= Fraction(window[1]))
            ]
            assert [{**event, "rank": None} for event in narrow["events"]] == kept


def test_a_window_that_is_not_given_is_that_of_the_index(
    minkref: Minkref, letters: Path, tmp_path: Path
) -> None:
    kind = ("--kind", "topology", "--index", letters)
    for given in ([], ["--from", "1/4"], ["--to", "4"]):
        value = ask(minkref, "events", "g1", "g2", *kind, *given)
        assert (value["from"], value["to"]) == ("1/4", "4")
    value = ask(minkref, "events", "g1", "g2", *kind, "--from", "1/2")
    assert (value["from"], value["to"]) == ("1/2", "4")
    page = tmp_path / "page.html"
    value = ask(minkref, "view", "g1", "g2", "--index", letters, "-o", page)
    assert (value["from"], value["to"]) == ("1/4", "4")
    value = ask(minkref, "view", "g1", "g2", "--index", letters, "--to", "3", "-o", page)
    assert (value["from"], value["to"]) == ("1/4", "3")


def test_a_view_of_an_open_index_begins_and_ends_where_views_do(
    minkref: Minkref, tmp_path: Path
) -> None:
    path = tmp_path / "sums.index"
    build(minkref, path, "g3", "g1")
    value = ask(minkref, "view", "g3", "g1", "--index", path, "-o", tmp_path / "page.html")
    assert (value["from"], value["to"]) == ("1/10", "10")


def test_events_written_to_a_file_are_those_that_are_printed(
    minkref: Minkref, letters: Path, tmp_path: Path
) -> None:
    file = tmp_path / "events.json"
    options = ("g1", "g2", "--kind", "topology", "--index", letters)
    printed = ask(minkref, "events", *options)
    assert ask(minkref, "events", *options, "-o", file)["events"] is None
    assert json.loads(file.read_text("utf-8"))["events"] == printed["events"]
    seen = minkref("events", *options)
    assert seen.code == 0
    assert "index" in seen.out and "hole" in seen.out


def segment(row: Any, P: Any, Q: Any, scale: Fraction) -> Any:
    """Both ends of an edge of the convolution."""
    kind, _, edge_ring, edge, vertex_ring, vertex = row
    own, other = (P, Q) if kind == "S" else (Q, P)
    ring = own[edge_ring]
    of_edge, of_vertex = (scale, 1) if kind == "S" else (1, scale)
    v = other[vertex_ring][vertex]
    return [
        tuple(of_edge * a + of_vertex * b for a, b in zip(end, v, strict=True))
        for end in (ring[edge], ring[(edge + 1) % len(ring)])
    ]


def passes_through(ends: Any, point: tuple[Fraction, Fraction]) -> bool:
    (ax, ay), (bx, by) = ends
    on_line = (bx - ax) * (point[1] - ay) == (by - ay) * (point[0] - ax)
    in_box = min(ax, bx) <= point[0] <= max(ax, bx) and min(ay, by) <= point[1] <= max(ay, by)
    return bool(on_line and in_box)


def exact_rings(operand: _core.PolygonSet) -> list[list[tuple[Fraction, Fraction]]]:
    polygons = json.loads(operand.to_json())["polygons"]
    return [
        [(Fraction(x), Fraction(y)) for x, y in ring]
        for polygon in polygons
        for ring in (polygon["outer"], *polygon["holes"])
    ]


@SEVERAL
def test_parents_by_index_are_some_of_those_by_dynamic_update_and_meet_in_the_place(
    minkref: Minkref, tmp_path: Path, name: str
) -> None:
    P, Q = operands(tmp_path, name)
    rings = exact_rings(read_operand(P).set), exact_rings(read_operand(Q).set)
    edges = {
        (row[0], *row[2:]): row
        for row in _core.reduced_convolution(read_operand(P).set, read_operand(Q).set)
    }
    found, moved = (
        ask(minkref, "events", P, Q, "--kind", "boundary", "--route", route)["events"]
        for route in ("index", "dynamic")
    )
    for event, other in zip(found, moved, strict=True):
        scale, at = Fraction(event["s"]), (Fraction(event["at"][0]), Fraction(event["at"][1]))
        parents, every = (
            {(edge["kind"], *edge["edge"], *edge["vertex"]) for edge in one["parents"]}
            for one in (event, other)
        )
        assert len(parents) == len(event["parents"])
        assert parents <= every, event["s"]
        through = [
            edge for edge in parents if passes_through(segment(edges[edge], *rings, scale), at)
        ]
        assert len(through) >= 2, (event["s"], event["at"])


@SEVERAL
def test_features_are_born_and_die_in_the_same_place(
    minkref: Minkref, tmp_path: Path, name: str
) -> None:
    P, Q = operands(tmp_path, name)
    found, moved = (
        [
            (event["s"], event["feature"], event["change"], event["at"])
            for event in ask(minkref, "events", P, Q, "--kind", "topology", "--route", route)[
                "events"
            ]
            if event["change"] in ("birth", "death")
        ]
        for route in ("index", "dynamic")
    )
    assert found == moved


# Pages.


def page_data(minkref: Minkref, page: Path, *arguments: str | Path) -> tuple[Any, dict[str, Any]]:
    value = ask(minkref, "view", *arguments, "-o", page)
    return value, data_of(page.read_text(encoding="utf-8"))


@pytest.mark.parametrize("window", [(None, None), ("1/2", "2")])
@pytest.mark.parametrize("name", ["letters", "islands", "several components"])
def test_a_page_shows_the_same_by_both_routes(
    minkref: Minkref, tmp_path: Path, name: str, window: Window
) -> None:
    P, Q = operands(tmp_path, name)
    path = tmp_path / "sums.index"
    build(minkref, path, P, Q, "--from", window[0] or "1/10", "--to", window[1] or "10")
    pages = [
        page_data(minkref, tmp_path / "page.html", P, Q, *route)
        for route in (
            ["--index", path],
            [*window_options(window), "--route", "index"],
            [*window_options(window), "--route", "dynamic"],
        )
    ]
    assert [value["route"] for value, _ in pages] == ["index", "index", "dynamic"]
    moved, expected = pages[-1]
    counts = ("from", "to", "segments", "boundary_events", "topology_events", "holes",
              "components", "tracks")  # fmt: skip
    for value, data in pages[:-1]:
        assert [value[field] for field in counts] == [moved[field] for field in counts]
        for field in ("window", "P", "Q", "S", "T", "scales", "about", "kinds", "holes",
                      "components"):  # fmt: skip
            assert data[field] == expected[field], field
        # Without the places, of which a route may name any.
        topology = [[row[:-1] for row in page["topology"]] for page in (data, expected)]
        assert topology[0] == topology[1]
        decoders = Decoder(data), Decoder(expected)
        assert len(data["states"]) == len(expected["states"])
        ends = [expected["window"][0][1], *expected["about"], expected["window"][1][1]]
        for state in range(0, len(expected["states"]), 1 + len(expected["states"]) // 20):
            scale = (ends[state] + ends[state + 1]) / 2
            assert drawn(decoders[0], state, scale) == drawn(decoders[1], state, scale)


def drawn(page: Decoder, state: int, scale: float) -> Any:
    """The rings of a state as points, with what they bound, in one order."""
    rings = []
    for is_hole, component, hole, tracks in page.rings(state).values():
        points = [page.point(track, scale) for track in tracks]
        least = points.index(min(points))
        rings.append((is_hole, component, hole, points[least:] + points[:least]))
    return sorted(rings)


def test_a_page_of_a_part_of_the_window_shows_that_part(
    minkref: Minkref, letters: Path, tmp_path: Path
) -> None:
    window = ("--from", "1/3", "--to", "5/2")
    page = tmp_path / "page.html"
    value, data = page_data(minkref, page, "g1", "g2", "--index", letters, *window)
    moved, expected = page_data(minkref, page, "g1", "g2", "--route", "dynamic", *window)
    assert data["scales"] == expected["scales"]
    assert data["kinds"] == expected["kinds"]
    for field in ("boundary_events", "topology_events", "holes", "components"):
        assert value[field] == moved[field], field
    P, Q = read_operand("g1").set, read_operand("g2").set
    decoder = Decoder(data)
    for scale in (0.334, 0.5123, 1.0077, 1.77, 2.4987):
        assert difference(decoder.polygons(scale), true_polygons(P, Q, scale)) < 1e-9


# Operands of all kinds.

THIN = {
    "empty": "POLYGON EMPTY",
    "point": "POINT(1 2)",
    "segment": "LINESTRING(0 0,3 1)",
}


@pytest.mark.parametrize("first", [True, False])
@pytest.mark.parametrize("shape", THIN)
def test_operands_without_area(minkref: Minkref, tmp_path: Path, shape: str, first: bool) -> None:
    thin = written(tmp_path, "thin", THIN[shape])
    P, Q = (thin, "g1") if first else ("g1", thin)
    path = tmp_path / "sums.index"
    build(minkref, path, P, Q)
    for scale in ("1/3", "1", "7"):
        read_off = told(minkref, P, Q, "--scale", scale, "--index", path)
        assert read_off == told(minkref, P, Q, "--scale", scale)
    for kind in ("boundary", "topology"):
        found = ask(minkref, "events", P, Q, "--kind", kind, "--index", path)
        assert account(found) == account(ask(minkref, "events", P, Q, "--kind", kind))
    rows = ask(minkref, "sweep", P, Q, "--from", "1", "--to", "2", "--steps", "3", "--index", path)[
        "rows"
    ]
    assert {row["components"] for row in rows} == {0 if shape == "empty" else 1}
    page = tmp_path / "page.html"
    assert ask(minkref, "view", P, Q, "--index", path, "-o", page)["components"] == (
        0 if shape == "empty" else 1
    )


def test_the_same_operand_in_another_file_is_the_same(minkref: Minkref, tmp_path: Path) -> None:
    path = tmp_path / "sums.index"
    build(minkref, path, "g1", "g3")
    copy = tmp_path / "copy.json"
    copy.write_text(read_operand("g1").set.to_json(), encoding="utf-8")
    read_off = told(minkref, copy, "g3", "--index", path)
    assert read_off == told(minkref, "g1", "g3")


# Refusals.


def refused(minkref: Minkref, folder: Path, *arguments: str | Path) -> Any:
    """The text of a refusal that writes nothing, and its document."""
    before = {path: path.read_bytes() for path in folder.rglob("*") if path.is_file()}
    ran = minkref(*arguments)
    assert (ran.code, ran.out) == (2, ""), ran.out
    assert "mend:" in ran.err
    document = minkref(*arguments, "--json")
    assert document.code == 2
    jsonschema.validate(document.json, error_schema())
    assert {path: path.read_bytes() for path in folder.rglob("*") if path.is_file()} == before
    return ran.err, document.json["error"]


COMMANDS = {
    "sum": ["sum", "g1", "g2"],
    "sweep": ["sweep", "g1", "g2", "--from", "1", "--to", "2", "--steps", "2"],
    "events": ["events", "g1", "g2", "--kind", "topology"],
    "view": ["view", "g1", "g2", "-o", "page.html"],
}
EACH = pytest.mark.parametrize("command", COMMANDS)


@pytest.fixture
def at(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    """A working folder with an index."""
    monkeypatch.chdir(tmp_path)
    index = _core.ScaleSpaceIndex(read_operand("g1").set, read_operand("g2").set, "1/4", "4")
    index.save("letters.index")
    return tmp_path


@EACH
def test_an_index_of_other_operands_is_refused(minkref: Minkref, at: Path, command: str) -> None:
    name, _, _, *options = COMMANDS[command]
    for operands in (("g2", "g1"), ("g1", "g3"), ("g3", "g2"), ("g1", "g1")):
        text, error = refused(minkref, at, name, *operands, *options, "--index", "letters.index")
        assert "letters.index" in text
        assert " and ".join(operands) in text
        assert error["code"] == "other-operands"


@pytest.mark.parametrize(
    "arguments",
    [
        ["sum", "g1", "g2", "--scale", "5"],
        ["sum", "g1", "g2", "--scale", "1/5"],
        ["sum", "g1", "g2", "--scale", "4.0000000000000000000001"],
        ["sweep", "g1", "g2", "--from", "1/5", "--to", "1", "--steps", "2"],
        ["sweep", "g1", "g2", "--from", "5", "--to", "1", "--steps", "2", "-o", "sums"],
        ["events", "g1", "g2", "--kind", "boundary", "--from", "1/5"],
        ["events", "g1", "g2", "--kind", "topology", "--to", "5", "-o", "events.json"],
        ["view", "g1", "g2", "--from", "1/5"],
        ["view", "g1", "g2", "--to", "5"],
    ],
    ids=" ".join,
)
def test_a_scale_outside_the_window_is_refused(
    minkref: Minkref, at: Path, arguments: list[str]
) -> None:
    text, error = refused(minkref, at, *arguments, "--index", "letters.index")
    assert "letters.index" in text
    assert "1/4 to 4" in text
    assert error["code"] == "outside-window"
    assert [path.name for path in at.iterdir()] == ["letters.index"]


@EACH
def test_a_file_that_is_cut_off_is_refused(minkref: Minkref, at: Path, command: str) -> None:
    whole = (at / "letters.index").read_bytes()
    for size in (0, 1, 8, 100, len(whole) // 2, len(whole) - 1):
        (at / "cut.index").write_bytes(whole[:size])
        text, _ = refused(minkref, at, *COMMANDS[command], "--index", "cut.index")
        assert "cut.index" in text


def test_a_file_with_a_changed_byte_is_refused(minkref: Minkref, at: Path) -> None:
    whole = (at / "letters.index").read_bytes()
    for place in range(0, len(whole), len(whole) // 25):
        changed = bytearray(whole)
        changed[place] ^= 1 << place % 8
        (at / "changed.index").write_bytes(changed)
        text, _ = refused(minkref, at, *COMMANDS["sum"], "--index", "changed.index")
        assert "changed.index" in text, place
    (at / "changed.index").write_bytes(whole + b"\0")
    refused(minkref, at, *COMMANDS["sum"], "--index", "changed.index")


@EACH
@pytest.mark.parametrize(
    ("name", "code"),
    [
        ("empty", "not-an-index"),
        ("foreign", "not-an-index"),
        ("g1.json", "not-an-index"),
        (".", "no-file"),
        ("absent", "no-file"),
    ],
)
def test_what_is_no_index_is_refused(
    minkref: Minkref, at: Path, command: str, name: str, code: str
) -> None:
    (at / "empty").touch()
    (at / "foreign").write_bytes(b"\x89PNG\r\n\x1a\n" + bytes(range(256)) * 20)
    (at / "g1.json").write_text(read_operand("g1").set.to_json(), encoding="utf-8")
    text, error = refused(minkref, at, *COMMANDS[command], "--index", name)
    assert text.startswith(f"minkref: {name}: ")
    assert error["code"] == code
    assert error["where"] == name


@EACH
def test_a_route_that_does_not_use_the_index_is_refused(
    minkref: Minkref, at: Path, command: str
) -> None:
    text, _ = refused(
        minkref, at, *COMMANDS[command], "--index", "letters.index", "--route", "dynamic"
    )
    assert "--index letters.index" in text
    assert "--route dynamic" in text
    ask(minkref, *COMMANDS[command], "--index", "letters.index", "--route", "index")


@pytest.mark.parametrize("kind", ["pair", "parallel", "triple", "arrangement"])
@pytest.mark.parametrize("option", [["--index", "letters.index"], ["--route", "index"]])
def test_events_of_the_arrangement_have_no_index(
    minkref: Minkref, at: Path, kind: str, option: list[str]
) -> None:
    text, _ = refused(minkref, at, "events", "g1", "g2", "--kind", kind, *option)
    assert option[0] in text
    assert f"{kind} events" in text


def test_other_arithmetics_have_no_index(minkref: Minkref, at: Path) -> None:
    options = ["--index", "letters.index", "--arithmetic", "double"]
    text, _ = refused(minkref, at, *COMMANDS["sum"], *options)
    assert "exact only" in text


@pytest.mark.parametrize(
    "arguments",
    [
        ["index", "gs3", "rod", "-o", "sums.index"],
        ["sum", "gs3", "rod", "--index", "letters.index"],
        ["sweep", "gs3", "rod", "--scales", "scales.txt", "--index", "letters.index"],
        ["events", "gs3", "rod", "--kind", "topology", "--index", "letters.index"],
        ["view", "gs3", "rod", "--index", "letters.index", "-o", "page.html"],
    ],
    ids=" ".join,
)
def test_polyhedra_have_no_index(minkref: Minkref, at: Path, arguments: list[str]) -> None:
    (at / "scales.txt").write_text("1,2,3\n", encoding="utf-8")
    refused(minkref, at, *arguments)
    assert sorted(path.name for path in at.iterdir()) == ["letters.index", "scales.txt"]


@pytest.mark.parametrize(
    ("options", "word"),
    [
        (["--memory", "1"], "memory"),
        (["--memory", "-1"], "--memory -1"),
        (["--memory", "much"], "--memory"),
        (["--threads", "0"], "--threads 0"),
        (["--threads", "-2"], "--threads -2"),
        (["--threads", "100000"], "--threads 100000"),
        (["--check", "-1"], "--check -1"),
        (["--check", "1000000"], "--check 1000000"),
        (["--from", "0"], "--from"),
        (["--from", ""], "--from"),
        (["--to", "-1"], "--to"),
        (["--to", "x"], "--to"),
        (["--from", "2", "--to", "1"], "empty"),
    ],
    ids=lambda value: " ".join(value) if isinstance(value, list) else value,
)
def test_a_bad_option_is_refused_and_an_older_file_is_left(
    minkref: Minkref, tmp_path: Path, options: list[str], word: str
) -> None:
    path = tmp_path / "sums.index"
    for text in (None, "an older one"):
        if text is not None:
            path.write_text(text, encoding="utf-8")
        err, _ = refused(minkref, tmp_path, "index", "g1", "g2", "-o", path, *options)
        assert word in err
        assert path.exists() == (text is not None)


def test_points_without_a_sum_are_refused(minkref: Minkref, tmp_path: Path) -> None:
    thin = written(tmp_path, "thin", THIN["point"]), written(tmp_path, "long", THIN["segment"])
    refused(minkref, tmp_path, "index", *thin, "-o", tmp_path / "sums.index")
    assert not (tmp_path / "sums.index").exists()


def test_the_file_of_an_operand_is_not_lost(minkref: Minkref, tmp_path: Path) -> None:
    P, Q = written(tmp_path, "P", TRIANGLE), written(tmp_path, "Q", U)
    link = tmp_path / "link"
    link.symlink_to(Q)
    for output in (P, Q, link):
        text, error = refused(minkref, tmp_path, "index", P, Q, "-o", output)
        assert "operand" in text
        assert error["code"] == "cannot-write"
    assert Path(P).read_text(encoding="utf-8") == TRIANGLE


def test_an_output_that_cannot_be_is_refused(minkref: Minkref, tmp_path: Path) -> None:
    text, _ = refused(
        minkref, tmp_path, "index", "g1", "g2", "-o", tmp_path / "no" / "such" / "folder"
    )
    assert "does not exist" in text
    assert "folder" in refused(minkref, tmp_path, "index", "g1", "g2", "-o", tmp_path)[0]
    assert list(tmp_path.iterdir()) == []
    assert minkref("index", "g1", "g2").code == 2


@pytest.mark.parametrize("command", ["events", "view"])
@pytest.mark.parametrize("route", [["--index", "letters.index"], ["--route", "index"]])
@pytest.mark.parametrize(
    ("window", "word"),
    [
        (["--from", "2", "--to", "1"], ""),
        (["--from", ""], "not a number"),
        (["--to", ""], "not a number"),
        (["--from", "0"], "zero"),
    ],
    ids=["backwards", "empty begin", "empty end", "zero"],
)
def test_a_bad_window_is_refused_also_with_an_index(
    minkref: Minkref, at: Path, command: str, route: list[str], window: list[str], word: str
) -> None:
    text, _ = refused(minkref, at, *COMMANDS[command], *route, *window)
    assert word in text


def test_no_route_of_that_name(minkref: Minkref, at: Path) -> None:
    for command in COMMANDS.values():
        text, _ = refused(minkref, at, *command, "--route", "indices")
        assert "no route" in text


class Differing:
    """An index that is wrong at the scales that it is asked about."""

    def __init__(self, index: _core.ScaleSpaceIndex) -> None:
        self._index = index

    def __getattr__(self, name: str) -> Any:
        return getattr(self._index, name)

    def first_difference(self, scales: list[str]) -> str:
        return scales[0]


def test_an_index_that_differs_from_the_static_route_is_not_written(
    minkref: Minkref, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    from minkref.commands import index

    build_index = index.build_index
    monkeypatch.setattr(index, "build_index", lambda *given: Differing(build_index(*given)))
    path = tmp_path / "sums.index"
    path.write_text("an older one", encoding="utf-8")
    assert minkref("index", "g3", "g1", "-o", path).code == 70
    assert path.read_text(encoding="utf-8") == "an older one"
    assert minkref("index", "g3", "g1", "-o", path, "--check", "0").code == 0


# Builds that do not come to their end.

# Says so when the build begins; LAST stands for what happens before the file takes its name.
SLOW = """
import os, signal, sys
from minkref import documents
from minkref.commands import index
from minkref.cli import run
build = index.build_index
def telling(*arguments):
    print("building", flush=True)
    return build(*arguments)
index.build_index = telling
{last}
sys.exit(run(sys.argv[1:]))
"""


def started(path: Path, P: str, Q: str, last: str = "") -> subprocess.Popen[str]:
    """A build that has begun."""

    def heed_interrupts() -> None:  # a background job of a shell is started deaf to them
        signal.signal(signal.SIGINT, signal.SIG_DFL)

    command = ["index", P, Q, "-o", str(path), "--threads", "1", "--check", "0"]
    process = subprocess.Popen(
        [sys.executable, "-c", SLOW.format(last=last), *command],
        stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True, preexec_fn=heed_interrupts,
    )  # fmt: skip
    assert process.stdout is not None
    assert process.stdout.readline() == "building\n"
    return process


@pytest.mark.parametrize(
    ("number", "old"),
    [
        (signal.SIGKILL, None),
        (signal.SIGKILL, b"an older one"),
        (signal.SIGTERM, b"an older one"),
        (signal.SIGINT, None),
    ],
)
def test_a_build_that_is_killed_leaves_no_file_and_an_older_one_whole(
    tmp_path: Path, number: signal.Signals, old: bytes | None
) -> None:
    path = tmp_path / "sums.index"
    if old is not None:
        path.write_bytes(old)
    process = started(path, "glyph1204", "glyph275")
    try:
        time.sleep(0.2)
        process.send_signal(number)
        process.communicate(timeout=60)
    finally:
        process.kill()
    assert process.returncode in (-number, 128 + number)
    assert [(p.name, p.read_bytes()) for p in tmp_path.iterdir()] == (
        [] if old is None else [(path.name, old)]
    )


@pytest.mark.parametrize("old", [None, b"an older one"])
def test_a_build_that_is_killed_before_its_file_has_its_name_leaves_an_older_one_whole(
    tmp_path: Path, old: bytes | None
) -> None:
    path = tmp_path / "sums.index"
    if old is not None:
        path.write_bytes(old)
    dies = "documents.os.replace = lambda *paths: os.kill(os.getpid(), signal.SIGKILL)"
    process = started(path, "g1", "g3", dies)
    process.communicate(timeout=60)
    assert process.returncode == -signal.SIGKILL
    assert (path.read_bytes() if path.exists() else None) == old


def test_a_file_that_cannot_be_written_leaves_an_older_one_whole(
    minkref: Minkref, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    path = tmp_path / "sums.index"
    path.write_text("an older one", encoding="utf-8")

    def full(*paths: Any) -> None:
        raise OSError(28, "No space left on device")

    monkeypatch.setattr("minkref.documents.os.replace", full)
    text, _ = refused(minkref, tmp_path, "index", "g1", "g3", "-o", path)
    assert "No space left" in text
    assert [path.name for path in tmp_path.iterdir()] == ["sums.index"]


@pytest.mark.parametrize("copied", [False, True])
def test_an_index_may_be_moved_and_be_read_only(
    minkref: Minkref, letters: Path, tmp_path: Path, copied: bool
) -> None:
    (tmp_path / "elsewhere").mkdir()
    other = tmp_path / "elsewhere" / "a name with blanks"
    (shutil.copy if copied else shutil.move)(letters, other)
    other.chmod(0o400)
    assert told(minkref, "g1", "g2", "--index", other) == told(minkref, "g1", "g2")
