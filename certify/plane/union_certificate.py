"""The producer of certificates for unions (docs/certificates-unions.md). The producer is not
trusted: the checker is."""

from __future__ import annotations

import json
from collections.abc import Sequence
from fractions import Fraction
from functools import cached_property
from typing import Any

from minkref import _core
from minkref.argument_types import two_exact
from minkref.certify.case_text import plain_polygons
from minkref.certify.plane.union_degeneracies import Edges
from minkref.errors import Refusal
from minkref.exact import digest
from minkref.version import version

SIGNS = 8  # of predicates that doubles get wrong


class UnionCertificate:
    """Claims about sets in the plane and their union, each made once. Exact."""

    def __init__(self, sets: Sequence[_core.PolygonSet]) -> None:
        """Validates the sets; raises BadInput for an invalid set, Refusal for a point or a segment,
        which certificates do not take."""
        for k, one in enumerate(sets):
            one.validate(f"set {k}")
            if one.rings() and not one.is_region:
                mend = "leave it out, or give a polygon"
                raise Refusal("a point or a segment has no interior", f"set {k}", mend)
        self.sets = list(sets)
        self.claims: list[dict[str, Any]] = []

    def union(self, region: _core.PolygonSet | None = None) -> None:
        """Claims the union; `region`: a result to claim instead of the reference's."""
        found = _core.combined("union", self.sets)[0] if region is None else region
        self._claim("union", polygons=plain_polygons(found))

    def point(self, point: Sequence[str | int | Fraction]) -> None:
        """Claims which sets have a point inside, and which edges pass."""
        x, y = two_exact("point", point)
        at = str(x), str(y)
        origin = _core.PolygonSet.from_json('{"polygons":[{"outer":[["0","0"]],"holes":[]}]}')
        told: dict[str, list[int]] = {"overlapping": [], "touching": [], "empty": []}
        for k, one in enumerate(self.sets):
            contact = "empty" if not one.rings() else _core.decide(one, origin, "1", *at)["contact"]
            told[contact].append(k)
        self._claim("point", point=list(at), inside=told["overlapping"], on=told["touching"])

    def degeneracies(self) -> None:
        """Claims all degenerate points, and each edge's overlap with a later edge. O(n^2) for n
        edges."""
        for point, meeting in self._edges.meetings().items():
            vertices, edges = sorted(meeting.vertices), sorted(meeting.edges)
            self._claim("meet", point=self._edges.told(point), vertices=vertices, edges=edges)
        for one, other, way in self._edges.overlaps():
            self._claim("overlap", edges=[one.name, other.name], way=way)

    def signs(self, most: int = SIGNS) -> None:
        """Claims at most so many signs that doubles get wrong, zeros last. O(n^2) for n edges."""
        found = sorted(self._edges.wrong_in_doubles(), key=lambda one: one[2] == 0)
        for edge, other, sign in found[:most]:
            ends = [edge.name, (edge.name[0], edge.end), other.name]
            self._claim("sign", of=["orientation", ends], sign=sign)

    def text(self, case: str, title: str = "", producer: str = "") -> str:
        """The certificate; `case`: the path to the case, relative to the certificate."""
        head = {
            "certificate": "union-certificate-v1",
            "title": title,
            "producer": producer or f"minkref {version()}",
            "case": {"path": case, "sha256": self.case_digest()},
        }
        parts = [f'"{name}":{_compact(value)}' for name, value in head.items() if value]
        claims = ",\n".join(map(_compact, self.claims))
        return "{" + ",\n".join([*parts, f'"claims":[{claims}]']) + "}\n"

    def case(self) -> str:
        """The text of the certified case, union-case-v1."""
        head = f'"schema":"union-case-v1","id":"{self.case_digest()[:12]}"'
        sets = ",\n".join(one.to_json() for one in self.sets)
        return f'{{{head},\n"sets":[{sets}]}}\n'

    def case_digest(self) -> str:
        """The digest by which certificates name cases."""
        value = {"sets": list(map(plain_polygons, self.sets))}
        return digest(json.dumps(value, sort_keys=True, separators=(",", ":")))

    @cached_property
    def _edges(self) -> Edges:
        return Edges(self.sets)

    def _claim(self, claim: str, **members: Any) -> None:
        self.claims.append({"claim": claim, **members})


def _compact(value: Any) -> str:
    return json.dumps(value, separators=(",", ":"), ensure_ascii=False)
