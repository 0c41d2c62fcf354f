"""A wrong result counts as proven only if it contradicts its witness."""

from __future__ import annotations

import pytest

pytest.importorskip("minkref._core", reason="the extension module is not built")

from minkref.fuzz.verdicts.verdict import Outcome, Reason, Verdict, Witness
from minkref.reports.evidence.plane_sums.random_pairs import refutes

SQUARE = '{"polygons":[{"holes":[],"outer":[["0","0"],["2","0"],["2","2"],["0","2"]]}]}'
HERE, THERE = ("1", "1"), ("3", "1")


@pytest.mark.parametrize(
    ("point", "in_truth", "refuted"),
    [(HERE, False, True), (THERE, True, True), (HERE, True, False), (THERE, False, False)],
)
def test_witness_refutes_what_says_the_contrary_of_its_point(
    point: tuple[str, str], in_truth: bool, refuted: bool
) -> None:
    reasons = (Reason.MISSING,) if in_truth else (Reason.EXTRA,)
    witness = Witness(point, in_truth)
    outcome = Outcome("t", Verdict.WRONG, reasons, witness=witness, got=SQUARE)
    assert refutes(outcome) is refuted


def test_wrong_result_without_a_witness_is_not_proven() -> None:
    assert not refutes(Outcome("t", Verdict.WRONG, (Reason.MISSING,), got=SQUARE))
