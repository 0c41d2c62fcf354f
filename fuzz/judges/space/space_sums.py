"""Compares all results on one sum in space: the reference's routes, CGAL's Nef polyhedra, cells,
and the slow engine, which decides by a point."""

from __future__ import annotations

import json
import random
from collections import Counter
from dataclasses import dataclass, field
from functools import cached_property

from minkref import _core
from minkref.fuzz.geometry.polyhedron import Polyhedron
from minkref.fuzz.geometry.space import Point
from minkref.fuzz.judges.space.space_nef import NefJudge
from minkref.fuzz.judges.space.space_routes import Route
from minkref.fuzz.space.general_pairs import GeneralPair
from minkref.fuzz.space.meeting import decide
from minkref.fuzz.space.thin_meeting import ThinMeeting
from minkref.fuzz.space.witness import holds
from minkref.fuzz.verdicts.verdict import Witness
from minkref.oracle.slow import (
    CellSum,
    Exposed,
    Solid,
    SolidSum,
    exposed_from_json,
    open_lines,
    solid_faults,
    solid_from_json,
    uniform,
    whole_sum,
)
from minkref.oracle.slow.space.solid_claim import place_of, told_apart, winding

REFUSALS = (_core.BadInput, _core.LimitExceeded, RuntimeError, ValueError)
MOST_PAIRS = 6  # most pairs of convex pieces for a whole sum by the slow engine
Matrix = tuple[tuple[int, int, int], tuple[int, int, int], tuple[int, int, int]]


@dataclass
class SpaceSums:
    """The answers on one pair, by author. `compared` counts comparisons by both sides, `messages`
    are disagreements, each with a witness."""

    pair: GeneralPair
    answers: dict[str, str] = field(default_factory=dict)
    compared: Counter[str] = field(default_factory=Counter)
    messages: list[str] = field(default_factory=list)

    @cached_property
    def truth(self) -> SolidSum:
        pair = self.pair
        return SolidSum(_solid(pair.P), _solid(pair.Q), uniform(pair.scale))

    @cached_property
    def dice(self) -> random.Random:
        return random.Random(f"minkref points {self.pair.name}")

    def ask(self, routes: dict[str, Route], nef: NefJudge) -> None:
        """Asks everyone who knows an answer. A route's refusal is a disagreement."""
        pair = self.pair
        for name, route in routes.items():
            try:
                self.answers[name] = route(pair.P, pair.Q, pair.scale)
            except REFUSALS as error:  # the pair is valid
                self.say(f"route {name} gives no sum: {type(error).__name__}: {error}")
        if pair.cells:
            cells = CellSum(pair.cells.P, pair.cells.Q, pair.scale, pair.cells.matrix)
            self.answers["cells"] = cells.exposed().text()
        if not (pair.P.is_thin or pair.Q.is_thin):
            text = nef.sum(pair.P.scaled(pair.scale), pair.Q)
            if text is not None:
                self.answers["nef"] = text
        if len(self.truth.pairs) <= MOST_PAIRS:
            self.answers["slow engine"] = whole_sum(self.truth).text()

    def compare(self, points: int) -> None:
        """All answers with the first, as text; the first, and each that differs, with the points
        of the slow engine: of faces, of space, and beside planes."""
        texts = dict.fromkeys(self.answers.values())
        first = next(iter(self.answers), "")
        for name, text in self.answers.items():
            if name != first:
                self.compared[name] += 1
                if text != self.answers[first]:
                    self.say(f"{first} and {name} differ{self._apart(self.answers[first], text)}")
        for text in texts:
            names = " and ".join(name for name, other in self.answers.items() if other == text)
            self._against_points(names, exposed_from_json(json.loads(text)), text, points)

    def _against_points(self, names: str, claim: Exposed, text: str, points: int) -> None:
        self.compared["points"] += points
        lines = open_lines(claim)
        if lines:
            self.say(f"{names}: edges do not cancel along {lines} lines")
            return
        if claim.recast().text() != text:
            self.say(f"{names}: the text is not canonical")
        for fault in solid_faults(self.truth, claim, self.dice, points=points):
            place = place_of(self.truth, claim, fault, self.dice)
            self.say(f"{names}: {fault.what}{self.witnessed(place)}")
            return

    def _apart(self, one: str, other: str) -> str:
        sets = [exposed_from_json(json.loads(text)) for text in (one, other)]
        place = told_apart(sets[0], sets[1], self.dice)
        if place is None:
            return ""
        winds = " and ".join(str(winding(each, place, self.dice)) for each in sets)
        return f" (they wind {winds} times){self.witnessed(place)}"

    def witnessed(self, place: Point | None) -> str:
        """Says where the slow engine puts the point, and whether a witness passes its check."""
        if place is None:
            return ""
        inside = self.truth.holds(place)
        pair = self.pair
        x, y, z = (str(number) for number in place)
        p = q = None
        if inside:
            if pair.P.is_thin or pair.Q.is_thin:
                decision = ThinMeeting(pair.P, pair.Q, pair.scale).decide(place)
            else:
                decision = decide(pair.P, pair.Q, pair.scale, place)
            p, q = _texts(decision.p), _texts(decision.q)
        stands = holds(pair.P, pair.Q, pair.scale, Witness((x, y, z), inside, p, q))
        where = "in the sum" if inside else "outside"
        return f"; ({x}, {y}, {z}) is {where}, {'proven' if stands else 'NOT PROVEN'}"

    def say(self, message: str) -> None:
        self.messages.append(f"{self.pair.name} at {self.pair.scale}: {message}")


def moved(text: str, rows: Matrix, shift: Point) -> str:
    """A set given by its canonical text, under an integer matrix and a translation."""
    return exposed_from_json(json.loads(text)).mapped(rows, shift).text()


def _solid(polyhedron: Polyhedron) -> Solid:
    return solid_from_json(polyhedron.document())


def _texts(point: Point | None) -> tuple[str, ...] | None:
    return None if point is None else tuple(str(number) for number in point)
