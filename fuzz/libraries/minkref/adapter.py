"""minkref itself in inexact arithmetic: the argument is double or mpfr:BITS.

All predicates then use rounded numbers, without any filter or repair: the result may be another
set. The declaration equals a floating point library's, and `wrong` is to be expected: this shows
the value of exact arithmetic.
"""

from __future__ import annotations

import json
import sys

from adapter_protocol import Set, serve  # type: ignore[import-not-found,unused-ignore]
from minkref import _core
from minkref.fuzz.libraries.paper.with_disc import corrected, grown
from minkref.version import version

#: Numbers that its arithmetic does not hold are rounded to the nearest that it does.
CAPABILITIES = "plane non-convex holes components touching empty point segment rational offset"


def operand(value: Set) -> _core.PolygonSet:
    return _core.PolygonSet.from_json(json.dumps(value))


def main(arithmetic: str) -> None:
    hello = {
        "name": "minkref-" + arithmetic.replace(":", ""),
        "version": version(),
        "language": "C++",
        "arithmetic": "float64" if arithmetic == "double" else arithmetic,
        "numbers": "text",
        "tolerance": {"absolute": "0", "relative": "1e-9"},
        "sum": "region",
        "sets": "regularised",
        "capabilities": CAPABILITIES.split(),
    }

    def sum_of(sP: Set, Q: Set) -> dict[str, object]:
        answer = _core.minkowski_sum(operand(sP), operand(Q), "1", "paper", arithmetic)
        result: dict[str, object] = json.loads(answer.region.canonical_json())
        return result

    def offset_of(P: Set, radius: str) -> dict[str, object]:
        """By the program of the Appendix, its sentences corrected."""
        return grown(json.dumps(P), radius, arithmetic, corrected())

    serve(hello, sum_of, offset_of=offset_of)


if __name__ == "__main__":
    main(sys.argv[1])
