"""Right results pass whatever their form; wrong results are found, with a witness."""

from __future__ import annotations

import random
from dataclasses import replace
from fractions import Fraction
from functools import cache
from itertools import product

import pytest
from members import turn
from minkref.fuzz.geometry.polyhedron import Polyhedron
from minkref.fuzz.geometry.space import Point
from minkref.fuzz.space.cells import surface_of
from minkref.fuzz.space.comparison import compare
from minkref.fuzz.space.generators.convex import cube
from minkref.fuzz.space.generators.torus import torus
from minkref.fuzz.space.hull import convex_hull, sum_of_convex
from minkref.fuzz.space.laws import refined
from minkref.fuzz.space.pair import SpacePair, Truth
from minkref.fuzz.space.pairs import pair_of_cells, space_pair
from minkref.fuzz.space.witness import holds
from minkref.fuzz.verdicts.verdict import Reason, Witness
from thoroughness import THOROUGH, draws

KNOWN = (
    "polycube",
    "hollow",
    "frame",
    "l-prism",
    "prism",
    "convex",
    "sphere",
    "round",
    "thin",
    "offset",
)
EPS = Fraction(1, 10**9)
NOTHING = Polyhedron((), ())


def total(pair: SpacePair) -> Polyhedron:
    found = pair.sum()
    assert found is not None
    return found


@cache
def pairs_of(family: str) -> list[SpacePair]:
    """Up to three pairs of a family; only the pair whose sum has fewest triangles, if few are
    drawn."""
    pairs: list[SpacePair] = []
    for index in (1, 13, 40):
        pair = space_pair(family, 3, index)
        try:
            if len(total(pair).triangles) < 400:
                pairs.append(pair)
        except ValueError:
            continue  # rings of the region touch
    assert pairs
    return sorted(pairs, key=lambda pair: len(total(pair).triangles))[: draws(1, 3)]


def in_triangles(polyhedron: Polyhedron) -> Polyhedron:
    return Polyhedron(polyhedron.vertices, polyhedron.triangles)


def without_common_vertices(polyhedron: Polyhedron) -> Polyhedron:
    """Gives every triangle separate vertices, as STL does."""
    vertices = [polyhedron.vertices[k] for face in polyhedron.triangles for k in face]
    count = len(polyhedron.triangles)
    return Polyhedron(tuple(vertices), tuple((3 * k, 3 * k + 1, 3 * k + 2) for k in range(count)))


def with_one_face_split(polyhedron: Polyhedron) -> Polyhedron:
    """Splits one face at a new vertex on an edge; the face's neighbour stays whole."""
    face = polyhedron.faces[0]
    a, b = polyhedron.vertices[face[0]], polyhedron.vertices[face[1]]
    middle = tuple((a[k] + b[k]) / 2 for k in range(3))
    new = len(polyhedron.vertices)
    return Polyhedron(
        (*polyhedron.vertices, middle),  # type: ignore[arg-type]
        ((face[0], new, *face[2:]), (new, *face[1:3]), *polyhedron.faces[1:]),
    )


@pytest.mark.parametrize("family", KNOWN)
def test_right_results_pass_in_every_form(family: str) -> None:
    for pair in pairs_of(family):
        right = total(pair)
        forms = (
            right,
            in_triangles(right),
            refined(right),
            refined(refined(right)) if len(right.triangles) < 30 else right,
            without_common_vertices(right),
            with_one_face_split(right),
            right.with_faces_of(right),
            in_triangles(right).with_faces_of(refined(right)),
            right.with_faces_of(right).with_faces_of(right.turned_inside_out()),
        )
        for form in forms:
            answer = compare(pair, form)
            assert (answer.verdict, answer.proven) == ("pass", True), answer
        for form in turn(forms, KNOWN.index(family) % 3, 3):
            assert compare(pair, form, exact=False, tolerance=EPS).verdict == "pass"


def test_coplanar_faces_merged_to_large_ones_pass() -> None:
    pair = pair_of_cells(
        "l", frozenset({(0, 0, 0), (1, 0, 0)}), frozenset({(4, 4, 4)}), Fraction(1)
    )
    low = (Fraction(4), Fraction(4), Fraction(4))
    merged = convex_hull(product((low[0], low[0] + 3), (low[1], low[1] + 2), (low[2], low[2] + 2)))
    assert len(merged.faces) == 6 and compare(pair, merged).proven


def test_shells_inside_the_result_pass_even_if_they_lie_askew() -> None:
    pair = space_pair("hollow", 3, 1)
    right = total(pair)
    askew = torus(5, 3, Fraction(1, 5), Fraction(1, 9))
    x, y, z = (number + Fraction(1, 2) for number in right.box[0])
    inner = askew.translated((x, y, z))
    for form in (
        right.with_faces_of(inner),
        right.with_faces_of(inner).with_faces_of(inner.turned_inside_out()),
    ):
        answer = compare(pair, form)
        assert answer.verdict == "pass" and answer.proven
    hollowed = compare(pair, right.with_faces_of(inner.turned_inside_out()))
    assert hollowed.verdict == "wrong" and hollowed.reasons == (Reason.MISSING,)
    for family in ("prism", "convex"):
        pair = space_pair(family, 3, 24)
        right = total(pair)
        centre = tuple(sum(v[k] for v in right.vertices) / len(right.vertices) for k in range(3))
        if not pair.meeting.meets(centre):  # type: ignore[arg-type]
            continue
        small = askew.scaled(Fraction(1, 50)).translated(centre)  # type: ignore[arg-type]
        assert compare(pair, right.with_faces_of(small)).proven
        answer = compare(pair, right.with_faces_of(small.turned_inside_out()))
        assert answer.verdict == "wrong" and answer.reasons == (Reason.MISSING,)


def assert_wrong(
    pair: SpacePair, result: Polyhedron, *reasons: Reason, tolerance: Fraction | None = None
) -> None:
    answer = compare(pair, result, tolerance is None, tolerance or Fraction(0))
    assert answer.verdict == "wrong", (pair.family, answer)
    assert answer.witness is not None
    assert holds(pair.P, pair.Q, pair.scale, answer.witness)
    if reasons:
        assert set(answer.reasons) == set(reasons), (pair.family, answer)
    lie = replace(answer.witness, in_truth=not answer.witness.in_truth)
    assert not holds(pair.P, pair.Q, pair.scale, lie)


@pytest.mark.parametrize(
    ("family", "tolerance"),
    [
        (family, tolerance)
        for place, family in enumerate(KNOWN)
        for tolerance in turn((None, EPS), place % 2, 2)
    ],
)
def test_wrong_results_are_found(family: str, tolerance: Fraction | None) -> None:
    for pair in pairs_of(family):
        right = total(pair)
        one = (Fraction(1), Fraction(0), Fraction(0))
        assert_wrong(pair, NOTHING, tolerance=tolerance)
        assert_wrong(pair, right.turned_inside_out(), tolerance=tolerance)
        assert_wrong(pair, right.translated(one), tolerance=tolerance)
        assert_wrong(pair, right.scaled(Fraction(99, 100)), tolerance=tolerance)
        assert_wrong(pair, right.scaled(Fraction(101, 100)), tolerance=tolerance)
        far = (Fraction(0), Fraction(10**7), Fraction(0))
        stray = cube(far, Fraction(1))
        if pair.truth is not Truth.CELLS:  # there the grid would be too large
            united = right.with_faces_of(stray)
            assert_wrong(pair, united, Reason.EXTRA, tolerance=tolerance)
        opened = Polyhedron(right.vertices, right.faces[1:])
        assert_wrong(pair, opened, Reason.NOT_CLOSED, tolerance=tolerance)


@pytest.mark.parametrize("tolerance", [None, EPS])
@pytest.mark.parametrize("family", ["polycube", "hollow", "frame", "l-prism"])
def test_results_wrong_by_a_cell_are_found(family: str, tolerance: Fraction | None) -> None:
    for pair in pairs_of(family):
        known = pair.cell_sum
        dice = random.Random(family)
        for _ in range(3):
            x, y, z = dice.choice(sorted(known.cells))
            less = replace(known, cells=known.cells - {(x, y, z)}).polyhedron()
            assert_wrong(pair, less, tolerance=tolerance)
            beside = next((a, y, z) for a in range(x, x + 99) if (a, y, z) not in known.cells)
            more = replace(known, cells=known.cells | {beside}).polyhedron()
            assert_wrong(pair, more, tolerance=tolerance)


def test_faults_of_cells_have_their_names() -> None:
    box = frozenset(product(range(5), range(5), range(5)))
    hollow = box - frozenset(product(range(1, 4), range(1, 4), range(1, 4)))
    pair = pair_of_cells("named", hollow, frozenset({(9, 9, 9)}), Fraction(1))
    known = pair.cell_sum
    inside = frozenset(product(range(11, 13), range(11, 13), range(11, 13)))
    assert known.cells.isdisjoint(inside)

    def with_cells(cells: frozenset[tuple[int, int, int]]) -> Polyhedron:
        return replace(known, cells=cells).polyhedron()

    assert_wrong(pair, with_cells(known.cells | inside), Reason.HOLE_LOST)
    assert_wrong(pair, with_cells(known.cells | {(30, 0, 0)}), Reason.COMPONENT)
    assert_wrong(pair, with_cells(known.cells - {(9, 9, 9)}), Reason.MISSING)
    assert_wrong(pair, with_cells(known.cells | {(8, 9, 9)}), Reason.EXTRA)
    assert_wrong(
        pair, with_cells(known.cells - {(9, 9, 9)} | {(8, 12, 12)}), Reason.EXTRA, Reason.MISSING
    )
    solid = pair_of_cells("solid", box, frozenset({(0, 0, 0)}), Fraction(1))
    hole = replace(solid.cell_sum, cells=solid.cell_sum.cells - {(2, 2, 2)}).polyhedron()
    assert_wrong(solid, hole, Reason.HOLE_INVENTED)


@pytest.mark.parametrize("family", ["l-prism", "offset", "polycube"])
def test_the_copy_of_an_operand_beside_the_sum_is_found(family: str) -> None:
    for pair in pairs_of(family):
        united = total(pair).with_faces_of(pair.meeting.sP)
        answer = compare(pair, united)
        if all(pair.meeting.meets(vertex) for vertex in pair.meeting.sP.vertices):
            continue
        assert answer.verdict == "wrong"
        assert not {Reason.EXTRA, Reason.COMPONENT}.isdisjoint(answer.reasons)
    cells = pair_of_cells(
        "l",
        frozenset({(10, 10, 10), (11, 10, 10), (10, 11, 10)}),
        frozenset({(3, 0, 0)}),
        Fraction(1),
    )
    assert_wrong(cells, total(cells).with_faces_of(cells.P), Reason.COMPONENT)


def nudged(polyhedron: Polyhedron, size: Fraction, seed: int) -> Polyhedron:
    dice = random.Random(seed)
    vertices = tuple(
        tuple(number + size * Fraction(dice.randint(-99, 99), 100) for number in vertex)
        for vertex in polyhedron.vertices
    )
    return Polyhedron(vertices, polyhedron.triangles)  # type: ignore[arg-type]


@pytest.mark.parametrize("family", turn(KNOWN, 1, 2))
def test_results_within_the_tolerance_pass_and_others_do_not(family: str) -> None:
    for pair in pairs_of(family):
        right = total(pair)
        near = nudged(right, EPS, 1)
        assert compare(pair, near, exact=False, tolerance=EPS).verdict == "pass-within"
        assert compare(pair, near, exact=True).verdict == "wrong"
        if family != "offset":
            far = right.scaled(1 + 40 * EPS).translated((EPS * 40, EPS * 40, -EPS * 40))
            assert_wrong(pair, far, tolerance=EPS)


def shells(P: list[Polyhedron], Q: list[Polyhedron], scale: Fraction) -> Polyhedron:
    """The sum of unions of convex pieces, as overlapping shells."""
    result = NOTHING
    for p in P:
        for q in Q:
            result = result.with_faces_of(sum_of_convex(p, q, scale))
    return result


def cones(star: Polyhedron) -> list[Polyhedron]:
    origin: Point = (Fraction(0),) * 3  # type: ignore[assignment]
    return [
        convex_hull([origin, *(star.vertices[k] for k in triangle)]) for triangle in star.triangles
    ]


def segments(ring: Polyhedron, section: int) -> list[Polyhedron]:
    count = len(ring.vertices)
    return [
        convex_hull(ring.vertices[(k + j) % count] for j in range(2 * section))
        for k in range(0, count, section)
    ]


def torus_pair(side: Fraction) -> tuple[SpacePair, Polyhedron]:
    P = torus(6, 4, Fraction(3), Fraction(1))
    half = -side / 2
    Q = cube((half, half, half), side)
    right = shells(segments(P, 4), [Q], Fraction(1))
    return SpacePair(P, Q, Fraction(1), "torus"), right


@pytest.mark.parametrize("side", [Fraction(1), Fraction(6)])
def test_sum_of_a_torus_from_overlapping_shells_passes_and_its_hole_counts(side: Fraction) -> None:
    pair, right = torus_pair(side)
    assert compare(pair, right).verdict == "pass"
    assert compare(pair, nudged(right, EPS, 2), False, EPS).verdict == "pass-within"
    solid = convex_hull(right.vertices)
    assert_wrong(pair, solid, Reason.EXTRA) if side == 1 else None
    for tolerance in (None, EPS) if THOROUGH else (None if side == 1 else EPS,):
        assert_wrong(pair, pair.P, tolerance=tolerance)
        assert_wrong(pair, right.scaled(Fraction(101, 100)), tolerance=tolerance)
        assert_wrong(pair, right.turned_inside_out(), Reason.MISSING, tolerance=tolerance)


@pytest.mark.thorough
@pytest.mark.parametrize("index", [0, 20])
def test_sum_of_two_stars_from_overlapping_shells_passes(index: int) -> None:
    """Repeats test_sum_of_a_torus_from_overlapping_shells_passes_and_its_hole_counts for two
    stars."""
    pair = next(
        pair
        for k in range(index, 999)
        if (pair := space_pair("star", 2, k)).Q.box[0][2] < 0  # the second is a star too
    )
    right = shells(cones(pair.P), cones(pair.Q), Fraction(1))
    assert compare(pair, right).verdict == "pass"
    assert compare(pair, nudged(right, EPS, 3), False, EPS).verdict == "pass-within"
    for tolerance in (None, EPS):
        assert_wrong(pair, pair.P, tolerance=tolerance)
        if index == 20:
            solid = convex_hull(right.vertices)
            assert_wrong(pair, solid, Reason.EXTRA, tolerance=tolerance)


def test_a_face_that_is_not_planar_is_named_in_an_exact_result_only() -> None:
    pair = space_pair("offset", 1, 3)
    right = total(pair)
    bent = nudged(right, EPS, 4)
    whole_faces = Polyhedron(bent.vertices, right.faces)
    answer = compare(pair, whole_faces)
    assert answer.reasons == (Reason.NOT_CLOSED,) and "not planar" in answer.message
    assert compare(pair, whole_faces, False, EPS * 2).verdict == "pass-within"


def test_negative_tolerance_is_refused() -> None:
    pair = space_pair("offset", 1, 0)
    with pytest.raises(ValueError, match="negative"):
        compare(pair, NOTHING, False, Fraction(-1))


def test_a_witness_that_lies_does_not_hold() -> None:
    block = surface_of(frozenset({(0, 0, 0), (1, 0, 0), (0, 1, 0)}))
    unit = cube((Fraction(0),) * 3, Fraction(1))  # type: ignore[arg-type]
    one = Fraction(1)
    inside = Witness(("1", "1", "1"), True, ("1/2", "1/2", "1/2"), ("1/2", "1/2", "1/2"))
    assert holds(block, unit, one, inside)
    assert holds(block, unit, one, inside, Fraction(2, 5))
    assert not holds(block, unit, one, inside, Fraction(1, 2))
    assert not holds(block, unit, Fraction(2), inside)
    assert not holds(block, unit, one, replace(inside, p=("1/2", "1/2", "3/4")))
    assert not holds(
        block, unit, one, replace(inside, p=("3", "1/2", "1/2"), q=("-2", "1/2", "1/2"))
    )
    assert not holds(block, unit, one, Witness(("1", "1", "1"), False))
    outside = Witness(("5/2", "5/2", "1"), False)
    assert holds(block, unit, one, outside)
    assert holds(block, unit, one, outside, Fraction(49, 100))
    assert not holds(block, unit, one, outside, Fraction(1, 2))
    assert not holds(block, unit, one, Witness(("2", "5/2", "1"), False))  # on the boundary
    assert not holds(block, unit, one, replace(outside, in_truth=True))


@pytest.mark.parametrize("swapped", [False, True])
def test_a_cavity_that_is_filled_is_found_where_points_alone_are_known(swapped: bool) -> None:
    """The cavity takes a thousandth of the volume, and no face of the result comes near."""
    block = frozenset(product(range(5), repeat=3))
    hollow = surface_of(block - {(2, 2, 2)})
    half = cube((Fraction(0),) * 3, Fraction(1, 2))
    P, Q = (half, hollow) if swapped else (hollow, half)
    filled = cube((Fraction(0),) * 3, Fraction(11, 2))
    found = compare(SpacePair(P, Q, Fraction(1), "named"), filled)
    assert found.verdict == "wrong" and found.reasons == (Reason.EXTRA,)
