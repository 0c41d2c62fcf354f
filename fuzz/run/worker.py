"""One worker process of a run: takes cases from a pipe, runs the targets on each, judges,
answers."""

from __future__ import annotations

import resource
import traceback
from dataclasses import dataclass, field
from multiprocessing.connection import Connection

from minkref.fuzz.cases.any_case import AnyCase
from minkref.fuzz.cases.case_name import CaseName
from minkref.fuzz.cases.no_case import NoCase
from minkref.fuzz.cases.verbs import is_features, is_offset, is_path, is_union
from minkref.fuzz.cgal import server as cgal_server
from minkref.fuzz.plane.case import Case
from minkref.fuzz.run import child, naming
from minkref.fuzz.run.catalogue import Catalogue, is_judge
from minkref.fuzz.run.offer import Judge
from minkref.fuzz.settings import asking_about
from minkref.fuzz.targets.answer import Limits, Target, load_limit
from minkref.fuzz.targets.asking import JUDGING, Asking
from minkref.fuzz.verdicts.verdict import GOOD, Outcome, Verdict

CASE = "minkref:case"  # the step before any target: the case is made
CASE_SECONDS = 60.0
JUDGING_SECONDS = 120.0  # for judging one answer
JUDGE_SECONDS = 600.0  # for one judge on one case: slow by design


@dataclass
class Job:
    """A case for a worker. `lost` holds targets that took down a worker before, `overdue` targets
    that ran out of time or were killed once; a second time counts."""

    number: int
    name: CaseName
    learning: bool = False  # whether to report the case's coverage
    generated: bool = False  # may be left out if no target takes it
    resting: frozenset[str] = frozenset()  # targets not to ask
    lost: dict[str, Outcome] = field(default_factory=dict)
    overdue: set[str] = field(default_factory=set)


@dataclass
class CaseResult:
    """A worker's result for one case. Sets are texts, present only if something is amiss. `absent`
    says why the case does not exist, `untaken` why no target takes it. `coverage`: the case's
    features, without faults. `needs`: the capabilities that the case asks for, if a target declares
    some."""

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
    literal: str | None = None
    dimension: int = 2
    family: str = ""
    position: str = ""
    coverage: str | None = None
    absent: str | None = None
    untaken: str | None = None
    generated: bool = False
    needs: tuple[str, ...] = ()

    @property
    def is_run(self) -> bool:
        return self.absent is None and self.untaken is None

    @property
    def path(self) -> str | None:
        """Returns the question of a path case, if something is amiss. Its `scale` means nothing:
        the question covers many."""
        return self.literal if self.literal is not None and is_path(self.literal) else None

    @property
    def union(self) -> str | None:
        """Returns the sets to unite as a case's text, if something is amiss."""
        return self.literal if self.literal is not None and is_union(self.literal) else None

    @property
    def offset(self) -> str | None:
        """Returns the set to grow, with the radius, as a case's text, if something is amiss."""
        return self.literal if self.literal is not None and is_offset(self.literal) else None

    @property
    def features(self) -> str | None:
        """Returns the set whose features are asked for, likewise."""
        return self.literal if self.literal is not None and is_features(self.literal) else None


def work(pipe: Connection, targets: list[str], catalogue: Catalogue, limits: Limits) -> None:
    """A worker's loop. Before each step it announces the target and its time limit, so that the
    parent knows whose fault this process's death is."""
    child.begin()
    _limit_memory(limits.bytes + limits.judging_bytes)
    made = Made(catalogue, limits)
    try:
        while True:
            job = pipe.recv()
            if job is None:
                return
            try:
                pipe.send(("done", _Work(pipe, job, targets, made).result()))
            except (BrokenPipeError, EOFError):
                return
            except MemoryError:
                pipe.send(("no memory",))
            except Exception as error:  # noqa: BLE001 the parent reports it
                pipe.send(("failed", f"{job.name.text}: {error}", traceback.format_exc()))
    except (EOFError, OSError):
        return
    finally:
        made.close()


def _limit_memory(bytes_allowed: int) -> None:
    _, hard = resource.getrlimit(resource.RLIMIT_AS)
    if hard == resource.RLIM_INFINITY or bytes_allowed < hard:
        resource.setrlimit(resource.RLIMIT_AS, (bytes_allowed, hard))


@dataclass
class Made:
    """Targets and judges of a worker, kept from one case to the next."""

    catalogue: Catalogue
    limits: Limits
    targets: dict[str, Target] = field(default_factory=dict)
    judges: dict[str, Judge] = field(default_factory=dict)

    def target(self, name: str) -> Target:
        if name not in self.targets:
            self.targets[name] = self.catalogue.target(name, self.limits)
        return self.targets[name]

    def judge(self, name: str) -> Judge:
        if name not in self.judges:
            self.judges[name] = self.catalogue.judges.make(name, self.limits)
        return self.judges[name]

    def close(self) -> None:
        held: list[Target | Judge] = [*self.targets.values(), *self.judges.values()]
        for each in held:
            each.close()


@dataclass
class _Work:
    """One case before all targets."""

    pipe: Connection
    job: Job
    targets: list[str]
    made: Made

    def result(self) -> CaseResult:
        self._begin(CASE)
        try:
            case = naming.load(self.job.name)
        except NoCase as reason:
            return self._absent(str(reason))
        except MemoryError:
            return self._absent("there is too little memory to make it")
        asking = asking_about(case, self.made.target, self._begin, self.job.lost, self.made.limits)
        ruled = []
        if isinstance(case, Case) and case.law is None:
            ruled = [self._rule(case, name) for name in self.targets if is_judge(name)]
        names = [name for name in self.targets if name not in self.job.resting]
        outcomes = asking.outcomes([name for name in names if not is_judge(name)])
        if self.job.generated and not any(map(is_judge, self.targets)) and all_skip(outcomes):
            job, why = self.job, outcomes[0].message
            return CaseResult(job.number, job.name, "1", outcomes, "", "", (0, 0, ""), untaken=why)
        return self._result(case, [*ruled, *outcomes], asking)

    def _absent(self, why: str) -> CaseResult:
        job = self.job
        return CaseResult(job.number, job.name, "1", [], "", "", (0, 0, ""), absent=why)

    def _rule(self, case: Case, name: str) -> Outcome:
        """Puts the reference before one judge."""
        if name in self.job.lost:
            return self.job.lost[name]
        self.pipe.send(("begin", name, load_limit(self.made.limits)))
        judge = self.made.judge(name)
        self._begin(name)
        return judge.rule(case)

    def _begin(self, step: str) -> None:
        self.pipe.send(("begin", step, wall_clock_limit(step, self.made)))

    def _result(self, case: AnyCase, outcomes: list[Outcome], asking: Asking) -> CaseResult:
        job = self.job
        result = CaseResult(
            job.number, job.name, case.scale, outcomes, case.P_name, case.Q_name, case.size
        )
        result.generated = job.generated
        result.dimension, result.family, result.position = (
            case.dimension,
            case.family,
            case.position,
        )
        if any(map(self.made.catalogue.declares_itself, self.targets)):
            result.needs = tuple(sorted(case.needs))
        if job.learning:
            result.coverage = asking.coverage()
        if any(outcome.verdict not in (*GOOD, Verdict.SKIPPED) for outcome in outcomes):
            result.literal = case.literal
            result.P, result.Q = case.judged_operands
            result.expected = asking.expected(outcomes)
        return result


def all_skip(outcomes: list[Outcome]) -> bool:
    return bool(outcomes) and all(outcome.verdict is Verdict.SKIPPED for outcome in outcomes)


def wall_clock_limit(name: str, made: Made) -> float:
    """Returns the seconds after which the parent ends a worker still at `name`. Child processes of
    the CGAL oracle, adapters and functions have their own, tighter clock."""
    if name == CASE:
        return CASE_SECONDS
    if name.startswith(JUDGING):
        return JUDGING_SECONDS
    if is_judge(name):
        return JUDGE_SECONDS
    limits = made.limits
    if made.catalogue.declares_itself(name):
        return 2 * load_limit(limits) + 6 * limits.seconds
    return limits.seconds + (2 * cgal_server.GRACE_SECONDS if name.startswith("cgal-") else 0)
