#!/usr/bin/env python3
"""Checks certificates of Minkowski sums, paths, bridges and unions: `python3 check.py FILE...`.

The checker stands alone: this file and the standard library. Each part of it needs this one, the
last one, and those that it names. The forms, the demands of each rule and why they are enough:
docs/certificates.md, and certificates-convex.md, -solids, -paths, -features, -unions, -disc.
Signs are decided in integers and fractions. Anything unknown, unused or left over is malformed.

Exit codes: 0 verified; 1 refuted; 2 malformed, or its case is missing; 4 out of budget.
"""

from __future__ import annotations

import argparse
import hashlib
import itertools
import json
import os
import re
import signal
import sys
import time
from collections import Counter, defaultdict
from collections.abc import Callable, Iterable, Iterator, Sequence
from contextlib import contextmanager
from fractions import Fraction
from math import gcd, inf, isqrt, lcm
from pathlib import Path
from typing import Any, ClassVar, NamedTuple, TypeVar

VERIFIED, REFUTED, MALFORMED, OUT_OF_BUDGET = 0, 1, 2, 4
NUMBER = re.compile(r"[+-]?(\d+(\.\d*)?|\.\d+)([eE][+-]?(\d{1,3}|1000))?|[+-]?\d+/\d+", re.ASCII)
SURROGATE = re.compile(r"(?<!\\)(\\\\)*\\u[dD][89a-fA-F]")
MOST_DIGITS, MOST_BITS = 100_000, 2**31  # of one number; of numbers over one denominator
GZIP = b"\x1f\x8b"

Json = Any
Vertex = tuple[Fraction, ...]  # x, y; or x0, x1, y0, y1: the point (x0 + s x1, y0 + s y1)
Reader = Callable[[Path, float], bytes]  # of a file, and of a larger one a byte more than so many
# The function that follows a form, and the member that holds the argument; parts add theirs.
FORMS: dict[Any, tuple[str, Callable[..., list[str]]]] = {}


class NotVerified(Exception):
    def __init__(self, code: int, what: str) -> None:
        super().__init__(what)
        self.code = code


def demand(condition: bool, what: str, code: int = REFUTED) -> None:
    if not condition:
        raise NotVerified(code, what)


def require(condition: bool, what: str) -> None:
    demand(condition, what, MALFORMED)


@contextmanager
def within(place: str) -> Iterator[None]:
    """Puts the place before the message of an error inside."""
    try:
        yield
    except NotVerified as error:
        raise NotVerified(error.code, f"{place}: {error}") from error


class Budget:
    """The time and the tests that may still be spent. A signal ends work between two tests."""

    def __init__(self, seconds: float, tests: float) -> None:
        self.deadline, self.tests = time.monotonic() + seconds, tests
        signal.signal(signal.SIGALRM, lambda *_: self.spend(inf))
        signal.setitimer(signal.ITIMER_REAL, max(1e-6, min(seconds, 1e9)))

    def spend(self, tests: float) -> None:
        self.tests -= tests
        left = self.tests >= 0 and time.monotonic() < self.deadline
        demand(left, "a limit is reached (--seconds, --tests)", OUT_OF_BUDGET)

    def common(self, points: Sequence[Sequence[Fraction]]) -> int:
        """The common denominator, by which all coordinates become whole: they take room."""
        unit = 1
        for point in points:
            unit = lcm(unit, *(c.denominator for c in point))
            self.spend(1 + (bits := unit.bit_length()) // 64)
            demand(bits * len(points) <= MOST_BITS, "a denominator is too large", OUT_OF_BUDGET)
        return unit


def members(value: Json, names: str) -> list[Json]:
    """The members of an object, in the order of `names`, no others; `name?` may lack: None."""
    require(isinstance(value, dict), f"an object with {names} is missing")
    missing = [name for name in names.split() if name[-1] != "?" and name not in value]
    require(not missing, f"a member is missing: {', '.join(missing)}")
    known = names.replace("?", "").split()
    require(set(value) <= set(known), f"there are more members than {names}")
    return [value.get(name) for name in known]


def items(value: Json, length: int | None = None) -> list[Json]:
    require(isinstance(value, list), "a list is missing")
    require(length is None or len(value) == length, f"a list has not {length} entries")
    return list(value)


def headed(value: Json) -> tuple[Json, list[Json]]:
    """The first entry of a list, and the others."""
    require(items(value) != [], "a list is empty")
    return value[0], value[1:]


def integer(value: Json) -> int:
    require(isinstance(value, int) and not isinstance(value, bool), f"{value!r} is no integer")
    return int(value)


def index(value: Json, end: int) -> int:
    """A number below `end`: what is referred to has come before."""
    require(0 <= integer(value) < end, f"there is no number {value} before this")
    return int(value)


def number(value: Json) -> Fraction:
    if not isinstance(value, str):
        return Fraction(integer(value))
    good = len(value) <= MOST_DIGITS and NUMBER.fullmatch(value)
    require(bool(good) and not re.search("/0+$", value), f"{value[:60]!r} is no number")
    return Fraction(value)


def scale_of(value: Json) -> Fraction:
    require(number(value) > 0, f"the scale {value} is not positive")
    return number(value)


def vector(value: Json) -> Vertex:
    return tuple(number(coordinate) for coordinate in items(value, 2))


def file_bytes(path: Path, most: float) -> bytes:
    require(os.path.isfile(path), f"{str(path)[:400]} cannot be read: it is no file")
    with path.open("rb") as file:
        return file.read(int(most) + 1)


def read_json(path: Path, read: Reader, most: float, decimals: bool) -> Json:
    def unique(pairs: list[tuple[str, Json]]) -> Json:
        require(len(dict(pairs)) == len(pairs), "an object has a member twice")
        return dict(pairs)

    def refuse(text: str) -> Json:
        raise NotVerified(MALFORMED, f"{text[:60]} is no number here")

    try:
        data = read(path, most)
        demand(len(data) <= most, f"{path} has over {most:,.0f} bytes (--bytes)", OUT_OF_BUDGET)
        mend = "gzip -dc FILE | python3 check.py -, or minkref check FILE"
        require(data[:2] != GZIP, f"{path} is compressed by gzip: {mend}")
        text = data.decode()
        require(not SURROGATE.search(text), f"{path} escapes a surrogate")
        hooks: Json = {"parse_constant": refuse, "parse_float": str if decimals else refuse}
        hooks["parse_int"] = lambda text: (int if len(text) <= MOST_DIGITS else refuse)(text)
        return json.loads(text, object_pairs_hook=unique, **hooks)
    except OSError as error:
        raise NotVerified(MALFORMED, f"{path} cannot be read: {error.strerror}") from error
    except (ValueError, OverflowError, RecursionError) as error:
        raise NotVerified(MALFORMED, f"{path} is not JSON: {error}") from error


def digest_of(value: Json) -> str:
    text = json.dumps(value, sort_keys=True, separators=(",", ":"))
    return hashlib.sha256(text.encode()).hexdigest()


def edges_of(ring: Sequence[Any]) -> Iterator[tuple[Any, Any]]:
    return zip(ring, [*ring[1:], *ring[:1]], strict=True)


# Part 2: sums in the plane. An object of the class of a step exists only if the step holds.

Kind = TypeVar("Kind")
Vector = tuple[int, int]
Triple = tuple[Any, Any, Any]  # the point (x / w, y / w), w > 0; the line a x + b y + c = 0
Rings = list[list[Vertex]]  # the outer one, and the holes
Edge = tuple[int, int]


class Operand:
    """Its vertices in the order of the file, and its rings as their indices."""

    def __init__(self, value: Json, name: str) -> None:
        self.name = name
        self.exact: list[Vertex] = []
        self.points: list[Triple] = []  # the vertices in units that make them integers
        self.rings: list[list[int]] = []
        self.outer: set[int] = set()  # which rings are
        self.plain: list[Json] = []  # what is hashed: numbers in lowest terms
        for polygon in items(members(value, "polygons")[0]):
            outer, holes = members(polygon, "outer holes?")
            self.outer.add(len(self.rings))
            rings = [self.read_ring(r) for r in [outer, *items([] if holes is None else holes)]]
            self.plain.append({"holes": rings[1:], "outer": rings[0]})
        self.thin = any(len(ring) < 3 for ring in self.rings)  # a point or a segment
        require(not self.thin or len(self.rings) == 1, f"{name} has a ring of too few vertices")

    def read_ring(self, value: Json) -> Json:
        ring = [vector(point) for point in items(value)]
        require(bool(ring), f"{self.name} has an empty ring")
        self.rings.append(list(range(len(self.exact), len(self.exact) + len(ring))))
        self.exact += ring
        return [[str(x), str(y)] for x, y in ring]


def cross(u: Sequence[Any], v: Sequence[Any]) -> Any:
    return u[0] * v[1] - u[1] * v[0]


def dot(u: Sequence[Any], v: Sequence[Any]) -> Any:
    return u[0] * v[0] + u[1] * v[1]


def across(u: Triple, v: Triple) -> Triple:
    """The line through two points; up to a factor the point on two lines."""
    return u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]


def meet(first: Triple, second: Triple) -> Triple:
    x, y, w = across(first, second)
    demand(w != 0, "parallel lines do not meet")
    divisor = gcd(x, y, w) if w > 0 else -gcd(x, y, w)
    return x // divisor, y // divisor, w // divisor


def direction(p: Triple, q: Triple) -> Vector:
    return q[0] * p[2] - p[0] * q[2], q[1] * p[2] - p[1] * q[2]


def doubled_area(ring: Sequence[Any]) -> Any:
    return sum(cross(a, b) for a, b in edges_of(ring))


def is_convex(directions: Sequence[Vector]) -> bool:
    """Whether edges of these directions turn left, or go straight on, once around in all."""
    upwards = [d[1] > 0 or (d[1] == 0 and d[0] > 0) for d in directions]
    pairs = list(edges_of(directions))
    turns = all(cross(d, e) > 0 or (cross(d, e) == 0 and dot(d, e) > 0) for d, e in pairs)
    return turns and sum(not before and now for before, now in edges_of(upwards)) == 1


def hull(points: Iterable[Triple]) -> list[Triple]:
    """The vertices of the convex hull, counter-clockwise."""
    ordered = sorted(set(points))
    both: list[Triple] = []
    for run in (ordered, ordered[::-1]):
        chain: list[Triple] = []
        for p in run:
            while len(chain) > 1 and cross(direction(*chain[-2:]), direction(chain[-1], p)) <= 0:
                chain.pop()
            chain.append(p)
        both += chain[:-1]
    return both or ordered


def divides(A: list[Triple], B: list[Triple]) -> bool:
    """Whether the line of an edge of A has all of B on its other side."""
    sides = ([cross(direction(a, b), direction(a, p)) for p in B] for a, b in edges_of(A))
    return any(max(side) <= 0 for side in sides)


def whole_normal(value: Vertex) -> Vector:
    require(all(c.denominator == 1 for c in value), "a normal is not of whole numbers")
    require(any(value), "a normal is zero")
    return int(value[0]), int(value[1])


def add_up_to_nothing(edges: Iterable[tuple[Any, Any, int]]) -> bool:
    """Whether directed edges, each so many times, cancel: on each line their ends do."""
    ends: dict[Any, int] = defaultdict(int)
    for (x, y, *_), (X, Y, *_), times in edges:
        slope = Fraction(Y - y) / (X - x) if X != x else None
        line = x if slope is None else (slope, y - slope * x)
        ends[line, x, y] += times
        ends[line, X, Y] -= times
    return not any(ends.values())


class Pieces:
    """`pieces`: convex pieces that tile an operand, and groups of them. Node n is piece n, or group
    n - (number of pieces); the last one holds all. A node is solid if it is known to be convex."""

    def __init__(self, step: Json, proof: Proof) -> None:
        of, pieces, groups = members(step, "rule of pieces groups")[1:]
        self.operand, self.proof = proof.operand(of), proof
        points = self.operand.points
        pieces = [[index(i, len(points)) for i in items(piece)] for piece in items(pieces)]
        self.hulls = [[points[i] for i in piece] for piece in pieces]
        self.check_tiling(pieces)
        self.children: list[list[int]] = [[] for _ in pieces]
        self.leaves = [{i} for i in range(len(pieces))]
        self.solid = [True for _ in pieces]
        for group in items(groups):
            self.add_group([index(child, len(self.hulls)) for child in items(group)])
        whole = not pieces or len(self.leaves[-1]) == len(pieces)
        demand(whole, "the last node does not hold all pieces")
        self.root = [len(self.hulls) - 1] if pieces else []
        self.support: dict[tuple[int, Vector], int] = {}

    def check_tiling(self, pieces: list[list[int]]) -> None:
        points, rings, name = self.operand.points, self.operand.rings, self.operand.name
        if self.operand.thin:
            return demand(pieces == rings, f"{name} is no region: it is its own only piece")
        self.proof.spend(sum(map(len, [*rings, *pieces])))
        given = [(points[i], points[j], -1) for ring in rings for i, j in edges_of(ring)]
        made = [(a, b, 1) for piece in self.hulls for a, b in edges_of(piece)]
        demand(add_up_to_nothing(given + made), f"the pieces do not add up to {name}")
        for piece in self.hulls:
            demand(is_convex([direction(*e) for e in edges_of(piece)]), "a piece is not convex")

    def add_group(self, children: list[int]) -> None:
        require(0 < len(children) == len(set(children)), "a group has no member, or one twice")
        parts = [self.hulls[child] for child in children]
        self.proof.spend(sum(map(len, parts)) + sum(len(self.leaves[child]) for child in children))
        self.children.append(children)
        self.leaves.append(set().union(*(self.leaves[child] for child in children)))
        self.hulls.append(hull(corner for part in parts for corner in part))
        solid = len(parts) == 2 and all(self.solid[child] for child in children)
        solid = solid and doubled_area(self.hulls[-1]) == sum(map(doubled_area, parts))
        self.solid.append(solid and (divides(*parts) or divides(*parts[::-1])))

    def most(self, node: int, normal: Vector) -> int:
        """The largest value of normal * x on the hull of a node."""
        if (node, normal) not in self.support:
            self.proof.spend(len(self.hulls[node]))
            self.support[node, normal] = max(dot(normal, corner) for corner in self.hulls[node])
        return self.support[node, normal]


class Region:
    """`eq` at one scale, `move` from one to another: convex cells that tile a box, each covered by
    the sum of two solid nodes or apart from it, which is thus the union of those covered. Corners
    are linear in s: what is linear and holds at both ends holds between."""

    def __init__(self, step: Json, proof: Proof) -> None:
        names = "rule scales by box elements cells normals proofs contacts polygons"
        rule, scales, by, *lists = members(step, names)
        box, elements, cells, normals, proofs, contacts, rings = map(items, lists)
        self.proof = proof
        self.scales = [scale_of(scale) for scale in items(scales, 1 if rule == "eq" else 2)]
        require(self.scales == sorted(set(self.scales)), "the scales do not ascend")
        self.P, self.Q = (proof.step(value, Pieces) for value in items(by, 2))
        require((self.P.operand.name, self.Q.operand.name) == ("P", "Q"), "`by` is not of P and Q")
        self.roots = list(itertools.product(self.P.root, self.Q.root))  # none: the sum is empty
        self.box = [number(value) * proof.unit for value in items(box, 4)]
        demand(self.box[0] < self.box[2] and self.box[1] < self.box[3], "the box is empty")
        self.lines: dict[int, list[Triple]] = {}
        for wall, at in enumerate(self.box):
            normal = (at.denominator, 0) if wall % 2 == 0 else (0, at.denominator)
            self.lines[wall] = [(*normal, -at.numerator) for _ in self.scales]
        self.points: dict[int, list[Triple]] = {}
        for entry in elements:
            self.add_element(*headed(entry))
        self.cells = [[self.point(i) for i in items(cell)] for cell in cells]
        self.owner: dict[Edge, int] = {}
        self.directions: dict[Edge, Vector] = {}
        for cell in range(len(self.cells)):
            self.check_cell(cell)
        self.check_box()
        self.normals = [whole_normal(vector(normal)) for normal in normals]
        self.inside: dict[int, list[Json]] = {}  # the covered cells, with their nodes
        for cell, (how, code) in enumerate(map(headed, items(proofs, len(self.cells)))):
            require(how in ("cov", "sep"), f"cell {cell} has no proof")
            (self.check_cover if how == "cov" else self.check_apart)(self.cells[cell], code)
            self.inside.update({cell: code} if how == "cov" else {})
        self.contacts = set()
        for ids, code in map(headed, contacts):
            contact = [self.point(i) for i in items(ids)]
            require(1 <= len(contact) == len(set(contact)) <= 2, "this is no point or segment")
            self.check_apart(contact, code)
            self.contacts.add(tuple(contact))
        self.count()
        self.passed: list[Vertex] = []  # the points of the rings
        self.polygons = self.canonical([[items(r) for r in items(p)] for p in rings])

    def point(self, value: Json) -> int:
        require(integer(value) in self.points, f"element {value} is no point before this")
        return int(value)

    def add_element(self, kind: Json, entry: list[Json]) -> None:
        self.proof.spend(1)
        own = len(self.lines) + len(self.points)
        if kind == "meet":
            require(all(integer(i) in self.lines for i in items(entry, 2)), "no lines to meet")
            self.points[own] = list(map(meet, *(self.lines[i] for i in entry)))
        elif kind == "up":
            at = self.points[self.point(items(entry, 1)[0])]
            self.lines[own] = [(w, 0, -x) for x, _, w in at]
        else:
            self.lines[own] = self.moving_line(self.proof.operand(kind), items(entry, 3))

    def moving_line(self, mover: Operand, entry: list[Json]) -> list[Triple]:
        """Through vertices i and k of one operand, moved by vertex j of the other."""
        other = self.proof.operands["Q" if mover.name == "P" else "P"]
        i, k = (mover.points[index(value, len(mover.points))] for value in entry[:2])
        j = other.points[index(entry[2], len(other.points))]
        demand(i != k, "a line has no direction")
        dx, dy = direction(i, k)
        p, q = (i, j) if mover.name == "P" else (j, i)
        p, q = dot((-dy, dx), p), dot((-dy, dx), q)
        fractions = ((s.numerator, s.denominator) for s in self.scales)
        return [(-dy * v, dx * v, -u * p - v * q) for u, v in fractions]

    def check_cell(self, cell: int) -> None:
        self.proof.spend(len(self.cells[cell]))
        turns = []
        for edge in edges_of(self.cells[cell]):
            pairs = zip(*(self.points[end] for end in edge), strict=True)
            moves = [d for d in (direction(a, b) for a, b in pairs) if d != (0, 0)]
            demand(bool(moves), f"cell {cell} has an edge without length")
            straight = len(moves) == 1 or (cross(*moves) == 0 and dot(*moves) > 0)
            demand(straight, f"cell {cell} has an edge that turns")
            demand(edge not in self.owner, f"two cells have the edge {edge}")
            self.owner[edge], self.directions[edge] = cell, moves[0]
            turns.append(moves[0])
        demand(len(turns) > 2 and is_convex(turns), f"cell {cell} is not convex")

    def check_box(self) -> None:
        """Edges with a cell on one side only are the rim of the box, which holds the sum."""
        rim = [edge for edge in self.owner if edge[::-1] not in self.owner]
        for u, v in rim:
            ends = [*self.points[u], *self.points[v]]
            on_wall = any(all(self.box[w] * p[2] == p[w % 2] for p in ends) for w in range(4))
            demand(on_wall, f"the edge {u}, {v} of a cell has no cell on its other side")
        at = {i: [Fraction(c, p[0][2]) for c in p[0][:2]] for i, p in self.points.items()}
        x, y, X, Y = self.box
        frame = [(a, b, -1) for a, b in edges_of([(x, y), (X, y), (X, Y), (x, Y)])]
        made = [(at[u], at[v], 1) for u, v in rim]
        demand(add_up_to_nothing(frame + made), "the cells do not add up to the box")
        for normal, c in zip([(-1, 0), (0, -1), (1, 0), (0, 1)], self.box, strict=True):
            for (end, s), (A, B) in itertools.product(enumerate(self.scales), self.roots):
                most = Fraction(self.most(end, A, B, normal), s.denominator)
                demand(most < sum(normal) * c, "the box does not hold the sum")

    def most(self, end: int, A: int, B: int, normal: Vector) -> int:
        """The largest value of normal * x on sA + B, times the denominator of s."""
        s = self.scales[end]
        return s.numerator * self.P.most(A, normal) + s.denominator * self.Q.most(B, normal)

    def least(self, end: int, corners: list[int], normal: Vector, side: int) -> int:
        """The least value (side 1) of normal * x on points, rounded down, or the largest (-1),
        rounded up, in the unit of `most`."""
        factor = side * self.scales[end].denominator
        points = (self.points[i][end] for i in corners)
        return side * int(min(factor * dot(normal, p) // p[2] for p in points))

    def check_cover(self, corners: list[int], nodes: list[Json]) -> None:
        """`cov`: the hull of the corners lies in sA + B, both nodes solid."""
        A, B = items(nodes, 2)
        A, B = index(A, len(self.P.hulls)), index(B, len(self.Q.hulls))
        demand(self.P.solid[A] and self.Q.solid[B], f"{A} or {B} is not convex")
        for a, b in [*edges_of(self.P.hulls[A]), *edges_of(self.Q.hulls[B])]:
            self.proof.spend(len(corners))
            normal = b[1] - a[1], a[0] - b[0]
            for end in range(len(self.scales)):
                inside = self.least(end, corners, normal, -1) <= self.most(end, A, B, normal)
                demand(inside, f"{corners} is not in the sum of {A} and {B}")

    def check_apart(self, corners: list[int], code: list[Json]) -> None:
        """`sep`, for all pairs of pieces: -1 splits the first node of the pair in hand, -2 the
        second; n says that normal n separates the pair from the corners (they may touch)."""
        self.proof.spend(len(code))
        known: dict[Edge, int] = {}
        pairs = list(self.roots)
        for token in code:
            demand(bool(pairs), "a code goes on after its end")
            A, B = pairs.pop()
            if token in (-1, -2):
                children = self.P.children[A] if token == -1 else self.Q.children[B]
                demand(bool(children), "a code splits a piece")
                pairs += [(c, B) if token == -1 else (A, c) for c in reversed(children)]
                continue
            normal = self.normals[index(token, len(self.normals))]
            for end in range(len(self.scales)):
                if (end, token) not in known:
                    known[end, token] = self.least(end, corners, normal, 1)
                apart = known[end, token] >= self.most(end, A, B, normal)
                demand(apart, f"normal {normal} does not separate {corners} from {A} and {B}")
        demand(not pairs, "a code ends too early")

    def count(self) -> None:
        """Components of the interior, and holes: cells that share an edge, joined."""
        root = list(range(len(self.cells)))
        for edge, cell in self.owner.items():
            other = self.owner.get(edge[::-1], cell)
            if (cell in self.inside) == (other in self.inside):
                root[find(root, cell)] = find(root, other)
        self.root = [find(root, cell) for cell in range(len(root))]
        components = len({self.root[cell] for cell in self.inside})
        self.counts = [components, len(set(self.root)) - components - 1]

    def canonical(self, polygons: list[list[list[Json]]]) -> list[Rings]:
        owner, d = self.owner, self.directions
        left = {e for e in owner if owner[e] in self.inside and owner[e[::-1]] not in self.inside}
        middle = sum(self.scales, Fraction(0)) / len(self.scales)
        made, roots = [], []
        for polygon in polygons:
            require(bool(polygon), "a polygon has no ring")
            rings: Rings = []
            roots.append(set[int]())
            for ring in polygon:
                edges = list(edges_of([self.point(v) for v in ring]))
                simple = len(set(ring)) == len(ring) > 2 and left.issuperset(edges)
                demand(simple, "a ring is not simple, or not on the boundary")
                left.difference_update(edges)
                roots[-1] |= {self.root[owner[e]] for e in edges}
                self.passed += [self.vertex(point) for point, _ in edges]
                rings.append([self.vertex(f[0]) for e, f in edges_of(edges) if cross(d[e], d[f])])
                outer = doubled_area([at_scale(v, middle) for v in rings[-1]]) > 0
                demand(outer == (len(rings) == 1), "a ring runs the wrong way")
            made.append(rings)
        one_each = len(roots) == self.counts[0] and all(len(root) == 1 for root in roots)
        demand(not left and one_each, "the rings are not the boundary, a polygon a component")
        return canonical_order(made)

    def vertex(self, point: int) -> Vertex:
        ends = [[Fraction(c, p[2] * self.proof.unit) for c in p[:2]] for p in self.points[point]]
        if len(ends) == 1:
            return tuple(ends[0])
        a, b = self.scales
        u, v = ((q - p) / (b - a) for p, q in zip(*ends, strict=True))
        return ends[0][0] - a * u, u, ends[0][1] - a * v, v


def find(root: list[int], cell: int) -> int:
    while root[cell] != cell:
        root[cell] = cell = root[root[cell]]
    return cell


def at_scale(vertex: Vertex, s: Fraction) -> Vertex:
    return vertex if len(vertex) == 2 else (vertex[0] + s * vertex[1], vertex[2] + s * vertex[3])


def canonical_order(polygons: list[Rings]) -> list[Rings]:
    def turned(ring: list[Vertex]) -> list[Vertex]:
        return ring[ring.index(min(ring)) :] + ring[: ring.index(min(ring))]

    return sorted([turned(rings[0]), *sorted(map(turned, rings[1:]))] for rings in polygons)


def plain(polygons: list[Rings]) -> Json:
    rings = [[[[str(c) for c in v] for v in ring] for ring in polygon] for polygon in polygons]
    return {"polygons": [{"holes": polygon[1:], "outer": polygon[0]} for polygon in rings]}


class Proof:
    """The operands, and the steps and claims that hold so far."""

    rules: ClassVar[dict[Any, Any]] = {"pieces": Pieces, "eq": Region, "move": Region}
    claims: ClassVar[dict[Any, Any]] = {}  # what checks one; returns its text and what it shows

    def __init__(self, P: Operand, Q: Operand, budget: Budget) -> None:
        require(not (P.thin and Q.thin), "both operands are points or segments")
        self.operands = {P.name: P, Q.name: Q}
        self.spend = budget.spend
        self.unit = budget.common(P.exact + Q.exact)
        for o in (P, Q):
            o.points = [(int(x * self.unit), int(y * self.unit), 1) for x, y in o.exact]
            areas = [doubled_area([o.points[i] for i in ring]) for ring in o.rings]
            right = o.thin or all(a and (a > 0) == (i in o.outer) for i, a in enumerate(areas))
            require(right, f"{o.name} has a ring that runs the wrong way")

    def operand(self, name: Json) -> Operand:
        require(name in tuple(self.operands), f"{name!r} is no operand")
        return self.operands[name]

    def step(self, value: Json, kind: type[Kind]) -> Kind:
        step = self.steps[index(value, len(self.steps))]
        require(isinstance(step, kind), f"step {value} is no {kind.__name__.lower()}")
        self.used.add(value)
        return step  # type: ignore[no-any-return]

    def region(self, step: Json, scale: Json) -> Region:
        region = self.step(step, Region)
        demand(region.scales == [scale_of(scale)], "the step is about another scale")
        return region

    def follow(self, steps: Json, claims: Json) -> list[str]:
        """Checks steps and claims; returns the claims as texts."""
        self.steps: list[Any] = []
        self.used: set[int] = set()
        self.shown: list[Any] = []  # the region, or the regions, that a claim is about
        self.said: list[str] = []
        for i, step in enumerate(items(steps)):
            with within(f"step {i}"):
                rule = step.get("rule") if isinstance(step, dict) else None
                require(rule in tuple(self.rules), f"there is no rule {rule!r}")
                self.steps.append(self.rules[rule](step, self))
        require(len(set(map(digest_of, items(claims)))) == len(claims), "a claim is made twice")
        for i, claim in enumerate(claims):
            with within(f"claim {i}"):
                self.spend(64)
                kind = claim.get("claim") if isinstance(claim, dict) else None
                require(kind in tuple(self.claims), f"there is no claim {kind!r}")
                said, shown = self.claims[kind](self, claim)
                self.said.append(f"{kind}: {said}")
                self.shown.append(shown)
        require(bool(claims), "nothing is claimed")
        require(len(self.used) == len(self.steps), "a step is not used")
        return self.said


def add_sum(proof: Proof, claim: Json) -> tuple[str, Region]:
    """The sum at a scale, by its digest, and by its canonical form if that is given."""
    names = "claim scale step components holes digest polygons?"
    scale, step, *counts, digest, polygons = members(claim, names)[1:]
    region = proof.region(step, scale)
    demand(region.counts == [*map(integer, counts)], "components or holes are others")
    form = plain(region.polygons)
    demand(digest_of(form) == digest, "the digest is another")
    demand(polygons in (None, form["polygons"]), "the polygons are others")
    return f"at {scale}, {counts[0]} components, {counts[1]} holes, {digest}", region


def of_the_plane(case: Json, digest: Json, steps: Json, claims: Json, budget: Budget) -> list[str]:
    P, Q = (Operand(case.get(operand), operand) for operand in "PQ")
    demand(digest_of({"P": P.plain, "Q": Q.plain}) == digest, "not the case that is certified")
    return Proof(P, Q, budget).follow(steps, claims)


Proof.claims["sum"] = add_sum
FORMS["certificate-v1"] = "steps", of_the_plane


# Part 3: the other claims in the plane. Needs part 2.


def seen(proof: Proof, value: Json, kind: type[Kind]) -> Kind:
    found = proof.shown[index(value, len(proof.shown))]
    require(isinstance(found, kind), f"claim {value} is of another kind")
    return found  # type: ignore[no-any-return]


def form_of(region: Region, s: Fraction | None = None) -> tuple[list[Rings], list[Vertex]]:
    """The form, and the points that rings pass more than once, as often as they come again. At a
    scale between: if the boundary has the same vertices there."""
    again = sorted((Counter(region.passed) - Counter(set(region.passed))).elements())
    if s is None:
        return region.polygons, again
    moved = [[[at_scale(v, s) for v in r] for r in p] for p in region.polygons]
    return canonical_order(moved), sorted(at_scale(v, s) for v in again)


def is_within(region: Region, contact: tuple[int, ...]) -> bool:
    """Whether all cells around a point, or on both sides of an edge, are covered."""
    sides = [e for e in region.owner if contact[0] in e and contact[-1] in e]
    sides += [e[::-1] for e in sides]
    return bool(sides) and all(region.owner.get(e) in region.inside for e in sides)


def add_interval(proof: Proof, claim: Json) -> tuple[str, list[Region]]:
    """No event of the boundary between two scales: its vertices are linear in s."""
    names = "claim from to steps components holes digest"
    a, b, steps, *counts, digest = members(claim, names)[1:]
    regions = [proof.step(step, Region) for step in items(steps)]
    lengths = [len(region.scales) for region in regions]
    require(lengths == [2, *[1, 2] * (len(regions) // 2)], "moves, and scales between")
    joints = [s for region in regions[1::2] for s in region.scales * 3]
    ends = [scale_of(a), *joints, scale_of(b)]
    demand(ends == [s for r in regions for s in r.scales], "the steps do not reach end to end")
    for region in regions:
        demand(region.counts == [*map(integer, counts)], "components or holes are others")
        wanted = form_of(regions[0], None if region.scales[1:] else region.scales[0])
        demand(form_of(region) == wanted, f"the boundary changes at {region.scales[0]}")
    demand(digest_of(plain(regions[0].polygons)) == digest, "the digest is another")
    return f"from {a} to {b}, {counts[0]} components, {counts[1]} holes, {digest}", regions


def add_event(proof: Proof, claim: Json) -> tuple[str, tuple[Fraction, str]]:
    """At a scale, and just below and above it, the boundary or the topology is not the same."""
    scale, kind, before, at, after = members(claim, "claim scale kind before at after")[1:]
    require(kind in ("boundary", "topology"), f"there is no event {kind!r}")
    low, here, high = seen(proof, before, list), seen(proof, at, Region), seen(proof, after, list)
    s = scale_of(scale)
    demand(low[-1].scales[1] == here.scales[0] == high[0].scales[0] == s, "not at one scale")
    same = form_of(low[0]) == form_of(high[0]) and form_of(low[0], s) == form_of(here)
    as_many = low[0].counts == here.counts == high[0].counts
    demand(not (as_many if kind == "topology" else same), "nothing changes")
    said = f"{kind} at {scale}, no event of the boundary from {low[0].scales[0]} to it"
    return said, (s, "boundary" if as_many else "topology")


def add_point(proof: Proof, claim: Json) -> tuple[str, None]:
    """A point of the sum: s p + q, p in a piece of P and q in one of Q."""
    scale, point, p, q, steps, nodes = members(claim, "claim scale point p q by pieces")[1:]
    parts = vector(p), vector(q)
    made = tuple(scale_of(scale) * x + y for x, y in zip(*parts, strict=True))
    demand(made == vector(point), "s p + q is another point")
    at = zip("PQ", parts, items(steps, 2), items(nodes, 2), strict=True)
    for name, part, step, node in at:
        pieces = proof.step(step, Pieces)
        require(pieces.operand.name == name, f"no pieces of {name}")
        ring = pieces.hulls[index(node, pieces.children.count([]))]
        p = part[0] * proof.unit, part[1] * proof.unit, 1
        turns = (cross(direction(a, b), direction(a, p)) for a, b in edges_of(ring))
        # A piece may be a segment, or a point: the box bounds it.
        good = all(min(c) <= x <= max(c) for x, *c in zip(p, *ring, strict=True))
        demand(good and min(turns) >= 0, f"{part} is not in piece {node} of {name}")
    return f"{point} at {scale}", None


class Outside(Region):
    """A point at a scale that normals hold strictly apart from all pairs of pieces."""

    def __init__(self, proof: Proof, scale: Json, at: Json, steps: Json, normals: Json) -> None:
        self.proof, self.scales = proof, [scale_of(scale)]
        self.P, self.Q = (proof.step(value, Pieces) for value in items(steps, 2))
        require((self.P.operand.name, self.Q.operand.name) == ("P", "Q"), "`by` is not of P and Q")
        self.roots = list(itertools.product(self.P.root, self.Q.root))
        self.at = [c * proof.unit for c in vector(at)]
        self.normals = [whole_normal(vector(normal)) for normal in items(normals)]

    def least(self, end: int, corners: list[int], normal: Vector, side: int) -> int:
        """The largest integer less than the value at the point: a normal may not touch."""
        return int(-(-self.scales[end].denominator * dot(normal, self.at) // 1)) - 1


def add_outside(proof: Proof, claim: Json) -> tuple[str, None]:
    """A point that is not in the sum."""
    scale, point, steps, normals, code = members(claim, "claim scale point by normals code")[1:]
    Outside(proof, scale, point, steps, normals).check_apart([], items(code))
    return f"{point} at {scale}", None


def add_passage(proof: Proof, claim: Json) -> tuple[str, dict[tuple[int, ...], Region]]:
    """Points inside the sum, along edges of cells, that the sum of the interiors misses."""
    scale, step, points, path = members(claim, "claim scale step points path")[1:]
    region = proof.region(step, scale)
    thin = region.P.operand.thin or region.Q.operand.thin
    require(not thin, "passages of a point or a segment are not proven by contacts")
    ids = [region.point(i) for i in items(path)]
    demand([region.vertex(i) for i in ids] == list(map(vector, items(points))), "other points")
    contacts = [(ids[0],)] if len(ids) == 1 else list(itertools.pairwise(ids))
    require(bool(contacts), "a passage has no point")
    for contact in contacts:
        demand(contact in region.contacts, f"{contact} is no contact")
        demand(is_within(region, contact), f"{contact} is not inside the sum")
    return f"{points} at {scale}", dict.fromkeys(contacts, region)


def add_sign(proof: Proof, claim: Json) -> tuple[str, None]:
    """The sign of a predicate between two scales, or at one; zero at one means a root there."""
    of, a, b, sign = members(claim, "claim of from to sign")[1:]
    require(scale_of(a) <= scale_of(b), "the scales do not ascend")
    require(integer(sign) in (-1, 0, 1), "this is no sign")
    signs = signs_of(proof, of, [number(a), number(b)])
    good = signs == {0} if sign == 0 else {sign} <= signs <= {0, sign}
    demand(good, f"{of} has the signs {sorted(signs)} from {a} to {b}")
    return f"{of} has the sign {sign} from {a} to {b}", None


def signs_of(proof: Proof, predicate: Json, ends: list[Fraction]) -> set[int]:
    """Those of the Bernstein coefficients, from one scale to another, of `orientation` of three
    points s p + q (positive: they turn left), or of `concurrent`, three lines, each through two
    such points (zero: they meet in a point or are parallel). Both are linear in each point, and
    a coefficient adds up the values with so many points at the second scale."""
    name, entries = items(predicate, 2)
    require(name in ("orientation", "concurrent"), f"there is no predicate {name!r}")
    points = items(entries, 3)
    if name == "concurrent":
        points = [point for line in points for point in items(line, 2)]
    moving = [[moved(proof, point, s) for s in ends] for point in points]
    apart = len(moving) == 3 or all(moving[k] != moving[k + 1] for k in (0, 2, 4))
    require(apart, "a line has one point given twice")
    sums = [Fraction(0)] * (len(points) + 1)
    for choice in itertools.product((0, 1), repeat=len(points)):
        u, v, w, *more = (point[end] for point, end in zip(moving, choice, strict=True))
        if more:
            u, v, w = across(u, v), across(w, more[0]), across(more[1], more[2])
        sums[sum(choice)] += sum(x * y for x, y in zip(u, across(v, w), strict=True))
    return {(c > 0) - (c < 0) for c in sums}


def moved(proof: Proof, value: Json, s: Fraction) -> Triple:
    """Vertex i of sP plus vertex j of Q, null for none of it."""
    x, y = Fraction(0), Fraction(0)
    for i, name in zip(items(value, 2), "PQ", strict=True):
        if i is not None:
            at = proof.operands[name].exact[index(i, len(proof.operands[name].exact))]
            x, y = (c + (s if name == "P" else 1) * d for c, d in zip((x, y), at, strict=True))
    return x, y, Fraction(1)


def of_scaled_axes(
    case: Json, digest: Json, axes: Json, steps: Json, claims: Json, budget: Budget
) -> list[str]:
    """All that part 2 says, with P scaled by a factor for each axis first."""
    P, Q = (Operand(case.get(operand), operand) for operand in "PQ")
    demand(digest_of({"P": P.plain, "Q": Q.plain}) == digest, "not the case that is certified")
    x, y = map(scale_of, items(axes, 2))
    P.exact = [(x * a, y * b) for a, b in P.exact]
    return [f"P by {x},{y}: {line}" for line in Proof(P, Q, budget).follow(steps, claims)]


FORMS["axes-certificate-v1"] = "axes steps", of_scaled_axes
Proof.claims.update(interval=add_interval, event=add_event, point=add_point)
Proof.claims.update(outside=add_outside, passage=add_passage, sign=add_sign)


# Part 3b: lists in the plane that are complete. Needs parts 2 and 3.


def add_events(proof: Proof, claim: Json) -> tuple[str, None]:
    """All events of the boundary between two scales: intervals without any, and events where they
    meet."""
    names = "claim from to intervals events scales kinds components holes"
    a, b, through, claims, scales, kinds, *counts = members(claim, names)[1:]
    intervals = [seen(proof, i, list) for i in items(through)]
    events = [seen(proof, i, tuple) for i in items(claims)]
    require(len(intervals) == len(events) + 1, "intervals, and events between")
    joints = [s for s, _ in events]
    starts, ends = zip(*((x[0].scales[0], x[-1].scales[1]) for x in intervals), strict=True)
    meet = [scale_of(a), *joints] == [*starts] and [*joints, scale_of(b)] == [*ends]
    demand(meet, "the intervals do not reach end to end, with events between")
    listed = [*map(scale_of, items(scales, len(events)))]
    demand(listed == joints, "the events are at other scales")
    same = items(kinds, len(events)) == [kind for _, kind in events]
    demand(same, "an event is of the other kind")
    for n, given in enumerate(counts):
        found = [interval[0].counts[n] for interval in intervals]
        demand([*map(integer, items(given, len(found)))] == found, "components or holes are others")
    told = ", ".join(f"{kind} at {s}" for s, kind in events) or "none"
    return f"from {a} to {b}, without both, all of the boundary: {told}", None


def places_between(region: Region) -> dict[tuple[int, ...], list[list[Json]]]:
    """The sides between two covered cells, without their ends, and the points around which all
    cells are covered; each with the nodes that cover these cells."""
    nodes: dict[tuple[int, ...], list[list[Json]]] = defaultdict(list)
    outer = set()
    for (u, v), cell in region.owner.items():
        other = region.owner.get((v, u))
        if cell in region.inside and other in region.inside:
            for place in ((min(u, v), max(u, v)), (u,), (v,)):
                nodes[place].append(region.inside[cell])
        else:
            outer |= {(min(u, v), max(u, v)), (u,), (v,)}
    return {place: nodes[place] for place in sorted(nodes.keys() - outer)}


def is_in_open_sums(region: Region, place: tuple[int, ...], nodes: list[list[Json]]) -> bool:
    """Whether the insides of these sums of two solids hold a point, or together a segment without
    its ends. A part of it in one of them is open: t from 0 to 1, between two values."""
    ends = [region.points[place[0]][0], region.points[place[-1]][0]]
    parts = []
    for A, B in sorted({(A, B) for A, B in nodes}):
        low, high = Fraction(0), Fraction(1)
        for a, b in [*edges_of(region.P.hulls[A]), *edges_of(region.Q.hulls[B])]:
            region.proof.spend(len(place))
            normal = b[1] - a[1], a[0] - b[0]
            most, unit = region.most(0, A, B, normal), region.scales[0].denominator
            s, t = (most - Fraction(unit * dot(normal, end), end[2]) for end in ends)
            if s <= 0 and t <= 0:
                low = high
            elif s < 0:
                low = max(low, s / (s - t))
            elif t < 0:
                high = min(high, s / (s - t))
        if low < high:
            parts.append((low, high))
    reach = Fraction(0)
    for low, high in sorted(parts):
        reach = max(reach, high) if low < reach or low == 0 else reach
    return reach == 1


def add_passages(proof: Proof, claim: Json) -> tuple[str, None]:
    """All points inside the sum that the sum of the interiors misses are on these passages."""
    scale, step, passages, inner = members(claim, "claim scale step passages inner")[1:]
    region = proof.region(step, scale)
    thin = region.P.operand.thin or region.Q.operand.thin
    require(not thin, "passages of a point or a segment are not proven by contacts")
    listed = [seen(proof, i, dict) for i in items(passages)]
    require(all(of is region for found in listed for of in found.values()), "of another step")
    require(len(set(passages)) == len(listed), "a passage is listed twice")
    contacts = {tuple(sorted(contact)) for found in listed for contact in found}
    contacts |= {(point,) for contact in contacts for point in contact}
    places = places_between(region)
    left = {p for p in places.keys() - contacts if not is_in_open_sums(region, p, places[p])}
    for ids, nodes in (items(entry, 2) for entry in items(inner)):
        place = tuple(sorted(region.point(i) for i in items(ids)))
        require(place in left, f"{ids} is between no cells, or shown already")
        left.remove(place)
        for pair in items(nodes):
            A, B = items(pair, 2)
            A, B = index(A, len(region.P.hulls)), index(B, len(region.Q.hulls))
            demand(region.P.solid[A] and region.Q.solid[B], f"{A} or {B} is not convex")
        demand(is_in_open_sums(region, place, nodes), f"{ids} is not inside these sums")
    demand(not left, f"{sorted(left)[:3]} are on no passage that is listed")
    return f"{len(listed)} at {scale}, and no others", None


Proof.claims.update(events=add_events, passages=add_passages)


# Part 4: space, surfaces whose vertices are whole numbers, and sums of convex polyhedra.

SpaceVector = tuple[int, int, int]
SpacePoint = tuple[Fraction, Fraction, Fraction]


def indices(value: Json, end: int) -> list[int]:
    numbers = [integer(entry) for entry in items(value)]
    require(all(0 <= i < end for i in numbers), f"one of {numbers[:9]}... is no number here")
    return numbers


def space_vector(value: Json) -> SpacePoint:
    x, y, z = map(number, items(value, 3))
    return x, y, z


def dot_in_space(u: SpaceVector, v: SpaceVector) -> int:
    return u[0] * v[0] + u[1] * v[1] + u[2] * v[2]


def cross_in_space(u: SpaceVector, v: SpaceVector) -> SpaceVector:
    return u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]


def times(factors: Sequence[Any], point: Sequence[Any]) -> SpaceVector:
    """The products, which are whole numbers."""
    return int(factors[0] * point[0]), int(factors[1] * point[1]), int(factors[2] * point[2])


def heights(normal: SpaceVector, points: Sequence[SpaceVector]) -> list[int]:
    a, b, c = normal
    return [a * x + b * y + c * z for x, y, z in points]


def turn(a: SpaceVector, b: SpaceVector, c: SpaceVector, normal: SpaceVector) -> int:
    """Positive if the way a b c turns left, seen against the normal."""
    u, v = ((q[0] - p[0], q[1] - p[1], q[2] - p[2]) for p, q in ((a, b), (b, c)))
    return dot_in_space(cross_in_space(u, v), normal)


def is_ring(ring: Sequence[int]) -> bool:
    return len(set(ring)) == len(ring) >= 3


def area_and_normal(ring: Sequence[SpaceVector]) -> tuple[SpaceVector, SpaceVector]:
    """Twice the area, as a vector to the side from which the ring runs counter-clockwise; the
    shortest whole vector along it."""
    x, y, z = map(sum, zip(*(cross_in_space(*edge) for edge in edges_of(ring)), strict=True))
    divisor = gcd(x, y, z) or 1
    return (x, y, z), (x // divisor, y // divisor, z // divisor)


def is_closed(rings: Sequence[list[int]]) -> bool:
    """Whether each directed edge is in one ring only, and its reverse in one."""
    edges = [edge for ring in rings for edge in edges_of(ring)]
    there = set(edges)
    return len(there) == len(edges) and all((b, a) in there for a, b in edges)


def hull_in_plane(points: Sequence[SpaceVector], normal: SpaceVector) -> list[SpaceVector]:
    """The corners of the hull of points in a plane, in which lexicographic order is a sweep."""
    both: list[SpaceVector] = []
    for run in (sorted(points), sorted(points, reverse=True)):
        chain: list[SpaceVector] = []
        for p in run:
            while len(chain) > 1 and turn(chain[-2], chain[-1], p, normal) <= 0:
                chain.pop()
            chain.append(p)
        both += chain[:-1]
    return both


class Body:
    """A polyhedron, its vertices and faces in the order of the file."""

    def __init__(self, value: Json, name: str) -> None:
        self.name, (vertices, faces) = name, members(value, "vertices faces")
        self.exact = [space_vector(vertex) for vertex in items(vertices)]
        self.faces = [indices(face, len(self.exact)) for face in items(faces)]
        rings = bool(self.faces) and all(map(is_ring, self.faces))
        require(rings, f"{name} has a face that is no ring, or none")
        used = len(set(itertools.chain(*self.faces))) == len(self.exact)
        require(used, f"{name} has a vertex in no face")

    def plain(self) -> Json:
        """The value that is hashed, with numbers in lowest terms."""
        return {"faces": self.faces, "vertices": [[str(c) for c in point] for point in self.exact]}

    def check(self, unit: int, budget: Budget) -> None:
        """Whether the faces go once around the convex hull of the vertices."""
        self.points = [times((unit, unit, unit), point) for point in self.exact]
        require(len(set(self.points)) == len(self.points), f"{self.name} has a point twice")
        require(is_closed(self.faces), f"{self.name} is not closed")
        first, covered, at_top = (0, 0, 0), 0, self.points
        for i, face in enumerate(self.faces):
            with within(f"{self.name}, face {i}"):
                area, normal = area_and_normal([self.points[k] for k in face])
                require(any(area), "it has no area")
                budget.spend(len(self.points))
                levels = heights(normal, self.points)
                require(len({levels[k] for k in face}) == 1, "it is not planar")
                require(levels[face[0]] == max(levels), "a vertex lies above its plane")
                if i == 0:
                    require(min(levels) < max(levels), "all vertices lie in its plane")
                    first, at_top = normal, [self.points[k] for k in greatest(levels)]
                covered += dot_in_space(area, first) if normal == first else 0
        once = dot_in_space(area_and_normal(hull_in_plane(at_top, first))[0], first)
        require(covered == once, f"{self.name} goes around its hull more than once")


def greatest(levels: list[int]) -> list[int]:
    """Where the greatest ones are."""
    most = max(levels)
    return [i for i, level in enumerate(levels) if level == most]


class ConvexSum:
    """The sum at a scaling: a closed surface, each vertex S p + q, each facet in a plane that P and
    Q, where they are farthest along its normal, reach together."""

    def __init__(self, value: Json, P: Body, Q: Body, unit: int, budget: Budget) -> None:
        scaling, vertices, facets = members(value, "scaling vertices facets")
        self.scaling = space_vector(scaling)
        require(min(self.scaling) > 0, "a factor of the scaling is not positive")
        pairs = [items(pair, 2) for pair in items(vertices)]
        for p, q in pairs:
            indices([p], len(P.exact)), indices([q], len(Q.exact))
        ends = len(pairs), len(P.exact), len(Q.exact)
        parts = [list(map(indices, items(facet, 3), ends)) for facet in items(facets)]
        self.rings = [ring for ring, _, _ in parts]
        rings = bool(parts) and all(map(is_ring, self.rings))
        require(rings, "a facet is no ring, or there is none")
        begin = all(ring[0] == min(ring) for ring in self.rings)
        require(begin, "a facet does not begin with its least vertex")
        require(self.rings == sorted(self.rings), "the facets do not ascend")
        require(len(set(itertools.chain(*self.rings))) == len(pairs), "a vertex is in no facet")
        budget.spend(sum(ends))
        common = lcm(*(factor.denominator for factor in self.scaling))
        self.unit = unit * common
        self.P = [times([common * factor for factor in self.scaling], p) for p in P.points]
        self.Q = [times((common, common, common), q) for q in Q.points]
        sums = (zip(self.P[p], self.Q[q], strict=True) for p, q in pairs)
        self.points = [(a + d, b + e, c + f) for (a, d), (b, e), (c, f) in sums]
        demand(self.points == sorted(set(self.points)), "the vertices do not ascend")
        demand(is_closed(self.rings), "the facets are not closed")
        self.normals: set[SpaceVector] = set()
        self.sextuple = 0  # of the volume
        for i, part in enumerate(parts):
            with within(f"facet {i}"):
                budget.spend(len(P.points) + len(Q.points))
                self.check_facet(*part)

    def check_facet(self, ring: list[int], of_P: list[int], of_Q: list[int]) -> None:
        corners = [self.points[i] for i in ring]
        area, normal = area_and_normal(corners)
        demand(any(area), "it has no area")
        demand(normal not in self.normals, "another facet has its normal")
        self.normals.add(normal)
        level = dot_in_space(normal, corners[0])
        demand(set(heights(normal, corners)) == {level}, "it is not planar")
        ways = zip(corners, corners[1:] + corners[:1], corners[2:] + corners[:2], strict=True)
        demand(all(turn(*way, normal) > 0 for way in ways), "it does not turn left")
        levels = heights(normal, self.P), heights(normal, self.Q)
        demand(sum(map(max, levels)) == level, "the sum reaches beyond its plane")
        demand([of_P, of_Q] == [*map(greatest, levels)], "other vertices of P or Q are farthest")
        self.sextuple += dot_in_space(area, corners[0])

    def check_claim(self, claim: list[Json]) -> str:
        """Checks a claim and returns its text."""
        scaling, vertices, facets, volume, digest = claim
        demand(space_vector(scaling) == self.scaling, "the sum is at another scaling")
        counts = [integer(vertices), integer(facets)] == [len(self.points), len(self.rings)]
        demand(counts, "vertices or facets are not so many")
        found = Fraction(self.sextuple, 6 * self.unit**3)
        demand(number(volume) == found, "the volume is another")
        plain = [[str(Fraction(c, self.unit)) for c in point] for point in self.points]
        same = digest_of({"faces": self.rings, "vertices": plain}) == digest
        demand(same, "the digest is another")
        at = ", ".join(map(str, self.scaling))
        return f"sum: at ({at}), {vertices} vertices, {facets} facets, volume {found}, {digest}"


def bodies_of(case: Json, digest: Json) -> list[Body]:
    require(case.get("dimension") == 3, "this is no case in space")
    bodies = [Body(case.get(operand), operand) for operand in "PQ"]
    plain = {body.name: body.plain() for body in bodies}
    demand(digest_of(plain) == digest, "not the case that is certified")
    return bodies


def of_convex_bodies(
    case: Json, digest: Json, entries: Json, claims: Json, budget: Budget
) -> list[str]:
    P, Q = bodies_of(case, digest)
    unit = budget.common(P.exact + Q.exact)
    for operand in (P, Q):
        operand.check(unit, budget)
    sums: list[ConvexSum] = []
    for entry in items(entries):
        with within(f"sum {len(sums)}"):
            sums.append(ConvexSum(entry, P, Q, unit, budget))
    return said_of(sums, claims, "vertices facets volume digest", budget)


def said_of(sums: Sequence[Any], claims: Json, names: str, budget: Budget) -> list[str]:
    """Checks claims about sums in space; returns them as texts."""
    require(len({one.scaling for one in sums}) == len(sums), "two sums are at one scaling")
    require(len(set(map(digest_of, items(claims)))) == len(claims), "a claim is made twice")
    said: list[str] = []
    used: set[int] = set()
    for claim in claims:
        with within(f"claim {len(said)}"):
            budget.spend(64)
            kind, i, *more = members(claim, f"claim sum scaling {names}")
            require(kind == "sum", f"there is no claim {kind!r}")
            used |= {*indices([i], len(sums))}
            said.append(sums[i].check_claim(more))
    require(bool(said) and len(used) == len(sums), "nothing is claimed, or a sum is not used")
    return said


FORMS["convex-certificate-v1"] = "sums", of_convex_bodies


# Part 5: solids of any shape, as unions of convex pieces. Needs parts 2 and 4.

MOST_PAIRS = 20_000  # of pieces of solids
AXES = ((1, 0, 0), (-1, 0, 0), (0, 1, 0), (0, -1, 0), (0, 0, 1), (0, 0, -1))
Homogeneous = tuple[int, int, int, int]  # the point (x / w, y / w, z / w), w > 0
HalfSpace = tuple[SpaceVector, int]  # normal * x <= height
Feature = tuple[SpaceVector, ...]  # the corners of a corner, an edge or a facet of a piece
Tiles = dict[HalfSpace, list[list[Homogeneous]]]  # convex parts of faces, by oriented planes
MORE: dict[str, Callable[[Tiles, list[Json], Budget], str]] = {}  # checks of members in part 5c


def minus(a: SpaceVector, b: SpaceVector) -> SpaceVector:
    return a[0] - b[0], a[1] - b[1], a[2] - b[2]


def plus(a: SpaceVector, b: SpaceVector) -> SpaceVector:
    return a[0] + b[0], a[1] + b[1], a[2] + b[2]


def negative(a: SpaceVector) -> SpaceVector:
    return -a[0], -a[1], -a[2]


def shortest(a: SpaceVector) -> SpaceVector:
    divisor = gcd(*a) or 1
    return a[0] // divisor, a[1] // divisor, a[2] // divisor


def below(polygon: list[Homogeneous], half: HalfSpace, budget: Budget) -> list[Homogeneous]:
    """The part below a plane of a convex polygon with an area: nothing if the part has no area; all
    of the polygon where it lies in the plane."""
    budget.spend(len(polygon))
    (a, b, c), height = half
    levels = [a * x + b * y + c * z - height * w for x, y, z, w in polygon]
    if max(levels) <= 0:
        return polygon
    if min(levels) >= 0:
        return []
    kept: list[Homogeneous] = []
    for k, end in enumerate(polygon):
        s, e = levels[k - 1], levels[k]
        if (s < 0 < e) or (e < 0 < s):
            x, y, z, w = (abs(e) * p + abs(s) * q for p, q in zip(polygon[k - 1], end, strict=True))
            divisor = gcd(x, y, z, w)
            kept.append((x // divisor, y // divisor, z // divisor, w // divisor))
        if e <= 0:
            kept.append(end)
    return kept


class Hull:
    """The convex hull of points, each of which is one of its corners."""

    def __init__(self, points: list[SpaceVector], budget: Budget) -> None:
        self.points = points
        require(len(set(points)) == len(points) > 3, "a point is there twice, or there are under 4")
        self.facets: dict[SpaceVector, list[SpaceVector]] = {}  # counter-clockwise, by the normal
        for a, b, c in itertools.combinations(points, 3):
            budget.spend(len(points))
            n = shortest(cross_in_space(minus(b, a), minus(c, a)))
            if not any(n):
                continue
            levels, level = heights(n, points), dot_in_space(n, a)
            require(min(levels) < max(levels), "its points lie in a plane")
            if level not in (min(levels), max(levels)):
                continue
            n = n if level == max(levels) else negative(n)
            if n not in self.facets:
                at = [p for p, height in zip(points, levels, strict=True) if height == level]
                self.facets[n] = hull_in_plane(at, n)
        corners = {p for ring in self.facets.values() for p in ring}
        require(len(corners) == len(points), "one of its points is no corner")
        self.edges = {tuple(sorted(e)) for ring in self.facets.values() for e in edges_of(ring)}
        self.ways = sorted({shortest(minus(q, p)) for p, q in self.edges})

    def support(self, n: SpaceVector) -> int:
        return max(heights(n, self.points))

    def holds(self, p: SpaceVector) -> bool:
        return all(dot_in_space(n, p) <= dot_in_space(n, r[0]) for n, r in self.facets.items())


class PiecesInSpace:
    """Convex pieces of an operand, scaled: hulls, and their corners, edges and facets, each with
    the hulls that hold it."""

    def __init__(self, corners: list[list[SpaceVector]], budget: Budget) -> None:
        self.hulls = [Hull(points, budget) for points in corners]
        holders: dict[SpaceVector, frozenset[int]] = {}
        for p in itertools.chain(*corners):
            if p not in holders:
                budget.spend(len(self.hulls))
                holders[p] = frozenset(k for k, hull in enumerate(self.hulls) if hull.holds(p))
        self.features: dict[Feature, frozenset[int]] = {}
        for hull in self.hulls:
            rings = [tuple(sorted(ring)) for ring in hull.facets.values()]
            for feature in (*((p,) for p in hull.points), *hull.edges, *rings):
                self.features[feature] = frozenset.intersection(*(holders[p] for p in feature))
        self.normals = {n for hull in self.hulls for n in hull.facets}
        self.edges = [
            (feature, {p for k in held for p in self.hulls[k].points})
            for feature, held in self.features.items()
            if len(feature) == 2
        ]

    def supports(self, n: SpaceVector) -> list[int]:
        return [hull.support(n) for hull in self.hulls]

    def tops(self, n: SpaceVector, budget: Budget) -> list[tuple[Feature, int]]:
        """The features that are level along a normal, with their heights, such that no hull that
        holds one reaches above it."""
        budget.spend(len(self.features))
        supports, found = self.supports(n), []
        for feature, holders in self.features.items():
            level = dot_in_space(n, feature[0])
            if all(dot_in_space(n, p) == level for p in feature[1:]):
                if all(supports[k] <= level for k in holders):
                    found.append((feature, level))
        return found


def read_pieces(value: Json, body: Body) -> tuple[list[SpacePoint], list[list[int]]]:
    """The vertices of the operand and what is added to them; the corners of each piece."""
    points, hulls = members(value, "points hulls")
    exact = [*body.exact, *map(space_vector, items(points))]
    found = [indices(entry, len(exact)) for entry in items(hulls)]
    require(bool(found), f"{body.name} has no pieces")
    require(all(one == sorted(set(one)) for one in found), "the points of a piece do not ascend")
    added = set(itertools.chain(*found)) >= set(range(len(body.exact), len(exact)))
    require(added, "a point is in no piece")
    return exact, found


def check_pieces(body: Body, pieces: list[Hull], budget: Budget) -> None:
    """Demands that the facets of the pieces, less the faces of the operand, cancel: in each plane,
    on each of its lines, each point is the start of as many edges as it is the end of."""
    ends: Counter[Any] = Counter()

    def count(normal: SpaceVector, ring: Sequence[SpaceVector], times_: int) -> None:
        budget.spend(len(ring))
        plane = max(normal, negative(normal))
        for a, b in edges_of(ring):
            way = shortest(minus(b, a))
            way = max(way, negative(way))
            line = plane, dot_in_space(plane, a), way, cross_in_space(way, a)
            ends[line, b] += times_
            ends[line, a] -= times_

    for piece in pieces:
        for normal, ring in piece.facets.items():
            count(normal, ring, 1)
    for i, face in enumerate(body.faces):
        with within(f"{body.name}, face {i}"):
            ring = [body.points[k] for k in face]
            area, normal = area_and_normal(ring)
            require(any(area), "it has no area")
            require(len(set(heights(normal, ring))) == 1, "it is not planar")
            count(normal, ring, -1)
    demand(not any(ends.values()), f"the pieces of {body.name} do not tile it")


class SolidSum:
    """The sum at a scaling, plane by plane: in each plane that may have a part of the boundary, a
    polygon that holds it is cut, and each part is said to be a face or not."""

    def __init__(
        self, value: Json, unit: int, points: list[list[SpaceVector]],
        hulls: list[list[list[int]]], budget: Budget,
    ) -> None:  # fmt: skip
        scaling, planes = members(value, "scaling planes")
        self.scaling, self.budget = space_vector(scaling), budget
        require(min(self.scaling) > 0, "a factor of the scaling is not positive")
        common = lcm(*(factor.denominator for factor in self.scaling))
        self.unit = unit * common
        factors = [common * factor for factor in self.scaling], (common, common, common)
        scaled = [[times(by, p) for p in of] for by, of in zip(factors, points, strict=True)]
        self.P, self.Q = (
            PiecesInSpace([[at[i] for i in one] for one in of], budget)
            for at, of in zip(scaled, hulls, strict=True)
        )
        self._bounds: dict[tuple[int, int], list[HalfSpace]] = {}
        self.faces: Tiles = {}
        found = self.find_planes()
        entries = [items(entry, 3) for entry in items(planes)]
        demand(len(entries) == len(found), "there are more planes, or fewer")
        for n, (plane, corners) in enumerate(sorted(found.items())):
            with within(f"plane {n}"):
                normal, offset, tree = entries[n]
                here = [integer(c) for c in items(normal, 3)] == [*plane[0]]
                demand(here and number(offset) * self.unit == plane[1], "another is expected")
                ring = hull_in_plane(list(corners), plane[0])
                self.follow(plane, [(x, y, z, 1) for x, y, z in ring], items(tree))

    def find_planes(self) -> dict[tuple[SpaceVector, int], set[SpaceVector]]:
        """The oriented planes in which the boundary may have an area, and the corners of what it
        has there at most: sums of two features, each a top along the normal."""
        planes: dict[tuple[SpaceVector, int], set[SpaceVector]] = defaultdict(set)
        P, Q, budget = self.P, self.Q, self.budget
        for n in P.normals | Q.normals:
            tops = Q.tops(n, budget)
            for one, height in P.tops(n, budget):
                budget.spend(len(tops))
                for other, level in tops:
                    if len(one) > 2 or len(other) > 2:
                        budget.spend(len(one) * len(other))
                        sums = (plus(p, q) for p in one for q in other)
                        planes[n, height + level].update(sums)
        for e, near_e in P.edges:
            for f, near_f in Q.edges:
                budget.spend(1)
                way = shortest(cross_in_space(minus(e[1], e[0]), minus(f[1], f[0])))
                for n in (way, negative(way)) if any(way) else ():
                    height, level = dot_in_space(n, e[0]), dot_in_space(n, f[0])
                    if all(dot_in_space(n, p) <= height for p in near_e):
                        if all(dot_in_space(n, p) <= level for p in near_f):
                            planes[n, height + level].update(plus(p, q) for p in e for q in f)
        return planes

    def bounds(self, pair: tuple[int, int]) -> list[HalfSpace]:
        """The half-spaces whose intersection the sum of two pieces is; those of its box first."""
        if pair not in self._bounds:
            A, B = self.P.hulls[pair[0]], self.Q.hulls[pair[1]]
            others = {*A.facets, *B.facets}
            ways = (shortest(cross_in_space(e, f)) for e in A.ways for f in B.ways)
            others |= {n for way in ways if any(way) for n in (way, negative(way))}
            normals = [*AXES, *sorted(others - {*AXES})]
            self.budget.spend(len(normals) * (len(A.points) + len(B.points)))
            self._bounds[pair] = [(n, A.support(n) + B.support(n)) for n in normals]
        return self._bounds[pair]

    def follow(
        self, plane: tuple[SpaceVector, int], whole: list[Homogeneous], tree: list[Json]
    ) -> None:
        normal, level = plane
        top_of_P, top_of_Q = self.P.supports(normal), self.Q.supports(normal)
        low_of_P, low_of_Q = (of.supports(negative(normal)) for of in (self.P, self.Q))
        pairs = list(itertools.product(range(len(top_of_P)), range(len(top_of_Q))))
        self.budget.spend(len(pairs))
        tops = {(i, j): top_of_P[i] + top_of_Q[j] for i, j in pairs}
        lows = {(i, j): -low_of_P[i] - low_of_Q[j] for i, j in pairs}
        above = [pair for pair in pairs if lows[pair] <= level < tops[pair]]
        beneath = [pair for pair in pairs if lows[pair] < level <= tops[pair]]

        def is_free(polygon: list[Homogeneous], of: list[tuple[int, int]]) -> bool:
            return not any(self.meets(polygon, pair) for pair in of)

        stack = [whole]
        for k, entry in enumerate(tree):
            with within(f"entry {k}"):
                kind, rest = headed(entry)
                require(bool(stack), "nothing is left to be cut")
                polygon = stack.pop()
                if kind == "cut":
                    a, b, c, d = map(integer, items(rest, 4))
                    height = d * self.unit
                    other = below(polygon, ((-a, -b, -c), -height), self.budget)
                    part = below(polygon, ((a, b, c), height), self.budget)
                    demand(bool(part) and bool(other) and part is not polygon, "it does not cut")
                    stack += [other, part]
                elif kind == "none":
                    items(rest, 0)
                    demand(is_free(polygon, beneath), "a sum of two pieces is below it")
                else:
                    require(kind in ("above", "face"), f"there is no entry {str(kind)[:60]!r}")
                    i, j = items(rest, 2)
                    pair = index(i, len(self.P.hulls)), index(j, len(self.Q.hulls))
                    inside = all(below(polygon, half, self.budget) is polygon
                                 for half in self.bounds(pair))  # fmt: skip
                    demand(inside, "it does not lie in the sum of these pieces")
                    if kind == "above":
                        demand(tops[pair] > level, "the sum of these pieces is not above it")
                        continue
                    demand(lows[pair] < level, "the sum of these pieces is not below it")
                    demand(is_free(polygon, above), "a sum of two pieces is above it")
                    self.faces.setdefault(plane, []).append(polygon)
        require(not stack, "entries are missing")

    def meets(self, polygon: list[Homogeneous], pair: tuple[int, int]) -> bool:
        """Whether they have an area in common."""
        for half in self.bounds(pair):
            if not (polygon := below(polygon, half, self.budget)):
                return False
        return True

    def check_claim(self, claim: list[Json]) -> str:
        """Checks a claim and returns its text."""
        scaling, planes, polygons, volume, digest, *numbers = claim
        demand(space_vector(scaling) == self.scaling, "the sum is at another scaling")
        form = CanonicalForm(self.faces, self.unit, self.budget)
        counts = [integer(planes), integer(polygons)] == [len(form.planes), form.polygons]
        demand(counts, "planes or polygons are not so many")
        demand(number(volume) == form.volume, "the volume is another")
        demand(digest_of(form.value()) == digest, "the digest is another")
        told = "".join(checked(self.faces, numbers, self.budget) for checked in MORE.values())
        at = ", ".join(map(str, self.scaling))
        return f"sum: at ({at}), {planes} planes, {told}volume {form.volume}, {digest}"


class CanonicalForm:
    """The form of a set whose boundary is tiled by convex polygons, by their oriented planes."""

    def __init__(self, faces: Tiles, unit: int, budget: Budget) -> None:
        self.budget = budget
        self.planes: list[tuple[SpaceVector, Fraction, list[Rings]]] = []
        triple = Fraction(0)
        for (normal, level), polygons in sorted(faces.items()):
            axis, offset = seen_along(normal), Fraction(level, unit)
            u, v = (k for k in range(3) if k != axis)
            mirrored = (normal[axis] > 0) == (axis == 1)
            tiles: Rings = []
            for polygon in polygons:
                ring = [(Fraction(p[u], p[3] * unit), Fraction(p[v], p[3] * unit)) for p in polygon]
                tiles.append([*ring[:: -1 if mirrored else 1]])
            region = united(tiles, budget)
            self.planes.append((normal, offset, region))
            triple += offset * sum(map(doubled_area, tiles)) / 2 / abs(normal[axis])
        self.volume = triple / 3
        self.polygons = sum(len(region) for _, _, region in self.planes)

    def is_convex(self, corners: list[SpacePoint]) -> bool:
        for (a, b, c), offset, _ in self.planes:
            self.budget.spend(len(corners))
            if any(a * x + b * y + c * z > offset for x, y, z in corners):
                return False
        return True

    def value(self) -> Json:
        """The form as JSON; for a convex polyhedron, faces and vertices."""
        corners = [
            [[lifted(p, normal, offset) for p in ring] for rings in region for ring in rings]
            for normal, offset, region in self.planes
        ]
        points = sorted({p for rings in corners for ring in rings for p in ring})
        if not self.is_convex(points):
            rows = [
                {"normal": [*map(str, normal)], "offset": str(offset), "region": plain(region)}
                for normal, offset, region in self.planes
            ]
            return {"planes": rows}
        place = {point: i for i, point in enumerate(points)}
        faces = []
        for (normal, _, _), (ring,) in zip(self.planes, corners, strict=True):
            axis = seen_along(normal)
            back = (normal[axis] > 0) == (axis == 1)
            face = [place[p] for p in ring[:: -1 if back else 1]]
            least = face.index(min(face))
            faces.append(face[least:] + face[:least])
        return {"faces": sorted(faces), "vertices": [[*map(str, point)] for point in points]}


def seen_along(normal: SpaceVector) -> int:
    return next(k for k in range(3) if normal[k])


def lifted(point: Vertex, normal: SpaceVector, offset: Fraction) -> SpacePoint:
    """The point of a plane that is seen there along the first axis in which it has a normal."""
    axis = seen_along(normal)
    u, v = (k for k in range(3) if k != axis)
    rest = (offset - normal[u] * point[0] - normal[v] * point[1]) / normal[axis]
    place = [*point[:axis], rest, *point[axis:]]
    return place[0], place[1], place[2]


def united(tiles: Rings, budget: Budget) -> list[Rings]:
    """The canonical form of the union of convex polygons, counter-clockwise, that do not overlap:
    for each component of its interior the outer ring and the holes."""
    lines: dict[Any, list[tuple[Vertex, Vertex, int]]] = defaultdict(list)
    for n, tile in enumerate(tiles):
        for a, b in edges_of(tile):
            lines[line_of(a, b)].append((a, b, n))
    root, sides = list(range(len(tiles))), []
    for edges in lines.values():
        stops = sorted({p for a, b, _ in edges for p in (a, b)})
        budget.spend(len(stops) * len(edges))
        for low, high in itertools.pairwise(stops):
            left = [n for a, b, n in edges if a <= low and high <= b]
            right = [n for a, b, n in edges if b <= low and high <= a]
            if left and right:
                root[find(root, left[0])] = find(root, right[0])
            elif left or right:
                sides.append((low, high, left[0]) if left else (high, low, right[0]))
    sides = cut_at_ends(sides, budget)
    leaving: dict[Vertex, list[tuple[Vertex, Vertex, int]]] = defaultdict(list)
    for side in sides:
        leaving[side[0]].append(side)
    found: dict[int, Rings] = defaultdict(list)
    done: set[tuple[Vertex, Vertex]] = set()
    for first in sides:
        walk: list[Vertex] = []
        side = first
        while side[:2] not in done:
            done.add(side[:2])
            walk.append(side[0])
            budget.spend(len(leaving[side[1]]))
            side = next_side(side, leaving[side[1]])
        for ring in simple_rings(walk):
            found[find(root, side[2])].append(ring)
    polygons = []
    for rings in found.values():
        outer = [ring for ring in rings if doubled_area(ring) > 0]
        demand(len(outer) == 1, "a component has not one outer ring")
        polygons.append([*outer, *sorted(ring for ring in rings if doubled_area(ring) < 0)])
    return sorted(polygons)


def line_of(a: Vertex, b: Vertex) -> tuple[Any, ...]:
    if a[0] == b[0]:
        return (a[0],)
    slope = (b[1] - a[1]) / (b[0] - a[0])
    return slope, a[1] - slope * a[0]


def cut_at_ends(
    sides: list[tuple[Vertex, Vertex, int]], budget: Budget
) -> list[tuple[Vertex, Vertex, int]]:
    """Sides cut where others begin in their insides: the boundary touches itself there."""
    ends: dict[Any, list[Vertex]] = defaultdict(list)
    starts = sorted({a for a, _, _ in sides})
    for line in {line_of(a, b) for a, b, _ in sides}:
        budget.spend(len(starts))
        ends[line] = [p for p in starts if (
            p[0] == line[0] if len(line) == 1 else p[1] == line[0] * p[0] + line[1]
        )]  # fmt: skip
    cut = []
    for a, b, n in sides:
        inside = [p for p in ends[line_of(a, b)] if min(a, b) < p < max(a, b)]
        stops = [a, *(inside if a < b else inside[::-1]), b]
        cut += [(p, q, n) for p, q in itertools.pairwise(stops)]
    return cut


def next_side(
    side: tuple[Vertex, Vertex, int], leaving: list[tuple[Vertex, Vertex, int]]
) -> tuple[Vertex, Vertex, int]:
    """The first clockwise from where a side came: both bound one wedge of the interior."""
    back = side[0][0] - side[1][0], side[0][1] - side[1][1]
    best, at_best, half_best = side, back, 9
    for other in leaving:
        way = other[1][0] - other[0][0], other[1][1] - other[0][1]
        turned = cross(back, way)
        half = 0 if turned < 0 else 1 if turned == 0 else 2
        if half < half_best or (half == half_best and cross(at_best, way) > 0):
            best, at_best, half_best = other, way, half
    return best


def simple_rings(walk: list[Vertex]) -> Iterator[list[Vertex]]:
    """A closed walk, split where it comes to a point again; without the points where it goes
    straight on."""
    ring: list[Vertex] = []
    place: dict[Vertex, int] = {}
    for point in [*walk, *walk[:1]]:
        if point in place:
            at = place[point]
            yield in_order(ring[at:])
            for passed in ring[at:]:
                del place[passed]
            del ring[at:]
        place[point] = len(ring)
        ring.append(point)


def in_order(ring: list[Vertex]) -> list[Vertex]:
    """From its least corner."""
    n = len(ring)
    ways = [(b[0] - a[0], b[1] - a[1]) for a, b in edges_of(ring)]
    corners = [ring[k] for k in range(n) if cross(ways[k - 1], ways[k]) != 0]
    least = corners.index(min(corners))
    return corners[least:] + corners[:least]


def tiled(case: Json, digest: Json, parts: list[Json], budget: Budget) -> tuple[Any, ...]:
    """The unit that makes coordinates whole, and for both operands: the points, the numbers of the
    corners of each piece, and the pieces."""
    bodies = bodies_of(case, digest)
    exact, hulls = zip(*map(read_pieces, parts, bodies), strict=True)
    demand(len(hulls[0]) * len(hulls[1]) <= MOST_PAIRS, "too many pairs of pieces", OUT_OF_BUDGET)
    unit, found = budget.common([*itertools.chain(*exact)]), []
    points = [[times((unit, unit, unit), p) for p in of] for of in exact]
    for body, at, pieces in zip(bodies, points, hulls, strict=True):
        body.points = at[: len(body.exact)]
        with within(f"the pieces of {body.name}"):
            found.append([Hull([at[i] for i in one], budget) for one in pieces])
            check_pieces(body, found[-1], budget)
    return unit, points, list(hulls), found


def of_solids(case: Json, digest: Json, proof: Json, claims: Json, budget: Budget) -> list[str]:
    *parts, entries = members(proof, "P Q sums")
    unit, points, hulls, _ = tiled(case, digest, parts, budget)
    sums: list[SolidSum] = []
    for entry in items(entries):
        with within(f"sum {len(sums)}"):
            sums.append(SolidSum(entry, unit, points, hulls, budget))
    return said_of(sums, claims, " ".join(["planes polygons volume digest", *MORE]), budget)


FORMS["solid-certificate-v1"] = "proof", of_solids


# Part 5b: single points and sums of solids, piece by piece. Needs part 5.

Solids = list[list[Hull]]  # the pieces of P and of Q


def scaling_of(value: Json) -> SpacePoint:
    require(min(space_vector(value)) > 0, "a factor of the scaling is not positive")
    return space_vector(value)


def product(factors: Sequence[Any], point: Sequence[Any]) -> Any:
    return tuple(a * b for a, b in zip(factors, point, strict=True))


def check_point(claim: Json, solids: Solids, unit: int, budget: Budget) -> str:
    """A point of the sum: S p + q, p in a piece of P and q in one of Q."""
    scaling, point, p, q, nodes = members(claim, "claim scaling point p q pieces")[1:]
    parts = space_vector(p), space_vector(q)
    made = zip(product(scaling_of(scaling), parts[0]), parts[1], strict=True)
    demand(space_vector(point) == tuple(a + b for a, b in made), "S p + q is another point")
    for name, part, node, pieces in zip("PQ", parts, items(nodes, 2), solids, strict=True):
        piece = pieces[index(node, len(pieces))]
        budget.spend(len(piece.facets))
        demand(piece.holds(product((unit,) * 3, part)), f"{part} is not in piece {node} of {name}")
    return f"point: {point} at {scaling}"


def check_outside(claim: Json, solids: Solids, unit: int, budget: Budget) -> str:
    """A point outside the sum: a normal for each pair of pieces holds the point apart."""
    scaling, point, normals, code = members(claim, "claim scaling point normals code")[1:]
    factors, x = scaling_of(scaling), product((unit,) * 3, space_vector(point))
    ways: Any = [tuple(map(integer, items(normal, 3))) for normal in items(normals)]
    pairs = list(itertools.product(*solids))
    numbers = indices(items(code, len(pairs)), len(ways))
    require(all(map(any, ways)) and len({*numbers}) == len(ways), "a normal is 0, or not used")
    for (A, B), n in zip(pairs, (ways[k] for k in numbers), strict=True):
        budget.spend(len(A.points) + len(B.points))
        most = A.support(product(factors, n)) + B.support(n)
        demand(dot_in_space(n, x) > most, f"normal {n} does not hold the point apart")
    return f"outside: {point} at {scaling}"


def of_points(case: Json, digest: Json, proof: Json, claims: Json, budget: Budget) -> list[str]:
    unit, _, _, solids = tiled(case, digest, members(proof, "P Q"), budget)
    kinds = {"point": check_point, "outside": check_outside}
    require(len(set(map(digest_of, items(claims)))) == len(claims) > 0, "a claim is made twice")
    said: list[str] = []
    for claim in claims:
        with within(f"claim {len(said)}"):
            budget.spend(64)
            kind = str(claim.get("claim") if isinstance(claim, dict) else None)
            require(kind in kinds, f"there is no claim {kind!r}")
            said.append(kinds[kind](claim, solids, unit, budget))
    return said


FORMS["solid-point-certificate-v1"] = "proof", of_points


# Part 5c: components, cavities and tunnels of sums of solids. Needs part 5.

Box = tuple[list[int], list[int]]  # whole numbers not above, and not below, the coordinates
Line = tuple[SpaceVector, Homogeneous]  # a direction, and its cross product with a point


def on_plane(polygon: list[Homogeneous], plane: HalfSpace) -> tuple[list[int], list[Homogeneous]]:
    """The corners' levels above a plane; the polygon's points there: none, one, or both ends of a
    segment."""
    (a, b, c), height = plane
    levels = [a * x + b * y + c * z - height * w for x, y, z, w in polygon]
    points = []
    for k, end in enumerate(polygon):
        s, e = levels[k - 1], levels[k]
        if (s < 0 < e) or (e < 0 < s):
            x, y, z, w = (abs(e) * p + abs(s) * q for p, q in zip(polygon[k - 1], end, strict=True))
            points.append((x, y, z, w))
        elif e == 0:
            points.append(end)
    return levels, points


def share_a_segment(ends: list[list[Homogeneous]], way: SpaceVector) -> bool:
    """Whether two segments on a line along a vector have more than a point in common."""
    places = [[Fraction(dot_in_space(way, p[:3]), p[3]) for p in of] for of in ends]
    return max(map(min, places)) < min(map(max, places))


def box_of(polygon: list[Homogeneous]) -> Box:
    low = [min(p[k] // p[3] for p in polygon) for k in range(3)]
    return low, [max(-(-p[k] // p[3]) for p in polygon) for k in range(3)]


class Shells:
    """The boundary of a solid, cut until its convex parts meet along whole sides, or at points; and
    the closed surfaces to which these are joined."""

    def __init__(self, faces: Tiles, budget: Budget) -> None:
        self.budget = budget
        whole = [(plane, polygon) for plane in sorted(faces) for polygon in faces[plane]]
        self.parts = [
            (plane, part)
            for (plane, polygon), cuts in zip(whole, self.find_cuts(whole), strict=True)
            for part in self.cut(polygon, cuts)
        ]
        self.find_sides()

    def find_cuts(self, whole: list[tuple[HalfSpace, list[Homogeneous]]]) -> list[set[HalfSpace]]:
        """For each part, the planes of others that share a segment with its inside."""
        boxes = [box_of(polygon) for _, polygon in whole]
        order = sorted(range(len(whole)), key=lambda i: boxes[i][0][0])
        cuts: list[set[HalfSpace]] = [set() for _ in whole]
        for n, i in enumerate(order):
            for j in order[n + 1 :]:
                if boxes[j][0][0] > boxes[i][1][0]:
                    break
                self.budget.spend(1)
                apart = any(
                    boxes[i][0][k] > boxes[j][1][k] or boxes[j][0][k] > boxes[i][1][k]
                    for k in (1, 2)
                )
                if not apart:
                    self.add_cuts(whole, cuts, i, j)
        return cuts

    def add_cuts(
        self, whole: list[tuple[HalfSpace, list[Homogeneous]]], cuts: list[set[HalfSpace]],
        i: int, j: int,
    ) -> None:  # fmt: skip
        (one, A), (other, B) = whole[i], whole[j]
        way = cross_in_space(one[0], other[0])
        if not any(way):
            return
        self.budget.spend(len(A) + len(B))
        (of_A, on_A), (of_B, on_B) = on_plane(A, other), on_plane(B, one)
        if len(on_A) > 1 and len(on_B) > 1 and share_a_segment([on_A, on_B], way):
            for k, levels, plane in ((i, of_A, other), (j, of_B, one)):
                if min(levels) < 0 < max(levels):
                    cuts[k].add(max(plane, (negative(plane[0]), -plane[1])))

    def cut(self, polygon: list[Homogeneous], planes: set[HalfSpace]) -> list[list[Homogeneous]]:
        parts = [polygon]
        for normal, height in sorted(planes):
            sides = (normal, height), (negative(normal), -height)
            cut = [below(part, side, self.budget) for part in parts for side in sides]
            parts = [part for part in cut if part]
        return parts

    def find_sides(self) -> None:
        """Numbers all sides of parts, cut where others on their lines end: `next` of each along its
        part, and `mates`, across the inside of the solid and across its outside."""
        on: dict[Line, list[tuple[int, int, Homogeneous, Homogeneous]]] = defaultdict(list)
        rows: list[list[tuple[Line, Homogeneous, Homogeneous]]] = []
        for n, (_, part) in enumerate(self.parts):
            rows.append([(line_through(a, b), a, b) for a, b in edges_of(part)])
            for k, (line, a, b) in enumerate(rows[-1]):
                on[line].append((n, k, a, b))
        place: dict[tuple[Line, Homogeneous], int] = {}
        for line, sides in on.items():
            stops = {p for side in sides for p in side[2:]}
            along = sorted(stops, key=lambda p: Fraction(dot_in_space(line[0], p[:3]), p[3]))
            place.update(((line, p), k) for k, p in enumerate(along))
        around: dict[tuple[Line, int], list[tuple[int, int]]] = defaultdict(list)
        self.of: list[int] = []  # the part of each side
        self.next: list[int] = []
        for n, row in enumerate(rows):
            first = len(self.of)
            for line, a, b in row:
                i, j = place[line, a], place[line, b]
                self.budget.spend(abs(j - i))
                for k in range(i, j) if i < j else range(i - 1, j - 1, -1):
                    around[line, k].append((len(self.of), 1 if i < j else -1))
                    self.of.append(n)
            self.next += [*range(first + 1, len(self.of)), first]
        self.mates = [0] * len(self.of), [0] * len(self.of)
        for (line, _), joined in around.items():
            self.join(line[0], joined)

    def join(self, way: SpaceVector, sides: list[tuple[int, int]]) -> None:
        """Joins the parts around a segment. Seen against its direction the outside is to the left
        of a part that runs along it, and the inside to the left of one that runs back."""
        inward = [self.inward(way, *side) for side in sides]
        along = inward[0]
        across = cross_in_space(way, along)
        turns = [turned_by(dot_in_space(v, along), dot_in_space(v, across)) for v in inward]
        order = [side for _, side in sorted(zip(turns, sides, strict=True))]
        for (h, sign), (other, back) in edges_of(order):
            demand(sign != back, "faces do not bound the sum")
            mates = self.mates[sign > 0]
            mates[h], mates[other] = other, h

    def inward(self, way: SpaceVector, side: int, sign: int) -> SpaceVector:
        v = cross_in_space(self.parts[self.of[side]][0][0], way)
        return v if sign > 0 else negative(v)

    def surfaces(self, mates: list[int]) -> list[tuple[int, bool]]:
        """The genus of each surface, and whether it bounds a volume above zero."""
        root = list(range(len(self.parts)))
        for h, other in enumerate(mates):
            root[find(root, self.of[h])] = find(root, self.of[other])
        shells = [find(root, n) for n in range(len(root))]
        doubled = Counter[int]()  # of the Euler characteristics
        volumes: dict[int, list[Fraction]] = defaultdict(list)
        for shell, part in zip(shells, self.parts, strict=True):
            doubled[shell] += 2
            volumes[shell].append(cone(*part))
        done = [False] * len(mates)
        for start in range(len(mates)):
            doubled[shells[self.of[start]]] -= 1
            if not done[start]:
                doubled[shells[self.of[start]]] += 2
            h = start
            while not done[h]:
                done[h], h = True, self.next[mates[h]]
        found = []
        for shell, twice in doubled.items():
            demand(twice % 4 == 0 and twice <= 4, "faces do not bound the sum")
            found.append(((4 - twice) // 4, added(volumes[shell]) > 0))
        return found


def line_through(a: Homogeneous, b: Homogeneous) -> Line:
    (x, y, z, w), (p, q, r, t) = a, b
    way = shortest((p * w - x * t, q * w - y * t, r * w - z * t))
    way = max(way, negative(way))
    *moment, w = (*cross_in_space(way, (x, y, z)), w)
    divisor = gcd(*moment, w)
    return way, (moment[0] // divisor, moment[1] // divisor, moment[2] // divisor, w // divisor)


def turned_by(x: int, y: int) -> Fraction:
    """Ascends from 0 with the direction's angle, counter-clockwise from that of x > 0, y = 0."""
    part = Fraction(x, abs(x) + abs(y))
    return 1 - part if y >= 0 else 3 + part


def cone(plane: HalfSpace, part: list[Homogeneous]) -> Fraction:
    """Six times the volume between the origin and a part of a face."""
    normal, height = plane
    axis = seen_along(normal)
    u, v = (axis + 1) % 3, (axis + 2) % 3
    ring = [(Fraction(p[u], p[3]), Fraction(p[v], p[3])) for p in part]
    return Fraction(doubled_area(ring) * height, normal[axis])


def added(values: list[Fraction]) -> Fraction:
    while len(values) > 1:
        values = [sum(values[k : k + 2], Fraction(0)) for k in range(0, len(values), 2)]
    return values[0]


def check_numbers(faces: Tiles, claimed: list[Json], budget: Budget) -> str:
    """Components, cavities and tunnels of the solid with these faces, if they are claimed."""
    if claimed == [None] * 3:
        return ""
    shells = Shells(faces, budget)
    inner, outer = map(shells.surfaces, shells.mates)
    found = [
        sum(is_positive for _, is_positive in inner),
        sum(not is_positive for _, is_positive in outer),
        sum(genus for genus, _ in inner),
    ]
    demand([*map(integer, claimed)] == found, "components, cavities or tunnels are not so many")
    return "{} components, {} cavities, {} tunnels, ".format(*found)


MORE["components? cavities? tunnels?"] = check_numbers


# Part 6: a part R, scaled, that moves along a path in the plane among obstacles O. Needs part 2.

# t, s, w: the part t / w of a segment, the scale s / w; w = 0: far up
Corner = tuple[int, int, int]
Cut = tuple[Any, bool]  # just below a scale; True: just above it


def places(value: Json, place: Callable[[Json], Vertex] = vector) -> list[Vertex]:
    require(bool(items(value)), "a path has no place")
    return list(map(place, value))


def stays(place: Vertex) -> Vertex:
    """A place as one that moves with the scale."""
    return (place[0], Fraction(0), place[1], Fraction(0))


def moving(value: Json) -> Vertex:
    """`["x0", "x1", "y0", "y1"]`; a place that stays has two numbers."""
    return stays(vector(value)) if len(items(value)) == 2 else tuple(map(number, items(value, 4)))


def segments(path: list[Vertex]) -> list[tuple[Vertex, Vertex]]:
    """From each place to the next; a single place gives a segment from it to itself."""
    return list(itertools.pairwise(path)) or [(path[0], path[0])]


def at_corners(f: Triple, cell: list[Corner]) -> list[int]:
    return [f[0] * t + f[1] * s + f[2] * w for t, s, w in cell]


def not_above(f: Triple, cell: list[Corner]) -> list[Corner]:
    """The part of a convex polygon where f <= 0."""
    levels = at_corners(f, cell)
    kept: list[Corner] = []
    for i, (c, level) in enumerate(zip(cell, levels, strict=True)):
        if level * levels[i - 1] < 0:
            u, v = abs(level), abs(levels[i - 1])
            t, s, w = (v * x + u * y for x, y in zip(c, cell[i - 1], strict=True))
            kept.append((t // gcd(t, s, w), s // gcd(t, s, w), w // gcd(t, s, w)))
        kept += [c] if level <= 0 else []
    return list(dict.fromkeys(kept))


def sides(ring: list[Triple]) -> list[Vector]:
    """Normals of half-planes that have in common a convex polygon, a segment or a point (also as a
    segment without length)."""
    if len(ring) > 2:
        return [(b[1] - a[1], a[0] - b[0]) for a, b in edges_of(ring)]
    x, y = direction(ring[0], ring[1]) if len(set(ring)) == 2 else (1, 0)
    return [(x, y), (-x, -y), (y, -x), (-y, x)]


def winds_around(ring: list[Vertex], x: Vertex) -> bool:
    """Whether a closed polyline that misses a point leads around it."""
    times = 0
    for a, b in edges_of(ring):
        if (a[1] <= x[1]) != (b[1] <= x[1]):
            side = cross((b[0] - a[0], b[1] - a[1]), (x[0] - a[0], x[1] - a[1]))
            times += (side > 0 and b[1] > a[1]) - (side < 0 and b[1] < a[1])
    return times != 0


class ScaleRange:
    """All scales from one to another, each of which belongs to them or does not."""

    def __init__(self, value: Json) -> None:
        low, high, *self.is_in = members(value, "from to from_in to_in")
        require(all(isinstance(told, bool) for told in self.is_in), "this is not true or false")
        a, b = number(low), None if high is None else number(high)
        self.ends = [(a.numerator, a.denominator), b.as_integer_ratio() if b else (1, 0)]
        self.low: Cut = (a, not self.is_in[0])
        self.high: Cut = (inf if b is None else b, self.is_in[1])
        proper = a >= 0 and (a > 0 or not self.is_in[0]) and (b is not None or not self.is_in[1])
        require(proper and self.low < self.high, f"{value} are no scales")

    def middle(self) -> Fraction:
        """One of the scales."""
        low, high = self.low[0], self.high[0]
        return Fraction(low + 1 if high == inf else (low + high) / 2)

    def meet(self, corners: list[Corner]) -> bool:
        """Whether the hull of corners has a point at one of the scales, and not only at an end that
        does not belong to them."""
        out = [end for end, is_in in zip(self.ends, self.is_in, strict=True) if not is_in]
        return bool(corners) and not any(all(s * W == S * w for _, s, w in corners) for S, W in out)

    def __eq__(self, other: object) -> bool:
        return isinstance(other, ScaleRange) and (self.low, self.high) == (other.low, other.high)

    def __str__(self) -> str:
        ends = f"{self.low[0]}, {self.high[0]}"
        return f"{'[' if self.is_in[0] else '('}{ends}{']' if self.is_in[1] else ')'}"


class Way:
    """A segment of places of R, in whole numbers. Its ends may move with the scale s, from p(s) to
    q(s), as long as its direction stays: the places p(s) + t d, with 0 <= t <= (q(s) - p(s)) / d,
    which is linear in s. Its cell holds all such t and s."""

    def __init__(self, clear: Clear, ends: Sequence[Vertex]) -> None:
        self.by, self.parts = clear.by, lcm(*(c.denominator for end in ends for c in end))
        unit, ((s, w), (S, W)) = clear.proof.unit * self.parts, clear.scales.ends
        first, last = ([int(c * unit) for c in end] for end in ends)
        self.start, self.slope = (first[0], first[2]), (first[1], first[3])
        off = [b - a for a, b in zip(first, last, strict=True)]
        u, v = ((c * off[0] + a * off[1], c * off[2] + a * off[3]) for a, c in clear.scales.ends)
        demand(cross(u, v) == 0 and dot(u, v) >= 0, "a segment turns as the scale changes")
        self.along = (u[0] + v[0], u[1] + v[1])
        self.square, t, T = dot(self.along, self.along) or 1, dot(u, self.along), dot(v, self.along)
        self.cell = list(dict.fromkeys([(0, s, w), (t, s, w), (T, S, W), (0, S, W)]))

    def gap(self, normal: Vector, A: int, B: int) -> Triple:
        """f, linear: positive at (t, s, w) where n (x + s a) > n b for all a in A, b in B."""
        part, others = self.by
        least, most = -part.most(A, (-normal[0], -normal[1])), others.most(B, normal)
        far = dot(normal, self.start)
        grows = self.square * (dot(normal, self.slope) + self.parts * least)
        return dot(normal, self.along), grows, self.square * (far - self.parts * most)


class Clear:
    """`clear`: at no scale of a range a place of a path collides. For each segment a code follows
    all pairs of pieces over the convex cell of all t and s: n takes away where normal n holds the
    pair apart, until nothing is left; -1 and -2 split a node; -3 cuts the cell in the middle."""

    def __init__(self, step: Json, proof: PathProof) -> None:
        names = "rule by contact path scales normals codes"
        by, contact, path, scales, normals, codes = members(step, names)[1:]
        self.by, self.contact, self.proof = proof.pair(by), proof.contact(contact), proof
        self.path = list(map(stays, proof.path)) if path is None else places(path, moving)
        self.scales = ScaleRange(scales)
        self.normals = [whole_normal(vector(normal)) for normal in items(normals)]
        self.roots = list(itertools.product(*(of.root for of in self.by)))
        ways = segments(self.path)
        for i, (ends, code) in enumerate(zip(ways, items(codes, len(ways)), strict=True)):
            with within(f"segment {i}"):
                self.follow(Way(self, ends), items(code))

    def left(self, cell: list[Corner], f: Triple) -> list[Corner]:
        """The part of a cell that f does not hold apart."""
        self.proof.spend(len(cell))
        rest = not_above(f, cell)
        overlap = self.contact == "forbidden" or min(at_corners(f, cell)) < 0
        return rest if overlap and self.scales.meet(rest) else []

    def follow(self, way: Way, code: list[Json]) -> None:
        stack = [(way.cell, A, B) for A, B in self.roots]
        for token in map(integer, code):
            self.proof.spend(1)
            demand(bool(stack), "a code goes on after its end")
            cell, A, B = stack.pop()
            if token in (-1, -2):
                children = self.by[token + 2 == 0].children[A if token == -1 else B]
                demand(bool(children), "a code splits a piece")
                pairs = [(c, B) if token == -1 else (A, c) for c in reversed(children)]
                stack += [(cell, *pair) for pair in pairs]
            elif token == -3:
                at = [Fraction(t, w) for t, _, w in cell if w]
                u, v = ((min(at) + max(at)) / 2).as_integer_ratio()
                stack += [(not_above(f, cell), A, B) for f in ((-v, 0, u), (v, 0, -u))]
            else:
                normal = self.normals[index(token, len(self.normals))]
                rest = self.left(cell, way.gap(normal, A, B))
                stack += [(rest, A, B)] if rest else []
        demand(not stack, "a code ends too early")


class PathProof(Proof):
    """The proof for a case of R, O and a path."""

    rules: ClassVar[dict[str, Any]] = {"pieces": Pieces, "clear": Clear}

    def __init__(self, path: list[Vertex], sets: Sequence[Operand], budget: Budget) -> None:
        super().__init__(sets[0], sets[1], budget)
        self.path, self.ways = path, segments(path)

    def claim(self, value: Json) -> tuple[Any, ...]:
        shown = self.shown[index(value, len(self.shown))]
        require(isinstance(shown, tuple), f"claim {value} is of another kind")
        return shown  # type: ignore[no-any-return]

    def pair(self, by: Json) -> tuple[Pieces, Pieces]:
        pair = [self.step(value, Pieces) for value in items(by, 2)]
        require([of.operand.name for of in pair] == ["R", "O"], "`by` is not of R and O")
        return pair[0], pair[1]

    def nodes(self, by: tuple[Pieces, Pieces], value: Json) -> Edge:
        A, B = (index(i, len(of.hulls)) for i, of in zip(items(value, 2), by, strict=True))
        demand(by[0].solid[A] and by[1].solid[B], f"{A} or {B} is not convex")
        return A, B

    def contact(self, value: Json) -> str:
        """With contact allowed both have an area: else seams of pieces would be let through."""
        require(value in ("allowed", "forbidden"), f"there is no contact {value!r}")
        thin = value == "allowed" and any(o.thin for o in self.operands.values())
        require(not thin, "with contact allowed neither may be a point or a segment")
        return str(value)

    def clear(self, step: Json, contact: Json, scales: Json) -> Clear:
        clear = self.step(step, Clear)
        same = (clear.contact, clear.scales) == (self.contact(contact), ScaleRange(scales))
        demand(same, "the step is about another contact, or other scales")
        return clear

    def add_free(self, claim: Json) -> tuple[str, Any]:
        """At each scale of a range no place of the path collides."""
        contact, scales, step = members(claim, "claim contact scales step")[1:]
        clear = self.clear(step, contact, scales)
        demand(clear.path == list(map(stays, self.path)), "the step is about another path")
        return f"at {clear.scales}, contact {contact}", ("free", contact, clear.scales)

    def add_hit(self, claim: Json) -> tuple[str, Any]:
        """At each scale of a range some place of the path collides."""
        contact, scales, by, hits = members(claim, "claim contact scales by hits")[1:]
        contact, told, pair = self.contact(contact), ScaleRange(scales), self.pair(by)
        reach = told.low
        for i, hit in enumerate(items(hits)):
            with within(f"hit {i}"):
                low, high = self.hit(hit, contact == "allowed", pair)
                demand(low <= reach < high, "it leaves out scales before it, or adds none")
                reach = high
        demand(reach >= told.high, "the hits do not reach to the last scale")
        return f"at {told}, contact {contact}", ("hit", contact, told)

    def hit(self, value: Json, strict: bool, by: tuple[Pieces, Pieces]) -> tuple[Cut, Cut]:
        """Where its scales begin and end. A place, and a point that the part and the obstacles have
        in common there, move linearly from each scale to the next; `up`: they stay for ever."""
        segment, nodes, entries = members(value, "segment nodes points")
        start, end = self.ways[index(segment, len(self.ways))]
        A, B = self.nodes(by, nodes)
        of_A, of_B = sides(by[0].hulls[A]), sides(by[1].hulls[B])
        up = items(entries)[-1:] == ["up"]
        scales: list[Any] = []
        levels: list[list[Any]] = []  # of the point across the sides of both pieces; positive: out
        for entry in entries[: len(entries) - up]:
            self.spend(len(of_A) + len(of_B))
            t, s, point = items(entry, 3)
            t, s, (x, y) = number(t), number(s), vector(point)
            require(0 <= t <= 1 and s >= 0, "this is no place of a segment, or no scale")
            off = tuple(p - (1 - t) * c - t * d for p, c, d in zip((x, y), start, end, strict=True))
            outs = [self.unit * dot(n, off) - s * by[0].most(A, n) for n in of_A]
            levels.append(outs + [self.unit * dot(n, (x, y)) - by[1].most(B, n) for n in of_B])
            scales.append(s)
        require(bool(scales), "a hit has no point")
        require(scales == sorted(set(scales)), "the scales do not ascend")
        if up:
            levels.append([-by[0].most(A, n) for n in of_A] + [0 for _ in of_B])
            scales.append(inf)
        demand(all(max(level) <= 0 for level in levels), "a point is not in its piece")
        if strict:
            inner = all(max(level) < 0 for level in levels[1:-1])
            pairs = itertools.pairwise(levels)
            between = all(u < 0 or v < 0 for p in pairs for u, v in zip(*p, strict=True))
            demand(inner and between, "a point is not in the interior of its piece")
        ends = [not strict or max(level) < 0 for level in (levels[0], levels[-1])]
        return (scales[0], not (ends[0] and scales[0] > 0)), (scales[-1], ends[1] and not up)

    def add_valid(self, claim: Json) -> tuple[str, None]:
        """Which of some scales are valid for the path: claims follow each other, free or hit."""
        return self.answer(claim, "valid", ("free", "hit"))

    def add_trap(self, claim: Json) -> tuple[str, None]:
        """At which of some scales the part is trapped at the place."""
        self.place()
        return self.answer(claim, "trapped", ("trapped", "escapes", "hit"))

    def answer(self, claim: Json, name: str, kinds: Sequence[str]) -> tuple[str, None]:
        """`name`: the member with the scales of the claims of the first kind."""
        contact, scales, told, claims = members(claim, f"claim contact scales {name} claims")[1:]
        contact, window = self.contact(contact), ScaleRange(scales)
        parts = [self.claim(value) for value in items(claims)]
        require(all(part[0] in kinds for part in parts), "a claim is of another kind")
        demand(all(part[1] == contact for part in parts), "a claim is about another contact")
        ends = [window.low, *(part[2].high for part in parts)]
        good = [part[2].low for part in parts] + [window.high] == ends
        demand(good, "the claims do not follow each other from end to end")
        groups = itertools.groupby(parts, key=lambda part: part[0] == kinds[0])
        found = [
            (g[0][2].low, g[-1][2].high) for has, g in ((h, list(g)) for h, g in groups) if has
        ]
        ranges = [*map(ScaleRange, items(told))]
        demand([(one.low, one.high) for one in ranges] == found, "the scales are others")
        return f"of {window}, contact {contact}: {', '.join(map(str, ranges)) or 'none'}", None

    def place(self) -> Vertex:
        require(len(self.path) == 1, "the path of the case is not one place")
        return self.path[0]

    def add_escapes(self, claim: Json) -> tuple[str, Any]:
        """A way from the place to one from which the part may go on along the normal. Its places
        may move with the scale."""
        contact, scales, step, normal = members(claim, "claim contact scales step normal")[1:]
        clear = self.clear(step, contact, scales)
        demand(clear.path[0] == stays(self.place()), "the way begins elsewhere")
        last, out = Way(clear, [clear.path[-1]] * 2), whole_normal(vector(normal))
        left = [clear.left(last.cell, last.gap(out, *pair)) for pair in clear.roots]
        demand(not any(left), "its end is not beyond all collisions")
        return f"at {clear.scales}, contact {contact}", ("escapes", contact, clear.scales)

    def add_trapped(self, claim: Json) -> tuple[str, Any]:
        """The place is free, and a ring of places that collide leads around it. Its vertices move
        linearly with the scale."""
        names = "claim contact scales step by ring pairs"
        contact, scales, step, by, ring, pairs = members(claim, names)[1:]
        clear, by = self.clear(step, contact, scales), self.pair(by)
        demand(clear.path == [stays(self.place())], "the step is about another place")
        corners = [tuple(map(number, items(corner, 4))) for corner in items(ring)]
        ends = [(0, s, w) for s, w in clear.scales.ends]
        for edge, nodes in zip(edges_of(corners), items(pairs, len(corners)), strict=True):
            A, B = self.nodes(by, nodes)
            of_A = [(-x, -y) for x, y in sides(by[0].hulls[A])]  # the sum is of B and -sA
            for n, (x, X, y, Y) in itertools.product(of_A + sides(by[1].hulls[B]), edge):
                self.spend(2)
                far = self.unit * dot(n, (x, y)) - by[1].most(B, n)
                grows = self.unit * dot(n, (X, Y)) - by[0].most(A, (-n[0], -n[1]))
                levels = [grows * s + far * w for _, s, w in ends]
                touch = [end for end, level in zip(ends, levels, strict=True) if level == 0]
                inside = contact == "forbidden" or not clear.scales.meet(touch)
                demand(max(levels) <= 0 and inside, f"an edge is not in the sum of {A} and {B}")
        s = clear.scales.middle()
        around = winds_around([at_scale(corner, s) for corner in corners], self.path[0])
        demand(around, "the ring does not lead around the place")
        return f"at {clear.scales}, contact {contact}", ("trapped", contact, clear.scales)

    claims: ClassVar[dict[Any, Any]] = {
        "free": add_free, "hit": add_hit, "valid": add_valid,
        "escapes": add_escapes, "trapped": add_trapped, "trap": add_trap,
    }  # fmt: skip


def of_paths(case: Json, digest: Json, steps: Json, claims: Json, budget: Budget) -> list[str]:
    sets = [Operand(case.get(operand), operand) for operand in "RO"]
    path = places(case.get("path"))
    plain = {one.name: one.plain for one in sets} | {"path": [[str(x), str(y)] for x, y in path]}
    demand(digest_of(plain) == digest, "not the case that is certified")
    return PathProof(path, sets, budget).follow(steps, claims)


FORMS["path-certificate-v1"] = "steps", of_paths
# Part 7: bridges of a disc that touches a set in the plane from outside. Needs part 2.

Named = tuple[str, int]


def less(p: Vertex, q: Vertex) -> Vertex:
    return p[0] - q[0], p[1] - q[1]


def nearest(p: Vertex, a: Vertex, b: Vertex) -> Vertex:
    """The point of a segment that is nearest to a point."""
    along, way = less(b, a), less(p, a)
    part = max(Fraction(0), min(Fraction(1), Fraction(dot(along, way)) / dot(along, along)))
    return a[0] + part * along[0], a[1] + part * along[1]


def squared_distance(p: Vertex, a: Vertex, b: Vertex) -> Fraction:
    """From a point to a segment."""
    off = less(p, nearest(p, a, b))
    return Fraction(dot(off, off))


class DiscProof:
    """Discs of one squared radius outside of P; edge n goes from vertex n to the next of its
    ring."""

    kinds: tuple[str, ...] = ("bridge", "touch")

    def __init__(self, P: Operand, square: Fraction, budget: Budget) -> None:
        require(not P.thin and bool(P.rings), "P is no region")
        self.at, self.square, self.spend = P.exact, square, budget.spend
        self.next = {i: j for ring in P.rings for i, j in edges_of(ring)}
        self.last = {j: i for i, j in self.next.items()}
        require(all(self.at[i] != self.at[j] for i, j in self.next.items()), "an edge is zero")
        self.times = Counter(self.at)

    def edge(self, n: int) -> tuple[Vertex, Vertex]:
        return self.at[n], self.at[self.next[n]]

    def along(self, n: int) -> Vertex:
        return less(*self.edge(n)[::-1])

    def height(self, n: int, p: Vertex) -> Any:
        """How far a point is right of an edge, times the edge's length."""
        return cross(less(p, self.at[n]), self.along(n))

    def feature(self, value: Json) -> Named:
        kind, n = items(value, 2)
        require(kind in ("vertex", "edge"), "a feature is a vertex or an edge")
        return str(kind), index(n, len(self.at))

    def touches(self, feature: Named, centres: Sequence[Vertex], closed: bool) -> set[int]:
        """The feature is in P, in front of it lie all centres: their nearest point of these edges
        is inside the edge (`closed`: or one of its ends), or the vertex."""
        kind, n = feature
        if kind == "edge":
            length = dot(self.along(n), self.along(n))
            over = [dot(less(p, self.at[n]), self.along(n)) for p in centres]
            inside = 0 < min(over) and max(over) < length
            inside = inside or (closed and 0 <= min(over) and max(over) <= length)
            demand(inside, "a centre is not in front of its edge")
            demand(all(self.height(n, p) > 0 for p in centres), "a centre is not right of its edge")
            return {n}
        before, v = self.last[n], self.at[n]
        demand(self.times[v] == 1, "rings touch at a vertex")
        turn = cross(self.along(before), self.along(n))
        on = turn == 0 and dot(self.along(before), self.along(n)) > 0
        right = turn > 0 or (on and all(self.height(n, p) > 0 for p in centres))
        demand(right, "P is not convex at a vertex")
        for p in centres:
            way = less(p, v)
            ahead = dot(way, self.along(n)) > 0 or dot(way, self.along(before)) < 0
            demand(not ahead, "a centre is nearer to an edge than to its vertex")
        return {before, n}

    def near(self, feature: Named, a: Vertex, b: Vertex, sign: int) -> bool:
        """Whether all points between two are nearer than the radius (-1), or farther (1)."""
        kind, n = feature
        if kind == "edge":
            square = self.square * dot(self.along(n), self.along(n))
            return all(sign * (self.height(n, p) ** 2 - square) > 0 for p in (a, b))
        v = self.at[n]
        if sign < 0:
            return all(dot(less(p, v), less(p, v)) < self.square for p in (a, b))
        return squared_distance(v, a, b) > self.square

    def winds(self, p: Vertex, way: Sequence[Any] = (1, 0), but: int | None = None) -> int:
        """How often rings wind around a point off all edges; right of one edge, if it is on it, and
        `way` leads there."""
        winds = 0
        for n in self.next:
            low, high = (cross(way, less(q, p)) for q in self.edge(n))
            if n != but and (low <= 0) != (high <= 0):
                height = self.height(n, p)
                winds += (high > low and height < 0) - (high < low and height > 0)
        return winds

    def bridge(self, claim: Json) -> str:
        left, right, box = members(claim, "claim left right box")[1:]
        one, other = self.feature(left), self.feature(right)
        require(one != other, "a bridge has one feature twice")
        p, u, w = (vector(each) for each in items(box, 3))
        q, s, t = ((p[0] + x, p[1] + y) for x, y in (u, w, (u[0] + w[0], u[1] + w[1])))
        corners = [p, q, t, s]
        require(all(dot(d, d) for d in (u, w)) and cross(u, w) != 0, "a box is flat")
        small = all(dot(d, d) < self.square for d in (less(t, p), less(s, q)))
        demand(small, "a box is wider than the radius")
        own = self.touches(one, corners, False) | self.touches(other, corners, False)
        good = self.near(one, p, s, -1) and self.near(one, q, t, 1)
        good = good and self.near(other, p, q, -1) and self.near(other, s, t, 1)
        demand(good, "no centre in the box is as far from both features as the radius")
        for n in self.next.keys() - own:
            self.spend(8)
            a, b = self.edge(n)
            far = [squared_distance(c, a, b) for c in corners]
            far += [squared_distance(e, *side) for side in edges_of(corners) for e in (a, b)]
            demand(min(far) > self.square, f"edge {n} may be in the disc")
        demand(self.winds(p) == 0, "a centre is not outside of P")
        return f"bridge from {one[0]} {one[1]} to {other[0]} {other[1]}"

    def touch(self, claim: Json) -> str:
        """A disc that touches P at these features, and no other."""
        centre, told = members(claim, "claim centre features")[1:]
        c, named = vector(centre), [self.feature(value) for value in items(told)]
        require(len(set(named)) == len(named) >= 2, "a disc touches two features or more")
        own: set[int] = set().union(*(self.touches(feature, [c], True) for feature in named))
        for n in self.next:
            self.spend(1)
            far = squared_distance(c, *self.edge(n))
            good = far == self.square if n in own else far > self.square
            demand(good, f"edge {n} is not as far from the centre as it should be")
        demand(self.winds(c) == 0, "a centre is not outside of P")
        return f"disc about ({c[0]}, {c[1]}) that touches {len(named)} features"


def of_discs(
    case: Json, digest: Json, square: Json, claims: Json, budget: Budget,
    proofs: type[DiscProof] = DiscProof,
) -> list[str]:  # fmt: skip
    P = Operand(case.get("P"), "P")
    demand(digest_of({"P": P.plain}) == digest, "not the case that is certified")
    require(number(square) > 0, "the squared radius is not positive")
    proof, said = proofs(P, number(square), budget), []
    require(bool(items(claims)), "nothing is claimed")
    require(len(set(map(digest_of, claims))) == len(claims), "a claim is made twice")
    for k, claim in enumerate(claims):
        with within(f"claim {k}"):
            budget.spend(64)
            kind: Json = claim.get("claim") if isinstance(claim, dict) else None
            require(kind in proof.kinds, f"there is no claim {kind!r}")
            said.append(f"{getattr(proof, kind)(claim)}, squared radius {number(square)}")
    return said


FORMS["feature-certificate-v1"] = "square", of_discs


# Part 8: unions of sets in the plane. Needs part 2.

Side = tuple[Triple, Triple, Triple]  # from a point to a point; the line, positive on the left


def triple(p: Vertex) -> Triple:
    """In lowest terms."""
    w = lcm(p[0].denominator, p[1].denominator)
    return int(p[0] * w), int(p[1] * w), w


def exact(p: Triple) -> Vertex:
    return Fraction(p[0], p[2]), Fraction(p[1], p[2])


def at_point(line: Triple, p: Triple) -> int:
    """Positive left of the line, negative right of it."""
    return int(line[0] * p[0] + line[1] * p[1] + line[2] * p[2])


def winding(sides: Iterable[Side], p: Triple, beside: Vector) -> int:
    """How often edges wind around the point p + e `beside`, which lies on none, for small e > 0."""
    turns = 0
    for a, b, line in sides:
        above = [(v[1] * p[2] - p[1] * v[2], -beside[1]) > (0, 0) for v in (a, b)]
        if above[0] != above[1]:
            left = (at_point(line, p), dot(line, beside)) > (0, 0)
            turns += (above[1] and left) - (above[0] and not left)
    return turns


def span(side: Side) -> list[Vertex]:
    return sorted(map(exact, side[:2]))


def is_inside(side: Side, p: Triple) -> bool:
    """Whether a point lies on an edge, and is neither end."""
    low, high = span(side)
    return at_point(side[2], p) == 0 and low < exact(p) < high


def cuts(side: Side, other: Side) -> list[Triple]:
    """Where another edge meets an edge; of a common stretch the other's ends."""
    (a, b, line), (c, d, across_it) = side, other
    if (ends := (at_point(line, c), at_point(line, d))) == (0, 0):
        return [p for p in (c, d) if p in (a, b) or is_inside(side, p)]
    apart = ends[0] * ends[1] > 0 or at_point(across_it, a) * at_point(across_it, b) > 0
    return [] if apart else [meet(line, across_it)]


class Union(Proof):
    """Sets, and claims about them. A vertex is [set, vertex]; so is the edge that begins there."""

    claims: ClassVar[dict[Any, Any]] = {}

    def __init__(self, sets: list[Operand], budget: Budget) -> None:
        self.spend, self.vertices = budget.spend, [list(map(triple, one.exact)) for one in sets]
        self.ends = [dict(e for ring in one.rings for e in edges_of(ring)) for one in sets]
        self.sides = [sides_of(one) for one in sets]

    def at(self, value: Json) -> Triple:
        k, i = items(value, 2)
        vertices = self.vertices[index(k, len(self.vertices))]
        return vertices[index(i, len(vertices))]

    def side(self, value: Json) -> Side:
        first = self.at(value)
        last = self.vertices[value[0]][self.ends[value[0]][value[1]]]
        return first, last, across(first, last)


def sides_of(one: Operand) -> list[Side]:
    require(not one.thin, f"{one.name} is a point or a segment")
    points = list(map(triple, one.exact))
    found = [(points[i], points[j]) for ring in one.rings for i, j in edges_of(ring)]
    require(all(a != b for a, b in found), f"{one.name} has an edge of length zero")
    return [(a, b, across(a, b)) for a, b in found]


def claim_union(union: Union, claim: Json) -> tuple[str, None]:
    """The union is the set that polygons bound. All edges, cut where they meet, part the plane into
    faces; each has a piece of an edge at its boundary, and both sides of all pieces are right."""
    region = Operand({"polygons": members(claim, "claim polygons")[1]}, "the union")
    bounds = sides_of(region)
    every = sorted(set(itertools.chain(bounds, *union.sides)))
    for side in every:
        union.spend(len(every))
        at = sorted({exact(p) for other in every for p in cuts(side, other)})
        for (x, y), (z, w) in itertools.pairwise(at):
            p = triple(((x + z) / 2, (y + w) / 2))
            union.spend(2 * len(every))
            for beside in (side[2][:2], (-side[2][0], -side[2][1])):
                held = any(winding(sides, p, beside) > 0 for sides in union.sides)
                demand(winding(bounds, p, beside) == held, f"the sides differ at {plain_point(p)}")
    return f"{len(bounds)} edges, {digest_of({'polygons': region.plain})}", None


def plain_point(p: Triple) -> str:
    return f"({', '.join(map(str, exact(p)))})"


def claim_point(union: Union, claim: Json) -> tuple[str, None]:
    """The sets that have a point inside, and those with an edge through it; it is outside of all
    others."""
    point, inside, on = members(claim, "claim point inside on")[1:]
    p = triple(vector(point))
    union.spend(2 * sum(map(len, union.sides)))
    through = [any(p == side[0] or is_inside(side, p) for side in one) for one in union.sides]
    edges = [k for k, is_on in enumerate(through) if is_on]
    demand(list(map(integer, items(on))) == edges, f"edges of the sets {edges} pass the point")
    around = (k for k, one in enumerate(union.sides) if winding(one, p, (0, 0)) > 0)
    held = [k for k in around if not through[k]]
    demand(list(map(integer, items(inside))) == held, f"the sets {held} have it inside")
    return f"{plain_point(p)} inside {held}, on edges of {edges}", None


def claim_meet(union: Union, claim: Json) -> tuple[str, None]:
    """A point is each of some vertices, and inside each of some edges; several sets have these."""
    point, vertices, edges = members(claim, "claim point vertices edges")[1:]
    p = triple(vector(point))
    demand(all(union.at(v) == p for v in items(vertices)), "a vertex is elsewhere")
    demand(all(is_inside(union.side(e), p) for e in items(edges)), "an edge does not pass there")
    named = [*vertices, *edges]
    require(len({k for k, _ in named}) > 1, "one set, or none, is named")
    require(len(set(map(tuple, named))) == len(named), "one is named twice")
    return f"at {plain_point(p)} the vertices {vertices}, and inside the edges {edges}", None


def claim_overlap(union: Union, claim: Json) -> tuple[str, None]:
    """Edges of two sets have a stretch in common, and run the same way (1) or not (-1)."""
    edges, way = members(claim, "claim edges way")[1:]
    one, other = map(union.side, items(edges, 2))
    require(edges[0][0] != edges[1][0], "one set is named")
    demand(at_point(one[2], other[0]) == at_point(one[2], other[1]) == 0, "they are on two lines")
    (a, b), (c, d) = span(one), span(other)
    demand(max(a, c) < min(b, d), "they have no stretch in common")
    same = (exact(one[0]) == a) == (exact(other[0]) == c)
    demand(integer(way) == (1 if same else -1), "they run the other way")
    return f"the edges {edges}, {'the same way' if same else 'opposite ways'}", None


def claim_sign(union: Union, claim: Json) -> tuple[str, None]:
    """The sign of `orientation` of three vertices (positive: they turn left), or of `concurrent`,
    three lines, each through two vertices (zero: they meet in a point or are parallel)."""
    of, sign = members(claim, "claim of sign")[1:]
    kind, rows = items(of, 2)
    require(kind in ("orientation", "concurrent"), f"there is no predicate {kind!r}")
    lines = [[r] if kind == "orientation" else items(r, 2) for r in items(rows, 3)]
    points = [list(map(union.at, line)) for line in lines]
    u, v, w = (row[0] if len(row) == 1 else across(row[0], row[1]) for row in points)
    require(all(map(any, (u, v, w))), "a line has one point given twice")
    value = at_point(across(v, w), u)
    demand(integer(sign) == (value > 0) - (value < 0), "it has another sign")
    return f"{of} has the sign {sign}", None


def of_unions(case: Json, digest: Json, claims: Json, budget: Budget) -> list[str]:
    sets = [Operand(one, f"set {k}") for k, one in enumerate(items(case.get("sets")))]
    demand(digest_of({"sets": [one.plain for one in sets]}) == digest, "another case is certified")
    return Union(sets, budget).follow([], claims)


FORMS["union-certificate-v1"] = "", of_unions
Union.claims.update(union=claim_union, point=claim_point, meet=claim_meet)
Union.claims.update(overlap=claim_overlap, sign=claim_sign)


# Part 8b: sums of a set in the plane with a disc. Needs parts 2 and 7.


class Root:
    """p + q √d, with p, q and d > 0 from the field below, at last fractions."""

    def __init__(self, p: Any, q: Any, d: Any) -> None:
        self.p, self.q, self.d = p, q, d

    def shares(self, other: Any) -> bool:
        return isinstance(other, Root) and other.d is self.d

    def __add__(self, other: Any) -> Any:
        p, q = (other.p, other.q) if self.shares(other) else (other, 0)
        return Root(self.p + p, self.q + q, self.d)

    def __mul__(self, other: Any) -> Any:
        if not self.shares(other):
            return Root(self.p * other, self.q * other, self.d)
        p = self.p * other.p + self.q * other.q * self.d
        return Root(p, self.p * other.q + self.q * other.p, self.d)

    def __sub__(self, other: Any) -> Any:
        return self + other * -1

    def __rsub__(self, other: Any) -> Any:
        return self * -1 + other

    __radd__, __rmul__ = __add__, __mul__


def sign(x: Any) -> int:
    if not isinstance(x, Root):
        return int(x > 0) - int(x < 0)
    p, q = sign(x.p), sign(x.q)
    return p or q if p * q >= 0 else p * sign(x.p * x.p - x.q * x.q * x.d)


class Place(NamedTuple):
    """On a curve. `mark`: how far along an edge, or the direction from a vertex. `key`: a joint's
    number, or the curve that goes on at this end."""

    at: Any
    mark: Any
    key: Any = None


class Curve:
    """Edge n, moved to its right by the radius; or the arc about the vertex where edge n begins,
    after edge `before`. P is on the left."""

    def __init__(self, proof: DiscSum, n: int, before: int | None = None) -> None:
        self.proof, self.n, self.is_arc = proof, n, before is not None
        self.v, self.along = proof.at[n], proof.along(n)
        self.square, self.own = dot(self.along, self.along), {n}
        ends: list[Any] = [Fraction(0), Fraction(1)]
        self.tips, last = proof.edge(n), proof.key_after(n)
        if before is not None:
            self.own = {m for m in proof.next if self.v in proof.edge(m)}
            ends = [right(proof.along(before)), right(self.along)]
            self.tips, last = (self.v, self.v), (n, False)
        self.ends = self.place(ends[0], (n, self.is_arc)), self.place(ends[1], last)

    def place(self, t: Any, key: Any = None) -> Place:
        """At a part of the edge, or in a direction."""
        way = t if self.is_arc else right(self.along)
        root = Root(Fraction(0), Fraction(1), self.proof.square / dot(way, way))
        over = (0, 0) if self.is_arc else (t * self.along[0], t * self.along[1])
        at = tuple(root * way[k] + (self.v[k] + over[k]) for k in (0, 1))
        return Place(at, t if self.is_arc else t * self.square, key)

    def joint(self, value: Json) -> Place:
        at = self.proof.joints[index(value, len(self.proof.joints))]
        way, height = less(at, self.v), self.proof.height(self.n, at)
        if self.is_arc:
            demand(sign(dot(way, way) - self.proof.square) == 0, "a joint is off its arc")
            return Place(at, way, value)
        off = sign(height * height - self.proof.square * self.square)
        demand(off == 0 and sign(height) > 0, "a joint is off its line")
        return Place(at, dot(self.along, way), value)

    def order(self, x: Any, y: Any) -> int:
        """1 if mark y comes after mark x, on an arc within half a turn."""
        return sign(cross(x, y) if self.is_arc else y - x)

    def end(self, value: Json, end: Place) -> Place:
        found = end if value is None else self.joint(value)
        same = self.order(end.mark, found.mark) == 0
        same = same and (not self.is_arc or sign(dot(end.mark, found.mark)) > 0)
        demand(same, "a joint is not at the end of its curve")
        went = self.proof.ends.setdefault(end.key, found.key)
        demand(went == found.key, "two curves meet at a joint of one of them")
        return found

    def between(self, value: Json) -> Place:
        if isinstance(value, int):
            found = self.joint(value)
        else:
            t: Any = vector(value) if self.is_arc else number(value)
            require(not self.is_arc or any(t), "a direction is zero")
            found = self.place(t)
        inside = self.order(self.ends[0].mark, found.mark) > 0
        demand(inside and self.order(found.mark, self.ends[1].mark) > 0, "a place is off its curve")
        return found

    def over(self, f: int) -> list[Any]:
        """The heights of an edge's ends, the lower one first, and how far along they are."""
        ends = [(self.proof.height(self.n, p), less(p, self.v)) for p in self.proof.edge(f)]
        return sorted((height, dot(self.along, way)) for height, way in ends)

    def is_nearest(self, f: int, x: Place, y: Place) -> bool:
        """Whether a point nearest to edge f lies between, not farther than the radius."""
        if self.is_arc:
            way = less(nearest(self.v, *self.proof.edge(f)), self.v)
            inside = self.order(x.mark, way) > 0 and self.order(way, y.mark) > 0
            return inside and dot(way, way) <= 4 * self.proof.square
        (h, s), (k, t) = self.over(f)
        square = self.proof.square * self.square
        above = [-1 if each <= 0 else sign(each * each - square) for each in (h, k)]
        if above == [-1, 1]:  # the edge crosses the line
            part = (t - s) / (k - h)
            at = [(self.proof.height(self.n, z.at) - h) * part + s - z.mark for z in (x, y)]
            return sign(at[0]) > 0 > sign(at[1])
        level = k if above[1] <= 0 else h
        there = [along for height, along in ((h, s), (k, t)) if height == level]
        inside = self.order(x.mark, max(there)) > 0 and self.order(min(there), y.mark) > 0
        return inside and level >= 0 and level * level <= 4 * square

    def free(self, x: Place, y: Place) -> None:
        """All points between are farther than the radius from all edges but their own."""
        for f in self.proof.beside[self.n] - self.own:
            self.proof.spend(1)
            far = [self.proof.far(z.at, f) for z in (x, y)]
            good = min(far) >= 0 and not self.is_nearest(f, x, y)
            demand(good, f"edge {f} is near to a free part")
            for z, each in zip((x, y), far, strict=True):
                if each == 0 and isinstance(z.key, int):
                    self.proof.touched.add((z.key, f))
                    continue
                tip = self.tips[z.key != self.ends[0].key]
                own = z.key is not None and tip in self.proof.edge(f)
                demand(each > 0 or own, f"edge {f} touches a curve where no joint is")

    def blocked(self, x: Place, y: Place, f: int) -> None:
        """All points between are nearer to edge f than the radius."""
        self.proof.spend(1)
        good = sorted(self.proof.far(z.at, f) for z in (x, y)) in ([-1, -1], [-1, 0])
        if self.is_arc and good:
            way = less(self.v, nearest(self.v, *self.proof.edge(f)))
            past = self.order(x.mark, way) > 0 and self.order(way, y.mark) > 0
            good = any(way) and not past
        demand(good, f"edge {f} is not near to a blocked part")

    def facing(self, x: Place, y: Place, f: int) -> None:
        """All points between are right between this edge and edge f."""
        (h, s), (k, t) = self.over(f)
        good = not self.is_arc and h == k > 0 and h * h == 4 * self.proof.square * self.square
        good = good and self.order(s, x.mark) >= 0 and self.order(y.mark, t) >= 0
        demand(good, f"edge {f} does not face edge {self.n}")

    def follow(self, value: Json) -> None:
        entries = items(value)
        require(len(entries) > 2 and len(entries) % 2 == 1, "a curve is not places and links")
        places = [self.end(entries[0], self.ends[0]), *map(self.between, entries[2:-1:2])]
        places.append(self.end(entries[-1], self.ends[1]))
        self.proof.on |= {(z.key, self.n, self.is_arc) for z in places if isinstance(z.key, int)}
        start: Any = None
        for (x, y), link in zip(itertools.pairwise(places), entries[1::2], strict=True):
            two = isinstance(x.key, int) and isinstance(y.key, int)
            require(not two, "two joints have no place between")
            demand(self.order(x.mark, y.mark) > 0, "places are out of order")
            if link != "free":
                require(start is None, "a free part ends nowhere")
                name = index(
                    items(link, 1)[0] if isinstance(link, list) else link, len(self.proof.at)
                )
                (self.facing if isinstance(link, list) else self.blocked)(x, y, name)
                continue
            self.free(x, y)
            start = x.key if start is None else start
            require(start is not None, "a free part begins nowhere")
            self.proof.parts.append((self, x, y, len(self.proof.pieces)))
            if y.key is not None:
                self.proof.pieces.append((start, y.key, self))
                start = None

    def name(self) -> tuple[Fraction, ...]:
        """As in the canonical form: an arc before a line, then numbers."""
        if self.is_arc:
            return Fraction(0), *self.v
        unit = lcm(*(c.denominator for c in self.along))
        x, y = (int(c * unit) for c in self.along)
        x, y = x // gcd(x, y), y // gcd(x, y)
        return Fraction(1), Fraction(x), Fraction(y), y * self.v[0] - x * self.v[1]


def right(d: Vertex) -> Vertex:
    return d[1], -d[0]


def roots(links: Iterable[tuple[Any, Any]]) -> Callable[[Any], Any]:
    """Finds the representative of a class, by pairs of members."""
    above: dict[Any, Any] = {}

    def root(x: Any) -> Any:
        while x in above:
            x = above[x]
        return x

    for x, y in links:
        if root(x) != root(y):
            above[root(x)] = root(y)
    return root


class DiscSum(DiscProof):
    """The sum of P with a disc. Valid sets only: rings meet at vertices, P is on their left."""

    kinds = ("sum", "point")

    def __init__(self, P: Operand, square: Fraction, budget: Budget) -> None:
        super().__init__(P, square, budget)
        self.rings, self.ring = P.rings, {n: k for k, r in enumerate(P.rings) for n in r}
        simple = all(len({self.at[n] for n in ring}) == len(ring) for ring in P.rings)
        demand(simple, "a ring passes a vertex twice")
        reach = Fraction(isqrt(4 * square.numerator * square.denominator) + 1, square.denominator)
        boxes = {n: [*map(min, *self.edge(n)), *map(max, *self.edge(n))] for n in self.next}
        self.beside: dict[int, set[int]] = {n: set() for n in self.next}
        links = []
        for n, f in itertools.product(self.next, repeat=2):
            budget.spend(1)
            apart = max(
                max(boxes[n][k] - boxes[f][k + 2], boxes[f][k] - boxes[n][k + 2]) for k in (0, 1)
            )
            if apart <= reach:
                self.beside[n].add(f)
                if n < f and self.joins(n, f):
                    links.append((self.ring[n], self.ring[f]))
        for n in self.next:
            budget.spend(len(self.next))
            (a, b), way = self.edge(n), right(self.along(n))
            winds = self.winds(((a[0] + b[0]) / 2, (a[1] + b[1]) / 2), way, n)
            demand(winds == 0, f"P is not on the left of edge {n} alone")
        holes = (
            k for k, ring in enumerate(P.rings) if doubled_area([self.at[n] for n in ring]) < 0
        )
        self.root = roots([*links, *((k, self.around(k)) for k in holes)])
        arriving: dict[Vertex, list[int]] = defaultdict(list)
        for m in self.next:
            arriving[self.edge(m)[1]].append(m)
        self.before = {n: self.first_right(n, arriving[self.at[n]]) for n in self.next}
        self.after = {m: n for n, m in self.before.items()}
        demand(len(self.after) == len(self.next), "rings cross at a vertex")

    def joins(self, n: int, f: int) -> bool:
        """Whether the sums of two edges have interior points in common, or face each other. The
        edges have nothing else in common than an end."""
        (a, b), (c, d) = self.edge(n), self.edge(f)
        if common := {a, b} & {c, d}:
            ways = [
                less(p, q) for p, q in itertools.product((a, b, c, d), common) if p not in common
            ]
            apart = len(ways) == 2 and (cross(*ways) != 0 or dot(*ways) < 0)
            demand(apart, f"edges {n} and {f} overlap")
            return True
        sides = [self.height(n, c), self.height(n, d), self.height(f, a), self.height(f, b)]
        ends = ((a, c, d), (b, c, d), (c, a, b), (d, a, b))
        gap = min(squared_distance(*each) for each in ends)
        crossing = sides[0] * sides[1] < 0 and sides[2] * sides[3] < 0
        demand(gap > 0 and not crossing, f"edges {n} and {f} meet")
        (u, v), square = (self.along(n), self.along(f)), 4 * self.square
        along = sorted(dot(u, less(p, a)) for p in (c, d))
        facing = cross(u, v) == 0 > dot(u, v) and sides[0] > 0
        return gap < square or (gap == square and facing and along[0] < dot(u, u) and along[1] > 0)

    def around(self, k: int) -> int:
        """The ring to the left of a hole."""
        x, y = min(self.at[n] for n in self.rings[k])
        found = []
        for n in self.next.keys() - set(self.rings[k]):
            (a, b), (c, d) = self.edge(n)
            if (b <= y) != (d <= y) and (at := a + (y - b) * (c - a) / (d - b)) <= x:
                found.append((at, self.ring[n]))
        demand(bool(found), "a hole is in nothing")
        return max(found)[1]

    def first_right(self, n: int, arriving: list[int]) -> int:
        """The first edge clockwise of edge n, seen from where n begins."""

        def turn(m: int) -> int:
            return sign(cross(self.along(n), less(self.at[m], self.at[n])))

        first = arriving[0]
        for m in arriving[1:]:
            ways = [less(self.at[k], self.at[n]) for k in (m, first)]
            if turn(m) < turn(first) or (turn(m) == turn(first) and cross(*ways) < 0):
                first = m
        return first

    def key_after(self, m: int) -> tuple[int, bool]:
        """Where the curve of edge m ends, the arc or the edge that begins."""
        return self.after[m], self.turns_left(self.after[m])

    def turns_left(self, n: int) -> bool:
        return bool(cross(self.along(self.before[n]), self.along(n)) > 0)

    def far(self, p: Any, f: int) -> int:
        """The sign of the distance of a point from an edge less the radius."""
        a, b = self.edge(f)
        along = self.along(f)
        over = dot(along, less(p, a))
        if sign(over) > 0 and sign(over - dot(along, along)) < 0:
            height = self.height(f, p)
            return sign(height * height - self.square * dot(along, along))
        way = less(p, a if sign(over) <= 0 else b)
        return sign(dot(way, way) - self.square)

    def read_joint(self, value: Json) -> Any:
        root, more, *place = items(value, 4)
        low, (base, part) = number(root), vector(more)
        field = Root(base, part, low)
        demand(low > 0 and sign(field) > 0, "a root is not of a positive number")
        numbers = [[number(c) for c in items(each, 4)] for each in place]
        return tuple(Root(Root(p, q, low), Root(r, s, low), field) for p, q, r, s in numbers)

    def sum(self, claim: Json) -> str:
        names = "claim joints edges arcs components holes digest"
        joints, edges, arcs, components, holes, digest = members(claim, names)[1:]
        self.joints = [self.read_joint(each) for each in items(joints)]
        self.ends: dict[Any, Any] = {}
        self.on: set[tuple[int, int, bool]] = set()
        self.touched: set[tuple[int, int]] = set()
        self.parts: list[tuple[Curve, Place, Place, int]] = []
        self.pieces: list[tuple[Any, Any, Curve]] = []
        self.found: set[int] = set()
        curves = [Curve(self, n) for n in self.next]
        curves += [Curve(self, n, self.before[n]) for n in self.next if self.turns_left(n)]
        walks = [*items(edges, len(self.next)), *items(arcs, len(curves) - len(self.next))]
        for curve, walk in zip(curves, walks, strict=True):
            with within(f"the {'arc' if curve.is_arc else 'curve'} of edge {curve.n}"):
                curve.follow(walk)
        require({j for j, _, _ in self.on} == set(range(len(self.joints))), "a joint is not used")
        for joint, f in self.touched:
            arc = any((joint, n, True) in self.on for n in self.next if self.at[n] in self.edge(f))
            demand(arc or (joint, f, False) in self.on, f"edge {f} has no joint where it touches")
        form = [self.component([items(ring) for ring in items(one)]) for one in items(components)]
        used = [piece for one in components for ring in one for piece in ring]
        require(sorted(used) == list(range(len(self.pieces))), "pieces are not in one ring each")
        classes = {self.root(k) for k in range(len(self.rings))}
        demand(len(form) == len(classes), f"there are {len(classes)} components")
        keys = {key for piece in self.pieces for key in piece[:2]}
        root = roots((a, b) for a, b, _ in self.pieces)
        count = len(self.pieces) - len(keys) + len({root(key) for key in keys}) - len(form)
        demand(integer(holes) == count, f"there are {count} holes")
        made = [{"outer": told(one[0]), "holes": list(map(told, one[1:]))} for one in sorted(form)]
        text = {"components": made, "squared_radius": str(self.square)}
        demand(digest_of(text) == digest, "the sum has another digest")
        return f"sum: {len(form)} components, {count} holes, {digest}"

    def component(self, rings: list[list[Json]]) -> list[Any]:
        """The outer ring and the holes, in the canonical form."""
        pieces = [[self.pieces[index(k, len(self.pieces))] for k in ring] for ring in rings]
        require(bool(pieces) and all(pieces), "a ring is missing or empty")
        for ring in pieces:
            closed = all(a[1] == b[0] for a, b in edges_of(ring))
            demand(closed, "a ring's pieces do not follow each other")
            demand(len({a[0] for a in ring}) == len(ring), "a ring passes a joint twice")
        own = {self.root(self.ring[piece[2].n]) for ring in pieces for piece in ring}
        require(len(own) == 1 and own.isdisjoint(self.found), "rings of several components")
        self.found |= own
        top = max(self.at[n][::-1] for n in self.next if self.root(self.ring[n]) in own)[::-1]
        at = {k for curve, x, y, k in self.parts if curve.is_arc and curve.v == top
              and curve.order(x.mark, (0, 1)) > 0 and curve.order((0, 1), y.mark) >= 0}  # fmt: skip
        demand(bool(at) and at <= set(rings[0]), "the outer ring does not come first")
        outer, *holes = ([piece[2].name() for piece in ring] for ring in pieces)
        return [least(outer), *sorted(map(least, holes))]

    def point(self, claim: Json) -> str:
        """Whether a point is nearer than the radius (-1), or farther (1)."""
        at, distance = members(claim, "claim point distance")[1:]
        p = vector(at)
        self.spend(len(self.next))
        far = min(squared_distance(p, *self.edge(n)) for n in self.next)
        found = -1 if far > 0 and self.winds(p) > 0 else sign(far - self.square)
        demand(integer(distance) == found, "the point is not as far from P")
        return f"point: ({p[0]}, {p[1]}) is {('inside', 'at the radius', 'outside')[found + 1]}"


def least(ring: list[Any]) -> list[Any]:
    """Curves that go on count once; the ring begins so as to be least."""
    names = [
        name for last, name in zip([ring[-1], *ring[:-1]], ring, strict=True) if name != last
    ] or ring[:1]
    return min(names[k:] + names[:k] for k in range(len(names)))


def told(ring: list[Any]) -> Json:
    return [["line" if name[0] else "arc", *map(str, name[1:])] for name in ring]


def of_disc_sums(case: Json, digest: Json, square: Json, claims: Json, budget: Budget) -> list[str]:
    return of_discs(case, digest, square, claims, budget, DiscSum)


FORMS["disc-sum-certificate-v1"] = "square", of_disc_sums


# The last part: the certificate as a whole, and the command.

Verdict = tuple[int, str, list[str]]  # the code, why, what is claimed
Limits = tuple[float, float, float]  # seconds, tests, and bytes of a file
FILES: list[Reader] = [file_bytes, file_bytes]  # read the certificate, and the case
INPUT: list[Reader] = [lambda _, most: sys.stdin.buffer.read(int(most) + 1), file_bytes]


def check(path: Path, case: Path | None, limits: Limits, read: Sequence[Reader]) -> list[str]:
    """The case, and the claims that a certificate proves, as texts. Raises NotVerified."""
    size, budget = limits[2], Budget(*limits[:2])
    certificate = read_json(path, read[0], size, decimals=False)
    form = certificate.get("certificate") if isinstance(certificate, dict) else None
    require(form in tuple(FORMS), f"this is no {' or '.join(FORMS)}, but {form!r}")
    argument, follow = FORMS[form]
    names = f"certificate title? comment? producer? case {argument} claims"
    _, *told, of = (found := members(certificate, names))[:5]
    require(all(t is None or isinstance(t, str) for t in told), "what carries no truth is no text")
    name, digest = members(of, "path sha256")
    steps = name.split("/") if isinstance(name, str) and "\0" not in name else [""]
    require(steps[-1] not in ("", "."), "the path of the case is none")
    inside = case is not None or {"", ".."}.isdisjoint(steps)
    require(inside, f"the case {name} is in another folder: give --case FILE")
    value = read_json(case := case or path.parent / name, read[1], size, decimals=True)
    require(isinstance(value, dict), "this is no case")
    return [f"case {case}, {digest}", *follow(value, digest, *found[5:], budget)]


def verdict(path: Path, case: Path | None, limits: Limits, read: Sequence[Reader]) -> Verdict:
    """The code, why it is not verified, and the case and what is claimed."""
    sys.set_int_max_str_digits(0)
    try:
        return VERIFIED, "", check(path, case, limits, read)
    except NotVerified as error:
        return error.code, str(error), []
    except (MemoryError, RecursionError):
        return OUT_OF_BUDGET, "there is too little memory", []
    finally:
        signal.setitimer(signal.ITIMER_REAL, 0)


def main(arguments: list[str] | None = None) -> int:
    parser = argparse.ArgumentParser(description="Checks certificates of Minkowski sums.")
    parser.add_argument("files", nargs="+", type=Path, metavar="FILE", help="- is standard input")
    parser.add_argument("--case", type=Path, help="the case, instead of the path that is named")
    parser.add_argument("--seconds", type=float, default=600, help="for one certificate (600)")
    parser.add_argument("--tests", type=float, default=1e10, help="elementary tests (10^10)")
    parser.add_argument("--bytes", type=float, default=2**28, help="of a file (2^28)")
    given = parser.parse_args(arguments)
    words = {VERIFIED: "verified", REFUTED: "refuted: ", MALFORMED: "malformed: "}
    limits, codes = (given.seconds, given.tests, given.bytes), set()
    for path in given.files:
        code, why, said = verdict(path, given.case, limits, INPUT if str(path) == "-" else FILES)
        told = f"{path}: {words.get(code, 'out of budget: ')}{why}", *(f"  {line}" for line in said)
        print(*(line.encode("unicode_escape").decode() for line in told), sep="\n", flush=True)
        codes.add(code)
    return next((c for c in (REFUTED, MALFORMED, OUT_OF_BUDGET) if c in codes), VERIFIED)


if __name__ == "__main__":
    try:
        sys.exit(main())
    except OSError:  # nobody takes the verdict
        os._exit(70)
