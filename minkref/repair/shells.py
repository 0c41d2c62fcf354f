"""Nested shells, and the way each shell has to face."""

from __future__ import annotations

from collections.abc import Sequence
from fractions import Fraction
from itertools import count

from minkref.repair.change import Change
from minkref.repair.faces import IntegerVector, Mesh, Note, cross, dot, edges_of, minus
from minkref.repair.groups import Groups

Triangle = tuple[IntegerVector, IntegerVector, IntegerVector]
Exact = tuple[Fraction, Fraction, Fraction]


def shells_of(mesh: Mesh, part: Sequence[int]) -> list[list[int]]:
    """Group faces into shells: closed parts; parts ending at edges with more than two faces go
    together."""
    loose: dict[tuple[int, int], set[int]] = {}
    net: dict[tuple[int, int, int], int] = {}
    for k, face in enumerate(mesh.faces):
        for a, b in edges_of(face):
            key = (part[k], min(a, b), max(a, b))
            net[key] = net.get(key, 0) + (1 if a < b else -1)
    for (number, a, b), total in net.items():
        if total:
            loose.setdefault((a, b), set()).add(number)
    groups = Groups(max(part, default=-1) + 1)
    for numbers in loose.values():
        first, *others = numbers
        for other in others:
            groups.join(first, other)
    found: dict[int, list[int]] = {}
    for k, number in enumerate(part):
        found.setdefault(groups.root(number), []).append(k)
    return list(found.values())


def face_outwards(mesh: Mesh, shells: list[list[int]], rule: str, note: Note) -> None:
    """Turn or drop shells, from the outermost inwards, so that the material is where the rule says:
    where the shells wind around a point (nonzero), so often that the number is odd (evenodd), or
    positive. Drops shells that bound nothing by the rule. The shells must not cross.
    O(shells times faces)."""
    shells = [shell for shell in shells if shell]
    triangles = [[t for k in shell for t in _fan(mesh, mesh.faces[k])] for shell in shells]
    volumes = [_sextuple_volume(each) for each in triangles]
    boxes = [_box(each) for each in triangles]
    inside: list[list[int]] = []
    for k in range(len(shells)):
        near = [j for j in range(len(shells)) if j != k and _holds(boxes[j], boxes[k])]
        inside.append(_around(triangles, k, near))
    sign = [1 if volume > 0 else -1 for volume in volumes]
    stays = [True] * len(mesh.faces)
    for k in sorted(range(len(shells)), key=lambda k: len(inside[k])):
        outer = sum(sign[j] for j in inside[k])
        wanted = _wanted(outer, sign[k], rule)
        if wanted == sign[k]:
            continue
        change = Change(
            "turned-shell" if wanted else "dropped-shell",
            face=mesh.numbers[shells[k][0]],
            faces=len(shells[k]),
            volume=abs(Fraction(volumes[k], 6 * mesh.denominator**3)),
        )
        note(change)
        for face in shells[k]:
            mesh.faces[face] = mesh.faces[face][::-1]
            stays[face] = wanted != 0
        sign[k] = wanted
    mesh.keep(stays)


def _wanted(outer: int, sign: int, rule: str) -> int:
    """The sign of a shell after the repair, 0 for a dropped shell. `outer`: the winding number just
    outside, 0 or 1."""
    inner = outer + sign
    is_material = (
        inner > 0 if rule == "positive" else inner % 2 == 1 if rule == "evenodd" else inner != 0
    )
    return int(is_material) - outer


def _fan(mesh: Mesh, face: Sequence[int]) -> list[Triangle]:
    points = [mesh.integers[v] for v in face]
    return [(points[0], points[k], points[k + 1]) for k in range(1, len(points) - 1)]


def _sextuple_volume(triangles: list[Triangle]) -> int:
    return sum(dot(a, cross(b, c)) for a, b, c in triangles)


def _box(triangles: list[Triangle]) -> tuple[IntegerVector, IntegerVector]:
    points = [p for triangle in triangles for p in triangle]
    low = tuple(min(p[k] for p in points) for k in range(3))
    high = tuple(max(p[k] for p in points) for k in range(3))
    return (low[0], low[1], low[2]), (high[0], high[1], high[2])


def _holds(
    outer: tuple[IntegerVector, IntegerVector], inner: tuple[IntegerVector, IntegerVector]
) -> bool:
    return all(outer[0][k] <= inner[0][k] and inner[1][k] <= outer[1][k] for k in range(3))


def _around(triangles: list[list[Triangle]], k: int, near: list[int]) -> list[int]:
    """The shells of `near` around shell k, by a line through an inner point of one of its
    triangles: points and directions are tried until the line meets no edge and the point lies on
    none of the other shells."""
    if not near:
        return []
    for trial in count(1):
        a, b, c = triangles[k][(trial - 1) % len(triangles[k])]
        over = 1 + trial + trial**2
        x, y, z = (Fraction(a[i] + trial * b[i] + trial**2 * c[i], over) for i in range(3))
        way = (trial + 1, 2 * trial**2 + 3, 7 * trial + 5)
        found = [_winding(triangles[j], (x, y, z), way) for j in near]
        if None not in found:
            return [j for j, number in zip(near, found, strict=True) if number]
    raise AssertionError


def _winding(triangles: list[Triangle], at: Exact, way: IntegerVector) -> int | None:
    """How often triangles wind around a point; None if the ray meets an edge or starts on one."""
    total = 0
    scale = at[0].denominator * at[1].denominator * at[2].denominator
    start = tuple(int(x * scale) for x in at)
    for triangle in triangles:
        a, b, c = (tuple(scale * p[i] - start[i] for i in range(3)) for p in triangle)
        normal = cross(minus(_three(b), _three(a)), minus(_three(c), _three(a)))
        u = dot(way, cross(_three(a), _three(b)))
        v = dot(way, cross(_three(b), _three(c)))
        w = dot(way, cross(_three(c), _three(a)))
        if (u > 0 or v > 0 or w > 0) and (u < 0 or v < 0 or w < 0):
            continue
        if u == 0 or v == 0 or w == 0:
            if u == v == w == 0 and dot(normal, _three(a)):
                continue  # seen edge-on
            return None
        height = dot(normal, _three(a))
        if height == 0:
            return None
        if (height > 0) == (dot(normal, way) > 0):
            total += 1 if height > 0 else -1
    return total


def _three(vector: tuple[int, ...]) -> IntegerVector:
    return vector[0], vector[1], vector[2]
