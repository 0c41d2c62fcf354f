"""Faulty adapters in the plane: invalid input and the protocol itself."""

from __future__ import annotations

from typing import Any

from conversation import Answer, Rejected, Request
from plane_adapter import Plane, Refusing
from plane_sets import Polygon, polygons_of, rings_of, set_of, trapezoids


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
    """Rejects valid input with touching rings."""

    def look_at(self, operand: Any) -> None:
        super().look_at(operand)
        corners = [p for ring in rings_of(polygons_of(set_of(operand))) for p in ring]
        if len(corners) != len(set(corners)):
            raise Rejected("a ring touches itself or another")


class WrongSeq(Plane):
    """Echoes the previous `seq` in every tenth answer."""

    def line(self, seq: Any, answer: Answer) -> str:
        return super().line(seq - 1 if seq % 10 == 0 else seq, answer)


class Leaks(Plane):
    """Keeps 16 MiB for each request."""

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
    """Ends in the middle of a long answer's line."""

    def line(self, seq: Any, answer: Answer) -> str:
        text = super().line(seq, answer)
        if len(text) > 1500:
            print(text[:1500], flush=True)
            raise SystemExit(0)
        return text


class ChattersOnOutput(Plane):
    """Writes a word on standard output before answers with several polygons."""

    def line(self, seq: Any, answer: Answer) -> str:
        text = super().line(seq, answer)
        return (
            f"found {len(answer['polygons'])}\n{text}"
            if len(answer.get("polygons", [])) > 1
            else text
        )


class OverlappingPolygons(Plane):
    """Lists polygons whose interiors overlap; the page has `rings` for such answers."""

    def form(self, polygons: list[Polygon]) -> Answer:
        return super().form([*polygons, *((ring, []) for ring in trapezoids(rings_of(polygons)))])
