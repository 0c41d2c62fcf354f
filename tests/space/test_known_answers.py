"""Sums in space known by hand, and found by two routes."""

from __future__ import annotations

import random
from fractions import Fraction
from itertools import product

import pytest
from minkref import PolygonSet
from minkref.fuzz.geometry.polyhedron import Polyhedron
from minkref.fuzz.geometry.space import Point
from minkref.fuzz.space.cells import cavities, cells_of, is_manifold, sum_of_cells, surface_of
from minkref.fuzz.space.closedness import open_edge
from minkref.fuzz.space.comparison import compare
from minkref.fuzz.space.generators.convex import cube
from minkref.fuzz.space.generators.polycube import frame, hollow_box, l_prism, random_polycube
from minkref.fuzz.space.generators.torus import torus
from minkref.fuzz.space.hull import sum_of_convex
from minkref.fuzz.space.meeting import Meeting, decide
from minkref.fuzz.space.membership import Surface, winding_number
from minkref.fuzz.space.pairs import pair_of_cells, pair_of_prisms, space_pair
from minkref.fuzz.space.prism import Prism

UNIT = frozenset({(0, 0, 0)})
ORIGIN = (Fraction(0),) * 3


def point(x: object, y: object, z: object) -> Point:
    return (Fraction(str(x)), Fraction(str(y)), Fraction(str(z)))


def block(a: int, b: int, c: int) -> frozenset[tuple[int, int, int]]:
    return frozenset(product(range(a), range(b), range(c)))


def test_l_prism_far_from_the_origin_and_a_unit_cube() -> None:
    pair = pair_of_cells("l", l_prism(3, 1, 3, (10, 10, 10)), UNIT, Fraction(1))
    assert pair.cell_sum.volume == 48
    total = pair.sum()
    assert total is not None and total.volume == 48
    assert total.box == (point(10, 10, 10), point(14, 14, 14))
    assert compare(pair, total).proven
    assert pair.meeting.meets(point(12, 12, 12))
    assert not pair.meeting.meets(point("12.001", "12.001", 12))


def test_two_cubes() -> None:
    small, large = cube(ORIGIN, Fraction(1)), cube(point(5, 0, 0), Fraction(2))
    assert sum_of_convex(small, large, Fraction(3)) == cube(point(5, 0, 0), Fraction(5))
    whole = sum_of_cells(UNIT, UNIT, Fraction(3, 2))
    assert (len(whole.cells), whole.volume) == (125, Fraction(125, 8))


@pytest.mark.parametrize(("side", "closed"), [("1.9", False), (2, True), ("2.1", True)])
def test_a_cube_closes_the_hole_of_a_torus_of_cells(side: object, closed: bool) -> None:
    pair = space_pair("frame", 0, 0)
    P = surface_of(frozenset(c for c in block(4, 4, 1) if c[0] in (0, 3) or c[1] in (0, 3)))
    Q = cube(ORIGIN, Fraction(str(side)))
    middle = point("2.95", "2.95", "1")
    assert Meeting(P, Q, pair.scale).meets(middle) == closed


def test_a_cube_that_fits_the_hole_exactly_touches() -> None:
    P = surface_of(frozenset(c for c in block(3, 3, 1) if c != (1, 1, 0)))
    Q = cube(point("-1/2", "-1/2", "-1/2"), Fraction(1))
    x = point("3/2", "3/2", "1/2")
    assert decide(P, Q, Fraction(1), x).contact == "touch"
    assert decide(P, Q, Fraction(1), point("3/2", "1.6", "1/2")).contact == "overlap"
    smaller = Q.scaled(Fraction(9, 10))
    assert decide(P, smaller, Fraction(1), x).contact == "empty"
    same = decide(P, P, Fraction(1), point(3, 3, 1))  # the cube of P and -P + (3, 3, 1) are one
    assert same.contact == "overlap"
    above = decide(P, P, Fraction(1), point(3, 3, 2))
    assert above.contact == "touch"


def test_a_polygonal_torus_keeps_its_hole_before_a_small_cube_only() -> None:
    P = torus(8, 4, Fraction(3), Fraction(1))
    assert P.fault() is None and is_genus_one(P)
    for side, closed in ((Fraction(1), False), (Fraction(5), True)):
        half = -side / 2
        Q = cube((half, half, half), side)
        assert Meeting(P, Q, Fraction(1)).meets(ORIGIN) == closed


def is_genus_one(polyhedron: Polyhedron) -> bool:
    edges = sum(len(face) for face in polyhedron.faces) // 2
    return len(polyhedron.vertices) - edges + len(polyhedron.faces) == 0


def test_operand_inside_a_cavity_is_outside_and_one_inside_the_walls_is_inside() -> None:
    P = surface_of(hollow_box(random.Random(1), 3))
    Q = cube(point("-1/4", "-1/4", "-1/4"), Fraction(1, 2))
    m = Meeting(P, Q, Fraction(1))
    assert m.decide(point("1.5", "1.5", "1.5")).contact == "empty"
    assert m.decide(point("0.5", "0.5", "0.5")).contact == "overlap"
    assert m.apart(point("1.5", "1.5", "1.5"), Fraction(1, 5))
    assert not m.apart(point("1.5", "1.5", "1.5"), Fraction(1, 4))
    assert m.deep(point("0.5", "0.5", "0.5"), Fraction(1, 5)) is not None


def test_hull_and_cells_agree_on_boxes() -> None:
    for a, b, scale in (((2, 1, 1), (1, 3, 1), "1"), ((1, 2, 3), (2, 2, 1), "3/2")):
        pair = pair_of_cells("boxes", block(*a), block(*b), Fraction(scale))
        hull = sum_of_convex(pair.P, pair.Q, pair.scale)
        assert hull.volume == pair.cell_sum.volume
        assert compare(pair, hull).proven


def test_prism_and_cells_agree_on_prisms_of_grid_squares() -> None:
    ring = [(0, 0), (4, 0), (4, 4), (0, 4)]
    hole = [(1, 1), (1, 3), (3, 3), (3, 1)]
    P = Prism(PolygonSet([ring, hole]), Fraction(0), Fraction(1))
    corner = [(0, 0), (2, 0), (2, 1), (1, 1), (1, 2), (0, 2)]
    Q = Prism(PolygonSet(corner), Fraction(1), Fraction(2))
    P_cells = frozenset(c for c in block(4, 4, 1) if c[0] in (0, 3) or c[1] in (0, 3))
    Q_cells = frozenset({(0, 0, 1), (1, 0, 1), (0, 1, 1)})
    assert cells_of(P.polyhedron()) == P_cells and cells_of(Q.polyhedron()) == Q_cells
    for text in ("1", "1/3", "2"):
        scale = Fraction(text)
        cells = pair_of_cells("cells", P_cells, Q_cells, scale)
        prism = pair_of_prisms("prism", P, Q, scale)
        assert prism.prism_sum.volume == cells.cell_sum.volume
        assert compare(cells, prism.prism_sum.polyhedron()).proven
        assert compare(prism, cells.cell_sum.polyhedron()).proven


def test_points_and_cells_agree_at_every_centre() -> None:
    for index in (4, 25, 44):
        pair = space_pair("polycube", 8, index)
        known = pair.cell_sum
        a, b, c = known.unit
        low, high = (f(cell[k] for cell in known.cells for k in range(3)) for f in (min, max))
        for x, y, z in product(range(low - 1, high + 2), repeat=3):
            if (x + 2 * y + 3 * z) % 5:
                continue
            centre = ((x + Fraction(1, 2)) * a, (y + Fraction(1, 2)) * b, (z + Fraction(1, 2)) * c)
            assert pair.meeting.meets(centre) == ((x, y, z) in known.cells)


def test_a_window_that_closes_leaves_a_cavity() -> None:
    walls = set(block(5, 5, 5)) - set((x + 1, y + 1, z + 1) for x, y, z in block(3, 3, 3))
    walls.discard((2, 2, 0))
    pair = pair_of_cells("window", frozenset(walls), UNIT, Fraction(1))
    assert not cavities(walls) and len(cavities(pair.cell_sum.cells)) == 1
    assert compare(pair, pair.cell_sum.polyhedron()).proven


def test_cells_that_touch_along_an_edge_or_at_a_corner_are_no_manifold() -> None:
    assert is_manifold(UNIT) and not is_manifold(frozenset())
    for other in ((1, 1, 0), (1, 1, 1)):
        assert not is_manifold(UNIT | {other})
        surface = surface_of(UNIT | {other})
        assert surface.fault() is not None and open_edge(surface) is None
    for count in (3, 9, 20):
        assert is_manifold(random_polycube(random.Random(count), count))
    assert is_manifold(frame(random.Random(2), 5))


def test_winding_number_of_cubes_within_cubes() -> None:
    outer, inner = cube(ORIGIN, Fraction(3)), cube(point(1, 1, 1), Fraction(1))
    both = outer.with_faces_of(inner)
    hollow = outer.with_faces_of(inner.turned_inside_out())
    for surface, inside in ((both, 2), (hollow, 0), (both.turned_inside_out(), -2)):
        assert winding_number(surface, point("3/2", "3/2", "3/2")) == inside
    assert winding_number(both, point("1/2", "1", "1")) == 1  # the ray meets edges and corners
    assert winding_number(both, point(1, 1, 1)) is None
    assert winding_number(both, point(1, 1, 0)) is None
    assert winding_number(both, point(1, 1, -1)) == 0
    assert winding_number(both, point(3, 3, -1)) == 0


def test_winding_number_above_every_kind_of_vertex_and_edge() -> None:
    pair = space_pair("star", 9, 30)
    surface = Surface(pair.P)
    for x, y, z in refined_points(pair.P):
        assert surface.winding((x, y, z)) is None
        assert surface.winding((x, y, z - 100)) == 0
        assert surface.winding((x, y, z + 100)) == 0
        assert surface.winding((x / 2, y / 2, z / 2)) == 1  # the origin sees the surface
        assert surface.winding((x * 2, y * 2, z * 2)) == 0


def refined_points(polyhedron: Polyhedron) -> list[Point]:
    from minkref.fuzz.space.laws import refined

    return list(refined(polyhedron).vertices)


def test_fault_names_what_is_wrong() -> None:
    good = cube(ORIGIN, Fraction(1))
    assert good.fault() is None
    assert "occurs 1 times, and 0 times" in str(Polyhedron(good.vertices, good.faces[1:]).fault())
    assert "out of range" in str(Polyhedron(good.vertices[:-1], good.faces).fault())
    bent = (point("1/9", "1/8", "1/7"), *good.vertices[1:])
    assert "is not planar" in str(Polyhedron(bent, good.faces).fault())
    assert "no area" in str(Polyhedron(good.vertices, (*good.faces, (0, 1, 0))).fault())
    assert "no faces" in str(Polyhedron((), ()).fault())
    twin = cube(point(1, 1, 1), Fraction(1))
    corner = {v: k for k, v in enumerate(good.vertices)}
    names = [corner.get(v, k + 8) for k, v in enumerate(twin.vertices)]
    joined = Polyhedron(
        good.vertices + twin.vertices,
        good.faces + tuple(tuple(names[k] for k in face) for face in twin.faces),
    )
    assert "no single fan" in str(joined.fault())
    for text in ('{"vertices":[["1.5","0","0"]],"faces":[]}', '{"vertices":[],"faces":[[0,1,2]]}'):
        with pytest.raises(ValueError):
            Polyhedron.from_json(text)
