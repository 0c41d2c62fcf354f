"""Certificate claims before routes that know nothing of proofs: the slow engine, and real roots
counted by computer algebra."""

from __future__ import annotations

import json
from fractions import Fraction
from typing import Any

import sympy
from minkref.certify.plane.moving_form import moving_form
from minkref.exact import digest
from minkref.oracle import slow

SAMPLES = 3  # scales examined per interval
Claim = dict[str, Any]


class Confirmation:
    """Confirms the claims about one case, each different claim once."""

    def __init__(self, case_text: str) -> None:
        value = json.loads(case_text)
        self.P, self.Q = (slow.operand_from_json(value[name]) for name in "PQ")
        self.vertices = [
            [(Fraction(x), Fraction(y)) for polygon in value[name]["polygons"]
             for ring in (polygon["outer"], *polygon.get("holes", [])) for x, y in ring]
            for name in "PQ"
        ]  # fmt: skip
        self._known: dict[str, bool] = {}

    def all_hold(self, claims: list[Claim]) -> bool:
        return all(self.holds(claim, claims) for claim in claims)

    def holds(self, claim: Claim, claims: list[Claim]) -> bool:
        """Whether a claim is true; claims that it refers to count only through its own
        statement."""
        if claim["claim"] == "event":
            claim = {**claim, "before": claims[claim["before"]], "after": claims[claim["after"]]}
        said = {name: claim[name] for name in claim if name not in ("step", "steps", "path", "at")}
        key = json.dumps(said, sort_keys=True)
        if key not in self._known:
            self._known[key] = bool(getattr(self, f"_{claim['claim']}")(said))
        return self._known[key]

    def _sum(self, claim: Claim) -> bool:
        found = slow.minkowski_sum(self.P, self.Q, Fraction(claim["scale"]))
        ours = found.digest, found.components, found.holes
        same = ours == (claim["digest"], claim["components"], claim["holes"])
        return same and "polygons" not in claim

    def _interval(self, claim: Claim) -> bool:
        """At some scales inside the boundary has no event, and this moving form."""
        a, b = Fraction(claim["from"]), Fraction(claim["to"])
        for i in range(1, SAMPLES + 1):
            s = a + (b - a) * i / (SAMPLES + 1)
            found = slow.topology(self.P, self.Q, s)
            counts = len(found.at.interior), len(found.at.complement)
            form = _form(found.above, s)
            if found.boundary_changes or counts != (claim["components"], claim["holes"]):
                return False
            if digest(form) != claim["digest"]:
                return False
        return a < b

    def _event(self, claim: Claim) -> bool:
        s = Fraction(claim["scale"])
        found = slow.topology(self.P, self.Q, s)
        ends = claim["before"]["to"], claim["after"]["from"]
        if any(Fraction(end) != s for end in ends):
            return False
        counts = {
            (len(x.interior), len(x.complement)) for x in (found.below, found.at, found.above)
        }
        return len(counts) > 1 if claim["kind"] == "topology" else found.boundary_changes

    def _passage(self, claim: Claim) -> bool:
        """Whether the points form a part of a piece from the slow engine."""
        points = [(Fraction(x), Fraction(y)) for x, y in claim["points"]]
        pieces = slow.minkowski_sum(self.P, self.Q, Fraction(claim["scale"])).tight
        runs = [run for piece in pieces for run in (list(piece), list(piece)[::-1])]
        n = len(points)
        return any(run[i : i + n] == points for run in runs for i in range(len(run) - n + 1))

    def _point(self, claim: Claim) -> bool:
        x, y = map(Fraction, claim["point"])
        return slow.witness(self.P, self.Q, Fraction(claim["scale"]), (x, y)).contact != "disjoint"

    def _outside(self, claim: Claim) -> bool:
        return not self._point(claim)

    def _sign(self, claim: Claim) -> bool:
        """The sign at one scale; or no real root between two, and the sign in the middle."""
        s = sympy.symbols("s")
        name, entries = claim["of"]
        points = entries if name == "orientation" else [point for line in entries for point in line]
        rows = [self._row(point, s) for point in points]
        if name == "concurrent":
            rows = [list(sympy.Matrix(rows[i]).cross(sympy.Matrix(rows[i + 1]))) for i in (0, 2, 4)]
        value = sympy.Poly(sympy.expand(sympy.Matrix(rows).det()), s)
        a, b = (sympy.Rational(claim[name]) for name in ("from", "to"))
        middle = sympy.sign(value.eval((a + b) / 2))
        if a == b or value.is_zero:
            return bool(middle == claim["sign"])
        inside = value.count_roots(a, b) - sum(value.eval(end) == 0 for end in (a, b))
        return bool(claim["sign"] != 0 and middle == claim["sign"] and inside == 0)

    def _row(self, point: list[int | None], s: Any) -> list[Any]:
        total = [sympy.Integer(0), sympy.Integer(0)]
        for i, vertices, factor in zip(point, self.vertices, (s, 1), strict=True):
            if i is not None:
                place = [sympy.Rational(c.numerator, c.denominator) for c in vertices[i]]
                total = [x + factor * c for x, c in zip(total, place, strict=True)]
        return [*total, sympy.Integer(1)]


def _form(state: Any, s: Fraction) -> str:
    return moving_form(
        [
            [[[_text(t, s, 0), _text(t, s, 1), _text(u, s, 0), _text(u, s, 1)] for t, u in ring]
             for ring in part]
            for part in state.rings
        ]
    )  # fmt: skip


def _text(track: Any, s: Fraction, part: int) -> str:
    """x0 or x1 of the coordinate x0 + s x1."""
    slope = Fraction(track.slope)
    return str(slope if part else Fraction(track.value) - s * slope)
