"""Malformed numbers, one after another, at every verb, for the plane and for space. The page allows
only `n`, `n/d` and decimals, with ASCII digits."""

from __future__ import annotations

import json
from typing import Any, ClassVar

from honest import Adapter, Answer, Request

HUGE = "1e1_000_000_000"
TEXTS = [
    *("1_0", "1e1_0", HUGE, "1e1000000000", "-1E+999999999999", "1e-1000000000", "1e99999"),
    *("0e99999", "1e00001", "9" * 20_000_000, "1/" + "9" * 5_000_000, "0." + "1" * 5_000_000),
    *("\u0661", "\uff11", "\u00b2", "\u00bd", "\u2460", "\u096a/\u0969", "\u22121", "1\u00a0"),
    *(" 1", "1 ", "1\n", "\t1", "1 /2", "1/ 2", "+ 1", "- 1", "1\u0000", "\ufeff1", "\u200b1"),
    *("0x10", "0b1", "0o7", "1L", "1n", "1.0f", "0x1p3", "1j", "1e1.5", "1e1/2", "1e+", "e5"),
    *("1/0", "0/0", "-1/0", "1/-2", "1/+2", "1//2", "1/2/3", "1/2e3", "1.5/2", "1/1.5", "/2", "1/"),
    *("", "+", "-", ".", "+.", "--1", "+-1", "1..2", "1.2.3", "1,5", "1'000", "1 000", "(1)"),
    *("inf", "-inf", "Infinity", "nan", "NaN", "sNaN", "None", "true", "one", "{}", "1%", "$1"),
]
JSON = [
    *("NaN", "Infinity", "-Infinity", "1e999999999", "-1e99999", "1e-999999999", "1.5e400"),
    *("null", "true", "false", "[]", "{}", "[1]", '{"n": 1}', "01", "+1", ".5", "1.", "0x1"),
    *("1_0", "1e1_0", "9" * 20_000_000, "0." + "1" * 5_000_000, "1/2", "'1'", "\u0661", ""),
]
SPELLINGS = [*(json.dumps(text) for text in TEXTS), *JSON]


class Spells(Adapter):
    """Replaces a number with each spelling, in all answers to a verb."""

    verb: ClassVar[str] = "at"
    form: ClassVar[str] = '"polygons": [{"outer": [[%s, "0"], ["9", "0"], ["0", "9"]]}]'
    spellings: ClassVar[list[str]] = SPELLINGS

    def __init__(self, told: dict[str, str]) -> None:
        super().__init__(told)
        self.count = int(told.get("first", "0"))

    def line(self, request: Request) -> bytes:
        if request["verb"] != self.verb:
            return super().line(request)
        spelling = self.spellings[self.count % len(self.spellings)]
        self.count += 1
        seq = str(request["seq"])
        members = self.form.replace("%s", spelling)
        return f'{{"seq": {seq}, "status": "result", {members}}}'.encode("utf-8", "surrogatepass")

    def at(self, request: Request) -> Answer:
        return {"status": "result", "polygons": []}


class SpellsPolygons(Spells):
    """Spells a coordinate of a polygon's ring."""


class SpellsRings(Spells):
    """Spells a coordinate of a flat list of rings."""

    form = '"rings": [[["0", "0"], ["9", %s], ["0", "9"]]]'


class SpellsInDoubles(Spells):
    """Spells a double: texts are no doubles, whatever they spell."""

    declares: ClassVar[dict[str, Any]] = {"numbers": "double", "arithmetic": "float64"}
    form = '"polygons": [{"outer": [[%s, 0], [9, 0], [0, 9]]}]'


class SpellsUpdates(Spells):
    """Spells a coordinate of the answer to `update`."""

    verb = "update"
    declares: ClassVar[dict[str, Any]] = {"capabilities": ["plane", "rational", "update"]}

    def at(self, request: Request) -> Answer:
        return Adapter.at(self, request)


class SpellsEvents(Spells):
    """Spells a scale of the event list."""

    verb = "events"
    form = '"scales": [%s]'
    declares: ClassVar[dict[str, Any]] = {
        "capabilities": ["plane", "non-convex", "holes", "components", "rational", "events"]
    }


class InSpace(Spells):
    declares: ClassVar[dict[str, Any]] = {"capabilities": ["space", "rational", "non-convex"]}
    form = (
        '"vertices": [[%s, "0", "0"], ["9", "0", "0"], ["0", "9", "0"], ["0", "0", "9"]], '
        '"faces": [[0, 2, 1], [0, 1, 3], [1, 2, 3], [2, 0, 3]]'
    )

    def at(self, request: Request) -> Answer:
        return {"status": "result", "vertices": [], "faces": []}


class SpellsSpace(InSpace):
    """Spells a coordinate of a body's vertex."""


class SpellsUpdatesInSpace(InSpace):
    """Spells a vertex coordinate of the answer to `update`."""

    verb = "update"
    declares: ClassVar[dict[str, Any]] = {
        "capabilities": ["space", "rational", "non-convex", "update", "non-uniform"]
    }


class SpellsIndices(InSpace):
    """Spells a vertex index of a face: an index is an integer from 0 on, and no coordinate."""

    form = '"vertices": [["0", "0", "0"], ["9", "0", "0"], ["0", "9", "0"]], "faces": [[0, 1, %s]]'
    spellings: ClassVar[list[str]] = [
        *SPELLINGS,
        *("-1", "3", "2147483648", "18446744073709551616", "1.0", "2e0", '"1"', "1e1000"),
    ]


class SpellsTolerance(Adapter):
    """Spells its declared tolerance, one spelling at each start; the option `first` chooses it."""

    member: ClassVar[str] = '"tolerance": {"relative": %s}'

    def line(self, request: Request) -> bytes:
        text = super().line(request)
        if request["verb"] != "hello":
            return text
        spelling = SPELLINGS[int(self.told.get("first", "2"))]
        text = text.replace(b'"exact"', b'"float64"')
        return text[:-1] + (", " + self.member.replace("%s", spelling) + "}").encode()


class SpellsGridUnit(SpellsTolerance):
    member = '"grid": {"unit": %s}'


class SpellsGridLargest(SpellsTolerance):
    member = '"grid": {"bits": 8, "largest": %s}'


class SpellsGridBits(SpellsTolerance):
    member = '"grid": {"bits": %s}'


class HugeNumbers(Spells):
    """Allowed numbers of the greatest length: judged, in time, and wrong."""

    spellings: ClassVar[list[str]] = [
        *('"1e9999"', '"-1e9999"', '"1e-9999"', '"%s"' % ("7" * 9000), '"1/%s"' % ("7" * 9000)),
        *('"0.%s"' % ("3" * 9000), '"0e9999"', '"-0"', '"+0.0"', "7" * 4000),
    ]
