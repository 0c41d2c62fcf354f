"""Certifies witnesses of `minkref verify`: all checkers, and changed claims."""

from __future__ import annotations

import json
import os
import random
import statistics
import tempfile
import time
from collections import Counter
from collections.abc import Callable, Iterable, Iterator
from dataclasses import dataclass, field
from itertools import islice, zip_longest
from pathlib import Path
from typing import Any

from minkref.fuzz.all_targets import ALL_TARGETS
from minkref.fuzz.judges.claimed import NO_FORM
from minkref.fuzz.judges.witness_certificate import WitnessCertificate, certificate_of, is_true
from minkref.fuzz.run.case_list import CaseList
from minkref.fuzz.run.runner import Finding
from minkref.fuzz.run.runner import run as run_cases
from minkref.fuzz.targets.answer import Limits
from minkref.fuzz.verdicts.baseline import Baseline
from minkref.reports.evidence.certificates.checkers import in_cpp, in_proved, in_python, verdicts
from minkref.reports.evidence.certificates.witness_mutants import ChangedWitness, changed_witnesses
from minkref.reports.evidence.framework.command import searched
from minkref.reports.evidence.framework.in_processes import in_processes
from minkref.reports.evidence.framework.of_tests import (
    SEEDED,
    VERIFY,
    offset_adapter,
    path_adapter,
    seeded_adapter,
    union_adapter,
)
from minkref.reports.evidence.framework.part import Counts, Findings, Minutes, Size

MINUTES = Minutes(0.2, 0.6, 6)

SEED = 2026
WITNESSES, MUTANTS = Counts(30, 100, 500), Counts(100, 500, 2000)
EVERY = Counts(12, 4, 1)  # one seeded fault of so many
CASES = Counts(4, 20, 60)  # of each family
FAMILIES = ("union", "offsets", "path", "space-slot", "space-ring", "space-cup")
SHOWN_BY = SEEDED / "shown_by.json"  # a case for each seeded fault
SOLIDS = "py:faulty_solids:fills_all"
DECLINED = 5
OF_SUMS = ("certificate-v1", "solid-point-certificate-v1")
Made = tuple[str, WitnessCertificate]


@dataclass
class Tally:
    refused: Counter[str] = field(default_factory=Counter)  # by the change
    true: Counter[str] = field(default_factory=Counter)  # verified, and true as well
    false: list[str] = field(default_factory=list)
    disagreements: list[str] = field(default_factory=list)


def run(findings: Findings, size: Size) -> None:
    made: list[Made] = []
    why: Counter[str] = Counter()
    seconds: list[float] = []
    faults: list[str] = []
    for found in islice(_found(size), size.of(WITNESSES)):
        began = time.perf_counter()
        one = certificate_of(found, "it")
        seconds.append(time.perf_counter() - began)
        name = f"{found.outcome.target.split('/')[-1]}: {found.case.name.text}"
        if one is None:
            why["a finding without a witness"] += 1
        elif one.file is not None:
            made.append((name, one))
        elif one.why_none.startswith(NO_FORM):
            why[one.why_none] += 1
        else:
            faults.append(f"{name}: {one.why_none}")
    findings.none("witnesses with a form of certificate, and without a certificate", faults)
    wanted = size.of(WITNESSES)
    findings.equal("findings of `minkref verify`", wanted, len(seconds))
    _verified(findings, made)
    forms = Counter(json.loads(one.text)["certificate"] for _, one in made)
    findings.figures["certificates by form"] = dict(sorted(forms.items()))
    findings.figures["without one"] = dict(sorted(why.items()))
    findings.figures["bytes, median and most"] = _spread([len(one.text) for _, one in made])
    findings.figures["seconds to make and check one, median and most"] = _spread(seconds)
    of_sums = [row for row in made if json.loads(row[1].text)["certificate"] in OF_SUMS]
    _changed(findings, of_sums, size.of(MUTANTS))


def _found(size: Size) -> Iterator[Finding]:
    """Yields findings about wrong targets, one from each target in turn."""
    shown_by = json.loads(SHOWN_BY.read_text(encoding="utf-8"))
    faults = sorted(shown_by)[:: size.of(EVERY)]
    targets = [union_adapter("parity"), offset_adapter("bevel"), path_adapter("always"), SOLIDS]
    targets += map(seeded_adapter, faults)
    pairs = (shown_by[fault][-1] for fault in faults)
    names = [json.dumps({"P": P, "Q": Q, "scale": "1"}) for P, Q in pairs]
    names += [f"{family}:{SEED}:{k}" for k in range(size.of(CASES)) for family in FAMILIES]
    cases = CaseList(SEED, named=tuple(names), models=False)
    os.environ.update(searched(VERIFY))  # for the function
    done = run_cases(cases, targets, ALL_TARGETS, {}, Baseline(), Limits(seconds=20), 2)
    of = {target: [f for f in done.findings if f.outcome.target == target] for target in targets}
    for row in zip_longest(*of.values()):
        yield from (one for one in row if one is not None and one.outcome.witness is not None)


def _verified(findings: Findings, made: list[Made]) -> None:
    """Puts each certificate before each checker."""
    with tempfile.TemporaryDirectory() as name:
        files = []
        for number, (_, one) in enumerate(made):
            folder = Path(name) / str(number)
            folder.mkdir()
            for file, text in one.files.items():
                (folder / file).write_text(text, encoding="utf-8")
            files.append(folder / (one.file or ""))
        for title, command in _checkers(findings):
            codes = [verdict.code for verdict in verdicts(command, files)]
            passed = (0, DECLINED) if "proved" in title else (0,)
            bad = [name for (name, _), code in zip(made, codes, strict=True) if code not in passed]
            findings.none(f"of {len(made)} certificates, not verified by {title}", bad)
            if DECLINED in codes:
                findings.figures[f"declined by {title}"] = codes.count(DECLINED)


def _checkers(findings: Findings) -> Iterator[tuple[str, list[str]]]:
    makers: Iterable[tuple[str, Callable[[], list[str]]]] = (
        ("check.py", in_python), ("minkref-check", in_cpp), ("the proved checker", in_proved),
    )  # fmt: skip
    for title, make in makers:
        try:
            yield title, make()
        except FileNotFoundError as absent:
            if title != "the proved checker":
                raise
            findings.note(f"not asked: {absent}")


def _changed(findings: Findings, made: list[Made], count: int) -> None:
    each = -(-count // max(1, len(made)))
    tasks = [(number, one.case, one.text, each) for number, (_, one) in enumerate(made)]
    total = Tally()
    for one in in_processes(_judged, tasks, 20, "certificates"):
        for name, value in vars(one).items():
            setattr(total, name, getattr(total, name) + value)
    judged = total.refused.total() + total.true.total() + len(total.false)
    findings.target("mutants", judged >= count, f"at least {count:,}", f"{judged:,}")
    findings.none("mutants that are verified and not true", total.false)
    findings.none("mutants on which the checkers disagree", total.disagreements)
    findings.figures["mutants refused"] = dict(sorted(total.refused.items()))
    findings.figures["mutants verified, and true as well"] = dict(sorted(total.true.items()))


def _judged(task: tuple[int, str, str, int]) -> Tally:
    """Puts changes of one certificate before both checkers, and judges accepted ones."""
    number, case, text, each = task
    found = Tally()
    every = list(islice(changed_witnesses(case, text, random.Random(f"{SEED}:{number}")), each))
    with tempfile.TemporaryDirectory() as name:
        files = [_written(Path(name), k, changed) for k, changed in enumerate(every)]
        ours, theirs = verdicts(in_python(), files), verdicts(in_cpp(), files)
    for changed, one, other in zip(every, ours, theirs, strict=True):
        told = f"certificate {number}, {changed.way}: {changed.certificate['claims']}"
        if one.code != other.code:
            found.disagreements.append(f"{told}: {one.code}, {other.code}")
        if one.code:
            found.refused[changed.way] += 1
        elif is_true(changed.case, changed.certificate["claims"][0]):
            found.true[changed.way] += 1
        else:
            found.false.append(told)
    return found


def _written(folder: Path, number: int, changed: ChangedWitness) -> Path:
    certificate: dict[str, Any] = changed.certificate
    certificate["case"]["path"] = f"{number}.case.json"
    (folder / f"{number}.case.json").write_text(json.dumps(changed.case), encoding="utf-8")
    file = folder / f"{number}.cert.json"
    file.write_text(json.dumps(certificate), encoding="utf-8")
    return file


def _spread(values: list[Any]) -> str:
    return f"{statistics.median(values):.4g}, {max(values):.4g}" if values else "-"
