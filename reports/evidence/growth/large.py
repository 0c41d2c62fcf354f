"""A hundred thousand vertices, a million triangles: time, memory, how soon Ctrl-C is heard."""

from __future__ import annotations

import random
import signal
import subprocess
import sys
import tempfile
import time
from dataclasses import asdict, dataclass
from pathlib import Path

from minkref.reports.evidence.framework.command import COMMAND, cost
from minkref.reports.evidence.framework.part import Counts, Findings, Minutes, Size
from minkref.reports.evidence.growth import bodies, outlines
from minkref.reports.evidence.growth.jobs import LEAST, READ

MINUTES = Minutes(None, None, 8)
ALONE = True

SHARE = Counts(50, 10, 1)  # of the sizes below
VERTICES, TRIANGLES = 100_000, 1_000_000
SECONDS, READING = 30.0, 60.0
STOPS = Counts(2, 2, 12)  # moments of Ctrl-C for each job
SOON = 0.3  # seconds from Ctrl-C to the end
MOST_MIB = 4.0, 100.0  # of an index: times its file, and more
A_VERTEX = 1024.0  # bytes
CHECK = "import sys, minkref; minkref.read_file(sys.argv[1]).validate()"
SEED = 54


@dataclass(frozen=True)
class Large:
    """`words` as in jobs.py; `keeps`: the answer is as large as the input, or an index."""

    name: str
    text: str
    least: str
    words: str
    suffix: str = "wkt"
    keeps: bool = True

    @property
    def size(self) -> int:
        return TRIANGLES if self.suffix == "off" else VERTICES


def _large(share: int) -> list[Large]:
    index = "index {P} {Q} --from 1/2 --to 2 -o index.bin --threads 1"
    count, small = VERTICES // share, outlines.comb(LEAST)
    mesh = bodies.torus(TRIANGLES // share), bodies.torus(LEAST)
    return [
        Large("sum with 1,000 holes", outlines.sieve(count, 1000 // share),
              outlines.sieve(LEAST, 1), "sum {P} {Q} --json"),
        Large("sum with a disc, combs", outlines.comb(count), small, "sum {P} disc:5 --json"),
        Large("sum with a disc, plates", outlines.plate(count), small, "sum {P} disc:5 --json"),
        Large("index, combs", outlines.comb(count), small, index),
        Large("index, coasts", outlines.coast(count), small, index),
        Large("polygons validated", outlines.coast(count), small, "check {P}", keeps=False),
        Large("meshes validated", *mesh, "read {P}", "off", keeps=False),
    ]  # fmt: skip


def run(findings: Findings, size: Size) -> None:
    dice = random.Random(SEED)
    figures = []
    with tempfile.TemporaryDirectory(prefix="minkref-large-") as name:
        folder = Path(name)
        (folder / "Q.wkt").write_text(outlines.OCTAGON)
        for job in _large(size.of(SHARE)):
            P = folder / f"P.{job.suffix}"
            P.write_text(job.least)
            command = _command(job, folder)
            start = cost(command, folder)
            P.write_text(job.text)
            took = cost(command, folder)
            limit = READING if job.suffix == "off" else SECONDS
            most = size.of(SHARE) * (took.mib - start.mib) * 2**20 / job.size
            findings.target(f"{job.name}: seconds", took.seconds <= limit, f"at most {limit:g}",
                            f"{took.seconds:.2f}; {took.mib:.0f} MB, {most:,.0f} bytes a vertex "
                            "or triangle beyond the start")  # fmt: skip
            if not job.keeps:
                findings.target(f"{job.name}: bytes a vertex or triangle", most <= A_VERTEX,
                                f"at most {A_VERTEX:g}", f"{most:,.0f}")  # fmt: skip
            if job.words.startswith("index"):
                _index_memory(findings, job, folder, took.mib)
            stops = [_stopped(command, folder, dice.uniform(0.05, 0.95) * (took.seconds + 0.3))
                     for _ in range(size.of(STOPS))]  # fmt: skip
            heard = [one for one in stops if one is not None]
            findings.target(f"{job.name}: seconds from Ctrl-C to the end, at worst",
                            max(heard, default=0.0) <= SOON, f"at most {SOON:g}",
                            f"{max(heard, default=0.0):.2f} in {len(heard)}")  # fmt: skip
            figures.append({"job": job.name, **asdict(took), "stops": stops})
    findings.figures = {"jobs": figures}


def _command(job: Large, folder: Path) -> list[str]:
    words = job.words.format(P=folder / f"P.{job.suffix}", Q=folder / "Q.wkt").split()
    reads = {"read": READ, "check": CHECK}.get(words[0])
    return [sys.executable, "-c", reads, *words[1:]] if reads else [*COMMAND, *words]


def _index_memory(findings: Findings, job: Large, folder: Path, mib: float) -> None:
    times, more = MOST_MIB
    file = (folder / "index.bin").stat().st_size / 2**20
    findings.target(f"{job.name}: memory of the build", mib <= times * file + more,
                    f"at most {times:g} times its file and {more:g} MB",
                    f"{mib:.0f} MB, file {file:.1f} MB")  # fmt: skip


def _stopped(command: list[str], folder: Path, after: float) -> float | None:
    """Seconds from the signal to the end; None where the command had ended before."""
    ran = subprocess.Popen(
        command, cwd=folder, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL,
        preexec_fn=lambda: signal.signal(signal.SIGINT, signal.SIG_DFL),
    )  # fmt: skip
    time.sleep(after)
    if ran.poll() is not None:
        return None
    since = time.monotonic()
    ran.send_signal(signal.SIGINT)
    ran.wait(60)
    return time.monotonic() - since
