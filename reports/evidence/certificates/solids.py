"""Certificates for sums of solids: both checkers, the slow engine, bytes and seconds."""

from __future__ import annotations

import json
import statistics
import tempfile
import time
from collections import Counter
from itertools import islice
from pathlib import Path
from typing import Any

from minkref.fuzz.judges.space.certified_solids import SolidConfirmation
from minkref.fuzz.space.general_pairs import GeneralPair
from minkref.reports.evidence.certificates.checkers import in_cpp, in_python, timed
from minkref.reports.evidence.certificates.solid_cases import certified, solid_pairs
from minkref.reports.evidence.framework.in_processes import in_processes
from minkref.reports.evidence.framework.part import Counts, Findings, Minutes, Size

MINUTES = Minutes(0.1, 0.5, 5)

SEED = 2013
PAIRS = Counts(2, 36, 156)
EVERY, MOST_PIECES = 3, 24  # asked of the slow engine: one in so many, of up to so many pairs


def run(findings: Findings, size: Size) -> None:
    pairs = list(islice(solid_pairs(SEED), size.of(PAIRS)))
    rows = list(in_processes(_one, list(enumerate(pairs)), what="pairs"))
    refused = [f"{row['name']}: {row['why']}" for row in rows if row["why"]]
    false = [row["name"] for row in rows if row["confirmed"] is False]
    findings.law("certificates verified by both checkers", not refused, len(rows),
                 f"{len(rows) - len(refused)}{'; '.join(['', *refused[:3]])}")  # fmt: skip
    findings.none("claims that the slow engine does not confirm", false)
    findings.figures["claims that the slow engine confirms"] = sum(
        row["confirmed"] is True for row in rows
    )
    numbers = Counter(row["numbers"] for row in rows)
    findings.figures["components, cavities, tunnels"] = dict(sorted(numbers.items()))
    for what in ("pieces", "plates", "entries", "bytes"):
        findings.figures[f"{what}, median and most"] = _spread(rows, what, 0)
    for what in ("made", "Python", "C++"):
        findings.figures[f"seconds, {what}, median and most"] = _spread(rows, what)
    families = sorted({row["family"] for row in rows})
    for family in families:
        of = [row for row in rows if row["family"] == family]
        findings.figures[f"{family}: bytes, seconds to make it, in Python, in C++, at most"] = (
            f"{max(row['bytes'] for row in of):,}; "
            + ", ".join(f"{max(row[what] for row in of):.2f}" for what in ("made", "Python", "C++"))
        )


def _one(numbered: tuple[int, GeneralPair]) -> dict[str, Any]:
    number, pair = numbered
    began = time.perf_counter()
    certificate = certified(pair)
    made = time.perf_counter() - began
    with tempfile.TemporaryDirectory() as folder:
        path = Path(folder, "it.cert.json")
        text = certificate.text("it.case.json")
        path.write_text(text, encoding="utf-8")
        Path(folder, "it.case.json").write_text(certificate.case(), encoding="utf-8")
        python, in_p = timed(in_python(), path)
        cpp, in_c = timed(in_cpp(), path)
    proof = json.loads(text)["proof"]
    pieces = len(proof["P"]["hulls"]) * len(proof["Q"]["hulls"])
    planes = proof["sums"][0]["planes"]
    confirmed = None
    if number % EVERY == 0 and pieces <= MOST_PIECES:
        confirmation = SolidConfirmation(json.loads(certificate.case()))
        confirmed = confirmation.all_hold(certificate.claims)
    return {
        "name": pair.name,
        "family": pair.name.split(":")[0],
        "why": "; ".join(v.why for v in (python, cpp) if v.code),
        "confirmed": confirmed,
        "numbers": ", ".join(
            str(certificate.claims[0][name]) for name in ("components", "cavities", "tunnels")
        ),
        "planes": certificate.claims[0]["planes"],
        "pieces": pieces,
        "plates": len(planes),
        "entries": sum(len(tree) for _, _, tree in planes),
        "bytes": len(text.encode()),
        "made": made,
        "Python": in_p,
        "C++": in_c,
    }


def _spread(rows: list[dict[str, Any]], name: str, digits: int = 3) -> str:
    values = [row[name] for row in rows]
    return f"{statistics.median(values):,.{digits}f} and {max(values):,.{digits}f}"
