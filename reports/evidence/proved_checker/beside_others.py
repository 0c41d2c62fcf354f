"""The checker proved right: agreement with the other checkers, mutants, speed, and a theorem."""

from __future__ import annotations

import contextlib
import itertools
import json
import os
import random
import shutil
import subprocess
import tempfile
import time
from collections import Counter
from collections.abc import Iterator
from dataclasses import dataclass, field
from fractions import Fraction
from pathlib import Path

from minkref import _core
from minkref.certify.plane.certificate import Certificate, NoProof
from minkref.certify.space.convex_certificate import convex_certificate
from minkref.fuzz.geometry.polyhedron import Polyhedron
from minkref.fuzz.judges.plane.certified_claims import Confirmation
from minkref.fuzz.plane.case import Case
from minkref.fuzz.space.generators.convex import random_hull, sphere
from minkref.proved_program import PROGRAM
from minkref.reports.evidence.certificates.certified_cases import (
    cases,
    events,
    star,
    wound,
    written,
)
from minkref.reports.evidence.certificates.checkers import (
    ROOT,
    in_cpp,
    in_proved,
    in_python,
    timed,
    verdicts,
)
from minkref.reports.evidence.certificates.mutants import is_changed, mutants
from minkref.reports.evidence.framework.operands import operand, tell_absent
from minkref.reports.evidence.framework.part import Counts, Findings, Minutes, Size

RESTS_ON = ("oracle/proved/",)
MINUTES = Minutes(0.1, 1, 6)

SEED = 3232
SUMS, EVENTS, MUTANTS = Counts(6, 200, 2000), Counts(2, 20, 200), Counts(40, 1000, 10_000)
DEGENERACIES = 40
BODIES = Counts(2, 30, 200)
SCALINGS = [("1", "1", "1"), ("1/2", "3", "7/5")]
BATCH = 100
TIMES = 10.0  # the C++ checker
CORPUS = ROOT / "degeneracies" / "corpus"
CLAIMS = ("sum", "interval", "event", "point", "outside", "passage", "sign")
HOLED = "POLYGON((0 0, 4 0, 4 4, 0 4, 0 0), (1 1, 1 3, 3 3, 3 1, 1 1))"


@dataclass
class Tally:
    codes: Counter[str] = field(default_factory=Counter)
    disagree: list[str] = field(default_factory=list)


def run(findings: Findings, size: Size) -> None:
    try:
        in_proved()
    except FileNotFoundError as error:
        findings.note(f"{error}: nothing of this part was run")
        findings.target(f"{PROGRAM} is built", False, "built", "absent")
        return
    with tempfile.TemporaryDirectory() as name:
        folder = Path(name)
        _agree(findings, "fresh sums", _fresh(size.of(SUMS)), folder)
        _agree(findings, "fresh events", _events(size.of(EVENTS)), folder)
        if size is not Size.QUICK:
            _corpus(findings)
            _degeneracies(findings, folder)
            _speed(findings, folder)
        _mutants(findings, size.of(MUTANTS), folder)
        _bodies(findings, folder, size.of(BODIES))
        _theorem(findings, folder)


def _certified(case: Case) -> Certificate:
    """Certifies the sum with its tight passages, a point of the sum if pieces can show that point,
    one beside it that is not, and the turn of three convolution vertices if the turn keeps its sign
    from half the scale to double."""
    certificate = Certificate(case.P, case.Q)
    certificate.sum(case.scale, passages=True)
    if case.P.is_region and case.Q.is_region:
        region = json.loads(_core.minkowski_sum(case.P, case.Q, case.scale).region.to_json())
        x, y = region["polygons"][0]["outer"][0]
        certificate.point(case.scale, (str(x), str(y)))
        certificate.outside(case.scale, (Fraction(x) - Fraction(1, 1000), str(y)))
        s = Fraction(case.scale)
        with contextlib.suppress(NoProof):
            certificate.sign(("orientation", [[0, 0], [1, 0], [2, 0]]), s / 2, 2 * s)
        with contextlib.suppress(NoProof):
            certificate.sign(("orientation", [[0, 0], [1, 0], [0, 1]]), s / 2, 2 * s)
    return certificate


def _fresh(count: int) -> Iterator[tuple[str, Certificate]]:
    for case in itertools.islice(cases(SEED), count):
        yield case.name.text, _certified(case)


def _events(count: int) -> Iterator[tuple[str, Certificate]]:
    """Certificates for events, each with the interval from the previous event, the sum at the
    event, with tight passages, and the interval afterwards."""
    for case, scale, before in itertools.islice(events(SEED, 1), count):
        certificate = Certificate(case.P, case.Q)
        certificate.event(scale, before, passages=True)
        yield f"{case.name.text} at {scale}", certificate


def _corpus(findings: Findings) -> None:
    """Checks that each claim from the corpus's plane certificates is proved."""
    files = [
        path
        for path in sorted(CORPUS.rglob("*.cert.json"))
        if '"certificate-v1"' in path.read_text(encoding="utf-8")
    ]
    theirs = Counter(verdict.code for verdict in verdicts(in_cpp(), files))
    began = time.perf_counter()
    ran = subprocess.run([*in_proved(), *map(str, files)], capture_output=True, text=True)
    seconds = time.perf_counter() - began
    claimed = Counter(
        claim["claim"]
        for path in files
        for claim in json.loads(path.read_text(encoding="utf-8"))["claims"]
    )
    lines = ran.stdout.splitlines()
    found = Counter(
        line.removeprefix("  ").partition(":")[0]
        for line in lines
        if line.startswith(tuple(f"  {kind}:" for kind in CLAIMS))
    )
    findings.equal(
        "certificates of the corpus that the C++ checker verifies", len(files), theirs[0]
    )
    findings.equal(
        "certificates of the corpus that the proved one verifies", len(files),
        sum(line.endswith(": verified") for line in lines),
    )  # fmt: skip
    for kind in CLAIMS:
        findings.equal(f"claims `{kind}` of the corpus that are proved", claimed[kind], found[kind])
    findings.figures["certificates of the corpus: seconds of the proved checker"] = f"{seconds:.0f}"


def _agree(
    findings: Findings, what: str, made: Iterator[tuple[str, Certificate]], folder: Path
) -> None:
    tally = Tally()
    count = 0
    while batch := list(itertools.islice(made, BATCH)):
        files = [written(each, folder, f"{i}") for i, (_, each) in enumerate(batch)]
        found = [verdicts(command, files) for command in (in_proved(), in_python(), in_cpp())]
        for (name, _), *codes in zip(batch, *found, strict=True):
            tally.codes[str(codes[0].code)] += 1
            if len({verdict.code for verdict in codes}) > 1 or codes[0].code:
                told = ", ".join(str(verdict.code) for verdict in codes)
                tally.disagree.append(f"{name} (seed {SEED}): {told}: {codes[0].why}")
        count += len(batch)
    findings.none(f"{what}, on which the three do not all say verified", tally.disagree)
    findings.law(f"{what} there are", count > 0, "some", f"{count:,}")
    findings.figures[f"{what}: verified by all three"] = tally.codes["0"]
    findings.figures[f"{what}: declined"] = tally.codes["5"]


def _degeneracies(findings: Findings, folder: Path) -> None:
    """Certificates for the signs that make a scale critical."""
    files: list[Path] = []
    for case, scale, _ in itertools.islice(events(SEED, 1), DEGENERACIES):
        certificate = Certificate(case.P, case.Q)
        certificate.degeneracy(scale)
        files.append(written(certificate, folder, f"degeneracy{len(files)}"))
    for who, command in (("are proved", in_proved()), ("the C++ checker verifies", in_cpp())):
        found = Counter(verdict.code for verdict in verdicts(command, files))
        findings.equal(f"degeneracies that {who}", DEGENERACIES, found[0])


def _small() -> Iterator[tuple[str, Certificate]]:
    """Certificates for full sums with their other claims, and, alternating with them, for
    events."""
    some = (case for case in cases(SEED + 1) if 0 < case.P.vertices + case.Q.vertices < 40)
    for case, (other, scale, before) in zip(some, events(SEED + 1, 1), strict=False):
        certificate = _certified(case)
        for claim in certificate.claims:
            if claim["claim"] == "sum":
                region = _core.minkowski_sum(case.P, case.Q, case.scale).region
                claim["polygons"] = json.loads(region.canonical_json())["polygons"]
        yield case.name.text, certificate
        certificate = Certificate(other.P, other.Q)
        certificate.event(scale, before)
        yield f"{other.name.text} at {scale}", certificate


def _mutants(findings: Findings, wanted: int, folder: Path) -> None:
    """Judges certificates with changed claims, and another batch with changed cases (under the old
    digest)."""
    accepted: list[str] = []
    true = 0
    refused: Counter[str] = Counter()
    dice = random.Random(SEED)
    for name, certificate in _small():
        path = written(certificate, folder, "it")
        value = json.loads(path.read_text(encoding="utf-8"))
        changed = [
            mutant
            for mutant in mutants({"claims": value["claims"]}, 12, dice)
            if is_changed(mutant.value["claims"], value["claims"])
        ][: min(BATCH, wanted - refused.total() - len(accepted))]
        files = []
        confirmation = Confirmation(certificate.case())
        for i, mutant in enumerate(changed):
            files.append(folder / f"m{i}.cert.json")
            files[-1].write_text(json.dumps({**value, **mutant.value}), encoding="utf-8")
        for mutant, verdict in zip(changed, verdicts(in_proved(), files) if files else (),
                                   strict=True):  # fmt: skip
            claims = mutant.value["claims"]
            others = [claim for claim in claims if claim not in value["claims"]]
            if not verdict.code and all(confirmation.holds(claim, claims) for claim in others):
                true += 1  # a point at another scale, a sign between others
            elif not verdict.code:
                told = f"{name} (seed {SEED}): {mutant.way} at {mutant.path}"
                accepted.append(told)
            else:
                refused[str(verdict.code)] += 1
        if refused.total() + len(accepted) >= wanted:
            break
    findings.none(f"mutants with a changed claim that are accepted, of {wanted:,}", accepted)
    findings.figures["mutants accepted whose other claim is true too, by the slow engine"] = true
    words = {"1": "refuted", "2": "malformed", "4": "out of budget", "5": "declined"}
    findings.figures["mutants refused"] = {words[code]: n for code, n in sorted(refused.items())}


def _speed(findings: Findings, folder: Path) -> None:
    """Processor time, against the C++ checker."""
    tell_absent(findings, "monkey", "bird")
    pairs = {
        "monkey + bird": (operand("monkey").set, operand("bird").set),
        "dog145 + g1": (operand("dog145").set, operand("g1").set),
        "stars of 100 and 30": (star(100, SEED), star(30, SEED + 1)),
        "spirals of 60 and 30": (wound(60, 16, Fraction(4)), wound(30, 1, Fraction(1, 2))),
    }  # fmt: skip
    for title, (P, Q) in pairs.items():
        certificate = Certificate(P, Q)
        certificate.sum("1")
        _compared(findings, title, written(certificate, folder, "large"))
    P, Q = star(16, SEED), star(8, SEED + 1)
    scales = [Fraction(row[0]) for row in _core.DynamicSum(P, Q, "1/2", "2").boundary_events()]
    before, scale = max(itertools.pairwise(scales), key=lambda pair: pair[1] - pair[0])
    certificate = Certificate(P, Q)
    certificate.event(scale, before)
    _compared(findings, "an event of stars of 16 and 8", written(certificate, folder, "event"))


def _compared(findings: Findings, title: str, file: Path) -> None:
    (ours, mine), (theirs, other) = timed(in_proved(), file), timed(in_cpp(), file)
    findings.equal(f"{title}: verified by both", [0, 0], [ours.code, theirs.code])
    findings.target(f"{title}: times the C++ checker", mine <= TIMES * other,
                    f"at most {TIMES:.0f}", f"{mine / other:.1f}")  # fmt: skip
    findings.figures[f"{title}: seconds, proved and C++"] = f"{mine:.2f} and {other:.2f}"


def _bodies(findings: Findings, folder: Path, count: int) -> None:
    """Judges sums of convex polyhedra: fresh, and with changed claims."""
    dice = random.Random(SEED)
    made, changed = [], []
    for i in range(count):
        bodies = [random_hull(dice, dice.randint(4, 14), dice.randint(1, 6)) for _ in "PQ"]
        made.append(_written_bodies(bodies, SCALINGS, folder, f"body{i}"))
        value = json.loads(made[-1].read_text(encoding="utf-8"))
        for j, mutant in enumerate(mutants({"claims": value["claims"]}, 1, dice)):
            if all(claim in value["claims"] for claim in mutant.value["claims"]):
                continue  # reordered or fewer claims
            changed.append(folder / f"body{i}.{j}.cert.json")
            changed[-1].write_text(json.dumps({**value, **mutant.value}), encoding="utf-8")
    codes = zip(*(verdicts(c, made) for c in (in_proved(), in_python(), in_cpp())), strict=True)
    found = [{verdict.code for verdict in row} for row in codes]
    findings.equal("sums of convex polyhedra verified by all three", count, found.count({0}))
    accepted = [verdict for verdict in verdicts(in_proved(), changed) if not verdict.code]
    findings.none(f"of {len(changed):,} with a changed claim, accepted", accepted)
    large = [sphere(dice, 100, Fraction(size)) for size in (3, 1)]
    file = _written_bodies(large, SCALINGS[:1], folder, "spheres")
    _compared(findings, "polyhedra of 102 vertices", file)


def _written_bodies(
    bodies: list[Polyhedron], scalings: list[tuple[str, str, str]], folder: Path, stem: str
) -> Path:
    P, Q = (
        _core.Polyhedron([tuple(vertex) for vertex in value["vertices"]], value["faces"])
        for value in (body.document() for body in bodies)
    )
    texts = convex_certificate(P, Q, scalings, f"{stem}.case.json", "evidence")
    (folder / f"{stem}.case.json").write_text(texts.case, encoding="utf-8")
    path = folder / f"{stem}.cert.json"
    path.write_text(texts.certificate, encoding="utf-8")
    return path


def _theorem(findings: Findings, folder: Path) -> None:
    coqc = shutil.which("coqc")
    proofs = ROOT / "build" / "proofs"
    if coqc is None or not (proofs / "Canonical.vo").exists():
        findings.note("coqc or the compiled proofs are absent: no theorem was compiled")
        return
    P = _core.read_text(HOLED, "wkt", "a square ring")
    certificate = Certificate(P, P)
    certificate.sum("1/5")
    holes = certificate.claims[0]["holes"]
    file = written(certificate, folder, "holed")
    theorem = folder / "holed.v"
    subprocess.run([*in_proved(), f"--theorem={theorem}", str(file)], check=True,
                   stdout=subprocess.DEVNULL)  # fmt: skip
    command = [coqc, "-q", "-Q", str(proofs), "Proved", theorem.name]
    text = theorem.read_text(encoding="utf-8")
    began = time.perf_counter()
    ran = subprocess.run(command, cwd=folder, capture_output=True, text=True, env={**os.environ})
    findings.equal("holes of the sum that is stated as a theorem", 1, holes)
    findings.equal("coqc takes the theorem: exit code", 0, ran.returncode)
    findings.figures["the theorem: lines, seconds of coqc"] = (
        f"{text.count(chr(10)):,}, {time.perf_counter() - began:.1f}"
    )
    theorem.write_text(text.replace("(24#5, 0#1)", "(23#5, 0#1)", 1), encoding="utf-8")
    ran = subprocess.run(command, cwd=folder, capture_output=True, text=True)
    findings.law("coqc refuses the same theorem of another sum", ran.returncode != 0, "not 0",
                 ran.returncode)  # fmt: skip
