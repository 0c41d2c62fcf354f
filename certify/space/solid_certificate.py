"""The producer of certificates for sums of polyhedra of any shape (docs/certificates-solids.md).
The producer is not trusted: the checker is."""

from __future__ import annotations

import json
from fractions import Fraction
from math import lcm
from typing import Any

from minkref import _core
from minkref.argument_types import three_exact
from minkref.certify.space.solid_pieces import Row, ScaledTiling
from minkref.certify.space.solid_planes import planes
from minkref.certify.space.solid_tree import TooLarge, Trees
from minkref.certify.space.tiled_solids import TiledSolids, too_large
from minkref.exact import digest

Scaling = Row  # a factor for each axis, n or n/d
MOST_ENTRIES = 200_000  # entries in one sum's trees


class SolidCertificate(TiledSolids):
    """Sums of two polyhedra of any shape, each with a proof and a claim. Exact. Claims the
    reference's sum."""

    form = "solid-certificate-v1"

    def __init__(self, P: _core.Polyhedron, Q: _core.Polyhedron) -> None:
        """Raises _core.BadInput where an operand is not valid, or has no volume; Refusal where the
        operands have too many convex pieces for a certificate."""
        super().__init__(P, Q)
        self._sums: list[dict[str, Any]] = []
        self._numbers: dict[Scaling, int] = {}  # claims' numbers

    def sum(self, scaling: Scaling) -> int:
        """Claims the sum at a scaling. Returns the claim's number: an earlier number if the scaling
        repeats. The cost grows with the sum's planes times the pairs of convex pieces that meet
        each. Raises Refusal if the proof has too many entries."""
        at = three_exact("scaling", scaling)
        if at in self._numbers:
            return self._numbers[at]
        found = _core.edge_sum_in_space(self.P, self.Q, at)
        self._sums.append({"scaling": at, "planes": self._planes(at)})
        convex = found.convex()
        components, cavities, tunnels = found.surface().topology()
        self.claims.append(
            {
                "claim": "sum",
                "sum": len(self._sums) - 1,
                "scaling": at,
                "planes": found.planes,
                "polygons": _polygons(found),
                "volume": found.volume(),
                "components": components,
                "cavities": cavities,
                "tunnels": tunnels,
                "digest": digest(convex.surface().canonical_json() if convex else
                                 found.canonical_json()),
            }
        )  # fmt: skip
        self._numbers[at] = len(self.claims) - 1
        return self._numbers[at]

    def _planes(self, at: Scaling) -> list[list[Any]]:
        P, Q = self._tilings
        common = lcm(*(Fraction(factor).denominator for factor in at))
        unit = lcm(P.unit(), Q.unit()) * common
        first, second = ScaledTiling(P, at, unit), ScaledTiling(Q, ("1", "1", "1"), unit)
        trees = Trees(first, second, unit, MOST_ENTRIES)
        try:
            return [
                [plane[0], str(Fraction(plane[1], unit)), trees.tree(plane, corners)]
                for plane, corners in planes(first, second).items()
            ]
        except TooLarge as error:
            raise too_large(f"the proof has more than {MOST_ENTRIES:,} entries") from error

    def _argument(self) -> dict[str, Any]:
        return {"sums": self._sums}


def _polygons(found: _core.PolyhedralSet) -> int:
    rows = json.loads(found.canonical_json())["planes"]
    return sum(len(row["region"]["polygons"]) for row in rows)
