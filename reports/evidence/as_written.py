"""Every number that leaves the program, read back and held against numbers of 1,500 bits."""

from __future__ import annotations

from collections import Counter

from minkref.reports.evidence.framework.in_processes import in_processes
from minkref.reports.evidence.framework.part import READERS, REFERENCE, Findings
from minkref.reports.evidence.written import changes, settings
from minkref.reports.evidence.written.tally import Tally

SUBJECT = (
    "Numbers as written: for sums with a disc (half of them of turned shapes in doubles, others "
    "with walls parallel up to 1e-30, on maps, on boards), in the plane and in space, every file, "
    "table, document and array is read by the judge's own readers and compared with its own "
    "rational numbers and numbers of 1,500 bits; polygons inside of a sum and around it are so "
    "exactly."
)
MINUTES = (25, 0.4)
DEPENDS = (
    *REFERENCE, *READERS, "commands/**/*.py", "python/minkref/**/*.py",
    "reports/evidence/written/*.py",
)  # fmt: skip

COUNTS = {"disc": (5000, 24), "plane": (2000, 24), "space": (500, 12)}  # full, quick
BATCH = {"disc": 25, "plane": 50, "space": 10}
QUICK_BATCH = 12
WITHIN = 60.0  # seconds, in which a changed answer is found
QUICK_CHANGES = (("plane", "doubles two units nearer to zero"),)
Task = tuple[str, int, int]


def batch(task: Task) -> tuple[str, Tally]:
    setting, first, end = task
    return setting, settings.judged(setting, range(first, end))


def found_after(task: tuple[str, str]) -> tuple[float, str]:
    return changes.found_after(*task)


def tasks(quick: bool) -> list[Task]:
    return [
        (setting, first, min(first + size, counts[quick]))
        for setting, counts in COUNTS.items()
        for size in [QUICK_BATCH if quick else BATCH[setting]]
        for first in range(0, counts[quick], size)
    ]


def run(findings: Findings, quick: bool) -> None:
    tallies = {setting: Tally() for setting in COUNTS}
    for setting, tally in in_processes(batch, tasks(quick), each=10, what="batches"):
        tallies[setting].add(tally)
    for setting, tally in tallies.items():
        _tell(findings, setting, tally, COUNTS[setting][quick])
        if not quick:
            missing = settings.kinds(setting) - set(tally.kinds)
            findings.none(f"{setting}: kinds that are never drawn", sorted(missing))
    _changes(findings, quick)
    findings.figures["seed"] = settings.SEED


def _tell(findings: Findings, setting: str, tally: Tally, wanted: int) -> None:
    looked = sum(tally.kinds.values())
    findings.equal(f"{setting}: sums judged", wanted, looked)
    shown = [
        f"{count:,} of {writer}, {fault}: {tally.examples[writer, fault][0][:300]}"
        for (writer, fault), count in tally.wrong.most_common()
    ]
    findings.none(f"{setting}: numbers and files that are not right", shown)
    refused = [f"{count:,} of {what}" for what, count in tally.refused.items()]
    findings.none(f"{setting}: answers that are refused", refused)
    unread = [writer for writer in settings.WRITERS[setting] if not tally.numbers[writer]]
    findings.none(f"{setting}: writers of which no number is read", unread)
    findings.figures[setting] = {
        "kinds": dict(sorted(tally.kinds.items())),
        "numbers compared, by writer": dict(sorted(tally.numbers.items())),
        "refused": dict(sorted(tally.refused.items())),
        "wrong": {
            f"{writer}: {fault}": count for (writer, fault), count in sorted(tally.wrong.items())
        },
    }
    numbers = Counter(tally.numbers)
    findings.note(f"{setting}: {numbers.total():,} numbers of {len(numbers)} writers and readings")


def _changes(findings: Findings, quick: bool) -> None:
    asked = list(QUICK_CHANGES) if quick else changes.tasks()
    found = dict(zip(asked, in_processes(found_after, asked, what="changes"), strict=True))
    late = [
        f"{name} in {setting}" for (setting, name), (after, _) in found.items() if after > WITHIN
    ]
    findings.none("changed answers that are not found in time", late)
    findings.figures["changed answers, found after seconds"] = {
        f"{name}, {setting}": [round(after, 1), what]
        for (setting, name), (after, what) in found.items()
    }
