#!/usr/bin/env python3
"""Checks certificates (convex-certificate-v1) of sums SP + Q of convex polyhedra:
`python3 check_convex.py FILE...`.

It stands alone: this file and the standard library. What the members mean, what is demanded and
why that is enough: docs/certificates-convex.md. All is decided in integers and fractions. What is
unknown, unused or left over makes a certificate malformed.

Exit codes: 0 verified; 1 refuted; 2 malformed, or its case is missing; 4 out of budget.
"""

from __future__ import annotations

import argparse
import hashlib
import itertools
import json
import os
import re
import sys
import time
import zlib
from collections.abc import Iterator, Sequence
from contextlib import contextmanager
from fractions import Fraction
from math import gcd, lcm
from pathlib import Path
from typing import Any

VERIFIED, REFUTED, MALFORMED, OUT_OF_BUDGET = 0, 1, 2, 4
FORM = "convex-certificate-v1"
NUMBER = re.compile(r"[+-]?(\d+(\.\d*)?|\.\d+)([eE][+-]?(\d{1,3}|1000))?|[+-]?\d+/\d+", re.ASCII)
SURROGATE = re.compile(r"(?<!\\)(\\\\)*\\u[dD][89a-fA-F]")
MOST_DIGITS = 100_000  # of one number

Json = Any
Point = tuple[Fraction, Fraction, Fraction]
Vector = tuple[int, int, int]
Verdict = tuple[int, str, list[str]]  # the code, why, what is claimed


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
    """What is wrong inside is said with its place."""
    try:
        yield
    except NotVerified as error:
        raise NotVerified(error.code, f"{place}: {error}") from error


def members(value: Json, names: str) -> list[Json]:
    """The members of an object, in the order of `names`. No other may be there; `name?` may lack
    and is None then."""
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


def integer(value: Json) -> int:
    require(isinstance(value, int) and not isinstance(value, bool), f"{value!r} is no integer")
    return int(value)


def indices(value: Json, end: int) -> list[int]:
    numbers = [integer(entry) for entry in items(value)]
    require(all(0 <= i < end for i in numbers), f"one of {numbers[:9]}... is no number here")
    return numbers


def number(value: Json) -> Fraction:
    if not isinstance(value, str):
        return Fraction(integer(value))
    good = len(value) <= MOST_DIGITS and NUMBER.fullmatch(value)
    require(bool(good) and not re.search("/0+$", value), f"{value[:60]!r} is no number")
    return Fraction(value)


def vector(value: Json) -> Point:
    x, y, z = map(number, items(value, 3))
    return x, y, z


def read_json(path: Path, most: float, decimals: bool) -> Json:
    def unique(pairs: list[tuple[str, Json]]) -> Json:
        require(len(dict(pairs)) == len(pairs), "an object has a member twice")
        return dict(pairs)

    def refuse(text: str) -> Json:
        raise NotVerified(MALFORMED, f"{text[:60]} is no number here")

    def whole_number(text: str) -> int:
        return int(text) if len(text) <= MOST_DIGITS else refuse(text)

    try:
        require(os.path.isfile(path), f"{str(path)[:400]} cannot be read: it is no file")
        with path.open("rb") as file:
            data = file.read(int(most) + 1)
        if data[:2] == b"\x1f\x8b" and len(data) <= most:
            packed = zlib.decompressobj(wbits=31)
            data = packed.decompress(data, int(most) + 1)
            whole = len(data) > most or (packed.eof and not packed.unused_data)
            require(whole, f"{path} is not one whole compressed file")
        demand(len(data) <= most, f"{path} has over {most:,.0f} bytes (--bytes)", OUT_OF_BUDGET)
        text = data.decode()
        require(not SURROGATE.search(text), f"{path} escapes a surrogate")
        real = str if decimals else refuse
        hooks: Json = {"parse_constant": refuse, "parse_float": real, "parse_int": whole_number}
        return json.loads(text, object_pairs_hook=unique, **hooks)
    except OSError as error:
        raise NotVerified(MALFORMED, f"{path} cannot be read: {error.strerror}") from error
    except (ValueError, OverflowError, RecursionError, zlib.error) as error:
        raise NotVerified(MALFORMED, f"{path} is not JSON: {error}") from error


def digest_of(value: Json) -> str:
    text = json.dumps(value, sort_keys=True, separators=(",", ":"))
    return hashlib.sha256(text.encode()).hexdigest()


def dot(u: Vector, v: Vector) -> int:
    return u[0] * v[0] + u[1] * v[1] + u[2] * v[2]


def cross(u: Vector, v: Vector) -> Vector:
    return u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]


def times(factors: Sequence[Any], point: Sequence[Any]) -> Vector:
    """The products, which are whole numbers."""
    return int(factors[0] * point[0]), int(factors[1] * point[1]), int(factors[2] * point[2])


def heights(normal: Vector, points: Sequence[Vector]) -> list[int]:
    a, b, c = normal
    return [a * x + b * y + c * z for x, y, z in points]


def turn(a: Vector, b: Vector, c: Vector, normal: Vector) -> int:
    """Positive if the way a b c turns left, seen against the normal."""
    u, v = ((q[0] - p[0], q[1] - p[1], q[2] - p[2]) for p, q in ((a, b), (b, c)))
    return dot(cross(u, v), normal)


def edges_of(ring: Sequence[Any]) -> Iterator[tuple[Any, Any]]:
    return zip(ring, [*ring[1:], *ring[:1]], strict=True)


def is_ring(ring: Sequence[int]) -> bool:
    return len(set(ring)) == len(ring) >= 3


def area_and_normal(ring: Sequence[Vector]) -> tuple[Vector, Vector]:
    """Twice the area, as a vector to the side from which the ring runs counter-clockwise; the
    shortest whole vector along it."""
    x, y, z = map(sum, zip(*(cross(*edge) for edge in edges_of(ring)), strict=True))
    divisor = gcd(x, y, z) or 1
    return (x, y, z), (x // divisor, y // divisor, z // divisor)


def is_closed(rings: Sequence[list[int]]) -> bool:
    """Whether each directed edge is in one ring only, and its reverse in one."""
    edges = [edge for ring in rings for edge in edges_of(ring)]
    there = set(edges)
    return len(there) == len(edges) and all((b, a) in there for a, b in edges)


def hull_in_plane(points: Sequence[Vector], normal: Vector) -> list[Vector]:
    """The corners of the hull of points in a plane, in which lexicographic order is a sweep."""
    both: list[Vector] = []
    for run in (sorted(points), sorted(points, reverse=True)):
        chain: list[Vector] = []
        for p in run:
            while len(chain) > 1 and turn(chain[-2], chain[-1], p, normal) <= 0:
                chain.pop()
            chain.append(p)
        both += chain[:-1]
    return both


class Budget:
    def __init__(self, seconds: float, tests: float) -> None:
        self.deadline, self.tests = time.monotonic() + seconds, tests

    def spend(self, tests: int) -> None:
        self.tests -= tests
        left = self.tests >= 0 and time.monotonic() < self.deadline
        demand(left, "a limit is reached (--seconds, --tests)", OUT_OF_BUDGET)


class Operand:
    """A polyhedron, its vertices and faces in the order of the file."""

    def __init__(self, value: Json, name: str) -> None:
        self.name, (vertices, faces) = name, members(value, "vertices faces")
        self.exact = [vector(vertex) for vertex in items(vertices)]
        self.faces = [indices(face, len(self.exact)) for face in items(faces)]
        rings = bool(self.faces) and all(map(is_ring, self.faces))
        require(rings, f"{name} has a face that is no ring, or none")
        used = len(set(itertools.chain(*self.faces))) == len(self.exact)
        require(used, f"{name} has a vertex in no face")

    def plain(self) -> Json:
        """What is hashed: numbers in lowest terms."""
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
                covered += dot(area, first) if normal == first else 0
        once = dot(area_and_normal(hull_in_plane(at_top, first))[0], first)
        require(covered == once, f"{self.name} goes around its hull more than once")


def greatest(levels: list[int]) -> list[int]:
    """Where the greatest ones are."""
    most = max(levels)
    return [i for i, level in enumerate(levels) if level == most]


class Sum:
    """The sum at a scaling: a closed surface, each vertex S p + q, each facet in a plane that P and
    Q, where they are farthest along its normal, reach together."""

    def __init__(self, value: Json, P: Operand, Q: Operand, unit: int, budget: Budget) -> None:
        scaling, vertices, facets = members(value, "scaling vertices facets")
        self.scaling = vector(scaling)
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
        used = len(set(itertools.chain(*self.rings))) == len(pairs)
        require(used, "a vertex is in no facet")
        budget.spend(sum(ends))
        common = lcm(*(factor.denominator for factor in self.scaling))
        self.unit = unit * common
        self.P = [times([common * factor for factor in self.scaling], p) for p in P.points]
        self.Q = [times((common, common, common), q) for q in Q.points]
        sums = (zip(self.P[p], self.Q[q], strict=True) for p, q in pairs)
        self.points = [(a + d, b + e, c + f) for (a, d), (b, e), (c, f) in sums]
        demand(self.points == sorted(set(self.points)), "the vertices do not ascend")
        demand(is_closed(self.rings), "the facets are not closed")
        self.normals: set[Vector] = set()
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
        level = dot(normal, corners[0])
        demand(set(heights(normal, corners)) == {level}, "it is not planar")
        ways = zip(corners, corners[1:] + corners[:1], corners[2:] + corners[:2], strict=True)
        demand(all(turn(*way, normal) > 0 for way in ways), "it does not turn left")
        levels = heights(normal, self.P), heights(normal, self.Q)
        demand(sum(map(max, levels)) == level, "the sum reaches beyond its plane")
        demand([of_P, of_Q] == [*map(greatest, levels)], "other vertices of P or Q are farthest")
        self.sextuple += dot(area, corners[0])

    def check_claim(self, claim: list[Json]) -> str:
        """What is claimed."""
        scaling, vertices, facets, volume, digest = claim
        demand(vector(scaling) == self.scaling, "the sum is at another scaling")
        counts = [integer(vertices), integer(facets)] == [len(self.points), len(self.rings)]
        demand(counts, "vertices or facets are not so many")
        found = Fraction(self.sextuple, 6 * self.unit**3)
        demand(number(volume) == found, "the volume is another")
        plain = [[str(Fraction(c, self.unit)) for c in point] for point in self.points]
        same = digest_of({"faces": self.rings, "vertices": plain}) == digest
        demand(same, "the digest is another")
        at = ", ".join(map(str, self.scaling))
        return f"sum: at ({at}), {vertices} vertices, {facets} facets, volume {found}, {digest}"


def check(path: Path, case: Path | None, seconds: float, tests: float, size: float) -> list[str]:
    """What a certificate proves. Raises NotVerified."""
    certificate = read_json(path, size, decimals=False)
    form = certificate.get("certificate") if isinstance(certificate, dict) else None
    require(form == FORM, f"this is no {FORM}, but {form!r}")
    names = "certificate title? comment? producer? case sums claims"
    _, *told, of, entries, claims = members(certificate, names)
    require(all(t is None or isinstance(t, str) for t in told), "what carries no truth is no text")
    name, digest = members(of, "path sha256")
    good = isinstance(name, str) and "\0" not in name and name.split("/")[-1] not in ("", ".")
    require(good, "the path of the case is none")
    value = read_json(case or path.parent / name, size, decimals=True)
    in_space = isinstance(value, dict) and type(value.get("dimension")) is int
    require(in_space and value["dimension"] == 3, "this is no case in space")
    P, Q = (Operand(value.get(operand), operand) for operand in "PQ")
    demand(digest_of({"P": P.plain(), "Q": Q.plain()}) == digest, "not the case that is certified")
    budget, unit = Budget(seconds, tests), 1
    for point in P.exact + Q.exact:
        unit = lcm(unit, *(c.denominator for c in point))
        budget.spend(1 + unit.bit_length() // 64)
    for operand in (P, Q):
        operand.check(unit, budget)
    sums: list[Sum] = []
    for entry in items(entries):
        with within(f"sum {len(sums)}"):
            sums.append(Sum(entry, P, Q, unit, budget))
    require(len({one.scaling for one in sums}) == len(sums), "two sums are at one scaling")
    require(len(set(map(digest_of, items(claims)))) == len(claims), "a claim is made twice")
    said: list[str] = []
    used: set[int] = set()
    for claim in claims:
        with within(f"claim {len(said)}"):
            budget.spend(64)
            kind, i, *more = members(claim, "claim sum scaling vertices facets volume digest")
            require(kind == "sum", f"there is no claim {kind!r}")
            used |= {*indices([i], len(sums))}
            said.append(sums[i].check_claim(more))
    require(bool(said) and len(used) == len(sums), "nothing is claimed, or a sum is not used")
    return said


def verdict(path: Path, case: Path | None, seconds: float, tests: float, size: float) -> Verdict:
    """The code, why it is not verified, and what is claimed."""
    sys.set_int_max_str_digits(0)
    try:
        return VERIFIED, "", check(path, case, seconds, tests, size)
    except NotVerified as error:
        return error.code, str(error), []
    except (MemoryError, RecursionError):
        return OUT_OF_BUDGET, "there is too little memory", []


def main(arguments: list[str] | None = None) -> int:
    parser = argparse.ArgumentParser(description="Checks certificates of sums of convex polyhedra.")
    parser.add_argument("files", nargs="+", type=Path, metavar="FILE")
    parser.add_argument("--case", type=Path, help="the case, instead of the path that is named")
    parser.add_argument("--seconds", type=float, default=600, help="for one certificate (600)")
    parser.add_argument("--tests", type=float, default=1e10, help="elementary tests (10^10)")
    parser.add_argument("--bytes", type=float, default=2**28, help="of a file, unpacked (2^28)")
    given = parser.parse_args(arguments)
    words = {VERIFIED: "verified", REFUTED: "refuted: ", MALFORMED: "malformed: "}
    codes = set()
    for path in given.files:
        code, why, said = verdict(path, given.case, given.seconds, given.tests, given.bytes)
        told = f"{path}: {words.get(code, 'out of budget: ')}{why}", *(f"  {line}" for line in said)
        print(*(line.encode("unicode_escape").decode() for line in told), sep="\n", flush=True)
        codes.add(code)
    return next((c for c in (REFUTED, MALFORMED, OUT_OF_BUDGET) if c in codes), VERIFIED)


if __name__ == "__main__":
    try:
        sys.exit(main())
    except OSError:  # nobody takes the verdict
        os._exit(70)
