"""`minkref events` for kinds that need more than pairs of edges."""

from __future__ import annotations

from collections.abc import Callable
from fractions import Fraction
from pathlib import Path
from typing import Any

import jsonschema
import pytest
from minkref.schemas import result_schema

Minkref = Callable[..., Any]
KINDS = ("triple", "arrangement", "boundary", "topology")


@pytest.fixture
def dying(tmp_path: Path) -> tuple[Path, Path]:
    """A triangular hole that shrinks to a point at 541/186, where three edges meet."""
    P, Q = tmp_path / "P.wkt", tmp_path / "Q.wkt"
    P.write_text("POLYGON((-3 -2, 4 -1, 1 3, -3 -2))", encoding="utf-8")
    Q.write_text(
        "POLYGON((-40 -40, 40 -40, 40 40, -40 40, -40 -40),(0 20, -19 -9, 17 -11, 0 20))",
        encoding="utf-8",
    )
    return P, Q


@pytest.mark.parametrize("kind", KINDS)
def test_documents_follow_the_published_schema(minkref: Minkref, kind: str) -> None:
    ran = minkref("events", "g3", "g1", "--kind", kind, "--json")
    assert (ran.code, ran.err) == (0, "")
    value = ran.json
    jsonschema.validate(value, result_schema("events"))
    scales = [Fraction(event["s"]) for event in value["events"]]
    assert value["count"] == len(scales) > 0
    assert scales == sorted(scales)
    assert value["distinct"] == len(set(scales)) == value["events"][-1]["rank"] + 1


def test_arrangement_events_are_the_three_kinds_together(minkref: Minkref) -> None:
    def listed(kind: str) -> list[str]:
        events = minkref("events", "g1", "g2", "--kind", kind, "--json").json["events"]
        return sorted(str((e["s"], e["kind"], e["change"], e["parents"], e["at"])) for e in events)

    parts = [event for kind in ("pair", "parallel", "triple") for event in listed(kind)]
    # Only the list of all arrangement events holds ends that pass each other on a line.
    together = [e for e in listed("arrangement") if "'parallel', 'swap'" not in e]
    assert together == sorted(parts)


@pytest.mark.parametrize("kind", KINDS)
def test_a_closed_window_holds_the_events_at_its_ends(minkref: Minkref, kind: str) -> None:
    every = minkref("events", "g1", "g2", "--kind", kind, "--json").json["events"]
    first, last = every[len(every) // 4]["s"], every[3 * len(every) // 4]["s"]
    window = ("--from", first, "--to", last)
    within = minkref("events", "g1", "g2", "--kind", kind, *window, "--json").json["events"]
    expected = [e for e in every if Fraction(first) <= Fraction(e["s"]) <= Fraction(last)]
    assert [(e["s"], e["change"], e["at"]) for e in within] == [
        (e["s"], e["change"], e["at"]) for e in expected
    ]


def test_a_hole_dies_where_no_pair_event_is(minkref: Minkref, dying: tuple[Path, Path]) -> None:
    pairs = minkref("events", *dying, "--json").json["events"]
    assert "541/186" not in {event["s"] for event in pairs}
    value = minkref("events", *dying, "--kind", "topology", "--json").json
    deaths = [e for e in value["events"] if e["feature"] == "hole" and e["change"] == "death"]
    assert [(e["s"], e["before"], e["after"]) for e in deaths] == [("541/186", [1], [])]
    assert value["holes"] == [{"id": 1, "birth": None, "death": "541/186"}]
    triples = minkref("events", *dying, "--kind", "triple", "--json").json["events"]
    here = [event for event in triples if event["s"] == "541/186"]
    assert [len(event["parents"]) for event in here] == [3]
    assert here[0]["at"] == deaths[0]["at"]


def test_every_topology_event_is_a_boundary_event(minkref: Minkref) -> None:
    boundary = minkref("events", "g2", "g1", "--kind", "boundary", "--json").json["events"]
    topology = minkref("events", "g2", "g1", "--kind", "topology", "--json").json["events"]
    assert {e["s"] for e in topology} <= {e["s"] for e in boundary}
    assert topology


def test_swapping_the_operands_inverts_the_scales(minkref: Minkref) -> None:
    # Compares events of the sum only; the convolution itself differs if edges are parallel.
    one = minkref("events", "g1", "g2", "--kind", "topology", "--json").json["events"]
    other = minkref("events", "g2", "g1", "--kind", "topology", "--json").json["events"]
    inverse = sorted({1 / Fraction(event["s"]) for event in other})
    assert sorted({Fraction(event["s"]) for event in one}) == inverse


def test_people_see_the_life_of_holes(minkref: Minkref, dying: tuple[Path, Path]) -> None:
    ran = minkref("events", *dying, "--kind", "topology")
    assert ran.code == 0
    assert "hole: death" in ran.out
    assert "541/186" in ran.out


def test_an_empty_operand_has_no_events(minkref: Minkref, tmp_path: Path) -> None:
    nothing = tmp_path / "nothing.wkt"
    nothing.write_text("POLYGON EMPTY", encoding="utf-8")
    for kind in KINDS:
        value = minkref("events", nothing, "g1", "--kind", kind, "--json").json
        assert (value["count"], value["events"]) == (0, [])


@pytest.mark.parametrize(
    "extra",
    [
        ["--kind", "topologies"],
        ["--kind", "topology", "--form", "printed"],
        ["--kind", "triple", "--arithmetic", "double"],
        ["--kind", "boundary", "-o", "events.parquet"],
        ["--kind", "triple", "--from", "3", "--to", "2"],
        ["--kind", "topology", "--from", "0"],
        ["--kind", "topology", "--least-precision"],
    ],
)
def test_refuses(minkref: Minkref, tmp_path: Path, extra: list[str]) -> None:
    extra = [str(tmp_path / x) if x.endswith(".parquet") else x for x in extra]
    ran = minkref("events", "g1", "g2", *extra)
    assert ran.code == 2
    assert ran.err.startswith("minkref: ")
    assert not list(tmp_path.iterdir())
