"""A hundred members of every invalid family: refused by each command that reads operands, and by
the slow engine."""

from __future__ import annotations

import io
import json
import tempfile
import time
from collections import Counter
from contextlib import redirect_stderr, redirect_stdout
from dataclasses import dataclass, field
from pathlib import Path

from minkref.cli.cli import run as run_command
from minkref.degeneracies.invalid.catalogue import INVALID_FAMILIES, invalid_member
from minkref.degeneracies.invalid.commands import COMMANDS, left_out, words
from minkref.degeneracies.invalid.member import Invalid
from minkref.fuzz.judges.plane.slow_operands import slow_refuses
from minkref.reports.evidence.framework.command import minkref
from minkref.reports.evidence.framework.in_processes import in_processes
from minkref.reports.evidence.framework.part import Counts, Findings, Minutes, Size

MINUTES = Minutes(None, 1.2, 20)

SEED = 47
COUNT = Counts(0, 4, 100)
LONG = ("invalid-too-many-vertices", "invalid-too-many-digits")  # files with tens of megabytes
REFUSED = 2  # the exit code


@dataclass
class Told:
    """The commands' answers to a family's members."""

    family: str
    different: int = 0
    runs: Counter[str] = field(default_factory=Counter)  # by command
    faults: dict[str, list[str]] = field(default_factory=dict)
    slow: Counter[str] = field(default_factory=Counter)
    seconds: float = 0.0

    def fault(self, what: str, where: str) -> None:
        self.faults.setdefault(what, []).append(where)


TAKEN = "runs with another exit code than 2"
OTHER_CODE = "runs that give another reason than the family's"
NO_PLACE = "messages that leave out the file or the place that was damaged"
WRITTEN = "runs that wrote something"
SLOW_TAKES = "files that the slow engine's reader takes"


def run(findings: Findings, size: Size) -> None:
    names = sorted(INVALID_FAMILIES, key=lambda name: name not in LONG)  # the long ones first
    tasks = [(name, size.of(COUNT)) for name in names]
    told = []
    for one in in_processes(_of_family, tasks, what="families"):
        told.append(one)
        print(f"{one.family}: {sum(one.runs.values())} runs, {one.seconds:.0f} s", flush=True)
    runs = sum((one.runs for one in told), Counter[str]())
    count = size.of(COUNT)
    expected = {command: count * len(names) for command in COMMANDS}
    findings.equal("members that each command was given", expected, dict(runs))
    for what in (TAKEN, OTHER_CODE, NO_PLACE, WRITTEN, SLOW_TAKES):
        found = [where for one in told for where in one.faults.get(what, [])]
        findings.law(what, not found, 0, f"{len(found)}: {'; '.join(found[:3])}" if found else 0)
    slow = sum((one.slow for one in told), Counter[str]())
    findings.figures["families, members, different ones"] = [
        len(names), count * len(names), sum(one.different for one in told)
    ]  # fmt: skip
    findings.figures["the slow engine's reader"] = dict(sorted(slow.items()))
    read = {one.family for one in told if one.slow["refused"]}
    findings.figures["families that the slow engine does not read"] = sorted(set(names) - read)
    _generate(findings)


def _of_family(task: tuple[str, int]) -> Told:
    name, count = task
    told = Told(name)
    began = time.perf_counter()
    contents = set()
    for index in range(count):
        member = invalid_member(INVALID_FAMILIES[name], SEED, index)
        contents.add((member.content, member.scale))
        with tempfile.TemporaryDirectory() as folder:
            for command in COMMANDS:
                _told(told, command, member, Path(folder), f"{command} {name}:{SEED}:{index}")
            if not member.slow_reads:
                told.slow["not read: GeoJSON, or a limit that it has not"] += 1
                continue
            refused = slow_refuses(Path(folder) / member.argument, member.scale)
            told.slow["refused" if refused else "taken"] += 1
            if not refused:
                told.fault(SLOW_TAKES, f"{name}:{SEED}:{index}")
    told.different = len(contents)
    told.seconds = time.perf_counter() - began
    return told


def _told(told: Told, command: str, member: Invalid, folder: Path, where: str) -> None:
    line = words(command, member, folder)
    before = _contents(folder)
    out, err = io.StringIO(), io.StringIO()
    with redirect_stdout(out), redirect_stderr(err):
        code = run_command([*line, "--json"])
    told.runs[command] += 1
    if code != REFUSED:
        told.fault(TAKEN, f"{where}: {code}")
        return
    error = json.loads(out.getvalue())["error"]
    if error["code"] != member.code:
        told.fault(OTHER_CODE, f"{where}: {error['code']}")
    if left_out(member, err.getvalue()):
        told.fault(NO_PLACE, f"{where}: {err.getvalue()[:300]}")
    if _contents(folder) != before:
        told.fault(WRITTEN, where)


def _contents(folder: Path) -> dict[str, int]:
    return {str(path): path.stat().st_mtime_ns for path in folder.rglob("*")}


def _generate(findings: Findings) -> None:
    """The command makes the files, and no certificate."""
    with tempfile.TemporaryDirectory() as name:
        _, made = minkref("generate", "invalid", "--count", 3, "-o", name)
        families = {row["family"] for row in made["cases"]}
        findings.law("families that `minkref generate invalid` makes",
                     families == set(INVALID_FAMILIES), len(INVALID_FAMILIES),
                     len(families))  # fmt: skip
        certificates = list(Path(name).rglob("*.cert.json"))
        findings.none("certificates that it makes", len(certificates))
