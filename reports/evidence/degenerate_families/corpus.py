"""The corpus made again: the same bytes."""

from __future__ import annotations

import tempfile
from pathlib import Path

from minkref.degeneracies import lint
from minkref.degeneracies.catalogue import FAMILIES, SOLID_FAMILIES, SPACE_FAMILIES
from minkref.degeneracies.found import NAME as FOUND
from minkref.degeneracies.make_corpus import make
from minkref.reports.evidence.certificates.checkers import in_cpp, in_python, verdicts
from minkref.reports.evidence.framework.part import Findings, Minutes, Size

MINUTES = Minutes(None, 2.5, 5)

LEAST_CASES, MOST_BYTES = 400, 20_000_000
BATCH = 200


def run(findings: Findings, size: Size) -> None:
    there = _contents(lint.CORPUS)
    with tempfile.TemporaryDirectory() as name:
        make(Path(name))
        again = _contents(Path(name))
    changed = sorted(path for path in there | again if there.get(path) != again.get(path))
    findings.none("files that are others when made again", changed)
    faults = [*lint.faults(again=False), *lint.corpus_faults()]
    findings.none("faults of form", faults)
    cases = len(lint.case_paths(lint.CORPUS))
    total = sum(map(len, there.values()))
    for dimension, families in ((2, [*FAMILIES, FOUND]), (3, [*SPACE_FAMILIES, *SOLID_FAMILIES])):
        folders = {path.parent.name for path in lint.case_paths(lint.CORPUS)}
        absent = [family for family in families if family not in folders]
        findings.none(f"families of dimension {dimension} without a case", absent)
    findings.target("cases", cases >= LEAST_CASES, f"at least {LEAST_CASES}", cases)
    findings.target("bytes", total < MOST_BYTES, f"under {MOST_BYTES:,}", f"{total:,}")
    of_solids = [p for p in lint.case_paths(lint.CORPUS) if p.parent.name in SOLID_FAMILIES]
    certified = cases - len(of_solids)  # solids' sums have none
    files = sorted(lint.CORPUS.rglob(f"*{lint.ENDING}"))
    for what, command in (("Python", in_python()), ("C++", in_cpp())):
        good = sum(
            verdict.code == 0
            for i in range(0, len(files), BATCH)
            for verdict in verdicts(command, files[i : i + BATCH])
        )
        findings.equal(f"certificates verified by the checker in {what}", certified, good)


def _contents(folder: Path) -> dict[str, bytes]:
    return {str(p.relative_to(folder)): p.read_bytes() for p in folder.rglob("*.json")}
