"""Certificate claims before routes that know nothing of proofs: the slow engine, and real roots
counted by computer algebra."""

from __future__ import annotations

import itertools
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
        if claim["claim"] == "passages":
            points = [claims[passage].get("points") for passage in claim["passages"]]
            claim = {"claim": "passages", "scale": claim["scale"], "points": points}
        if claim["claim"] == "events":
            claim = {name: claim[name] for name in claim if name not in ("intervals", "events")}
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
        return len(_counts(found)) > 1 if claim["kind"] == "topology" else found.boundary_changes

    def _events(self, claim: Claim) -> bool:
        """Whether these are events of these kinds, and the scales examined between two show one
        moving form, no event, and these counts."""
        listed = [Fraction(s) for s in claim["scales"]]
        stops = [Fraction(claim["from"]), *listed, Fraction(claim["to"])]
        found = [slow.topology(self.P, self.Q, s) for s in listed]
        if not all(at.boundary_changes for at in found):
            return False
        kinds = ["topology" if len(_counts(at)) > 1 else "boundary" for at in found]
        between: list[tuple[int, int]] = []
        for low, high in itertools.pairwise(stops):
            scales = [low + (high - low) * i / (SAMPLES + 1) for i in range(1, SAMPLES + 1)]
            states = [(s, slow.topology(self.P, self.Q, s)) for s in scales]
            forms = {_form(state.above, s) for s, state in states}
            counts = {count for _, state in states for count in _counts(state)}
            changes = any(state.boundary_changes for _, state in states)
            if low >= high or changes or len(forms) + len(counts) != 2:
                return False
            between += counts
        rows = [*zip(claim["components"], claim["holes"], strict=True)]
        return kinds == claim["kinds"] and between == rows

    def _passage(self, claim: Claim) -> bool:
        """Whether the points form a part of a piece from the slow engine."""
        points = [(Fraction(x), Fraction(y)) for x, y in claim["points"]]
        pieces = slow.minkowski_sum(self.P, self.Q, Fraction(claim["scale"])).tight
        runs = [run for piece in pieces for run in (list(piece), list(piece)[::-1])]
        n = len(points)
        return any(run[i : i + n] == points for run in runs for i in range(len(run) - n + 1))

    def _passages(self, claim: Claim) -> bool:
        """Whether each piece from the slow engine is made of these segments and points."""
        paths = [[(Fraction(x), Fraction(y)) for x, y in points] for points in claim["points"]]
        pieces = slow.minkowski_sum(self.P, self.Q, Fraction(claim["scale"])).tight
        return _steps(paths) >= _steps([list(piece) for piece in pieces])

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


def _steps(paths: list[list[tuple[Fraction, Fraction]]]) -> set[Any]:
    """Points and segments of paths, without points where they go straight on."""
    steps: set[Any] = {frozenset(path) for path in paths if len(path) == 1}
    for path in paths:
        corners = path[:1]
        for a, b, c in zip(path, path[1:], path[2:], strict=False):
            if (b[0] - a[0]) * (c[1] - b[1]) != (b[1] - a[1]) * (c[0] - b[0]):
                corners.append(b)
        corners += path[-1:]
        steps |= {frozenset(side) for side in itertools.pairwise(corners)}
    return steps


def _counts(found: slow.Topology) -> set[tuple[int, int]]:
    """Components and holes below, at and above a scale."""
    return {(len(x.interior), len(x.complement)) for x in (found.below, found.at, found.above)}


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
