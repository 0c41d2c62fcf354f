"""Adapters, functions and files that mean harm: refused or judged, and nothing is left behind."""

from __future__ import annotations

from concurrent.futures import ThreadPoolExecutor
from typing import Any

from minkref.reports.evidence.framework.of_tests import module
from minkref.reports.evidence.framework.part import Counts, Findings, Minutes, Size
from minkref.reports.evidence.framework.places import ROOT

RESTS_ON = ("tests/adapters/hostile/",)
MINUTES = Minutes(None, 1.5, 60)
ALONE = True

FOLDER = ROOT / "tests" / "adapters" / "hostile"
WORDS: tuple[str, ...] = ("--no-models", "--shrink-calls", "0", "--jobs", "1", "--no-settings")
WORDS += ("--call-seconds", "3", "--call-memory", "400", "--call-output", "32")
WAYS = ("sandbox", "none")
EVERY = Counts(0, 4, 1)  # one file of so many
FEWER = Counts(0, 1, 1)  # one quick attack of so many
AT_ONCE = 2


def room(name: str) -> Any:
    """A module from tests/adapters/hostile."""
    return module(name, FOLDER, FOLDER / "files")


def attacked(attack: Any, way: str) -> dict[str, Any]:
    """Runs verify on a hostile adapter or function."""
    words = (*attack.words, *WORDS, "--isolation", way)
    seen = room("attack").attack(attack.adapter, *words, told=attack.told, tty=attack.tty)
    row = {
        "title": f"{attack.title}, {way}",
        "faults": room("judging").faults_of(attack, seen, way == "sandbox"),
        "code": seen.code,
        "seconds": round(seen.seconds, 1),
        "verdicts": seen.verdicts(),
        "reached": room("judging").got(seen),
        "traces": [*seen.outside, *seen.work],
        "processes": len(seen.processes),
    }
    print(row, flush=True)
    return row


def read(hostile: Any) -> dict[str, Any]:
    seen = room("reading").read(hostile)
    print(seen, flush=True)
    return {"title": seen.title, "faults": seen.faults, "code": seen.code, "peak": seen.peak_bytes}


def run(findings: Findings, size: Size) -> None:
    files = room("file_catalogue").FILES[:: size.of(EVERY)]
    chosen = [attack for attack in room("attacks").ATTACKS if attack.quick or size is Size.FULL]
    chosen = chosen[:: size.of(FEWER)]
    with ThreadPoolExecutor(AT_ONCE) as pool:
        for way in WAYS:
            rows = list(pool.map(lambda attack, way=way: attacked(attack, way), chosen))
            tell_attacks(findings, way, rows)
        tell_files(findings, list(pool.map(read, files)))


def tell_attacks(findings: Findings, way: str, rows: list[dict[str, Any]]) -> None:
    name = "with the sandbox" if way == "sandbox" else "without it"
    bad = [row for row in rows if row["faults"]]
    findings.none(f"attacks {name}: not as documented", len(bad))
    left = sum(row["processes"] for row in rows)
    findings.none(f"processes left behind, {name}", left)
    findings.figures[f"attacks, {name}"] = rows
    reached = sorted({word for row in rows for word in row["reached"]})
    findings.note(f"{name}, adapters and functions got at: {', '.join(reached) or 'nothing'}")
    tell(findings, bad)


def tell_files(findings: Findings, rows: list[dict[str, Any]]) -> None:
    bad = [row for row in rows if row["faults"]]
    findings.none("hostile files neither refused nor judged as documented", len(bad))
    findings.figures["hostile files"] = len(rows)
    findings.figures["refused"] = sum(row["code"] != 0 for row in rows)
    findings.figures["largest process, MiB"] = max(row["peak"] for row in rows) >> 20
    tell(findings, bad)


def tell(findings: Findings, bad: list[dict[str, Any]]) -> None:
    for row in bad:
        findings.note(f"{row['title']}: {'; '.join(row['faults'])}")
