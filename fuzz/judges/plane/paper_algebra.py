"""The event array of the paper's program before computer algebra: births and deaths of contacts
between two edges."""

from __future__ import annotations

from collections import Counter
from dataclasses import dataclass
from fractions import Fraction

from minkref import _core
from minkref.fuzz.judges.plane.event_comparison import is_degenerate
from minkref.fuzz.judges.plane.event_rows import parents_of
from minkref.fuzz.libraries.paper.program_name import ProgramName
from minkref.oracle.symbolic.arrangement import pairwise_events
from minkref.oracle.symbolic.convolution import reduced_convolution
from minkref.oracle.symbolic.moving import MovingSegment
from minkref.oracle.symbolic.rational import rationals

Parents = tuple[str, int, int, int, int]
# Two edges of the reduced convolution, and whether they begin to meet.
Change = tuple[frozenset[Parents], bool]
Scales = dict[Change, Fraction]
BEGINS = {"birth": (True,), "death": (False,), "touch": (True, False), "overlap": (True, False)}
RIGHT, MISPLACED, MISSED, INVENTED = "right", "misplaced", "missed", "invented"
GENERAL = "wrong in general position"  # of the wrong ones, those of pairs that are not degenerate
UNDECIDED = "undecided"  # the arithmetic told no sign: no list


@dataclass(frozen=True)
class Algebra:
    """Events by computer algebra."""

    edges: int
    scales: Scales
    segments: dict[Parents, MovingSegment]

    def is_general(self, change: Change) -> bool:
        """Whether the pair is in general position: not parallel, and each end comes to the other
        edge's line at a scale of its own."""
        pair = sorted((self.segments[each] for each in change[0]), key=lambda each: each.kind)
        return len(pair) == 2 and not is_degenerate(pair[0], pair[1])


def by_algebra(P: _core.PolygonSet, Q: _core.PolygonSet, most_edges: int) -> Algebra | None:
    """Derives all births and deaths from the definitions; None beyond `most_edges`. O(n^2),
    exact."""
    first, second = (
        [
            [rationals(map(str, corner)) for corner in ring]
            for rings in each.rings()
            for ring in rings
        ]
        for each in (P, Q)
    )
    found = reduced_convolution(first, second)  # type: ignore[arg-type]
    if len(found) > most_edges:
        return None
    scales: Scales = {}
    for each in pairwise_events([edge.segment for edge in found]):
        pair = frozenset(found[k].parents for k in each.segments)
        for begins in BEGINS.get(each.event.change, ()):
            scales[pair, begins] = Fraction(
                int(each.event.s.numerator), int(each.event.s.denominator)
            )
    return Algebra(len(found), scales, {edge.parents: edge.segment for edge in found})


def listed(P: _core.PolygonSet, Q: _core.PolygonSet, name: ProgramName) -> Scales:
    """The program's births and deaths. Raises UndecidedSign."""
    edges = [parents_of(row) for row in _core.reduced_convolution(P, Q)]
    program = _core.PaperUpdate(P, Q, "1", name.arithmetic, name.readings)
    return {
        (frozenset((edges[a], edges[b])), begins): Fraction(scale)
        for scale, a, b, begins in program.events()
    }


def compared(truth: Algebra, claimed: Scales, relative: Fraction) -> Counter[str]:
    """Counts: a scale is right within a relative tolerance."""
    counts: Counter[str] = Counter()
    wrong = [change for change in claimed if change not in truth.scales]
    counts[INVENTED] += len(wrong)
    for change, scale in truth.scales.items():
        got = claimed.get(change)
        if got is not None and abs(got - scale) <= relative * scale:
            counts[RIGHT] += 1
            continue
        counts[MISSED if got is None else MISPLACED] += 1
        wrong.append(change)
    counts[GENERAL] += sum(map(truth.is_general, wrong))
    return counts
