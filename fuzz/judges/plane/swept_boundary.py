"""Boundary events against the heights of the vertices of the swept solid."""

from __future__ import annotations

from fractions import Fraction

from minkref import _core
from minkref.fuzz.cgal.swept_solid import MOST_PAIRS, SweptSolid
from minkref.fuzz.judges.ruling import Ruling
from minkref.fuzz.plane.case import Case
from minkref.fuzz.verdicts.verdict import Reason

# Between fractions with primes that no event of small integer operands has.
LOW, HIGH = "101/1009", "1009/101"


def judge(case: Case, solid: SweptSolid) -> Ruling:
    """Compares scales for `--kind boundary`, by both routes, within a window."""
    answer = solid.vertices(case.P_json, case.Q_json, LOW, HIGH)
    if answer.status == "skipped":
        reason = answer.reason or ""
        too_many = f"more than {MOST_PAIRS} pairs of triangles"
        return Ruling(skipped=too_many if "pairs of triangles" in reason else reason)
    if answer.vertices is None:
        raise RuntimeError(f"the swept solid {answer.status}: {answer.reason}")
    ruling = Ruling()
    heights = {vertex.s for vertex in answer.vertices}
    for route, sums in (("dynamic", _core.DynamicSum), ("index", _core.ScaleIndex)):
        rows = sums(case.P, case.Q, LOW, HIGH).boundary_events()
        events = {Fraction(s) for s, *_ in rows} - {Fraction(LOW), Fraction(HIGH)}
        ruling.compare(
            f"scales of boundary events by the route {route}, less those of both",
            sorted(map(str, events - heights)), sorted(map(str, heights - events)),
            Reason.EVENT_INVENTED if events - heights else Reason.EVENT_MISSED,
        )  # fmt: skip
    return ruling
