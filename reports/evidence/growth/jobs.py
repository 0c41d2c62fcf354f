"""Jobs over sizes: processor time and memory of each command, how fast both grow, and CGAL's."""

from __future__ import annotations

import math
import sys
import tempfile
from collections.abc import Callable
from dataclasses import asdict, dataclass
from pathlib import Path
from typing import Any

from minkref import _core
from minkref.fuzz.cgal.oracle import CgalOracle
from minkref.output.documents import replacing
from minkref.reports.evidence.framework.command import COMMAND, Cost, cost
from minkref.reports.evidence.framework.comparing import available_cgal
from minkref.reports.evidence.framework.part import Counts, Findings, Minutes, Size
from minkref.reports.evidence.growth import bodies, outlines
from minkref.reports.growth_plot import draw

MINUTES = Minutes(None, None, 15)
ALONE = True

PLOT = Path("reports/evidence/growth.svg")
SHARE = Counts(0, 8, 1)  # of the sizes below
LEAST = 24  # vertices or triangles: what every run of the command takes
LIMIT = Counts(0.0, 10.0, 60.0)  # seconds; larger sizes are then left out
MOST = 1.2  # exponent
SURE = 0.1  # seconds beyond the start: less tells no exponent
AGAIN, SHORT = 4, 3.0  # times a run shorter than these seconds is measured again
PEER = 2.0  # times CGAL's


@dataclass(frozen=True)
class Job:
    """`words` has {P} for the operand of a size and {Q} for the other one."""

    name: str
    make: Callable[[int], str]
    words: str
    largest: int
    suffix: str = "wkt"

    @property
    def sizes(self) -> list[int]:
        return [self.largest // 8, self.largest // 4, self.largest // 2, self.largest]


@dataclass(frozen=True)
class Run:
    job: str
    size: int
    seconds: float
    megabytes: float
    cgal: float | None


READ = "import sys, minkref; minkref.PolyhedralSet(minkref.read_mesh(sys.argv[1]))"
SUM, WINDOW = "sum {P} {Q} --json", "--from 1/2 --to 2"
JOBS = [
    *(Job(f"sum, {name}", make, SUM, 64_000) for name, make in (
        ("combs", outlines.comb), ("sheared combs", outlines.sheared_comb),
        ("stars", outlines.star), ("spirals", outlines.spiral), ("coasts", outlines.coast),
        ("plates", outlines.plate), ("frames", outlines.frames), ("islands", outlines.islands),
    )),
    *(Job(f"index, {name}", make, f"index {{P}} {{Q}} {WINDOW} -o index.bin --threads 1", 16_000)
      for name, make in (("combs", outlines.comb), ("stars", outlines.star),
                         ("coasts", outlines.coast))),
    *(Job(f"pair events, {name}", make, f"events {{P}} {{Q}} {WINDOW} --kind pair --json", 32_000)
      for name, make in (("stars", outlines.star), ("coasts", outlines.coast))),
    *(Job(f"sum with a disc, {name}", make, "sum {P} disc:5 --json", 32_000) for name, make in (
        ("combs", outlines.comb), ("stars", outlines.star), ("plates", outlines.plate))),
    *(Job(f"events of a disc, {name}", make, "events {P} disc --json", 8_000) for name, make in (
        ("combs", outlines.comb), ("stars", outlines.star), ("plates", outlines.plate))),
    *(Job(f"sum in space, {name}", make, SUM, largest, "off") for name, make, largest in (
        ("tori", bodies.torus, 16_000), ("terrains", bodies.terrain, 16_000),
        ("double cones", bodies.double_cone, 2_000),
        ("prisms over combs", bodies.comb_prism, 8_000),
    )),
    *(Job(f"reading a mesh, {name}", make, "read {P}", largest, "off")
      for name, make, largest in (
        ("tori", bodies.torus, 64_000), ("double cones", bodies.double_cone, 16_000),
        ("prisms over combs", bodies.comb_prism, 16_000))),
]  # fmt: skip


def run(findings: Findings, size: Size) -> None:
    runs: list[Run] = []
    with tempfile.TemporaryDirectory(prefix="minkref-growth-") as name:
        folder = Path(name)
        (folder / "Q.wkt").write_text(outlines.OCTAGON)
        (folder / "Q.off").write_text(bodies.CUBE)
        starts = {}
        with_cgal = bool(available_cgal(findings, "cgal-reduced"))
        for job in JOBS:
            starts[job.name] = _asked(job, LEAST, folder).seconds
            runs += _runs(job, folder, size, with_cgal)
            own = [one for one in runs if one.job == job.name]
            _tell(findings, job, own, starts[job.name])
    findings.figures = {"starts": starts, "runs": [asdict(one) for one in runs]}
    if size is Size.FULL:
        with replacing(PLOT) as target:
            draw(findings.figures["runs"], target)


def _runs(job: Job, folder: Path, size: Size, with_cgal: bool) -> list[Run]:
    found: list[Run] = []
    for count in job.sizes:
        count //= size.of(SHARE)
        took = _asked(job, count, folder)
        has_peer = with_cgal and job.name.startswith("sum, ")
        peer = _cgal(folder / f"P.{job.suffix}", size.of(LIMIT)) if has_peer else None
        found.append(Run(job.name, count, took.seconds, took.mib, peer))
        if took.seconds > size.of(LIMIT):
            break
    return found


def _asked(job: Job, count: int, folder: Path) -> Cost:
    """The least of some runs, where they are short: other work only adds to it."""
    P = folder / f"P.{job.suffix}"
    P.write_text(job.make(count))
    words = job.words.format(P=P, Q=folder / f"Q.{job.suffix}").split()
    is_read = words[0] == "read"
    command = [sys.executable, "-c", READ, *words[1:]] if is_read else [*COMMAND, *words]
    runs = [cost(command, folder)]
    runs += [cost(command, folder) for _ in range(AGAIN if runs[0].seconds < SHORT else 0)]
    return Cost(min(one.seconds for one in runs), max(one.mib for one in runs))


def _cgal(P: Path, seconds: float) -> float | None:
    sets = [_core.read_text(text, "wkt").canonical_json()
            for text in (P.read_text(), outlines.OCTAGON)]  # fmt: skip
    with CgalOracle("reduced", seconds=seconds) as oracle:
        answer = oracle.sum(*sets)
    return answer.seconds if answer.status == "result" else None


def exponent(runs: list[Run], start: float) -> float | None:
    """The slope over the last three sizes; None if they are too quick to tell."""
    points = [(math.log(one.size), math.log(one.seconds - start))
              for one in runs[-3:] if one.seconds - start > SURE]  # fmt: skip
    if len(points) < 2:
        return None
    xs, ys = zip(*points, strict=True)
    x, y = sum(xs) / len(xs), sum(ys) / len(ys)
    return float(sum((a - x) * (b - y) for a, b in points) / sum((a - x) ** 2 for a in xs))


def _tell(findings: Findings, job: Job, runs: list[Run], start: float) -> None:
    last, grows = runs[-1], exponent(runs, start)
    told: Any = "too quick to tell" if grows is None else f"{grows:.2f}"
    findings.target(f"{job.name}: exponent of the processor time", grows is None or grows <= MOST,
                    f"at most {MOST}", f"{told}; {last.size:,}: {last.seconds:.2f} s, "
                    f"{last.megabytes:.0f} MB")  # fmt: skip
    if last.cgal is None:
        return
    ratio = max(0.0, last.seconds - start) / last.cgal
    findings.target(f"{job.name}: times CGAL's reduced convolution, {last.size:,} vertices",
                    ratio <= PEER, f"at most {PEER:g}",
                    f"{ratio:.2f} ({last.cgal:.2f} s)")  # fmt: skip
