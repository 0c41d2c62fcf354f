"""`minkref verify` on pairs of polyhedra of any shape: our routes and a right function pass, faults
are found, with a witness, and made small."""

from __future__ import annotations

import json
from collections.abc import Callable
from fractions import Fraction

import pytest
from minkref.fuzz.all_targets import ALL_TARGETS
from minkref.fuzz.geometry.polyhedron import Polyhedron
from minkref.fuzz.run.runner import Run
from minkref.fuzz.run.unasked import unproven_notes
from minkref.fuzz.shrink.finding import shrink_finding
from minkref.fuzz.space.families import GENERAL
from minkref.fuzz.space.generators.convex import cube
from minkref.fuzz.space.witness import holds
from minkref.fuzz.targets.answer import Limits
from minkref.fuzz.verdicts.verdict import Outcome, Reason, Verdict
from thoroughness import THOROUGH, draws

SEED = 8
INDICES = {"space-mixed": 1, "space-knot": 6}  # small ones
CASES = tuple(f"{name}:{SEED}:{INDICES.get(name, 0)}" for name, _ in GENERAL.values())
SOME = ("space-cup:8:1", "space-mixed:8:1", "translate-P(space-spikes:8:1)")
Verify = Callable[..., Run]


@pytest.mark.parametrize("route", ["minkref:edges", "minkref:definition-space"])
def test_our_routes_pass_on_every_family(
    outcomes: Callable[..., list[Outcome]], route: str
) -> None:
    cases = CASES if THOROUGH or route == "minkref:edges" else CASES[::2]
    said = outcomes(route, *cases)
    assert [outcome.verdict for outcome in said] == [Verdict.PASS] * len(cases), said


def test_a_right_function_passes_and_faults_are_found(verify: Verify) -> None:
    names = [f"py:faulty_solids:{name}" for name in ("right", "fills_all", "moves_a_vertex")]
    done = verify(*names, named=SOME)
    found: dict[str, set[tuple[Reason, ...]]] = {}
    for finding in done.findings:
        outcome, case = finding.outcome, finding.case
        found.setdefault(outcome.target, set()).add(outcome.reasons)
        assert outcome.verdict is Verdict.WRONG and outcome.witness is not None
        value = json.loads(case.literal or "")
        P, Q = (Polyhedron.from_document(value[name]) for name in "PQ")
        assert holds(P, Q, Fraction(value["scale"]), outcome.witness)
    assert set(found) == set(names[1:])
    assert found[names[1]] == {(Reason.EXTRA,)}


def test_a_fault_is_made_small(verify: Verify) -> None:
    name = "py:faulty_solids:fills_all"
    (finding,) = verify(name, named=("space-cup:8:1",)).findings
    small = shrink_finding(finding, ALL_TARGETS, Limits(), draws(60, 150))
    assert small is not None and small.stable
    assert small.result.size[0] < finding.case.size[0] / 2 + 4
    assert small.outcome.reasons == (Reason.EXTRA,)


def test_a_pass_by_single_points_is_in_the_notes(verify: Verify) -> None:
    """A self-crossing operand has no exact sum. The answer is right."""
    one = cube((Fraction(1, 3), Fraction(0), Fraction(0)), Fraction(2))
    crossing = one.with_faces_of(one.translated((Fraction(1), Fraction(1), Fraction(1))))
    value = {"P": crossing.document(), "Q": one.document(), "scale": "1"}
    name = "py:faulty_solids:by_shells"
    done = verify(name, named=(json.dumps(value),))
    assert not done.findings
    (note,) = unproven_notes(done)
    assert note.startswith(f"{name}: 1 answers pass without a proof") and "no exact sum" in note
