"""Produces certificates of sums with a disc (docs/certificates-disc.md). Only checkers are
trusted."""

from __future__ import annotations

import json
from decimal import localcontext
from fractions import Fraction
from typing import Any

from minkref import _core
from minkref.argument_types import two_exact
from minkref.certify.case_text import disc_head
from minkref.certify.claims_text import shown
from minkref.certify.disc.boundary_rings import components
from minkref.certify.disc.curve_walk import CurveWalk, Joints, Key
from minkref.certify.disc.fineness import Fineness
from minkref.certify.disc.joint_places import decimal
from minkref.certify.disc.near_edge import NearEdge, boxes_within
from minkref.certify.disc.offset_curve import OffsetCurve
from minkref.certify.disc.region_edges import (
    RegionEdges,
    squared_distance,
    winds,
    with_touching_vertices,
)
from minkref.certify.plane.certificate import NoProof
from minkref.exact import digest

FORM = "disc-sum-certificate-v1"


class DiscSumCertificate:
    """Claims about P + a disc: the sum, and where points are. Exact answers come from the
    reference; decimals of many digits find what blocks each curve. O(n m) for m edges near an
    edge."""

    def __init__(self, P: _core.PolygonSet, square: Fraction) -> None:
        """Validates P. Vertices inside an edge of another ring become vertices of both. Raises
        NoProof for a point, a segment, lines and the empty set."""
        P.validate("P")
        if not P.is_region or not P.rings():
            raise NoProof("only sums of regions with a disc are certified", "give polygons")
        self.P, self.square = with_touching_vertices(P), square
        self.claims: list[dict[str, Any]] = []
        self._set = RegionEdges(self.P)

    def __repr__(self) -> str:
        return shown(self, self.claims)

    def sum(self, known: tuple[int, str] | None = None) -> None:
        """Claims the sum with its components, holes and digest. `known`: its holes and canonical
        form. Raises NoProof where numbers are too long, or the boundary too fine for decimals."""
        coordinates = (c for edge in self._set.edges.values() for c in edge[0])
        fineness = Fineness.of(coordinates, self.square)
        if known is None:
            found = _core.offset(self.P, str(self.square))
            known = found.holes, found.canonical_json()
        try:
            with localcontext() as context:
                context.prec = fineness.digits
                claim = self._walked(fineness)
        except ArithmeticError as error:  # of decimals, as where two places have the same digits
            raise NoProof("places of the boundary are too near to each other") from error
        claim |= {"holes": known[0], "digest": digest(known[1])}
        self.claims.append(claim)

    def point(self, at: tuple[str, str]) -> None:
        """Claims whether a point is nearer to P than the radius (-1), at it (0) or farther (1)."""
        p, edges = two_exact("at", at), list(self._set.edges.values())
        far = min(squared_distance(p, edge) for edge in edges)
        side = (far > self.square) - (far < self.square)
        if far > 0 and winds(p, edges) > 0:
            side = -1
        self.claims.append({"claim": "point", "point": [str(c) for c in p], "distance": side})

    def _walked(self, fineness: Fineness) -> dict[str, Any]:
        """Walks all curves and joins their free parts to rings."""
        own = self._set
        arcs = [n for n, m in own.before.items() if own.turn(m, n) > 0]
        after = {m: n for n, m in own.before.items()}
        radius = decimal(self.square).sqrt()
        joints, root, join = Joints(radius * fineness.grid), *own.classes()
        edges = {n: NearEdge.of(edge) for n, edge in own.edges.items()}
        near = boxes_within(edges, 2 * radius)
        walks: list[list[CurveWalk]] = []
        for numbers in (list(edges), arcs):
            walks.append([])
            is_arc = len(walks) == 2
            for n in numbers:
                edge, last = own.edges[n], after[n]
                before = edges[own.before[n]] if is_arc else None
                curve = OffsetCurve(n, edges[n], self.square, fineness.same, before)
                tips = edge[:1] if is_arc else edge
                heights = {f: curve.height(edges[f]) for f in near[n] if f != n}
                for f in sorted(heights, key=lambda f: -heights[f]):  # the likeliest to cover it
                    if curve.is_covered and root(f) == root(n):
                        continue
                    if curve.look_at(f, edges[f], tips):
                        join(n, f)
                keys: tuple[Key, Key] = (n, False), (last, last in arcs)
                if is_arc:
                    keys = (n, True), (n, False)
                walks[-1].append(CurveWalk(curve, joints, keys))
        pieces = [piece for walk in (*walks[0], *walks[1]) for piece in walk.pieces]
        return {
            "claim": "sum",
            "joints": [place.entry() for place in joints.places],
            "edges": [walk.entries for walk in walks[0]],
            "arcs": [walk.entries for walk in walks[1]],
            "components": components(pieces, root, fineness.same),
        }

    def case(self) -> str:
        """The case file's text."""
        return f'{{"P":{self.P.to_json()}}}\n'

    def text(self, case: str, title: str = "", producer: str = "") -> str:
        """The certificate; `case`: its case file's relative path."""
        head = disc_head(FORM, self.P, self.square, case, title, producer)
        claims = ",\n".join(_claim_text(claim) for claim in self.claims)
        return json.dumps(head)[:-1] + f', "claims": [\n{claims}\n]}}\n'


def _claim_text(claim: dict[str, Any]) -> str:
    """A line for each joint and each curve."""
    rows = [
        f'"{name}": [\n{",".join(map(_row, value))[1:]}]' if name in ("joints", "edges", "arcs")
        else f'"{name}": {json.dumps(value)}'
        for name, value in claim.items()
    ]  # fmt: skip
    return "{" + ",\n".join(rows) + "}"


def _row(value: object) -> str:
    return "\n" + json.dumps(value)
