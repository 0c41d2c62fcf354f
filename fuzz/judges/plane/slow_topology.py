"""Topology below, at and above scales of events against the slow engine, which knows no event."""

from __future__ import annotations

from collections import Counter
from fractions import Fraction

from minkref import _core
from minkref.fuzz.judges.plane.slow_operands import slow_operands
from minkref.fuzz.judges.ruling import Ruling, event_scales
from minkref.fuzz.plane.case import Case
from minkref.fuzz.verdicts.verdict import Reason
from minkref.oracle import slow
from minkref.oracle.slow.identity import Link
from minkref.oracle.slow.state import State

Counts = tuple[int, int, int]


def judge(case: Case) -> Ruling:
    """Components, holes and vertices on the three sides of an event, whether the boundary changes,
    and which holes and components are born, die, merge, split or touch (the numbers by the route
    dynamic, the events by the route index too)."""
    ruling = Ruling()
    P, Q = slow_operands(case)
    dynamic = _core.DynamicSum(case.P, case.Q)
    index = _core.ScaleIndex(case.P, case.Q)
    boundary = {
        "dynamic": {row[0] for row in dynamic.boundary_events()},
        "index": {row[0] for row in index.boundary_events()},
    }
    for scale in event_scales(case, dynamic):
        truth = slow.topology(P, Q, Fraction(scale))
        below, at, above = _counts(dynamic, Fraction(scale))
        ruling.compare(
            f"components, holes and vertices just below {scale}", below, _of(truth.below),
            Reason.HOLE_LOST if below[1] < len(truth.below.complement) else Reason.HOLE_INVENTED,
        )  # fmt: skip
        ruling.compare(
            f"components and holes at {scale}", at, _of(truth.at)[:2], Reason.STATE_DRIFT
        )
        ruling.compare(
            f"components, holes and vertices just above {scale}", above, _of(truth.above),
            Reason.HOLE_LOST if above[1] < len(truth.above.complement) else Reason.HOLE_INVENTED,
        )  # fmt: skip
        for route, sums in (("dynamic", dynamic), ("index", index)):
            told = scale in boundary[route]
            ruling.compare(
                f"whether the boundary changes at {scale}, route {route}", told,
                truth.boundary_changes,
                Reason.EVENT_INVENTED if told else Reason.EVENT_MISSED,
            )  # fmt: skip
            ruling.compare(
                f"what happens to holes and components at {scale}, route {route}",
                _reported(sums, scale), _linked(truth), Reason.EVENT_MISPLACED,
            )  # fmt: skip
    return ruling


def _of(state: State) -> Counts:
    vertices = sum(sum(rings) for rings in state.shape)
    return len(state.interior), len(state.complement), vertices


def _counts(dynamic: _core.DynamicSum, scale: Fraction) -> tuple[Counts, tuple[int, int], Counts]:
    """Components, holes (and vertices) just below, at and just above a scale. A state holds from
    its scale to the next one's."""
    below = at = above = None
    for begin, (holes, components, vertices, holes_at, components_at) in dynamic.state_counts():
        here = (components, holes, vertices)
        if begin is None or Fraction(begin) < scale:
            below, at, above = here, here[:2], here
        elif Fraction(begin) == scale:
            at, above = (components_at, holes_at), here
    assert below is not None and at is not None and above is not None
    return below, at, above


Change = tuple[str, str, int, int, int]


def _linked(truth: slow.Topology) -> Counter[Change]:
    """Feature, change, how many below, at and above."""
    changes: Counter[Change] = Counter()
    for feature, links in (("hole", truth.holes), ("component", truth.components)):
        for link in links:
            if link.change != "same":
                counts = len(link.below), len(link.at), len(link.above)
                changes[feature, _word(link), *counts] += 1
    return changes


def _word(link: Link) -> str:
    """Several features that become several others merge if fewer exist above, else they split."""
    if link.change == "merge and split":
        return "merge" if len(link.below) > len(link.above) else "split"
    return link.change


def _reported(sums: _core.DynamicSum | _core.ScaleIndex, scale: str) -> Counter[Change]:
    return Counter(
        (feature, change, len(before), parts, len(after))
        for s, feature, change, before, after, parts, _ in sums.topology_events()
        if s == scale
    )
