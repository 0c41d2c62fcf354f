"""The cost of an adapter's walls: for a start, and for each case of a running adapter."""

from __future__ import annotations

import statistics
import sys
import tempfile
import time
from collections.abc import Sequence
from pathlib import Path

from minkref.fuzz.cases.case_name import CaseName
from minkref.fuzz.isolation.isolation import NONE, SANDBOX, Isolation, choose
from minkref.fuzz.isolation.sandbox import absence
from minkref.fuzz.plane.case import Case
from minkref.fuzz.run import naming
from minkref.fuzz.settings import asking_about
from minkref.fuzz.targets.adapter import AdapterTarget
from minkref.fuzz.targets.adapter_process import AdapterProcess
from minkref.fuzz.targets.answer import Limits
from minkref.reports.evidence.framework.of_tests import SEEDED
from minkref.reports.evidence.framework.part import Counts, Findings, Minutes, Size

MINUTES = Minutes(None, 0.5, 3)
ALONE = True

STARTS = Counts(0, 40, 150)
ROUNDS = Counts(0, 6, 25)
CASES = 60
MOST_MILLISECONDS, MOST_SHARE = 10.0, 0.02
GREETS = (
    "import json, sys\n"
    "for line in sys.stdin:\n"
    "    seq = json.loads(line)['seq']\n"
    "    words = {'status': 'result', 'protocol': 'adapter-v1', 'capabilities': ['plane']}\n"
    "    print(json.dumps({'seq': seq, **words}), flush=True)\n"
)


def run(findings: Findings, size: Size) -> None:
    why = absence()
    if why is not None:
        findings.target("a sandbox", False, "available", why)
        return
    walls = [choose(SANDBOX), choose(NONE)]
    for each in walls:
        findings.figures[f"walls: {each.kind}"] = each.sentence()
    starts = _starts(walls, size.of(STARTS))
    more = _report(findings, "milliseconds to the greeting", starts, 1000)
    wanted = f"{MOST_MILLISECONDS:g} ms at most"
    met = more <= MOST_MILLISECONDS
    findings.target("more for a start, middle of the pairs", met, wanted, f"{more:.1f} ms")
    rounds = _rounds(walls, size.of(ROUNDS))
    lost = _report(findings, f"seconds for {CASES} cases", rounds, 1)
    share = lost / statistics.median(rounds[1])
    met = share <= MOST_SHARE
    findings.target("share of the throughput, middle", met, MOST_SHARE, f"{share:.3f}")


def _report(findings: Findings, what: str, times: list[list[float]], unit: float) -> float:
    """The median difference between the alternating measurements."""
    for kind, values in zip((SANDBOX, NONE), times, strict=True):
        least, middle, most = min(values), statistics.median(values), max(values)
        findings.figures[f"{what}, {kind}"] = (
            f"{middle * unit:.3g} ({least * unit:.3g} to {most * unit:.3g})"
        )
    differences = [a - b for a, b in zip(*times, strict=True)]
    return float(unit * statistics.median(differences))


def _starts(walls: list[Isolation], count: int) -> list[list[float]]:
    """Start times, alternating between sandbox and none."""
    times: list[list[float]] = [[], []]
    with tempfile.TemporaryDirectory(prefix="minkref-start-") as folder:
        program = Path(folder, "greets.py")
        program.write_text(GREETS, encoding="utf-8")
        words = [sys.executable, "-S", "-E", str(program)]
        for number in range(2 * count):
            kind = number % 2
            process = AdapterProcess("it", words, Limits(isolation=walls[kind]))
            since = time.perf_counter()
            process.start()
            times[kind].append(time.perf_counter() - since)
            process.close()
    return times


def _rounds(walls: list[Isolation], count: int) -> list[list[float]]:
    """Times for the same cases with a running adapter, alternating between sandbox and none."""
    words = [sys.executable, str(SEEDED / "seeded_adapter.py"), "sound"]
    names = [f"random:12:{index}" for index in range(CASES)]
    cases = [naming.load(CaseName(name, "random")) for name in names]
    targets = [AdapterTarget("it", words, Limits(isolation=each)) for each in walls]
    times: list[list[float]] = [[], []]
    try:
        for kind in (0, 1):
            _ask(targets[kind], cases)  # starts the adapter, which loads its modules
        for number in range(2 * count):
            kind = number % 2
            since = time.perf_counter()
            _ask(targets[kind], cases)
            times[kind].append(time.perf_counter() - since)
    finally:
        for target in targets:
            target.close()
    return times


def _ask(target: AdapterTarget, cases: Sequence[object]) -> None:
    for case in cases:
        assert isinstance(case, Case)
        asking = asking_about(case, lambda _: target, lambda _: None, {}, Limits())
        (outcome,) = asking.outcomes(["it"])
        if outcome.verdict != "pass":
            raise RuntimeError(f"{case.name.text}: {outcome.verdict} {outcome.message}")
