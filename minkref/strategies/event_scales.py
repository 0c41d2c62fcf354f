"""Scales of events, scales beside events, and others."""

from __future__ import annotations

from fractions import Fraction
from typing import Any, Literal

from hypothesis import strategies as st
from minkref import _core
from minkref.strategies.regions import pairs
from minkref.strategies.values import ScaledPair, SetData, to_set

Kind = Literal["arrangement", "boundary", "topology"]
KINDS = ("arrangement", "boundary", "topology")
PLACES = ("any", "at", "below", "above", "between")


def scales_near_events(
    P: SetData, Q: SetData, *, kind: Kind = "boundary", bits: int = 60
) -> st.SearchStrategy[str]:
    """Draw scales for a pair: critical scales, scales 2^-k below or above a critical scale (1 <= k
    <= bits, more if the scale would not be positive), scales half way between two, and others.
    `kind`: the change at a critical scale (docs/definitions.md): `arrangement`, `boundary` or
    `topology`.

    Shrinks to 1, then to the simplest critical scale, then to the largest distance from a critical
    scale. Exact. Finds the events once per example; O((n + k) log n), k the arrangement events.
    Raises ValueError for another kind and for `bits` below 1, BadInput for invalid operands."""
    if kind not in KINDS:
        raise ValueError(f"there is no kind {kind!r}: the kinds are {', '.join(KINDS)}")
    if bits < 1:
        raise ValueError(f"bits is {bits}: give a number of at least 1")
    return _scales(P, Q, kind, bits)


def scaled_pairs(
    *, kind: Kind = "boundary", bits: int = 60, **bounds: Any
) -> st.SearchStrategy[ScaledPair]:
    """Draw operands as `pairs` does within `bounds`, and a scale as `scales_near_events` does.

    Shrinks as both do. Exact, and always valid. Costs as much as both."""
    return pairs(**bounds).flatmap(
        lambda both: scales_near_events(*both, kind=kind, bits=bits).map(
            lambda scale: {"P": both[0], "Q": both[1], "scale": scale}
        )
    )


@st.composite
def _scales(draw: st.DrawFn, P: SetData, Q: SetData, kind: Kind, bits: int) -> str:
    critical = critical_scales(P, Q, kind)
    place = draw(st.sampled_from(PLACES if critical else PLACES[:1]))
    if place == "any":
        return str(Fraction(draw(st.integers(1, 12)), draw(st.integers(1, 12))))
    if place == "between":
        ends = [critical[0] / 2, *critical, 2 * critical[-1]]
        k = draw(st.integers(0, len(ends) - 2))
        return str((ends[k] + ends[k + 1]) / 2)
    simplest = sorted(critical, key=lambda s: (s.denominator, s.numerator))
    scale = simplest[draw(st.integers(0, len(simplest) - 1))]
    if place == "at":
        return str(scale)
    near = Fraction(1, 2 ** draw(st.integers(1, bits)))
    while near >= scale:
        near /= 2
    return str(scale - near if place == "below" else scale + near)


def critical_scales(P: SetData, Q: SetData, kind: Kind) -> list[Fraction]:
    """List critical scales ascending, each once. Exact."""
    first, second = to_set(P), to_set(Q)
    first.validate("P")
    second.validate("Q")
    if kind == "arrangement":
        events = _core.ArrangementEvents(first, second)
        scales = [row[0] for row in events.rows(events.of_kind("arrangement"))]
    else:
        dynamic = _core.DynamicSum(first, second)
        rows: list[Any] = list(
            dynamic.boundary_events() if kind == "boundary" else dynamic.topology_events()
        )
        scales = [row[0] for row in rows]
    return sorted({Fraction(scale) for scale in scales})
