"""Right results in space pass, however unusual their spelling."""

from __future__ import annotations

import json
from collections.abc import Callable
from fractions import Fraction

import pytest
from minkref.fuzz.cases.case_name import CaseName
from minkref.fuzz.geometry.polyhedron import Polyhedron
from minkref.fuzz.geometry.space import Point
from minkref.fuzz.run import naming
from minkref.fuzz.space.case import SpaceCase
from minkref.fuzz.space.comparison import compare
from minkref.fuzz.space.pair import Truth
from minkref.fuzz.space.pairs import space_pair
from minkref.fuzz.verdicts.verdict import Reason
from thoroughness import THOROUGH

EPS = Fraction(1, 10**9)


def with_unused_vertices(*places: Fraction) -> Callable[[Polyhedron], Polyhedron]:
    """Adds vertices without a face, before and after the others."""
    points: tuple[Point, ...] = tuple((place, place, -place) for place in places)

    def change(solid: Polyhedron) -> Polyhedron:
        count = len(points)
        faces = tuple(tuple(k + count for k in face) for face in solid.faces)
        return Polyhedron((*points, *solid.vertices, *points), faces)

    return change


def with_repeated_corners(solid: Polyhedron) -> Polyhedron:
    """Repeats each corner of each face."""
    faces = tuple(tuple(k for k in face for _ in (0, 1)) for face in solid.faces)
    return Polyhedron(solid.vertices, faces)


def with_needles(solid: Polyhedron) -> Polyhedron:
    """A vertex amid an edge on one side, and a face without area that fills the seam."""
    first, *others = solid.faces
    a, b = solid.vertices[first[0]], solid.vertices[first[1]]
    middle = ((a[0] + b[0]) / 2, (a[1] + b[1]) / 2, (a[2] + b[2]) / 2)
    new = len(solid.vertices)
    seam = (first[1], new, first[0])
    return Polyhedron((*solid.vertices, middle), ((first[0], new, *first[1:]), *others, seam))


def started_elsewhere(solid: Polyhedron) -> Polyhedron:
    faces = tuple(face[1:] + face[:1] for face in solid.faces)
    return Polyhedron(solid.vertices, faces[::-1])


FORMS = {
    "unused beside": with_unused_vertices(Fraction(0), Fraction(1, 7)),
    "unused far away": with_unused_vertices(Fraction(10**6)),
    "unused beyond all": with_unused_vertices(Fraction(10**40)),
    "unused with a long denominator": with_unused_vertices(Fraction(1, 7**90)),
    "repeated corners": with_repeated_corners,
    "needles": with_needles,
    "other starts": started_elsewhere,
}


FAMILIES = ("polycube", "frame", "prism", "convex", "offset", "torus")


@pytest.mark.parametrize(
    ("family", "form"),
    [
        (family, form)
        for place, family in enumerate(FAMILIES)
        for other, form in enumerate(FORMS)
        if THOROUGH or (place + other) % 3 == 0
    ],
)
def test_right_results_pass_however_they_are_spelled(family: str, form: str) -> None:
    pair = space_pair(family, 3, 13)
    right = pair.sum() if pair.truth is not Truth.POINTS else None
    if right is None:
        return only_points(form)
    spelled = FORMS[form](right)
    answer = compare(pair, spelled)
    assert (answer.verdict, answer.proven) == ("pass", True), answer
    assert compare(pair, spelled, exact=False, tolerance=EPS).verdict == "pass"
    moved = compare(pair, FORMS[form](right.translated((Fraction(1), Fraction(0), Fraction(0)))))
    assert moved.verdict == "wrong"


def only_points(form: str) -> None:
    """For torus + cube, single points alone are known: the operand itself is no sum."""
    pair = space_pair("torus", 3, 13)
    answer = compare(pair, FORMS[form](pair.P))
    assert answer.verdict == "wrong" and Reason.MISSING in answer.reasons


def test_unused_vertices_of_an_operand_are_no_points_of_it() -> None:
    """A cube with a vertex that no face names is convex, with a known sum."""
    name = CaseName("space-offset:1:0", "test")
    case = naming.load(name)
    assert isinstance(case, SpaceCase)
    value = json.loads(case.literal)
    value["P"]["vertices"].append(["1000000", "0", "1/3"])
    spelled = naming.load(CaseName(json.dumps(value), "test"))
    assert isinstance(spelled, SpaceCase)
    assert spelled.pair.truth is Truth.HULL
    assert spelled.pair.hull == case.pair.hull
    assert "non-convex" not in spelled.needs


def test_a_face_without_area_hides_no_face_that_is_not_planar() -> None:
    pair = space_pair("offset", 1, 3)
    right = pair.sum()
    assert right is not None
    first, *others = right.vertices
    bent = Polyhedron(((first[0], first[1] + 1, first[2] + 2), *others), right.faces)
    seam = right.faces[0][:2]
    hidden = Polyhedron(bent.vertices, ((seam[0], seam[1], seam[0]), *bent.faces))
    for result in (bent, hidden):
        answer = compare(pair, result)
        assert answer.reasons == (Reason.NOT_CLOSED,) and "not planar" in answer.message
