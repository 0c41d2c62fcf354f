"""Places as far from three sites: one formula for doubles and for exact numbers.

All coordinates may be floats, or rationals; roots come from `root`. A place is told as (x, y,
squared radius)."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from typing import Any

Place = tuple[Any, Any, Any]
Root = Callable[[Any], Any]
Line = tuple[Any, Any, Any, Any, Any, Any]  # normal, height, squared length, direction
Spot = tuple[Any, Any]


def places(
    lines: list[Line], spots: list[Spot], own: set[tuple[int, int]], are_parallel: bool, root: Root
) -> list[Place]:
    """Places equally far from three lines and points together, in front of all lines. `own` has
    (i, j) if line i ends at point j; other points lie off all lines. No two lines face one way;
    `are_parallel`: both lines are, if there are two."""
    if len(lines) == 3:
        return list(_lines(lines, root))
    if len(lines) == 2:
        ends = {i for i, _ in own}
        if ends == {1}:
            lines = lines[::-1]
        if are_parallel:
            return list(_between_parallels(lines, spots[0], bool(ends), root))
        return list(_two_lines(lines, spots[0], ends, root))
    if len(lines) == 1:
        if own:
            return list(_at_end(lines[0], spots, own)) if len(own) == 1 else []
        return list(_line(lines[0], spots, root))
    return list(_points(spots))


def _points(spots: list[Spot]) -> Iterator[Place]:
    (ax, ay), (bx, by), (cx, cy) = spots
    px, py, qx, qy = bx - ax, by - ay, cx - ax, cy - ay
    area = 2 * (px * qy - py * qx)
    if area == 0:
        return
    p, q = px * px + py * py, qx * qx + qy * qy
    x, y = (qy * p - py * q) / area, (px * q - qx * p) / area
    yield ax + x, ay + y, x * x + y * y


def _at_end(line: Line, spots: list[Spot], own: set[tuple[int, int]]) -> Iterator[Place]:
    """Right before a line's end."""
    nx, ny, _, square, _, _ = line
    [(_, k)] = own
    (x, y), (u, v) = spots[k], spots[1 - k]
    over = nx * (u - x) + ny * (v - y)
    if over > 0:
        t = ((u - x) ** 2 + (v - y) ** 2) / (2 * over)
        yield x + t * nx, y + t * ny, t * t * square


def _line(line: Line, spots: list[Spot], root: Root) -> Iterator[Place]:
    """On the perpendicular bisector of the points, at m + t w: a quadratic equation for t."""
    nx, ny, height, square, _, _ = line
    (px, py), (qx, qy) = spots
    mx, my, wx, wy = (px + qx) / 2, (py + qy) / 2, py - qy, qx - px
    apart = wx * wx + wy * wy
    h, k = nx * mx + ny * my - height, nx * wx + ny * wy
    first, last = k * k - square * apart, h * h - square * apart / 4
    under = square * apart * (h * h + k * k / 4 - square * apart / 4)
    for t in _solutions(first, h * k, last, under, root):
        yield mx + t * wx, my + t * wy, t * t * apart + apart / 4


def _solutions(first: Any, half: Any, last: Any, under: Any, root: Root) -> Iterator[Any]:
    """Solutions t of first t^2 + 2 half t + last = 0, with half^2 - first last = under."""
    step = root(under)
    total = half + step if _sign(half) >= 0 else half - step
    if _sign(total) == 0:
        if _sign(first) != 0:
            yield total
        return
    yield -last / total
    if _sign(first) != 0 and _sign(step) != 0:
        yield -total / first


def _sign(value: Any) -> int:
    return int(value.sign()) if hasattr(value, "sign") else (value > 0) - (value < 0)


def _two_lines(lines: list[Line], spot: Spot, ends: set[int], root: Root) -> Iterator[Place]:
    """Places move out from the lines' crossing: n . p = height + s |n| |n_1|."""
    if len(ends) == 2:
        return
    (ax, ay, a, square, _, _), (bx, by, b, other, _, _) = lines
    turn, along = ax * by - ay * bx, ax * bx + ay * by
    x, y = spot
    length = root(square * other)
    if ends:
        t = (bx * x + by * y - b) / (length - along)
        yield x + t * ax, y + t * ay, t * t * square
        return
    sx, sy = (a * by - b * ay) / turn - x, (ax * b - bx * a) / turn - y
    ux, uy = (square * by - length * ay) / turn, (length * ax - square * bx) / turn
    first, half = square * (length - along) / (length + along), ux * sx + uy * sy
    last = sx * sx + sy * sy
    for s in _solutions(first, half, last, half * half - first * last, root):
        yield x + sx + s * ux, y + sy + s * uy, s * s * square


def _between_parallels(lines: list[Line], spot: Spot, is_end: bool, root: Root) -> Iterator[Place]:
    (ax, ay, a, square, dx, dy), (bx, by, b, _, _, _) = lines
    x, y = spot
    factor = (ax * bx + ay * by) / square  # n_2 = factor n_1
    t = (b / factor - a) / 2
    if t <= 0:
        return
    off = a + t - ax * x - ay * y
    x, y = x + off * ax / square, y + off * ay / square
    if is_end:
        yield x, y, t * t / square
        return
    step = root(t * t - off * off) / square
    yield x + step * dx, y + step * dy, t * t / square
    yield x - step * dx, y - step * dy, t * t / square


def _lines(lines: list[Line], root: Root) -> Iterator[Place]:
    """n . p = height + s |n| |n_1| for three lines: linear equations for p and s."""
    turns = [
        lines[j][0] * lines[k][1] - lines[j][1] * lines[k][0] for j, k in ((1, 2), (2, 0), (0, 1))
    ]
    square = lines[0][3]
    factors = [root(square * line[3]) for line in lines]
    total = sum(turn * factor for turn, factor in zip(turns, factors, strict=True))
    heights = sum(turn * line[2] for turn, line in zip(turns, lines, strict=True))
    if _sign(total) == 0:
        return
    s = -heights / total
    if _sign(s) <= 0:
        return
    k = max(range(3), key=lambda k: abs(turns[k]))
    i, j = (k + 1) % 3, (k + 2) % 3
    (px, py, p), (qx, qy, q) = lines[i][:3], lines[j][:3]
    p, q = p + s * factors[i], q + s * factors[j]
    yield (p * qy - q * py) / turns[k], (px * q - qx * p) / turns[k], s * s * square
