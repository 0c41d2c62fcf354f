"""Sums of larger polyhedra of any shape equal CGAL's sums, and have Manifold's volume."""

from __future__ import annotations

import sys
import time
from collections import Counter
from fractions import Fraction
from typing import Any

from minkref import _core
from minkref.fuzz.judges.space.space_manifold import MANIFOLD, NEAREST, ManifoldJudge
from minkref.fuzz.judges.space.space_nef import NEF, NefJudge
from minkref.fuzz.judges.space.space_routes import core_polyhedron
from minkref.fuzz.judges.space.space_sums import REFUSALS, SpaceSums
from minkref.fuzz.space.large_pairs import large_pair
from minkref.reports.evidence.framework.in_processes import in_processes
from minkref.reports.evidence.framework.part import Counts, Findings, Minutes, Size

MINUTES = Minutes(None, 2, 25)

SEED = 2012
PAIRS = Counts(1, 16, 200)
SECONDS = Counts(8.0, 10.0, 15.0)  # of a call
POINTS, POINTS_ALONE = 4, 20

Task = tuple[int, Size]
_judges: dict[Size, tuple[NefJudge, ManifoldJudge]] = {}  # of this process, which ends them


def judge(task: Task) -> dict[str, Any]:
    """Judges all answers on one pair."""
    sys.set_int_max_str_digits(0)  # exact volumes have as many digits as they need
    index, size = task
    if size not in _judges:
        seconds = size.of(SECONDS)
        _judges[size] = (NefJudge(seconds), ManifoldJudge(seconds))
    nef_judge, manifold_judge = _judges[size]
    pair = large_pair(SEED, index)
    sums = SpaceSums(pair)
    row: dict[str, Any] = {
        "name": pair.name,
        "facets": len(pair.P.triangles) + len(pair.Q.triangles),
        "compared": [],
        "difference": None,
        "messages": sums.messages,
    }
    start = time.perf_counter()
    try:
        found = _core.edge_sum_in_space(
            core_polyhedron(pair.P), core_polyhedron(pair.Q), ("1", "1", "1")
        )
    except REFUSALS as error:  # the pair is valid
        sums.say(f"gives no sum: {type(error).__name__}: {error}")
        return row
    row["seconds"] = round(time.perf_counter() - start, 3)
    sums.answers["edges"] = found.canonical_json()
    nef = nef_judge.sum(pair.P, pair.Q)
    if nef is not None:
        sums.answers[NEF] = nef
        row["compared"].append(NEF)
    volume = manifold_judge.volume(pair.P, pair.Q)
    row["difference"] = volume.difference(Fraction(found.volume()))
    if row["difference"] is not None:
        row["compared"].append(MANIFOLD)
    sums.compare(POINTS if row["compared"] else POINTS_ALONE)
    row["compared"].append("points")
    return row


def run(findings: Findings, size: Size) -> None:
    count = size.of(PAIRS)
    compared: Counter[str] = Counter()
    messages: list[str] = []
    off: list[str] = []
    alone: list[str] = []
    facets: list[int] = []
    slowest: tuple[float, str] = (0.0, "")
    tasks = [(index, size) for index in range(count)]
    for row in in_processes(judge, tasks, each=max(1, count // 20), what="pairs"):
        compared.update(row["compared"])
        messages += row["messages"]
        facets.append(row["facets"])
        slowest = max(slowest, (row.get("seconds", 0.0), row["name"]))
        if row["difference"] is not None and row["difference"] > NEAREST:
            off.append(f"{row['name']}: {row['difference']:.1e}")
        if row["compared"] == ["points"]:
            alone.append(row["name"])
        for message in row["messages"]:
            print(message, flush=True)
    for name, absence in ((NEF, NefJudge(1).absence), (MANIFOLD, ManifoldJudge(1).absence)):
        if absence:
            findings.note(f"{name} is not installed: {absence}")
    findings.none("disagreements with Nef polyhedra and with points", messages)
    findings.equal("pairs held against points", count, compared["points"])
    findings.law("sums that are Nef's, plane by plane", compared[NEF] > 0, "some", compared[NEF])
    findings.target(
        "volumes of Manifold that are off", not off,
        f"0 of {compared[MANIFOLD]} by more than {NEAREST:g}", "; ".join(off[:3]) or 0,
    )  # fmt: skip
    wanted = count * 9 // 10
    findings.target(
        "pairs on which Nef or Manifold answers in time", count - len(alone) >= wanted,
        wanted, count - len(alone),
    )  # fmt: skip
    findings.note(
        f"seed {SEED}; {min(facets)} to {max(facets)} triangles; slowest of ours: {slowest[1]}, "
        f"{slowest[0]} s on one thread"
    )
    findings.figures = {
        "pairs": count,
        "compared": dict(compared),
        "alone": alone,
        "off": off,
        "disagreements": messages[:20],
    }
