"""One worker process of a run: takes cases from a pipe, runs the targets on each, judges,
answers."""

from __future__ import annotations

import resource
import traceback
from dataclasses import dataclass, field
from multiprocessing.connection import Connection
from typing import Any

from minkref.fuzz.cases.case import Case, CaseName
from minkref.fuzz.cgal import server as cgal_server
from minkref.fuzz.judges.checks import PREFIX, Check
from minkref.fuzz.run import child
from minkref.fuzz.targets.catalogue import (
    LOAD_SECONDS,
    Answer,
    Limits,
    Target,
    make_target,
    size_limit,
)
from minkref.fuzz.verdicts.judgement import TRUTHS, judge
from minkref.fuzz.verdicts.verdict import Outcome, Verdict

JUDGE_SECONDS = 600.0  # for one judge on one case: slow by design
REST = 2 << 30  # bytes that a worker may need beside what one call of a target may take


@dataclass
class Job:
    """One case for a worker. `lost` holds the targets that took a worker down with them before,
    `overdue` those that were out of time once; a second time counts."""

    number: int
    name: CaseName
    lost: dict[str, Outcome] = field(default_factory=dict)
    overdue: set[str] = field(default_factory=set)


@dataclass
class CaseResult:
    """What a worker hands back on one case. Sets are texts, and only where something is amiss."""

    number: int
    name: CaseName
    scale: str
    outcomes: list[Outcome]
    P_name: str
    Q_name: str
    size: tuple[int, int, str]
    P: str | None = None
    Q: str | None = None
    expected: str | None = None


def work(pipe: Connection, targets: list[str], limits: Limits) -> None:
    """The loop of a worker. Before each step it says which target is about to run, and how long it
    may, so that the parent knows whose fault the death of this process is."""
    child.begin()
    _limit_memory(limits.bytes + REST)
    made: dict[str, Target | Check] = {}
    try:
        while True:
            job = pipe.recv()
            if job is None:
                return
            try:
                pipe.send(("done", _run(pipe, job, targets, limits, made)))
            except (BrokenPipeError, EOFError):
                return
            except Exception as error:  # noqa: BLE001 the parent reports it
                pipe.send(("failed", f"{job.name.text}: {error}", traceback.format_exc()))
    except (EOFError, OSError):
        return
    finally:
        for target in made.values():
            target.close()


def _limit_memory(bytes_allowed: int) -> None:
    _, hard = resource.getrlimit(resource.RLIMIT_AS)
    if hard == resource.RLIM_INFINITY or bytes_allowed < hard:
        resource.setrlimit(resource.RLIMIT_AS, (bytes_allowed, hard))


def _run(
    pipe: Connection, job: Job, targets: list[str], limits: Limits, made: dict[str, Target | Check]
) -> CaseResult:
    _begin(pipe, "minkref:case", limits)
    case = job.name.load()
    ruled = [_rule(pipe, job, case, name, limits, made) for name in targets if is_check(name)]
    targets = [name for name in targets if not is_check(name)]
    if not targets:
        return _result(job, case, ruled, {})
    answers: dict[str, Answer] = {}
    for name in dict.fromkeys([*TRUTHS, *targets]):
        if name in job.lost:
            lost = job.lost[name]
            answers[name] = Answer(
                verdict=lost.verdict, message=lost.message, signal=lost.signal, seconds=lost.seconds
            )
            continue
        if name not in targets and any(answer.region for answer in answers.values()):
            continue  # one route of ours is truth enough until somebody disagrees
        limit = size_limit(name, limits)
        if limit is not None and case.vertex_pairs > limit:
            message = f"{case.vertex_pairs:,} pairs of vertices, more than {limit:,} (--size-limit)"
            answers[name] = Answer(verdict=Verdict.SKIPPED, message=message)
            continue
        if name not in made:
            pipe.send(("begin", name, load_limit(limits)))
            made[name] = make_target(name, limits)
        target = made[name]
        assert not isinstance(target, Check)
        _begin(pipe, name, limits)
        answers[name] = target.sum(case)
        if answers[name].verdict is Verdict.TIMED_OUT:  # a machine may stand still: once more
            _begin(pipe, name, limits)
            answers[name] = target.sum(case)
    _begin(pipe, "minkref:referee", limits)
    return _result(job, case, [*ruled, *judge(case, answers, targets)], answers)


def _rule(
    pipe: Connection,
    job: Job,
    case: Case,
    name: str,
    limits: Limits,
    made: dict[str, Target | Check],
) -> Outcome:
    """The reference before one judge."""
    if name in job.lost:
        return job.lost[name]
    pipe.send(("begin", name, load_limit(limits)))
    if name not in made:
        made[name] = Check(name, limits.size)
    check = made[name]
    assert isinstance(check, Check)
    _begin(pipe, name, limits)
    return check.rule(case)


def is_check(name: str) -> bool:
    return name.startswith(PREFIX)


def _begin(pipe: Connection, step: str, limits: Limits) -> None:
    pipe.send(("begin", step, wall_clock_limit(step, limits)))


def _result(
    job: Job, case: Case, outcomes: list[Outcome], answers: dict[str, Answer]
) -> CaseResult:
    result = CaseResult(
        job.number, job.name, case.scale, outcomes, case.P_name, case.Q_name, case.size
    )
    if any(outcome.verdict not in (Verdict.PASS, Verdict.SKIPPED) for outcome in outcomes):
        wrong = {outcome.target for outcome in outcomes if outcome.verdict is Verdict.WRONG}
        result.P, result.Q = case.P_json, case.Q_json
        result.expected = next(
            (
                answer.region.json
                for name, answer in answers.items()
                if name in TRUTHS and answer.region and name not in wrong
            ),
            None,
        )
    return result


def load_limit(limits: Limits) -> float:
    """Seconds for the import of the module of a `py:` target, which is no call of it."""
    return max(LOAD_SECONDS, limits.seconds)


def wall_clock_limit(name: str, limits: Limits) -> float:
    """Seconds after which the parent ends a worker that is still at `name`. The children of the
    CGAL oracle have their own, tighter clock."""
    grace: dict[str, Any] = {"minkref:case": 60.0, "minkref:referee": 120.0}
    if name in grace:
        return float(grace[name])
    if is_check(name):
        return JUDGE_SECONDS
    return limits.seconds + (2 * cgal_server.GRACE_SECONDS if name.startswith("cgal-") else 0)
