"""The programs extracted from proofs, against the reference: sums and decisions of points, of which
every answer is proved to be right. A missing answer, which no proof excludes, is a fault here."""

from __future__ import annotations

import json
import random
import tempfile
import time
from collections import Counter
from collections.abc import Sequence
from fractions import Fraction
from pathlib import Path
from typing import Any

from minkref import _core, proved_program
from minkref.certify.plane.certificate import Certificate
from minkref.exact import digest
from minkref.fuzz.cases.case_name import CaseName
from minkref.fuzz.judges.plane.slow_points import points_of
from minkref.fuzz.plane.case import Case
from minkref.fuzz.plane.families.catalogue import FAMILIES
from minkref.fuzz.run import naming
from minkref.reports.evidence.certificates.certified_cases import star, written
from minkref.reports.evidence.certificates.checkers import ROOT, in_proved, verdicts
from minkref.reports.evidence.framework.in_processes import in_processes
from minkref.reports.evidence.framework.part import Counts, Findings, Minutes, Size

RESTS_ON = ("oracle/proved/",)
MINUTES = Minutes(None, 2, 60)

SEED = 1130
CASES, THIN = Counts(60, 600, 25_600), Counts(2, 20, 1200)  # of all families, and of one more
PAIRS, THIN_PAIRS = Counts(40, 450, 20_000), Counts(2, 40, 2000)
SUMS, POINTS = Counts(150, 2000, 60_000), Counts(200, 2500, 150_000)
EVERY = Counts(60, 10, 1)  # of the corpus's cases
PROVED_TOO = 40  # one of so many cases has its sum proved by a certificate, too
MOST_PAIRS, MOST_PAIRS_POINTS = 150, 1600  # of vertices, for sums and for points
THIN_FAMILY = "degenerate"
CORPUS = ROOT / "degeneracies" / "corpus"
ORIGIN = '{"polygons": [{"outer": [["0", "0"]], "holes": []}]}'
STARS = Counts((12,), (12, 20), (12, 20, 40))  # corners of each of two stars


def names(size: Size) -> list[str]:
    """Pairs of all families in turn, then of points, segments and empty sets only."""
    families = list(FAMILIES)
    rounds = [(families[i % len(families)], i // len(families)) for i in range(size.of(CASES))]
    more = [(THIN_FAMILY, i) for i in range(size.of(CASES), size.of(CASES) + size.of(THIN))]
    return [f"{family}:{SEED}:{number}" for family, number in rounds + more]


def judge(name: str) -> dict[str, Any]:
    """One pair: points; and if it is small its sums at the given scale, and at, beside and between
    two of its boundary events."""
    case = naming.load(CaseName(name, "evidence"))
    tally: Counter[str] = Counter()
    faults: list[str] = []
    if not isinstance(case, Case) or case.vertex_pairs > MOST_PAIRS_POINTS:
        return {"tally": tally, "faults": faults}
    thin = [not (o.is_region or o.is_empty) for o in (case.P, case.Q)]
    if not all(thin) and case.vertex_pairs <= MOST_PAIRS:
        for scale in _scales(case):
            _compare(tally, faults, case, scale)
        if int(name.rpartition(":")[2]) % PROVED_TOO == 0:
            _prove(tally, faults, case)
        tally["pairs"] += 1
        tally["with a point or a segment"] += any(thin)
    _decide(tally, faults, case)
    return {"tally": tally, "faults": faults}


def _scales(case: Case) -> list[str]:
    if not case.is_uniform:
        return [case.scale]
    dynamic = _core.DynamicSum(case.P, case.Q, "1/4", "4")
    events = sorted({Fraction(row[0]) for row in dynamic.boundary_events()})
    dice = random.Random(case.name.text)
    found = [Fraction(case.scale)]
    for event in dice.sample(events, min(2, len(events))):
        after = next((other for other in events if other > event), Fraction(5))
        found += [event, event + (after - event) / 10**9, (event + after) / 2]
    return [str(scale) for scale in dict.fromkeys(found)]


def _compare(tally: Counter[str], faults: list[str], case: Case, scale: str) -> float:
    """Seconds of the proved program"""
    ours = _core.minkowski_sum(case.P, case.Q, scale)
    asked = scale.split(",") if "," in scale else scale
    began = time.perf_counter()
    theirs = _answer(case.P_json, case.Q_json, asked)
    seconds = time.perf_counter() - began
    expected = {
        "digest": digest(ours.region.canonical_json()),
        "components": ours.components,
        "holes": ours.holes,
    }
    tally["sums"] += 1
    if any(theirs.get(name) != value for name, value in expected.items()):
        faults.append(f"{case.name.text} at {scale}")
    return seconds


def _answer(P: str, Q: str, scale: str | list[str]) -> dict[str, Any]:
    """The program's sum; nothing where it does not answer, which differs from each sum."""
    try:
        return proved_program.whole_sum(P, Q, scale)
    except RuntimeError:
        return {}


def _prove(tally: Counter[str], faults: list[str], case: Case) -> None:
    """The checker that is proved right takes a certificate of the same digest: the program's answer
    is the sum, in its one canonical form."""
    if not case.is_uniform:
        return
    theirs = proved_program.whole_sum(case.P_json, case.Q_json, case.scale)
    certificate = Certificate(case.P, case.Q)
    certificate.sum(case.scale)
    with tempfile.TemporaryDirectory() as folder:
        (verdict,) = verdicts(in_proved(), [written(certificate, Path(folder), "it")])
    tally["proved"] += 1
    if verdict.code or certificate.claims[0]["digest"] != theirs["digest"]:
        faults.append(f"{case.name.text}: a certificate of the program's answer")


def _decide(tally: Counter[str], faults: list[str], case: Case) -> None:
    points = [(str(x), str(y)) for x, y in points_of(case)]
    if not points or not case.is_uniform:
        return
    answers = proved_program.points(case.P_json, case.Q_json, case.scale, points)
    ours = [_core.decide(case.P, case.Q, case.scale, *x) for x in points]
    for x, is_in, found in zip(points, answers, ours, strict=True):
        tally["in" if is_in else "out"] += 1
        if is_in != (found["contact"] != "empty"):
            faults.append(f"{case.name.text}: ({', '.join(x)})")
    for name, operand in (("p", case.P_json), ("q", case.Q_json)):
        own = [found[name] for found in ours if found["contact"] != "empty"]
        if own and not all(proved_program.points(operand, ORIGIN, "1", own)):
            faults.append(f"{case.name.text}: a {name} that its operand does not have")
    for x, found in zip(points, ours, strict=True):
        if found["contact"] != "empty" and not _adds_up(x, case.scale, found["p"], found["q"]):
            faults.append(f"{case.name.text}: p and q do not add up to ({', '.join(x)})")


def _adds_up(x: Sequence[str], scale: str, p: Sequence[str], q: Sequence[str]) -> bool:
    return all(
        Fraction(scale) * Fraction(a) + Fraction(b) == Fraction(c)
        for a, b, c in zip(p, q, x, strict=True)
    )


def judge_corpus(path: Path) -> dict[str, Any]:
    """The digests, components and holes that stand in a case of the corpus."""
    case = json.loads(path.read_text(encoding="utf-8"))
    faults = []
    P, Q = (json.dumps(case[name]) for name in "PQ")
    known = [row for row in case["expected"] if "digest" in row]
    for row in known:
        found = _answer(P, Q, row["scale"])
        if any(found.get(name) != row[name] for name in ("digest", "components", "holes")):
            faults.append(f"{case['id']} at {row['scale']}")
    return {"sums": len(known), "faults": faults}


def corpus() -> list[Path]:
    return [
        path
        for path in sorted(CORPUS.rglob("*.json"))
        if not path.name.endswith(".cert.json") and _has_sums(path)
    ]


def _has_sums(path: Path) -> bool:
    case = json.loads(path.read_text(encoding="utf-8"))
    return case.get("schema") == "case-v1" and case["dimension"] == 2 and bool(case.get("expected"))


def is_absent(findings: Findings) -> bool:
    """Whether the program is not built, which is then told."""
    if proved_program.found() is not None:
        return False
    findings.note(f"{proved_program.BUILT_BY}: nothing of this step was run")
    findings.target(f"{proved_program.PROGRAM} is built", False, "built", "absent")
    return True


def run(findings: Findings, size: Size) -> None:
    if is_absent(findings):
        return
    tally: Counter[str] = Counter()
    faults: list[str] = []
    for found in in_processes(judge, names(size), 500, "pairs"):
        tally += found["tally"]
        faults += found["faults"]
    findings.none(f"sums or points on which the program and the reference differ ({SEED=})", faults)
    points = tally["in"] + tally["out"]
    thin = tally["with a point or a segment"]
    for what, wanted, reached in (
        ("pairs, of which sums are", size.of(PAIRS), tally["pairs"]),
        ("pairs with a point or a segment", size.of(THIN_PAIRS), thin),
        ("sums, at, beside and between events", size.of(SUMS), tally["sums"]),
        ("points", size.of(POINTS), points),
    ):
        findings.law(f"{what}, compared", reached >= wanted, f"{wanted:,}", f"{reached:,}")
    findings.figures["points of these in the sum"] = f"{tally['in']:,}"
    findings.figures["answers whose digest a certificate proves, too"] = tally["proved"]
    results = list(in_processes(judge_corpus, corpus()[:: size.of(EVERY)], 100, "of the corpus"))
    faulty = [fault for found in results for fault in found["faults"]]
    findings.none("sums of the corpus that the program answers otherwise", faulty)
    findings.figures["sums of the corpus"] = f"{sum(found['sums'] for found in results):,}"
    for corners in size.of(STARS):
        P, Q = star(corners, SEED), star(corners, SEED + 1)
        case = Case(CaseName(f"stars of {corners}", "evidence"), P, Q, "7/5", "P", "Q")
        faults = []
        seconds = _compare(tally, faults, case, case.scale)
        findings.none(f"two stars of {corners} corners, on which they differ", faults)
        findings.figures[f"seconds of the program for these, {corners} x {corners}"] = (
            f"{seconds:.1f}"
        )
