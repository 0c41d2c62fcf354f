"""Points and sides between covered cells that are inside the sum of the interiors: for a complete
list of tight passages (docs/certificates.md, `passages`)."""

from __future__ import annotations

import itertools
import json
from collections import defaultdict
from collections.abc import Iterable, Sequence
from fractions import Fraction
from math import lcm
from typing import Any

from minkref.certify.plane.piece_nodes import Tree
from minkref.certify.plane.predicate import Place, Vertices

Ids = tuple[int, ...]  # one point of the step, or the two ends of a side
Pair = tuple[int, int]  # a node of P and one of Q
Line = tuple[Fraction, Fraction, Fraction]  # a x + b y = c
Part = tuple[Fraction, Fraction]  # of a side, from 0 to 1, without its ends


class InnerPlaces:
    """`steps`: the steps `pieces` for P and Q, and a step `eq`. Exact. The cost grows with the
    sides of cells, and with pairs of pieces times the sides that two covering sums leave open."""

    def __init__(self, steps: Sequence[str], vertices: Vertices, scale: Fraction) -> None:
        *pieces, region = (json.loads(step) for step in steps)
        both = (vertices.P, vertices.Q)
        self._unit = lcm(*(c.denominator for of in both for place in of for c in place))
        self._trees = [Tree(step, of, self._unit) for step, of in zip(pieces, both, strict=True)]
        self._vertices, self._scale = vertices, scale
        self._points = self._places_of(region)
        self._region = region

    def entries(self, passages: Iterable[Sequence[int]]) -> list[list[Any]] | None:
        """The member `inner`, for passages given by the step's points; None if a place is in no
        sum of interiors, and on no passage."""
        nodes = self._between()
        for path in passages:
            for ids in (*((i,) for i in path), *map(sorted, itertools.pairwise(path))):
                nodes.pop(tuple(ids), None)
        found: list[list[Any]] = []
        for ids, pairs in sorted(nodes.items()):
            if _covering([(self._part(ids, *pair), pair) for pair in pairs]) is not None:
                continue
            P, Q = (range(tree.pieces) for tree in self._trees)
            every = [(self._part(ids, A, B), (A, B)) for A in P for B in Q]
            chosen = _covering(every)
            if chosen is None:
                return None
            found.append([list(ids), [list(pair) for pair in chosen]])
        return found

    def _between(self) -> dict[Ids, set[Pair]]:
        """Places with covered cells all around, and the nodes that cover these."""
        cover = [(code[0], code[1]) if how == "cov" else None
                 for how, *code in self._region["proofs"]]  # fmt: skip
        owner = {
            side: cell
            for cell, ring in enumerate(self._region["cells"])
            for side in zip(ring, ring[1:] + ring[:1], strict=True)
        }
        nodes: dict[Ids, set[Pair]] = defaultdict(set)
        outer: set[Ids] = set()
        for (u, v), cell in owner.items():
            other = owner.get((v, u))
            inner = other is not None and cover[other] is not None
            pair = cover[cell]
            for ids in ((min(u, v), max(u, v)), (u,), (v,)):
                if inner and pair is not None:
                    nodes[ids].add(pair)
                else:
                    outer.add(ids)
        return {ids: pairs for ids, pairs in nodes.items() if ids not in outer}

    def _part(self, ids: Ids, A: int, B: int) -> Part | None:
        """The part of a place inside the sum of two nodes."""
        low, high = Fraction(0), Fraction(1)
        P, Q = self._trees
        for n in (*P.sides[A], *Q.sides[B]):
            most = self._scale * P.most(A, n) + Q.most(B, n)
            ends = (self._points[i] for i in (ids[0], ids[-1]))
            s, t = (most - self._unit * (n[0] * x + n[1] * y) for x, y in ends)
            if s <= 0 and t <= 0:
                return None
            if s < 0:
                low = max(low, s / (s - t))
            elif t < 0:
                high = min(high, s / (s - t))
        return (low, high) if low < high else None

    def _places_of(self, region: dict[str, Any]) -> dict[int, Place]:
        x0, y0, x1, y1 = map(Fraction, region["box"])
        one, none = Fraction(1), Fraction(0)
        lines: dict[int, Line] = {
            0: (one, none, x0), 1: (none, one, y0), 2: (one, none, x1), 3: (none, one, y1)
        }  # fmt: skip
        points: dict[int, Place] = {}
        for number, (kind, *of) in enumerate(region["elements"], 4):
            if kind == "meet":
                points[number] = _meet(lines[of[0]], lines[of[1]])
            elif kind == "up":
                lines[number] = (one, none, points[of[0]][0])
            else:
                lines[number] = self._line(kind, *of)
        return points

    def _line(self, kind: str, i: int, k: int, j: int) -> Line:
        ends = ((i, j), (k, j)) if kind == "P" else ((j, i), (j, k))
        (a, b), (c, d) = (self._vertices.at(end, self._scale) for end in ends)
        return b - d, c - a, (b - d) * a + (c - a) * b


def _meet(one: Line, other: Line) -> Place:
    (a, b, e), (c, d, f) = one, other
    size = a * d - b * c
    return (e * d - b * f) / size, (a * f - e * c) / size


def _covering(parts: Iterable[tuple[Part | None, Pair]]) -> list[Pair] | None:
    """Pairs whose parts cover all from 0 to 1, without these two; None if they do not."""
    left = sorted((part, pair) for part, pair in parts if part is not None)
    chosen: list[Pair] = []
    reach = Fraction(0)
    while reach < 1:
        begun = [(part[1], pair) for part, pair in left if part[0] < reach or part[0] == 0]
        further, pair = max(begun, default=(reach, (0, 0)))
        if further <= reach:
            return None
        reach = further
        chosen.append(pair)
    return chosen
