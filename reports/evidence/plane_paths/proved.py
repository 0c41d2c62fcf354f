"""Certificates of paths and traps, and changed ones, before the checker that is proved right."""

from __future__ import annotations

import json
import random
import tempfile
from collections import Counter
from pathlib import Path
from typing import Any

from minkref.fuzz.judges.motion.trap_cases import trap_case
from minkref.fuzz.motion.path_cases import path_case
from minkref.proved_program import PROGRAM
from minkref.reports.evidence.certificates.checkers import (
    in_cpp,
    in_proved,
    in_python,
    timed,
    verdicts,
)
from minkref.reports.evidence.certificates.mutants import mutants
from minkref.reports.evidence.certificates.path_cases import Made, made, written
from minkref.reports.evidence.framework.in_processes import in_processes
from minkref.reports.evidence.framework.part import Counts, Findings, Minutes, Size
from minkref.reports.evidence.plane_paths.paths import CONTACTS, large_path, trap_in_room

RESTS_ON = ("oracle/proved/",)
MINUTES = Minutes(None, 0.5, 12)

SEED = 3290
PATHS = Counts(2, 50, 500)
ROOMS = Counts(1, 15, 150)
DOORS = Counts(1, 10, 100)
CHANGED = Counts(2, 20, 100)  # certificates of each kind with changed ones
EACH = 30  # changes of one certificate
LEAST = Counts(50, 1000, 5000)


def run(findings: Findings, size: Size) -> None:
    try:
        in_proved()
    except FileNotFoundError as error:
        findings.note(f"{error}: nothing of this step was run")
        findings.target(f"{PROGRAM} is built", False, "built", "absent")
        return
    counts = {"path": size.of(PATHS), "room": size.of(ROOMS), "door": size.of(DOORS)}
    tasks = [
        (kind, index, index < size.of(CHANGED))
        for kind, count in counts.items()
        for index in range(count)
    ]
    tally: Counter[str] = Counter()
    without: Counter[str] = Counter()
    unproven: list[str] = []
    false: list[str] = []
    for found in in_processes(judge, tasks, 50, "paths and traps"):
        tally.update(found["tally"])
        without.update(found["without"])
        unproven += found["unproven"]
        false += found["false"]
    findings.none("certificates that the proved checker does not verify", unproven)
    findings.none("changed certificates that are proved, and refuted by check.py", false)
    for what in ("paths", "traps"):
        findings.law(
            f"answers about {what} that are proved", tally[what] > 0, "some", f"{tally[what]:,}"
        )
    findings.target("changed certificates", tally["changed"] >= size.of(LEAST),
                    f"at least {size.of(LEAST):,}", f"{tally['changed']:,}")  # fmt: skip
    told = "; ".join(f"{count} without: {why}" for why, count in sorted(without.items()))
    findings.note(
        f"seed {SEED}: {tally['paths']:,} answers about random paths and {tally['traps']:,} about "
        f"traps proved at all their scales, contact allowed and forbidden"
        + (f"; {told}" if told else "")
        + f"; of {tally['changed']:,} changed certificates {tally['changed, proved']:,} proved, "
        f"all verified by check.py too, which verifies {tally['changed, not proved']:,} more"
    )
    findings.figures["proved"] = {**tally, "without": dict(without)}
    _large(findings)


def judge(task: tuple[str, int, bool]) -> dict[str, Any]:
    """One path or place, with both contacts (a door: contact forbidden)."""
    kind, index, changes = task
    several = [_made(kind, index, contact) for contact in CONTACTS]
    there = [one for one in several if one is not None and one.certificate is not None]
    tally: Counter[str] = Counter()
    unproven, false = [], []
    with tempfile.TemporaryDirectory() as folder:
        files = [written(one, Path(folder), str(k)) for k, one in enumerate(there)]
        for one, verdict in zip(there, verdicts(in_proved(), files) if files else (), strict=True):
            tally["paths" if kind == "path" else "traps"] += not verdict.code
            if verdict.code:
                unproven.append(f"{one.name} (seed {SEED}): {verdict.why}")
        if changes and files:
            false = _changed(there[-1].name, files[-1], tally)
    without = Counter(one.why for one in several if one is not None and one.certificate is None)
    return {"tally": tally, "without": without, "unproven": unproven, "false": false}


def _made(kind: str, index: int, contact: str) -> Made | None:
    name = f"{kind} {index}, {contact}"
    if kind == "path":
        case = path_case(SEED, index)
        sets = case.part, case.obstacles
        return made(name, sets, case.path, lambda proof: proof.valid(contact))
    if kind == "room":
        part, room, at = trap_in_room(random.Random(f"{SEED}:trap:{index}"))
        return made(name, (part, room), [at], lambda proof: proof.trap(contact))
    if contact == "allowed":
        return None
    door = trap_case(SEED, index)
    sets = door.part, door.obstacles
    return made(name, sets, [door.at], lambda proof: proof.trap(contact))


def _changed(name: str, file: Path, tally: Counter[str]) -> list[str]:
    """Changed certificates that are proved, and not verified by check.py."""
    dice = random.Random(name)
    value = json.loads(file.read_text(encoding="utf-8"))
    every = [mutant for mutant in mutants(value, 1, dice) if mutant.path[0] in ("steps", "claims")]
    some = dice.sample(every, min(EACH, len(every)))
    files = [file.with_name(f"changed{number}.cert.json") for number in range(len(some))]
    for path, mutant in zip(files, some, strict=True):
        path.write_text(json.dumps(mutant.value), encoding="utf-8")
    false = []
    ours, theirs = verdicts(in_proved(), files), verdicts(in_python(), files)
    for mutant, one, other in zip(some, ours, theirs, strict=True):
        tally["changed"] += 1
        tally["changed, proved"] += not one.code
        tally["changed, not proved"] += bool(one.code) and not other.code
        if not one.code and other.code:
            false.append(f"{name} (seed {SEED}): {mutant.way} at {mutant.path}: {other.why}")
    return false


def _large(findings: Findings) -> None:
    """Processor time for the certificate of a path of 100 segments, beside the other checkers."""
    part, obstacles, path = large_path()
    one = made("the large path", (part, obstacles), path, lambda proof: proof.valid())
    commands = {"proved": in_proved(), "check.py": in_python(), "minkref-check": in_cpp()}
    with tempfile.TemporaryDirectory() as folder:
        file = written(one, Path(folder), "it")
        found = {name: timed(command, file) for name, command in commands.items()}
    codes = [verdict.code for verdict, _ in found.values()]
    findings.equal("the large path: verified by all three", [0, 0, 0], codes)
    findings.figures["the large path: seconds"] = {
        name: round(seconds, 3) for name, (_, seconds) in found.items()
    }
