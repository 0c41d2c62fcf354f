"""Degenerate families of general polyhedra: each member keeps its family's promise, by predicates
computed here from the case file alone. Their sums: test_sums_of_solids.py."""

from __future__ import annotations

from fractions import Fraction

import pytest
from minkref.degeneracies import lint
from minkref.degeneracies.catalogue import FAMILIES, SOLID_FAMILIES, SPACE_FAMILIES
from minkref.degeneracies.solids.case_document import SHOWN
from minkref.oracle.slow import SolidSum, solid_from_json, uniform
from solid_members import SEED, documents, operands, scales
from solid_predicates import Read, value_of
from thoroughness import some

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
AT_ONE_SCALE = {
    *PLANES, "solids-four-facets", "solids-crossed-facets", "solids-long-numbers",
    "solids-tiny-numbers",
}  # fmt: skip


@pytest.mark.parametrize("name", SOLID_FAMILIES)
def test_what_is_shown_holds(name: str) -> None:
    """Each predicate has the signs that the case file states, and is zero at the first scale; at
    the other scales zero always or never, as the family demands."""
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
def test_points_are_where_they_are_said_to_be(name: str) -> None:
    """Asks the slow engine whether points lie in the closed sum, and in the sum of the
    interiors."""
    for value in documents(name):
        P, Q = operands(value)
        for k, s in some(enumerate(scales(value)), 2):
            truth = SolidSum(*(solid_from_json(each.document()) for each in (P, Q)), uniform(s))
            for row in value["degeneracy"]["points"]:
                p, q = (list(map(Fraction, row[each])) for each in "pq")
                x, y, z = (s * a + b for a, b in zip(p, q, strict=True))
                closed, inner = truth.holds((x, y, z)), truth.holds((x, y, z), interiors=True)
                kind = "overlap" if inner else "touch" if closed else "empty"
                assert kind == row["contact"][k], (value["id"], row, s)


@pytest.mark.parametrize("name", PLANES)
def test_what_fits_at_one_scale(name: str) -> None:
    """Facets face each other in the expected number of planes, which share nothing, a line or a
    point; a gap opens on one side of the scale."""
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
        facts, _ = SOLID_FAMILIES["solids-thin-operand"].member(SEED, index)
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


def test_each_family_has_its_page_and_a_name_of_its_own() -> None:
    assert not set(SOLID_FAMILIES) & (set(FAMILIES) | set(SPACE_FAMILIES))
    for name, family in SOLID_FAMILIES.items():
        heading, _, text = (lint.ROOM / "pages" / f"{name}.md").read_text().partition("\n")
        assert heading == f"# {name}: {family.title}"
        assert len(text.split()) > 30 and family.why
