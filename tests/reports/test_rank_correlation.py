"""Rank correlations against the definition, and the laws of their intervals."""

from __future__ import annotations

import random
from statistics import StatisticsError

import pytest
from minkref.reports.bench.rank_correlation import rank_correlation, ranks, stronger_by


def test_equal_values_share_the_mean_of_their_ranks() -> None:
    assert ranks([3, 1, 3, 2]) == [2.5, 0, 2.5, 1]


def test_a_rising_function_has_the_correlation_1_and_a_falling_one_has_the_opposite() -> None:
    xs = [0.1, 0.7, 2, 5, 11, 12]
    for sign in (1, -1):
        found = rank_correlation(xs, [sign * x**3 for x in xs])
        assert found.value == found.low == found.high == pytest.approx(sign)


def test_the_correlation_of_ranks_without_ties_is_that_of_the_formula() -> None:
    """1 - 6 sum d^2 / (n (n^2 - 1)), by Spearman."""
    dice = random.Random(7)
    xs, ys = ([dice.random() for _ in range(30)] for _ in range(2))
    square = sum((a - b) ** 2 for a, b in zip(ranks(xs), ranks(ys), strict=True))
    found = rank_correlation(xs, ys)
    assert found.value == pytest.approx(1 - 6 * square / (30 * (30**2 - 1)))
    assert found.low < found.value < found.high


def test_an_interval_is_the_same_for_the_same_values_and_narrower_for_more() -> None:
    dice = random.Random(8)
    xs = [dice.random() for _ in range(120)]
    ys = [x + dice.random() for x in xs]
    few, many = rank_correlation(xs[:20], ys[:20]), rank_correlation(xs, ys)
    assert few == rank_correlation(xs[:20], ys[:20])
    assert many.high - many.low < few.high - few.low


def test_the_better_predictor_is_told_by_an_interval_above_0() -> None:
    dice = random.Random(9)
    ys = [dice.random() for _ in range(40)]
    noise = [dice.random() for _ in range(40)]
    assert stronger_by(ys, [-y for y in ys], noise).low > 0
    equal = stronger_by(ys, ys, [-y for y in ys])
    assert equal.value == equal.low == equal.high == pytest.approx(0)


def test_a_constant_has_no_correlation() -> None:
    with pytest.raises(StatisticsError):
        rank_correlation([1, 2, 3], [4, 4, 4])
