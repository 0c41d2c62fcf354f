"""The outer Voronoi diagram of a polygon set, by CGAL's segment Delaunay graph and by
Boost.Polygon: its vertices, with their features named as curves of docs/disc.md are."""

from __future__ import annotations

import math
from bisect import bisect_left
from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass
from fractions import Fraction
from functools import cached_property
from itertools import pairwise
from pathlib import Path
from typing import Any, Self

from minkref.fuzz.cgal.executables import BUILD_COMMAND, built_folders, search_folders
from minkref.fuzz.judges.line_process import LineProcess

CGAL, BOOST = "CGAL", "Boost"
_PROGRAMS = {CGAL: "minkref-cgal-diagram", BOOST: "minkref-boost-diagram"}
_BUILD = {CGAL: BUILD_COMMAND, BOOST: BUILD_COMMAND.replace("minkref_cgal", _PROGRAMS[BOOST])}
ROUNDED = 64 * 2.0**-53  # of a coordinate, by Boost
LARGEST = 2**31 - 1  # of Boost's coordinates

Point = tuple[Fraction, Fraction]
# ("vertex", x, y), or ("line", dx, dy, c): the points with dy x - dx y = c, (dx, dy) primitive.
Feature = tuple[Any, ...]
Rings = Sequence[Sequence[tuple[Any, Any]]]


@dataclass(frozen=True)
class Piece:
    """An edge, or a part of one between points at which other rings touch it."""

    start: Point
    end: Point
    line: Feature

    @property
    def along(self) -> Point:
        return self.end[0] - self.start[0], self.end[1] - self.start[1]


class Outline:
    """The boundary of a polygon set, which lies to the left of its edges, moved so that `origin`,
    the lower left corner of its box, comes to (0, 0). Exact."""

    def __init__(self, rings: Rings) -> None:
        given = [[(Fraction(x), Fraction(y)) for x, y in ring] for ring in rings]
        x, y = (min(corner[k] for ring in given for corner in ring) for k in (0, 1))
        self.origin = x, y
        self.rings = [[(a - x, b - y) for a, b in ring] for ring in given]
        corners = [corner for ring in self.rings for corner in ring]
        self.size = float(max(max(corner) for corner in corners))
        self.factor = math.lcm(*(c.denominator for corner in corners for c in corner))
        self.pieces = list(self._pieces())

    @classmethod
    def of(cls, P: Any) -> Self:
        """Of a set of the extension module."""
        return cls([ring for polygon in P.rings() for ring in polygon])

    def _pieces(self) -> Iterator[Piece]:
        corners = sorted({corner for ring in self.rings for corner in ring})
        for ring in self.rings:
            for start, end in zip(ring, [*ring[1:], ring[0]], strict=True):
                line = line_through(start, end)
                stops = [start, *_between(corners, start, end), end]
                for a, b in pairwise(stops):
                    yield Piece(a, b, line)

    def vertex(self, x: str, y: str) -> Feature:
        """By its coordinates where it was given."""
        return ("vertex", Fraction(x) - self.origin[0], Fraction(y) - self.origin[1])

    def spot(self, x: float, y: float) -> tuple[float, float]:
        """A place, moved as the set is."""
        return float(Fraction(x) - self.origin[0]), float(Fraction(y) - self.origin[1])

    def edge(self, ring: int, index: int) -> Feature:
        """The line of an edge, by the number of its ring and of its first vertex."""
        corners = self.rings[ring]
        return line_through(corners[index], corners[(index + 1) % len(corners)])

    @cached_property
    def straight(self) -> dict[Feature, list[Feature]]:
        """Lines that go on straight at a vertex."""
        arriving: dict[Point, set[Feature]] = {}
        for piece in self.pieces:
            arriving.setdefault(piece.end, set()).add(piece.line)
        found: dict[Feature, list[Feature]] = {}
        for piece in self.pieces:
            if piece.line in arriving.get(piece.start, set()):
                found.setdefault(("vertex", *piece.start), []).append(piece.line)
        return found

    def integers(self) -> list[list[int]]:
        """The pieces, multiplied by `factor`."""
        return [[int(c * self.factor) for c in (*piece.start, *piece.end)] for piece in self.pieces]

    def is_outside(self, x: float, y: float) -> bool:
        """By the edges to the right. In doubles: for places that are off the boundary."""
        inside = False
        for ax, ay, bx, by in self._bands.get(math.floor(y / self._band), ()):
            if (ay > y) != (by > y) and ax + (y - ay) / (by - ay) * (bx - ax) > x:
                inside = not inside
        return not inside

    @cached_property
    def _band(self) -> float:
        return (self.size or 1.0) / max(1, len(self.pieces) // 4)

    @cached_property
    def _bands(self) -> dict[int, list[tuple[float, float, float, float]]]:
        found: dict[int, list[tuple[float, float, float, float]]] = {}
        for piece in self.pieces:
            (ax, ay), (bx, by) = map(float, piece.start), map(float, piece.end)
            low, high = sorted((ay, by))
            for band in range(math.floor(low / self._band), math.floor(high / self._band) + 1):
                found.setdefault(band, []).append((ax, ay, bx, by))
        return found


def line_through(start: Point, end: Point) -> Feature:
    dx, dy = end[0] - start[0], end[1] - start[1]
    common = math.lcm(dx.denominator, dy.denominator)
    x, y = int(dx * common), int(dy * common)
    divisor = math.gcd(x, y)
    x, y = x // divisor, y // divisor
    return ("line", x, y, y * start[0] - x * start[1])


def _between(corners: list[Point], start: Point, end: Point) -> list[Point]:
    """Those on the open segment from start to end, in order."""
    along = end[0] - start[0], end[1] - start[1]
    square = along[0] ** 2 + along[1] ** 2
    low, high = min(start[0], end[0]), max(start[0], end[0])
    bottom, top = min(start[1], end[1]), max(start[1], end[1])
    found = []
    for x, y in corners[bisect_left(corners, low, key=lambda corner: corner[0]) :]:
        if x > high:
            break
        if not bottom <= y <= top:
            continue
        way = x - start[0], y - start[1]
        far = along[0] * way[0] + along[1] * way[1]
        if along[0] * way[1] == along[1] * way[0] and 0 < far < square:
            found.append((far, (x, y)))
    return [corner for _, corner in sorted(found)]


@dataclass(frozen=True)
class Vertex:
    """Off the boundary and outside of the set. `features` are three or more, straight vertices of
    the set replaced by the lines through them."""

    x: float
    y: float
    radius: float
    features: frozenset[Feature]


@dataclass(frozen=True)
class DiagramAnswer:
    """`vertices` is None where there is no answer, and `why` says what became of it. `straight`
    counts vertices that a straight vertex of the set makes; `seconds` are those of the library's
    functions alone."""

    vertices: list[Vertex] | None
    straight: int = 0
    seconds: float = 0.0
    why: str = ""


def executable(judge: str) -> Path | None:
    folders = search_folders() if judge == CGAL else built_folders("boost")
    paths = (folder / _PROGRAMS[judge] for folder in folders)
    return next((path for path in paths if path.is_file()), None)


def absence(judge: str) -> str | None:
    """What is missing, and the command that gets it."""
    return None if executable(judge) else f"{_PROGRAMS[judge]} is not built: {_BUILD[judge]}"


class DiagramJudge:
    """CGAL or Boost, in a child process for many sets. Close it, or use it in a `with`. CGAL's
    places are doubles next to exact ones; Boost's are doubles, within 64 units in the last place,
    and its coordinates are integers of 32 bits."""

    def __init__(self, judge: str, seconds: float) -> None:
        path = executable(judge)
        self.judge = judge
        self._process = None if path is None else LineProcess(path, seconds)

    def __enter__(self) -> Self:
        return self

    def __exit__(self, *_: object) -> None:
        self.close()

    def close(self) -> None:
        if self._process is not None:
            self._process.close()

    def vertices(self, outline: Outline) -> DiagramAnswer:
        if self._process is None:
            return DiagramAnswer(None, why=str(absence(self.judge)))
        segments = outline.integers()
        if self.judge == BOOST and max(map(max, segments)) > LARGEST:
            return DiagramAnswer(None, why="coordinates have more than 32 bits")
        sent: Any = segments
        if self.judge == CGAL:
            sent = [[str(c) for c in segment] for segment in segments]
        answer = self._process.ask({"segments": sent})
        if "error" in answer:
            return DiagramAnswer(None, why=str(answer["error"]))
        return _outer(outline, self.judge, answer)


def _outer(outline: Outline, judge: str, answer: dict[str, Any]) -> DiagramAnswer:
    feature = _by_number(outline) if judge == BOOST else _by_coordinates(outline)
    ends = {(a, b) for x, y, u, v in outline.integers() for a, b in ((x, y), (u, v))}
    found, straight = [], 0
    for each in answer["vertices"]:
        x, y = (float(c) / outline.factor for c in each["at"])
        features = {feature(site) for site in each["sites"]}
        far = distance((x, y), next(iter(features)))
        if judge == CGAL:
            far = math.sqrt(each["squared_radius"]) / outline.factor
        elif _is_at_end(each["at"], ends):
            continue
        if not outline.is_outside(x, y):
            continue
        kept = _without_straight(outline, features, (x, y))
        if len(kept) < 3:
            straight += 1
            continue
        found.append(Vertex(x, y, far, kept))
    return DiagramAnswer(found, straight, float(answer["seconds"]))


def _by_number(outline: Outline) -> Callable[[Sequence[int]], Feature]:
    """A site of Boost's: an open segment, or one of its ends."""

    def feature(site: Sequence[int]) -> Feature:
        piece = outline.pieces[site[0]]
        if len(site) == 1:
            return piece.line
        return ("vertex", *(piece.end if site[1] else piece.start))

    return feature


def _by_coordinates(outline: Outline) -> Callable[[Sequence[str]], Feature]:
    """A site of CGAL's: a point, or an open segment, either way round."""
    lines: dict[tuple[str, ...], Feature] = {}
    for piece, (a, b, c, d) in zip(outline.pieces, outline.integers(), strict=True):
        for ends in ((a, b, c, d), (c, d, a, b)):
            lines[tuple(map(str, ends))] = piece.line

    def feature(site: Sequence[str]) -> Feature:
        if len(site) == 4:
            return lines[tuple(site)]
        return ("vertex", *(Fraction(c) / outline.factor for c in site))

    return feature


def _is_at_end(at: Sequence[float], ends: set[tuple[int, int]]) -> bool:
    """Whether a vertex of Boost's lies at an end of segments, whose distance is zero."""
    end = round(at[0]), round(at[1])
    return end in ends and math.dist(at, end) <= ROUNDED * max(1, *end)


def _without_straight(
    outline: Outline, features: set[Feature], spot: tuple[float, float]
) -> frozenset[Feature]:
    """A vertex of the set at which a line goes on straight is nothing of its own for places in
    front of that line: these are in front of the vertex."""
    kept = set()
    for feature in features:
        lines = [line for line in outline.straight.get(feature, []) if height(spot, line) > 0]
        kept |= set(lines) or {feature}
    return frozenset(kept)


def height(spot: tuple[float, float], line: Feature) -> float:
    """Over a line, the set being below. In doubles."""
    _, dx, dy, c = line
    return float(dy * spot[0] - dx * spot[1] - float(c)) / math.hypot(dx, dy)


def distance(spot: tuple[float, float], feature: Feature) -> float:
    """From a vertex or a line. In doubles."""
    if feature[0] == "line":
        return abs(height(spot, feature))
    return math.hypot(spot[0] - float(feature[1]), spot[1] - float(feature[2]))
