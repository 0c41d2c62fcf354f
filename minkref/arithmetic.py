"""The names of arithmetics."""

from __future__ import annotations

import re

from minkref.errors import Refusal, nearest

NAMES = ("rational", "interval", "double")
FEWEST_BITS, MOST_BITS = 2, 1_000_000
_MPFR = re.compile(r"mpfr:(\d+)", re.ASCII)


def check_arithmetic(
    name: str, where: str = "--arithmetic", names: tuple[str, ...] = NAMES
) -> None:
    """Refuses everything but mpfr:BITS and the names."""
    mpfr = _MPFR.fullmatch(name)
    if name not in names and not mpfr:
        near = nearest(name, (*names, "mpfr:53"))
        mend = f"{near}choose {', '.join(names)} or mpfr:BITS"
        raise Refusal(f"there is no arithmetic {name[:40]!r}", where, mend)
    if mpfr and not (len(mpfr[1]) <= 20 and FEWEST_BITS <= int(mpfr[1]) <= MOST_BITS):
        raise Refusal(
            f"{mpfr[1][:20]} bits are out of range",
            where,
            f"choose between {FEWEST_BITS} and {MOST_BITS} bits",
        )
