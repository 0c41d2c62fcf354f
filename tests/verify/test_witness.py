"""The check of witnesses in plain fractions: right witnesses hold, and no lie does."""

from __future__ import annotations

import json

import pytest
from minkref.fuzz.plane.witness import holds
from minkref.fuzz.verdicts.verdict import Witness


def box(xmin: int, ymin: int, xmax: int, ymax: int, *holes: tuple[int, int, int, int]) -> str:
    def ring(a: int, b: int, c: int, d: int) -> list[list[str]]:
        return [[str(x), str(y)] for x, y in ((a, b), (c, b), (c, d), (a, d))]

    inner = [ring(*hole)[::-1] for hole in holes]
    return json.dumps({"polygons": [{"outer": ring(xmin, ymin, xmax, ymax), "holes": inner}]})


FRAME = box(0, 0, 10, 10, (2, 2, 8, 8))
UNIT = box(0, 0, 1, 1)


@pytest.mark.parametrize(
    ("point", "inside", "p", "q"),
    [
        (("1/2", "1/2"), True, ("0", "0"), ("1/2", "1/2")),
        (("11", "11"), True, ("10", "10"), ("1", "1")),  # a corner belongs to the closed sum
        (("5", "5"), False, None, None),  # in the hole that survives
        (("12", "5"), False, None, None),
        (("3001/1000", "5"), False, None, None),  # just inside the hole
    ],
)
def test_true_witnesses_hold(
    point: tuple[str, str], inside: bool, p: tuple[str, str] | None, q: tuple[str, str] | None
) -> None:
    assert holds(FRAME, UNIT, "1", Witness(point, inside, p, q))


@pytest.mark.parametrize(
    ("point", "inside", "p", "q"),
    [
        (("1/2", "1/2"), True, ("0", "0"), ("1/2", "1/3")),  # does not add up
        (("5", "5"), True, ("9/2", "9/2"), ("1/2", "1/2")),  # p in the hole
        (("3", "1"), True, ("1", "1"), ("2", "0")),  # q outside Q
        (("1", "1"), True, None, None),  # no p and q
        (("1", "1"), False, None, None),  # inside
        (("11", "11"), False, None, None),  # touches at a corner
        (("3", "5"), False, None, None),  # touches along an edge
    ],
)
def test_lies_are_refuted(
    point: tuple[str, str], inside: bool, p: tuple[str, str] | None, q: tuple[str, str] | None
) -> None:
    assert not holds(FRAME, UNIT, "1", Witness(point, inside, p, q))


def test_scale_belongs_to_the_first_operand() -> None:
    witness = Witness(("5", "5"), True, ("2", "2"), ("1", "1"))
    assert holds(UNIT.replace('"1"', '"2"'), UNIT, "2", witness)
    assert not holds(UNIT.replace('"1"', '"2"'), UNIT, "1", witness)


def test_operand_that_lies_inside_the_other_meets_it() -> None:
    """No edges cross: one set contains the other."""
    big, small = box(-10, -10, 10, 10), box(-1, -1, 1, 1)
    assert not holds(big, small, "1", Witness(("0", "0"), False))
    assert not holds(small, big, "1", Witness(("0", "0"), False))
    assert holds(box(-10, -10, 10, 10, (-5, -5, 5, 5)), small, "1", Witness(("0", "0"), False))
