"""The rational of the least denominator between two: right, and found for bounds of any length."""

from __future__ import annotations

import random
from fractions import Fraction
from math import ceil

import pytest
from minkref.certify.simplest import simplest_between

SEED = 7


def by_trying(low: Fraction, high: Fraction) -> Fraction:
    """The least denominator, and the least numerator with it."""
    denominator = 1
    while ceil(low * denominator) > high * denominator:
        denominator += 1
    return Fraction(ceil(low * denominator), denominator)


def test_it_has_the_least_denominator() -> None:
    dice = random.Random(SEED)
    for _ in range(2000):
        low, high = sorted(Fraction(dice.randrange(400), dice.randrange(1, 60)) for _ in range(2))
        if low == high:
            continue
        found = simplest_between(low, high)
        assert low <= found <= high, (SEED, low, high)
        assert found == by_trying(low, high), (SEED, low, high)


@pytest.mark.parametrize(
    ("low", "high", "found"),
    [
        ("0", "1/3", "0"),
        ("1/3", "1/2", "1/2"),
        ("1/3", "2/5", "1/3"),
        ("5/7", "8/11", "5/7"),
        ("2", "7/2", "2"),
        ("5/2", "7/2", "3"),
        ("314/100", "315/100", "22/7"),
    ],
)
def test_some_by_hand(low: str, high: str, found: str) -> None:
    assert simplest_between(Fraction(low), Fraction(high)) == Fraction(found)


@pytest.mark.parametrize("terms", [999, 1001, 5_000])
def test_between_neighbouring_convergents_of_the_golden_ratio(terms: int) -> None:
    """The bounds have a thousand terms in common and more: no depth of calls is needed. The
    earlier of two neighbours has the smaller denominator, and nothing in between has less."""
    a, b = 1, 1
    for _ in range(terms):
        a, b = a + b, a
    shorter, longer = Fraction(a, b), Fraction(a + b, a)
    assert simplest_between(*sorted((shorter, longer))) == shorter
    # Strictly in between: their mediant is the simplest.
    mediant = Fraction(2 * a + b, a + b)
    third = (longer - shorter) / 3
    inner = simplest_between(*sorted((shorter + third, longer - third / 10**6)))
    assert inner.denominator >= mediant.denominator
