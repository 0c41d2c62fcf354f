"""A case in space: two polyhedra and a scale."""

from __future__ import annotations

import json
import random
from collections.abc import Callable
from dataclasses import dataclass, replace
from fractions import Fraction
from functools import cached_property
from typing import Any

from minkref.errors import Refusal
from minkref.exact import read_scale
from minkref.fuzz.cases.case_name import CaseName
from minkref.fuzz.cases.needs import is_double
from minkref.fuzz.cases.no_case import NoCase
from minkref.fuzz.geometry.polyhedron import Polyhedron
from minkref.fuzz.geometry.space import Scale, factors
from minkref.fuzz.space.cells import cells_of
from minkref.fuzz.space.families import drawn_pair
from minkref.fuzz.space.fault_search import decided
from minkref.fuzz.space.hull import is_convex
from minkref.fuzz.space.laws import transformed_pairs
from minkref.fuzz.space.pair import SpacePair, Truth
from minkref.fuzz.space.protocol import IN_SPACE
from minkref.fuzz.space.self_crossing import self_crossing
from minkref.fuzz.verdicts.verdict import Witness

OTHER_FACTORS = (Fraction(1, 2), Fraction(3, 4), Fraction(1), Fraction(3, 2), Fraction(4))
MOST_GRID = 24  # cells across, for a literal to be looked at as a polycube
MOST_IN_SUM = 500_000  # most cells in the sum of two polycubes; beyond, cells are not used
LAWS_IN_SPACE = (
    "translate-P",
    "translate-Q",
    "homogeneity",
    "refinement",
    "rotate-axes",
    "quarter-turn",
    "swap",
)


def _same(result: Polyhedron) -> Polyhedron:
    return result


@dataclass
class SpaceCase:
    """The verdict is about `pair`. A target is asked for `asked`, which differs after a change by a
    law, and `back` takes the target's result to a result for `pair`; with `before`, the target is
    asked by `update`."""

    name: CaseName
    pair: SpacePair
    asked: SpacePair
    family: str
    back: Callable[[Polyhedron], Polyhedron] = _same
    position: str = "given"
    P_name: str = "P"
    Q_name: str = "Q"
    before: SpaceCase | None = None  # at another scale, from which `update` reaches this case

    dimension = 3
    exchange = IN_SPACE
    is_valid = True

    @staticmethod
    def of(name: CaseName, operands: list[Any], scale: Any, where: str) -> SpaceCase:
        """Makes a case from two sets in space as JSON values. Refuses values that are no
        polyhedra."""
        mend = 'write {"vertices": [[x, y, z], ...], "faces": [[i, j, k, ...], ...]}'
        solids = []
        for value in operands:
            try:
                solid = Polyhedron.from_document(value)
            except ValueError as error:
                raise Refusal(f"this is not a polyhedron: {error}", where, mend) from error
            fault = solid.fault()
            if fault is not None:
                raise Refusal(fault, where, "repair the mesh", "not-closed")
            solids.append(solid if solid.is_thin else solid.without_unused_vertices())
        if all(solid.is_thin for solid in solids):
            mend = "give one by its faces"
            raise Refusal("neither operand has a volume", where, mend, "not-solid")
        pair = known_pair(solids[0], solids[1], _scale(str(scale), where))
        return SpaceCase(name, pair, pair, "named")

    def under(self, law: str, name: CaseName) -> SpaceCase:
        """Changes the case by a law. NoCase if the law does not apply."""
        for changed in transformed_pairs(self.pair):
            if changed.name == law:
                return replace(self, name=name, asked=changed.pair, back=changed.back)
        raise NoCase(f"the law {law} says nothing of this case in space")

    def updated(self, name: CaseName) -> SpaceCase:
        """The case by `update` from another scale: uniform, or by three factors, like its own."""
        dice = random.Random(f"minkref update {name.text}")
        scale = other = self.asked.scale
        while other == scale:
            if isinstance(scale, tuple):
                x, y, z = (f * dice.choice(OTHER_FACTORS) for f in scale)
                other = (x, y, z)
            else:
                other = scale * dice.choice(OTHER_FACTORS)
        before = replace(self, name=name, asked=replace(self.asked, scale=other))
        return replace(self, name=name, before=before)

    @property
    def judged_operands(self) -> tuple[str, str]:
        return (self.pair.P.to_json(), self.pair.Q.to_json())

    @cached_property
    def P_json(self) -> str:
        return self.asked.P.to_json()

    @cached_property
    def Q_json(self) -> str:
        return self.asked.Q.to_json()

    @cached_property
    def scaled_P_json(self) -> str:
        return self.asked.P.scaled(self.asked.scale).to_json()

    @property
    def scale(self) -> str:
        return scale_text(self.asked.scale)

    @property
    def size(self) -> tuple[int, int, str]:
        pair = self.pair
        count = len(pair.P.vertices) + len(pair.Q.vertices)
        return (count, len(pair.P.to_json()) + len(pair.Q.to_json()), self.name.text)

    @cached_property
    def needs(self) -> frozenset[str]:
        needs = {"space"}
        for solid in (self.asked.P, self.asked.Q):
            if solid.is_thin:
                needs.add("point" if len(solid.vertices) == 1 else "segment")
            if not is_convex(solid):
                needs.add("non-convex")
                needs |= _topology(solid)
                if self_crossing(solid) is not None:
                    needs.add("touching")
        if not all(is_double(number) for number in self.sent):
            needs.add("rational")
        if isinstance(self.asked.scale, tuple):
            needs.add("non-uniform")
        return frozenset(needs)

    @cached_property
    def coordinates(self) -> list[Fraction]:
        """The coordinates of sP and of Q."""
        solids = (self.asked.P.scaled(self.asked.scale), self.asked.Q)
        return [number for solid in solids for vertex in solid.vertices for number in vertex]

    @cached_property
    def sent(self) -> list[Fraction]:
        """All coordinates sent to an implementation, including P's."""
        return [number for vertex in self.asked.P.vertices for number in vertex] + self.coordinates

    @cached_property
    def magnitude(self) -> Fraction:
        sP = self.asked.P.scaled(self.asked.scale)
        return sum(
            (max((abs(n) for v in solid.vertices for n in v), default=Fraction(0)))
            for solid in (sP, self.asked.Q)
        ) or Fraction(0)

    @property
    def literal(self) -> str:
        """Writes the pair as a text that names it, on one line."""
        value = {
            "P": self.pair.P.document(),
            "Q": self.pair.Q.document(),
            "scale": scale_text(self.pair.scale),
        }
        return json.dumps(value, separators=(",", ":"))

    def some_point(self) -> Witness:
        """Decides a point of the sum: the sum of two vertices."""
        p, q = self.pair.P.scaled(self.pair.scale).vertices[0], self.pair.Q.vertices[0]
        return decided(self.pair, (p[0] + q[0], p[1] + q[1], p[2] + q[2]))


def known_pair(P: Polyhedron, Q: Polyhedron, scale: Scale) -> SpacePair:
    """Returns the pair with the known facts about its sum: for convex operands the hull, for
    polycubes the cells, for others the exact sum."""
    if is_convex(P) and is_convex(Q):
        return SpacePair(P, Q, scale, "named", Truth.HULL)
    if not any(solid.is_thin or _extent(solid) > MOST_GRID for solid in (P, Q)):
        try:
            cells = (cells_of(P), cells_of(Q))
        except ValueError:
            return SpacePair(P, Q, scale, "named")
        if cells_in_sum(len(cells[0]) * len(cells[1]), scale) > MOST_IN_SUM:
            return SpacePair(P, Q, scale, "named")
        return SpacePair(P, Q, scale, "named", Truth.CELLS, P_cells=cells[0], Q_cells=cells[1])
    return SpacePair(P, Q, scale, "named")


def cells_in_sum(pairs: int, scale: Scale) -> int:
    """At most, of so many pairs of cells: at n/d each has n + d cells of the grid to a side."""
    sides = [factor.numerator + factor.denominator for factor in factors(scale)]
    return pairs * sides[0] * sides[1] * sides[2]


def _extent(solid: Polyhedron) -> Fraction:
    low, high = solid.box
    return max(b - a for a, b in zip(low, high, strict=True))


def _topology(solid: Polyhedron) -> set[str]:
    """Returns `holes` if a shell has a tunnel or is a cavity, `components` if several outer shells
    exist."""
    shells = solid.shells
    edges = {frozenset((f[k - 1], f[k])) for f in solid.faces for k in range(len(f))}
    used = {vertex for face in solid.faces for vertex in face}
    count = len(set(shells))
    needs = set()
    if len(used) - len(edges) + len(solid.faces) != 2 * count:
        needs.add("holes")
    if count > 1:
        signs = []
        for shell in set(shells):
            faces = tuple(f for f, s in zip(solid.faces, shells, strict=True) if s == shell)
            signs.append(Polyhedron(solid.vertices, faces).volume > 0)
        if not all(signs):
            needs.add("holes")
        if sum(signs) > 1:
            needs.add("components")
    return needs


def scale_text(scale: Scale) -> str:
    return ",".join(str(f) for f in scale) if isinstance(scale, tuple) else str(scale)


def _scale(text: str, where: str) -> Scale:
    parts = [Fraction(read_scale(part, where)) for part in text.split(",")]
    if len(parts) == 3:
        return (parts[0], parts[1], parts[2])
    if len(parts) != 1:
        raise Refusal("a scale is one number or three", where, "write 3/2 or 1,2,1/2")
    return parts[0]


def load_space(name: CaseName, family: str, seed: int, index: int) -> SpaceCase:
    pair = drawn_pair(family, seed, index)
    return SpaceCase(name, pair, pair, family)
