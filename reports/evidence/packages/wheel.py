"""Packages as people get them: a wheel on a bare machine, the sources in a build."""

from __future__ import annotations

import json
import shutil
import subprocess
import sys
import tempfile
from pathlib import Path

from minkref.reports.evidence.framework.part import EVERYTHING, Findings, Minutes, Size
from minkref.reports.evidence.framework.places import FOLDER, ROOT

RESTS_ON = EVERYTHING
MINUTES = Minutes(None, 0.5, 40)


def call(findings: Findings, title: str, *command: str | Path) -> str | None:
    """Runs a command with its log in build/evidence. Returns the output; None on failure."""
    log = FOLDER / f"packages {title}.log".replace(" ", "-")
    done = subprocess.run(
        [str(word) for word in command], cwd=ROOT, capture_output=True, text=True, check=False
    )
    log.write_text(done.stdout + done.stderr, encoding="utf-8")
    print(f"{title}: exit code {done.returncode}", flush=True)
    findings.law(title, done.returncode == 0, "exit code 0", f"exit code {done.returncode}")
    return done.stdout if done.returncode == 0 else None


def bare(findings: Findings, folder: Path) -> None:
    said = call(
        findings,
        "make the wheel",
        sys.executable,
        "tools/packaging/wheel.py",
        "--out",
        folder / "dist",
    )
    if said is None:
        return
    wheel, rows = Path(said.split()[-1]), folder / "rows.json"
    findings.figures["wheel"] = {"name": wheel.name, "bytes": wheel.stat().st_size}
    if not shutil.which("bwrap"):
        findings.note("no bubblewrap: the wheel was made, its commands were not tried")
        return
    call(
        findings,
        "all commands",
        sys.executable,
        "tools/packaging/bare.py",
        wheel,
        "--figures",
        rows,
    )
    if rows.is_file():
        tried = json.loads(rows.read_text(encoding="utf-8"))
        failed = [row["line"] for row in tried if row["faults"]]
        findings.figures["lines"] = len(tried)
        findings.law("lines that do not do what they should", not failed, "none", failed or "none")


def fetched(findings: Findings, folder: Path) -> None:
    build = folder / "fetched"
    sources = ("-S", ROOT / "tests" / "consumer" / "fetched", "-B", build, "-G", "Ninja")
    options = (f"-DMINKREF_SOURCES={ROOT}", "-DCMAKE_BUILD_TYPE=Release")
    if call(findings, "configure with the sources", "cmake", *sources, *options) is None:
        return
    if call(findings, "build with the sources", "cmake", "--build", build, "-j", "2") is not None:
        call(findings, "run with the sources", build / "consumer")


def installed(findings: Findings, folder: Path) -> None:
    """Checks `cmake --install`: the build's interpreter finds the package without PYTHONPATH."""
    prefix = folder / "prefix"
    call(findings, "virtual environment", sys.executable, "-m", "venv", "--without-pip", prefix)
    command = ("cmake", "--install", ROOT / "build" / "release", "--component", "python")
    call(findings, "cmake --install", *command, "--prefix", prefix)
    code = "import minkref, minkref._core as core; print(minkref.__version__, core.__file__)"
    python = (prefix / "bin" / "python", "-P")  # not from the current folder, which has the sources
    said = call(findings, "import what is installed", *python, "-c", code)
    findings.law("it is the installed one", str(prefix) in (said or ""), prefix.name, said)


def run(findings: Findings, size: Size) -> None:
    with tempfile.TemporaryDirectory(prefix="minkref-packages-") as name:
        folder = Path(name)
        if size is Size.FULL:  # the other two build for an hour
            bare(findings, folder)
            fetched(findings, folder)
        installed(findings, folder)
