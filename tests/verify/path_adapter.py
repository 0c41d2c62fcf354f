"""An adapter that answers the verb `path`, in a way that the argument names.

right           by the reference
trapezoids      by pieces in plain fractions, single scales only
rounded         each end of a range off by a hair, within a declared tolerance
doubles         as rounded, takes doubles only and sends them
coarse          looks at five places of each segment
touching        takes a touch for a collision, whatever the rule
careless        lets the part touch, whatever the rule
one-interval    knows the first valid range only
not-alone       leaves out scales that are valid alone
inner           does not look at the ends of segments
first-segment   looks at the first segment only
turned          places the part turned by a half-turn
hull            takes the convex hull of the part
no-holes        fills the holes of the obstacles
closed          lists ranges with both ends, whether they belong to them or not
never           calls nothing valid
always          calls everything valid
rejects         rejects the input
short           leaves out the answer to the last scale
"""

from __future__ import annotations

import json
import sys
from collections.abc import Iterator
from fractions import Fraction
from itertools import pairwise
from typing import Any

import minkref
from minkref.fuzz.geometry.plane import fraction_rings, hull
from minkref.motion.scale_ranges import ScaleRange
from path_by_trapezoids import passes

HAIR = Fraction(1, 10**12)
TINY = Fraction(1, 2**40)
Place = tuple[Fraction, Fraction]


def shape(value: Any) -> minkref.PolygonSet:
    """The exact set from numbers as texts or doubles."""
    return minkref.PolygonSet.from_json(json.dumps(texts(value)))


def texts(value: Any) -> Any:
    if isinstance(value, dict):
        return {key: texts(one) for key, one in value.items()}
    if isinstance(value, list):
        return [texts(one) for one in value]
    return str(Fraction(value))


def doubles(value: Any) -> Any:
    if isinstance(value, dict):
        return {key: doubles(one) for key, one in value.items()}
    return [doubles(one) for one in value] if isinstance(value, list) else float(Fraction(value))


def between(a: Place, b: Place, t: Fraction) -> Place:
    return (a[0] + t * (b[0] - a[0]), a[1] + t * (b[1] - a[1]))


def paths(way: str, path: list[Place]) -> Iterator[list[Place]]:
    """Paths that a way checks instead of the given path."""
    segments = list(pairwise(path))
    if way == "first-segment":
        yield path[:2]
    elif way == "inner":
        yield from ([between(a, b, TINY), between(a, b, 1 - TINY)] for a, b in segments)
    elif way == "coarse":
        yield from ([p] for p in path)
        for a, b in segments:
            yield from ([between(a, b, Fraction(k, 4))] for k in (1, 2, 3))
    else:
        yield path


def operands(way: str, part: Any, obstacles: Any) -> tuple[minkref.PolygonSet, minkref.PolygonSet]:
    if way == "no-holes":
        kept = [{"outer": one["outer"], "holes": []} for one in obstacles["polygons"]]
        obstacles = {"polygons": kept}
    moved, fixed = shape(part), shape(obstacles)
    if way == "turned":
        moved = moved.scaled("-1")
    if way == "hull":
        corners = [p for ring in fraction_rings(moved.to_json()) for p in ring]
        moved = minkref.PolygonSet(hull(corners))
    return moved, fixed


def valid(
    way: str, part: Any, obstacles: Any, request: dict[str, Any]
) -> tuple[list[tuple[ScaleRange, ...]], bool]:
    """Ranges that must all hold a valid scale, and whether no scale is valid."""
    contact = {"touching": "forbidden", "careless": "allowed"}.get(way, request["contact"])
    path = [(Fraction(x), Fraction(y)) for x, y in request["path"]]
    moved, fixed = operands(way, part, obstacles)
    found = [minkref.valid_scales(moved, fixed, one, contact).ranges for one in paths(way, path)]
    if way == "one-interval":
        found = [ranges[:1] for ranges in found]
    if way == "not-alone":
        found = [tuple(one for one in ranges if one.low != one.high) for ranges in found]
    if way in ("rounded", "doubles"):
        found = [tuple(map(rounded, ranges)) for ranges in found]
    if way == "always":
        found = []
    return found, way == "never"


def rounded(one: ScaleRange) -> ScaleRange:
    high = None if one.high is None else one.high * (1 + HAIR)
    return ScaleRange(one.low * (1 - HAIR), high, True, True)


def answer_path(way: str, part: Any, obstacles: Any, request: dict[str, Any]) -> dict[str, Any]:
    if way == "trapezoids":
        path = [(Fraction(x), Fraction(y)) for x, y in request["path"]]
        scales, contact = map(Fraction, request["scales"]), request["contact"]
        return {"valid": [passes(part, obstacles, path, scale, contact) for scale in scales]}
    found, nothing = valid(way, part, obstacles, request)

    def holds(scale: Fraction) -> bool:
        return not nothing and all(any(scale in one for one in ranges) for ranges in found)

    if "scales" in request:
        told = [holds(Fraction(scale)) for scale in request["scales"]]
        return {"valid": told[:-1] if way == "short" else told}
    low, high = Fraction(request["from"]), Fraction(request["to"])
    ends = {end for ranges in found for one in ranges for end in (one.low, one.high) if end}
    cuts = sorted({low, high, *(end for end in ends if low < end < high)})
    listed = []
    for a, b in zip(cuts, [*cuts[1:], None], strict=True):
        if holds(a):
            listed.append({"from": str(a), "to": str(a)})
        if b is not None and holds((a + b) / 2):
            is_closed = way == "closed"
            listed.append({"from": str(a), "to": str(b), "from_in": is_closed, "to_in": is_closed})
    return {"ranges": listed}


def main(way: str) -> None:
    capabilities = ["plane", "non-convex", "holes", "components", "touching", "point", "segment"]
    capabilities += ["path", "path-ranges"]
    hello: dict[str, Any] = {"name": way, "version": "1", "arithmetic": "exact"}
    hello["capabilities"] = [*capabilities, "rational"]
    if way == "trapezoids":
        without = ("path-ranges", "point", "segment")
        hello["capabilities"] = [word for word in hello["capabilities"] if word not in without]
    if way in ("rounded", "doubles"):
        hello |= {"arithmetic": "float64", "tolerance": {"relative": "1e-9"}}
    if way == "doubles":
        hello |= {"numbers": "double", "capabilities": capabilities}
    loaded: Any = None
    for line in sys.stdin:
        request = json.loads(line)
        verb, answer = request["verb"], {"status": "result"}
        if verb == "hello":
            answer |= {"protocol": "adapter-v1", **hello}
        elif verb == "load":
            loaded = (request["P"], request["Q"])
        elif verb == "path" and way == "rejects":
            answer = {"status": "rejected", "reason": "no"}
        elif verb == "path":
            answer |= answer_path(way, *loaded, request)
        elif verb == "at":
            P, Q = shape(request["sP"]), shape(loaded[1])
            found = json.loads(minkref.minkowski_sum(P, Q).region.canonical_json())
            answer |= doubles(found) if way == "doubles" else found
        print(json.dumps({"seq": request["seq"], **answer}), flush=True)
        if verb == "stop":
            return


if __name__ == "__main__":
    main(sys.argv[1])
