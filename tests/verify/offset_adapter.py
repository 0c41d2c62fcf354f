"""An adapter that grows sets by a disc, in a way that the argument names.

polygon        the exact sum with a polygon of 48 corners inside the disc
pieces         the union of the set, a box before each edge, a polygon about each vertex
doubles        as polygon, takes doubles only and sends them, rounded
curves         by the reference, rings begun elsewhere and in another order

All others have one fault each: FAULTS.
"""

from __future__ import annotations

import json
import math
import sys
from collections.abc import Callable
from fractions import Fraction
from typing import Any

import minkref
from minkref import _core
from minkref.fuzz.geometry.plane import Point, Shape, box, edges, extent, hull

Region = minkref.PolygonSet
CORNERS = 48
ALL = "plane non-convex holes components touching empty point segment rational offset".split()


def disc(radius: Fraction, corners: int = CORNERS, turned: bool = False) -> Region:
    """Corners on the circle or, as doubles go, next to it."""
    shift = 0.5 if turned else 0.0
    angles = [math.tau * (k + shift) / corners for k in range(corners)]
    ring = [(radius * Fraction(math.cos(a)), radius * Fraction(math.sin(a))) for a in angles]
    return Region(ring)


def read(value: Any) -> Region:
    return Region.from_json(json.dumps(texts(value)))


def texts(value: Any) -> Any:
    if isinstance(value, dict):
        return {key: texts(one) for key, one in value.items()}
    return [texts(one) for one in value] if isinstance(value, list) else str(Fraction(value))


def doubles(value: Any) -> Any:
    if isinstance(value, dict):
        return {key: doubles(one) for key, one in value.items()}
    return [doubles(one) for one in value] if isinstance(value, list) else float(Fraction(value))


def grown(P: Region, radius: Fraction, corners: int = CORNERS) -> Region:
    if P.is_empty:
        return P
    return _core.minkowski_sum(P, disc(radius, corners), "1").region


def shape(P: Region) -> Shape:
    found: Shape = P.rings()
    return found


def place(region: Region, at: Point) -> Region:
    return region.translated(str(at[0]), str(at[1]))


def strips(P: Region, radius: Fraction, skip: int = -1) -> list[Region]:
    """A box before each edge, outwards."""
    found = []
    for k, (a, b) in enumerate(edges(shape(P))):
        length = math.hypot(float(b[0] - a[0]), float(b[1] - a[1]))
        if k == skip or not length:
            continue
        out = Fraction(1 / length) * radius
        n = (out * (b[1] - a[1]), -out * (b[0] - a[0]))
        found.append(Region([(a[0] + n[0], a[1] + n[1]), (b[0] + n[0], b[1] + n[1]), b, a]))
    return found


def pieces(
    P: Region, radius: Fraction, cap: Region | None, skip: int = -1, without: bool = False
) -> Region:
    """`cap` about each vertex; `without` the set itself."""
    ends = [p for polygon in shape(P) for ring in polygon for p in ring]
    caps = [] if cap is None else [place(cap, p) for p in ends]
    return minkref.unite(
        [*([] if without or not P.is_region else [P]), *strips(P, radius, skip), *caps]
    )


def without_holes(P: Region) -> Region:
    if not P.is_region:
        return P
    return minkref.unite([Region(polygon[0]) for polygon in shape(P)])


def holes_of(P: Region) -> Region:
    return minkref.subtract(without_holes(P), [P]) if P.is_region else P


def first(P: Region, count: int) -> Region:
    """Some polygons of the set."""
    kept = shape(P)[:count]
    return Region(kept) if kept else minkref.unite([])


def all_but_one(P: Region) -> Region:
    return first(P, max(len(shape(P)) - 1, 1))


def hull_of(P: Region) -> Region:
    return Region(hull([p for q in shape(P) for p in q[0]])) if P.is_region else P


def square(radius: Fraction) -> Region:
    return Region(box(-radius, -radius, 2 * radius, 2 * radius))


def other_holes(P: Region, radius: Fraction, factor: Fraction) -> Region:
    """The holes as at another radius."""
    outer = without_holes(grown(P, radius))
    return minkref.subtract(outer, [holes_of(grown(P, radius * factor))])


def cut(found: Region, high: Fraction, thick: Fraction) -> Region:
    """Without a strip across it."""
    if found.is_empty:
        return found
    x, y, w, h = extent([p for polygon in shape(found) for p in polygon[0]])
    return minkref.subtract(found, [Region(box(x - 1, y + high * h, w + 2, thick))])


def dent(P: Region, radius: Fraction) -> Region:
    """The arc about one vertex runs the wrong way round."""
    found = grown(P, radius)
    at = max(p for polygon in shape(P) for p in polygon[0])
    return minkref.subtract(found, [place(disc(radius * Fraction(4, 5)), (at[0] + radius, at[1]))])


def on_grid(found: Region, unit: Fraction) -> Region:
    rings = [
        [[(unit * round(x / unit), unit * round(y / unit)) for x, y in ring] for ring in polygon]
        for polygon in shape(found)
    ]
    region, *_ = _core.region_of_rings([p for p in rings if len(set(p[0])) > 2], True)
    return region


def spot(P: Region, radius: Fraction) -> Region:
    """With a small hole."""
    found = grown(P, radius)
    at = shape(P)[0][0][0]
    size = radius / 50
    return minkref.subtract(found, [Region(box(at[0], at[1], size, size))])


def boxed(P: Region, radius: Fraction) -> Region:
    x, y, w, h = extent([p for polygon in shape(P) for p in polygon[0]])
    return Region(box(x - radius, y - radius, w + 2 * radius, h + 2 * radius))


def eroded(P: Region, radius: Fraction) -> Region:
    band = pieces(P, radius, disc(radius), without=True)
    return minkref.subtract(P, [band]) if P.is_region else minkref.unite([])


def island(P: Region, radius: Fraction) -> Region:
    """With a component far away."""
    found = grown(P, radius)
    x, y, w, _ = extent([p for polygon in shape(found) for p in polygon[0]])
    return minkref.unite([found, Region(box(x + 2 * w, y, radius / 4, radius / 4))])


Way = Callable[[Region, Fraction], Region]
FAULTS: dict[str, Way] = {
    "bevel": lambda P, r: pieces(P, r, None),
    "miter": lambda P, r: pieces(P, r, square(r)),
    "lost-hole": lambda P, r: without_holes(grown(P, r)),
    "ignores-holes": lambda P, r: grown(without_holes(P), r),
    "lost-component": lambda P, r: all_but_one(grown(P, r)),
    "first-polygon": lambda P, r: grown(first(P, 1), r) if P.is_region else grown(P, r),
    "reversed-arc": dent,
    "late-event": lambda P, r: other_holes(P, r, Fraction(9, 10)),
    "early-event": lambda P, r: other_holes(P, r, Fraction(11, 10)),
    "coarse-grid": lambda P, r: on_grid(grown(P, r), r / 8),
    "wrong-sign": eroded,
    "no-caps": lambda P, r: grown(P, r) if P.is_region else pieces(P, r, None),
    "square-caps": lambda P, r: pieces(P, r, disc(r) if P.is_region else square(r)),
    "coarse-arcs": lambda P, r: grown(P, r, 7),
    "diameter": lambda P, r: grown(P, r / 2),
    "radius-plus": lambda P, r: grown(P, r * Fraction(101, 100)),
    "forgets-edge": lambda P, r: pieces(P, r, disc(r), skip=0),
    "band": lambda P, r: pieces(P, r, disc(r), without=True),
    "cracked": lambda P, r: cut(grown(P, r), Fraction(1, 2), r / 1000),
    "invents-hole": spot,
    "island": island,
    "moved": lambda P, r: place(grown(P, r), (r / 50, Fraction(0))),
    "hull": lambda P, r: grown(hull_of(P), r),
    "box": boxed,
}  # fmt: skip


def curves(P: Region, radius: Fraction) -> Any:
    value = json.loads(_core.offset(P, str(radius**2)).canonical_json())["components"]
    for component in value:
        component["outer"] = [*component["outer"][1:], component["outer"][0]]
        component["holes"].reverse()
    return {"components": value[::-1]}


def answer_to(way: str, request: dict[str, Any]) -> Any:
    P, radius = read(request["P"]), Fraction(request["radius"])
    if way == "curves":
        return curves(P, radius) if not P.is_empty else {"components": []}
    if P.is_empty:
        return {"polygons": []}
    if way in FAULTS:
        found = FAULTS[way](P, radius)
    else:
        found = pieces(P, radius, disc(radius)) if way == "pieces" else grown(P, radius)
    value = json.loads(minkref.write(found, "json"))
    return doubles(value) if way == "doubles" else value


def main(way: str) -> None:
    hello: dict[str, Any] = {"name": way, "version": "1", "sum": "none", "capabilities": ALL}
    if way != "curves":
        hello |= {"arithmetic": "polygons", "tolerance": {"relative": "1e-12", "radius": "0.0022"}}
    if way == "doubles":
        hello |= {"arithmetic": "float64", "numbers": "double"}
        hello["capabilities"] = [word for word in ALL if word != "rational"]
    for line in sys.stdin:
        request = json.loads(line)
        answer: dict[str, Any] = {"seq": request["seq"], "status": "result"}
        if request["verb"] == "hello":
            answer |= {"protocol": "adapter-v1", **hello}
        elif request["verb"] == "offset":
            answer |= answer_to(way, request)
        elif request["verb"] != "stop":
            answer |= {"status": "skipped", "reason": "no such verb"}
        print(json.dumps(answer), flush=True)


if __name__ == "__main__":
    main(sys.argv[1])
