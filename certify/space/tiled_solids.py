"""Two polyhedra as convex pieces: the shared parts of certificates about solids."""

from __future__ import annotations

import json
from typing import Any

from minkref import _core
from minkref.argument_types import expect_surfaces
from minkref.certify.claims_text import shown
from minkref.certify.space.solid_pieces import Tiling
from minkref.errors import Refusal
from minkref.exact import digest
from minkref.version import version

MOST_PAIRS = 1024  # pairs of pieces


class TiledSolids:
    """The operands, their pieces, the case, and the certificate's text. Exact."""

    form: str

    def __init__(self, P: _core.Polyhedron, Q: _core.Polyhedron) -> None:
        """Raises _core.BadInput where an operand is not valid, or has no volume; Refusal where the
        operands have too many convex pieces for a certificate."""
        expect_surfaces(P=P, Q=Q)
        self.P, self.Q = P, Q
        self._tilings = Tiling(P, "P"), Tiling(Q, "Q")
        self.claims: list[dict[str, Any]] = []
        pairs = len(self._tilings[0].rings) * len(self._tilings[1].rings)
        if pairs > MOST_PAIRS:
            what = f"the operands have {pairs:,} pairs of convex pieces, more than {MOST_PAIRS:,}"
            raise too_large(what)

    def __repr__(self) -> str:
        return shown(self, self.claims)

    def text(self, case: str, title: str = "", producer: str = "") -> str:
        """The certificate; `case`: the path to the case, relative to the certificate."""
        head = {
            "certificate": self.form,
            "title": title,
            "producer": producer or f"minkref {version()}",
            "case": {"path": case, "sha256": self.case_digest()},
        }
        told = {name: value for name, value in head.items() if value}
        P, Q = (tiling.value() for tiling in self._tilings)
        parts = [f'"{name}":{json.dumps(told[name], ensure_ascii=False)}' for name in told]
        parts.append(f'"proof":{_compact({"P": P, "Q": Q, **self._argument()})}')
        parts.append(f'"claims":{_compact(self.claims)}')
        return "{" + ",\n".join(parts) + "}\n"

    def case_digest(self) -> str:
        """SHA-256 of both operands; the certificate names the case with this digest."""
        return solid_case_digest(self.P, self.Q)

    def case(self) -> str:
        """The text of the certified case."""
        return f'{{"dimension":3,\n"P":{_plain(self.P)},\n"Q":{_plain(self.Q)}}}\n'

    def _argument(self) -> dict[str, Any]:
        """The proof's members beside the pieces."""
        return {}


def solid_case_digest(P: _core.Polyhedron, Q: _core.Polyhedron) -> str:
    """SHA-256 of both operands, as in certificates."""
    return digest(f'{{"P":{_plain(P)},"Q":{_plain(Q)}}}')


def too_large(what: str) -> Refusal:
    mend = "give operands with fewer reflex edges, or certify a sum of parts of them"
    return Refusal(what, "P and Q", mend, "too-large")


def _plain(surface: _core.Polyhedron) -> str:
    return _compact({"faces": surface.rings(), "vertices": surface.written_points()})


def _compact(value: Any) -> str:
    return json.dumps(value, separators=(",", ":"))
