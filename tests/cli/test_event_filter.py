"""`minkref events --where`: the events that meet a condition, exactly, whatever the list."""

from __future__ import annotations

import json
import random
from collections.abc import Callable
from fractions import Fraction
from pathlib import Path
from typing import Any

import pyarrow.parquet
import pytest
from thoroughness import draws

Minkref = Callable[..., Any]
Event = dict[str, Any]
KINDS = ("pair", "parallel", "triple", "arrangement", "boundary", "topology")
SIGNS: dict[str, Callable[[Fraction, Fraction], bool]] = {
    "=": lambda a, b: a == b,
    "!=": lambda a, b: a != b,
    "<": lambda a, b: a < b,
    "<=": lambda a, b: a <= b,
    ">": lambda a, b: a > b,
    ">=": lambda a, b: a >= b,
}
SEED = 20121


def listed(minkref: Minkref, kind: str, *options: str, P: str = "g1", Q: str = "g2") -> Any:
    ran = minkref("events", P, Q, "--kind", kind, "--json", *options)
    assert ran.code == 0, ran.out + ran.err
    return ran.json


@pytest.fixture
def stairs(tmp_path: Path) -> tuple[str, str]:
    """Operands with parallel edges, so that many events share a scale and a line."""
    first, second = tmp_path / "stairs.wkt", tmp_path / "frame.wkt"
    first.write_text("POLYGON((0 0,2 0,2 1,1 1,1 2,0 2,0 0))", encoding="utf-8")
    frame = "POLYGON((0 0,9 0,9 9,0 9,0 0),(2 2,2 5,5 5,5 4,4 4,4 2,2 2))"
    second.write_text(frame, encoding="utf-8")
    return str(first), str(second)


def number(event: Event, field: str) -> Fraction:
    return Fraction(event["at"]["xy".index(field)] if field in "xy" else event[field])


def condition(dice: random.Random, events: list[Event], depth: int) -> tuple[str, Any]:
    """A random condition as text, and as a function of events: its numbers come from events, so
    that bounds are hit."""
    event = dice.choice(events)
    choice = dice.randrange(8 if depth else 5)
    if choice <= 1:
        field = dice.choice(["s", "x", "y", "rank"])
        sign, bound = dice.choice([*SIGNS]), number(event, field)
        return f"{field} {sign} {bound}", lambda e: SIGNS[sign](number(e, field), bound)
    if choice == 2:
        field = dice.choice(["s", "x", "y"])
        low, high = sorted(number(dice.choice(events), field) for _ in range(2))
        opening, closing = dice.choice("[("), dice.choice("])")
        return (
            f"{field} in {opening}{low}, {high}{closing}",
            lambda e: (
                (low <= number(e, field) if opening == "[" else low < number(e, field))
                and (number(e, field) <= high if closing == "]" else number(e, field) < high)
            ),
        )
    if choice == 3:
        field = dice.choice(["kind", "change", *(["feature"] if "feature" in event else [])])
        word = event[field]
        return f"{field} = {word}", lambda e: e[field] == word
    if choice == 4:
        edge = dice.choice(event["parents"])
        place = ".".join(str(n) for n in edge["edge"])
        return f"parents has {edge['kind']} {place}", lambda e: any(
            (p["kind"], p["edge"]) == (edge["kind"], edge["edge"]) for p in e["parents"]
        )
    first, holds = condition(dice, events, depth - 1)
    second, also = condition(dice, events, depth - 1)
    if choice == 5:
        return f"not ({first})", lambda e: not holds(e)
    if choice == 6:
        return f"({first} and {second})", lambda e: holds(e) and also(e)
    return f"({first} or {second})", lambda e: holds(e) or also(e)


@pytest.mark.parametrize("operands", ["letters", "stairs"])
@pytest.mark.parametrize("kind", KINDS)
def test_a_condition_keeps_what_fractions_say(
    kind: str, operands: str, minkref: Minkref, stairs: tuple[str, str]
) -> None:
    P, Q = stairs if operands == "stairs" else ("g1", "g2")
    whole = listed(minkref, kind, P=P, Q=Q)
    events = whole["events"]
    if not events:
        return
    dice = random.Random(SEED)
    for _ in range(draws(4, 12)):
        text, holds = condition(dice, events, 2)
        some = listed(minkref, kind, "--where", text, P=P, Q=Q)
        wanted = [event for event in events if holds(event)]
        assert some["events"] == wanted, f"seed {SEED}: {text}"
        assert (some["count"], some["distinct"]) == (whole["count"], whole["distinct"])
        assert (some["matching"], some["where"]) == (len(wanted), text)
        assert some["matching_distinct"] == len({event["s"] for event in wanted})


def test_scales_that_doubles_cannot_tell_apart_are_told_apart(
    minkref: Minkref, tmp_path: Path
) -> None:
    event = listed(minkref, "pair")["events"][100]
    scale = Fraction(event["s"])
    above = scale + Fraction(1, 10**40)
    assert float(above) == float(scale)
    kept = [
        listed(minkref, "pair", "--where", f"rank = {event['rank']} and s {sign} {bound}")
        for sign, bound in (("=", scale), ("<", above), ("=", above), (">=", above))
    ]
    assert [found["matching"] > 0 for found in kept] == [True, True, False, False]


def test_every_format_and_route_has_the_same_events(minkref: Minkref, tmp_path: Path) -> None:
    where = ("--where", "s > 7/5 and change = death")
    wanted = listed(minkref, "pair", *where)["events"]
    assert wanted
    for name in ("events.json", "events.jsonl", "events.parquet"):
        ran = minkref("events", "g1", "g2", *where, "-o", tmp_path / name)
        assert (ran.code, f"{len(wanted):,} at" in ran.out) == (0, True)
    assert json.loads((tmp_path / "events.json").read_text())["events"] == wanted
    lines = (tmp_path / "events.jsonl").read_text().splitlines()
    assert [json.loads(line) for line in lines] == wanted
    table = pyarrow.parquet.read_table(tmp_path / "events.parquet").to_pylist()
    assert [(row["s"], row["rank"], row["change"]) for row in table] == [
        (event["s"], event["rank"], event["change"]) for event in wanted
    ]
    window = ("--from", "1/4", "--to", "4", "--where", "feature = hole and before has 0")
    by_route = [
        listed(minkref, "topology", *window, "--route", route)["events"]
        for route in ("dynamic", "index")
    ]
    assert by_route[0] == by_route[1] != []


def test_a_limit_counts_matching_events(minkref: Minkref) -> None:
    found = listed(minkref, "pair", "--where", "change = birth", "--limit", "3")
    assert (len(found["events"]), {event["change"] for event in found["events"]}) == (3, {"birth"})
    assert found["count"] > found["matching"] > 3
    whole = listed(minkref, "pair", "--limit", "0")
    assert (whole["where"], whole["matching"]) == (None, whole["count"])


@pytest.mark.parametrize(
    ("text", "character", "mend"),
    [
        ("scale > 1", 1, "ask for s, x, y"),
        ("kind = pair and chnge = birth", 17, "did you mean change?"),
        ("change = brith", 10, "did you mean birth?"),
        ("kind = triple", 8, "choose --kind triple or arrangement"),
        ("feature = hole", 1, "choose --kind topology"),
        ("before has 0", 1, "choose --kind topology"),
        ("s >", 4, "a number"),
        ("", 1, "write, for example"),
        ("s > 1 && s < 2", 7, "write and"),
        ("s > 7 / 5", 7, "without spaces"),
        ("s > 1/0", 5, "give a number"),
        ("s > 1e9999", 5, "between"),
        ("s = birth", 1, "s > 7/5"),
        ("change > birth", 8, "write change = birth"),
        ("x has 3", 1, "x > 7/5"),
        ("1 < s > 2", 7, "A < s < B"),
        ("parents has S 0", 15, "RING.INDEX"),
        ("parents = S", 1, "parents has S"),
        ("(s > 1", 7, "')'"),
        ('change = "birth"', 10, "without quotes"),
        ("s > 1,5", 6, "decimal with a point"),
    ],
)
def test_what_is_no_condition_is_refused_at_its_place(
    text: str, character: int, mend: str, minkref: Minkref
) -> None:
    ran = minkref("events", "g1", "g2", "--json", "--where", text)
    error = ran.json["error"]
    assert ran.code == 2
    assert f"--where, character {character}" in error["where"]
    assert mend in error["mend"]


@pytest.mark.parametrize("text", ["not " * 998 + "s > 1", "(" * 1900 + "s > 1" + ")" * 1900])
def test_conditions_nest_deeply(text: str, minkref: Minkref) -> None:
    assert listed(minkref, "pair", "--limit", "0", "--where", text)["matching"] > 0
    ran = minkref("events", "g1", "g2", "--where", text + " or s > 1" * 300)
    assert (ran.code, "more than 4000 characters" in ran.err) == (2, True)
