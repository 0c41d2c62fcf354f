"""Seeded faults of the verb `offset` are refuted within few cases, each with a point that plain
fractions check, twice; right implementations from the page alone are never accused."""

from __future__ import annotations

import json
import runpy
from dataclasses import replace
from fractions import Fraction
from itertools import product
from pathlib import Path

import pytest
from asked_offsets import case, is_proven, outcomes, request
from minkref.fuzz.offsets.asked_offset import AskedOffset
from minkref.fuzz.offsets.join_check import holds as shows
from minkref.fuzz.offsets.judgement import judge_offset
from minkref.fuzz.targets.declaration import read_declaration
from minkref.fuzz.verdicts.verdict import GOOD, Outcome, Verdict, Witness
from offset_faults import FAULTS
from plain_offset import PlainOffset, Point, Ring, ccw, go
from right_offsets import RIGHT
from seeded_offset import answer
from sharp_faults import SHARP_FAULTS
from thoroughness import THOROUGH, draws

SEED = 7
JUDGE = Path(__file__).parents[3] / "degeneracies" / "findings" / "judge.py"
ALONE = runpy.run_path(str(JUDGE))  # shares no code with the others
SOON = ("SignIgnored", "ArcsReversed", "HolesIgnored", "ReflexDiscsLost", "OneSide", "LimitIgnored")
NAMES = [*([fault.__name__ for fault in FAULTS[1:]] if THOROUGH else SOON), *SHARP_FAULTS]


def test_there_are_sixty_of_them_and_each_says_what_is_wrong() -> None:
    abouts = [fault.__doc__ or "" for fault in (*FAULTS[1:], *SHARP_FAULTS.values())]
    assert len(set(abouts)) == len(abouts) >= 60
    assert all(12 <= len(about) <= 100 and about.endswith(".") for about in abouts)


@pytest.mark.parametrize("name", NAMES)
def test_a_seeded_fault_is_refuted(name: str) -> None:
    print("seed", SEED)
    asked, said = next(
        pair for pair in outcomes(name, SEED, 60) if pair[1].verdict not in GOOD
        and pair[1].verdict is not Verdict.SKIPPED
    )  # fmt: skip
    assert said.verdict is Verdict.WRONG and is_proven(asked, said)
    assert said.witness is not None
    told = ALONE["answers"](json.loads(asked.literal), said.witness.document())
    assert told == {said.witness.in_truth}


@pytest.mark.parametrize("name", ["0", *RIGHT])
def test_a_right_one_is_never_accused(name: str) -> None:
    if name == "shapely":
        pytest.importorskip("shapely")
    print("seed", SEED)
    said = [one for _, one in outcomes(name, SEED, draws(5, 120))]
    assert {one.verdict for one in said} <= {*GOOD, Verdict.SKIPPED}, said
    judged = sum(one.verdict in GOOD for one in said)
    assert judged * 2 > len(said)


# A triangle's hole that its inradius closes, with squared corners; lines with square ends.
CLOSED = "joins-grid:11:20"
TOLERANCE = "46879/13743895347200000000"
ENDS = ("joins-grid:11:199", "joins-grid:11:189", "joins-grid:11:77")


def outcome(target: PlainOffset, asked: AskedOffset) -> Outcome:
    declared = read_declaration(answer(target, "t", {"verb": "hello"}), "t")
    value = answer(target, "t", request(asked, declared))
    return judge_offset(asked, "t", asked.exchange.received(value, declared, 0.0))[0]


class Slit(PlainOffset):
    """Square ends without the line's end: doubles leave a slit."""

    def square_end(self, v: Point, n: Point, r: float) -> Ring:
        left, right, d = go(v, n, -r), go(v, n, r), (-n[1], n[0])
        return ccw([left, right, go(right, d, r), go(left, d, r)])


def test_a_hole_that_the_last_of_the_radius_closes_may_stay() -> None:
    """An answer is right if it is so for a radius within the tolerance."""
    assert outcome(RIGHT["rounded"](), case(CLOSED)).verdict in GOOD


TRIANGLES = ((3, 4, 1), (8, 15, 3), (20, 21, 6))  # legs, inradius
MANNERS = ({"join": "bevel"}, {"join": "square"}, {"join": "mitre", "limit": "2"}, {})


@pytest.mark.parametrize("join", MANNERS, ids=lambda manner: manner.get("join", "round"))
@pytest.mark.parametrize("name", ["inside", "around", "other-corners", "rounded"])
def test_holes_closed_exactly_by_the_radius_accuse_nobody(name: str, join: dict[str, str]) -> None:
    """Each triangle closes at its inradius, at one point; moved, and in other units."""
    for (a, b, radius), (x, y), unit in product(TRIANGLES, ((0, 0), (11, -7)), ("1", "1/3", "1/7")):
        corners = [(x, y), (x, y + b), (x + a, y)]
        box = [(x - 50, y - 50), (x + 90, y - 50), (x + 90, y + 90), (x - 50, y + 90)]
        outer, hole = (
            [[str(c * Fraction(unit)) for c in p] for p in ring] for ring in (box, corners)
        )
        P = {"polygons": [{"outer": outer, "holes": [hole]}]}
        text = json.dumps({"offset": P, "radius": str(radius * Fraction(unit)), **join})
        said = outcome(RIGHT[name](), case(text))
        assert said.verdict in GOOD, (text, said)


def test_a_point_that_a_smaller_radius_leaves_is_no_witness() -> None:
    """The second judge holds such a point for no proof, however deep it lies at the radius."""
    asked = case(CLOSED)
    witness = Witness(
        ("-1811939329/110680464442257309696", "1/274877906944"), True, tolerance=TOLERANCE,
        radius=str(asked.radius), manner=str(asked.manner),
    )  # fmt: skip
    assert not shows(asked.literal, witness)
    assert shows(asked.literal, replace(witness, tolerance="0"))


@pytest.mark.parametrize("name", ENDS)
def test_a_slit_is_missing_however_thin(name: str) -> None:
    assert outcome(PlainOffset(), case(name)).verdict in GOOD
    assert outcome(Slit(), case(name)).verdict is Verdict.WRONG


def test_a_square_that_lacks_a_corner_is_no_witness() -> None:
    """The side x + y = 10 moves to 10 + sqrt 2, and has to leave out no corner."""
    triangle = {"polygons": [{"outer": [["0", "0"], ["10", "0"], ["0", "10"]], "holes": []}]}
    text = json.dumps({"offset": triangle, "radius": "1", "join": "bevel"})
    for tolerance, holds in (("7/10", True), ("3/4", False)):
        witness = Witness(("5", "5"), True, tolerance=tolerance)
        assert shows(text, witness) == holds
        assert ALONE["answers"](json.loads(text), witness.document()) == (
            {True} if holds else {True, False}
        )


def test_a_witness_with_joins_that_says_too_much_is_refused() -> None:
    """A corner without its mitre: the square around the witness has to lie within it."""
    asked, said = next(
        (asked, said) for asked, said in outcomes("MitresBevelled", SEED, 60)
        if said.verdict is Verdict.WRONG and asked.manner.join == "mitre"
    )  # fmt: skip
    witness = said.witness
    assert witness is not None and witness.in_truth and is_proven(asked, said)
    assert not shows(asked.literal, replace(witness, in_truth=False))
    far = str(Fraction(witness.tolerance) + 3 * abs(asked.radius))
    assert not shows(asked.literal, replace(witness, tolerance=far))
