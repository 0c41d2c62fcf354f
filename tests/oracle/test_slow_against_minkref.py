"""The slow engine against the reference: random pairs with holes, at plain scales and at events.

A difference is shrunk by omitting triangles and corners; the test prints the failing rest with its
seed.
"""

from __future__ import annotations

import json
import random
from collections.abc import Callable
from fractions import Fraction
from pathlib import Path
from typing import Any

import minkref
import pytest
from minkref.cli.cli import run
from minkref.oracle.slow import Operand, minkowski_sum, topology
from minkref.oracle.slow.canonical import digest, document
from random_pairs import Source, as_json, pair, shrunk
from thoroughness import draws

SEED = 20124
SCALES = [Fraction(n, d) for n, d in ((1, 1), (1, 2), (2, 1), (3, 1), (3, 2), (2, 3), (7, 5))]


def theirs(P: Operand, Q: Operand, scale: Fraction) -> tuple[Any, ...]:
    p, q = (minkref.read_text(json.dumps(as_json(operand)), "json") for operand in (P, Q))
    found = minkref.minkowski_sum(p, q, str(scale))
    tight = minkref.tight_passages(p, q, str(scale))
    return (
        found.region.canonical_json(),
        found.components,
        found.holes,
        [[[str(x), str(y)] for x, y in piece["points"]] for piece in tight],
    )


def ours(P: Operand, Q: Operand, scale: Fraction) -> tuple[Any, ...]:
    found = minkowski_sum(P, Q, scale)
    assert found.digest == digest(found.polygons)
    return (
        json.dumps(document(found.polygons), separators=(",", ":")),
        found.components,
        found.holes,
        [[[str(x), str(y)] for x, y in piece] for piece in found.tight],
    )


def differs(P: Source, Q: Source, scale: Fraction) -> bool:
    p, q = P.operand(), Q.operand()
    if p.ends and q.ends:
        return False
    return ours(p, q, scale) != theirs(p, q, scale)


def assert_equal(index: int, P: Source, Q: Source, scale: Fraction) -> None:
    if differs(P, Q, scale):
        P, Q = shrunk(P, Q, lambda p, q: differs(p, q, scale))
        raise AssertionError(f"seed {SEED}, pair {index}, scale {scale}: {P} {Q}")


@pytest.mark.parametrize("block", range(10))
def test_sums_and_tight_passages_of_random_pairs_are_those_of_the_reference(block: int) -> None:
    for index in range(block * 40, block * 40 + draws(20, 40)):
        P, Q = pair(SEED, index, small=index % 8 != 0)
        assert_equal(index, P, Q, SCALES[index % len(SCALES)])


Events = Callable[[Operand, Operand, str], dict[Fraction, list[Any]]]


@pytest.fixture
def events(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> Events:
    """The reference's events by scale, from the command's output."""

    def call(P: Operand, Q: Operand, kind: str) -> dict[Fraction, list[Any]]:
        names = written(tmp_path, P, Q)
        assert run(["events", *names, "--kind", kind, "--json"]) == 0
        found: dict[Fraction, list[Any]] = {}
        for event in json.loads(capsys.readouterr().out)["events"]:
            found.setdefault(Fraction(event["s"]), []).append(event)
        return found

    return call


def written(folder: Path, P: Operand, Q: Operand) -> list[str]:
    names = []
    for role, operand in (("P", P), ("Q", Q)):
        names.append(folder / f"{role}.json")
        names[-1].write_text(json.dumps(as_json(operand)), encoding="utf-8")
    return list(map(str, names))


@pytest.mark.parametrize("index", range(draws(8, 12)))
def test_states_change_at_the_events_of_the_reference_and_at_no_other(
    index: int, events: Events
) -> None:
    P, Q = pair(SEED + 1, index)
    p, q = P.operand(), Q.operand()
    if (p.ends and q.ends) or p.is_empty or q.is_empty:
        return
    scales = events(p, q, "arrangement")
    boundary = events(p, q, "boundary")
    changes = events(p, q, "topology")
    assert changes.keys() <= boundary.keys() <= scales.keys()
    chosen = random.Random(SEED + index).sample(sorted(scales), min(draws(6, 15), len(scales)))
    for scale in {*chosen, *changes}:
        assert_equal(index, P, Q, scale)
        found = topology(p, q, scale)
        assert found.boundary_changes == (scale in boundary), (SEED + 1, index, scale)
        # How many features go in, how many parts exist at the scale, how many come out.
        links = [("hole", link) for link in found.holes]
        links += [("component", link) for link in found.components]
        expected = [
            (e["feature"], e["change"], len(e["before"]), e["parts"], len(e["after"]))
            for e in changes.get(scale, [])
        ]
        assert sorted(expected) == sorted(
            (feature, link.change, len(link.below), len(link.at), len(link.above))
            for feature, link in links
            if link.change != "same"
        ), (SEED + 1, index, scale)
