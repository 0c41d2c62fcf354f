"""Tori and tubes along torus knots, with integer vertices."""

from __future__ import annotations

import random
from fractions import Fraction
from math import cos, pi, sin

from minkref.fuzz.geometry.polyhedron import Polyhedron
from minkref.fuzz.geometry.space import Point
from minkref.fuzz.space.self_crossing import self_crossing

# Corner directions of lattice polygons around the origin.
ROUND: dict[int, list[tuple[int, int]]] = {
    3: [(1, 0), (-1, 1), (-1, -1)],
    4: [(1, 0), (0, 1), (-1, 0), (0, -1)],
    5: [(2, 0), (1, 2), (-2, 1), (-2, -1), (1, -2)],
    6: [(1, 0), (1, 1), (0, 1), (-1, 0), (-1, -1), (0, -1)],
}
SECTIONS: dict[int, list[tuple[int, int]]] = {
    3: [(1, 0), (-1, 1), (-1, -1)],
    4: [(1, -1), (1, 1), (-1, 1), (-1, -1)],
}


def lattice_torus(around: int, section: int, radius: int) -> Polyhedron:
    """A torus with 3 to 6 trapezoid stretches (`around`) and a section of 3 or 4 corners, at a
    radius above one; `around` times `section` planar faces."""
    vertices: list[Point] = []
    for x, y in ROUND[around]:
        for a, b in SECTIONS[section]:
            r = radius + a
            vertices.append((Fraction(r * x), Fraction(r * y), Fraction(b)))
    return Polyhedron(tuple(vertices), tuple(_quads(around, section)))


def knot_tube(
    dice: random.Random, p: int, q: int, around: int, section: int, size: int
) -> Polyhedron:
    """A tube with `around` stretches along the (p, q) torus knot, in 2 `around` `section`
    triangles. To avoid self-crossing, thinner tubes are tried in turn. ValueError if the knot has
    too few stretches for any."""
    turned = dice.random()
    for thickness in (0.35, 0.2, 0.1, 0.05):
        vertices: list[Point] = []
        for k in range(around):
            t = 2 * pi * (k + turned) / around
            for j in range(section):
                x, y, z = _on_tube(p, q, t, 2 * pi * j / section, thickness)
                vertices.append((Fraction(round(size * x)), Fraction(round(size * y)),
                                 Fraction(round(size * z))))  # fmt: skip
        faces = [part for a, b, c, d in _quads(around, section) for part in ((a, b, c), (a, c, d))]
        tube = Polyhedron(tuple(vertices), tuple(faces))
        if tube.fault() is None and self_crossing(tube) is None and tube.volume > 0:
            return tube
    raise ValueError(f"a ({p}, {q}) knot of {around} stretches crosses itself")


def wide_knot(p: int, q: int, around: int, section: int, size: int) -> Polyhedron:
    """A tube with `around` stretches about the (p, q) knot on a torus with radii 3 and 1.2 `size`,
    with thickness 0.35, in 2 `around` `section` triangles. The section keeps to one direction in
    space, turning about the knot. ValueError if the tube crosses itself."""
    vertices: list[Point] = []

    def knot(at: float) -> list[float]:
        rim = 3 + 1.2 * cos(q * at)
        return [rim * cos(p * at), rim * sin(p * at), 1.2 * sin(q * at)]

    for k in range(around):
        t = 2 * pi * k / around
        here, after, before = knot(t), knot(t + 1e-4), knot(t - 1e-4)
        along = _unit([a - b for a, b in zip(after, before, strict=True)])
        u = _unit(_across(along, [0.1, 0.2, 1.0]))
        v = _across(along, u)
        for j in range(section):
            angle = 2 * pi * j / section
            x, y, z = (
                Fraction(round(size * (a + 0.35 * (cos(angle) * b + sin(angle) * c))))
                for a, b, c in zip(here, u, v, strict=True)
            )
            vertices.append((x, y, z))
    faces = [part for a, b, c, d in _quads(around, section) for part in ((a, b, c), (a, c, d))]
    tube = Polyhedron(tuple(vertices), tuple(faces))
    tube = tube if tube.volume > 0 else tube.turned_inside_out()
    if tube.fault() is not None or self_crossing(tube) is not None:
        raise ValueError(f"a wide ({p}, {q}) knot of {around} stretches crosses itself")
    return tube


def _on_tube(p: int, q: int, t: float, angle: float, r: float) -> tuple[float, float, float]:
    """A corner of the section at t. Floats only choose grid points. The section lies between a
    direction radial to the torus and the common normal of this direction and the knot."""

    def knot(at: float) -> list[float]:
        rim = 2 + cos(q * at)
        return [rim * cos(p * at), rim * sin(p * at), -sin(q * at)]

    here = knot(t)
    after, before = knot(t + 1e-4), knot(t - 1e-4)
    along = _unit([a - b for a, b in zip(after, before, strict=True)])
    up = [cos(q * t) * cos(p * t), cos(q * t) * sin(p * t), -sin(q * t)]
    lift = sum(a * b for a, b in zip(up, along, strict=True))
    u = _unit([a - lift * b for a, b in zip(up, along, strict=True)])
    v = _across(u, along)
    x, y, z = (
        a + r * (cos(angle) * b + sin(angle) * c) for a, b, c in zip(here, u, v, strict=True)
    )
    return x, y, z


def _across(u: list[float], v: list[float]) -> list[float]:
    """The cross product."""
    return [u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]]


def _unit(v: list[float]) -> list[float]:
    length = sum(a * a for a in v) ** 0.5
    return [a / length for a in v]


def _quads(around: int, section: int) -> list[tuple[int, int, int, int]]:
    faces = []
    for i in range(around):
        here, there = i * section, (i + 1) % around * section
        for j in range(section):
            k = (j + 1) % section
            faces.append((here + j, there + j, there + k, here + k))
    return faces
