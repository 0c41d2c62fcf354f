#!/usr/bin/env python3
"""Checks certificates of Minkowski sums, paths, bridges and unions: `python3 check.py FILE...`.

The checker stands alone: this file and the standard library. Each part of it needs this one, the
last one, and those that it names. The forms, the demands of each rule and why they are enough:
docs/certificates.md, and certificates-convex.md, -solids, -paths, -features, -unions, -disc.
Signs are decided in integers and fractions. Anything unknown, unused or left over is malformed.

Exit codes: 0 verified; 1 refuted; 2 malformed, or its case is missing; 4 out of budget.
"""

from __future__ import annotations

import argparse
import hashlib
import itertools
import json
import os
import re
import signal
import sys
import time
from collections import Counter, defaultdict
from collections.abc import Callable, Iterable, Iterator, Sequence
from contextlib import contextmanager
from fractions import Fraction
from math import gcd, inf, isqrt, lcm
from pathlib import Path
from typing import Any, ClassVar, NamedTuple, TypeVar

VERIFIED, REFUTED, MALFORMED, OUT_OF_BUDGET = 0, 1, 2, 4
NUMBER = re.compile(r"[+-]?(\d+(\.\d*)?|\.\d+)([eE][+-]?(\d{1,3}|1000))?|[+-]?\d+/\d+", re.ASCII)
SURROGATE = re.compile(r"(?<!\\)(\\\\)*\\u[dD][89a-fA-F]")
MOST_DIGITS, MOST_BITS = 100_000, 2**31  # of one number; of numbers over one denominator
GZIP = b"\x1f\x8b"

Json = Any
Vertex = tuple[Fraction, ...]  # x, y; or x0, x1, y0, y1: the point (x0 + s x1, y0 + s y1)
Reader = Callable[[Path, float], bytes]  # of a file, and of a larger one a byte more than so many
# The function that follows a form, and the member that holds the argument; parts add theirs.
FORMS: dict[Any, tuple[str, Callable[..., list[str]]]] = {}


class NotVerified(Exception):
    def __init__(self, code: int, what: str) -> None:
        super().__init__(what)
        self.code = code


def demand(condition: bool, what: str, code: int = REFUTED) -> None:
    if not condition:
        raise NotVerified(code, what)


def require(condition: bool, what: str) -> None:
    demand(condition, what, MALFORMED)


@contextmanager
def within(place: str) -> Iterator[None]:
    """Puts the place before the message of an error inside."""
    try:
        yield
    except NotVerified as error:
        raise NotVerified(error.code, f"{place}: {error}") from error


class Budget:
    """The time and the tests that may still be spent. A signal ends work between two tests."""

    def __init__(self, seconds: float, tests: float) -> None:
        self.deadline, self.tests = time.monotonic() + seconds, tests
        signal.signal(signal.SIGALRM, lambda *_: self.spend(inf))
        signal.setitimer(signal.ITIMER_REAL, max(1e-6, min(seconds, 1e9)))

    def spend(self, tests: float) -> None:
        self.tests -= tests
        left = self.tests >= 0 and time.monotonic() < self.deadline
        demand(left, "a limit is reached (--seconds, --tests)", OUT_OF_BUDGET)

    def common(self, points: Sequence[Sequence[Fraction]]) -> int:
        """The common denominator, by which all coordinates become whole: they take room."""
        unit = 1
        for point in points:
            unit = lcm(unit, *(c.denominator for c in point))
            self.spend(1 + (bits := unit.bit_length()) // 64)
            demand(bits * len(points) <= MOST_BITS, "a denominator is too large", OUT_OF_BUDGET)
        return unit


def members(value: Json, names: str) -> list[Json]:
    """The members of an object, in the order of `names`, no others; `name?` may lack: None."""
    require(isinstance(value, dict), f"an object with {names} is missing")
    missing = [name for name in names.split() if name[-1] != "?" and name not in value]
    require(not missing, f"a member is missing: {', '.join(missing)}")
    known = names.replace("?", "").split()
    require(set(value) <= set(known), f"there are more members than {names}")
    return [value.get(name) for name in known]


def items(value: Json, length: int | None = None) -> list[Json]:
    require(isinstance(value, list), "a list is missing")
    require(length is None or len(value) == length, f"a list has not {length} entries")
    return list(value)


def headed(value: Json) -> tuple[Json, list[Json]]:
    """The first entry of a list, and the others."""
    require(items(value) != [], "a list is empty")
    return value[0], value[1:]


def integer(value: Json) -> int:
    require(isinstance(value, int) and not isinstance(value, bool), f"{value!r} is no integer")
    return int(value)


def index(value: Json, end: int) -> int:
    """A number below `end`: what is referred to has come before."""
    require(0 <= integer(value) < end, f"there is no number {value} before this")
    return int(value)


def number(value: Json) -> Fraction:
    if not isinstance(value, str):
        return Fraction(integer(value))
    good = len(value) <= MOST_DIGITS and NUMBER.fullmatch(value)
    require(bool(good) and not re.search("/0+$", value), f"{value[:60]!r} is no number")
    return Fraction(value)


def scale_of(value: Json) -> Fraction:
    require(number(value) > 0, f"the scale {value} is not positive")
    return number(value)


def vector(value: Json) -> Vertex:
    return tuple(number(coordinate) for coordinate in items(value, 2))


def file_bytes(path: Path, most: float) -> bytes:
    require(os.path.isfile(path), f"{str(path)[:400]} cannot be read: it is no file")
    with path.open("rb") as file:
        return file.read(int(most) + 1)


def read_json(path: Path, read: Reader, most: float, decimals: bool) -> Json:
    def unique(pairs: list[tuple[str, Json]]) -> Json:
        require(len(dict(pairs)) == len(pairs), "an object has a member twice")
        return dict(pairs)

    def refuse(text: str) -> Json:
        raise NotVerified(MALFORMED, f"{text[:60]} is no number here")

    try:
        data = read(path, most)
        demand(len(data) <= most, f"{path} has over {most:,.0f} bytes (--bytes)", OUT_OF_BUDGET)
        mend = "gzip -dc FILE | python3 check.py -, or minkref check FILE"
        require(data[:2] != GZIP, f"{path} is compressed by gzip: {mend}")
        text = data.decode()
        require(not SURROGATE.search(text), f"{path} escapes a surrogate")
        hooks: Json = {"parse_constant": refuse, "parse_float": str if decimals else refuse}
        hooks["parse_int"] = lambda text: (int if len(text) <= MOST_DIGITS else refuse)(text)
        return json.loads(text, object_pairs_hook=unique, **hooks)
    except OSError as error:
        raise NotVerified(MALFORMED, f"{path} cannot be read: {error.strerror}") from error
    except (ValueError, OverflowError, RecursionError) as error:
        raise NotVerified(MALFORMED, f"{path} is not JSON: {error}") from error


def digest_of(value: Json) -> str:
    text = json.dumps(value, sort_keys=True, separators=(",", ":"))
    return hashlib.sha256(text.encode()).hexdigest()


def edges_of(ring: Sequence[Any]) -> Iterator[tuple[Any, Any]]:
    return zip(ring, [*ring[1:], *ring[:1]], strict=True)
