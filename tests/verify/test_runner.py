"""Runs against targets with deliberate faults: verdicts, exit codes, baseline, determinism."""

from __future__ import annotations

import importlib
from collections.abc import Callable
from pathlib import Path
from typing import Any

import pytest
from minkref.fuzz.isolation.isolation import choose
from minkref.fuzz.plane.witness import holds
from minkref.fuzz.run import case_list, pool
from minkref.fuzz.run.runner import Run
from minkref.fuzz.verdicts.baseline import Baseline, Entry
from minkref.fuzz.verdicts.verdict import Reason, Verdict
from minkref.output.exits import ExitCode
from thoroughness import draws

Verify = Callable[..., Run]


def counts(run: Run, target: str) -> dict[str, int]:
    return dict(run.matrix[(target, run.groups[0])].verdicts)


def test_right_target_and_all_routes_pass(verify: Verify) -> None:
    names = ["minkref:paper", "minkref:winding", "minkref:definition", "py:faulty_sums:right"]
    pairs = draws(12, 40)
    run = verify(*names, pairs=pairs)
    assert run.findings == []
    assert run.exit_code() is ExitCode.ALL_WELL
    assert all(counts(run, name) == {"pass": pairs} for name in names)


def test_wrong_target_is_wrong_with_a_witness_that_holds(verify: Verify) -> None:
    expected = {
        "py:faulty_sums:shifted": Reason.MISSING,
        "py:faulty_sums:invents_a_component": Reason.COMPONENT,
        "py:faulty_sums:nothing": Reason.COMPONENT,
        "py:faulty_sums:covers_twice": Reason.SELF_INTERSECTING,
        "py:faulty_sums:leaves_a_stub": Reason.NOT_CLOSED,
        "py:faulty_sums:adds_a_flat_ring": Reason.NOT_CLOSED,
        "py:faulty_sums:answers_in_long_numbers": Reason.EXTRA,
    }
    pairs = draws(3, 12)
    run = verify(*expected, pairs=pairs)
    assert run.exit_code() is ExitCode.WRONG
    assert all(counts(run, name) == {"wrong": pairs} for name in expected)
    for finding in run.findings:
        assert finding.outcome.verdict is Verdict.WRONG
        assert expected[finding.outcome.target] in finding.outcome.reasons
        assert finding.outcome.witness is not None
        assert finding.case.P and finding.case.Q
        assert holds(finding.case.P, finding.case.Q, finding.case.scale, finding.outcome.witness)


def test_rings_of_a_python_target_may_run_either_way(verify: Verify) -> None:
    run = verify("py:faulty_sums:runs_the_other_way", pairs=draws(12, 40))
    assert run.findings == []


def test_import_is_no_part_of_a_call(verify: Verify) -> None:
    run = verify("py:slow_to_import:right", pairs=2, call_seconds=1.0)
    assert run.findings == []


def test_lost_hole_is_found_named_and_reproduced(verify: Verify) -> None:
    run = verify("py:faulty_sums:loses_holes", pairs=draws(12, 200), families=("holes",))
    assert len(run.findings) > 1, "no sum has a hole"
    assert {finding.outcome.reasons for finding in run.findings} == {(Reason.HOLE_LOST,)}
    ((smallest, count),) = run.smallest()
    assert count == len(run.findings)
    assert all(smallest.case.size <= finding.case.size for finding in run.findings)
    again = verify("py:faulty_sums:loses_holes", named=(smallest.case.name.text,))
    assert again.findings[0].outcome.witness == smallest.outcome.witness
    assert smallest.reproduce.endswith(f"--case {smallest.case.name.text}")


BROKEN = {
    "raises": (Verdict.ERRORED, "this never works"),
    "speaks_nonsense": (Verdict.ERRORED, "not a polygon set"),
    "answers_in_floats": (Verdict.ERRORED, "exact numbers"),
    "exhausts_memory": (Verdict.OUT_OF_MEMORY, ""),
    "raises_what_has_no_text": (Verdict.ERRORED, "Mute"),
    "answers_with_a_spiteful_object": (Verdict.ERRORED, "not a polygon set"),
    "exits": (Verdict.ERRORED, "SystemExit"),
    "dies": (Verdict.CRASHED, "SIGSEGV"),
    "leaves": (Verdict.CRASHED, "exit code 3"),
    "hangs": (Verdict.TIMED_OUT, "no answer in 1 s"),
}


def test_broken_target_is_charged_and_others_are_not(verify: Verify) -> None:
    broken = {f"py:faulty_sums:{fault}": said for fault, said in BROKEN.items()}
    pairs = draws(1, 2)
    run = verify(*broken, "py:faulty_sums:right", pairs=pairs, call_seconds=1.0)
    assert {name: counts(run, name) for name in broken} == {
        name: {str(verdict): pairs} for name, (verdict, _) in broken.items()
    }
    assert counts(run, "py:faulty_sums:right") == {"pass": pairs}
    for finding in run.findings:
        assert broken[finding.outcome.target][1] in finding.outcome.message
    assert run.exit_code() is ExitCode.BROKEN


@pytest.mark.parametrize(
    ("fault", "message"),
    [
        ("dies", "could not be judged: the process died (SIGSEGV)"),
        ("takes_for_ever", "could not be judged: there was no end after 1 s"),
        ("exhausts_memory", "too little memory"),
        ("exhausts_memory_beside_the_judge", "too little memory"),
    ],
)
def test_answer_that_cannot_be_judged_is_undecided_and_ends_no_run(
    verify: Verify, monkeypatch: pytest.MonkeyPatch, fault: str, message: str
) -> None:
    spoils_judging = importlib.import_module("spoils_judging")
    monkeypatch.setattr(pool, "work", getattr(spoils_judging, fault))
    pairs = draws(1, 2)
    run = verify(spoils_judging.SPOILT, "minkref:winding", pairs=pairs)
    assert counts(run, spoils_judging.SPOILT) == {"undecided": pairs}
    assert counts(run, "minkref:winding") == {"pass": pairs}
    assert run.exit_code() is ExitCode.ALL_WELL
    assert message in run.findings[0].outcome.message


def test_a_case_that_takes_more_memory_than_there_is_is_absent_and_ends_no_run(
    verify: Verify, monkeypatch: pytest.MonkeyPatch
) -> None:
    spoils_judging = importlib.import_module("spoils_judging")
    monkeypatch.setattr(pool, "work", spoils_judging.has_no_memory_for_the_second_case)
    run = verify("py:faulty_sums:right", named=("random:1:0", "random:1:1"))
    assert sum(run.cases.values()) == 1
    assert run.failed is None


def test_one_late_answer_is_no_time_out(
    verify: Verify, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """The machine may have stood still: only a second time-out on the same case counts."""
    tmp_path.chmod(0o777)  # the function may be another user's, and leaves a mark there
    monkeypatch.setenv("MINKREF_TEST_MARK", str(tmp_path / "called"))
    target = "py:faulty_sums:hangs_once"
    run = verify(target, pairs=2, call_seconds=1.0, walls=choose("none"))
    assert counts(run, target) == {"pass": 2}
    assert (tmp_path / "called").exists()


def test_target_that_declines_everything_leaves_nothing_run(
    verify: Verify, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(case_list, "FEWEST_TRIES", draws(20, case_list.FEWEST_TRIES))
    run = verify("py:faulty_sums:declines", pairs=1)
    assert not run.cases and set(run.untaken) == {"outside the capabilities of the target"}
    assert run.exit_code() is ExitCode.USAGE


def test_baseline_turns_a_wrong_into_known_and_the_exit_code_into_0(verify: Verify) -> None:
    target = "py:faulty_sums:nothing"
    baseline = Baseline((Entry(target, "1.2*", "component", "it never answers"),))
    run = verify(target, pairs=2, baseline=baseline, versions={target: "1.2.3"})
    assert counts(run, target) == {"known": 2}
    assert run.exit_code() is ExitCode.ALL_WELL
    outcome = run.findings[0].outcome
    assert (outcome.was, outcome.message) == (Verdict.WRONG, "it never answers")
    assert outcome.witness is not None


def test_baseline_of_another_target_version_or_fault_excuses_nothing(verify: Verify) -> None:
    """Neither does a baseline with one of a fault's two reasons."""
    target, two_reasons = "py:faulty_sums:nothing", "py:faulty_sums:shifted"
    entries = (
        Entry("py:faulty_sums:other", "1.2.3", "component", "r"),
        Entry(target, "1.2.4", "component", "r"),
        Entry(target, "1.2.3", "extra", "r"),
        Entry(target, "1.2.3", "crashed", "r"),
        Entry(two_reasons, "*", "missing", "r"),
    )
    run = verify(
        target, two_reasons, pairs=2, baseline=Baseline(entries), versions={target: "1.2.3"}
    )
    assert counts(run, target) == counts(run, two_reasons) == {"wrong": 2}
    assert run.exit_code() is ExitCode.WRONG


def test_baseline_excuses_a_crash(verify: Verify) -> None:
    target = "py:faulty_sums:dies"
    baseline = Baseline((Entry(target, "*", "crashed", "a known crash"),))
    run = verify(target, "minkref:paper", pairs=2, baseline=baseline)
    assert counts(run, target) == {"known": 2}
    assert run.exit_code() is ExitCode.ALL_WELL


def facts(run: Run) -> Any:
    return [
        (f.outcome.target, f.outcome.verdict, f.outcome.reasons, f.outcome.witness, f.case.name)
        for f in run.findings
    ]


def test_findings_do_not_depend_on_the_number_of_workers(verify: Verify) -> None:
    names = ["minkref:paper", "py:faulty_sums:shifted", "py:faulty_sums:loses_holes"]
    one, two = (verify(*names, pairs=draws(8, 60), jobs=jobs) for jobs in (1, 2))
    assert facts(one) == facts(two)
    assert [f.kind for f, _ in one.smallest()] == [f.kind for f, _ in two.smallest()]
    assert one.cases == two.cases
