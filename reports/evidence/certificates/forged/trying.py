"""Forgeries tried on each checker: a process for each file, with exit code, time, memory."""

from __future__ import annotations

import json
import os
import random
import re
import resource
import subprocess
import time
from collections import Counter
from collections.abc import Sequence
from dataclasses import dataclass, field
from pathlib import Path

from minkref.reports.evidence.certificates.checkers import in_command, in_cpp, in_proved, in_python
from minkref.reports.evidence.certificates.forged import (
    bodies,
    cases,
    hits,
    motions,
    plane_boxes,
    plane_claims,
    plane_points,
    plane_steps,
    seams,
    sets,
    texts,
    transplants,
)
from minkref.reports.evidence.certificates.forged.ideas import (
    IDEAS,
    Forgery,
    Kept,
    Maker,
    Unfit,
    forged,
)
from minkref.reports.evidence.certificates.forged.raw import Raw

# modules that keep their ideas when imported
KEEPERS = (bodies, cases, hits, motions, plane_boxes, plane_claims, plane_points, plane_steps,
           seams, sets, texts, transplants)  # fmt: skip
SECONDS, ROOM = 20, 2 * 1024**3  # of the processor, and of addresses, for one checker and file
FILE = "it.cert.json"
REFUSALS = {"refuted": 1, "malformed": 2, "out of budget": 4, "declined": 5}
REFUSED = {1, 2, 4}
VERIFIED = re.compile(r"^.*: verified\s*$", re.M)
SAID = re.compile(r"^(/\S+): (verified|refuted|malformed|out of budget|declined)\b", re.M)
ONE_BY_ONE = {"lines_like_a_verdict", "packed", "nested_deep", "case_that_is_elsewhere"}


@dataclass
class Trial:
    """A forgery as a folder with files, and what the checkers say."""

    idea: str
    kind: str
    form: str
    raw: str
    folder: Path
    codes: dict[str, int] = field(default_factory=dict)
    slowest: float = 0
    faults: list[str] = field(default_factory=list)

    @property
    def name(self) -> str:
        return f"{self.idea} of {self.raw} ({self.folder.name})"


def made(folder: Path, raws: Sequence[Raw], count: int, seed: int) -> list[Trial]:
    """So many forgeries, the ideas in turn, each about the certificates in turn; none twice."""
    maker = Maker(random.Random(seed), raws)
    seen: set[tuple[bytes, bytes]] = set()
    found: list[Trial] = []
    misses: Counter[str] = Counter()
    ideas = [kept for kept in IDEAS if any(kept.make.__module__ == m.__name__ for m in KEEPERS)]
    maker.dice.shuffle(ideas)
    while len(found) < count and ideas:
        for kept in list(ideas):
            one = attempt(kept, maker, seen)
            if one is None:
                misses[kept.name] += 1
                if misses[kept.name] > 40:
                    ideas.remove(kept)
                continue
            raw, forgery = one
            found.append(written(folder / f"{len(found):04d}", kept, raw, forgery))
            if len(found) == count:
                break
    return found


def attempt(kept: Kept, maker: Maker, seen: set[tuple[bytes, bytes]]) -> tuple[Raw, Forgery] | None:
    fitting = [raw for raw in maker.raws if kept.fits(raw)]
    if not fitting:
        return None
    raw = maker.dice.choice(fitting)
    try:
        forgery = forged(kept, raw, maker)
    except Unfit:
        return None
    key = as_bytes(forgery.certificate), as_bytes(forgery.case or raw.name)
    if key in seen:
        return None
    seen.add(key)
    return raw, forgery


def as_bytes(text: str | bytes) -> bytes:
    return text if isinstance(text, bytes) else text.encode("utf-8", "surrogatepass")


def written(folder: Path, kept: Kept, raw: Raw, forgery: Forgery) -> Trial:
    """The certificate as it.cert.json, beside the case."""
    folder.mkdir()
    text = as_bytes(forgery.certificate).replace(b"FILE: verified", b"it.cert.json: verified")
    (folder / FILE).write_bytes(text)
    data = as_bytes(json.dumps(raw.case) if forgery.case is None else forgery.case)
    for name in (str(raw.certificate["case"]["path"]), "it.case.json"):
        (folder / name).write_bytes(data)
    return Trial(kept.name, kept.kind, raw.form, raw.name, folder)


def checkers(proved: bool) -> dict[str, list[str]]:
    """Each alone; the proved one if it is there."""
    found = {"check.py": in_python(), "minkref-check": in_cpp()}
    if proved:
        found["minkref-check-proved"] = in_proved()
    return {name: [*command, "--seconds", str(SECONDS)] for name, command in found.items()}


def tried_together(trials: Sequence[Trial], commands: dict[str, list[str]]) -> Sequence[Trial]:
    """Asks each checker about all of them at once, and alone about each one on which it says
    anything but that it is refused."""
    for name, command in commands.items():
        files = [str(trial.folder / FILE) for trial in trials]
        began = time.perf_counter()
        code, out = ended(command, files, Path("/"), len(trials))
        seconds = (time.perf_counter() - began) / len(trials)
        words = verdicts(out)
        for trial in trials:
            said = words.get(str(trial.folder / FILE), [])
            trial.slowest = max(trial.slowest, seconds)
            plainly = len(said) == 1 and said[0] in REFUSALS and code in {*REFUSED, 5}
            if plainly and trial.idea not in ONE_BY_ONE:
                trial.codes[name] = REFUSALS[said[0]]
            else:
                tried(trial, {name: command})
    return trials


def verdicts(out: str) -> dict[str, list[str]]:
    found: dict[str, list[str]] = {}
    for file, word in SAID.findall(out):
        found.setdefault(file, []).append(word)
    return found


def tried(trial: Trial, commands: dict[str, list[str]]) -> Trial:
    """Asks each checker alone; notes what is a fault of any."""
    for name, command in commands.items():
        began = time.perf_counter()
        code, out = ended(command, [FILE], trial.folder, 1)
        trial.slowest = max(trial.slowest, time.perf_counter() - began)
        trial.codes[name] = code
        judge(trial, name, code, out)
    return trial


def ended(command: list[str], files: list[str], folder: Path, count: int) -> tuple[int, str]:
    """Exit code and output, with limits for so many files; code 124 without an end."""

    def limited() -> None:
        resource.setrlimit(resource.RLIMIT_CPU, (2 * count * SECONDS, 2 * count * SECONDS))
        resource.setrlimit(resource.RLIMIT_AS, (ROOM, ROOM))

    try:
        ran = subprocess.run([*command, *files], cwd=folder, capture_output=True, check=False,
                             timeout=20 * SECONDS, stdin=subprocess.DEVNULL, preexec_fn=limited,
                             env={"PATH": os.defpath, "LANG": "C.UTF-8"})  # fmt: skip
    except subprocess.TimeoutExpired:
        return 124, ""
    return ran.returncode, (ran.stdout + ran.stderr).decode(errors="replace")


def judge(trial: Trial, name: str, code: int, out: str) -> None:
    refused = REFUSED | ({5} if name == "minkref-check-proved" else set())
    if code == 0:
        trial.faults.append(f"{name}: accepted")
    elif code not in refused:
        trial.faults.append(f"{name}: ended with {code}: {out[-300:]}")
    if "Traceback" in out:
        trial.faults.append(f"{name}: a traceback: {out[-300:]}")
    if VERIFIED.search(out):
        trial.faults.append(f"{name}: a line says verified: {out[:300]}")
    if code and not out.strip():
        trial.faults.append(f"{name}: refused without a word")


def by_command(trials: Sequence[Trial], *options: str) -> list[str]:
    """What `minkref check` says to many at once: those it verifies, or does not mention."""
    files = [str(trial.folder / FILE) for trial in trials]
    ran = subprocess.run([*in_command(), *options, *files], capture_output=True, check=False)
    out = ran.stdout.decode(errors="replace")
    said = verdicts(out)
    wrong = [f"{file}: {said.get(file)}" for file in files
             if len(said.get(file, [])) != 1 or said[file][0] not in REFUSALS]  # fmt: skip
    if ran.returncode not in REFUSED | {5} or b"Traceback" in ran.stderr:
        wrong.append(f"ended with {ran.returncode}: {ran.stderr[-300:].decode(errors='replace')}")
    return wrong


def truths(folder: Path, raws: Sequence[Raw]) -> list[str]:
    """True certificates that a checker does not verify."""
    files = [str(folder / f"{raw.name}.cert.json") for raw in raws]
    wrong = []
    for name, command in checkers(False).items():
        _, out = ended(command, files, folder, len(raws))
        words = verdicts(out)
        wrong += [f"{name}: {file}" for file in files if words.get(file) != ["verified"]]
    return wrong
