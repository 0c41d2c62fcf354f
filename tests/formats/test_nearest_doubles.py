"""A double written for an exact number is the nearest one, and a table shows certain digits only:
for sets in the plane, at any size, according to independent readers."""

from __future__ import annotations

import json
import math
import re
from fractions import Fraction
from random import Random
from typing import Any

import minkref
import pytest
from minkref.cli.output import measure
from minkref.exact import approximate, in_double_range, rounded
from minkref.plane.shapes import _of_bits

SEED = 20
NUMBER = r"[-+]?(?:\d+\.?\d*|\.\d+)(?:[eE][-+]?\d+)?"
Point = tuple[Fraction, Fraction]


def triangle(dice: Random) -> list[Point]:
    """Far, near, huge, tiny, flat; with and without finite decimals."""
    unit = Fraction(dice.choice([10**250, 10**18, 1, 1, 1])) / dice.choice([1, 1, 10**200, 10**30])
    far = dice.choice([0, 0, 10**15, -(3**40)])
    denominators = [1, 2, 3, 7, 10**6, 2**70, 3**50]

    def number() -> Fraction:
        part = Fraction(dice.randint(-(10**9), 10**9), dice.choice(denominators))
        return (far + part) * unit

    while True:
        a, b, c = [(number(), number()) for _ in range(3)]
        turn = (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0])
        if turn:
            return [a, b, c] if turn > 0 else [a, c, b]


def has_decimals(value: Fraction) -> bool:
    rest = value.denominator
    for prime in (2, 5):
        while rest % prime == 0:
            rest //= prime
    return rest == 1


def read(text: str, form: str) -> list[Fraction]:
    """All coordinates, in text order."""
    if form == "json":
        (polygon,) = json.loads(text)["polygons"]
        return [Fraction(x) for point in polygon["outer"] for x in point]
    lines = text.splitlines()
    body = "\n".join(lines[2:5]) if form == "poly" else text
    numbers = [Fraction(word) for word in re.findall(NUMBER, body)]
    return numbers if form == "poly" else numbers[:-2]  # the first point is repeated


@pytest.mark.parametrize("form", ["wkt", "geojson", "poly", "json"])
def test_a_writer_writes_the_number_or_the_double_next_to_it(form: str) -> None:
    dice = Random(SEED)
    for k in range(200):
        corners = triangle(dice)
        written = read(minkref.write(minkref.PolygonSet(corners), form), form)
        exact = [axis for corner in corners for axis in corner]
        for found, wanted in zip(written, exact, strict=True):
            if form == "json" or has_decimals(wanted):
                assert found == wanted, f"seed {SEED}, case {k}"
            else:
                assert float(found) == float(wanted), f"seed {SEED}, case {k}"


def test_arrays_and_pictures_have_the_nearest_doubles() -> None:
    dice = Random(SEED)
    for k in range(100):
        corners = triangle(dice)
        made = minkref.PolygonSet(corners)
        ((array,),) = made.arrays()
        assert array.tolist() == [[float(x), float(y)] for x, y in corners], f"case {k}"
        xs, ys = zip(*corners, strict=True)
        assert made.bounding_box() == (
            *map(float, map(min, (xs, ys))),
            *map(float, map(max, (xs, ys))),
        )
        factor = 1000 / max(max(xs) - min(xs), max(ys) - min(ys))
        drawn = [float(word) for word in re.findall(NUMBER, picture_path(made))]
        places = [((x - min(xs)) * factor, (max(ys) - y) * factor) for x, y in corners]
        assert drawn == [float(axis) for place in places for axis in place], f"case {k}"


def picture_path(made: Any) -> str:
    found = re.search(r'd="([^"]*)"', minkref.write(made, "svg"))
    assert found
    return found[1]


def numbers(dice: Random) -> Fraction:
    """Among them halfway between doubles, by some 1e-60, and beyond their range."""
    near = Fraction(dice.random()) + Fraction(1, 2**54) * dice.choice([1, 0])
    off = Fraction(dice.choice([-1, 0, 1]), 10**60)
    return (near + off) * Fraction(10) ** dice.choice([-400, -310, -20, 0, 20, 300, 400])


def test_the_double_beside_an_exact_number_is_rounded_once() -> None:
    dice = Random(SEED)
    for k in range(2000):
        value = numbers(dice)
        try:
            nearest = float(value)
        except OverflowError:
            nearest = math.inf
        assert approximate(str(value)) == nearest, f"seed {SEED}, case {k}"
        assert approximate(str(-value)) == -nearest
        if math.isinf(nearest) or (nearest == 0 and value):
            assert in_double_range(str(value)) is None
    halfway = Fraction(1) + Fraction(1, 2**53)
    assert approximate(str(halfway + Fraction(1, 10**60))) == 1 + 2**-52  # was rounded twice
    assert approximate("9" * 5000) == math.inf  # of any length


@pytest.mark.parametrize("digits", [6, 10, 17])
def test_digits_of_a_table_are_those_of_the_number(digits: int) -> None:
    dice = Random(SEED)
    for k in range(500):
        value = numbers(dice)
        shown = Fraction(rounded(str(value), digits))
        power = len(str(int(value))) - 1 if value >= 1 else -1
        while value and value < Fraction(10) ** power:
            power -= 1
        assert abs(shown - value) <= Fraction(10) ** (power - digits + 1) / 2, f"case {k}"
    assert rounded("0") == "0" and rounded("145") == "145" and rounded("1/8", 2) == "0.12"


def test_no_equals_sign_stands_beside_a_rounded_number() -> None:
    assert measure("21096362063/1174360") == "21096362063/1174360, about 17964.13541"
    assert measure("9") == "9" and measure("1/4") == "1/4 = 0.25"
    assert measure(str(10**400)) == "about 1e400 (401 characters; --json prints it)"


@pytest.mark.parametrize("far", ["0", "500000", "1e20", "1e300", "-1e-320"])
@pytest.mark.parametrize("side", ["10", "1/3", "1e-30", "1e-400", "1e150", "1e200"])
def test_the_area_of_an_index_is_told_within_a_small_part_of_it(side: str, far: str) -> None:
    """At 1e300 it was between minus infinity and infinity, for a square of side 1."""
    x, a = Fraction(far), Fraction(side)
    P = minkref.PolygonSet([(x, x), (x + a, x), (x + a, x + a), (x, x + a)])
    Q = minkref.PolygonSet([(0, 0), (a / 3, 0), (0, a)])
    index = minkref.build_index(P, Q, 1, 2)
    for scale in ("1", "3/2", "2"):
        exact = Fraction(minkref.minkowski_sum(P, Q, scale).region.area())
        if exact > 10**308:
            with pytest.raises(minkref.LimitExceeded, match="beyond the range of doubles"):
                index.area(scale)
            continue
        value, error = index.area(scale)
        assert math.isfinite(value) and abs(_of_bits(value) - exact) <= _of_bits(error)
        assert _of_bits(error) <= max(abs(_of_bits(value)) / 2**39, Fraction(1, 2**1074))
