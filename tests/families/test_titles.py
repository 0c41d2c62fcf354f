"""Every family shows the feature in its title."""

from __future__ import annotations

import json
from collections.abc import Iterator
from fractions import Fraction
from itertools import combinations
from typing import Any

from minkref import _core
from minkref.fuzz.plane.families.catalogue import FAMILIES
from minkref.fuzz.plane.families.random_pairs import Pair

SEED = 12
COUNT = 80

Point = tuple[Fraction, Fraction]


def pairs(name: str) -> Iterator[Pair]:
    print(f"seed {SEED}")
    return (FAMILIES[name].pair(SEED, 5 * index) for index in range(COUNT))


def share(name: str, shows: Any) -> float:
    """The share of pairs with a feature."""
    return sum(bool(shows(pair)) for pair in pairs(name)) / COUNT


def polygons(text: str) -> list[list[list[Point]]]:
    return [
        [
            [(Fraction(x), Fraction(y)) for x, y in ring]
            for ring in (polygon["outer"], *polygon["holes"])
        ]
        for polygon in json.loads(text)["polygons"]
    ]


def turns(ring: list[Point]) -> list[Fraction]:
    return [
        (b[0] - a[0]) * (c[1] - b[1]) - (b[1] - a[1]) * (c[0] - b[0])
        for a, b, c in zip(ring, ring[1:] + ring[:1], ring[2:] + ring[:2], strict=True)
    ]


def numbers(pair: Pair) -> list[Fraction]:
    return [
        number
        for text in (pair.P, pair.Q)
        for polygon in polygons(text)
        for ring in polygon
        for point in ring
        for number in point
    ]


def total(pair: Pair, scale: str | None = None) -> _core.Sum:
    P, Q = _core.PolygonSet.from_json(pair.P), _core.PolygonSet.from_json(pair.Q)
    return _core.minkowski_sum(P, Q, scale or pair.scale)


def holes(text: str) -> int:
    return sum(len(polygon) - 1 for polygon in polygons(text))


def has_touching_rings(pair: Pair) -> bool:
    for text in (pair.P, pair.Q):
        rings = [ring for polygon in polygons(text) for ring in polygon]
        if any(touch(one, other) for one, other in combinations(rings, 2)):
            return True
    return False


def touch(one: list[Point], other: list[Point]) -> bool:
    """Whether a ring's vertex lies on the other ring."""
    return any(
        (b[0] - a[0]) * (p[1] - a[1]) == (b[1] - a[1]) * (p[0] - a[0])
        and min(a, b) <= p <= max(a, b)
        for ring, points in ((one, other), (other, one))
        for a, b in zip(ring, ring[1:] + ring[:1], strict=True)
        for p in points
    )


def test_convex() -> None:
    assert share("convex", lambda pair: all(
        min(turns(polygons(text)[0][0])) >= 0 for text in (pair.P, pair.Q)
    )) == 1  # fmt: skip


def test_holes_in_both() -> None:
    assert share("holes", lambda pair: holes(pair.P) and holes(pair.Q)) == 1
    assert 0.1 < share("holes", lambda pair: total(pair).holes) < 0.9


def test_some_small_holes_survive_and_most_do_not() -> None:
    assert share("small-holes", lambda pair: total(pair).holes) > 0.95
    assert share("small-holes", lambda pair: total(pair).holes < holes(pair.P + "")
                 or total(pair).holes < holes(pair.Q)) > 0.7  # fmt: skip


def test_fits_are_exact_or_off_by_little() -> None:
    """The sum changes its form if the scale changes by one part in 2^19."""

    def changes(pair: Pair) -> bool:
        scale = Fraction(pair.scale)
        near = [str(scale * (1 + Fraction(k, 2**19))) for k in (-1, 0, 1)]
        sums = [total(pair, text) for text in near]
        return len({(each.holes, each.components, each.region.vertices) for each in sums}) > 1

    assert share("fit", changes) > 0.6


def test_collinear_vertices_and_parallel_edges() -> None:
    assert share("collinear", lambda pair: any(
        0 in turns(ring) for text in (pair.P, pair.Q) for polygon in polygons(text)
        for ring in polygon
    )) > 0.9  # fmt: skip


def test_touching_rings() -> None:
    assert share("touching", has_touching_rings) > 0.6
    assert share("cells", has_touching_rings) > 0.2


def test_cells_have_holes_and_components() -> None:
    assert share("cells", lambda pair: holes(pair.P) + holes(pair.Q)) > 0.15
    assert share("cells", lambda pair: len(polygons(pair.P)) + len(polygons(pair.Q)) > 2) > 0.3
    assert share("cells", lambda pair: total(pair).holes) > 0.05


def test_nested_polygons() -> None:
    assert share("nested", lambda pair: max(len(polygons(t)) for t in (pair.P, pair.Q)) > 1) > 0.9
    assert share("nested", lambda pair: total(pair).components > 1) > 0.3


def test_combs_stars_and_spirals_are_far_from_convex() -> None:
    for name in ("comb", "star", "spiral"):
        assert share(name, lambda pair: any(
            min(turns(polygon[0])) < 0 for text in (pair.P, pair.Q) for polygon in polygons(text)
        )) == 1  # fmt: skip
    assert share("spiral", lambda pair: total(pair).holes) > 0.2


def test_degenerate_operands() -> None:
    sets = [
        [_core.PolygonSet.from_json(text) for text in (pair.P, pair.Q)]
        for pair in pairs("degenerate")
    ]
    for kind in ("is_empty", "is_point", "is_segment"):
        assert sum(any(getattr(each, kind) for each in both) for both in sets) > 0.05 * COUNT
    assert all(sum(each.is_region for each in both) == 1 for both in sets)


def test_numbers() -> None:
    assert share("offset", lambda pair: max(map(abs, numbers(pair))) > 900) == 1
    assert share("rational", lambda pair: max(n.denominator for n in numbers(pair)) > 1) == 1
    assert share("rational", lambda pair: max(n.denominator for n in numbers(pair)) < 1000) == 1
    sizes = [[abs(n) for n in numbers(pair) if n] for pair in pairs("magnitude")]
    assert min(map(min, sizes)) < Fraction(1, 2**25) and max(map(max, sizes)) > 2**25
    assert sum(max(each) / min(each) > 2**20 for each in sizes) > 0.5 * COUNT


def test_slivers() -> None:
    def is_thin(pair: Pair) -> bool:
        return any(
            abs(ring_area(polygon[0])) * 20 < longest(polygon[0]) ** 2
            for text in (pair.P, pair.Q)
            for polygon in polygons(text)
        )

    assert share("thin", is_thin) > 0.8


def test_walls_lean_by_little() -> None:
    def apart(pair: Pair) -> list[Fraction]:
        """Sines of the angles between walls of the two operands, to their squares."""
        walls = [
            [(q[0] - p[0], q[1] - p[1]) for ring in (each[0] for each in polygons(text))
             for p, q in zip(ring, ring[1:] + ring[:1], strict=True)]
            for text in (pair.P, pair.Q)
        ]  # fmt: skip
        return [
            Fraction((u[0] * v[1] - u[1] * v[0]) ** 2) / ((u[0]**2 + u[1]**2) * (v[0]**2 + v[1]**2))
            for u in walls[0] for v in walls[1]
        ]  # fmt: skip

    for least, most in ((2, 5), (7, 13), (14, 19), (19, 32)):
        low, high = Fraction(1, 100**most), Fraction(1, 100**least)
        assert share("leaning", lambda p, low=low, high=high: any(
            low < sine < high for sine in apart(p)
        )) > 0.1  # fmt: skip


def ring_area(ring: list[Point]) -> Fraction:
    return sum(
        (p[0] * q[1] - p[1] * q[0] for p, q in zip(ring, ring[1:] + ring[:1], strict=True)),
        Fraction(0),
    )


def longest(ring: list[Point]) -> Fraction:
    return max(
        max(abs(p[0] - q[0]), abs(p[1] - q[1]))
        for p, q in zip(ring, ring[1:] + ring[:1], strict=True)
    )
