"""An adapter that unites sets, in a way that the argument names.

right          by the reference
slabs          by trapezoids in plain fractions, between the lines x = c through all crossings
doubles        as right, takes doubles only and sends them, rounded
forgets        leaves out the last set
no-holes       fills all holes of the union
parity         keeps what an odd number of sets has
together       lists the polygons of all sets as they are
outer          takes the sets without their holes
cracked        takes away a thin strip in the middle of the union
rejects        calls the input invalid
"""

from __future__ import annotations

import json
import sys
from fractions import Fraction
from itertools import pairwise
from typing import Any

import minkref
from minkref.fuzz.geometry.plane import Point, Shape, crossing, edges, segments_meet, turn

STRIP = Fraction(1, 10**6)
ALL = ["plane", "non-convex", "holes", "components", "touching", "empty", "rational", "union"]


def texts(value: Any) -> Any:
    if isinstance(value, dict):
        return {key: texts(one) for key, one in value.items()}
    return [texts(one) for one in value] if isinstance(value, list) else str(Fraction(value))


def doubles(value: Any) -> Any:
    if isinstance(value, dict):
        return {key: doubles(one) for key, one in value.items()}
    return [doubles(one) for one in value] if isinstance(value, list) else float(Fraction(value))


def read(value: Any) -> minkref.PolygonSet:
    return minkref.PolygonSet.from_json(json.dumps(texts(value)))


def without_holes(value: Any) -> Any:
    return {"polygons": [{"outer": one["outer"], "holes": []} for one in value["polygons"]]}


def united(way: str, sets: list[Any]) -> Any:
    if way == "slabs":
        return {"polygons": slabs([shape(each) for each in sets])}
    if way == "together":
        return {"polygons": [polygon for each in sets for polygon in each["polygons"]]}
    if way == "forgets":
        sets = sets[:-1]
    if way == "outer":
        sets = [without_holes(each) for each in sets]
    regions = [read(each) for each in sets]
    found = minkref.unite(regions)
    if way == "parity":
        found = minkref.unite([])
        for region in regions:
            both = minkref.intersect([found, region])
            found = minkref.subtract(minkref.unite([found, region]), [both])
    if way == "cracked" and not found.is_empty:
        x, y, w, h = extent(found)
        strip = [(x, y + h / 2), (x + w, y + h / 2), (x + w, y + h / 2 * (1 + STRIP))]
        strip.append((x, strip[-1][1]))
        found = minkref.subtract(found, [minkref.PolygonSet(strip)])
    value = json.loads(minkref.write(found, "json"))
    if way == "no-holes":
        value = without_holes(value)
    return doubles(value) if way == "doubles" else value


def extent(region: minkref.PolygonSet) -> tuple[Fraction, ...]:
    points = [p for polygon in region.rings() for ring in polygon for p in ring]
    (x, y), (u, v) = (tuple(f(p[k] for p in points) for k in (0, 1)) for f in (min, max))
    return x, y, u - x, v - y


def shape(value: Any) -> Shape:
    return [
        [[(Fraction(x), Fraction(y)) for x, y in ring] for ring in (one["outer"], *one["holes"])]
        for one in value["polygons"]
    ]


def slabs(sets: list[Shape]) -> list[Any]:
    """The trapezoids of all slabs: in each, edges do not cross and are ordered."""
    every = [edge for each in sets for edge in edges(each)]
    cuts = {p[0] for edge in every for p in edge}
    for k, (a, b) in enumerate(every):
        for c, d in every[:k]:
            parallel = (b[0] - a[0]) * (d[1] - c[1]) == (b[1] - a[1]) * (d[0] - c[0])
            if not parallel and segments_meet(a, b, c, d):
                cuts.add(crossing(a, b, c, d)[0])
    found = []
    xs = sorted(cuts)
    for left, right in pairwise(xs):
        middle = (left + right) / 2
        through = sorted(  # at one height, what begins comes before what ends
            (height(a, b, middle), -1 if a[0] < b[0] else 1, a, b)
            for a, b in every
            if min(a[0], b[0]) <= left and right <= max(a[0], b[0])
        )
        depth, start = 0, None
        for _, less, a, b in through:
            before, depth = depth, depth - less
            if not before:
                start = (a, b)
            if not depth and start is not None:
                found.append(trapezoid(left, right, start, (a, b)))
    return [each for each in found if each is not None]


def height(a: Point, b: Point, x: Any) -> Any:
    return a[1] + (x - a[0]) * (b[1] - a[1]) / Fraction(b[0] - a[0])


def trapezoid(left: Any, right: Any, low: Any, high: Any) -> Any:
    corners = [
        (left, height(*low, left)), (right, height(*low, right)),
        (right, height(*high, right)), (left, height(*high, left)),
    ]  # fmt: skip
    ring = list(dict.fromkeys(corners))
    if len(ring) < 3 or all(turn(ring[0], ring[1], p) == 0 for p in ring):
        return None
    return {"outer": [[str(x), str(y)] for x, y in ring], "holes": []}


def main(way: str) -> None:
    hello: dict[str, Any] = {"name": way, "version": "1", "arithmetic": "exact", "sum": "none"}
    hello["capabilities"] = ALL
    if way == "doubles":
        hello |= {"arithmetic": "float64", "numbers": "double"}
        hello["tolerance"] = {"relative": "1e-12"}
        hello["capabilities"] = [word for word in ALL if word != "rational"]
    for line in sys.stdin:
        request = json.loads(line)
        answer: dict[str, Any] = {"seq": request["seq"], "status": "result"}
        if request["verb"] == "hello":
            answer |= {"protocol": "adapter-v1", **hello}
        elif request["verb"] == "union":
            if way == "rejects":
                answer |= {"status": "rejected", "reason": "sets overlap"}
            else:
                answer |= united(way, request["sets"])
        elif request["verb"] != "stop":
            answer |= {"status": "skipped", "reason": "no such verb"}
        print(json.dumps(answer), flush=True)


if __name__ == "__main__":
    main(sys.argv[1])
