"""Points on a circle by decimal series, with the same digits on every machine."""

from __future__ import annotations

from decimal import ROUND_HALF_EVEN, Context, Decimal

DIGITS = Context(prec=60, rounding=ROUND_HALF_EVEN)


def pi() -> Decimal:
    """Compute pi by Machin's formula, 16 arctan 1/5 - 4 arctan 1/239, to 27 decimals."""

    def arctan_of_reciprocal(n: int) -> Decimal:
        total, power, k = Decimal(0), DIGITS.divide(Decimal(1), Decimal(n)), 0
        while power > Decimal("1e-62"):
            term = DIGITS.divide(power, Decimal(2 * k + 1))
            total = DIGITS.add(total, term if k % 2 == 0 else -term)
            power, k = DIGITS.divide(power, Decimal(n * n)), k + 1
        return total

    return DIGITS.subtract(16 * arctan_of_reciprocal(5), 4 * arctan_of_reciprocal(239))


def cosine_and_sine(turns: Decimal) -> tuple[Decimal, Decimal]:
    """Compute cos and sin of 2 pi `turns` by their series, to 25 decimals for |turns| <= 1.

    A change of sign rounds to Decimal's own 28 digits; the shipped models depend on this
    rounding."""
    angle = DIGITS.multiply(DIGITS.multiply(Decimal(2), pi()), turns)
    sums, term, k = [Decimal(0), Decimal(0)], Decimal(1), 0
    while k < 2 or abs(term) > Decimal("1e-62"):
        sums[k % 2] = DIGITS.add(sums[k % 2], term if k % 4 < 2 else -term)
        k += 1
        term = DIGITS.divide(DIGITS.multiply(term, angle), Decimal(k))
    return sums[0], sums[1]


def regular(corners: int, radius: Decimal, decimals: int) -> list[tuple[int, int]]:
    """Compute a regular polygon with a vertex on the positive x axis, in units of 10^-decimals,
    rounded."""
    unit = Decimal(10) ** decimals
    ring = []
    for k in range(corners):
        cosine, sine = cosine_and_sine(Decimal(k) / Decimal(corners))
        ring.append(
            (
                int((unit * radius * cosine).to_integral_value(ROUND_HALF_EVEN)),
                int((unit * radius * sine).to_integral_value(ROUND_HALF_EVEN)),
            )
        )
    return ring
