"""The producer of certificates (docs/certificates.md). The producer is not trusted: the checker
is."""

from __future__ import annotations

import itertools
import json
from collections.abc import Sequence
from fractions import Fraction
from pathlib import Path
from typing import Any

from minkref import _core
from minkref.argument_types import expect_sets, number, two_exact
from minkref.certify.case_text import case_digest, case_text, places
from minkref.certify.claims_text import shown
from minkref.certify.plane.coincidence import coincidences
from minkref.certify.plane.inner_places import InnerPlaces
from minkref.certify.plane.moving_form import Figure, figure, moving_form
from minkref.certify.plane.point_apart import PointApart
from minkref.certify.plane.predicate import Place, Predicate, Vertices
from minkref.certify.simplest import simplest_between
from minkref.errors import Refusal, cut
from minkref.version import version

PIECES = (0, 1)  # the numbers of their steps
MOST_ATTEMPTS = 400
Number = str | int | Fraction


class NoProof(Exception):
    """A claim does not hold, or no certificate of it was found. `mend`: advice, None for the
    usual advice."""

    def __init__(self, problem: str, mend: str | None = None) -> None:
        super().__init__(problem)
        self.mend = mend


class Certificate:
    """Steps and claims about sP + Q. Scales are exact numbers: texts, ints, Fractions. Each method
    adds a claim with its proof, and returns the claim's number. Exact. Raises NoProof if a claim
    does not hold, and RuntimeError if the reference is wrong: then no proof exists."""

    def __init__(
        self, P: _core.PolygonSet, Q: _core.PolygonSet, axes: Sequence[Number] | None = None
    ) -> None:
        """Validates both operands; raises BadInput for an invalid operand. With `axes`, a factor
        above 0 for each axis, P is scaled by these first: all claims are about S P and Q."""
        expect_sets(P=P, Q=Q)
        for name, operand in (("P", P), ("Q", Q)):
            operand.validate(name)
        self._case = P
        self._axes = None if axes is None else [str(_exact("axes", factor)) for factor in axes]
        if self._axes is not None:
            P = P.scaled(",".join(self._axes))
        self.P, self.Q = P, Q
        self._prover = _core.Prover(P, Q)
        self._steps: list[str] = []
        self._vertices = Vertices(places(P), places(Q))
        self.claims: list[dict[str, Any]] = []
        self._figures: dict[int, Figure] = {}  # for sum and interval claims

    def __repr__(self) -> str:
        return shown(self, self.claims)

    def sum(self, scale: Number, passages: bool = False, complete: bool = False) -> int:
        """Claims the sum at a scale; with `passages` also its tight passages, each by a claim of
        its own, after the sum's. Contacts prove no passages if an operand is a point or a segment:
        then no such claims follow. With `complete`, a last claim says that there are no others;
        raises NoProof if an operand is a point, a segment or empty."""
        text = str(_exact("scale", scale))
        regions = all(o.is_region for o in (self.P, self.Q))
        if complete and not regions:
            raise NoProof(
                "passages are proven where both operands have an interior", "leave it out"
            )
        passages = (passages or complete) and regions
        step, here, found = self._prove(text, passages)
        at = self._step(step)
        claim = self._claim(
            "sum", scale=text, step=at, components=here.components, holes=here.holes,
            digest=here.digest,
        )  # fmt: skip
        self._figures[claim] = here
        listed = []
        for points, path in found:
            places = [list(point) for point in points]
            listed.append(self._claim("passage", scale=text, step=at, points=places, path=path))
        if complete:
            inner = self._inner(at, Fraction(text), [path for _, path in found])
            self._claim("passages", scale=text, step=at, passages=listed, inner=inner)
        return claim

    def _inner(self, at: int, scale: Fraction, paths: list[list[int]]) -> list[list[Any]]:
        steps = [self._steps[step] for step in (*self._pieces(), at)]
        inner = InnerPlaces(steps, self._vertices, scale).entries(paths)
        if inner is None:
            raise RuntimeError(f"a point inside the sum at {scale} is on no passage, and should be")
        return inner

    def interval(self, from_scale: Number, to_scale: Number) -> int:
        """Claims that the boundary has no event between two scales. Raises NoProof if it has."""
        a, b = _exact("from_scale", from_scale), _exact("to_scale", to_scale)
        step, at, moving = self._move(a, b)
        steps = [step]
        while at < b:
            here, event = at, NoProof(f"the boundary has an event at {at}")
            step, state, _ = self._prove(str(here), False)
            if state != moving.at(here):
                raise event
            steps.append(step)
            step, at, above = self._move(here, b)
            if above != moving:
                raise event
            steps.append(step)
        claim = self._claim(
            "interval", **{"from": str(a), "to": str(b)}, steps=[self._step(s) for s in steps],
            components=moving.components, holes=moving.holes, digest=moving.digest,
        )  # fmt: skip
        self._figures[claim] = moving
        return claim

    def event(
        self, scale: Number, from_scale: Number, kind: str | None = None, passages: bool = False
    ) -> int:
        """Claims a boundary or topology event at a scale: the sum below, no event between, the sum
        at the scale, perhaps with its tight passages, and the sum just above. Without `kind`, a
        topology event if components or holes change."""
        s = _exact("scale", scale)
        before = self.interval(from_scale, s)
        at = self.sum(s, passages)
        step, end, above = self._move(s, 2 * s)
        kind = self._kind(s, before, at, above, kind)
        after = self._claim(
            "interval", **{"from": str(s), "to": str(end)}, steps=[self._step(step)],
            components=above.components, holes=above.holes, digest=above.digest,
        )  # fmt: skip
        return self._claim("event", scale=str(s), kind=kind, before=before, at=at, after=after)

    def events(self, from_scale: Number, to_scale: Number) -> int:
        """Claims all boundary events between two scales, without events at these two: intervals
        from each event to the next, every event, and that the list is complete."""
        a, b = _exact("from_scale", from_scale), _exact("to_scale", to_scale)
        if not 0 < a < b:
            raise NoProof(f"no scales are between {a} and {b}", "give positive scales that ascend")
        rows = _core.DynamicSum(self.P, self.Q, str(a), str(b)).boundary_events()
        scales = sorted({Fraction(row[0]) for row in rows} - {a, b})
        try:
            return self._all_events([a, *scales, b])
        except NoProof as error:
            raise RuntimeError(f"the events between {a} and {b} are not these: {error}") from error

    def _all_events(self, stops: list[Fraction]) -> int:
        intervals, events = [self.interval(*stops[:2])], []
        for s, end in itertools.pairwise(stops[1:]):
            at = self.sum(s)
            intervals.append(self.interval(s, end))
            before, after = intervals[-2:]
            kind = self._kind(s, before, at, self._figures[after])
            found = self._claim("event", scale=str(s), kind=kind, before=before, at=at, after=after)
            events.append(found)
        figures = [self._figures[claim] for claim in intervals]
        return self._claim(
            "events", **{"from": str(stops[0]), "to": str(stops[-1])},
            intervals=intervals, events=events, scales=[str(s) for s in stops[1:-1]],
            kinds=[self.claims[event]["kind"] for event in events],
            components=[f.components for f in figures], holes=[f.holes for f in figures],
        )  # fmt: skip

    def _kind(
        self, s: Fraction, before: int, at: int, above: Figure, kind: str | None = None
    ) -> str:
        """The kind of the event at a scale. Raises NoProof if there is none."""
        below, here = self._figures[before], self._figures[at]
        counts = {(f.components, f.holes) for f in (below, here, above)}
        kind = kind or ("topology" if len(counts) > 1 else "boundary")
        if kind == "topology" and len(counts) == 1:
            raise NoProof(f"components and holes are the same below, at and above {s}")
        if kind == "boundary" and below == above and below.at(s) == here:
            since = self.claims[before]["from"]
            raise NoProof(f"the boundary has no event at {s}, nor between {since} and {s}")
        return kind

    def point(self, scale: Number, point: tuple[Number, Number]) -> int:
        """Claims that a point belongs to the sum."""
        s = _exact("scale", scale)
        x, y = map(str, two_exact("point", point))
        answer = _core.decide(self.P, self.Q, str(s), x, y)
        if answer["contact"] == "empty":
            raise NoProof(f"the point ({cut(x)}, {cut(y)}) is not in the sum at {s}")
        parts = [(Fraction(x), Fraction(y)) for x, y in (answer["p"], answer["q"])]
        by = self._pieces()
        pieces = [self._piece(step, part) for step, part in zip(by, parts, strict=True)]
        p, q = ([str(x) for x in part] for part in parts)
        return self._claim(
            "point", scale=str(s), point=[x, y], p=p, q=q, by=list(by), pieces=pieces
        )

    def outside(self, scale: Number, point: tuple[Number, Number]) -> int:
        """Claims a point outside the sum. Raises NoProof if the sum has it."""
        s = _exact("scale", scale)
        x, y = two_exact("point", point)
        by = self._pieces()
        apart = PointApart([self._steps[step] for step in by], self._vertices, s, (x, y))
        code = apart.code()
        if code is None:
            raise NoProof(f"the point ({cut(str(x))}, {cut(str(y))}) is in the sum at {s}")
        return self._claim(
            "outside", scale=str(s), point=[str(x), str(y)], by=list(by),
            normals=apart.normals(), code=code,
        )  # fmt: skip

    def sign(self, of: Predicate, from_scale: Number, to_scale: Number) -> int:
        """The sign of a predicate (predicate.py) at all scales between two, or at one."""
        a, b = Fraction(from_scale), Fraction(to_scale)
        sign = self._vertices.sign_between(of, a, b)
        if sign is None:
            raise NoProof(f"no one sign between {a} and {b} is seen in the coefficients")
        return self._claim("sign", of=of, **{"from": str(a), "to": str(b)}, sign=sign)

    def zero(self, of: Predicate, scale: Number) -> list[int]:
        """Claims that a predicate vanishes at a scale, and its signs just below and above; or, if
        the predicate vanishes at all scales, that it does from half to double this scale."""
        s = Fraction(scale)
        if self._vertices.value(of, s) != 0:
            raise NoProof(f"{of[0]} is not zero at {s}")
        if self._vertices.sign_between(of, s, s + 1) == 0:
            return [self.sign(of, s / 2, 2 * s)]
        return [self.sign(of, *ends) for ends in (self._beside(of, s, 0), (s, s),
                                                  self._beside(of, s, 2 * s))]  # fmt: skip

    def degeneracy(self, scale: Number) -> list[int]:
        """Claims the reasons why a scale is critical: for all edges of the convolution that start
        or stop meeting there, alone or three in a point, the predicate that vanishes at the scale,
        and its signs beside it."""
        found = coincidences(self.P, self.Q, self._vertices, _exact("scale", scale))
        if not found:
            raise NoProof(f"no edges of the convolution start or stop meeting at {scale}")
        return [claim for of in found for claim in self.zero(of, scale)]

    def text(self, case: Path | str, title: str = "", producer: str = "") -> str:
        """The certificate; `case`: the path to the case, relative to the certificate."""
        head = {
            "certificate": "certificate-v1" if self._axes is None else "axes-certificate-v1",
            "title": title,
            "producer": producer or f"minkref {version()}",
            "case": {"path": str(case), "sha256": case_digest(self._case, self.Q)},
            "axes": self._axes,
        }
        told = {name: value for name, value in head.items() if value}
        parts = [f'"{name}":{json.dumps(told[name], ensure_ascii=False)}' for name in told]
        parts.append(f'"steps":[{",".join(self._steps)}]')
        parts.append(f'"claims":{json.dumps(self.claims, separators=(",", ":"))}')
        return "{" + ",\n".join(parts) + "}\n"

    def case(self) -> str:
        """The text of the certified case."""
        return case_text(self._case, self.Q)

    def _prove(self, scale: str, passages: bool) -> tuple[str, Figure, list[Any]]:
        """Returns the step at a scale, the sum's figure, and its tight passages."""
        step, region, components, holes, found, touching = self._prover.prove(
            scale, self._prover.box(scale), self._pieces(), passages
        )
        return step, figure(region.canonical_json(), touching, components, holes), found

    def _pieces(self) -> tuple[int, int]:
        if not self._steps:
            self._steps += [self._prover.pieces("P"), self._prover.pieces("Q")]
        return PIECES

    def _piece(self, step: int, place: Place) -> int:
        """Finds the operand's piece that holds a point."""
        value = json.loads(self._steps[step])
        vertices = (self._vertices.P, self._vertices.Q)[step]
        for k, piece in enumerate(value["pieces"]):
            corners = [vertices[i] for i in piece]
            sides = zip(corners, corners[1:] + corners[:1], strict=True)
            if len(piece) < 3 or all(_turn(a, b, place) >= 0 for a, b in sides):
                return k  # a point or a segment is a piece itself
        raise RuntimeError("no piece of the operand has the point")

    def _beside(self, of: Predicate, s: Fraction, end: Fraction | int) -> tuple[Fraction, Fraction]:
        """Scales from s towards an end, in order, between which a predicate's sign is seen. Halving
        ends before the predicate's next root, unless the predicate vanishes everywhere."""
        other = Fraction(end)
        for _ in range(MOST_ATTEMPTS):
            other = simplest_between(*sorted(((s + other) / 2, (s + 3 * other) / 4)))
            low, high = sorted((s, other))
            if self._vertices.sign_between(of, low, high):
                return low, high
        raise NoProof(f"no sign of {of[0]} is seen beside the scale {cut(str(s))}")

    def _step(self, text: str) -> int:
        self._steps.append(text)
        return len(self._steps) - 1

    def _claim(self, claim: str, /, **members: Any) -> int:
        self.claims.append({"claim": claim, **members})
        return len(self.claims) - 1

    def _move(self, a: Fraction, b: Fraction) -> tuple[str, Fraction, Figure]:
        """A proof from a on, as far as it goes: the step, the end, and what moves."""
        box = self._prover.box(str(b))
        low = b
        for _ in range(MOST_ATTEMPTS):
            third = (low - a) / 3
            s = simplest_between(a + third, low - third)
            found = self._prover.prove_around(str(s), box, self._pieces(), str(a), str(b))
            if found is None:  # lines meet at this scale that do not at others
                low = s
                continue
            step, begin, end, polygons, components, holes, touching = found
            if Fraction(begin) == a:
                form = moving_form(polygons)
                return step, Fraction(end), figure(form, touching, components, holes)
            low = Fraction(begin)
        raise RuntimeError(f"there is no proof from {a} on")


def _exact(name: str, given: Number) -> Fraction:
    text = number(name, given)
    try:
        return Fraction(text)
    except (ValueError, ZeroDivisionError):
        mend = "write an integer, a decimal or a fraction, such as 7/5"
        raise Refusal(f"{cut(text)!r} is not a number", name, mend, "not-a-number") from None


def _turn(a: Place, b: Place, c: Place) -> Fraction:
    return (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0])
