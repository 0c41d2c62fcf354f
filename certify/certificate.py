"""The producer of certificates (docs/certificates.md). It is not trusted: the checker is."""

from __future__ import annotations

import json
from fractions import Fraction
from pathlib import Path
from typing import Any

from minkref import _core
from minkref.certify.case_text import case_digest, case_text
from minkref.certify.moving_form import form_at, moving_form
from minkref.certify.simplest import simplest_between
from minkref.exact import digest
from minkref.version import version

PIECES = (0, 1)  # the numbers of their steps
MOST_ATTEMPTS = 400


class NoProof(Exception):
    """What is to be claimed does not hold."""


class Certificate:
    """Steps and claims about sP + Q. Scales are texts, n or n/d, or fractions. Each method adds
    what it says, with its proof, and returns the number of the claim. Exact. Raises NoProof where
    a claim does not hold, and RuntimeError where the reference is wrong: there is no proof then."""

    def __init__(self, P: _core.PolygonSet, Q: _core.PolygonSet) -> None:
        self.P, self.Q = P, Q
        self._prover = _core.Prover(P, Q)
        self._steps = [self._prover.pieces("P"), self._prover.pieces("Q")]
        self.claims: list[dict[str, Any]] = []

    def sum(self, scale: str | Fraction, passages: bool = False) -> int:
        """The sum at a scale; with its tight passages, each a claim of its own, after it."""
        text = str(Fraction(scale))
        step, region, components, holes, found = self._prover.prove(
            text, self._prover.box(text), PIECES, passages
        )
        number = self._step(step)
        claim = self._claim(
            "sum", scale=text, step=number, components=components, holes=holes,
            digest=digest(region.canonical_json()),
        )  # fmt: skip
        for points, path in found:
            places = [list(point) for point in points]
            self._claim("passage", scale=text, step=number, points=places, path=path)
        return claim

    def interval(self, from_scale: str | Fraction, to_scale: str | Fraction) -> int:
        """That the boundary has no event between two scales. Raises NoProof if it has."""
        a, b = Fraction(from_scale), Fraction(to_scale)
        steps: list[int] = []
        at, first = a, ""
        while at < b:
            if steps:
                step, *_ = self._prover.prove(str(at), self._prover.box(str(at)), PIECES, False)
                steps.append(self._step(step))
            step, at, form, components, holes = self._move(at, b)
            steps.append(self._step(step))
            if len(steps) > 1 and form != first:
                raise NoProof(f"the boundary has an event between {a} and {b}")
            first = form
        return self._claim(
            "interval", **{"from": str(a), "to": str(b)}, steps=steps, components=components,
            holes=holes, digest=digest(first),
        )  # fmt: skip

    def event(self, scale: str | Fraction, kind: str, from_scale: str | Fraction) -> int:
        """A boundary or topology event at a scale: what is below, none in between, what is at it,
        and what is just above."""
        s = Fraction(scale)
        before = self.interval(from_scale, s)
        at = self.sum(s)
        step, end, form, components, holes = self._move(s, 2 * s)
        if kind == "boundary" and (holds := self.claims[before])["digest"] == digest(form):
            if self._is_at(form, s, at):
                raise NoProof(f"the boundary has no event at {s}, and none after {holds['from']}")
        after = self._claim(
            "interval", **{"from": str(s), "to": str(end)}, steps=[self._step(step)],
            components=components, holes=holes, digest=digest(form),
        )  # fmt: skip
        return self._claim("event", scale=str(s), kind=kind, before=before, at=at, after=after)

    def text(self, case: Path | str, title: str = "") -> str:
        """The certificate; `case`: the path of its case, relative to its own."""
        head = {
            "certificate": "certificate-v1",
            "title": title,
            "producer": f"minkref {version()}",
            "case": {"path": str(case), "sha256": case_digest(self.P, self.Q)},
        }
        parts = [f"{json.dumps(name)}:{json.dumps(value)}" for name, value in head.items() if value]
        parts.append(f'"steps":[{",".join(self._steps)}]')
        parts.append(f'"claims":{json.dumps(self.claims, separators=(",", ":"))}')
        return "{" + ",\n".join(parts) + "}\n"

    def case(self) -> str:
        """The text of the case that is certified."""
        return case_text(self.P, self.Q)

    def _is_at(self, form: str, s: Fraction, claim: int) -> bool:
        """Whether a moving form at a scale is the sum that a claim has there."""
        wanted: str = self.claims[claim]["digest"]
        return digest(form_at(form, s)) == wanted

    def _step(self, text: str) -> int:
        self._steps.append(text)
        return len(self._steps) - 1

    def _claim(self, claim: str, /, **members: Any) -> int:
        self.claims.append({"claim": claim, **members})
        return len(self.claims) - 1

    def _move(self, a: Fraction, b: Fraction) -> tuple[str, Fraction, str, int, int]:
        """A proof from a on, as far as it goes: the step, the end, the form, components, holes."""
        box = self._prover.box(str(b))
        low = b
        for _ in range(MOST_ATTEMPTS):
            third = (low - a) / 3
            s = simplest_between(a + third, low - third)
            found = self._prover.prove_around(str(s), box, PIECES, str(a), str(b))
            if found is None:  # lines meet at this scale that do not at others
                low = s
                continue
            step, begin, end, polygons, components, holes = found
            if Fraction(begin) == a:
                form = json.dumps(moving_form(polygons), sort_keys=True, separators=(",", ":"))
                return step, Fraction(end), form, components, holes
            low = Fraction(begin)
        raise RuntimeError(f"there is no proof from {a} on")
