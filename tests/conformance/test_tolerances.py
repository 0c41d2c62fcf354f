"""Reports state a declared tolerance of any size, without failing."""

from __future__ import annotations

import pytest
from minkref.fuzz.verdicts.verdict import Witness
from minkref.reports.conformance.argument import around
from minkref.reports.conformance.target_page import facts_of

SIZES = {"1e1000": "e1000", "1/3": "3.333333e-1", "1e-2000": "e-2000", "123456789": "1.234568e8"}


@pytest.mark.parametrize("text", SIZES)
def test_a_tolerance_is_told_in_a_page_of_a_target_and_in_an_argument(text: str) -> None:
    row = {
        "version": "1",
        "sum": "region",
        "arithmetic": "float64",
        "capabilities": ["plane"],
        "tolerance": {"absolute": text, "relative": text},
    }
    told = dict(facts_of(row))["tolerance"]
    assert text in told and (len(text) < 6 or SIZES[text] in told)


@pytest.mark.parametrize("text", [str(10**1000), "1/3", f"1/{10**2000}"])
def test_an_argument_tells_the_tolerance_of_its_witness(text: str) -> None:
    (sentence,) = around(Witness(("1", "2"), in_truth=True, tolerance=text))
    assert text in sentence
