"""Offsets and insets with a known answer: each route of the reference has the digest, the witness
holds, before a judge that stands alone too, and `verify` has them as cases."""

from __future__ import annotations

import json
import subprocess
import sys
from fractions import Fraction

import pytest
from minkref import _core
from minkref.exact import digest
from minkref.fuzz.cases.case_name import CaseName
from minkref.fuzz.cases.no_case import NoCase
from minkref.fuzz.judges.disc.offset_findings import confirmed, squared
from minkref.fuzz.offsets.asked_offset import AskedOffset
from minkref.fuzz.offsets.judgement import is_proven
from minkref.fuzz.offsets.known import FAMILY, FILE, KnownOffset, known_offsets
from minkref.fuzz.offsets.question import OFFSETS
from minkref.fuzz.run import naming

KNOWN = known_offsets()
JUDGE = FILE.parent / "findings" / "judge.py"


def document(known: KnownOffset) -> dict[str, object]:
    """A finding, as the document of `verify` has it."""
    assert known.witness is not None
    operand = {"set": json.loads(known.asked.P_json)}
    return {"witness": known.witness.document(), "P": operand}


@pytest.mark.parametrize("known", KNOWN, ids=lambda known: known.title)
def test_what_is_said_of_an_offset_holds(known: KnownOffset) -> None:
    asked, is_round = known.asked, known.asked.manner.is_round
    assert is_round == (known.digest is not None)
    for route in ("definition", "paper") if is_round else ():
        found = asked.by_disc(asked.radius, 1, route)
        assert digest(found.canonical_json()) == known.digest
        assert (found.components, found.holes) == (known.components, known.holes)
    if is_round and asked.set.is_region and not asked.inward:
        square = str(asked.radius**2)
        assert digest(_core.disc_index(asked.set).canonical_json(square)) == known.digest
    assert known.story.endswith(".") and known.title
    assert known.victims or known.witness is None
    if known.witness is not None:
        assert is_proven(asked, known.witness)
        assert not is_round or confirmed(document(known))


def test_a_judge_that_stands_alone_confirms_each_witness() -> None:
    words = [sys.executable, "-I", str(JUDGE), str(FILE)]
    done = subprocess.run(words, capture_output=True, text=True, check=True)
    titles = [known.title for known in KNOWN if known.witness is not None]
    assert done.stdout.splitlines() == [f"{title}: confirmed" for title in titles]


def test_they_are_cases_of_verify() -> None:
    assert next(iter(OFFSETS.families)) == FAMILY
    assert len({known.title for known in KNOWN}) == len(KNOWN)
    for index, known in enumerate(KNOWN):
        case = naming.load(CaseName(f"{FAMILY}:1:{index}", "named"))
        assert isinstance(case, AskedOffset) and case.literal == known.asked.literal
    with pytest.raises(NoCase, match="known offsets"):
        naming.load(CaseName(f"{FAMILY}:1:{len(KNOWN)}", "named"))


def test_three_ways_to_measure_a_distance_agree() -> None:
    """The judge of the run, the check of its witnesses, the judge of findings."""
    for known in (one for one in KNOWN if not one.asked.set.is_empty):
        case = known.asked
        near, polygons = case.near, json.loads(case.P_json)["polygons"]
        for x in range(-5, 12, 4):
            for y in range(-5, 12, 3):
                point = (Fraction(x) / 3, Fraction(y) / 2)
                found = near.of(point).square
                assert found == squared(polygons, *point, case.inward), (known.title, point)
