"""Degenerate families in space: each member keeps its family's promise, by predicates computed here
from the case file alone; has a certificate that both checkers follow and the sum that an
independent hull finds; and has the same bytes every time."""

from __future__ import annotations

import json
from fractions import Fraction
from functools import cache
from itertools import permutations, product
from pathlib import Path
from typing import Any

import jsonschema
import pytest
from members import Vector, assert_made_again, cross, dot, faults_of_spoilt, minus, turn
from minkref.degeneracies import lint
from minkref.degeneracies.catalogue import FAMILIES, SPACE_FAMILIES, made_member
from minkref.degeneracies.invalid.catalogue import INVALID_FAMILIES, INVALID_MESH_FAMILIES
from minkref.degeneracies.make_corpus import SEED as CORPUS_SEED
from minkref.degeneracies.space.bodies import hull, orbit
from minkref.degeneracies.space.case_document import SHOWN, DegenerateInSpace
from minkref.degeneracies.space.outline import SPACE
from minkref.degeneracies.space.shapes import SOLIDS
from minkref.degeneracies.space.vectors import vector
from minkref.exact import digest
from minkref.fuzz.geometry.polyhedron import Polyhedron
from minkref.fuzz.geometry.space import Point
from minkref.fuzz.plane.families.catalogue import FAMILIES as FUZZED
from minkref.fuzz.space.families import SPACE_FAMILIES as FUZZED_IN_SPACE
from minkref.fuzz.space.hull import convex_hull, sum_of_convex
from minkref.reports.evidence.certificates.checkers import in_cpp, in_python, verdicts
from thoroughness import THOROUGH, draws

SEED = 907
COUNT = 8
#: Families whose first few members do not show everything that the family does.
VARIED = {"all-facets-change-no-edges", "facets-nearly-parallel", "magnitudes-in-space"}
SIBLINGS = 5  # the scaling, and two on each side


@cache
def documents(name: str) -> list[Any]:
    """Case documents read from files: the corpus's if few are drawn."""
    if not THOROUGH and name not in VARIED:
        paths = lint.case_paths(lint.CORPUS / name)
        return [json.loads(path.read_text(encoding="utf-8")) for path in paths]
    print(f"{name} --seed {SEED}")
    made = [DegenerateInSpace.of(SPACE_FAMILIES[name], SEED, k) for k in range(COUNT)]
    return [json.loads(each.case_text) for each in made]


def points(value: Any, name: str) -> list[Vector]:
    return [vector(*map(Fraction, row)) for row in value[name]["vertices"]]


def scaling(texts: list[str]) -> Point:
    return vector(*map(Fraction, texts))


def scaled(vertices: list[Vector], s: Point) -> list[Vector]:
    return [(x * s[0], y * s[1], z * s[2]) for x, y, z in vertices]


def normal(vertices: list[Vector], face: list[int]) -> Vector:
    """The outward normal of a plane through three corners with all vertices on one side."""
    a, *others = (vertices[k] for k in face)
    n = next(n for b in others for c in others if any(n := cross(minus(b, a), minus(c, a))))
    heights = {(h > 0) - (h < 0) for v in vertices for h in [dot(n, minus(v, a))]}
    assert heights == {0, -1} or heights == {0, 1}, "this is no facet"
    return n if 1 not in heights else (-n[0], -n[1], -n[2])


def along(vertices: list[Vector], face: list[int]) -> Vector:
    a, b = sorted(vertices[k] for k in face)
    return minus(b, a)


def sign(row: Any, P: list[Vector], Q: list[Vector]) -> int:
    """Sign of the predicate that a row names, for SP and Q."""
    if row["what"] == "compatible":
        facet, (vertex,), n_of, v_of = (
            (row["P"], row["Q"], P, Q) if len(row["Q"]) == 1 else (row["Q"], row["P"], Q, P)
        )
        n = normal(n_of, facet)
        return int(any(dot(n, v) > dot(n, v_of[vertex]) for v in v_of))
    first, second = (
        along(body, row[name]) if len(row[name]) == 2 else normal(body, row[name])
        for name, body in (("P", P), ("Q", Q))
    )
    if row["what"] in ("facet-and-edge", "edge-and-facet"):
        value = dot(first, second)
        return (value > 0) - (value < 0)
    if row["what"] == "parallel-facets" and cross(first, second) == (0, 0, 0):
        assert dot(first, second) > 0
    if row["what"] == "opposite-facets" and cross(first, second) == (0, 0, 0):
        assert dot(first, second) < 0
    return int(cross(first, second) != (0, 0, 0))


def facets(value: Any, k: int = 0) -> Any:
    return value["degeneracy"]["facets"][k]


def meet(value: Any, k: int = 0) -> int:
    row = facets(value, k)
    return int(row["facet_and_facet"] + row["facet_and_edge"])


def test_members_are_certified_as_expected(tmp_path: Path) -> None:
    rows = [
        made_member(SPACE_FAMILIES[name], SEED, k).write(tmp_path)
        for name in turn(SPACE_FAMILIES, 0, 4)
        for k in range(draws(1, 3))
    ]
    assert not list(lint.faults(tmp_path))
    files = [Path(str(row["certificate"])) for row in rows]
    for command in (in_python(), in_cpp()):
        assert {verdict.code for verdict in verdicts(command, files)} == {0}


@pytest.mark.parametrize("name", SPACE_FAMILIES)
def test_the_members_of_the_corpus_are_made_again(name: str) -> None:
    family, folder = SPACE_FAMILIES[name], lint.CORPUS / name
    assert_made_again(folder, SPACE.count, lambda k: made_member(family, CORPUS_SEED, k))


@pytest.mark.parametrize(
    ("spoil", "fault"),
    [
        (lambda v: v.pop("flags"), "flags is missing"),
        (lambda v: v["flags"].append("sparkling"), "not explained"),
        (lambda v: v["flags"].append("tight-passage"), "not explained"),
        (lambda v: v["flags"].append("thin-body"), "flags is not what"),
        (lambda v: v["flags"].pop(), "flags is not what"),
        (lambda v: v["expected"][0].__setitem__("facets", 7), "not certified"),
        (lambda v: v["expected"][0].__setitem__("volume", "1"), "not certified"),
        (lambda v: v["scales"].pop(), "id is not"),
        (lambda v: v["P"]["faces"].pop(), "edge"),
        (lambda v: v["degeneracy"].__setitem__("floats", []), "floats of degeneracy is not what"),
    ],
)
def test_lint_finds_what_is_wrong_in_space(tmp_path: Path, spoil: Any, fault: str) -> None:
    found = faults_of_spoilt(tmp_path, SPACE_FAMILIES["with-itself"], SEED, spoil)
    assert any(fault in line for line in found), found


@pytest.mark.parametrize("name", SPACE_FAMILIES)
def test_the_sum_is_that_of_the_independent_hull(name: str) -> None:
    for number, value in enumerate(documents(name)):
        P, Q = (Polyhedron.from_document(value[each]) for each in "PQ")
        for expected in value["expected"][number % 4 :: draws(4, 1)]:
            found = sum_of_convex(P, Q, scaling(expected["scale"]))
            text = json.dumps(
                {"faces": found.document()["faces"], "vertices": found.document()["vertices"]},
                separators=(",", ":"),
            )
            assert digest(text) == expected["digest"], value["id"]
            assert len(found.vertices) == expected["vertices"]
            assert (len(found.faces), str(found.volume)) == (expected["facets"], expected["volume"])


@pytest.mark.parametrize("name", SPACE_FAMILIES)
def test_what_is_shown_holds(name: str) -> None:
    """Each predicate has the signs that the case file states."""
    for value in documents(name):
        P, Q = points(value, "P"), points(value, "Q")
        rows = value["degeneracy"]["coincidences"]
        assert 0 < len(rows) <= SHOWN
        for row in rows:
            bodies = [scaled(P, scaling(at)) for at in value["scales"]]
            assert row["signs"] == [sign(row, body, Q) for body in bodies], (value["id"], row)


ALWAYS = {
    "facets-parallel-always": "facet_and_facet",
    "facet-along-edge-always": "facet_and_edge",
    "edges-parallel-always": "parallel_edges",
}
AT_A_SCALING = {
    "facets-parallel-at-a-scaling": "facet_and_facet",
    "facet-along-edge-at-a-scaling": "facet_and_edge",
    "edges-parallel-at-a-scaling": "parallel_edges",
}


@pytest.mark.parametrize("name", ALWAYS)
def test_what_is_parallel_at_every_scaling(name: str) -> None:
    """Edges and facets stay parallel at unrelated scalings, and at many more."""
    for value in documents(name):
        assert len(value["scales"]) > SIBLINGS
        assert all(row[ALWAYS[name]] > 0 for row in value["degeneracy"]["facets"])
        P, Q = points(value, "P"), points(value, "Q")
        for row in value["degeneracy"]["coincidences"]:
            assert set(row["signs"]) == {0}
            for s in product(map(Fraction, ("1/1000003", "7", "10000019")), repeat=3):
                assert sign(row, scaled(P, s), Q) == 0


@pytest.mark.parametrize("name", AT_A_SCALING)
def test_what_is_parallel_at_one_scaling_only(name: str) -> None:
    """Nothing is parallel beside the scaling, not even within 2^-60 of the factor."""
    for value in documents(name):
        counts = [row[AT_A_SCALING[name]] for row in value["degeneracy"]["facets"]]
        assert counts[0] > 0 and set(counts[1:]) == {0}
        for row in value["degeneracy"]["coincidences"]:
            assert row["signs"][0] == 0 and 0 not in row["signs"][1:]
        if name != "facets-parallel-at-a-scaling":
            assert facets(value)["facet_and_facet"] == 0


@pytest.mark.parametrize("name", SPACE_FAMILIES)
def test_siblings_are_on_both_sides_and_near(name: str) -> None:
    for value in documents(name):
        at, *others = map(scaling, value["scales"])
        steps = [minus(each, at) for each in others]
        one_axis = [d for d in steps if sum(c != 0 for c in d) == 1 and abs(sum(d)) < 1]
        assert {sum(d) > 0 for d in one_axis} == {True, False}
        # unless the nearest critical factor is nearer still, or the factor itself is huge
        (axis,) = {next(k for k in range(3) if d[k]) for d in one_axis[:2]}
        fine = min(abs(sum(d)) for d in one_axis)
        assert fine <= max(at[axis] / 2**58, Fraction(1, 2)), value["id"]
        assert fine < at[axis]


def test_an_arc_elsewhere_changes_nothing() -> None:
    """Just below, at, and just above the scaling, each kind has equally many facets."""
    for value in documents("great-circle-through-normal"):
        rows = [dict(facets(value, k), scale=0) for k in range(SIBLINGS)]
        assert all(row == rows[0] for row in rows)
        for row in value["degeneracy"]["coincidences"]:
            assert row["signs"][0] == 0 and set(row["signs"][1:]) <= {-1, 1}
            assert len(set(row["signs"])) == 3


def test_a_body_and_itself() -> None:
    for value in documents("with-itself"):
        P, Q = sorted(points(value, "P")), sorted(points(value, "Q"))
        assert len({minus(q, p) for p, q in zip(P, Q, strict=True)}) == 1
        factors = value["degeneracy"]["at"]
        assert len(set(factors)) == 1
        clean = convex_hull(P)
        assert (
            value["expected"][0]["facets"] == len(clean.faces) == facets(value)["facet_and_facet"]
        )
        volume = (1 + Fraction(factors[0])) ** 3 * clean.volume
        assert Fraction(value["expected"][0]["volume"]) == volume


def test_a_body_and_its_reflection() -> None:
    for value in documents("with-its-reflection"):
        P, Q = sorted(points(value, "P")), sorted(points(value, "Q"), reverse=True)
        assert (
            len({(p[0] + q[0], p[1] + q[1], p[2] + q[2]) for p, q in zip(P, Q, strict=True)}) == 1
        )
        back = sorted((-x, -y, -z) for x, y, z in P)
        assert len({minus(a, b) for a, b in zip(back, P, strict=True)}) > 1
        if value["degeneracy"]["at"] == ["1", "1", "1"]:
            result = [tuple(map(Fraction, v)) for v in value["expected"][0].get("result", {}).get(
                "vertices", [])]  # fmt: skip
            sums = {minus(a, tuple(-c for c in b)) for a, b in zip(  # type: ignore[arg-type]
                result, result[::-1], strict=True)}  # fmt: skip
            assert len(sums) <= 1


def test_facets_nearly_parallel_are_two_and_doubles_are_wrong() -> None:
    angles = set()
    for value in documents("facets-nearly-parallel"):
        P, Q = scaled(points(value, "P"), scaling(value["scales"][0])), points(value, "Q")
        assert value["degeneracy"]["floats"][0]["wrong_in_doubles"] > 0
        for row in value["degeneracy"]["coincidences"]:
            m, n = normal(P, row["P"]), normal(Q, row["Q"])
            across = cross(m, n)
            square = dot(across, across) / dot(m, n) ** 2  # of the tangent
            assert 0 < square < Fraction(1, 4**20) and dot(m, n) > 0
            angles.add((square.denominator.bit_length() - square.numerator.bit_length()) // 2)
    assert min(angles) < 60 and max(angles) > 120


def test_magnitudes() -> None:
    seen = set()
    for value in documents("magnitudes-in-space"):
        numbers = [abs(c) for name in "PQ" for p in points(value, name) for c in p if c]
        factors = [c for c in scaling(value["scales"][0])]
        seen |= {max(numbers) > 10**285, min(numbers) < Fraction(1, 10**285)}
        assert max(numbers) < Fraction(2) ** 1023 and min(numbers) > Fraction(1, 10**310)
        assert all(Fraction(1, 10**310) < f < Fraction(10) ** 310 for f in factors)
        extremes = [max(c, 1 / c) for c in (*numbers, *factors)]
        assert max(extremes) > 10**250 and meet(value) > 0
        assert value["degeneracy"]["floats"][0]["wrong_in_doubles"] > 0
    assert seen == {True, False}


def test_bodies_far_out() -> None:
    for value in documents("bodies-far-out"):
        for name in "PQ":
            body = points(value, name)
            assert min(abs(c) for p in body for c in p) > 10**13
        assert meet(value) > 0 and value["degeneracy"]["floats"][0]["wrong_in_doubles"] > 0


def test_needles_and_plates() -> None:
    """Expects a needle, with all vertices within a millionth of its length of the line between two,
    and a plate, a million times less wide across a facet than long, with a plate's volume."""
    for value in documents("needle-and-plate"):
        kinds = set()
        for name in "PQ":
            body = points(value, name)
            a, b = max(product(body, repeat=2), key=lambda ends: dot(*[minus(*ends)] * 2))
            d = minus(b, a)
            square = dot(d, d)
            girth = max(dot(c, c) for v in body for c in [cross(d, minus(v, a))]) / square
            solid = convex_hull(body)
            widths = []
            for face in solid.faces:
                n = normal(list(solid.vertices), list(face))
                heights = [dot(n, v) for v in body]
                widths.append((max(heights) - min(heights)) ** 2 / dot(n, n))
            thin = min(widths) * 10**12 < square
            if girth * 10**12 < square:
                kinds.add("needle")
            elif thin and solid.volume**2 * 10**4 > min(widths) * square**2:
                kinds.add("plate")
        assert kinds == {"needle", "plate"} and meet(value) > 0


def test_pyramids_and_prisms() -> None:
    for value in documents("many-facets-at-a-vertex"):
        counts = []
        for name in "PQ":
            corners = [k for face in convex_hull(points(value, name)).faces for k in face]
            counts.append(max(corners.count(k) for k in corners))
        assert max(counts) >= 8
    for value in documents("many-sided-facets"):
        row = value["degeneracy"]["coincidences"][0]
        assert row["what"] == "parallel-facets" and min(len(row["P"]), len(row["Q"])) >= 8
    large = DegenerateInSpace.of(SPACE_FAMILIES["many-sided-facets"], SEED, 0, 120)
    assert max(len(large.document["P"]["vertices"]), len(large.document["Q"]["vertices"])) >= 40


def test_symmetric_bodies_and_the_solids() -> None:
    assert [len(hull(orbit([vector(*p) for p in corners], mirrored)).faces)
            for corners, mirrored in SOLIDS] == [4, 6, 8, 14, 12, 20, 12, 14]  # fmt: skip
    for value in documents("symmetric-bodies"):
        for name in "PQ":
            body = set(points(value, name))
            for k in range(3):
                turned = {(p[k], p[(k + 1) % 3], p[(k + 2) % 3]) for p in body}
                assert turned == body == {(-x, -y, z) for x, y, z in body}
        assert len(value["degeneracy"]["coincidences"]) >= 4


def test_flat_vertices_change_nothing() -> None:
    for value in documents("flat-vertices"):
        bodies = [convex_hull(points(value, name)) for name in "PQ"]
        assert len(value["P"]["vertices"]) > len(bodies[0].vertices) + 1
        facets_at = [
            sum(dot(n, p) == dot(n, body_face[0]) for body_face in planes for n in [body_face[1]])
            for planes in [
                [
                    (bodies[0].vertices[f[0]], normal(list(bodies[0].vertices), list(f)))
                    for f in bodies[0].faces
                ]
            ]
            for p in points(value, "P")
        ]
        assert {1, 2} < set(facets_at)
        for expected in value["expected"]:
            found = sum_of_convex(bodies[0], bodies[1], scaling(expected["scale"]))
            assert len(found.faces) == expected["facets"]


def generic(value: Any, at: Point) -> Any:
    """By supports: Q's vertex for each facet of P, P's vertex for each facet of Q, and the edge
    pairs that make parallelograms of the sum."""
    P, Q = scaled(points(value, "P"), at), points(value, "Q")
    total = sum_of_convex(convex_hull(P), convex_hull(Q), Fraction(1))
    fv, vf, ee = {}, {}, set()
    for face in total.faces:
        n = normal(list(total.vertices), list(face))
        p, q = (
            tuple(k for k, v in enumerate(body) if dot(n, v) == max(dot(n, w) for w in body))
            for body in (P, Q)
        )
        if len(q) == 1:
            fv[p] = q
        elif len(p) == 1:
            vf[q] = p
        else:
            assert len(p) == len(q) == 2
            ee.add((p, q))
    return fv, vf, ee


def test_errors_of_edges_without_errors_of_facets_of_P() -> None:
    for value in documents("edge-error-without-facet-of-p"):
        ends = [generic(value, scaling(value["scales"][k])) for k in (-1, 0)]
        assert ends[0][0] == ends[1][0] and ends[0][1] != ends[1][1]
        assert ends[0][2] - ends[1][2]


def test_all_facets_change_and_no_edges() -> None:
    for value in documents("all-facets-change-no-edges"):
        before, after = (generic(value, scaling(value["scales"][k])) for k in (-1, 0))
        assert all(before[0][f] != v for f, v in after[0].items()) and len(after[0]) == 4
        assert all(before[1][f] != v for f, v in after[1].items()) and len(after[1]) == 4
        assert before[2] == after[2] != set()


@pytest.mark.parametrize("name", SPACE_FAMILIES)
def test_members_differ(name: str) -> None:
    ids = {value["id"] for value in documents(name)}
    wanted = 3 if name == "all-facets-change-no-edges" else len(documents(name)) - 2
    assert len(ids) >= wanted if THOROUGH or name in VARIED else len(ids) == SPACE.count


def test_each_family_has_its_page_and_a_name_of_its_own() -> None:
    groups = (
        FAMILIES, SPACE_FAMILIES, INVALID_FAMILIES, INVALID_MESH_FAMILIES, FUZZED, FUZZED_IN_SPACE,
    )  # fmt: skip
    names = [name for group in groups for name in group]
    assert len(set(names)) == len(names)
    for name, family in SPACE_FAMILIES.items():
        page = (lint.ROOM / "pages" / f"{name}.md").read_text(encoding="utf-8")
        assert page.startswith(f"# {name}: {family.title}\n")
        assert len(family.why) > 100 and "\n" not in family.why


@pytest.mark.parametrize(
    ("spoil", "fault"),
    [
        (lambda v: v.__setitem__("id", "with-itself-000000000000"), "the id is not"),
        (lambda v: v["expected"][0].__setitem__("facets", 7), "not certified"),
        (lambda v: v["expected"].pop(), "not each scale"),
        (lambda v: v["P"]["vertices"][0].__setitem__(0, "x"), "is not valid under any"),
        (lambda v: v["P"]["vertices"][0].__setitem__(0, "99999"), "vertices of a face"),
        (lambda v: v["P"]["faces"].pop(), "no other face"),
        (lambda v: v["degeneracy"].__setitem__("why", "because"), "why of degeneracy is not what"),
        (lambda v: v["degeneracy"].__setitem__("floats", []), "floats of degeneracy is not what"),
        (lambda v: v.__setitem__("title", "another"), "title is not what"),
        (lambda v: v.__setitem__("flags", []), "flags is not what"),
        (lambda v: v.__setitem__("interval", {}), "interval"),
        (lambda v: v.pop("degeneracy"), "degeneracy is missing"),
        (lambda v: v.__setitem__("scales", ["1"]), "is not of type 'array'"),
        (lambda v: v.__setitem__("dimension", 2), "is not valid under any"),
    ],
)
def test_lint_finds_what_is_wrong(tmp_path: Path, spoil: Any, fault: str) -> None:
    found = faults_of_spoilt(tmp_path, SPACE_FAMILIES["many-sided-facets"], SEED, spoil)
    assert any(fault in line for line in found), found


def test_the_schema_knows_both_dimensions() -> None:
    schema = json.loads((lint.ROOM / "schema" / "case-v1.json").read_text(encoding="utf-8"))
    validator = jsonschema.Draft202012Validator(schema)
    value = documents("with-itself")[0]
    assert validator.is_valid(value)
    for name, other in (
        ("dimension", 2),
        ("dimension", 4),
        ("scales", ["1", "2", "3"]),
        ("scales", [["1", "2"]]),
        ("scales", [["1", "2", "0"]]),
        ("P", {"polygons": []}),
        ("P", {"vertices": []}),
        ("Q", value["Q"] | {"faces": [[0, 1]]}),
        ("Q", value["Q"] | {"name": "q"}),
    ):
        assert not validator.is_valid(value | {name: other}), (name, other)


def test_the_rotations_of_the_tetrahedron_are_twelve() -> None:
    assert len(orbit([vector(1, 2, 3)], False)) == 12
    assert len(orbit([vector(1, 2, 3)], True)) == 48 == 8 * len(list(permutations("xyz")))
