"""Areas in floating point, for choices that decide nothing."""

from __future__ import annotations

from itertools import pairwise
from math import sqrt

Place = tuple[float, float, float]
RoughHalf = tuple[float, float, float, float]  # a x + b y + c z <= d


def rough_polygon(corners: list[tuple[int, int, int, int]], unit: int) -> list[Place]:
    """Converts homogeneous corners in units to a polygon in doubles."""
    return [(near(x, w * unit), near(y, w * unit), near(z, w * unit)) for x, y, z, w in corners]


def rough_half(half: tuple[tuple[int, int, int], int], unit: int) -> RoughHalf:
    """Returns the half-space in doubles, with a short normal."""
    (a, b, c), height = half
    size = max(abs(a), abs(b), abs(c))
    return near(a, size), near(b, size), near(c, size), near(height, size * unit)


def near(numerator: int, denominator: int) -> float:
    try:
        return numerator / denominator
    except OverflowError:
        return 0.0


def taken_off(polygon: list[Place], half: RoughHalf) -> float:
    """Twice the area of the polygon above the plane."""
    a, b, c, d = half
    kept: list[Place] = []
    p, at_p = polygon[-1], 0.0
    for k, q in enumerate([polygon[-1], *polygon]):
        at_q = a * q[0] + b * q[1] + c * q[2] - d
        if k and at_p * at_q < 0:
            t = at_p / (at_p - at_q)
            x, y, z = (s + t * (e - s) for s, e in zip(p, q, strict=True))
            kept.append((x, y, z))
        if k and at_q >= 0:
            kept.append(q)
        p, at_p = q, at_q
    return rough_area(kept)


def rough_area(polygon: list[Place]) -> float:
    """Twice the area."""
    if len(polygon) < 3:
        return 0.0
    x0, y0, z0 = polygon[0]
    x = y = z = 0.0
    for p, q in pairwise(polygon[1:]):
        a, b, c = p[0] - x0, p[1] - y0, p[2] - z0
        d, e, f = q[0] - x0, q[1] - y0, q[2] - z0
        x, y, z = x + b * f - c * e, y + c * d - a * f, z + a * e - b * d
    return sqrt(x * x + y * y + z * z)
