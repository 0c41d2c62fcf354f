"""Shrinking: ever smaller cases for which a predicate still holds. Exact, deterministic."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from dataclasses import dataclass
from typing import Generic, Protocol, TypeVar

MOST_CALLS = 600


class Sized(Protocol):
    @property
    def size(self) -> tuple[object, ...]: ...


T = TypeVar("T", bound=Sized)


@dataclass
class Shrunk(Generic[T]):
    """`complete`: no step makes it smaller; else the number of calls ran out."""

    case: T
    calls: int
    complete: bool


def shrink(
    case: T,
    smaller: Callable[[T], Iterator[T]],
    still: Callable[[T], bool],
    most_calls: int = MOST_CALLS,
) -> Shrunk[T]:
    """Greedy: takes the first of `smaller(case)` for which `still` holds, the boldest steps first,
    and begins again from there, until none does. Steps must make `case.size` less, so shrinking
    ends. Refused candidates are not tried again. Calls `still` at most `most_calls` times."""
    refused: set[tuple[object, ...]] = set()
    calls = 0
    while True:
        for candidate in smaller(case):
            key = candidate.size
            if key >= case.size or key in refused:
                continue
            if calls >= most_calls:
                return Shrunk(case, calls, False)
            calls += 1
            if still(candidate):
                case = candidate
                break
            refused.add(key)
        else:
            return Shrunk(case, calls, True)
