"""The producer of certificates for sums of polyhedra of any shape (docs/certificates-solids.md).
The producer is not trusted: the checker is."""

from __future__ import annotations

import json
from fractions import Fraction
from math import lcm
from typing import Any

from minkref import _core
from minkref.argument_types import expect_surfaces
from minkref.certify.claims_text import shown
from minkref.certify.space.solid_pieces import Row, ScaledTiling, Tiling
from minkref.certify.space.solid_planes import planes
from minkref.certify.space.solid_tree import TooLarge, Trees
from minkref.errors import Refusal
from minkref.exact import digest
from minkref.version import version

Scaling = Row  # a factor for each axis, n or n/d
MOST_PAIRS = 1024  # pairs of pieces
MOST_ENTRIES = 200_000  # entries in one sum's trees


class SolidCertificate:
    """Sums of two polyhedra of any shape, each with a proof and a claim. Exact. Claims the
    reference's sum."""

    def __init__(self, P: _core.Polyhedron, Q: _core.Polyhedron) -> None:
        """Raises _core.BadInput where an operand is not valid, or has no volume; Refusal where the
        operands have too many convex pieces for a certificate."""
        expect_surfaces(P=P, Q=Q)
        self.P, self.Q = P, Q
        self._tilings = Tiling(P, "P"), Tiling(Q, "Q")
        self.claims: list[dict[str, Any]] = []
        self._sums: list[dict[str, Any]] = []
        self._numbers: dict[Scaling, int] = {}  # claims' numbers
        pairs = len(self._tilings[0].rings) * len(self._tilings[1].rings)
        if pairs > MOST_PAIRS:
            what = f"the operands have {pairs:,} pairs of convex pieces, more than {MOST_PAIRS:,}"
            raise _too_large(what)

    def __repr__(self) -> str:
        return shown(self, self.claims)

    def sum(self, scaling: Scaling) -> int:
        """Claims the sum at a scaling. Returns the claim's number: an earlier number if the scaling
        repeats. The cost grows with the sum's planes times the pairs of convex pieces that meet
        each. Raises Refusal if the proof has too many entries."""
        x, y, z = (str(Fraction(factor)) for factor in scaling)
        at = (x, y, z)
        if at in self._numbers:
            return self._numbers[at]
        found = _core.edge_sum_in_space(self.P, self.Q, at)
        self._sums.append({"scaling": at, "planes": self._planes(at)})
        convex = found.convex()
        self.claims.append(
            {
                "claim": "sum",
                "sum": len(self._sums) - 1,
                "scaling": at,
                "planes": found.planes,
                "polygons": _polygons(found),
                "volume": found.volume(),
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
            raise _too_large(f"the proof has more than {MOST_ENTRIES:,} entries") from error

    def text(self, case: str, title: str = "", producer: str = "") -> str:
        """The certificate; `case`: the path to the case, relative to the certificate."""
        head = {
            "certificate": "solid-certificate-v1",
            "title": title,
            "producer": producer or f"minkref {version()}",
            "case": {"path": case, "sha256": self.case_digest()},
        }
        told = {name: value for name, value in head.items() if value}
        P, Q = (tiling.value() for tiling in self._tilings)
        parts = [f'"{name}":{json.dumps(told[name], ensure_ascii=False)}' for name in told]
        parts.append(f'"proof":{_compact({"P": P, "Q": Q, "sums": self._sums})}')
        parts.append(f'"claims":{_compact(self.claims)}')
        return "{" + ",\n".join(parts) + "}\n"

    def case_digest(self) -> str:
        """The digest of both operands, by which the certificate names the case."""
        return digest(f'{{"P":{_plain(self.P)},"Q":{_plain(self.Q)}}}')

    def case(self) -> str:
        """The text of the certified case."""
        return f'{{"dimension":3,\n"P":{_plain(self.P)},\n"Q":{_plain(self.Q)}}}\n'


def _polygons(found: _core.PolyhedralSet) -> int:
    rows = json.loads(found.canonical_json())["planes"]
    return sum(len(row["region"]["polygons"]) for row in rows)


def _plain(surface: _core.Polyhedron) -> str:
    return _compact({"faces": surface.rings(), "vertices": surface.written_points()})


def _too_large(what: str) -> Refusal:
    mend = "give operands with fewer reflex edges, or certify a sum of parts of them"
    return Refusal(what, "P and Q", mend, "too-large")


def _compact(value: Any) -> str:
    return json.dumps(value, separators=(",", ":"))
