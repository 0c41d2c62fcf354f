"""Flags of cases in space, decided again from the case file alone: each given flag holds, and no
other flag does."""

from __future__ import annotations

import json
from fractions import Fraction
from itertools import product
from typing import Any

import pytest
from members import Vector, cross, dot, minus
from minkref.degeneracies import lint
from minkref.degeneracies.catalogue import SPACE_FAMILIES
from minkref.degeneracies.space.bodies import box
from minkref.degeneracies.space.case_document import DegenerateInSpace
from minkref.degeneracies.space.draft import SpaceDraft, SpaceFacts
from minkref.degeneracies.space.flags import FLAGS_IN_SPACE, flags_in_space
from minkref.degeneracies.space.vectors import vector
from minkref.fuzz.geometry.polyhedron import Polyhedron
from minkref.fuzz.space.hull import convex_hull, sum_of_convex
from thoroughness import draws, some

SEED, COUNT = 31, draws(1, 2)
MILLION = 10**6


class Solid:
    """The hull of points, with normals and edges."""

    def __init__(self, points: list[Vector]) -> None:
        self.hull = convex_hull(points)
        self.points = list(self.hull.vertices)
        at = [[self.points[k] for k in face] for face in self.hull.faces]
        self.normals = [cross(minus(r[1], r[0]), minus(r[2], r[0])) for r in at]
        self.heights = [dot(n, r[0]) for n, r in zip(self.normals, at, strict=True)]
        self.sides = [len(ring) for ring in at]
        self.edges = {
            frozenset((face[k - 1], face[k])) for face in self.hull.faces for k in range(len(face))
        }
        self.along = [minus(*(self.points[k] for k in edge)) for edge in self.edges]

    def degree(self) -> int:
        corners = [k for face in self.hull.faces for k in face]
        return max(map(corners.count, corners))

    def is_thin(self) -> bool:
        pairs = product(self.points, repeat=2)
        length = max(dot(d, d) for a, b in pairs for d in [minus(a, b)])
        widths = []
        for n in self.normals:
            heights = [dot(n, v) for v in self.points]
            widths.append((max(heights) - min(heights)) ** 2 / dot(n, n))
        return min(widths) * MILLION**2 < length

    def is_far_out(self) -> bool:
        columns = list(zip(*self.points, strict=True))
        size = max(max(c) - min(c) for c in columns)
        return max(min(map(abs, c)) for c in columns) > MILLION * size

    def farthest(self, n: Vector) -> int:
        heights = [dot(n, v) for v in self.points]
        return heights.count(max(heights))


def parallel(a: Vector, b: Vector) -> bool:
    return cross(a, b) == (0, 0, 0)


def is_double(number: Fraction) -> bool:
    try:
        return Fraction(float(number)) == number
    except OverflowError:
        return False


def flags_of(value: Any) -> set[str]:
    """By the definitions of flags.json, but for close-scales and limits."""
    P, Q = (Polyhedron.from_document(value[name]) for name in "PQ")
    s = vector(*map(Fraction, value["scales"][0]))
    first, second, clean = Solid(list(P.scaled(s).vertices)), Solid(list(Q.vertices)), Solid(
        list(P.vertices)
    )  # fmt: skip
    total = Solid(list(sum_of_convex(P, Q, s).vertices))
    parents = [(first.farthest(n), second.farthest(n)) for n in total.normals]
    pairs = [(m, n) for m in first.normals for n in second.normals]
    ties = [
        [a * b for a, b in zip(n, d, strict=True)]
        for body, other in ((first, second), (second, first))
        for n in body.normals
        for d in other.along
    ]
    zero = [any(terms) for terms in ties if sum(terms) == 0]
    near = [
        0 < dot(c, c) * 4**20 < dot(m, n) ** 2 and dot(m, n) > 0
        for m, n in pairs
        for c in [cross(m, n)]
    ]
    numbers = [abs(c) for body in (P, Q) for v in body.vertices for c in v if c]
    sums = set()  # of two edges
    for edge in total.edges:
        d = minus(*(total.points[k] for k in edge))
        faces = [n for n, f in zip(total.normals, total.hull.faces, strict=True) if edge <= {*f}]
        across = vector(*(a + b for a, b in zip(*map(unit_sum, faces), strict=True)))
        sums.add(first.farthest(across) == 2 == second.farthest(across) and dot(across, d) == 0)
    bodies = (clean, second)
    given = ((P, clean), (Q, second))
    found = {
        "all-facets-parallel": all(min(p, q) > 2 for p, q in parents),
        "facet-along-edge": any(min(p, q) == 2 < max(p, q) for p, q in parents),
        "flat-vertices": any(len(g.vertices) > len(c.points) for g, c in given),
        "large-translation": any(body.is_far_out() for body in bodies),
        "magnitudes": max(*numbers, *s) > MILLION * min(*numbers, *s),
        "many-facets-at-a-vertex": any(body.degree() >= 8 for body in bodies),
        "many-sided-facets": any(max(body.sides) >= 8 for body in bodies),
        "nearly-parallel-facets": any(near),
        "opposite-facets": any(parallel(m, n) and dot(m, n) < 0 for m, n in pairs),
        "origin-outside": any(h < 0 for h in clean.heights),
        "overlapping-arcs": any(sums),
        "parallel-edges": any(parallel(d, e) for d in first.along for e in second.along),
        "parallel-facets": any(parallel(m, n) and dot(m, n) > 0 for m, n in pairs),
        "scale-is-no-float": not all(map(is_double, s)),
        "split-facets": any(len(g.faces) > len(c.normals) for g, c in given),
        "thin-body": any(body.is_thin() for body in bodies),
        "tie-at-a-scaling": True in zero,
        "tie-at-every-scaling": False in zero,
    }
    assert {*found, "close-scales", "limits"} == set(FLAGS_IN_SPACE)
    return {flag for flag, holds in found.items() if holds}


def unit_sum(n: Vector) -> Vector:
    """Divides n by the sum of its absolute coordinates: two such vectors sum to a vector inside the
    arc between them."""
    size = sum(map(abs, n))
    return n[0] / size, n[1] / size, n[2] / size


def told(value: Any) -> set[str]:
    return set(value["flags"]) - {"close-scales", "limits"}


@pytest.mark.parametrize("name", SPACE_FAMILIES)
def test_flags_in_space_hold_where_they_are_given_and_only_there(name: str) -> None:
    paths = some(lint.case_paths(lint.CORPUS / name), 1)
    values = [json.loads(path.read_text(encoding="utf-8")) for path in paths]
    print(f"{name} --seed {SEED}")
    values += [DegenerateInSpace.of(SPACE_FAMILIES[name], SEED, k).document for k in range(COUNT)]
    for value in values:
        assert flags_of(value) == told(value), value["id"]


def test_close_scales_by_the_siblings() -> None:
    """The flag `close-scales` holds exactly if the nearest sibling is less than 2^-60 below the
    scaling: 2^-61 of a factor or less, because larger steps would reach other critical factors.
    Small factors have smaller steps anyway."""
    for name in SPACE_FAMILIES:
        for path in lint.case_paths(lint.CORPUS / name):
            value = json.loads(path.read_text(encoding="utf-8"))
            at, below = (vector(*map(Fraction, scale)) for scale in value["scales"][:2])
            step = sum(minus(at, below), Fraction(0))
            assert ("close-scales" in value["flags"]) == (step < Fraction(1, 2**60)), value["id"]


def test_limits_of_integers_in_space() -> None:
    """No member of the corpus has coordinates at a limit."""

    def flags(largest: int) -> list[str]:
        corners = [(Fraction(x), Fraction(y), Fraction(z)) for x in (0, largest)
                   for y in (0, 3) for z in (0, 3)]  # fmt: skip
        return flags_in_space(SpaceFacts.of(SpaceDraft(convex_hull(corners), box(5, 5, 5))))

    assert "limits" in flags(2**53) and "limits" in flags(2**31 - 1)
    assert "limits" not in flags(2**53 + 1)
