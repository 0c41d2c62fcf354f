"""Edges of a convolution as the paper writes them, asked through the code of `reference/` (as
printed and as corrected) and through the symbolic oracle."""

from __future__ import annotations

from dataclasses import dataclass
from fractions import Fraction

from minkref import _core
from minkref.fuzz.judges.plane.paper_pairs import contact_interval

Place = tuple[int, int]
Interval = (
    tuple[Fraction | None, Fraction | None] | None
)  # None: empty; None: 0 below, no end above
ENDS = ("a0", "a1", "b0", "b1")


@dataclass(frozen=True)
class Edge:
    """From s p + q along d."""

    kind: str
    p: Place
    q: Place
    d: Place

    @property
    def numbers(self) -> tuple[str, tuple[int, ...]]:
        return self.kind, (*self.p, *self.q, *self.d)


def s_edge(p0: Place, p1: Place, q: Place) -> Edge:
    """The edge from p0 to p1 of P at the vertex q of Q: s p0 + q to s p1 + q."""
    return Edge("S", p0, q, (p1[0] - p0[0], p1[1] - p0[1]))


def t_edge(q0: Place, q1: Place, p: Place) -> Edge:
    """The edge from q0 to q1 of Q at the vertex p of P: q0 + s p to q1 + s p."""
    return Edge("T", p, q0, (q1[0] - q0[0], q1[1] - q0[1]))


@dataclass(frozen=True)
class Answers:
    """Answers for one pair: the scales at which the lines' crossing passes each end, if any; the
    interval as printed, with sorted ends, by the rule for convex P, as corrected, and from the
    symbolic oracle."""

    ends: dict[str, Fraction | None]
    printed: Interval
    convex: Interval
    corrected: Interval
    symbolic: Interval

    @property
    def sorted(self) -> Interval:
        """[max of the lesser scales, min of the greater scales], for s > 0. Needs all four
        scales."""
        a, b = ([self.ends[f"{edge}{i}"] for i in (0, 1)] for edge in "ab")
        roots = [scale for scale in (*a, *b) if scale is not None]
        low = max(min(roots[:2]), min(roots[2:]), Fraction(0))
        high = min(max(roots[:2]), max(roots[2:]))
        return (low if low > 0 else None, high) if low <= high and high > 0 else None


def answers(a: Edge, b: Edge) -> Answers:
    told = _core.pair_by_paper(a.numbers, b.numbers)
    ends = {
        name: None if scale is None else Fraction(scale)
        for name, scale in zip(ENDS, told["ends"], strict=True)
    }
    return Answers(
        ends,
        printed=_interval(told["printed"]),
        convex=_interval(told["convex"]),
        corrected=_interval(told["corrected"]),
        symbolic=symbolic_interval(a, b),
    )


def symbolic_interval(a: Edge, b: Edge) -> Interval:
    """By the symbolic oracle; the edges may be parallel."""
    return _interval(contact_interval(a.numbers, b.numbers))


def _interval(value: tuple[str | None, str | None] | None) -> Interval:
    if value is None:
        return None
    low, high = (None if bound is None else Fraction(bound) for bound in value)
    return low, high


def written(interval: Interval) -> str:
    if interval is None:
        return "empty"
    low, high = interval
    start = "(0" if low is None else f"[{low}"
    return f"{start}, {'∞)' if high is None else f'{high}]'}"
