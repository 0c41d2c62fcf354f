"""Sums of convex polyhedra: a true certificate by hand is verified; each rule refuses a false one,
and says why."""

from __future__ import annotations

import copy
from collections.abc import Callable
from typing import Any

import cubes
import pytest

Spoil = Callable[[dict[str, Any]], object]
REFUTED, MALFORMED = 1, 2


def test_a_true_one_is_verified(check_value: Any) -> None:
    code, said = check_value(cubes.certificate(), cubes.CASE)
    assert code == 0, said
    assert "8 vertices, 6 facets, volume 8, " + cubes.CLAIM["digest"] in said


def cert(member: str, value: Any) -> Spoil:
    return lambda c: c.__setitem__(member, value)


def of_sum(member: str, value: Any) -> Spoil:
    return lambda c: c["sums"][0].__setitem__(member, value)


def vertex(at: int, value: Any) -> Spoil:
    return lambda c: c["sums"][0]["vertices"].__setitem__(at, value)


def facet(at: int, part: int, value: Any) -> Spoil:
    return lambda c: c["sums"][0]["facets"][at].__setitem__(part, value)


def claim(member: str, value: Any) -> Spoil:
    return lambda c: c["claims"][0].__setitem__(member, value)


def rings(*rings: list[int]) -> Spoil:
    """Other facets, each with the parents that the hand-written one of its plane has, if any."""
    parents = [set(ring) for ring in cubes.RINGS]

    def spoil(c: dict[str, Any]) -> None:
        facets = []
        for ring in rings:
            found = next((p for p in parents if set(ring) <= p), set(ring))
            facets.append([ring, sorted(found), sorted(found)])
        c["sums"][0]["facets"] = facets

    return spoil


def also(*spoils: Spoil) -> Spoil:
    return lambda c: [spoil(c) for spoil in spoils]


A, B, C, D, E, F = cubes.RINGS
# The cube with the corner 7 cut off, a body that lies inside the sum.
CUT = also(
    rings(A, B, C, [1, 5, 3], [2, 3, 6], [3, 5, 6], [4, 6, 5]),
    lambda c: c["sums"][0]["facets"].__setitem__(5, [[3, 5, 6], [7], [7]]),
    lambda c: c["sums"][0]["vertices"].pop(),
)
INSIDE_OUT = rings(*sorted([ring[0], *ring[:0:-1]] for ring in cubes.RINGS))
# A vertex inside the edge from 0 to 1; all numbers after it move by one.
ON_EDGE = also(
    lambda c: c["sums"][0]["vertices"].insert(1, [0, 1]),
    lambda c: c["sums"][0].__setitem__(
        "facets",
        [[[i + (i > 0) for i in ring], sorted(ring), sorted(ring)] for ring in cubes.RINGS],
    ),
    facet(0, 0, [0, 1, 2, 4, 3]),
    lambda c: c["sums"][0]["facets"][2][0].append(1),
)


@pytest.mark.parametrize(
    ("spoil", "code", "why"),
    [
        (cert("certificate", "certificate-v1"), MALFORMED, ""),
        (cert("certificate", "convex-certificate-v2"), MALFORMED, "or disc-sum-certificate-v1,"),
        (cert("proof", []), MALFORMED, "more members"),
        (lambda c: c.pop("sums"), MALFORMED, "a member is missing: sums"),
        (cert("title", 7), MALFORMED, "carries no truth"),
        (lambda c: c["case"].__setitem__("path", 7), MALFORMED, "path of the case"),
        (lambda c: c["case"].__setitem__("path", "nowhere.json"), MALFORMED, "cannot be read"),
        (lambda c: c["case"].__setitem__("path", ".."), MALFORMED, "is in another folder"),
        (lambda c: c["case"].__setitem__("path", "x" * 10**6), MALFORMED, "xx cannot be read: it"),
        (lambda c: c["case"].__setitem__("path", "."), MALFORMED, "path of the case"),
        (lambda c: c["case"].__setitem__("of", ""), MALFORMED, "more members"),
        (lambda c: c["case"].__setitem__("sha256", "0" * 64), REFUTED, "not the case"),
        (lambda c: c["case"].__setitem__("sha256", None), REFUTED, "not the case"),
        (cert("sums", {}), MALFORMED, "a list is missing"),
        (cert("sums", []), MALFORMED, "no number here"),
        (cert("claims", []), MALFORMED, "nothing is claimed"),
        (of_sum("by", []), MALFORMED, "more members"),
        (of_sum("scaling", ["1", "1"]), MALFORMED, "has not 3 entries"),
        (of_sum("scaling", "1"), MALFORMED, "a list is missing"),
        (of_sum("scaling", ["1", "0", "1"]), MALFORMED, "not positive"),
        (of_sum("scaling", ["1", "-1", "1"]), MALFORMED, "not positive"),
        (of_sum("scaling", ["1", "1/0", "1"]), MALFORMED, "is no number"),
        (of_sum("scaling", ["1", True, "1"]), MALFORMED, "is no integer"),
        (of_sum("scaling", ["1", "1", "2"]), REFUTED, "the sum is at another scaling"),
        (vertex(0, [0, 8]), MALFORMED, "no number here"),
        (vertex(0, [8, 0]), MALFORMED, "no number here"),
        (vertex(0, [-1, 0]), MALFORMED, "no number here"),
        (vertex(0, [False, 0]), MALFORMED, "no integer"),
        (vertex(0, ["0", 0]), MALFORMED, "no integer"),
        (vertex(0, [0]), MALFORMED, "has not 2 entries"),
        (vertex(0, [0, 1]), REFUTED, "facet 1: it is not planar"),
        (vertex(7, [7, 3]), REFUTED, "the vertices do not ascend"),
        (vertex(1, [0, 0]), REFUTED, "the vertices do not ascend"),
        (also(vertex(1, [2, 2]), vertex(2, [1, 1])), REFUTED, "the vertices do not ascend"),
        (lambda c: c["sums"][0]["vertices"].append([7, 7]), MALFORMED, "in no facet"),
        (of_sum("facets", []), MALFORMED, "or there is none"),
        (also(of_sum("facets", []), of_sum("vertices", [])), MALFORMED, "or there is none"),
        (facet(0, 0, [0, 1]), MALFORMED, "a facet is no ring"),
        (facet(0, 0, [0, 1, 0, 2]), MALFORMED, "a facet is no ring"),
        (facet(0, 0, [1, 3, 2, 0]), MALFORMED, "does not begin with its least vertex"),
        (facet(0, 0, [0, 1, 3, 8]), MALFORMED, "no number here"),
        (lambda c: c["sums"][0]["facets"][0].append([]), MALFORMED, "has not 3 entries"),
        (rings(B, A, C, D, E, F), MALFORMED, "the facets do not ascend"),
        (rings(A, A, B, C, D, E, F), REFUTED, "not closed"),
        (rings(A, B, C, D, E), REFUTED, "not closed"),
        (facet(0, 0, [0, 2, 3, 1]), REFUTED, "not closed"),
        (facet(0, 0, [0, 1, 2, 3]), REFUTED, "not closed"),
        (rings([0, 1, 3], B, [0, 3, 2], C, D, E, F), REFUTED, "another facet has its normal"),
        (ON_EDGE, REFUTED, "facet 0: it does not turn left"),
        (INSIDE_OUT, REFUTED, "facet 0: the sum reaches beyond its plane"),
        (CUT, REFUTED, "facet 5: the sum reaches beyond its plane"),
        (facet(3, 1, [1, 3, 5]), REFUTED, "facet 3: other vertices"),
        (facet(3, 2, [1, 3, 5]), REFUTED, "facet 3: other vertices"),
        (facet(3, 1, [1, 3, 4, 5, 7]), REFUTED, "facet 3: other vertices"),
        (facet(3, 1, [1, 5, 3, 7]), REFUTED, "facet 3: other vertices"),
        (facet(3, 1, [1, 3, 5, 7, 7]), REFUTED, "facet 3: other vertices"),
        (facet(3, 1, [1, 3, 5, 8]), MALFORMED, "no number here"),
        (facet(3, 2, [True, 3, 5, 7]), MALFORMED, "no integer"),
        (claim("claim", "point"), MALFORMED, "claim"),
        (claim("sum", 1), MALFORMED, "no number here"),
        (claim("sum", "0"), MALFORMED, "no integer"),
        (claim("comment", "?"), MALFORMED, "more members"),
        (claim("scaling", ["1", "2", "1"]), REFUTED, "another scaling"),
        (claim("scaling", 1), MALFORMED, "a list is missing"),
        (claim("vertices", 7), REFUTED, "not so many"),
        (claim("vertices", True), MALFORMED, "no integer"),
        (claim("facets", 12), REFUTED, "not so many"),
        (claim("volume", "27"), REFUTED, "the volume is another"),
        (claim("volume", "-8"), REFUTED, "the volume is another"),
        (claim("volume", "8 m3"), MALFORMED, "no number"),
        (claim("digest", "0" * 64), REFUTED, "the digest is another"),
        (claim("digest", cubes.CLAIM["digest"].upper()), REFUTED, "the digest is another"),
        (claim("digest", None), REFUTED, "the digest is another"),
        (lambda c: c["claims"].append(cubes.CLAIM), MALFORMED, "a claim is made twice"),
        (lambda c: c["sums"].append(cubes.SUM), MALFORMED, "two sums are at one scaling"),
        (lambda c: c["sums"].append(cubes.SUM | {"scaling": ["2/2", "1", 1]}), MALFORMED,
         "two sums are at one scaling"),
        (lambda c: c["sums"].append(TWICE), MALFORMED, "a sum is not used"),
    ],
)  # fmt: skip
def test_a_false_one_is_not(expect_refused: Any, spoil: Spoil, code: int, why: str) -> None:
    expect_refused(cubes.certificate(), cubes.CASE, spoil, code, why)


# Vertices 1 and 2 in each other's places, and all that refers to them.
EXCHANGED = also(
    vertex(1, [2, 2]),
    vertex(2, [1, 1]),
    lambda c: c["sums"][0].__setitem__(
        "facets",
        sorted(
            [from_least([{1: 2, 2: 1}.get(i, i) for i in ring]), sorted(ring), sorted(ring)]
            for ring in cubes.RINGS
        ),
    ),
)


def from_least(ring: list[int]) -> list[int]:
    at = ring.index(min(ring))
    return ring[at:] + ring[:at]


@pytest.mark.parametrize(
    ("spoil", "code", "why"),
    [
        (lambda c: None, 0, "verified"),
        (EXCHANGED, REFUTED, "the vertices do not ascend"),
        (CUT, REFUTED, "facet 5: the sum reaches beyond its plane"),
        (INSIDE_OUT, REFUTED, "facet 0: the sum reaches beyond its plane"),
        (ON_EDGE, REFUTED, "facet 0: it does not turn left"),
        (rings([0, 1, 3], B, [0, 3, 2], C, D, E, F), REFUTED, "another facet has its normal"),
        (rings(A, A, B, C, D, E, F), REFUTED, "not closed"),
        (rings(A, B, C, D, E), REFUTED, "not closed"),
        (rings(A), MALFORMED, "a vertex is in no facet"),
        (rings(B, A, C, D, E, F), MALFORMED, "the facets do not ascend"),
        (facet(5, 0, [5, 4, 6, 7]), MALFORMED, "does not begin with its least vertex"),
        (vertex(0, [0, 1]), REFUTED, "facet 1: it is not planar"),
        (vertex(7, [7, 6]), REFUTED, "it is not planar"),
        (lambda c: c["sums"][0]["vertices"].append([7, 7]), MALFORMED, "in no facet"),
        (facet(3, 1, [1, 3, 5]), REFUTED, "facet 3: other vertices"),
        (lambda c: c["sums"].append(copy.deepcopy(cubes.SUM)), MALFORMED, "at one scaling"),
    ],
)
def test_a_false_sum_is_not_even_if_its_claim_agrees(
    check_value: Any, spoil: Spoil, code: int, why: str
) -> None:
    """Volume, digest and numbers are those of what is given."""
    value = cubes.certificate()
    spoil(value)
    sums = value["sums"]
    value["claims"] = [cubes.claim_about(n, one, cubes.CASE) for n, one in enumerate(sums)]
    got, said = check_value(value, cubes.CASE)
    assert got == code, said
    assert why in said


TWICE = cubes.SUM | {"scaling": ["2", "2", "2"]}


def test_several_scalings(check_value: Any) -> None:
    value = cubes.certificate()
    value["sums"].append(TWICE)
    digest = cubes.digest_of(cubes.in_lowest_terms(cubes.cube_of("3")))
    twice = cubes.CLAIM | {"sum": 1, "scaling": ["2", 2, "4/2"], "volume": 27, "digest": digest}
    value["claims"].append(twice)
    assert check_value(value, cubes.CASE)[0] == 0
    value["claims"].reverse()
    assert check_value(value, cubes.CASE)[0] == 0
    value["claims"][0]["sum"] = 0
    code, said = check_value(value, cubes.CASE)
    assert (code, "another scaling" in said) == (REFUTED, True)


# Operands. P is the cube, spoilt; its digest is right.


def body(vertices: list[Any], faces: list[list[int]]) -> dict[str, Any]:
    return {"vertices": vertices, "faces": faces}


CORNERS = cubes.CUBE["vertices"]
FACES = cubes.RINGS
TETRAHEDRON = [["0", "0", "0"], ["2", "0", "0"], ["0", "2", "0"], ["0", "0", "2"]]
SIDES = [[0, 2, 1], [0, 1, 3], [0, 3, 2], [1, 2, 3]]
MIDDLES = {(0, 1): 4, (0, 2): 5, (0, 3): 6, (1, 2): 7, (1, 3): 8, (2, 3): 9}
HALVES = [[1, 0, 0], [0, 1, 0], [0, 0, 1], [1, 1, 0], [1, 0, 1], [0, 1, 1]]
# The same sides as hexagons, with the middles of their edges.
HEXAGONS = [
    [v for a, b in zip(side, side[1:] + side[:1], strict=True)
     for v in (a, MIDDLES[min(a, b), max(a, b)])]
    for side in SIDES
]  # fmt: skip
FAR = [["5", "0", "0"], ["7", "0", "0"], ["5", "2", "0"], ["5", "0", "2"]]


@pytest.mark.parametrize(
    ("spoilt", "why"),
    [
        (None, "an object with vertices faces is missing"),
        ({"polygons": []}, "a member is missing"),
        (cubes.CUBE | {"colour": 1}, "more members"),
        (body([], []), "a face that is no ring, or none"),
        (body([["0", "0", "0"]], []), "a face that is no ring, or none"),
        (body([*CORNERS[:7], ["1", "1"]], FACES), "has not 3 entries"),
        (body([*CORNERS[:7], ["1", "1", "one"]], FACES), "is no number"),
        (body(CORNERS, [*FACES, [0, 1]]), "a face that is no ring"),
        (body(CORNERS, [*FACES, [0, 1, 0, 2]]), "a face that is no ring"),
        (body(CORNERS, [*FACES, [0, 1, 8]]), "no number here"),
        (body([*CORNERS, ["1/2", "1/2", "1/2"]], FACES), "a vertex in no face"),
        (body([*CORNERS, *FAR[:1]], FACES), "a vertex in no face"),
        (body(CORNERS, FACES[:5]), "P is not closed"),
        (body(CORNERS, [A[::-1], B, C, D, E, F]), "P is not closed"),
        (body(CORNERS, [*FACES, *FACES]), "P is not closed"),
        (body([*CORNERS, *CORNERS], [*FACES, *([i + 8 for i in f] for f in FACES)]),
         "P has a point twice"),
        # An edge from a vertex to itself, between faces that are right.
        (body([*CORNERS, CORNERS[0]], [[0, 8, 1, 3, 2], B, [0, 4, 5, 1, 8], D, E, F]),
         "P has a point twice"),
        (body(CORNERS, [f[::-1] for f in FACES]), "P, face 0: a vertex lies above its plane"),
        (body([*CORNERS, ["0", "0", "1/2"]], [[0, 8, 1, 3, 2], B, C, D, E, F, [0, 1, 8]]),
         "P, face 6: it has no area"),
        (body([*CORNERS[:7], ["1", "1", "2"]], FACES), "P, face 3: it is not planar"),
        # A pit in the top; a peak on it, whose faces are in order, but not the others.
        (body([*CORNERS, ["1/2", "1/2", "1/2"]],
              [A, B, C, E, F, [1, 5, 8], [5, 7, 8], [7, 3, 8], [3, 1, 8]]),
         "P, face 5: a vertex lies above its plane"),
        (body([*TETRAHEDRON, *FAR], [*SIDES, *([i + 4 for i in f] for f in SIDES)]),
         "a vertex lies above its plane"),
        (body([["0", "0", "0"], ["1", "0", "0"], ["1", "1", "0"], ["0", "1", "0"]],
              [[0, 1, 2, 3], [3, 2, 1, 0]]), "P, face 0: all vertices lie in its plane"),
        (body([*TETRAHEDRON, *HALVES], [*SIDES, *HEXAGONS]), "P goes around its hull more than"),
    ],
)  # fmt: skip
def test_a_false_operand_is_refused(check_value: Any, spoilt: Any, why: str) -> None:
    for name, other in ("PQ", "QP"):
        case = {"dimension": 3, name: spoilt, other: cubes.CUBE}
        value = otherwise_true(case)
        code, said = check_value(value, case)
        assert code == MALFORMED, said
        assert why.replace("P", name) in said


def otherwise_true(case: dict[str, Any]) -> dict[str, Any]:
    """The certificate of the sum of the hulls of the vertices, where they have one."""
    try:
        P, Q = (cubes.polyhedron(case[name]) for name in "PQ")
        return cubes.certificate_of(P, Q, [cubes.whole_scaling(1, 1, 1)])
    except (TypeError, KeyError, ValueError):
        return cubes.certificate()


@pytest.mark.parametrize("dimension", [None, 2, "3", 3.0, True, [3]])
def test_a_case_that_is_not_in_space_is_refused(check_value: Any, dimension: Any) -> None:
    case = cubes.CASE | {"dimension": dimension}
    code, said = check_value(cubes.certificate(), case)
    assert (code, "no case in space" in said) == (MALFORMED, True)


def test_numbers_of_a_case_may_be_written_otherwise(check_value: Any) -> None:
    case = copy.deepcopy(cubes.CASE) | {"title": "?"}
    case["Q"]["vertices"][7] = [1, 1.0, "10e-1"]
    assert check_value(cubes.certificate(), case)[0] == 0


TOP = {
    "two triangles": ([], [[1, 5, 7], [1, 7, 3]], [[]]),
    "four triangles": ([["1/2", "1/2", "1"]], [[1, 5, 8], [5, 7, 8], [7, 3, 8], [3, 1, 8]], [[8]]),
    "a dart": ([["1/4", "1/4", "1"]], [[1, 5, 8, 3], [3, 8, 5, 7]], [[8]]),
}


@pytest.mark.parametrize("name", TOP)
def test_faces_in_one_plane_and_flat_vertices(check_value: Any, name: str) -> None:
    """The top of P is given in parts. All vertices in its plane are parents of the sum's top."""
    more, parts, ((*flat,),) = TOP[name]
    case = cubes.CASE | {"P": body([*CORNERS, *more], [A, B, C, *parts, E, F])}
    value = cubes.certificate()
    value["case"]["sha256"] = cubes.digest_of_case(case)
    assert check_value(value, case)[0] == (REFUTED if flat else 0)
    value["sums"][0]["facets"][3][1] += flat
    code, said = check_value(value, case)
    assert code == 0, said
