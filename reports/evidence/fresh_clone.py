"""A fresh clone in a clean environment: the commands of the README, with their times."""

from __future__ import annotations

import os
import shutil
import subprocess
import tempfile
import time
from pathlib import Path

from minkref.reports.evidence.framework.part import Findings, names
from minkref.reports.evidence.framework.store import FOLDER, ROOT

SUBJECT = (
    "A fresh clone with nothing but PATH and HOME in its environment: make run, make test, "
    "make evidence QUICK=1 succeed; times of the first and of the second call."
)
MINUTES = (45, None)
ALONE = True
DEPENDS = (
    "Makefile",
    "CMakeLists.txt",
    "CMakePresets.json",
    "requirements.txt",
    "pyproject.toml",
    "cmake/*",
    "scripts/*",
    *(
        f"{room}/**/{glob}"
        for room in ("reference", "formats", "oracle", "python", "fuzz", "tests", "reports")
        for glob in ("*.py", "*.cpp", "*.hpp", "CMakeLists.txt")
        if any(ROOT.glob(f"{room}/**/{glob}"))
    ),
)

RUN_LIMIT = 300.0  # seconds of `make run` when all is built


def environment() -> dict[str, str]:
    """PATH and HOME, and a compiler cache that is switched off: times are those of a cold one."""
    path = [part for part in os.environ["PATH"].split(":") if str(ROOT / ".venv") not in part]
    return {"PATH": ":".join(path), "HOME": os.environ["HOME"], "CCACHE_DISABLE": "1"}


def call(findings: Findings, clone: Path, title: str, *command: str) -> float:
    """Runs a command in the clone; its log goes to build/evidence."""
    log = FOLDER / f"fresh_clone {title}.log".replace(" ", "-")
    began = time.monotonic()
    with open(log, "w", encoding="utf-8") as out:
        code = subprocess.run(
            command, cwd=clone, env=environment(), stdin=subprocess.DEVNULL, stdout=out, stderr=out
        ).returncode
    seconds = time.monotonic() - began
    print(f"{title}: exit code {code}, {seconds:.0f} s", flush=True)
    findings.figures[title] = {"seconds": round(seconds, 1), "code": code}
    findings.law(title, code == 0, "exit code 0", f"exit code {code}, {seconds:.0f} s")
    return seconds


def run(quick: bool) -> Findings:
    findings = Findings()
    git = ["git", "-C", str(ROOT)]
    state = subprocess.run(
        [*git, "status", "--porcelain"], capture_output=True, text=True, check=True
    )
    if state.stdout.strip():
        findings.note("the checkout has changes that are not committed; the clone is without them")
    folder = Path(tempfile.mkdtemp(prefix="minkref-clone-"))
    try:
        clone = folder / "minkref"
        subprocess.run(["git", "clone", "--quiet", str(ROOT), str(clone)], check=True)
        head = subprocess.run(
            [*git, "rev-parse", "HEAD"], capture_output=True, text=True, check=True
        )
        findings.figures["commit"] = head.stdout.strip()
        call(findings, clone, "make setup", "make", "setup")
        first = call(findings, clone, "make run", "make", "run")
        findings.target("seconds of make run, built", first <= RUN_LIMIT, RUN_LIMIT, f"{first:.0f}")
        again = call(findings, clone, "make run again", "make", "run")
        findings.target(
            "seconds of the second make run", again <= RUN_LIMIT, RUN_LIMIT, f"{again:.0f}"
        )
        call(findings, clone, "make test", "make", "test")
        only = "ONLY=" + " ".join(name for name in names() if name != "fresh_clone")
        call(findings, clone, "make evidence QUICK=1", "make", "evidence", "QUICK=1", only)
        clean = subprocess.run(
            ["git", "-C", str(clone), "status", "--porcelain"], capture_output=True, text=True
        ).stdout.strip()
        findings.law("files left in the way of git", clean == "", "none", clean[:200] or "none")
    finally:
        shutil.rmtree(folder, ignore_errors=True)
    return findings
