"""The least precision at which the paper's method gets all events of a case right."""

from __future__ import annotations

from minkref import _core

FEWEST_BITS, MOST_BITS = 8, 2048


def least_precision(
    P: _core.PolygonSet, Q: _core.PolygonSet, form: str = "corrected", most: int = MOST_BITS
) -> int | None:
    """Bits of mpfr such that no event is missed, invented or out of order: the least found by
    doubling, then halving the last step. A higher precision need not be right, too: rounding knows
    no order. None if no doubling up to `most` suffices, as for events that only exact arithmetic
    can tell: an end that stays on a line for all scales, a pair that only touches."""

    def enough(bits: int) -> bool:
        return bool(_core.precision_trial(P, Q, f"mpfr:{bits}", form)["all_right"])

    bits = FEWEST_BITS
    while not enough(bits):
        bits *= 2
        if bits > most:
            return None
    if bits == FEWEST_BITS:
        return bits
    low, high = bits // 2, bits
    while high - low > 1:
        middle = (low + high) // 2
        if enough(middle):
            high = middle
        else:
            low = middle
    return high
