"""Degenerate families of polyhedra of any shape: each member has what its family promises, by
predicates that are computed here from the case file alone; its sums are those of both routes and of
a judge that shares nothing with them; and the same bytes every time."""

from __future__ import annotations

import hashlib
import json
import random
from fractions import Fraction
from functools import cache
from pathlib import Path
from typing import Any

import pytest
from boxes_of_cells import euler_by_points, sum_by_boxes
from members import faults_of_spoilt, lines_under_two_hash_seeds
from minkref import _core
from minkref.degeneracies import lint
from minkref.degeneracies.catalogue import FAMILIES, SOLID_FAMILIES, SPACE_FAMILIES
from minkref.degeneracies.files import write_member
from minkref.degeneracies.make_corpus import COUNT_OF_SOLIDS as IN_CORPUS
from minkref.degeneracies.make_corpus import SEED as CORPUS_SEED
from minkref.degeneracies.solids.case_document import SHOWN, DegenerateSolids
from minkref.degeneracies.solids.generate import drawn_solids
from minkref.exact import digest
from minkref.fuzz.judges.space_routes import core_polyhedron, routes
from minkref.fuzz.space.polyhedron import Polyhedron
from minkref.oracle.slow import (
    SolidSum,
    exposed_from_json,
    open_lines,
    solid_faults,
    solid_from_json,
    uniform,
    whole_sum,
)
from solid_predicates import Read, value_of

SEED = 911
COUNT = 2
POINTS = 8  # of the slow engine, where it cannot make the sum whole
MOST_PAIRS = 4  # of convex pieces, for it to do so
SCALES = 5
FILLS = (
    ["touch", "empty", "empty", "overlap", "overlap"],
    ["touch", "overlap", "overlap", "empty", "empty"],
)
PLANES = {  # in how many planes facets face each other at the scale
    "solids-slot-closes": 1,
    "solids-components-meet": 1,
    "solids-cavity-to-point": 3,
    "solids-cavity-to-line": 2,
    "solids-cavity-to-sheet": 1,
    "solids-touch-along-edge": 2,
    "solids-touch-at-vertex": 3,
}
AT_ONE_SCALE = {*PLANES, "solids-four-facets", "solids-long-numbers", "solids-tiny-numbers"}


@cache
def documents(name: str) -> list[Any]:
    """As they are read from their files."""
    print(f"{name} --seed {SEED}")
    made = [DegenerateSolids.of(SOLID_FAMILIES[name], SEED, k) for k in range(COUNT)]
    return [json.loads(each.case_text) for each in made]


def operands(value: Any) -> tuple[Polyhedron, Polyhedron]:
    return Polyhedron.from_document(value["P"]), Polyhedron.from_document(value["Q"])


def scales(value: Any) -> list[Fraction]:
    assert all(len(set(scale)) == 1 for scale in value["scales"])
    return [Fraction(scale[0]) for scale in value["scales"]]


@pytest.mark.parametrize("name", SOLID_FAMILIES)
def test_the_members_of_the_corpus_are_made_again(name: str) -> None:
    """All of them, and no more: the same bytes."""
    made = [DegenerateSolids.of(SOLID_FAMILIES[name], CORPUS_SEED, k) for k in range(IN_CORPUS)]
    texts = {f"{each.id}.json": each.case_text for each in made}
    folder = lint.CORPUS / name
    assert texts == {path.name: path.read_text(encoding="utf-8") for path in folder.iterdir()}
    assert not list(lint.faults(folder, again=False))


@pytest.mark.parametrize("name", SOLID_FAMILIES)
def test_what_is_shown_holds(name: str) -> None:
    """Each predicate of a case file has the signs that it says, and is zero at the first scale; at
    others too, or at none of them."""
    for value in documents(name):
        rows = value["degeneracy"]["ties"]
        assert 0 < len(rows) <= SHOWN
        read = [Read(value, s) for s in scales(value)]
        for row in rows:
            assert row["signs"] == [value_of(row, each) for each in read], (value["id"], row)
            assert row["signs"][0] == 0
            if name in AT_ONE_SCALE:
                assert 0 not in row["signs"][1:]
            elif row["what"] != "vertices-meet":
                assert set(row["signs"]) == {0}


@pytest.mark.parametrize("name", SOLID_FAMILIES)
def test_scales_are_on_both_sides_and_near(name: str) -> None:
    for value in documents(name):
        at, *others = scales(value)
        assert len(others) == SCALES - 1
        steps = sorted((other - at) / at for other in others)
        assert [step > 0 for step in steps] == [False, False, True, True]
        assert max(steps[2], -steps[1]) < Fraction(1, 2**58)


@pytest.mark.parametrize("name", SOLID_FAMILIES)
def test_both_routes_and_a_judge_find_the_sum(name: str) -> None:
    """Polycubes as boxes, few pairs of pieces whole, others by points of faces and of space."""
    for number, value in enumerate(documents(name)):
        P, Q = operands(value)
        assert set(routes()) == {"edges", "definition"}
        for s, expected in zip(scales(value), value["expected"], strict=True):
            texts = {route(P, Q, s) for route in routes().values()}
            (text,) = texts
            assert digest(text) == expected["digest"], value["id"]
            found = exposed_from_json(json.loads(text))
            assert len(found.planes) == expected["planes"]
            assert str(found.volume()) == expected["volume"]
            boxes = sum_by_boxes(P, Q, s)
            if boxes is not None:
                assert boxes == text, (value["id"], s)
                continue
            truth = SolidSum(*(solid_from_json(each.document()) for each in (P, Q)), uniform(s))
            if len(truth.pairs) <= MOST_PAIRS:
                assert whole_sum(truth).text() == text, (value["id"], s)
                continue
            assert open_lines(found) == 0
            dice = random.Random(f"{SEED} {name} {number}")
            assert not list(solid_faults(truth, found, dice, points=POINTS)), (value["id"], s)


@pytest.mark.parametrize("name", SOLID_FAMILIES)
def test_points_are_where_they_are_said_to_be(name: str) -> None:
    """By the slow engine: in the closed sum or not, in the sum of the interiors or not."""
    for value in documents(name):
        P, Q = operands(value)
        for k, s in enumerate(scales(value)):
            truth = SolidSum(*(solid_from_json(each.document()) for each in (P, Q)), uniform(s))
            for row in value["degeneracy"]["points"]:
                p, q = (list(map(Fraction, row[each])) for each in "pq")
                x, y, z = (s * a + b for a, b in zip(p, q, strict=True))
                closed, inner = truth.holds((x, y, z)), truth.holds((x, y, z), interiors=True)
                kind = "overlap" if inner else "touch" if closed else "empty"
                assert kind == row["contact"][k], (value["id"], row, s)


@pytest.mark.parametrize("name", PLANES)
def test_what_fits_at_one_scale(name: str) -> None:
    """Facets face each other in as many planes as they should, which have no line in common, or a
    line, or a point; on one side of the scale there is a gap."""
    for value in documents(name):
        told = value["degeneracy"]
        assert told["points"][0]["contact"] in FILLS
        read = Read(value, scales(value)[0])
        normals = {read.plane(tie["features"][0])[0] for tie in told["ties"]}
        assert {tie["what"] for tie in told["ties"]} == {"facing"}
        assert len(normals) == len(told["ties"]) == PLANES[name]
        around = [row["contact"][0] for row in told["points"][1:]]
        if name.startswith("solids-touch"):
            assert sorted(around) == ["empty"] * (2 ** PLANES[name] - 2) + ["overlap"] * 2


def test_volumes_are_cubics_of_the_scale_beside_the_event() -> None:
    """A hollow box and a box: the cavity is there on one side only."""
    for value in documents("solids-cavity-to-point"):
        volumes = [Fraction(expected["volume"]) for expected in value["expected"]]
        P, Q = (solid.scaled(Fraction(1)) for solid in operands(value))
        filled = []
        for s in scales(value):
            sides = [
                s * (b[1] - b[0]) + d[1] - d[0] for b, d in zip(_spans(P), _spans(Q), strict=True)
            ]
            filled.append(sides[0] * sides[1] * sides[2])
        if P.volume == _box_volume(P) and Q.volume != _box_volume(Q) and _is_aligned(Q):
            assert volumes[0] == filled[0]
            assert [v < f for v, f in zip(volumes[1:], filled[1:], strict=True)] == [
                contact == "empty" for contact in value["degeneracy"]["points"][0]["contact"][1:]
            ]


def _spans(solid: Polyhedron) -> list[tuple[Fraction, Fraction]]:
    return list(zip(*solid.box, strict=True))


def _box_volume(solid: Polyhedron) -> Fraction:
    a, b, c = (high - low for low, high in _spans(solid))
    return a * b * c


def _is_aligned(solid: Polyhedron) -> bool:
    return len(set(solid.vertices)) == 16 and all(
        len({v[k] for v in solid.vertices}) == 4 for k in range(3)
    )


def test_the_convolution_winds_zero_times_around_a_point_inside() -> None:
    for value in documents("solids-cup-and-plate"):
        (row,) = value["degeneracy"]["points"]
        assert row["contact"][0] == "overlap" and row["euler"] == 0
        assert "winding-zero" in value["flags"]
        s = scales(value)[0]
        x, y, z = (s * Fraction(a) + Fraction(b) for a, b in zip(row["p"], row["q"], strict=True))
        assert euler_by_points(*operands(value), s, (x, y, z)) == 0


def test_refinement_does_not_change_the_sum() -> None:
    for k in range(COUNT):
        draft, facts, _ = drawn_solids(SOLID_FAMILIES["solids-refined"], SEED, k)
        assert draft.plain is not None
        assert len(draft.plain[0].vertices) < len(draft.P.vertices)
        plain = [core_polyhedron(solid) for solid in draft.plain]
        for s in facts.scales:
            assert _core.edge_sum_in_space(*plain, (str(s),) * 3) == facts.sum(s)


def test_a_solid_and_itself_or_its_reflection() -> None:
    for name, turn in (("solids-with-itself", 1), ("solids-with-reflection", -1)):
        for value in documents(name):
            s = scales(value)[0]
            read = Read(value, s)
            steps = {
                tuple(b - turn * a for a, b in zip(p, q, strict=True))
                for p, q in zip(read.points["P"], read.points["Q"], strict=True)
            }
            assert len(steps) == 1


def test_operands_are_points_segments_and_several_components() -> None:
    kinds = set()
    for index in range(8):
        _, facts, _ = drawn_solids(SOLID_FAMILIES["solids-thin-operand"], SEED, index)
        kinds |= {len(m.given.vertices) for m in (facts.P, facts.Q) if m.given.is_thin}
    assert kinds == {1, 2}
    for value in documents("solids-components-meet"):
        assert {len(set(solid.shells)) for solid in operands(value)} == {1, 2}


def test_numbers_are_long_or_tiny() -> None:
    for name in ("solids-long-numbers", "solids-tiny-numbers"):
        for value in documents(name):
            numbers = [abs(c) for solid in operands(value) for v in solid.vertices for c in v]
            if name == "solids-long-numbers":
                assert max(numbers) > 2**60 and all(c.denominator == 1 for c in numbers)
            else:
                assert max(numbers) < Fraction(1, 2**100) and min(numbers) > 0


@pytest.mark.parametrize(
    ("spoil", "fault"),
    [
        (lambda v: v.pop("flags"), "flags is missing"),
        (lambda v: v["flags"].append("sparkling"), "not explained"),
        (lambda v: v["flags"].pop(), "flags is not what"),
        (lambda v: v["expected"][0].__setitem__("volume", "1"), "expected is not what"),
        (lambda v: v["expected"].pop(), "not each scale"),
        (lambda v: v["scales"].pop(), "id is not"),
        (lambda v: v["P"]["faces"].pop(), "edge"),
        (lambda v: v["degeneracy"]["ties"].pop(), "ties"),
        (lambda v: v["degeneracy"]["ties"][0].__setitem__("what", "knot"), "knot"),
        (lambda v: v["degeneracy"].__setitem__("points", []), "points of degeneracy is not what"),
        (lambda v: v.__setitem__("certificate", "a.cert.json"), "have no certificates"),
    ],
)
def test_lint_finds_what_is_wrong(tmp_path: Path, spoil: Any, fault: str) -> None:
    found = faults_of_spoilt(tmp_path, SOLID_FAMILIES["solids-slot-closes"], SEED, spoil)
    assert any(fault in line for line in found), found


CODE = f"""
import hashlib
from minkref.degeneracies.catalogue import SOLID_FAMILIES
from minkref.degeneracies.solids.case_document import DegenerateSolids
for name in sorted(set(SOLID_FAMILIES) - {{"solids-four-facets"}}):
    text = DegenerateSolids.of(SOLID_FAMILIES[name], {SEED}, 0).case_text
    print(name, hashlib.sha256(text.encode()).hexdigest())
"""


def test_a_member_depends_on_seed_and_number_only(tmp_path: Path) -> None:
    found = lines_under_two_hash_seeds(CODE)
    assert len(found) == len(SOLID_FAMILIES) - 1
    row = write_member(SOLID_FAMILIES["solids-one-line"], SEED, 0, tmp_path)
    content = Path(row["case"]).read_bytes()
    assert f"solids-one-line {hashlib.sha256(content).hexdigest()}" in found
    assert row["certificate"] is None and row["bytes"] == len(content)


def test_each_family_has_its_page_and_a_name_of_its_own() -> None:
    assert not set(SOLID_FAMILIES) & (set(FAMILIES) | set(SPACE_FAMILIES))
    for name, family in SOLID_FAMILIES.items():
        heading, _, text = (lint.ROOM / "pages" / f"{name}.md").read_text().partition("\n")
        assert heading == f"# {name}: {family.title}"
        assert len(text.split()) > 30 and family.why
