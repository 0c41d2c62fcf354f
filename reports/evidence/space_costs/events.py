"""Events between facets of sums, complete and exact, on large pairs: seconds and memory."""

from __future__ import annotations

import multiprocessing
import time
from multiprocessing.connection import Connection
from pathlib import Path
from typing import Any

from minkref import _core
from minkref.fuzz.judges.space.space_routes import core_polyhedron
from minkref.output.documents import peak_bytes, replacing
from minkref.reports.bench.space_pairs import EVENT_PAIRS, Solids
from minkref.reports.evidence.framework.part import Counts, Findings, Minutes, Size
from minkref.reports.space_event_plot import draw

MINUTES = Minutes(0.05, 0.8, 12)
ALONE = True

WINDOW = ("1/5", "2")
THREADS = 2
PLOT = Path("reports/evidence/space_event_speed.svg")
THEIRS = 8_427_881 / (65 * 60)  # events per second, as the paper gives them for its pair
MOST_SECONDS, MOST_SECONDS_OF_ALL = 90, 240
MOST_BYTES = 4e9
LEAST_RATE = 100_000  # events of two facets a second and core
PAIRS = Counts(1, 2, 99)  # the first so many


def run(findings: Findings, size: Size) -> None:
    rows = []
    pairs = EVENT_PAIRS[: size.of(PAIRS)]
    for pair in pairs:
        for concurrent in (False, True):
            row = {
                "name": pair.name,
                "of": "all" if concurrent else "two",
                **_timed(pair.solids(), concurrent),
            }
            rows.append(row)
            print(row, flush=True)
            findings.note(_told(row))
    same = sum(two["events"] == every["events"] > 0
               for two, every in zip(rows[::2], rows[1::2], strict=True))  # fmt: skip
    findings.equal("pairs whose events of two facets do not depend on the others", len(pairs), same)
    findings.figures = {"rows": rows}
    if size is not Size.FULL:
        return
    of_two, of_all = rows[-2:]  # of the largest pair
    name = of_two["name"]
    for row, most in ((of_two, MOST_SECONDS), (of_all, MOST_SECONDS_OF_ALL)):
        findings.target(
            f"{name}: seconds for events of {_of(row)}", row["seconds"] <= most, f"at most {most}",
            f"{row['seconds']:.0f}",
        )  # fmt: skip
        findings.target(
            f"{name}: bytes for events of {_of(row)}", row["bytes"] <= MOST_BYTES,
            f"at most {MOST_BYTES / 1e9:g} GB", f"{row['bytes'] / 1e9:.2f} GB",
        )  # fmt: skip
    rate = of_two["events"] / of_two["processor"]
    findings.target(
        f"{name}: events of two facets a second and core", rate >= LEAST_RATE,
        f"at least {LEAST_RATE:,}", f"{rate:,.0f}, {rate / THEIRS:.0f} times the paper's",
    )  # fmt: skip
    findings.note(
        "the paper's models are not ours, and what it counts as an event is not told: the rates "
        "are beside each other and prove no equal work"
    )
    with replacing(PLOT) as temporary:
        draw(rows, THEIRS, temporary)


def _of(row: dict[str, Any]) -> str:
    return "two facets" if row["of"] == "two" else "two, three and four facets"


def _told(row: dict[str, Any]) -> str:
    more = (
        f", {row['triple']:,} of three and {row['four']:,} of four, from {row['tracks']:,} tracks"
        if row["of"] == "all" else ""
    )  # fmt: skip
    return (
        f"{row['name']}: {row['events']:,} events of two facets{more}, in {row['seconds']:.1f} s "
        f"on {THREADS} threads, {row['processor']:.1f} s of processor, {row['bytes'] / 1e9:.2f} GB"
    )


def _timed(solids: Solids, concurrent: bool) -> dict[str, Any]:
    """Runs in a separate child process, to measure its memory."""
    context = multiprocessing.get_context("spawn")
    ours, theirs = context.Pipe()
    child = context.Process(target=_work, args=(theirs, solids, concurrent))
    child.start()
    theirs.close()
    try:
        found: dict[str, Any] = ours.recv()
    finally:
        child.join()
    return found


def _work(answer: Connection, solids: Solids, concurrent: bool) -> None:
    P, Q = map(core_polyhedron, solids)
    before = peak_bytes()
    began, processor = time.perf_counter(), time.process_time()
    found = _core.space_events(P, Q, *WINDOW, threads=THREADS, concurrent=concurrent)
    seconds, spent = time.perf_counter() - began, time.process_time() - processor
    most = peak_bytes()
    counts = dict(found.counts())
    answer.send({
        **counts, "events": len(found), "seconds": seconds, "processor": spent,
        "bytes": most, "bytes_before": before,
    })  # fmt: skip
