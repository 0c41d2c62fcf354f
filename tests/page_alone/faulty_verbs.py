"""Faulty adapters: `update`, `events`, invalid input and the protocol itself, in the plane."""

from __future__ import annotations

from fractions import Fraction
from typing import Any

from conversation import Answer, Rejected, Request
from minkref import _core
from plane_adapter import Events, Plane, Refusing, Updating
from plane_sets import polygons_of, rings_of, set_of


class UpdateDrifts(Updating):
    """Each `update` moves the sum a billionth to the right, and the next one on from there."""

    off = Fraction(0)

    def at(self, request: Request) -> Answer:
        self.off = Fraction(0)
        return super().at(request)

    def update(self, request: Request) -> Answer:
        self.off += Fraction(1, 10**9)
        return super().update(request)

    def number(self, value: Fraction) -> Any:
        return str(value + self.off)


class SecondUpdateStays(Updating):
    """The second `update` after an `at` answers the sum of the first."""

    def at(self, request: Request) -> Answer:
        self.count = 0
        return super().at(request)

    def update(self, request: Request) -> Answer:
        self.count += 1
        if self.count > 1:
            return self.last
        self.last = super().update(request)
        return self.last


class UpdateIgnoresScale(Updating):
    """`update` answers the sum that the last `at` found."""

    def at(self, request: Request) -> Answer:
        self.last = super().at(request)
        return self.last

    def update(self, request: Request) -> Answer:
        return self.last


class UpdateKeepsHoles(Updating):
    """`update` to a smaller scale forgets that holes are born."""

    def update(self, request: Request) -> Answer:
        before = self.scale
        found = super().update(request)
        if self.scale < before:
            for polygon in found["polygons"]:
                polygon["holes"] = []
        return found


class EventsWithoutTouch(Events):
    """Leaves out scales at which something only touches itself."""

    def found(self, request: Request) -> list[Any]:
        return [event for event in super().found(request) if event[2] != "touch"]


class EventsWithoutDeaths(Events):
    """Leaves out scales at which something dies."""

    def found(self, request: Request) -> list[Any]:
        return [event for event in super().found(request) if event[2] != "death"]


class EventsWithoutSplits(Events):
    """Leaves out scales at which something splits."""

    def found(self, request: Request) -> list[Any]:
        return [event for event in super().found(request) if event[2] != "split"]


class EventsOfHolesOnly(Events):
    """Leaves out what happens to components."""

    def found(self, request: Request) -> list[Any]:
        return [event for event in super().found(request) if event[1] == "hole"]


class EventsOneMore(Events):
    """Lists one more scale, halfway between the first two."""

    def scales(self, request: Request) -> list[Fraction]:
        found = super().scales(request)
        return sorted([*found, (found[0] + found[1]) / 2]) if len(found) > 1 else found


class EventsShifted(Events):
    """The last scale is off by 1e-6."""

    def scales(self, request: Request) -> list[Fraction]:
        found = super().scales(request)
        return [*found[:-1], found[-1] + Fraction(1, 10**6)] if found else found


class EventsOfPairs(Events):
    """Knows scales of pairs of edges only: an event of three edges is left out."""

    def scales(self, request: Request) -> list[Fraction]:
        found = super().scales(request)
        if not found:
            return found
        P, Q = set_of(self.P), set_of(self.Q)
        all_pairs = _core.pair_events(P, Q, str(found[0]), str(found[-1]))
        pairs = {Fraction(row[0]) for row in all_pairs.rows(0, len(all_pairs))}
        return [scale for scale in found if scale in pairs]


class EventsInsideOnly(Events):
    """Leaves out events at the ends of the window."""

    def scales(self, request: Request) -> list[Fraction]:
        ends = {Fraction(request[end]) for end in ("from", "to")}
        return [scale for scale in super().scales(request) if scale not in ends]


class EventsDescending(Events):
    """Lists the scales in descending order."""

    def scales(self, request: Request) -> list[Fraction]:
        return super().scales(request)[::-1]


class EventsEmpty(Events):
    """Lists no scale at all."""

    def scales(self, request: Request) -> list[Fraction]:
        return []


class AcceptsInvalid(Refusing):
    """Promises to reject invalid input, and rejects nothing."""

    def look_at(self, operand: Any) -> None:
        return None


class AcceptsCrossing(Refusing):
    """Rejects only rings of fewer than three vertices."""

    def look_at(self, operand: Any) -> None:
        if any(len(polygon["outer"]) < 3 for polygon in operand["polygons"]):
            super().look_at(operand)


class RejectsTouching(Refusing):
    """Rejects valid input in which rings touch."""

    def look_at(self, operand: Any) -> None:
        super().look_at(operand)
        corners = [p for ring in rings_of(polygons_of(set_of(operand))) for p in ring]
        if len(corners) != len(set(corners)):
            raise Rejected("a ring touches itself or another")


class WrongSeq(Plane):
    """Every tenth answer echoes the `seq` of the one before."""

    def line(self, seq: Any, answer: Answer) -> str:
        return super().line(seq - 1 if seq % 10 == 0 else seq, answer)


class Leaks(Plane):
    """Keeps 16 MiB of each request."""

    def __init__(self) -> None:
        self.kept: list[bytes] = []

    def at(self, request: Request) -> Answer:
        self.kept.append(b"x" * 2**24)
        return super().at(request)


class SkipsThin(Plane):
    """Skips, against its declaration, what has a box fifty times as long as wide."""

    def answer(self, request: Request) -> Answer:
        found = super().answer(request)
        if request["verb"] == "at" and found.get("polygons"):
            xmin, ymin, xmax, ymax = set_of(request["sP"]).bounding_box()
            if max(xmax - xmin, ymax - ymin) > 50 * min(xmax - xmin, ymax - ymin) > 0:
                return {"status": "skipped", "reason": "too thin"}
        return found


class HalfALine(Plane):
    """Ends in the middle of a line where the answer is long."""

    def line(self, seq: Any, answer: Answer) -> str:
        text = super().line(seq, answer)
        if len(text) > 1500:
            print(text[:1500], flush=True)
            raise SystemExit(0)
        return text


class ChattersOnOutput(Plane):
    """Writes a word of its own on standard output before answers of several polygons."""

    def line(self, seq: Any, answer: Answer) -> str:
        text = super().line(seq, answer)
        return (
            f"found {len(answer['polygons'])}\n{text}"
            if len(answer.get("polygons", [])) > 1
            else text
        )
