"""A target that stops answering is asked no more, whatever the number of workers."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path

import pytest
from minkref.fuzz.all_targets import ALL_TARGETS
from minkref.fuzz.cases.case_name import CaseName
from minkref.fuzz.run.case_list import CaseList
from minkref.fuzz.run.ledger import Ledger
from minkref.fuzz.run.resting import MOST_TIME_OUTS, RESTS, Resting
from minkref.fuzz.run.runner import Run, run
from minkref.fuzz.run.unasked import resting_notes
from minkref.fuzz.run.worker import CaseResult
from minkref.fuzz.targets.answer import Limits
from minkref.fuzz.verdicts.baseline import Baseline
from minkref.fuzz.verdicts.verdict import Outcome, Verdict
from thoroughness import draws

Verify = Callable[..., Run]
SECONDS = 0.3
PAIRS = draws(6, 14)
HANGS = "py:faulty_sums:hangs"


def result(number: int, verdicts: dict[str, Verdict], generated: bool = True) -> CaseResult:
    outcomes = [Outcome(name, verdict, message=str(verdict)) for name, verdict in verdicts.items()]
    name = CaseName(f"random:1:{number}", "random")
    return CaseResult(number, name, "1", outcomes, "P", "Q", (7, 1, ""), generated=generated)


def test_only_time_outs_in_a_row_count_and_skips_do_not_end_the_row() -> None:
    out, well, skip = Verdict.TIMED_OUT, Verdict.PASS, Verdict.SKIPPED
    for row, rests in (
        ([out, out, well, out, out, well], False),
        ([out, out, Verdict.WRONG, out, out], False),
        ([out, skip, out, skip, skip, out], True),
        ([well, out, out, out, out], True),
    ):
        resting = Resting(["a", "b"])
        for number, verdict in enumerate(row):
            resting.note(result(number, {"a": verdict, "b": well}))
        assert ("a" in resting.since) is rests and "b" not in resting.since
        assert not resting.is_over


def test_what_a_target_says_after_its_row_is_left_out() -> None:
    """Another worker may have asked it meanwhile."""
    resting = Resting(["a", "b"], {"a": "random:1:2"})
    late = result(3, {"a": Verdict.WRONG, "b": Verdict.PASS})
    for asked in (late, result(3, {"b": Verdict.PASS})):
        said = {o.target: (o.verdict, o.message) for o in resting.applied(asked).outcomes}
        assert said == {"a": (Verdict.SKIPPED, RESTS), "b": (Verdict.PASS, "pass")}
    for asked in (
        result(3, {"a": Verdict.TIMED_OUT, "b": Verdict.SKIPPED}),
        result(3, {"b": Verdict.SKIPPED}),
    ):
        assert resting.applied(asked).untaken == "skipped"
    kept = resting.applied(result(3, {"b": Verdict.SKIPPED}, generated=False))
    assert kept.untaken is None and len(kept.outcomes) == 2


def test_verdicts_do_not_depend_on_the_workers(verify: Verify) -> None:
    seen = []
    for jobs in (1, draws(2, 3)):
        done = verify(HANGS, "minkref:paper", pairs=PAIRS, jobs=jobs, call_seconds=SECONDS)
        verdicts = {key: dict(cell.verdicts) for key, cell in done.matrix.items()}
        skips = {key: dict(cell.skips) for key, cell in done.matrix.items()}
        found = [(f.outcome.target, f.case.name.text) for f in done.findings]
        seen.append((verdicts, skips, found, done.resting, dict(done.cases)))
    assert seen[0] == seen[1]
    verdicts, _, found, resting, cases = seen[0]
    assert len(found) == MOST_TIME_OUTS and set(resting) == {HANGS}
    assert sum(cases.values()) == PAIRS
    assert sum(v.get("pass", 0) for v in verdicts.values()) == PAIRS


def test_a_run_in_which_nobody_answers_ends(verify: Verify) -> None:
    done = verify(HANGS, pairs=1000, call_seconds=SECONDS)
    assert sum(done.cases.values()) == len(done.findings) == MOST_TIME_OUTS
    assert done.exit_code() == 3
    (note,) = resting_notes(done, [HANGS], 1000)
    assert note.endswith("it was not asked again; the run ended there, 997 cases before its end")


def test_named_cases_are_asked_all(verify: Verify) -> None:
    named = tuple(f"random:1:{k}" for k in range(MOST_TIME_OUTS + 1))
    done = verify(HANGS, named=named, call_seconds=SECONDS)
    assert len(done.findings) == MOST_TIME_OUTS + 1 and not done.resting


@pytest.mark.usefixtures("faulty_sums")
def test_a_ledger_gives_the_same_run_again(tmp_path: Path) -> None:
    def again(targets: list[str]) -> Run:
        with Ledger(tmp_path / "run.jsonl", {"test": 1}) as ledger:
            limits = Limits(seconds=SECONDS)
            cases = CaseList(1, 6, models=False)
            return run(cases, targets, ALL_TARGETS, {}, Baseline(), limits, 2, ledger=ledger)

    first = again([HANGS, "minkref:paper"])
    second = again([HANGS, "minkref:paper"])
    assert first.matrix == second.matrix and first.resting == second.resting
    assert len(first.findings) == MOST_TIME_OUTS
