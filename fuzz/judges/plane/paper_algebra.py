"""The event array of the paper's program before computer algebra: births and deaths of contacts
between two edges."""

from __future__ import annotations

from collections import Counter
from dataclasses import dataclass
from fractions import Fraction

from minkref import _core
from minkref.fuzz.judges.plane.event_rows import parents_of
from minkref.fuzz.libraries.paper.program_name import ProgramName
from minkref.oracle.symbolic.arrangement import pairwise_events
from minkref.oracle.symbolic.convolution import reduced_convolution
from minkref.oracle.symbolic.rational import rationals

Parents = tuple[str, int, int, int, int]
# Two edges of the reduced convolution, and whether they begin to meet.
Change = tuple[frozenset[Parents], bool]
Scales = dict[Change, Fraction]
BEGINS = {"birth": (True,), "death": (False,), "touch": (True, False), "overlap": (True, False)}
RIGHT, MISPLACED, MISSED, INVENTED = "right", "misplaced", "missed", "invented"
UNDECIDED = "undecided"  # the arithmetic told no sign: no list


@dataclass(frozen=True)
class Algebra:
    """Events by computer algebra."""

    edges: int
    scales: Scales


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
    return Algebra(len(found), scales)


def listed(P: _core.PolygonSet, Q: _core.PolygonSet, name: ProgramName) -> Scales:
    """The program's births and deaths. Raises UndecidedSign."""
    edges = [parents_of(row) for row in _core.reduced_convolution(P, Q)]
    program = _core.PaperUpdate(P, Q, "1", name.arithmetic, name.readings)
    return {
        (frozenset((edges[a], edges[b])), begins): Fraction(scale)
        for scale, a, b, begins in program.events()
    }


def compared(truth: Scales, claimed: Scales, relative: Fraction) -> Counter[str]:
    """Counts: a scale is right within a relative tolerance."""
    counts: Counter[str] = Counter()
    for change, scale in truth.items():
        got = claimed.get(change)
        if got is None:
            counts[MISSED] += 1
        else:
            counts[RIGHT if abs(got - scale) <= relative * scale else MISPLACED] += 1
    counts[INVENTED] += sum(change not in truth for change in claimed)
    return counts
