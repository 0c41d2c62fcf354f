"""The module in a process whose floating-point environment another library has changed."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import minkref
import pytest
from float_environments import FLUSH, KNOWN, WAYS, environment
from minkref import _core

pytestmark = pytest.mark.skipif(not KNOWN, reason="the layout of fenv_t is glibc's for x86_64")


def square(low: str, high: str) -> minkref.PolygonSet:
    return minkref.PolygonSet([[(low, low), (high, low), (high, high), (low, high)]])


TINY = square(f"1/{2**1070}", f"3/{2**1070}")
SMALL = square(f"1/{2**536}", f"3/{2**536}")  # products of its coordinates are subnormal, and exact
L = minkref.PolygonSet([[(0, 0), (5, 0), (5, "1/3"), ("1/7", "1/3"), ("1/7", 4), (0, 4)]])
TRIANGLE = minkref.PolygonSet([[(0, 0), ("1/3", "1/7"), ("-1/9", "1/2")]])


def read_off() -> Any:
    index = minkref.build_index(L, TRIANGLE, "1/2", 2)
    return [index.sum("7/5").region.rings(), index.area("7/5"), index.event_scales()]


def all_radii() -> Any:
    index = _core.disc_index(L)
    points, starts = index.vertices(0.3)
    return points.tolist(), starts.tolist(), index.measures("1/9"), index.drawing(), index.radii()


QUESTIONS: dict[str, Callable[[], Any]] = {
    "interval": lambda: _core.minkowski_sum(SMALL, SMALL, "1", "paper", "interval").region.rings(),
    "winding": lambda: _core.minkowski_sum(L, TRIANGLE, "7/5", "winding").region.rings(),
    "offset of what is tiny": lambda: minkref.offset(TINY, f"1/{2**1070}").area,
    "offset": lambda: minkref.offset(L, "1/3").area,
    "index": read_off,
    "disc index": all_radii,
    "events": lambda: [str(event.scale) for event in minkref.events(L, TRIANGLE)],
    "doubles": lambda: [ring.tolist() for ring in TINY.arrays()[0]],
    "a double": lambda: minkref.PolygonSet([[(5e-324, 0), (1, 0), (0, 1)]]).rings(),
}


@pytest.mark.parametrize("way", WAYS)
@pytest.mark.parametrize("question", QUESTIONS)
def test_answers_are_those_of_a_fresh_process(question: str, way: str) -> None:
    right = QUESTIONS[question]()
    with environment(WAYS[way]):
        found = QUESTIONS[question]()
    assert repr(found) == repr(right)


def test_sum_of_subnormal_squares_is_not_empty_where_they_are_flushed() -> None:
    with environment(FLUSH):
        found = minkref.minkowski_sum(SMALL, SMALL, 1, arithmetic="interval")
        with pytest.raises(minkref.UndecidedSign):  # products are below all doubles
            minkref.minkowski_sum(TINY, TINY, 1, arithmetic="interval")
    assert not found.region.is_empty
    assert found.region == minkref.minkowski_sum(SMALL, SMALL, 1).region
