"""The paper's own repair of convex sums: its rows in `minkref sweep`, with the exact sum beside."""

from __future__ import annotations

import sys
import time
from collections.abc import Iterator
from typing import Any

from minkref import _core
from minkref.cli.output import plain_table
from minkref.cli.row_spool import Row, RowSpool
from minkref.errors import refusing
from minkref.exact import approximate, in_double_range
from minkref.fuzz.judges.plane.rounded_sums import significant_bits
from minkref.fuzz.judges.space.convex_claims import compare_claims, largest_distance
from minkref.output.terminal import counted
from minkref.plane.commands.sweep_rows import SHOWN, print_sweep
from minkref.space.operand import SpaceOperand, solid
from minkref.space.scaling import Scaling, text_of
from minkref.verbs.paper_update import decided
from minkref.verbs.repair_options import Repair

COUNTS = ("fv_errors", "vf_errors", "ee_errors", "descent_steps", "chains_walked", "without_end",
          "chains_stuck")  # fmt: skip


class RepairWalk:
    """P and Q followed from scaling to scaling by the paper's text. Each row holds what it claims
    against the exact sum."""

    def __init__(self, P: SpaceOperand, Q: SpaceOperand, first: Scaling, repair: Repair) -> None:
        bodies = solid(P), solid(Q)
        self._P, self._Q = bodies
        self._where = f"{P.name} and {Q.name}"
        self._bits = significant_bits(repair.arithmetic) or 53
        self._trace = repair.trace
        self._repair = refusing(
            self._where,
            lambda: _core.PaperRepair(*bodies, first, repair.arithmetic, repair.readings),
        )

    def row(self, scaling: Scaling) -> tuple[Row, _core.Polyhedron]:
        """The surface has all facets as they are claimed, each by itself: it need not be closed."""
        return decided(lambda: refusing(self._where, lambda: self._row(scaling)))

    def _row(self, scaling: Scaling) -> tuple[Row, _core.Polyhedron]:
        did = dict(self._repair.update(scaling))
        start = time.perf_counter()
        claims = self._repair.facets()
        pairs = sorted({pair for _, ring in claims for pair in ring})
        number = {pair: k for k, pair in enumerate(pairs)}
        points = self._repair.coordinates(pairs)
        surface = _core.Polyhedron(points, [[number[pair] for pair in ring] for _, ring in claims])
        seconds = time.perf_counter() - start
        volume = str(surface.sextuple_volume() / 6)
        row: Row = {
            "scale": list(scaling),
            "volume": volume,
            "volume_approximate": in_double_range(volume),
            "vertices": len(pairs),
            "facets": len(claims),
            **{name: did[name] for name in COUNTS},
            "update_seconds": did["seconds"],
            "sum_seconds": seconds,
            "exact": self._beside_exact(scaling, claims),
            "trace": trace_of(did) if self._trace else None,
        }
        return row, surface

    def _beside_exact(
        self, scaling: Scaling, claims: list[tuple[str, list[tuple[int, int]]]]
    ) -> dict[str, Any]:
        same = self._repair.has_exact_pairs()
        found = None if same else compare_claims(self._P, self._Q, scaling, claims)
        if found is None or found.fault is None:
            off = largest_distance(self._P, self._Q, scaling, self._repair, self._bits)
            return {"same_facets": True, "ulps": in_double_range(str(off)), "fault": None,
                    "facet": None, "vertex": None}  # fmt: skip
        return {
            "same_facets": False,
            "ulps": None,
            "fault": found.fault,
            "facet": {"kind": found.kind, "ring": [list(pair) for pair in found.ring]},
            "vertex": None if found.vertex is None else list(found.vertex),
        }


def trace_of(did: dict[str, Any]) -> dict[str, Any]:
    return {
        "errors": [
            {
                **{name: error[name] for name in ("kind", "facet", "vertex", "end")},
                "steps": [
                    {"vertex": vertex, "witness": witness, "squared_degree": degree}
                    for vertex, witness, degree in error["steps"]
                ],
            }
            for error in did["errors"]
        ],
        "chains": [
            {
                "edge": list(chain["edge"]),
                "before": [list(edge) for edge in chain["before"]],
                "after": [list(edge) for edge in chain["after"]],
                "stuck": chain["stuck"],
            }
            for chain in did["chains"]
        ],
    }


def print_repair(value: dict[str, Any], rows: RowSpool) -> None:
    headings = ("scale", "fv", "vf", "ee", "steps", "chains", "no end", "stuck", "exact")
    table = plain_table(*headings, right=headings[:-1], whole=True)
    for row in rows.first(SHOWN):
        table.add_row(
            text_of((row["scale"][0], row["scale"][1], row["scale"][2])),
            *(f"{row[name]:,}" for name in COUNTS),
            in_words(row["exact"]),
        )
    summary = [
        ("sweep", f"{value['P']} + {value['Q']}, {counted(len(rows), 'scaling')}"),
        ("repair", f"literal, {value['arithmetic']}"),
        ("fv, vf, ee", "facets of P and Q whose vertex is not compatible, lost pairs of edges"),
        ("no end, stuck", "descents that never end, edges along which no compatible edge leads on"),
        ("seconds", f"{value['seconds']:.3f}"),
    ]
    print_sweep(table, rows, summary, value)
    for row in rows.first(SHOWN):
        sys.stdout.writelines(f"{line}\n" for line in _told(row))


def in_words(found: dict[str, Any]) -> str:
    """A comparison in words."""
    if found["same_facets"]:
        off = found["ulps"]
        if off is None:
            return "the same facets; how far off is beyond the range of doubles"
        return "the same facets" if off == 0 else f"the same facets, up to {off:.3g} ulp off"
    ring = ", ".join(_pair(pair) for pair in found["facet"]["ring"])
    kind = found["facet"]["kind"]
    if found["fault"] == "not-supporting":
        return f"{kind}-facet {ring}: {_pair(found['vertex'])} is above it"
    if found["fault"] == "overlapping":
        return f"{kind}-facet {ring} overlaps another"
    return f"facet {ring} is missing in part"


def _told(row: Row) -> Iterator[str]:
    """The trace, if there is one."""
    trace = row["trace"]
    if trace is None:
        return
    yield f"\nat {text_of((row['scale'][0], row['scale'][1], row['scale'][2]))}"
    for error in trace["errors"]:
        way = "".join(
            f", IC² {approximate(step['squared_degree']):.6g} to {step['witness']}"
            for step in error["steps"]
        )
        end = "no end" if error["end"] is None else f"compatible: {error['end']}"
        pair = f"facet {error['facet']}, vertex {error['vertex']}"
        yield f"  {error['kind']}-error: {pair}{way}; {end}"
    for chain in trace["chains"]:
        before, after = (
            " ".join(_edge(edge) for edge in chain[name]) or "none" for name in ("before", "after")
        )
        stuck = "; stuck" if chain["stuck"] else ""
        yield f"  edge {_edge(chain['edge'])} of P: {before}; now {after}{stuck}"


def _pair(pair: list[int]) -> str:
    return f"{pair[0]}+{pair[1]}"


def _edge(edge: list[int]) -> str:
    return f"{edge[0]}-{edge[1]}"
