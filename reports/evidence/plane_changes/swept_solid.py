"""Boundary events against the vertex heights of the swept solid."""

from __future__ import annotations

import json
from fractions import Fraction
from typing import Any

from minkref import _core
from minkref.fuzz.cgal.swept_solid import MOST_PAIRS, SweptSolid
from minkref.fuzz.plane.families.random_pairs import Pair, random_pair
from minkref.reports.evidence.framework.part import Counts, Findings, Minutes, Size

MINUTES = Minutes(0.05, 0.4, 0.5)

SEED = 5
PAIRS = Counts(12, 80, 100)
# Fractions of primes that no event of small integer operands has.
LOW, HIGH = "101/1009", "1009/101"


def compare(solid: SweptSolid, pair: Pair) -> dict[str, Any] | None:
    """None where the pair has too many triangles."""
    answer = solid.vertices(pair.P, pair.Q, LOW, HIGH)
    if answer.status == "skipped":
        return None
    P, Q = _core.PolygonSet.from_json(pair.P), _core.PolygonSet.from_json(pair.Q)
    events = {Fraction(s) for s, *_ in _core.DynamicSum(P, Q, LOW, HIGH).boundary_events()}
    vertices = answer.vertices or ()
    heights = {vertex.s for vertex in vertices}
    return {
        "pair": pair.name,
        "status": answer.status,
        "holes": sum(len(p["holes"]) for t in (pair.P, pair.Q) for p in json.loads(t)["polygons"]),
        "seconds": answer.seconds or 0,
        "events": len(events),
        "vertices": len(vertices),
        "solid only": sorted(map(str, heights - events)),
        "ours only": sorted(map(str, events - heights)),
    }


def run(findings: Findings, size: Size) -> None:
    wanted = size.of(PAIRS)
    rows: list[dict[str, Any]] = []
    skipped = index = 0
    with SweptSolid() as solid:
        while len(rows) < wanted:
            row = compare(solid, random_pair(SEED, index))
            index += 1
            if row is None:
                skipped += 1
            else:
                rows.append(row)
                print(f"{len(rows)} of {wanted} pairs", flush=True)
    different = [row for row in rows if row["solid only"] or row["ours only"]]
    failed = [row for row in rows if row["status"] != "result"]
    holes = sum(row["holes"] > 0 for row in rows)
    findings.figures |= {
        "seed": SEED,
        "window": [LOW, HIGH],
        "most pairs of triangles": MOST_PAIRS,
        "skipped, of too many triangles": skipped,
        "heights": sum(row["events"] for row in rows),
        "vertices": sum(row["vertices"] for row in rows),
        "seconds of CGAL": round(sum(row["seconds"] for row in rows), 1),
        "different": different[:5],
        "failed": failed[:5],
    }
    findings.none("pairs on which the two differ", len(different))
    findings.none("pairs without an answer of CGAL", len(failed))
    findings.law("pairs", len(rows) >= wanted, wanted, len(rows))
    findings.target("pairs with holes", 4 * holes >= len(rows), "a quarter", holes)
    events = findings.figures["heights"]
    findings.target("scales compared", events >= len(rows), len(rows), events)
