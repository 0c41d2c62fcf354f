"""The programs extracted from proofs, against the reference: sums and decisions of points, of which
every answer is proved to be right. A missing answer, which no proof excludes, is a fault here."""

from __future__ import annotations

import json
import random
import tempfile
import time
from collections import Counter
from collections.abc import Sequence
from dataclasses import dataclass
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
MINUTES = Minutes(None, 1, 20)

SEED = 1130
CASES, THIN = Counts(60, 600, 25_600), Counts(2, 20, 1200)  # of all families, and of one more
PAIRS, THIN_PAIRS = Counts(40, 450, 20_000), Counts(2, 40, 2000)
SUMS, POINTS = Counts(100, 1400, 50_000), Counts(200, 2500, 150_000)
EVERY = Counts(60, 10, 1)  # of the corpus's cases
PROVED_TOO = 40  # one of so many cases has its sum proved by a certificate, too
BATCH = 25  # for one run of the program
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


@dataclass
class Asked:
    """A question for the program, and what the reference says."""

    what: str
    verb: str
    question: dict[str, Any]
    expected: dict[str, Any]


def answers(verb: str, questions: Sequence[str]) -> list[dict[str, Any]]:
    """The program's answers in one run, whole documents as `--json` has them; nothing where it does
    not answer."""
    if not questions:
        return []
    with tempfile.TemporaryDirectory() as name:
        files = [Path(name) / str(k) for k in range(len(questions))]
        for path, question in zip(files, questions, strict=True):
            path.write_text(question, encoding="utf-8")
        words = [verb, "--json", *proved_program.NO_LIMIT, *map(str, files)]
        ran = proved_program.run([proved_program.program(), *words])
    found = [json.loads(line) for line in ran.stdout.splitlines()]
    return found + [{}] * (len(questions) - len(found))


def judge(names: Sequence[str]) -> dict[str, Any]:
    """Pairs: points; of small ones sums at the given scale, and at, beside and after one of the
    boundary events."""
    tally: Counter[str] = Counter()
    asked: list[Asked] = []
    certificates: list[Certificate] = []
    faults: list[str] = []
    for name in names:
        case = naming.load(CaseName(name, "evidence"))
        if not isinstance(case, Case) or case.vertex_pairs > MOST_PAIRS_POINTS:
            continue
        thin = [not (o.is_region or o.is_empty) for o in (case.P, case.Q)]
        if not all(thin) and case.vertex_pairs <= MOST_PAIRS:
            sums = [_sum(case, scale) for scale in _scales(case)]
            asked += sums
            if int(name.rpartition(":")[2]) % PROVED_TOO == 0 and case.is_uniform:
                certificates.append(_certificate(case, sums[0], faults))
            tally["pairs"] += 1
            tally["sums"] += len(sums)
            tally["with a point or a segment"] += any(thin)
        asked += _points(tally, faults, case)
    for verb in ("--sum", "--points"):
        own = [each for each in asked if each.verb == verb]
        told = answers(verb, [json.dumps(each.question) for each in own])
        faults += [
            each.what
            for each, said in zip(own, told, strict=True)
            if any(said.get(name) != value for name, value in each.expected.items())
        ]
    with tempfile.TemporaryDirectory() as folder:
        files = [written(each, Path(folder), f"{k}") for k, each in enumerate(certificates)]
        verified = verdicts(in_proved(), files) if files else []
    tally["proved"] += len(verified)
    faults += [f"a certificate: {verdict.why}" for verdict in verified if verdict.code]
    return {"tally": tally, "faults": faults}


def _scales(case: Case) -> list[str]:
    if not case.is_uniform:
        return [case.scale]
    dynamic = _core.DynamicSum(case.P, case.Q, "1/4", "4")
    events = sorted({Fraction(row[0]) for row in dynamic.boundary_events()})
    dice = random.Random(case.name.text)
    found = [Fraction(case.scale)]
    if events:
        event = dice.choice(events)
        after = next((other for other in events if other > event), Fraction(5))
        found += [event, event + (after - event) / 10**9, (event + after) / 2]
    return [str(scale) for scale in dict.fromkeys(found)]


def _question(P: str, Q: str, scale: str, **more: Any) -> dict[str, Any]:
    asked = scale.split(",") if "," in scale else scale
    return {"P": json.loads(P), "Q": json.loads(Q), "scale": asked, **more}


def _sum(case: Case, scale: str) -> Asked:
    ours = _core.minkowski_sum(case.P, case.Q, scale)
    expected = {
        "digest": digest(ours.region.canonical_json()),
        "components": ours.components,
        "holes": ours.holes,
    }
    question = _question(case.P_json, case.Q_json, scale)
    return Asked(f"{case.name.text} at {scale}", "--sum", question, expected)


def _certificate(case: Case, at_scale: Asked, faults: list[str]) -> Certificate:
    """Equal digests: the answer is the sum, in its one canonical form."""
    certificate = Certificate(case.P, case.Q)
    certificate.sum(case.scale)
    if certificate.claims[0]["digest"] != at_scale.expected["digest"]:
        faults.append(f"{case.name.text}: a certificate of another digest")
    return certificate


def _points(tally: Counter[str], faults: list[str], case: Case) -> list[Asked]:
    points = [(str(x), str(y)) for x, y in points_of(case)]
    if not points or not case.is_uniform:
        return []
    ours = [_core.decide(case.P, case.Q, case.scale, *x) for x in points]
    inside = [found["contact"] != "empty" for found in ours]
    tally["in"] += sum(inside)
    tally["out"] += len(inside) - sum(inside)
    within = [(x, found) for x, found, is_in in zip(points, ours, inside, strict=True) if is_in]
    for x, found in within:
        if not _adds_up(x, case.scale, found["p"], found["q"]):
            faults.append(f"{case.name.text}: p and q do not add up to ({', '.join(x)})")
    name = case.name.text
    asked = [_decided(name, case.P_json, case.Q_json, case.scale, points, inside)]
    for which, operand in (("p", case.P_json), ("q", case.Q_json)):
        if own := [tuple(found[which]) for _, found in within]:
            what = f"{name}: a {which} that its operand does not have"
            asked.append(_decided(what, operand, ORIGIN, "1", own, [True] * len(own)))
    return asked


def _decided(
    what: str, P: str, Q: str, scale: str, points: Sequence[Sequence[str]], inside: list[bool]
) -> Asked:
    places = [list(point) for point in points]
    rows = [{"point": point, "in_sum": is_in} for point, is_in in zip(places, inside, strict=True)]
    question = _question(P, Q, scale, points=places)
    return Asked(f"{what}: points", "--points", question, {"points": rows})


def _adds_up(x: Sequence[str], scale: str, p: Sequence[str], q: Sequence[str]) -> bool:
    return all(
        Fraction(scale) * Fraction(a) + Fraction(b) == Fraction(c)
        for a, b, c in zip(p, q, x, strict=True)
    )


def judge_corpus(path: Path) -> dict[str, Any]:
    """The digests, components and holes that stand in a case of the corpus."""
    case = json.loads(path.read_text(encoding="utf-8"))
    known = [row for row in case["expected"] if "digest" in row]
    questions = [json.dumps({**{name: case[name] for name in "PQ"}, "scale": row["scale"]})
                 for row in known]  # fmt: skip
    faults = [
        f"{case['id']} at {row['scale']}"
        for row, told in zip(known, answers("--sum", questions), strict=True)
        if any(told.get(name) != row[name] for name in ("digest", "components", "holes"))
    ]
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
    every = names(size)
    batches = [every[k : k + BATCH] for k in range(0, len(every), BATCH)]
    for found in in_processes(judge, batches, 20, f"batches of {BATCH} pairs"):
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
        asked = _sum(case, case.scale)
        began = time.perf_counter()
        (told,) = answers("--sum", [json.dumps(asked.question)])
        seconds = time.perf_counter() - began
        same = all(told.get(name) == value for name, value in asked.expected.items())
        findings.law(f"two stars of {corners} corners: the same", same, True, same)
        findings.figures[f"seconds of the program for these, {corners} x {corners}"] = (
            f"{seconds:.1f}"
        )
