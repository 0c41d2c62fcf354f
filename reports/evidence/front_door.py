"""The commands of the README in fresh clones: this commit, and one before they were cheaper."""

from __future__ import annotations

import os
import resource
import shutil
import statistics
import subprocess
import tempfile
import time
from dataclasses import dataclass
from pathlib import Path

from minkref.reports.evidence.framework.part import Findings
from minkref.reports.evidence.framework.store import FOLDER, ROOT

SUBJECT = (
    "Fresh clones of this commit and of one before the front door was made cheaper, with an empty "
    "compiler cache: make run, then make test, an edit of one source to a tested result, and the "
    "start of the command, all in one run."
)
MINUTES = (75, None)
ALONE = True
DEPENDS = (
    "Makefile", "CMakeLists.txt", "*/CMakeLists.txt", "cmake/*", "requirements.txt", "scripts/*",
    "reference/**/*.?pp", "python/**/*", "formats/*.?pp",
)  # fmt: skip

BEFORE = "d726505"  # nothing of the front door had been made cheaper
RUN_RATIO, TEST_RATIO = 0.4, 0.6
EDIT_SECONDS = 20.0
STARTS = 15
TRIANGLES = ("POLYGON((0 0,1 0,0 1,0 0))", "POLYGON((0 0,2 0,0 3,0 0))")
#: What a start may take of what it took; and the seconds of both on the machine of the target.
START_RATIOS = {"--version": 0.15 / 0.6, "sum of two triangles": 0.25 / 0.7}
EDITED = "formats/decimal.cpp"
EDITED_TEST = ("test_formats", "--gtest_filter=*Decimal*")


@dataclass(frozen=True)
class Taken:
    """Seconds on the clock, and of all processors."""

    clock: float
    processor: float
    code: int

    def __str__(self) -> str:
        return f"{self.clock:.0f} s ({self.processor:.0f} s of processor time)"


class Clone:
    """The files of a commit in a folder of its own, and commands in it with nothing but PATH and
    HOME in their environment."""

    def __init__(self, folder: Path, commit: str) -> None:
        self.root = folder / commit
        subprocess.run(["git", "clone", "--quiet", ROOT, self.root], check=True)
        subprocess.run(["git", "-C", self.root, "checkout", "--quiet", commit], check=True)
        self.name = commit

    def call(self, *command: str) -> Taken:
        log = FOLDER / "front_door" / f"{self.name}-{'-'.join(command[:2])}.log".replace("/", "-")
        log.parent.mkdir(parents=True, exist_ok=True)
        path = [part for part in os.environ["PATH"].split(":") if str(ROOT / ".venv") not in part]
        environment = {"PATH": ":".join(path), "HOME": os.environ["HOME"], "CCACHE_DISABLE": "1"}
        began, spent = time.monotonic(), processor_seconds()
        with open(log, "w", encoding="utf-8") as out:
            done = subprocess.run(
                command, cwd=self.root, env=environment, stdin=subprocess.DEVNULL,
                stdout=out, stderr=out, check=False,
            )  # fmt: skip
        clock = time.monotonic() - began
        taken = Taken(clock, processor_seconds() - spent, done.returncode)
        print(f"{self.name}: {' '.join(command)}: exit code {done.returncode}, {taken}", flush=True)
        return taken

    def start(self, *words: str) -> float:
        """Seconds of processor time of the command, the least of some runs."""
        command = [str(self.root / ".venv" / "bin" / "minkref"), *words]
        seconds = []
        for _ in range(STARTS):
            spent = processor_seconds()
            subprocess.run(command, cwd=self.root, capture_output=True, check=True)
            seconds.append(processor_seconds() - spent)
        return statistics.median(seconds)


def processor_seconds() -> float:
    """Of all children that have ended."""
    usage = resource.getrusage(resource.RUSAGE_CHILDREN)
    return usage.ru_utime + usage.ru_stime


def edit(clone: Clone) -> Taken:
    """From a changed source to the result of its tests."""
    source = clone.root / EDITED
    source.write_text(source.read_text(encoding="utf-8") + "\n// Edited.\n", encoding="utf-8")
    test, words = EDITED_TEST
    line = (
        f"cmake --build build/release --target {test} && build/release/tests/formats/{test} {words}"
    )
    return clone.call("bash", "-c", line)


def run(_: bool) -> Findings:
    findings = Findings()
    folder = Path(tempfile.mkdtemp(prefix="minkref-front-door-"))
    folder.chmod(0o755)  # tests run programs as another user too
    now = subprocess.run(
        ["git", "-C", ROOT, "rev-parse", "--short", "HEAD"],
        capture_output=True,
        text=True,
        check=True,
    ).stdout.strip()
    try:
        old, new = Clone(folder, BEFORE), Clone(folder, now)
        # This commit first: what it gets wrong is seen soonest.
        taken = {
            (clone.name, command): clone.call("make", command)
            for clone in (new, old) for command in ("run", "test")
        }  # fmt: skip
        for command, most in (("run", RUN_RATIO), ("test", TEST_RATIO)):
            before, after = taken[old.name, command], taken[new.name, command]
            findings.law(f"make {command}: exit code", after.code == 0, 0, after.code)
            if before.code:
                findings.note(f"make {command} at {BEFORE} ended with exit code {before.code}.")
            ratio = after.clock / before.clock
            findings.target(
                f"make {command}, fresh, of {BEFORE}'s time", ratio <= most, most, f"{ratio:.2f}"
            )
            findings.figures[f"make {command}"] = {BEFORE: str(before), now: str(after)}
            share = after.processor / before.processor
            findings.note(
                f"make {command}: {before} at {BEFORE}, {after} now; of the processor "
                f"time {share:.2f}."
            )
        starts = {"--version": ["--version"], "sum of two triangles": ["sum", *TRIANGLES]}
        for name, words in starts.items():
            before_s, after_s = old.start(*words), new.start(*words)
            most = START_RATIOS[name]
            findings.target(
                f"start, {name}: of {BEFORE}'s processor time", after_s / before_s <= most,
                f"{most:.2f}", f"{after_s / before_s:.2f} ({before_s:.2f} s, {after_s:.2f} s)",
            )  # fmt: skip
        edited = edit(new)
        findings.law("the edit: exit code", edited.code == 0, 0, edited.code)
        findings.target(
            "an edit of one source to its tested result", edited.clock <= EDIT_SECONDS,
            f"{EDIT_SECONDS:.0f} s", str(edited),
        )  # fmt: skip
    finally:
        shutil.rmtree(folder, ignore_errors=True)
    return findings
