"""The module in a process whose floating-point environment another library has changed."""

from __future__ import annotations

import ctypes
import platform
import struct
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from typing import Any

import minkref
import pytest
from minkref import _core

pytestmark = pytest.mark.skipif(
    (platform.system(), platform.machine()) != ("Linux", "x86_64"),
    reason="the layout of fenv_t is that of glibc for x86_64",
)
NEAREST, DOWN, UP, TO_ZERO = 0x0000, 0x2000, 0x4000, 0x6000  # of the word MXCSR
FLUSH = 0x8040  # results and operands
WAYS = {"down": DOWN, "up": UP, "to zero": TO_ZERO, "flushed": FLUSH, "flushed, up": FLUSH | UP}
WORD = struct.Struct("<28xI")  # where it stands in fenv_t


@contextmanager
def environment(bits: int) -> Iterator[None]:
    """This thread as a library may leave it."""
    libm = ctypes.CDLL("libm.so.6")
    before = ctypes.create_string_buffer(32)
    libm.fegetenv(before)
    changed = ctypes.create_string_buffer(before.raw, 32)
    (word,) = WORD.unpack_from(before.raw)
    struct.pack_into("<I", changed, 28, (word & ~0xE040) | bits)
    libm.fesetenv(changed)
    try:
        yield
    finally:
        after = ctypes.create_string_buffer(32)
        libm.fegetenv(after)
        libm.fesetenv(before)
    (word,) = WORD.unpack_from(after.raw)
    assert word & 0xE040 == bits, "the caller's environment is brought back"


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
