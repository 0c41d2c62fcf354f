"""A random.Random whose throws Hypothesis draws and can shrink."""

from __future__ import annotations

from collections.abc import MutableSequence, Sequence
from random import Random
from typing import Any, TypeVar

from hypothesis import strategies as st
from minkref.degeneracies.family import NothingDrawn

T = TypeVar("T")
THROWS = 100  # drawn one by one; later throws follow from one number
MOST = 300  # then draws nothing: another draw may be quicker
FINENESS = 100  # number of values of random()


class Dice(Random):
    """A random generator for Hypothesis. Numbers shrink towards 0, choices to the first, and
    random() to nearly 1: generators ask `random() < share` for anything but the simplest. A
    generator that repeats until content would repeat the simplest throws for ever; so only the
    first THROWS are drawn, and a seed drawn afterwards gives the others. Raises NothingDrawn after
    MOST throws."""

    def __new__(cls, draw: st.DrawFn) -> Dice:
        return super().__new__(cls)

    def __init__(self, draw: st.DrawFn) -> None:
        super().__init__(0)
        self._draw, self._thrown = draw, 0
        self._rest: Random | None = None

    def randint(self, a: int, b: int) -> int:
        self._thrown += 1
        if self._thrown > MOST:
            raise NothingDrawn
        if self._thrown <= THROWS:
            return self._draw(st.integers(a, b))
        if self._rest is None:
            self._rest = Random(self._draw(st.integers(0, 2**16)))
        return self._rest.randint(a, b)

    def randrange(self, start: int, stop: int | None = None, step: int = 1) -> int:
        numbers = range(start) if stop is None else range(start, stop, step)
        return numbers[self.randint(0, len(numbers) - 1)]

    def random(self) -> float:
        return (FINENESS - 1 - self.randint(0, FINENESS - 1)) / FINENESS

    def getrandbits(self, k: int, /) -> int:
        return self.randint(0, 2**k - 1)

    def choice(self, seq: Any) -> Any:
        return seq[self.randint(0, len(seq) - 1)]

    def shuffle(self, x: MutableSequence[Any]) -> None:
        x[:] = self.sample(x, len(x))

    def sample(self, population: Sequence[T], k: int, *, counts: Any = None) -> list[T]:
        left = list(population)
        return [left.pop(self.randint(0, len(left) - 1)) for _ in range(k)]
