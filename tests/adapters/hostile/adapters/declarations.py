"""Answers to `hello` that lie or declare nothing. The option `first` chooses the lie."""

from __future__ import annotations

import json
from typing import Any

from honest import Adapter, Answer, Request

LIES: list[dict[str, Any]] = [
    {"protocol": "adapter-v2"},
    {"protocol": None},
    {"protocol": ["adapter-v1"]},
    {"unknown": 1},
    {"capabilities": ["plane", "everything"]},
    {"capabilities": "plane"},
    {"capabilities": {"plane": True}},
    {"capabilities": ["plane", ["space"]]},
    {"capabilities": ["plane"] + ["x" * 1000] * 1000},
    {"capabilities": None},
    {"arithmetic": 1},
    {"arithmetic": "\u0000"},
    {"numbers": "decimal"},
    {"numbers": True},
    {"sum": "everything"},
    {"sets": "open"},
    {"grid": {"bits": 0}},
    {"grid": {"bits": -1}},
    {"grid": {"bits": 10**18}},
    {"grid": {"bits": 1e300}},
    {"grid": {"bits": True}},
    {"grid": {"unit": "0"}},
    {"grid": {"unit": "-1"}},
    {"grid": {"bits": 8, "unit": "1"}},
    {"grid": {"largest": "-1"}},
    {"grid": {"largest": 10**400}},
    {"grid": {"bits": 8, "other": 1}},
    {"grid": []},
    {"arithmetic": "float64", "tolerance": {"absolute": "-1"}},
    {"arithmetic": "float64", "tolerance": {"relative": "1e99999999"}},
    {"arithmetic": "float64", "tolerance": {"relative": {}}},
    {"arithmetic": "float64", "tolerance": {"relative": 10**5000}},
    {"arithmetic": "float64", "tolerance": {"other": "1"}},
    {"arithmetic": "float64", "tolerance": "1e-9"},
    {"name": None},
    {"name": ["a"]},
    {"name": "x" * 10_000_000},
    {"version": 7},
    {"version": {"a": 1}},
    {"language": []},
    {"status": "skipped", "reason": "no"},
    {"status": "ok"},
    {"status": ["result"]},
    {"seq": 99},
]


class Lies(Adapter):
    """Tells the lie whose number the option `first` gives."""

    def line(self, request: Request) -> bytes:
        text = super().line(request)
        if request["verb"] != "hello":
            return text
        lie = LIES[int(self.told.get("first", "0"))]
        return json.dumps({**json.loads(text), **lie}).encode()


class PromisesAll(Adapter):
    """Declares every capability, and answers as one that takes convex operands only."""

    declares = {  # noqa: RUF012
        "capabilities": [
            *("plane", "space", "non-convex", "holes", "components", "touching", "empty", "point"),
            *("segment", "rational", "non-uniform", "rejects-invalid", "update", "events"),
        ]
    }

    def answer(self, request: Request) -> Answer:
        try:
            return super().answer(request)
        except (KeyError, ValueError, ZeroDivisionError):
            return {"status": "skipped", "reason": "not today"}


class HugeTolerance(Adapter):
    """Gives wrong sums within a declared tolerance of ten to the thousand, as the page allows."""

    declares = {  # noqa: RUF012
        "arithmetic": "float64",
        "tolerance": {"absolute": "1e1000", "relative": "1e1000"},
    }


class AnotherEachTime(Adapter):
    """Declares another name and version at every start, and forces restarts."""

    def hello(self, version: str) -> Answer:
        import time

        odd = time.time_ns() // 1000 % 2
        return {**super().hello(version), "name": f"other-{odd}", "version": str(time.time_ns())}

    def at(self, request: Request) -> Answer:
        if request["seq"] > 5:
            raise SystemExit(1)
        return super().at(request)
