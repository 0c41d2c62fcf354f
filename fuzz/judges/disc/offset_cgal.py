"""CGAL's exact offset in the canonical form of a sum with a disc (docs/disc.md)."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass
from fractions import Fraction
from pathlib import Path
from typing import Any

from minkref.fuzz.cgal.executables import BUILD_COMMAND, search_folders
from minkref.fuzz.cgal.line_process import LineProcess

PROGRAM = "minkref-cgal-offset"
Curve = tuple[str, ...]
Piece = dict[str, Any]
Spot = tuple[float, float]
Ring = tuple[Curve, ...]
ALIKE = 1e-4  # closer angles are one
SAME = 1e-10  # times the set's size: closer places are one
NEAR = 1e-7  # times the set's size: most distance of a line from its edge


@dataclass(frozen=True)
class OffsetAnswer:
    """`components`: outer ring and holes, in canonical order; None without an answer, and then
    `why` gives the reason. `seconds` counts CGAL's functions only."""

    components: list[tuple[Ring, list[Ring]]] | None
    holes: int = 0
    paths: tuple[tuple[Spot, ...], ...] = ()  # some points on each original ring
    seconds: float | None = None
    why: str = ""


def executable() -> Path | None:
    paths = (folder / PROGRAM for folder in search_folders())
    return next((path for path in paths if path.is_file()), None)


def absence() -> str | None:
    """Names the missing program, and the command that builds it."""
    return None if executable() else f"{PROGRAM} is not built: {BUILD_COMMAND}"


class OffsetJudge:
    """A child process for many offsets, restarted after taking too long."""

    def __init__(self, seconds: float) -> None:
        path = executable()
        self._process = None if path is None else LineProcess(path, seconds)

    def __enter__(self) -> OffsetJudge:
        return self

    def __exit__(self, *_: object) -> None:
        self.close()

    def close(self) -> None:
        if self._process is not None:
            self._process.close()

    def offset(self, P: dict[str, Any], radius: Fraction) -> OffsetAnswer:
        """The exact offset of polygons in canonical JSON. CGAL's lines have no rational equation:
        the nearby edge of P, moved outwards, names a line."""
        if self._process is None:
            return OffsetAnswer(None, why=str(absence()))
        answer = self._process.ask({"P": P, "radius": str(radius)})
        if "error" in answer:
            return OffsetAnswer(None, why=str(answer["error"]))
        lines = _Lines(P, radius)
        pieces = [
            piece
            for each in answer["polygons"]
            for ring in (each["outer"], *each["holes"])
            for piece in ring
        ]
        rings = [part for walk in _walks(pieces, lines.same) for part in _split(walk, lines.same)]
        parts = [
            part
            for each in answer["polygons"]
            for ring in (each["outer"], *each["holes"])
            for part in _split(ring, lines.same)
        ]
        paths = tuple(tuple(spot for piece in part for spot in _path(piece)) for part in parts)
        holes = sum(_area(path) < 0 for path in paths)
        return OffsetAnswer(_components(rings, lines), holes, paths, answer["seconds"])

    def seconds_near(self, P: dict[str, Any], radius: Fraction, tolerance: float) -> float | None:
        """Seconds for CGAL's approximated offset; None if CGAL has no answer."""
        if self._process is None:
            return None
        ask = {"P": P, "radius": str(radius), "tolerance": tolerance}
        seconds: float | None = self._process.ask(ask).get("seconds")
        return seconds


class _Lines:
    """The edges of a set, moved outwards."""

    def __init__(self, P: dict[str, Any], radius: Fraction) -> None:
        self._radius = float(radius)
        self._lines: dict[Curve, tuple[float, float, float]] = {}
        size = 1.0
        for polygon in P["polygons"]:
            for ring in (polygon["outer"], *polygon["holes"]):
                points = [(Fraction(x), Fraction(y)) for x, y in ring]
                size = max(size, *(abs(float(c)) for point in points for c in point))
                for a, b in zip(points, [*points[1:], points[0]], strict=True):
                    self._add(a, b)
        self.near = NEAR * (size + self._radius)
        self.same = SAME * (size + self._radius)

    def _add(self, a: tuple[Fraction, ...], b: tuple[Fraction, ...]) -> None:
        dx, dy = b[0] - a[0], b[1] - a[1]
        common = math.lcm(dx.denominator, dy.denominator)
        divisor = math.gcd(int(dx * common), int(dy * common))
        dx, dy = dx * common / divisor, dy * common / divisor
        c = dy * a[0] - dx * a[1]
        length = math.hypot(dx, dy)
        name = ("line", str(dx), str(dy), str(c))
        self._lines[name] = (float(dx) / length, float(dy) / length, float(c) / length)

    def name(self, ends: Sequence[float]) -> Curve:
        x0, y0, x1, y1 = ends

        def off(line: tuple[float, float, float]) -> float:
            dx, dy, c = line
            if dx * (x1 - x0) + dy * (y1 - y0) <= 0:
                return math.inf
            return max(abs(dy * x - dx * y - c - self._radius) for x, y in ((x0, y0), (x1, y1)))

        found = min(self._lines, key=lambda name: off(self._lines[name]))
        if not off(self._lines[found]) < self.near:
            raise ValueError("no edge leads to the line of a piece")
        return found


def _walks(pieces: list[Piece], near: float) -> list[list[Piece]]:
    """CGAL's rings pass through points where components touch. Here each ring goes on with the
    piece that bounds the same wedge of the interior, on the left."""
    starts: dict[tuple[int, int], list[int]] = {}
    size = 10 * near
    for k, piece in enumerate(pieces):
        x, y = piece["ends"][:2]
        starts.setdefault((round(x / size), round(y / size)), []).append(k)

    def following(piece: Piece) -> int:
        x, y = piece["ends"][2:]
        i, j = round(x / size), round(y / size)
        around = [(i + a, j + b) for a in (-1, 0, 1) for b in (-1, 0, 1)]
        found = [
            k
            for cell in around
            for k in starts.get(cell, [])
            if math.dist(pieces[k]["ends"][:2], (x, y)) < near
        ]
        back = _direction(piece, 3) + math.pi

        def turn(k: int) -> float:
            angle = (back - _direction(pieces[k], 0)) % math.tau
            return angle if angle > ALIKE else math.tau

        return min(found, key=turn)

    walks, left = [], set(range(len(pieces)))
    while left:
        k = first = min(left)
        walk = []
        while k in left:
            left.remove(k)
            walk.append(pieces[k])
            k = following(pieces[k])
        if k != first:
            raise ValueError("a walk does not close up")
        walks.append(walk)
    return walks


def _direction(piece: Piece, end: int) -> float:
    """The angle at which a piece leaves (0) or arrives (3)."""
    x0, y0, x1, y1 = piece["ends"]
    if not piece["arc"]:
        return math.atan2(y1 - y0, x1 - x0)
    x, y = _centre(piece)
    at = (x0 - x, y0 - y) if end == 0 else (x1 - x, y1 - y)
    return math.atan2(at[0], -at[1])


def _centre(piece: Piece) -> Spot:
    r, _, _, u, v, _ = (Fraction(number) for number in piece["conic"])
    return float(-u / (2 * r)), float(-v / (2 * r))


def _split(ring: list[Piece], near: float) -> list[list[Piece]]:
    """Cuts a ring into the parts between two visits to one place."""
    rings, kept = [], list[Piece]()
    for piece in ring:
        kept.append(piece)
        x, y = piece["ends"][2:]
        for k, other in enumerate(kept):
            if math.dist((x, y), other["ends"][:2]) < near and k > 0:
                rings.append(kept[k:])
                del kept[k:]
                break
    return [*rings, kept] if kept else rings


def _components(rings: list[list[Piece]], lines: _Lines) -> list[tuple[Ring, list[Ring]]]:
    """Sorts rings by their turning direction; each hole belongs to the smallest ring around it."""
    paths = [[spot for piece in ring for spot in _path(piece)] for ring in rings]
    areas = [_area(path) for path in paths]
    holes: dict[int, list[Ring]] = {k: [] for k, area in enumerate(areas) if area > 0}
    for k, area in enumerate(areas):
        if area > 0:
            continue
        inside = paths[k][1]  # the middle of a piece
        around = [other for other in holes if is_in(inside, paths[other])]
        holes[min(around, key=areas.__getitem__)].append(_ring(rings[k], lines))
    found = [(_ring(rings[k], lines), sorted(of, key=_order)) for k, of in holes.items()]
    return sorted(found, key=lambda component: _order(component[0]))


def _order(ring: Ring) -> list[Any]:
    return [_key(curve) for curve in ring]


def _path(piece: Piece) -> list[Spot]:
    """Some points on a piece, without its end."""
    x0, y0, x1, y1 = piece["ends"]
    if not piece["arc"]:
        return [(x0, y0), ((x0 + x1) / 2, (y0 + y1) / 2)]
    return spots_of_arc((x0, y0), (x1, y1), _centre(piece))


def spots_of_arc(start: Spot, end: Spot, centre: Spot) -> list[Spot]:
    """Points on a counter-clockwise arc, without its end."""
    x, y = centre
    first = math.atan2(start[1] - y, start[0] - x)
    turn = (math.atan2(end[1] - y, end[0] - x) - first) % math.tau
    radius, steps = math.dist(start, centre), 16
    angles = [first + turn * k / steps for k in range(steps)]
    return [(x + radius * math.cos(a), y + radius * math.sin(a)) for a in angles]


def _area(path: Sequence[Spot]) -> float:
    return sum(
        a[0] * b[1] - a[1] * b[0] for a, b in zip(path, [*path[1:], path[0]], strict=True)
    ) / 2  # fmt: skip


def is_in(spot: Spot, path: Sequence[Spot]) -> bool:
    x, y = spot
    inside = False
    for a, b in zip(path, [*path[1:], path[0]], strict=True):
        if (a[1] > y) != (b[1] > y) and a[0] + (y - a[1]) / (b[1] - a[1]) * (b[0] - a[0]) > x:
            inside = not inside
    return inside


def _ring(pieces: list[dict[str, Any]], lines: _Lines) -> Ring:
    curves = [_curve(piece, lines) for piece in pieces]
    changes = [curve for k, curve in enumerate(curves) if curve != curves[k - 1]]
    return least(changes or curves[:1])


def _curve(piece: dict[str, Any], lines: _Lines) -> Curve:
    if not piece["arc"]:
        return lines.name(piece["ends"])
    r, _, _, u, v, _ = (Fraction(number) for number in piece["conic"])
    return ("arc", str(-u / (2 * r)), str(-v / (2 * r)))


def _key(curve: Curve) -> tuple[Any, ...]:
    return (curve[0], *(Fraction(number) for number in curve[1:]))


def least(ring: Sequence[Curve]) -> Ring:
    """Rotates the ring to its least starting point."""
    keys = [_key(curve) for curve in ring]
    start = min(range(len(ring)), key=lambda k: keys[k:] + keys[:k])
    return (*ring[start:], *ring[:start])
