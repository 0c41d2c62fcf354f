"""The names of arithmetics."""

from __future__ import annotations

import re

from minkref.errors import Refusal, nearest

NAMES = ("rational", "interval", "double")
EXAMPLES = (*NAMES, "mpfr:53")
FEWEST_BITS, MOST_BITS = 2, 1_000_000
_MPFR = re.compile(r"mpfr:(\d+)", re.ASCII)


def check_arithmetic(name: str, where: str = "--arithmetic") -> None:
    """Refuses what is none of rational, interval, double and mpfr:BITS."""
    mpfr = _MPFR.fullmatch(name)
    if name not in NAMES and not mpfr:
        raise Refusal(
            f"there is no arithmetic {name[:40]!r}",
            where,
            f"{nearest(name, EXAMPLES)}choose rational, interval, double or mpfr:BITS",
        )
    if mpfr and not (len(mpfr[1]) <= 20 and FEWEST_BITS <= int(mpfr[1]) <= MOST_BITS):
        raise Refusal(
            f"{mpfr[1][:20]} bits are out of range",
            where,
            f"choose between {FEWEST_BITS} and {MOST_BITS} bits",
        )
