"""A ball about the origin as an operand: `ball:R`, `ball:sqrt:N`; and polyhedra near to it."""

from __future__ import annotations

import math
from collections.abc import Iterator
from fractions import Fraction
from itertools import pairwise

from minkref import _core
from minkref.disc.disc import Disc, read_squared_radius
from minkref.errors import Refusal
from minkref.exact import power_of_ten_below

PREFIX = "ball:"
MEND = "give a positive number, as ball:7/5, ball:0.25 or ball:sqrt:2"
MOST_FACETS = 20_000
FINER = 3  # times that the vertices are rounded to ten times as many digits
FEWEST = 4  # facets for each part of the radius that the tolerance is; about 5 are needed
ROUNDING = 64  # of the tolerance: at most one such part moves a vertex along an axis
Corner = tuple[float, float, float]
Point = tuple[Fraction, Fraction, Fraction]

_GOLDEN = (1 + math.sqrt(5)) / 2
_OCTAHEDRON: list[Corner] = [(1, 0, 0), (0, 1, 0), (0, 0, 1), (-1, 0, 0), (0, -1, 0), (0, 0, -1)]
_ICOSAHEDRON: list[Corner] = [
    point
    for a in (-1, 1)
    for b in (-_GOLDEN, _GOLDEN)
    for point in ((0, a, b), (a, b, 0), (b, 0, a))
]


def is_ball(name: str) -> bool:
    return name.startswith(PREFIX)


def read_ball(name: str) -> Disc:
    """Read a ball. Refuses anything but a positive finite number after the prefix."""
    return Disc(name, read_squared_radius(name, PREFIX, MEND))


def polyhedron_near(ball: Disc, within: Fraction, outside: bool) -> _core.ConvexPolyhedron:
    """Make a convex polyhedron inside the ball, every point of the ball at most `within` away; or
    around the ball, with every point at most `within` away from the ball. Vertices are finite
    decimals. Proof: docs/space-sums.md, "With a ball". Takes the smallest octahedron or
    icosahedron, with facets cut into n² triangles, that fits. About 5 R / `within` facets. Refuses
    more than MOST_FACETS."""
    bounds = ball.bounds(80)
    step = power_of_ten_below(min(within, bounds[1]) / ROUNDING)
    ratio = float(min(within / bounds[1], Fraction(1)))
    for directions, faces in _subdivided(int(FEWEST / ratio)):
        if not _may_fit(directions, faces, ratio, outside):
            continue
        for finer in range(FINER):
            found = _fitted(directions, faces, bounds, within, outside, step / 10**finer)
            if found is not None:
                return found
    raise Refusal(
        f"a polyhedron as near to the ball as {float(within):g} has more than {MOST_FACETS:,} "
        "facets",
        "--tolerance",
        "give a larger one",
        "too-many-facets",
    )


def is_near(
    points: list[Point],
    faces: list[list[int]],
    bounds: tuple[Fraction, Fraction],
    within: Fraction,
    outside: bool,
) -> bool:
    """Check the distances of the vertices, and of the planes of the triangles, which turn away from
    the origin: together they prove what polyhedron_near promises of a convex polyhedron. `bounds`:
    two numbers around the radius. Exact."""
    low, high = bounds
    nearest, farthest = (high, low + within) if outside else (max(high - within, Fraction(0)), low)
    if any(sum(x * x for x in point) > farthest**2 for point in points):
        return False
    for a, b, c in faces:
        normal = _cross(_less(points[b], points[a]), _less(points[c], points[a]))
        offset = _dot(normal, points[a])
        if offset <= 0 or offset**2 < nearest**2 * _dot(normal, normal):
            return False
    return True


def _fitted(
    directions: list[Corner],
    faces: list[list[int]],
    bounds: tuple[Fraction, Fraction],
    within: Fraction,
    outside: bool,
    step: Fraction,
) -> _core.ConvexPolyhedron | None:
    """Place vertices in the directions, at multiples of a step, and prove them; None if there is no
    proof."""
    low, _ = bounds
    radius = low + within - 2 * step if outside else low - 2 * step
    if radius <= 0:
        return None
    points: list[Point] = [
        (
            step * round(radius * Fraction(x) / step),
            step * round(radius * Fraction(y) / step),
            step * round(radius * Fraction(z) / step),
        )
        for x, y, z in directions
    ]
    if not is_near(points, faces, bounds, within, outside):
        return None
    try:
        surface = _core.Polyhedron([tuple(map(str, point)) for point in points], faces)
        return _core.ConvexPolyhedron(surface, "")
    except _core.BadInput:
        return None


def _may_fit(directions: list[Corner], faces: list[list[int]], ratio: float, outside: bool) -> bool:
    """Tell whether facets between points on the unit sphere are near enough to fit without
    rounding."""
    least = min(_distance(*(directions[k] for k in face)) for face in faces)
    return least * (1 + ratio) > 1 if outside else least > 1 - ratio


def _distance(a: Corner, b: Corner, c: Corner) -> float:
    u, v = (tuple(q - p for p, q in zip(a, other, strict=True)) for other in (b, c))
    normal = (u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0])
    return sum(n * x for n, x in zip(normal, a, strict=True)) / math.hypot(*normal)


def _subdivided(least: int) -> Iterator[tuple[list[Corner], list[list[int]]]]:
    """Yield points on the unit sphere and triangles, `least` or more, by the number of
    triangles."""
    solids: list[tuple[int, list[Corner]]] = [(8, _OCTAHEDRON), (20, _ICOSAHEDRON)]
    sizes = sorted(
        (count * n * n, n, corners)
        for count, corners in solids
        for n in range(1, math.isqrt(MOST_FACETS // count) + 1)
        if count * n * n >= least
    )
    for _, n, corners in sizes:
        yield _cut([_unit(corner) for corner in corners], n)


def _cut(corners: list[Corner], n: int) -> tuple[list[Corner], list[list[int]]]:
    """Cut each face into n² triangles, about equal on the sphere, seen from outside
    counter-clockwise."""
    numbers: dict[tuple[tuple[int, int], ...], int] = {}
    points: list[Corner] = []
    angle = math.acos(max(sum(p * q for p, q in zip(corners[0], other, strict=True))
                          for other in corners[1:]))  # fmt: skip

    def number(face: tuple[int, ...], weights: tuple[int, ...]) -> int:
        key = tuple((k, w) for k, w in sorted(zip(face, weights, strict=True)) if w)
        if key not in numbers:
            numbers[key] = len(points)
            parts = [math.sin(angle * w / n) for w in weights]
            points.append(
                _unit([sum(w * corners[k][i] for k, w in zip(face, parts, strict=True))
                       for i in range(3)])
            )  # fmt: skip
        return numbers[key]

    faces = []
    for face in _triangles(corners, angle):
        for i in range(n):
            for j in range(n - i):
                k = n - i - j
                a, b, c = ((i + 1, j, k - 1), (i, j + 1, k - 1), (i, j, k))
                faces.append([number(face, w) for w in (a, b, c)])
                if k > 1:
                    d = (i + 1, j + 1, k - 2)
                    faces.append([number(face, w) for w in (b, a, d)])
    return points, faces


def _triangles(corners: list[Corner], angle: float) -> list[tuple[int, int, int]]:
    """The faces of a regular solid of triangles, by corners that are nearest to each other."""
    near = math.cos(angle) - 1e-6
    count = range(len(corners))
    found = []
    for a in count:
        for b in count[a + 1 :]:
            for c in count[b + 1 :]:
                sides = [(corners[p], corners[q]) for p, q in pairwise((a, b, c, a))]
                if all(sum(map(math.prod, zip(*side, strict=True))) > near for side in sides):
                    turned = _distance(corners[a], corners[b], corners[c]) < 0
                    found.append((a, c, b) if turned else (a, b, c))
    return found


def _unit(point: list[float] | Corner) -> Corner:
    x, y, z = point
    size = math.hypot(x, y, z)
    return x / size, y / size, z / size


def _less(a: Point, b: Point) -> Point:
    return a[0] - b[0], a[1] - b[1], a[2] - b[2]


def _cross(a: Point, b: Point) -> Point:
    return (a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0])


def _dot(a: Point, b: Point) -> Fraction:
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
