"""Certificate claims about sums in space, before the slow engine, which knows nothing of proofs and
shares nothing with their producer or checker. Components, cavities and tunnels are those of the
reference, which counts them without the checkers."""

from __future__ import annotations

import json
from dataclasses import dataclass
from fractions import Fraction
from typing import Any

from minkref import _core
from minkref.exact import digest
from minkref.fuzz.space.hull import convex_hull
from minkref.oracle.slow.space.exposed import Exposed, lifted, rings_of
from minkref.oracle.slow.space.solid import height, solid_from_json
from minkref.oracle.slow.space.solid_sum import SolidSum
from minkref.oracle.slow.space.solid_whole import whole_sum

Numbers = tuple[int, int, int]  # of components, cavities, tunnels


@dataclass(frozen=True)
class SolidFacts:
    """The facts that a claim states about a sum."""

    planes: int
    polygons: int
    volume: Fraction
    digest: str


class SolidConfirmation:
    """Confirms the claims about one case; each scaling is asked for once. For a few dozen pairs of
    convex pieces."""

    def __init__(self, case: Any) -> None:
        self.P, self.Q = (solid_from_json(case[name]) for name in "PQ")
        self._given = [_polyhedron(case[name]) for name in "PQ"]
        self._known: dict[tuple[Fraction, ...], SolidFacts] = {}
        self._numbers: dict[tuple[Fraction, ...], Numbers] = {}

    def all_hold(self, claims: list[Any]) -> bool:
        return all(self.holds(claim) for claim in claims)

    def holds(self, claim: Any) -> bool:
        said = SolidFacts(
            claim["planes"], claim["polygons"], Fraction(claim["volume"]), claim["digest"]
        )
        numbers = tuple(claim.get(name) for name in ("components", "cavities", "tunnels"))
        claimed = any(number is not None for number in numbers)
        as_many = not claimed or numbers == self.numbers(claim["scaling"])
        return as_many and said == self.facts(claim["scaling"])

    def numbers(self, scaling: Any) -> Numbers:
        x, y, z = map(Fraction, scaling)
        if (x, y, z) not in self._numbers:
            P, Q = self._given
            found = _core.edge_sum_in_space(P, Q, (str(x), str(y), str(z)))
            self._numbers[x, y, z] = found.surface().topology()
        return self._numbers[x, y, z]

    def facts(self, scaling: Any) -> SolidFacts:
        x, y, z = map(Fraction, scaling)
        if (x, y, z) not in self._known:
            found = whole_sum(SolidSum(self.P, self.Q, (x, y, z)))
            polygons = sum(map(len, found.planes.values()))
            text = canonical_text(found)
            facts = SolidFacts(len(found.planes), polygons, found.volume(), digest(text))
            self._known[x, y, z] = facts
        return self._known[x, y, z]


def _polyhedron(value: Any) -> _core.Polyhedron:
    points = [tuple(str(Fraction(c)) for c in vertex) for vertex in value["vertices"]]
    return _core.Polyhedron(points, value["faces"])


def canonical_text(found: Exposed) -> str:
    """Writes a sum in canonical form; a convex sum as a polyhedron."""
    corners = {
        lifted(point, plane)
        for plane, polygons in found.planes.items()
        for ring in rings_of(polygons)
        for point in ring
    }
    for normal, offset in found.planes:
        if any(height(normal, corner) > offset for corner in corners):
            return found.text()
    return json.dumps(convex_hull(corners).document(), sort_keys=True, separators=(",", ":"))
