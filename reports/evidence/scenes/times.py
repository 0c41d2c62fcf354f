"""Times of scenes: sums, union and change, beside CGAL and the static route."""

from __future__ import annotations

import json
import random
import subprocess
import sys
import time
from collections.abc import Callable
from dataclasses import dataclass
from fractions import Fraction
from pathlib import Path
from statistics import median
from typing import Any

from minkref import Copy, PolygonSet, Scene, _core
from minkref.fuzz.all_targets import ALL_TARGETS
from minkref.plane.operand import read_operand
from minkref.reports.copies_cost_plot import draw
from minkref.reports.evidence.framework.part import Counts, Findings, Minutes, Size
from minkref.reports.evidence.scenes.joined import CgalSums, Joining

MINUTES = Minutes(None, 1.5, 5)
ALONE = True

SIZES: Counts[tuple[int, ...]] = Counts((12, 100), (12, 100, 1_000), (12, 100, 1_000, 10_000))
REPETITIONS = Counts(3, 3, 7)
JOINED: Counts[tuple[int, ...]] = Counts((12,), (12, 100), (12, 1_000))  # sizes at which CGAL joins
MODELS, ROBOT = ("g1", "g2", "g3", "g4"), "g4"
ROBOT_SCALE = "1/5"
SPACING = 150  # of the copies, which are some 100 wide times 0.3 to 2
SAMPLED = 24  # copies whose sums other methods compute
ROUNDS = 50  # evaluations from the index that a repetition takes the median of
CHANGES = 40
CHANGED = 1_000  # copies of the scene with the changes that a target is about
SEED = 11
PLOT = Path("reports/evidence/scene_costs.svg")
MOST_SECONDS, MOST_BYTES = 60, 4 << 30  # for the most copies


@dataclass(frozen=True)
class Timed:
    """Seconds of all repetitions; `counts`: of the last."""

    seconds: tuple[float, ...]
    value: Any = None

    @property
    def median(self) -> float:
        return median(self.seconds)

    def in_words(self, unit: float = 1.0, name: str = "s") -> str:
        low, high = min(self.seconds), max(self.seconds)
        return f"{unit * self.median:,.3g} {name} ({unit * low:,.3g} to {unit * high:,.3g})"


def timed(work: Callable[[], Any], repetitions: int) -> Timed:
    seconds = []
    for _ in range(repetitions):
        value = None  # the end of the one before is no part of this one
        began = time.perf_counter()
        value = work()
        seconds.append(time.perf_counter() - began)
    return Timed(tuple(seconds), value)


def operands() -> tuple[PolygonSet, list[PolygonSet]]:
    return read_operand(ROBOT).set.scaled(ROBOT_SCALE), [read_operand(m).set for m in MODELS]


def placed(count: int) -> list[Copy]:
    """Copies with scales of their own over a square, one for each SPACING squared."""
    dice = random.Random(f"minkref scene times {SEED} {count}")
    side = int(SPACING * count**0.5)
    return [
        Copy(
            dice.randrange(len(MODELS)),
            Fraction(dice.randint(300, 2000), 1000),
            (Fraction(dice.randint(0, 10 * side), 10), Fraction(dice.randint(0, 10 * side), 10)),
        )
        for _ in range(count)
    ]


def run(findings: Findings, size: Size) -> None:
    repetitions = size.of(REPETITIONS)
    robot, shapes = operands()
    _sums(findings, robot, shapes, repetitions)
    rows = []
    sizes: tuple[int, ...] = SIZES[size]
    for count in sizes:
        row = _scene(findings, robot, shapes, count, repetitions)
        if count in JOINED[size]:
            _beside_cgal(findings, robot, shapes, count, row)
        rows.append(row)
        print(row, flush=True)
    findings.figures["rows"] = rows
    if size is Size.FULL:
        _largest(findings, max(sizes))
        draw(rows, PLOT)


def _sums(
    findings: Findings, robot: PolygonSet, shapes: list[PolygonSet], repetitions: int
) -> None:
    """A sum at a new scale: from the index, by the static route, by CGAL."""
    turned = robot.scaled("-1")
    copies = placed(SAMPLED)
    asked = [(int(c.shape), str(c.scale)) for c in copies]
    indices = [_core.ScaleIndex(shape, turned, "3/10", "2") for shape in shapes]
    sums = CgalSums()
    own, other, cgal = [], [], []
    for _ in range(repetitions):  # all sides in turn
        evaluated = timed(
            lambda: [indices[shape].rings(scale, "homogeneous") for shape, scale in asked], ROUNDS
        )
        own.append(evaluated.median)
        anew = timed(
            lambda: [_core.minkowski_sum(shapes[shape], turned, scale) for shape, scale in asked], 1
        )
        other.append(anew.median)
        answers = [sums.sum(shapes[int(c.shape)], c.scale, turned) for c in copies]
        cgal.append(sum(answer[1] for answer in answers if answer is not None))
    from_index, static, theirs = (Timed(tuple(seconds)) for seconds in (own, other, cgal))
    findings.note(
        f"{SAMPLED} sums at scales of their own, exact: index {from_index.in_words(1e6, 'µs')}, "
        f"static route {static.in_words(1e3, 'ms')}, CGAL's reduced convolution "
        f"{theirs.in_words(1e3, 'ms')}"
    )
    for what, slower, least in (("CGAL", theirs, 1_000), ("our static route", static, 300)):
        ratio = slower.median / from_index.median
        findings.target(f"evaluation of sums, against {what}", ratio >= least,
                        f"at least {least:,} times faster", f"{ratio:,.0f} times")  # fmt: skip


def _scene(
    findings: Findings, robot: PolygonSet, shapes: list[PolygonSet], count: int, repetitions: int
) -> dict[str, Any]:
    copies = placed(count)

    def united() -> Scene:
        scene = Scene(robot, shapes, copies, threads=2)
        scene.union()
        return scene

    whole = timed(united, repetitions)
    scene = whole.value
    dice = random.Random(f"minkref scene changes {count}")
    changes, with_form, redone = [], [], []
    changed = scene
    for _ in range(CHANGES):
        at = dice.randrange(count)
        del changed  # its end is no part of the next change
        scale = Fraction(dice.randint(300, 2000), 1000)
        began = time.perf_counter()
        changed = scene.change(at, scale)
        changes.append(time.perf_counter() - began)
        changed.union()
        with_form.append(time.perf_counter() - began)
        redone.append(changed.copies_redone)
    change, form = Timed(tuple(changes)), Timed(tuple(with_form))
    findings.note(
        f"{count:,} copies: union {whole.in_words()}, {scene.union().vertices:,} vertices; one "
        f"change {change.in_words(1e3, 'ms')}, with the canonical form of all "
        f"{form.in_words(1e3, 'ms')}; copies done again: median {median(redone):,.0f}, at most "
        f"{max(redone)}"
    )
    if count == CHANGED:
        ratio = whole.median / change.median
        findings.target(f"one change among {count:,}, against the scene made anew", ratio >= 100,
                        "at least 100 times faster", f"{ratio:,.0f} times")  # fmt: skip
    return {
        "copies": count,
        "union": whole.median,
        "change": change.median,
        "change_with_form": form.median,
        "vertices": scene.union().vertices,
        "copies redone": median(redone),
    }


def _beside_cgal(
    findings: Findings, robot: PolygonSet, shapes: list[PolygonSet], count: int, row: dict[str, Any]
) -> None:
    turned = robot.scaled("-1")
    copies = placed(count)
    sums, seconds, totals = CgalSums(), 0.0, []
    for copy in copies:
        answer = sums.sum(shapes[int(copy.shape)], copy.scale, turned)
        if answer is None:
            findings.target(f"{count:,} copies by CGAL", False, "all sums", "one is missing")
            return
        seconds += answer[1]
        totals.append(answer[0].translated(*map(str, copy.place)))
    with Joining() as cgal:
        joined, join_seconds = cgal.join(totals)
    _in_doubles(findings, count, totals, row["union"])
    row["cgal"] = seconds + join_seconds
    ratio = row["cgal"] / row["union"]
    least = 5 if count < 1_000 else 15
    findings.note(
        f"{count:,} copies by CGAL, once: sums {seconds:,.2f} s, join {join_seconds:,.2f} s"
    )
    same = joined == Scene(robot, shapes, copies).union()
    findings.law(f"{count:,} copies: CGAL's sums joined by CGAL are our union", same, True, same)
    findings.target(f"{count:,} copies, union from end to end, against CGAL", ratio >= least,
                    f"at least {least} times faster", f"{ratio:,.1f} times")  # fmt: skip


def _in_doubles(findings: Findings, count: int, totals: list[PolygonSet], seconds: float) -> None:
    """GEOS's union in doubles, stated: it has no sums, and is not exact."""
    entry = next(entry for entry in ALL_TARGETS.entries() if entry.name == "geos")
    if not entry.available:
        findings.note(f"GEOS is not at hand: {entry.reason}")
        return
    with Joining("geos") as geos:
        in_doubles = [PolygonSet(each.approximate_rings()) for each in totals]
        _, taken = geos.join(in_doubles)
    findings.note(
        f"{count:,} copies, the union of the finished sums by GEOS in doubles, once, reading and "
        f"writing included: {taken:,.3f} s; ours with all sums {seconds:,.3f} s"
    )


#: In a process of its own, whose memory is its own.
ALONE_IN_A_PROCESS = """\
import json, sys, time
from minkref import Scene
from minkref.output.documents import peak_bytes
from minkref.reports.evidence.scenes.times import operands, placed
robot, shapes = operands()
copies = placed(int(sys.argv[1]))
began = time.perf_counter()
scene = Scene(robot, shapes, copies, threads=2)
vertices = scene.union().vertices
seconds = time.perf_counter() - began
print(json.dumps({"seconds": seconds, "bytes": peak_bytes(), "vertices": vertices}))
"""


def _largest(findings: Findings, count: int) -> None:
    command = [sys.executable, "-c", ALONE_IN_A_PROCESS, str(count)]
    found = json.loads(subprocess.run(command, check=True, capture_output=True, text=True).stdout)
    findings.figures["the most copies"] = found
    told = f"{found['seconds']:,.1f} s, {found['bytes'] / 2**30:.2f} GiB"
    findings.target(f"{count:,} copies, all in all",
                    found["seconds"] <= MOST_SECONDS and found["bytes"] <= MOST_BYTES,
                    f"at most {MOST_SECONDS} s and 4 GiB", told)  # fmt: skip
