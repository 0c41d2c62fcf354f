"""Pictures of a degenerate case: operands, and the sum below, at and above the scale. Exact
arithmetic moves coordinates to a frame of size one before they become doubles, so that very large
and very small cases can be drawn."""

from __future__ import annotations

import itertools
import json
from collections.abc import Iterable
from dataclasses import dataclass
from decimal import Decimal
from fractions import Fraction
from typing import Any

from minkref import _core
from minkref.reports.drawing import Layer, picture

Rings = list[list[list[tuple[Fraction, Fraction]]]]  # by polygon
Frame = tuple[Fraction, Fraction, Fraction]  # left, bottom, the longer side


@dataclass(frozen=True)
class Drawn:
    caption: str
    svg: str


def case_pictures(value: dict[str, Any]) -> list[Drawn]:
    """Pictures of a case-v1 with siblings: P and Q separately, the three sums in one frame."""
    P, Q = (_rings(value[name]) for name in "PQ")
    scales = value["scales"]
    beside = (len(scales) - 1) // 2
    wanted = [(scales[1], "just below"), (scales[0], "at"), (scales[1 + beside], "just above")]
    first, second = (_core.PolygonSet.from_json(json.dumps(value[name])) for name in "PQ")
    sums = [
        _rings(json.loads(_core.minkowski_sum(first, second, scale).region.canonical_json()))
        for scale, _ in wanted
    ]
    frame = _frame([*sums[0], *sums[1], *sums[2]])
    drawn = [
        Drawn(name, picture([Layer(style, _flat(rings, _frame(rings)))], name, 220))
        for name, rings, style in (("P", P, "first"), ("Q", Q, "second"))
    ]
    wound = "wound_zero_times" in value["degeneracy"]
    for (scale, where), rings in zip(wanted, sums, strict=True):
        caption = f"the sum {where} {_short(value['scales'][0])}"
        layers = [Layer("sum", _flat(rings, frame))]
        if scale == scales[0]:
            layers += _passages(value["degeneracy"]["tight_passages"], frame)
            if wound:
                layers += _passages([[value["degeneracy"]["wound_zero_times"]]], frame)
        drawn.append(
            Drawn(caption, picture(layers, caption, 300, (0.0, 0.0, 1.0, _height(frame, sums))))
        )
    return drawn


def _passages(pieces: list[list[list[str]]], frame: Frame) -> list[Layer]:
    layers: list[Layer] = []
    for piece in pieces:
        points = [_place((Fraction(x), Fraction(y)), frame) for x, y in piece]
        if len(points) == 1:
            layers.append(Layer("witness", point=points[0]))
        else:
            ends = itertools.pairwise(points)
            layers.append(Layer("missing", segments=[(*a, *b) for a, b in ends]))
    return layers


def _rings(value: dict[str, Any]) -> Rings:
    return [
        [
            [(Fraction(x), Fraction(y)) for x, y in ring]
            for ring in (p["outer"], *p.get("holes", []))
        ]
        for p in value["polygons"]
    ]


def _frame(rings: Rings) -> Frame:
    points = [point for polygon in rings for ring in polygon for point in ring]
    if not points:
        return Fraction(0), Fraction(0), Fraction(1)
    (left, right), (bottom, top) = (_ends(c) for c in zip(*points, strict=True))
    return left, bottom, max(right - left, top - bottom) or Fraction(1)


def _height(frame: Frame, sums: list[Rings]) -> float:
    tops = [y for rings in sums for polygon in rings for ring in polygon for _, y in ring]
    return float((max(tops, default=frame[1] + frame[2]) - frame[1]) / frame[2])


def _ends(values: Iterable[Fraction]) -> tuple[Fraction, Fraction]:
    ordered = sorted(values)
    return ordered[0], ordered[-1]


def _place(point: tuple[Fraction, Fraction], frame: Frame) -> tuple[float, float]:
    left, bottom, side = frame
    return float((point[0] - left) / side), float((point[1] - bottom) / side)


def _flat(rings: Rings, frame: Frame) -> list[list[list[tuple[float, float]]]]:
    return [[[_place(point, frame) for point in ring] for ring in polygon] for polygon in rings]


def _short(number: str) -> str:
    """A number for a caption, of any size."""
    value = Fraction(number)
    rounded = Decimal(value.numerator) / Decimal(value.denominator)
    return number if len(number) <= 12 else f"s = {rounded:.6g}"
