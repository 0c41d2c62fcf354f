"""Counts of a campaign, and its kinds of findings, taken chunk after chunk in the campaign's order:
which case shows a kind first does not depend on the workers."""

from __future__ import annotations

import hashlib
from collections import Counter
from collections.abc import Iterable, Sequence
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any

from minkref.fuzz.campaign.folder import ranges_of, read_json, small_path, state_path, write_json
from minkref.fuzz.run.ledger import plain_of, result_of
from minkref.fuzz.run.runner import Cell, Finding, Run, coverage_of, take
from minkref.fuzz.run.worker import CaseResult
from minkref.fuzz.shrink.finding import SmallFinding
from minkref.fuzz.shrink.groups import UNSHRUNK, Group, merged
from minkref.fuzz.verdicts.baseline import Baseline

FORMAT = "campaign-state-v1"


@dataclass
class Kind:
    """Findings with one target, verdict and reasons. `first`: in the campaign's order. `tried`: no
    shrinking is due."""

    first: Finding
    count: int = 1
    small: SmallFinding | None = None
    unshrunk: str = ""
    tried: bool = False

    @property
    def key(self) -> str:
        target, verdict, kinds = self.first.kind
        return "|".join((target, verdict, *kinds, self.first.case.name.text))

    @property
    def wants_shrinking(self) -> bool:
        return not self.tried and self.first.outcome.verdict not in UNSHRUNK


@dataclass
class Tally:
    """`run` has the matrix."""

    folder: Path
    campaign: str
    versions: dict[str, str | None]
    baseline: Baseline
    run: Run
    kinds: dict[tuple[str, str, tuple[str, ...]], Kind] = field(default_factory=dict)
    behaviours: set[str] = field(default_factory=set)
    taken: set[int] = field(default_factory=set)
    spent: float = 0.0  # seconds of all runs
    cases: int = 0
    unproven: dict[str, tuple[int, str]] = field(default_factory=dict)  # passes, the first of them

    @property
    def findings(self) -> int:
        return sum(kind.count for kind in self.kinds.values())

    def add(self, number: int, results: Sequence[CaseResult]) -> list[Kind]:
        """Counts a chunk. Returns new kinds."""
        self.taken.add(number)
        self.run.findings.clear()  # `finished` may have put the first ones there
        for result in results:
            take(self.run, result, self.versions, self.baseline)
            if (coverage := coverage_of(result)) is not None:
                self.behaviours.add(hashlib.sha256(coverage.encode()).hexdigest()[:16])
        self.cases = self.run.cases.total()
        new = []
        for finding in self.run.findings:
            known = self.kinds.get(finding.kind)
            if known is None:
                self.kinds[finding.kind] = kind = Kind(finding)
                self._read_small(kind)
                new.append(kind)
            else:
                known.count += 1
        for target, remarks in self.run.remarks.items():
            count, first = self.unproven.get(target, (0, remarks[0][1]))
            self.unproven[target] = count + len(remarks), first
        self.run.findings.clear()
        self.run.remarks.clear()
        return new

    def finished(self) -> Run:
        """Returns the run with one finding for each kind."""
        self.run.findings = [kind.first for kind in self.kinds.values()]
        return self.run

    def groups(self) -> list[Group]:
        """Returns kinds as `minkref verify` shows them, the most serious first."""
        groups = []
        for finding, _ in self.finished().smallest():
            kind = self.kinds[finding.kind]
            small = [kind.small] if kind.small is not None else []
            groups.append(Group(finding, kind.count, kind.unshrunk, small))
        return merged(groups)

    def keep_small(self, kind: Kind, made: SmallFinding | str | None) -> None:
        """Writes a shrunk finding, which no later run shrinks again."""
        kind.tried = True
        kind.small = made if isinstance(made, SmallFinding) else None
        kind.unshrunk = made if isinstance(made, str) else ""
        if not kind.unshrunk:
            path = small_path(self.folder, self.campaign, kind.key)
            write_json(path, {"key": kind.key, "small": _plain_small(kind.small)})

    def write(self) -> None:
        """Writes the state."""
        self.finished()
        cells = [
            [target, group, cell.verdicts, cell.skips, round(cell.seconds, 6)]
            for (target, group), cell in self.run.matrix.items()
        ]
        value = {
            "format": FORMAT,
            "baseline": _digest(self.baseline),
            "spent": round(self.spent, 3),
            "taken": ranges_of(self.taken),
            "groups": self.run.groups,
            "cases": self.run.cases,
            "matrix": cells,
            "absent": self.run.absent,
            "untaken": self.run.untaken,
            "unproven": self.unproven,
            "behaviours": sorted(self.behaviours),
            "kinds": [
                [kind.first.outcome.target, kind.count, plain_of(kind.first.case)]
                for kind in self.kinds.values()
            ],
        }
        write_json(state_path(self.folder, self.campaign), value)

    def read(self) -> None:
        """Continues from a state with this baseline. Without one, the ledger is counted anew; only
        the time spent is lost."""
        path = state_path(self.folder, self.campaign)
        if not path.is_file():
            return
        value = read_json(path)
        if value.get("format") != FORMAT:
            return
        self.spent = float(value["spent"])
        if value["baseline"] != _digest(self.baseline):
            return
        self.taken = {number for a, b in value["taken"] for number in range(a, b)}
        run = self.run
        run.groups, run.cases = value["groups"], Counter(value["cases"])
        run.absent, run.untaken = value["absent"], Counter(value["untaken"])
        for target, group, verdicts, skips, seconds in value["matrix"]:
            run.matrix[target, group] = Cell(Counter(verdicts), Counter(skips), seconds)
            if target not in run.targets:
                run.targets.append(target)
        self.unproven = {target: (n, first) for target, (n, first) in value["unproven"].items()}
        self.behaviours, self.cases = set(value["behaviours"]), run.cases.total()
        for target, count, plain in value["kinds"]:
            kind = Kind(_finding(target, result_of(plain), self), count)
            self._read_small(kind)
            self.kinds[kind.first.kind] = kind

    def _read_small(self, kind: Kind) -> None:
        path = small_path(self.folder, self.campaign, kind.key)
        if path.is_file():
            value = read_json(path)
            if value.get("key") == kind.key:
                kind.tried, kind.small = True, _small_of(value["small"])


def _finding(target: str, case: CaseResult, tally: Tally) -> Finding:
    outcome = next(o for o in case.outcomes if o.target == target)
    return Finding(tally.baseline.apply(outcome, tally.versions.get(target)), case)


def _digest(baseline: Baseline) -> str:
    return hashlib.sha256(repr(baseline).encode()).hexdigest()[:16]


def _plain_small(small: SmallFinding | None) -> dict[str, Any] | None:
    if small is None:
        return None
    return {
        **{name: value for name, value in vars(small).items() if name != "outcome"},
        "result": plain_of(small.result),
        "outcome": small.outcome.target,
    }


def _small_of(value: dict[str, Any] | None) -> SmallFinding | None:
    if value is None:
        return None
    result = result_of(value["result"])
    outcome = next(o for o in result.outcomes if o.target == value["outcome"])
    return SmallFinding(**{**value, "result": result, "outcome": outcome})


def wanting(kinds: Iterable[Kind]) -> list[Kind]:
    """Returns kinds to shrink."""
    return [kind for kind in kinds if kind.wants_shrinking]
