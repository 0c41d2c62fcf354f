"""Pair, parallel and triple events against the symbolic oracle: every pair and triple of edges."""

from __future__ import annotations

import json
from collections import Counter

from minkref import _core
from minkref.fuzz.case import Case
from minkref.fuzz.judges.event_rows import (
    minkref_rows,
    pair_search_rows,
    parents_of,
    show,
    symbolic_rows,
    unmatched,
)
from minkref.fuzz.judges.ruling import Ruling
from minkref.fuzz.verdict import Reason
from minkref.oracle.symbolic.arrangement import pairwise_events, threefold_events
from minkref.oracle.symbolic.convolution import reduced_convolution
from minkref.oracle.symbolic.moving import Point
from minkref.oracle.symbolic.rational import rational

LONGEST = 40  # edges of the convolution: all triples of more would take too long


def judge(case: Case) -> Ruling:
    """The edges of the reduced convolution, and all events of `--kind arrangement` and of `--kind
    pair` and `parallel`: scale, change, parents, place."""
    edges = reduced_convolution(_rings(case.P_json), _rings(case.Q_json))
    if len(edges) > LONGEST:
        return Ruling(skipped=f"more than {LONGEST} edges of the convolution")
    ruling = Ruling()
    listed = Counter(parents_of(row) for row in _core.reduced_convolution(case.P, case.Q))
    mine = Counter(edge.parents for edge in edges)
    if not ruling.compare(
        "edges of the reduced convolution that only one side has",
        sorted((listed - mine).elements()), sorted((mine - listed).elements()),
        Reason.EVENT_MISPLACED,
    ):  # fmt: skip
        return ruling
    segments = [edge.segment for edge in edges]
    truth = symbolic_rows(edges, pairwise_events(segments) + threefold_events(segments))
    events = _core.ArrangementEvents(case.P, case.Q)
    known = Counter({row: n for row, n in truth.items() if row[1] != "triple" and row[2] != "swap"})
    for what, expected, found in (
        ("arrangement", truth, minkref_rows(events, events.of_kind("arrangement"))),
        ("pair and parallel", known, pair_search_rows(_core.pair_events(case.P, case.Q))),
    ):
        missed, invented = unmatched(expected, found)
        ruling.compare(
            f"{what} events that only one side has",
            sorted(map(show, invented)), sorted(map(show, missed)),
            Reason.EVENT_MISSED if missed else Reason.EVENT_INVENTED,
        )  # fmt: skip
    return ruling


def _rings(text: str) -> list[list[Point]]:
    return [
        [(rational(x), rational(y)) for x, y in ring]
        for polygon in json.loads(text)["polygons"]
        for ring in (polygon["outer"], *polygon["holes"])
    ]
