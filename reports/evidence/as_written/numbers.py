"""Every number that leaves the program, read back and held against numbers of 1,500 bits."""

from __future__ import annotations

from collections import Counter

from minkref.reports.evidence.as_written import changes, settings
from minkref.reports.evidence.as_written.tally import Tally
from minkref.reports.evidence.framework.in_processes import in_processes
from minkref.reports.evidence.framework.part import Counts, Findings, Minutes, Size

MINUTES = Minutes(0.1, 2, 25)

COUNTS = {
    "disc": Counts(4, 400, 5000), "plane": Counts(4, 200, 2000), "space": Counts(2, 40, 500),
}  # fmt: skip
SEED = settings.SEED
BATCH = {"disc": 25, "plane": 50, "space": 10}
WITHIN = 60.0  # seconds until a change must be noticed
FEW_CHANGES = (("plane", "doubles two units nearer to zero"),)
Task = tuple[str, int, int]


def batch(task: Task) -> tuple[str, Tally]:
    setting, first, end = task
    return setting, settings.judged(setting, range(first, end))


def found_after(task: tuple[str, str]) -> tuple[float, str]:
    return changes.found_after(*task)


def tasks(size: Size) -> list[Task]:
    return [
        (setting, first, min(first + BATCH[setting], size.of(counts)))
        for setting, counts in COUNTS.items()
        for first in range(0, size.of(counts), BATCH[setting])
    ]


def run(findings: Findings, size: Size) -> None:
    tallies = {setting: Tally() for setting in COUNTS}
    for setting, tally in in_processes(batch, tasks(size), each=10, what="batches"):
        tallies[setting].add(tally)
    for setting, tally in tallies.items():
        _tell(findings, setting, tally, size.of(COUNTS[setting]))
        if size is Size.FULL:
            missing = settings.kinds(setting) - set(tally.kinds)
            findings.none(f"{setting}: kinds that are never drawn", sorted(missing))
    _changes(findings, size)


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


def _changes(findings: Findings, size: Size) -> None:
    asked = list(FEW_CHANGES) if size is Size.QUICK else changes.tasks()
    found = dict(zip(asked, in_processes(found_after, asked, what="changes"), strict=True))
    late = [
        f"{name} in {setting}" for (setting, name), (after, _) in found.items() if after > WITHIN
    ]
    findings.none("changed answers that are not found in time", late)
    findings.figures["changed answers, found after seconds"] = {
        f"{name}, {setting}": [round(after, 1), what]
        for (setting, name), (after, what) in found.items()
    }
