"""The loop of an adapter, right for convex operands in the plane; hostile adapters change one step.
Written from docs/adapter-protocol.md alone."""

from __future__ import annotations

import json
import os
import sys
from abc import ABC, abstractmethod
from fractions import Fraction
from typing import Any, ClassVar

Request = dict[str, Any]
Answer = dict[str, Any]
Point = tuple[Fraction, Fraction]


class Adapter:
    """Takes words NAME=VALUE on its command line: `run`, a mark of the run, and `ports` and folders
    to try. Its version tells a mischief's outcome."""

    declares: ClassVar[dict[str, Any]] = {}
    instead: ClassVar[str] = ""  # the verb that `mischief` is the answer to; else before `hello`

    def __init__(self, told: dict[str, str]) -> None:
        self.told = told
        self.run = told["run"]

    def mischief(self, request: Request) -> str | None:
        """Does the mischief; its text becomes the version where the mischief precedes `hello`."""
        return None

    def hello(self, version: str) -> Answer:
        return {
            "status": "result",
            "protocol": "adapter-v1",
            "name": type(self).__name__,
            "version": version,
            "arithmetic": "exact",
            "numbers": "text",
            "capabilities": ["plane", "rational"],
            **self.declares,
        }

    def load(self, request: Request) -> Answer:
        self.P, self.Q = request["P"], request["Q"]
        return {"status": "result"}

    def at(self, request: Request) -> Answer:
        ring = sum_of_convex(ring_of(request["sP"]), ring_of(self.Q))
        outer = [[str(x), str(y)] for x, y in ring]
        return {"status": "result", "polygons": [{"outer": outer, "holes": []}]}

    def update(self, request: Request) -> Answer:
        return self.at(request)

    def events(self, request: Request) -> Answer:
        return {"status": "result", "scales": []}

    def answer(self, request: Request) -> Answer:
        if request["verb"] == "hello":
            version = self.mischief(request) if not self.instead else None
            return self.hello(version or "1")
        found: Answer = getattr(self, request["verb"])(request)
        return found

    def line(self, request: Request) -> bytes:
        """The answer, without the end of the line."""
        return json.dumps({"seq": request["seq"], **self.answer(request)}).encode()

    def serve(self) -> None:
        for text in sys.stdin.buffer:
            request = json.loads(text)
            if request["verb"] == "stop":
                return
            if request["verb"] == self.instead:
                self.mischief(request)
            else:
                say(self.line(request) + b"\n")


class InTurn(Adapter, ABC):
    """Spoils each sum in the next way of a list."""

    count = 0

    def line(self, request: Request) -> bytes:
        text = super().line(request)
        if request["verb"] != "at":
            return text
        self.count += 1
        return self.spoilt(text, request)

    @abstractmethod
    def spoilt(self, text: bytes, request: Request) -> bytes: ...


def say(text: bytes) -> None:
    """Writes the whole text, past every buffer."""
    while text:
        text = text[os.write(1, text) :]


def ring_of(operand: Any) -> list[Point]:
    (polygon,) = operand["polygons"]
    return [(Fraction(x), Fraction(y)) for x, y in polygon["outer"]]


def sum_of_convex(a: list[Point], b: list[Point]) -> list[Point]:
    """Merges the edges of two counter-clockwise convex polygons by direction."""
    a, b = from_lowest(a), from_lowest(b)
    ring, i, j = [], 0, 0
    while i < len(a) or j < len(b):
        p, q = a[i % len(a)], b[j % len(b)]
        ring.append((p[0] + q[0], p[1] + q[1]))
        turn = cross(edge(a, i), edge(b, j))
        step_a = j == len(b) or (i < len(a) and turn >= 0)
        step_b = i == len(a) or (j < len(b) and turn <= 0)
        i, j = i + step_a, j + step_b
    return ring


def from_lowest(ring: list[Point]) -> list[Point]:
    start = min(range(len(ring)), key=lambda k: (ring[k][1], ring[k][0]))
    return ring[start:] + ring[:start]


def edge(ring: list[Point], k: int) -> Point:
    (ax, ay), (bx, by) = ring[k % len(ring)], ring[(k + 1) % len(ring)]
    return bx - ax, by - ay


def cross(a: Point, b: Point) -> Fraction:
    return a[0] * b[1] - a[1] * b[0]
