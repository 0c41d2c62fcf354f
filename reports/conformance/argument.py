"""Why a witness proves its claim: sentences to check with paper and pencil."""

from __future__ import annotations

from collections.abc import Sequence
from fractions import Fraction

from minkref.exact import scientific
from minkref.fuzz.geometry.plane import Point, Shape, contains, in_box, read_shape, turn
from minkref.fuzz.verdicts.verdict import Witness

ORIGIN = (Fraction(0), Fraction(0))
MOST_PAIRS = 4  # polygon pairs, each with its own sentence
MOST_VERTICES = 24  # a written-out set's vertices

Numbers = Sequence[str] | Sequence[Fraction | int]


def point_text(point: Numbers) -> str:
    return f"({', '.join(str(number) for number in point)})"


def argument_in_plane(P: str, Q: str, scale: str, witness: Witness) -> list[str]:
    """Sentences about a witness in the plane."""
    at = witness.scale or scale
    if witness.in_truth and witness.p and witness.q:
        own, other = (read_shape(text, Fraction(1), ORIGIN) for text in (P, Q))
        places = (_place("P", own, witness.p), _place("Q", other, witness.q))
        return [*inside(witness, at, places), *around(witness)]
    x = (Fraction(witness.point[0]), Fraction(witness.point[1]))
    first, second = read_shape(P, Fraction(at), ORIGIN), read_shape(Q, Fraction(-1), x)
    if witness.boundary:
        apart = ["No edge of sP meets an edge of x - Q, so no p and q on the boundaries give x."]
    else:
        apart = _apart(first, second)
    return [*outside(witness, at), *_written(first, second), *apart, *around(witness)]


def inside(witness: Witness, at: str, places: tuple[str, str]) -> list[str]:
    """p and q, and their sum number by number."""
    assert witness.p is not None and witness.q is not None
    factors = at.split(",") if "," in at else [at] * len(witness.p)
    sums = [
        f"{factor} * {_signed(p)} + {_signed(q)} = {x}"
        for factor, p, q, x in zip(factors, witness.p, witness.q, witness.point, strict=True)
    ]
    names = "xyz"
    return [
        f"p = {point_text(witness.p)} {places[0]}; q = {point_text(witness.q)} {places[1]}.",
        "s p + q = x: " + "; ".join(f"{n}: {line}" for n, line in zip(names, sums, strict=False)),
        "So x lies in "
        + ("the sum of the boundaries" if witness.boundary else "the sum")
        + ", by its definition.",
    ]


def outside(witness: Witness, at: str) -> list[str]:
    what = "the boundaries of sP and of" if witness.boundary else "sP and"
    return [
        f"x = {point_text(witness.point)} is s p + q with p in P and q in Q only where {what} "
        f"x - Q (all points x - q) have a point in common, here with s = {at}."
    ]


def around(witness: Witness) -> list[str]:
    if witness.tolerance == "0":
        return []
    side = "inside" if witness.in_truth else "outside of"
    what = "square" if len(witness.point) == 2 else "cube"
    return [
        f"The same holds for every point that differs from x by at most {witness.tolerance} (about "
        f"{scientific(witness.tolerance)}, the declared tolerance) in each coordinate: "
        f"this whole {what} lies {side} the sum, so that rounding does not explain the result."
    ]


def _signed(number: str) -> str:
    return f"({number})" if number.startswith("-") else number


def _place(name: str, polygons: Shape, numbers: tuple[str, ...]) -> str:
    point = (Fraction(numbers[0]), Fraction(numbers[1]))
    rings = [ring for polygon in polygons for ring in polygon]
    if any(point in ring for ring in rings):
        return f"is a vertex of {name}"
    for ring in rings:
        for a, b in zip(ring, ring[1:] + ring[:1], strict=True):
            if turn(a, b, point) == 0 and in_box(a, b, point):
                return f"lies on the edge of {name} from {point_text(a)} to {point_text(b)}"
    return f"lies inside {name}"


def _written(first: Shape, second: Shape) -> list[str]:
    texts = []
    for name, polygons in (("sP", first), ("x - Q", second)):
        if sum(len(ring) for polygon in polygons for ring in polygon) > MOST_VERTICES:
            return []
        texts.append(f"{name} is {set_text(polygons)}")
    return ["; ".join(texts) + "."]


def set_text(polygons: Shape) -> str:
    """`the polygon (0, 0) (1, 0) (0, 1), less the hole ...`."""
    return " and ".join(
        "the polygon "
        + ", less the hole ".join(" ".join(point_text(p) for p in ring) for ring in polygon)
        for polygon in polygons
    )


def _apart(first: Shape, second: Shape) -> list[str]:
    """Says how each polygon of one set misses each polygon of the other."""
    pairs = [(a, b) for a in first for b in second]
    several = len(pairs) > 1
    found = []
    for a, b in pairs[:MOST_PAIRS]:
        how = _how_apart(a, b)
        if several:
            how = f"{how} (polygons that begin at {point_text(a[0][0])} and {point_text(b[0][0])})"
        found.append(f"They do not meet: {how}.")
    if len(pairs) > MOST_PAIRS:
        found.append(f"So do the other {len(pairs) - MOST_PAIRS:,} pairs of polygons.")
    return [*found, "So x is not in the sum."]


def _how_apart(a: list[list[Point]], b: list[list[Point]]) -> str:
    for outer, other in ((a[0], b[0]), (b[0], a[0])):
        for u, v in zip(outer, outer[1:] + outer[:1], strict=True):
            sides = {turn(u, v, p) for p in outer} | {0}
            others = {turn(u, v, p) for p in other}
            if u != v and len(sides) < 3 and others in ({1}, {-1}) and not others & sides:
                line = f"the line through {point_text(u)} and {point_text(v)}"
                return f"{line} has one on one side or on it, and the other strictly on the other"
    for inner, outer_polygon, names in ((b, a, ("x - Q", "sP")), (a, b, ("sP", "x - Q"))):
        for hole in outer_polygon[1:]:
            if contains([[hole]], inner[0][0]):
                ring = " ".join(point_text(p) for p in hole[:MOST_VERTICES])
                return f"{names[0]} lies strictly inside the hole {ring} of {names[1]}"
    return "no edge of one meets an edge of the other, and neither holds a vertex of the other"
