"""Exact sums of polyhedra of any shape against CGAL's Nef polyhedra and Manifold: seconds."""

from __future__ import annotations

import json
import math
from fractions import Fraction
from pathlib import Path
from typing import Any

from minkref.fuzz.judges.space.space_manifold import MANIFOLD, NEAREST
from minkref.fuzz.judges.space.space_nef import NEF
from minkref.output.documents import replacing
from minkref.reports.bench.space_pairs import GROWING, PAIRS, SIZES, TimedPair
from minkref.reports.bench.space_tools import THREADS, Timed, Tools
from minkref.reports.evidence.framework.part import Counts, Findings, Minutes, Size
from minkref.reports.space_speed_plot import draw

MINUTES = Minutes(None, 1.5, 30)
ALONE = True

NEF_LIMIT = 300.0  # seconds for a call with a target for Nef's time
LIMIT = Counts(0.0, 20.0, 60.0)  # of any other
GROWN = Counts(0, 2, 99)  # of the sizes, the first so many
LONGEST = 20.0  # seconds of our time after which a family ends
BUSY = 0.1  # machine share of other programs beyond which processor time counts

PLOT = Path("reports/evidence/space_speed.svg")


def look(pair: TimedPair, tools: Tools, limit: float, findings: Findings) -> dict[str, Any]:
    """Runs all tools on one pair, one after the other, and records the findings. `limit` is Nef's
    limit. If other programs take much of the machine, processor time replaces wall clock: half of
    it for our two threads, all of it for Nef."""
    P, Q = pair.solids()
    ours, nef, manifold = tools.exact(P, Q), tools.nef(P, Q), tools.manifold(P, Q)
    # A killed call reports no processor time, so its own time would look like other programs' time.
    others = max(ours.others, nef.others if nef.seconds is not None else 0.0)
    busy = others > BUSY
    ratio, bound = ratio_of(ours, nef, limit, busy)
    row = {
        "name": pair.name,
        "facets": [len(P.triangles), len(Q.triangles)],
        "minkref": ours.seconds,
        NEF: nef.seconds,
        MANIFOLD: manifold.seconds,
        "processor": {"minkref": ours.processor, NEF: nef.processor, MANIFOLD: manifold.processor},
        "others": {"minkref": ours.others, NEF: nef.others, MANIFOLD: manifold.others},
        "by_processor_time": busy,
        "ratio": ratio,
        "ratio_is_a_bound": bound,
        "volume_difference": difference(ours, manifold),
        "equal": None if nef.text is None or ours.text is None else nef.text == ours.text,
        "why": {"minkref": ours.why, NEF: nef.why, MANIFOLD: manifold.why},
    }
    print(json.dumps(row), flush=True)
    how = ", by processor time" if busy else ""
    seconds = spent(ours, busy, THREADS)
    if pair.seconds is not None:
        met = seconds is not None and seconds <= pair.seconds
        reached = "no answer" if seconds is None else f"{seconds:.2f} s"
        findings.target(f"{pair.name}: seconds{how}", met, f"at most {pair.seconds:g} s", reached)
    if pair.ratio is not None:
        met = ratio is not None and ratio >= pair.ratio
        more = "more than " if bound else ""
        reached = f"none: {nef.why}" if ratio is None else f"{more}{ratio:,.1f}"
        what = f"{pair.name}: Nef's time to ours{how}"
        findings.target(what, met, f"at least {pair.ratio:g}", reached)
    findings.note(told(row))
    return row


def spent(answer: Timed, busy: bool, threads: int = 1) -> float | None:
    """Wall clock, or on a busy machine the processor time divided by the threads; None without an
    answer."""
    if not busy or answer.seconds is None or answer.processor is None:
        return answer.seconds
    return answer.processor / threads


def ratio_of(ours: Timed, nef: Timed, limit: float, busy: bool) -> tuple[float | None, bool]:
    """Nef's time divided by ours, and whether the ratio is only a lower bound, since Nef hit its
    limit."""
    seconds = spent(ours, busy, THREADS)
    over = nef.why.startswith("no answer in")
    if seconds is None or (nef.seconds is None and not over):
        return None, False
    theirs = limit if over else nef.seconds
    if busy:
        theirs = nef.processor
    return (None if theirs is None else theirs / seconds), over


def difference(ours: Timed, manifold: Timed) -> float | None:
    """The difference of Manifold's volume from the exact volume, relative to the exact volume."""
    if ours.volume is None or manifold.volume is None:
        return None
    exact = Fraction(ours.volume)
    return float(abs(Fraction(manifold.volume) - exact) / exact)


def told(row: dict[str, Any]) -> str:
    """One sentence: facets, seconds, ratio, equality, volume."""
    parts = []
    for tool in ("minkref", NEF, MANIFOLD):
        seconds = row[tool]
        spent = row["processor"][tool]
        what = row["why"][tool] if seconds is None else f"{seconds:.3f} s"
        parts.append(f"{tool} {what}" + (f" ({spent:.2f} of processor)" if spent else ""))
    if row["ratio"] is not None:
        more = "more than " if row["ratio_is_a_bound"] else ""
        how = "half of our processor time" if row["by_processor_time"] else "ours"
        parts.append(f"Nef's time to {how} {more}{row['ratio']:,.1f}")
    if row["equal"] is not None:
        parts.append("the same as Nef's" if row["equal"] else "NOT the same as Nef's")
    if row["volume_difference"] is not None:
        parts.append(f"Manifold's volume off by {row['volume_difference']:.1e}")
    p, q = row["facets"]
    return f"{row['name']} ({p:,} and {q:,} triangles): {', '.join(parts)}"


def grow(family: str, sizes: tuple[int, ...], tools: Tools) -> list[dict[str, Any]]:
    """Until ours takes too long; another tool is not asked again after its limit."""
    rows = []
    over: set[str] = set()
    for size in sizes:
        P, Q = GROWING[family](size)
        row: dict[str, Any] = {
            "family": family,
            "size": size,
            "facets": len(P.triangles) + len(Q.triangles),
        }
        calls = {"minkref": tools.exact, NEF: tools.nef, MANIFOLD: tools.manifold}
        answers = {name: call(P, Q) for name, call in calls.items() if name not in over}
        for name in calls:
            threads = THREADS if name == "minkref" else 1
            answer = answers.get(name, Timed())
            row[name] = spent(answer, answer.others > BUSY, threads)
            row[f"{name}_others"] = answer.others
        over |= {name for name in calls if row[name] is None}
        ours = answers["minkref"] if "minkref" in answers else Timed()
        nef = answers.get(NEF, Timed())
        row["equal"] = None if nef.text is None or ours.text is None else nef.text == ours.text
        row["volume_difference"] = difference(ours, answers.get(MANIFOLD, Timed()))
        print(json.dumps(row), flush=True)
        rows.append(row)
        if ours.seconds is None or ours.seconds > LONGEST:
            break
    return rows


def grown(rows: list[dict[str, Any]], findings: Findings) -> None:
    """Notes how each tool's time grows at the end of its curve."""
    for family in GROWING:
        for tool in ("minkref", NEF, MANIFOLD):
            own = [row for row in rows if row["family"] == family and row[tool] is not None]
            if len(own) < 3:
                continue
            first, last = own[-3], own[-1]
            power = math.log(last[tool] / first[tool]) / math.log(last["facets"] / first["facets"])
            findings.note(
                f"{family}: {tool} does {last['facets']:,} triangles in {last[tool]:.2f} s; its "
                f"time grows as the {power:.1f}th power of them at the end"
            )


def run(findings: Findings, size: Size) -> None:
    rows: list[dict[str, Any]] = []
    grows: list[dict[str, Any]] = []
    limit = size.of(LIMIT)
    for has_ratio in (True, False):
        nef_limit = NEF_LIMIT if has_ratio and size is Size.FULL else limit
        with Tools(limit, nef_limit) as tools:
            for pair in PAIRS:
                if (pair.ratio is not None) == has_ratio and (pair.quick or size is Size.FULL):
                    rows.append(look(pair, tools, nef_limit, findings))
    with Tools(limit) as tools:
        for name, why in tools.absent.items():
            findings.note(f"{name} is not installed: {why}")
        for family, sizes in SIZES.items():
            grows += grow(family, sizes[: size.of(GROWN)], tools)
    every = [*rows, *({"name": f"{row['family']} {row['size']}", **row} for row in grows)]
    findings.none("no sum of ours", [row["name"] for row in every if row["minkref"] is None])
    findings.none(
        "sums that are not Nef's, plane by plane",
        [row["name"] for row in every if row["equal"] is False],
    )
    if NEF not in tools.absent:
        same = sum(row["equal"] is True for row in every)
        findings.law("sums that are Nef's, as text", same > 0, "some", same)
    far = [
        f"{row['name']}: {row['volume_difference']:.1e}"
        for row in every
        if row["volume_difference"] is not None and row["volume_difference"] > NEAREST
    ]
    compared = sum(row["volume_difference"] is not None for row in every)
    if compared:
        what = f"volumes of Manifold that are off by more than {NEAREST:g}"
        findings.target(what, not far, f"0 of {compared}", "; ".join(far[:3]) or 0)
    grown(grows, findings)
    findings.note(
        "wall clock of the call alone in a warm child process, from operands in the form of the "
        "tool to its result: ours with the canonical form, Nef's lazy numbers not evaluated; the "
        "median of three calls below a second"
    )
    by_processor = [row["name"] for row in rows if row["by_processor_time"]]
    if by_processor:
        findings.note(
            f"others took more than {BUSY:.0%} of the machine during {len(by_processor)} of "
            f"{len(rows)} pairs, and of points of the plot: there half of the processor time of "
            "our two threads stands for our seconds, and for those of another tool all of its own, "
            "with what it does to take operands and to give a result"
        )
    findings.figures = {"rows": rows, "growth": grows}
    if size is Size.FULL:
        with replacing(PLOT) as temporary:
            draw(grows, temporary)
