"""The slow engine against the routes of the reference, and against the methods of CGAL."""

from __future__ import annotations

import json
import time
from collections import Counter
from fractions import Fraction
from html import escape
from pathlib import Path
from typing import Any

from minkref.fuzz.cases.case_name import CaseName
from minkref.fuzz.cgal.executables import target_names
from minkref.fuzz.judges.plane import slow_points, slow_sums, slow_tight_passages, slow_topology
from minkref.fuzz.judges.plane.cgal_claims import CgalClaims
from minkref.fuzz.judges.plane.large_points import decided_otherwise
from minkref.fuzz.plane.case import Case
from minkref.fuzz.run.naming import load_in_plane
from minkref.reports.drawing import Layer, picture
from minkref.reports.evidence.framework.in_processes import in_processes
from minkref.reports.evidence.framework.operands import case_of, tell_absent
from minkref.reports.evidence.framework.part import Counts, Findings, Minutes, Size
from minkref.reports.evidence.framework.places import FOLDER

MINUTES = Minutes(0.1, 1, 6)

SEED = 1905
PAIRS = Counts(30, 300, 2000)
JUDGES = {
    "sums": slow_sums.judge,
    "topology": slow_topology.judge,
    "tight passages": slow_tight_passages.judge,
    "points": slow_points.judge,
}
POINTS = 20
WITNESS_SECONDS = 60.0
DRAWN = FOLDER / "slow_engine_and_cgal.html"


def judge(index: int) -> dict[str, Any]:
    """Judges a pair; CGAL alone judges pairs without holes, since some CGAL methods take no
    others."""
    case: Case = load_in_plane(CaseName(f"random:{SEED}:{index}", "random pairs"))
    holes = case.P.ring_count + case.Q.ring_count > 2
    tally: Counter[str] = Counter()
    faults = []
    for name, rule in JUDGES.items() if holes else ():
        ruling = rule(case)
        tally[name] = ruling.compared
        faults += [f"{case.name.text} {name}: {message}" for message in ruling.messages]
    global _claims
    if _claims is None:
        _claims = CgalClaims(target_names())
    rows = _claims.against(case)
    return {"holes": holes, "tally": tally, "faults": faults, "cgal": rows}


_claims: CgalClaims | None = None


def draw(rows: list[dict[str, Any]]) -> str:
    """A page with all differences: the slow engine's sum, CGAL's sum, and the witness."""
    figures = []
    for row in rows:
        point = tuple(float(Fraction(x)) for x in row["point"])
        mark = Layer("witness", point=(point[0], point[1]))
        caption = f"{row['method']}, {row['case']}"
        pictures = "".join(
            f"<figure>{picture([Layer(style, _rings(row[key])), mark], caption)}"
            f"<figcaption>{text}</figcaption></figure>"
            for style, key, text in (("sum", "truth", "slow engine"), ("got", "claim", "CGAL"))
        )
        where = "in the sum" if row["in_truth"] else "not in the sum"
        figures.append(f"<h2>{escape(caption)}</h2><p>The point is {where}.</p>{pictures}")
    style = (
        "figure{display:inline-block} .sum{fill:#9bd}.got{fill:#fb8}.witness{fill:red;stroke:red}"
        "path{fill-rule:evenodd;stroke:#333}"
    )
    return (
        f"<!doctype html><meta charset=utf-8><title>Slow engine and CGAL</title><style>{style}"
        f"</style><h1>{len(rows)} differences</h1>{''.join(figures)}\n"
    )


def _rings(polygons: Any) -> list[list[list[tuple[float, float]]]]:
    return [
        [[(float(Fraction(x)), float(Fraction(y))) for x, y in ring] for ring in polygon]
        for polygon in polygons
    ]


def large_operands(findings: Findings) -> None:
    """Times single points on operands as large as the paper's models, including reading."""
    for first, second, scale in (("monkey", "bird", "1"), ("neuron", "bird", "1/3")):
        tell_absent(findings, first, second)
        case = case_of(first, second, scale)
        since = time.perf_counter()
        different = decided_otherwise(case, POINTS, SEED)
        seconds = time.perf_counter() - since
        name = case.name.text
        findings.none(f"{name}: points decided otherwise", len(different))
        findings.target(
            f"{name}: seconds for {POINTS} points", seconds < WITNESS_SECONDS,
            f"under {WITNESS_SECONDS:.0f} for one", f"{seconds:.1f} for all",
        )  # fmt: skip


def run(findings: Findings, size: Size) -> None:
    wanted = size.of(PAIRS)
    tally: Counter[str] = Counter()
    faults: list[str] = []
    rows: list[dict[str, Any]] = []
    outcomes: Counter[str] = Counter()
    done = 0
    for result in in_processes(judge, range(3 * wanted), each=100, what="pairs at most"):
        done += result["holes"]
        tally.update(result["tally"])
        faults += result["faults"]
        for row in result["cgal"]:
            outcomes[f"{row['method']}: {row['outcome']}"] += 1
            if row["outcome"] == "different":
                rows.append(row)
        if done == wanted:
            break
    findings.law("pairs with holes", done >= wanted, f"{wanted:,}", f"{done:,}")
    findings.none("differences from the reference", len(faults))
    for name in JUDGES:
        findings.law(f"{name} compared", tally[name] > 0, "some", f"{tally[name]:,}")
    agree = sum(count for name, count in outcomes.items() if name.endswith("equal"))
    findings.target("CGAL's sums that agree", agree > 0, "some", f"{agree:,}")
    DRAWN.parent.mkdir(parents=True, exist_ok=True)
    DRAWN.write_text(draw(rows), encoding="utf-8")
    undrawn = sum(row["point"] is None for row in rows)
    findings.none("differences from CGAL that are not drawn", undrawn)
    findings.note(f"{len(rows)} differences from CGAL are drawn in {Path(DRAWN.name)}")
    large_operands(findings)
    findings.figures |= {
        "seed": SEED,
        "compared": dict(tally),
        "faults": faults[:10],
        "CGAL": dict(sorted(outcomes.items())),
        "different": json.loads(
            json.dumps([{k: r[k] for k in ("method", "case", "point")} for r in rows])
        ),
    }
