"""The commands of the README in fresh clones: this commit, and one before they were cheaper."""

from __future__ import annotations

import statistics
import subprocess
import tempfile
from pathlib import Path

from minkref.reports.evidence.framework.clone import Clone, Taken, git, processor_seconds
from minkref.reports.evidence.framework.part import Findings
from minkref.reports.evidence.framework.store import ROOT

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


def start(clone: Clone, *words: str) -> float:
    """Seconds of processor time of the command, the middle of some runs."""
    command = [str(clone.root / ".venv" / "bin" / "minkref"), *words]
    seconds = []
    for _ in range(STARTS):
        spent = processor_seconds()
        subprocess.run(command, cwd=clone.root, capture_output=True, check=True)
        seconds.append(processor_seconds() - spent)
    return statistics.median(seconds)


def edit(clone: Clone) -> Taken:
    """From a changed source to the result of its tests."""
    source = clone.root / EDITED
    source.write_text(source.read_text(encoding="utf-8") + "\n// Edited.\n", encoding="utf-8")
    test, words = EDITED_TEST
    line = (
        f"cmake --build build/release --target {test} && build/release/tests/formats/{test} {words}"
    )
    return clone.call("edit", "bash", "-c", line)


def run(findings: Findings, _: bool) -> None:
    now = git(ROOT, "rev-parse", "--short", "HEAD")
    with tempfile.TemporaryDirectory(
        prefix="minkref-front-door-", ignore_cleanup_errors=True
    ) as name:
        Path(name).chmod(0o755)  # tests run programs as another user too
        old, new = (Clone(Path(name, commit), commit) for commit in (BEFORE, now))
        # This commit first: what it gets wrong is seen soonest.
        taken = {
            (clone, command): clone.call(f"make {command}", "make", command)
            for clone in (new, old) for command in ("run", "test")
        }  # fmt: skip
        for command, most in (("run", RUN_RATIO), ("test", TEST_RATIO)):
            before, after = taken[old, command], taken[new, command]
            findings.equal(f"make {command}: exit code", 0, after.code)
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
            before_s, after_s = start(old, *words), start(new, *words)
            most = START_RATIOS[name]
            findings.target(
                f"start, {name}: of {BEFORE}'s processor time", after_s / before_s <= most,
                f"{most:.2f}", f"{after_s / before_s:.2f} ({before_s:.2f} s, {after_s:.2f} s)",
            )  # fmt: skip
        edited = edit(new)
        findings.equal("the edit: exit code", 0, edited.code)
        findings.target(
            "an edit of one source to its tested result", edited.clock <= EDIT_SECONDS,
            f"{EDIT_SECONDS:.0f} s", str(edited),
        )  # fmt: skip
