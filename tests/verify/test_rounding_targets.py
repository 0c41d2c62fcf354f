"""Our inexact targets take any number, as the nearest one they can hold, and the sandwich judges
them: numbers exclude no case."""

from __future__ import annotations

import pytest
from minkref.fuzz.all_targets import ALL_TARGETS
from minkref.fuzz.run.case_list import CaseList
from minkref.fuzz.run.runner import run
from minkref.fuzz.targets.answer import Limits
from minkref.fuzz.verdicts.baseline import Baseline
from minkref.fuzz.verdicts.verdict import Verdict

SEED = 15
COUNT = 8


@pytest.mark.parametrize("target", ["minkref-double", "minkref-mpfr53"])
def test_numbers_that_no_double_holds_are_no_reason_to_skip(target: str) -> None:
    names = tuple(f"rational:{SEED}:{k}" for k in range(COUNT))
    cases = CaseList(SEED, None, named=names, models=False)
    done = run(cases, [target], ALL_TARGETS, {}, Baseline(), Limits(seconds=60), 1)
    (cell,) = done.matrix.values()
    assert cell.verdicts[str(Verdict.SKIPPED)] == 0, f"seed {SEED}"
    within = cell.verdicts[str(Verdict.PASS)] + cell.verdicts[str(Verdict.PASS_WITHIN)]
    assert within >= COUNT / 2, f"seed {SEED}: {cell.verdicts}"
    assert cell.verdicts[str(Verdict.PASS_WITHIN)] > 0, f"seed {SEED}: {cell.verdicts}"
