"""A hundred cases of every degenerate family: made, followed, and asked in floating point."""

from __future__ import annotations

import json
import tempfile
import time
from collections import Counter
from pathlib import Path
from typing import Any

from minkref.degeneracies import lint
from minkref.degeneracies.catalogue import FAMILIES, SPACE_FAMILIES
from minkref.degeneracies.plane.verdict_of_floats import WIDTHS
from minkref.reports.evidence.certificates.checkers import in_cpp, verdicts
from minkref.reports.evidence.framework.command import minkref
from minkref.reports.evidence.framework.part import Counts, Findings, Minutes, Size

MINUTES = Minutes(None, 1.2, 15)

SEED = 20
COUNT = Counts(0, 5, 100)
BATCH = 200
MORE = f"more than {WIDTHS[-1]}"


def run(findings: Findings, size: Size) -> None:
    with tempfile.TemporaryDirectory() as name:
        folder = Path(name)
        count = size.of(COUNT)
        words = ("--count", count, "--seed", SEED, "-o", name)
        made, more = (minkref("generate", which, *words)[1] for which in ("all", "space"))
        rows = [*made["cases"], *more["cases"]]
        per_family = Counter(row["family"] for row in rows)
        counts = sorted({per_family[family] for family in (*FAMILIES, *SPACE_FAMILIES)})
        findings.law("cases of each family", counts == [count], count, counts)
        different = {row["id"] for row in rows}
        findings.figures["cases, different ones, megabytes"] = [
            len(rows), len(different), round((made["bytes"] + more["bytes"]) / 1e6, 1)
        ]  # fmt: skip
        findings.figures["cases per second, with their certificates"] = {
            "in the plane": made["cases_per_second"], "in space": more["cases_per_second"]
        }  # fmt: skip
        began = time.perf_counter()
        checked = minkref("check", name)[1]["files"]
        seconds = time.perf_counter() - began
        bad = [row["file"] for row in checked if row["verdict"] != "verified"]
        good = len(checked) - len(bad)
        findings.law("certificates verified by `minkref check`",
                     not bad and good == len(different), len(different), good)  # fmt: skip
        findings.figures["certificates followed per second, Python"] = round(good / seconds, 1)
        files = sorted(folder.rglob("*.cert.json"))
        batches = [files[i : i + BATCH] for i in range(0, len(files), BATCH)]
        codes = Counter(v.code for batch in batches for v in verdicts(in_cpp(), batch))
        findings.law("verified by the checker in C++", codes == Counter({0: len(files)}),
                     len(files), codes[0])  # fmt: skip
        faults = list(lint.faults(folder, again=False))
        findings.none("faults of form", faults)
        values = [json.loads(path.read_text(encoding="utf-8")) for path in lint.case_paths(folder)]
        _floats(findings, [value for value in values if value["dimension"] == 2])
        _signs(findings, [value for value in values if value["dimension"] == 3])


def _floats(findings: Findings, values: list[dict[str, Any]]) -> None:
    """In the plane."""
    wrong: dict[str, Counter[bool]] = {}
    bits: Counter[str] = Counter()
    for value in values:
        tally = wrong.setdefault(value["tags"][0], Counter())
        for row in value["degeneracy"]["floats"]:
            tally[row["doubles_are_right"]] += 1
            bits[str(row["deciding_bits"] or MORE)] += 1
    names = [*(str(width) for width in WIDTHS), MORE]
    findings.figures["scales by the bits that decide"] = {n: bits[n] for n in names if bits[n]}
    findings.figures["share of scales at which doubles are wrong"] = {
        family: f"{tally[False] / tally.total():.0%}" for family, tally in sorted(wrong.items())
    }


def _signs(findings: Findings, values: list[dict[str, Any]]) -> None:
    """Counts wrong signs in space: one body's normal times the other body's edge."""
    wrong: dict[str, Counter[bool]] = {}
    for value in values:
        tally = wrong.setdefault(value["tags"][0], Counter())
        for row in value["degeneracy"]["floats"]:
            tally[row["wrong_in_doubles"] > 0] += 1
    findings.figures["share of scalings at which a sign is wrong in doubles"] = {
        family: f"{tally[True] / tally.total():.0%}" for family, tally in sorted(wrong.items())
    }
