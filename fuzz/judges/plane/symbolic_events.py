"""Pair, parallel and triple events against the symbolic oracle: every pair and triple of edges."""

from __future__ import annotations

from minkref.fuzz.geometry.plane import written_rings
from minkref.fuzz.judges.plane.event_rows import compared, show
from minkref.fuzz.judges.ruling import Ruling
from minkref.fuzz.plane.case import Case
from minkref.fuzz.verdicts.verdict import Reason
from minkref.oracle.symbolic.arrangement import pairwise_events, threefold_events
from minkref.oracle.symbolic.convolution import reduced_convolution
from minkref.oracle.symbolic.moving import Point
from minkref.oracle.symbolic.rational import rational

WHAT = {
    "convolution": "edges of the reduced convolution",
    "arrangement": "events of the arrangement",
    "pair search": "pair and parallel events",
}
LONGEST = 40  # edges of the convolution: all triples of more would take too long


def judge(case: Case) -> Ruling:
    """The edges of the reduced convolution, and all events of `--kind arrangement` and of `--kind
    pair` and `parallel`: scale, change, parents, place."""
    if not (case.P.is_region and case.Q.is_region):
        return Ruling(skipped="an operand that is a point, a segment or empty")
    edges = reduced_convolution(_rings(case.P_json), _rings(case.Q_json))
    if len(edges) > LONGEST:
        return Ruling(skipped=f"more than {LONGEST} edges of the convolution")
    ruling = Ruling()
    segments = [edge.segment for edge in edges]
    found = pairwise_events(segments) + threefold_events(segments)
    for what, (missed, invented) in compared(edges, found, case.P, case.Q).items():
        ruling.compare(
            f"{WHAT[what]} that only one side has",
            sorted(map(show, invented)), sorted(map(show, missed)),
            Reason.EVENT_MISSED if missed else Reason.EVENT_INVENTED,
        )  # fmt: skip
    return ruling


def _rings(text: str) -> list[list[Point]]:
    return [[(rational(x), rational(y)) for x, y in ring] for ring in written_rings(text)]
