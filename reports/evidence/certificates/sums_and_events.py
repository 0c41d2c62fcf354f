"""Certificates for many sums and events, followed by both checkers: verdicts, sizes, times."""

from __future__ import annotations

import statistics
import tempfile
import time
from collections import Counter
from collections.abc import Callable, Iterator
from fractions import Fraction
from functools import partial
from pathlib import Path

from minkref import _core
from minkref.certify.plane.certificate import Certificate
from minkref.fuzz.plane.case import Case
from minkref.reports.evidence.certificates.certified_cases import (
    cases,
    events,
    star,
    wound,
    written,
)
from minkref.reports.evidence.certificates.checkers import in_cpp, in_python, timed
from minkref.reports.evidence.framework.operands import operand
from minkref.reports.evidence.framework.part import Counts, Findings, Minutes, Size

MINUTES = Minutes(None, 1, 15)

SEED = 1611
WINDOWS = Counts(0, 15, 150)
COUNT, COUNT_SMALL = Counts(0, 50, 500), Counts(0, 20, 100)
EVENTS_EACH = 3
EVENTS_INSIDE = 6
SMALL = 12
SMALL_SECONDS = 0.2
LARGE_SECONDS = {"Python": 60.0, "C++": 5.0}
Row = dict[str, float]
Work = tuple[str, Callable[[], Certificate]]  # a name, and the timed call


def run(findings: Findings, size: Size) -> None:
    with tempfile.TemporaryDirectory() as name:
        folder = Path(name)
        _many(findings, "sums", _sums(), size.of(COUNT), folder)
        _many(findings, "events", _events(), size.of(COUNT), folder)
        _many(findings, "windows", _windows(), size.of(WINDOWS), folder)
        _many(findings, "all passages", _all_passages(), size.of(COUNT), folder)
        _many(findings, "pairs of 12 vertices", _small(), size.of(COUNT_SMALL), folder)
        _large(findings, folder)


def _sum(case: Case) -> Certificate:
    certificate = Certificate(case.P, case.Q)
    certificate.sum(case.scale, passages=True)
    return certificate


def _event(case: Case, scale: Fraction, before: Fraction) -> Certificate:
    certificate = Certificate(case.P, case.Q)
    certificate.event(scale, before)
    return certificate


def _sums() -> Iterator[Work]:
    for case in cases(SEED):
        yield case.name.text, partial(_sum, case)


def _events() -> Iterator[Work]:
    for case, scale, before in events(SEED, EVENTS_EACH):
        yield f"{case.name.text} at {scale}", partial(_event, case, scale, before)


def _window(case: Case, first: Fraction, last: Fraction) -> Certificate:
    certificate = Certificate(case.P, case.Q)
    certificate.events(first, last)
    return certificate


def _windows() -> Iterator[Work]:
    """All events between two scales, which are events themselves in turn or halfway to the next,
    of small cases; up to `EVENTS_INSIDE` of them."""
    for case, scale, before in events(SEED + 1, 1):
        rows = _core.DynamicSum(case.P, case.Q, str(before), "4").boundary_events()
        scales = sorted({Fraction(row[0]) for row in rows} | {before, scale, Fraction(4)})
        at = scales.index(before)
        inside = scales[at : at + EVENTS_INSIDE + 2]
        last = inside[-1] if at % 2 else (inside[-2] + inside[-1]) / 2
        name = f"{case.name.text} from {before} to {last}"
        yield name, partial(_window, case, before, last)


def _all_of_sum(case: Case) -> Certificate:
    certificate = Certificate(case.P, case.Q)
    certificate.sum(case.scale, complete=True)
    return certificate


def _all_passages() -> Iterator[Work]:
    for case in cases(SEED + 2):
        if case.P.is_region and case.Q.is_region:
            yield case.name.text, partial(_all_of_sum, case)


def _small() -> Iterator[Work]:
    """Sums of pairs with 12 vertices per operand."""

    def fits(case: Case) -> bool:
        return case.P.vertices == case.Q.vertices == SMALL

    for case in filter(fits, cases(SEED, ("random", "convex", "star", "holes", "spiral"))):
        yield case.name.text, partial(_sum, case)


def _many(findings: Findings, what: str, wanted: Iterator[Work], count: int, folder: Path) -> None:
    rows: list[Row] = []
    kinds: Counter[str] = Counter()
    refused = []
    while len(rows) < count:
        name, work = next(wanted)
        began = time.perf_counter()
        certificate = work()
        file = written(certificate, folder, "it")
        made = time.perf_counter() - began
        row, codes, why = _followed(file)
        rows.append({**row, "made": made})
        kinds.update(_kind(claim) for claim in certificate.claims)
        if any(codes):
            refused.append(f"{name}: {why}")
    findings.law(f"certificates of {what} verified by both checkers", not refused, count,
                 f"{count - len(refused)}{'; '.join(['', *refused[:3]])}")  # fmt: skip
    findings.figures[f"{what}: claims"] = dict(sorted(kinds.items()))
    findings.figures[f"{what}: bytes, median and most"] = _spread(rows, "bytes", 0)
    findings.figures[f"{what}: seconds to find and write a proof"] = _spread(rows, "made")
    for checker in ("Python", "C++"):
        title = f"{what}: seconds of the checker in {checker}, median and most"
        findings.figures[title] = _spread(rows, checker)
    if what.startswith("pairs"):
        most = {checker: max(row[checker] for row in rows) for checker in ("Python", "C++")}
        for checker, seconds in most.items():
            title = f"two operands of 12 vertices: most seconds in {checker}, with its start"
            findings.target(title, seconds < SMALL_SECONDS, f"under {SMALL_SECONDS}",
                            f"{seconds:.3f}")  # fmt: skip


def _large(findings: Findings, folder: Path) -> None:
    """A hundred vertices and thirty: a dog and a letter, stars, spirals."""
    pairs = {
        "dog145 and g1, 145 and 30 vertices": (operand("dog145").set, operand("g1").set),
        "stars of 100 and 30": (star(100, SEED), star(30, SEED + 1)),
        "spirals of 100 and 30": (wound(100, 16, Fraction(4)), wound(30, 1, Fraction(1, 2))),
    }
    for title, (P, Q) in pairs.items():
        began = time.perf_counter()
        certificate = Certificate(P, Q)
        certificate.sum("1", passages=True)
        file = written(certificate, folder, "large")
        made = time.perf_counter() - began
        row, codes, why = _followed(file)
        findings.law(f"{title}: verified by both checkers", not any(codes), "both", why or "both")
        findings.figures[title] = (
            f"{row['bytes']:,.0f} bytes, made in {made:.2f} s; "
            f"Python {row['Python']:.2f} s, C++ {row['C++']:.2f} s"
        )
        for checker, limit in LARGE_SECONDS.items():
            findings.target(f"{title}: seconds in {checker}", row[checker] < limit,
                            f"under {limit:.0f}", f"{row[checker]:.2f}")  # fmt: skip


def _followed(file: Path) -> tuple[Row, list[int], str]:
    row: Row = {"bytes": file.stat().st_size}
    codes, whys = [], []
    for checker, command in (("Python", in_python()), ("C++", in_cpp())):
        verdict, row[checker] = timed(command, file)
        codes.append(verdict.code)
        whys.append(verdict.why)
    return row, codes, "; ".join(filter(None, whys))


def _kind(claim: dict[str, str]) -> str:
    return f"{claim['kind']} event" if claim["claim"] == "event" else claim["claim"]


def _spread(rows: list[Row], name: str, digits: int = 3) -> str:
    values = [row[name] for row in rows]
    return f"{statistics.median(values):,.{digits}f} and {max(values):,.{digits}f}"
