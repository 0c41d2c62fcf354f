"""Valid shapes on whole numbers from any plan: inserts vertices into a triangle one by one, each at
a place that keeps the set valid, or leaves the vertex out. The reference's validation decides."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator, Sequence
from dataclasses import dataclass
from itertools import compress

from minkref.fuzz.geometry.plane import Point, Polygon, Ring, Shape, box, extent, moved
from minkref.fuzz.plane.families.drawing import is_valid, shape_text
from minkref.strategies.values import points_of

Corner = tuple[int, int, int]  # x, y, and the edge where the search for a place begins
Hole = tuple[bool, Sequence[Corner]]  # whether open, then corners
SIMPLEST: Ring = [(0, 0), (1, 0), (0, 1)]


@dataclass(frozen=True)
class Part:
    """The plan of a polygon. A triangle, or a box, encloses holes at a distance `margin`, in place
    of the first three corners; `bare` finally drops the enclosure's vertices that can be spared.
    The polygon lies beside earlier parts, `gap` away, or `around` them.

    A hole that is not open, or a part that is not kept, is removed at the very end: its
    surroundings stay, so that Hypothesis can try without the hole or part."""

    corners: Sequence[Corner]
    holes: Sequence[Hole] = ()
    kept: bool = True
    boxed: bool = False
    bare: bool = False
    around: bool = False
    margin: int = 1
    gap: int = 1


def grown(parts: Iterable[Part], limit: int, most: int) -> Shape:
    """Grow a plan's shape, with all numbers within [-limit, limit], and up to `most` vertices per
    ring. Drops parts, holes and vertices without room. O(n^2) validations for n corners."""

    def fits(shape: Shape) -> bool:
        if any(len(ring) > most for polygon in shape for ring in polygon):
            return False
        inside = all(-limit <= c <= limit for point in points_of(shape) for c in point)
        return inside and is_valid(shape_text(shape))

    made: Shape = []
    kept: list[bool] = []
    for part in parts:
        if made and part.around:
            made = _around(made, part, fits)
        else:
            made = _beside(made, _polygon(part, fits), part.gap, fits)
        kept += [part.kept] * (len(made) - len(kept))
    return list(compress(made, kept)) or made[:1]


Fits = Callable[[Shape], bool]


def _polygon(part: Part, fits: Fits) -> Polygon:
    holes: Shape = []
    is_open: list[bool] = []
    for opens, corners in part.holes:
        holes = _beside(holes, [_ring(corners, fits)], part.gap, fits)
        is_open += [opens] * (len(holes) - len(is_open))
    while holes:
        rings = [ring for (ring,) in holes]
        for frame in _frames(rings, part):
            if fits([[frame, *rings]]):
                outer = _outer(frame, part, lambda ring: fits([[ring, *rings]]))  # noqa: B023
                return [outer, *compress(rings, is_open)]
        holes.pop()
    return [_ring(part.corners, fits)]


def _around(islands: Shape, part: Part, fits: Fits) -> Shape:
    """Add a polygon around the islands, with the islands inside its hole."""
    for hole in _frames([polygon[0] for polygon in islands], part):
        for frame in _frames([hole], part):
            if fits([*islands, [frame, hole]]):
                outer = _outer(frame, part, lambda ring: fits([*islands, [ring, hole]]))  # noqa: B023
                return [*islands, [outer, hole]]
    return islands


def _beside(shape: Shape, polygon: Polygon, gap: int, fits: Fits) -> Shape:
    """Add the polygon at its own place, else to the right of the rest, above, to the left,
    below."""
    if not shape:
        return [polygon]
    x, y, width, height = extent(points_of(shape))
    left, low, wide, high = extent(polygon[0])
    shifts: list[Point] = [(0, 0)]
    for apart in dict.fromkeys((gap, 1)):
        shifts += [(x + width + apart - left, 0), (0, y + height + apart - low)]
        shifts += [(x - apart - left - wide, 0), (0, y - apart - low - high)]
    for shift in shifts:
        longer = [*shape, *moved([polygon], *shift)]
        if fits(longer):
            return longer
    return shape


def _frames(inside: Sequence[Ring], part: Part) -> Iterator[Ring]:
    """Yield triangles and boxes around rings."""
    points = [point for ring in inside for point in ring]
    x, y, width, height = extent(points)
    for margin in dict.fromkeys((part.margin, 1)):
        if not part.boxed:
            a, b = x - margin, y - margin
            leg = max(p[0] + p[1] for p in points) - a - b + margin
            yield [(a, b), (a + leg, b), (a, b + leg)]
        yield box(x - margin, y - margin, width + 2 * margin, height + 2 * margin)


def _outer(frame: Ring, part: Part, fits: Callable[[Ring], bool]) -> Ring:
    ring = _inserted(frame, part.corners[3:], fits)
    for point in frame if part.bare else ():
        shorter = [p for p in ring if p != point]
        if len(shorter) >= 3 and fits(shorter):
            ring = shorter
    return ring


def _ring(corners: Sequence[Corner], fits: Fits) -> Ring:
    """Grow a simple ring."""
    base, rest = _triangle(corners)
    return _inserted(base, rest, lambda ring: fits([[ring]]))


def _triangle(corners: Sequence[Corner]) -> tuple[Ring, Sequence[Corner]]:
    """Return the first corners not on one line, and the others; a fixed triangle if all are
    collinear."""
    ends: list[Point] = []
    for k, (x, y, _) in enumerate(corners):
        if len(ends) == 2:
            (a, b), (c, d) = ends
            if (c - a) * (y - b) != (d - b) * (x - a):
                return [*ends, (x, y)], corners[k + 1 :]
        elif (x, y) not in ends:
            ends.append((x, y))
    return SIMPLEST, corners


def _inserted(ring: Ring, corners: Iterable[Corner], fits: Callable[[Ring], bool]) -> Ring:
    for x, y, first in corners:
        for k in range(len(ring)):
            place = (first + k) % len(ring) + 1
            longer = [*ring[:place], (x, y), *ring[place:]]
            if fits(longer):
                ring = longer
                break
    return ring
