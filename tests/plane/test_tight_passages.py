"""The tight passages of handmade exact fits, at their scale and close by."""

from __future__ import annotations

import json
from fractions import Fraction
from typing import Any

import pytest
from minkref import BadInput, PolygonSet, tight_passages
from tight_passage_cases import CASES, FRAME, UNIT, Case, Ring

TINY = Fraction(1, 2**40)


def region(polygons: list[list[Ring]]) -> PolygonSet:
    def texts(ring: Ring) -> list[list[str]]:
        return [[str(x), str(y)] for x, y in ring]

    return PolygonSet.from_json(
        json.dumps(
            {
                "polygons": [
                    {"outer": texts(outer), "holes": [texts(ring) for ring in holes]}
                    for outer, *holes in polygons
                ]
            }
        )
    )


def found(case: Case, scale: Fraction) -> list[dict[str, Any]]:
    return tight_passages(region(case.P), region(case.Q), str(scale))


def points(passages: list[dict[str, Any]]) -> list[Ring]:
    return [piece["points"] for piece in passages]


def numbers(pieces: list[Ring]) -> list[Ring]:
    return [[(Fraction(x), Fraction(y)) for x, y in piece] for piece in pieces]


def rows(passages: list[dict[str, Any]]) -> list[list[list[tuple[Any, ...]]]]:
    def row(edge: dict[str, Any]) -> tuple[Any, ...]:
        return (edge["kind"], *edge["edge"], *edge["vertex"])

    return [[[row(edge) for edge in edges] for edges in piece["contacts"]] for piece in passages]


@pytest.mark.parametrize("case", CASES, ids=lambda case: case.title)
def test_tight_passages_are_those_derived_by_hand(case: Case) -> None:
    passages = found(case, Fraction(case.scale))
    assert points(passages) == numbers(case.passages)
    if case.contacts is not None:
        assert rows(passages) == case.contacts


@pytest.mark.parametrize("sign", [-1, 1], ids=["below", "above"])
@pytest.mark.parametrize(
    "case", [case for case in CASES if case.near is not None], ids=lambda case: case.title
)
def test_close_to_a_critical_scale_nothing_is_tight_but_what_is_at_all_scales(
    case: Case, sign: int
) -> None:
    assert case.near is not None
    passages = found(case, Fraction(case.scale) + sign * TINY)
    assert points(passages) == numbers(case.near)


def test_operands_that_the_sum_refuses_are_refused() -> None:
    with pytest.raises(BadInput, match="scale"):
        tight_passages(region(FRAME), region(UNIT), "0")
    with pytest.raises(BadInput):
        tight_passages(region([[[(0, 0), (1, 1), (1, 0)]]]), region(UNIT))
