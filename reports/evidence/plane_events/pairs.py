"""All pair and parallel events of the paper's pairs: how many, how fast, and whether they are
right at single scales."""

from __future__ import annotations

import time
from fractions import Fraction
from typing import Any

from minkref import _core
from minkref.fuzz.geometry.plane import Vector, cross, fraction_rings, minus, plus, segments_meet
from minkref.fuzz.geometry.space import denominator_of
from minkref.output.documents import peak_bytes
from minkref.reports.evidence.framework.operands import operand, tell_absent
from minkref.reports.evidence.framework.part import Findings, Minutes, Size

MINUTES = Minutes(0.05, 0.3, 0.3)

#: pairs that meet on an interval; births and deaths; counts for SS, ST and TT pairs
COUNTED = {
    ("disc1", "neuron"): (76_761, 145_453, (39_809, 77_912, 27_732)),
    ("monkey", "bird"): (1_535_530, 3_026_701, (718_956, 1_605_254, 702_491)),
}
PAPER_TOTALS = {("disc1", "neuron"): 56_238, ("monkey", "bird"): 56_996_430}
LIMITS = {("disc1", "neuron"): (2.0, 4096), ("monkey", "bird"): (30.0, 4096)}  # seconds, MiB
CHECKED_AT = (Fraction(1, 3), Fraction(1), Fraction(541, 186))
BIRTH, DEATH, TOUCH = 0, 1, 2
Segment = tuple[Vector[int], Vector[int]]


def run(findings: Findings, size: Size) -> None:
    for names in COUNTED:
        _pair(findings, names, size)


def _pair(findings: Findings, names: tuple[str, str], size: Size) -> None:
    P, Q = (operand(name) for name in names)
    title = f"{P.name} + {Q.name}"
    began = time.perf_counter()
    found = _core.pair_events(P.set, Q.set)
    seconds = time.perf_counter() - began
    peak = peak_bytes() / 2**20
    counts = dict(found.counts())
    tally = _tally(found)
    births_and_deaths = sum(tally["types"])
    findings.figures[title] = {
        **counts,
        "births and deaths": births_and_deaths,
        "of SS, ST, TT pairs": tally["types"],
        "parallel events": tally["parallel"],
        "seconds": round(seconds, 3),
        "pairs a second": round(counts["pairs"] / seconds),
        "events a second": round(counts["count"] / seconds),
        "peak MiB": round(peak),
        "share of pairs decided by the filter": counts["filtered_pairs"] / counts["pairs"],
        "the paper's total": PAPER_TOTALS[names],
    }
    descents = tally["descents"]
    findings.none(f"{title}: events before one of a smaller scale", descents)
    limit, memory = LIMITS[names]
    findings.target(f"{title}: seconds", seconds < limit, f"under {limit:g}", f"{seconds:.2f}")
    findings.target(f"{title}: peak MiB", peak < memory, f"under {memory}", f"{peak:.0f}")
    if tell_absent(findings, *names):
        wanted = COUNTED[names]
        got = (counts["intersecting_pairs"], births_and_deaths, tuple(tally["types"]))
        findings.target(
            f"{title}: meeting pairs; births and deaths; of SS, ST, TT", got == wanted,
            str(wanted), str(got),
        )  # fmt: skip
        findings.note(
            f"{title}: the paper's total of {PAPER_TOTALS[names]:,} follows from no rule that we "
            "know; it is not reproduced"
        )
    if names == ("disc1", "neuron"):
        for s in CHECKED_AT[:1] if size is Size.QUICK else CHECKED_AT:
            expected, got_at = _meeting_by_events(found, s), _meeting_by_signs(P.set, Q.set, s)
            findings.equal(
                f"{title}: pairs that meet at {s}, by orientation signs", got_at, expected
            )


def _tally(found: _core.PairEvents) -> dict[str, Any]:
    columns = {name: memoryview(raw) for name, raw in found.columns().items()}
    a, b, rank = (columns[name].cast("I") for name in ("a", "b", "rank"))
    _, _, nearest, which = found.scale_texts()
    values, numbers = memoryview(nearest).cast("d"), memoryview(which).cast("i")
    scale = [values[k] for k in numbers]
    change, parallel = columns["change"], columns["parallel"]
    is_s = [row[0] == "S" for row in found.edges()]
    types = [0, 0, 0]
    parallel_events = 0
    descents = 0
    for i in range(len(found)):
        if i and (rank[i] < rank[i - 1] or scale[i] < scale[i - 1]):
            descents += 1
        if parallel[i]:
            parallel_events += 1
        elif change[i] != TOUCH:
            types[2 - is_s[a[i]] - is_s[b[i]]] += 1
    return {"types": types, "parallel": parallel_events, "descents": descents}


def _meeting_by_events(found: _core.PairEvents, s: Fraction) -> int:
    """Pairs, not parallel, whose interval holds s."""
    counts = found.counts()
    columns = {name: memoryview(raw) for name, raw in found.columns().items()}
    a, b = columns["a"].cast("I"), columns["b"].cast("I")
    change, parallel = columns["change"], columns["parallel"]
    begins, texts, _, _ = found.scale_texts()
    begin = memoryview(begins).cast("q")
    rank = columns["rank"].cast("I")
    scales = [Fraction(texts[begin[i] : begin[i + 1]].decode()) for i in range(len(begin) - 1)]
    alive = int(counts["always_meeting_pairs"])
    born: set[tuple[int, int]] = set()
    with_birth: set[tuple[int, int]] = set()
    dead: set[tuple[int, int]] = set()
    with_death: set[tuple[int, int]] = set()
    for i in range(len(found)):
        if parallel[i]:
            continue
        pair, when = (a[i], b[i]), scales[rank[i]]
        if change[i] == TOUCH:
            alive += when == s
        elif change[i] == BIRTH:
            with_birth.add(pair)
            if when <= s:
                born.add(pair)
        else:
            with_death.add(pair)
            if when < s:
                dead.add(pair)
    for pair in with_birth | with_death:
        alive += (pair not in with_birth or pair in born) and pair not in dead
    return alive


def _meeting_by_signs(P: _core.PolygonSet, Q: _core.PolygonSet, s: Fraction) -> int:
    """Pairs of edges of the reduced convolution, not parallel, with a common point at scale s: a
    sweep over x intervals, and integer orientation signs."""
    active: list[tuple[int, Segment]] = []
    count = 0
    for left, right, (a, b) in sorted(
        (min(a[0], b[0]), max(a[0], b[0]), (a, b)) for a, b in _segments(P, Q, s)
    ):
        active = [entry for entry in active if entry[0] >= left]
        count += sum(
            cross(minus(b, a), minus(d, c)) != 0 and segments_meet(a, b, c, d)
            for _, (c, d) in active
        )
        active.append((right, (a, b)))
    return count


def _segments(P: _core.PolygonSet, Q: _core.PolygonSet, s: Fraction) -> list[Segment]:
    """Times a common denominator."""
    first, second = fraction_rings(P.to_json(), s), fraction_rings(Q.to_json())
    denominator = denominator_of(point for ring in (*first, *second) for point in ring)
    found: list[Segment] = []
    for kind, _, edge_ring, edge, vertex_ring, vertex in _core.reduced_convolution(P, Q):
        moving, fixed = (first, second) if kind == "S" else (second, first)
        ring, at = moving[edge_ring], fixed[vertex_ring][vertex]
        ends = plus(ring[edge], at), plus(ring[(edge + 1) % len(ring)], at)
        a, b = ((int(x * denominator), int(y * denominator)) for x, y in ends)
        found.append((a, b))
    return found
