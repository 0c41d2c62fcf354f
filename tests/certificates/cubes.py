"""Certificates of sums of convex polyhedra without the producer: one by hand, of two unit cubes;
and that of any two bodies, by the independent hull."""

from __future__ import annotations

import copy
import hashlib
import itertools
import json
from fractions import Fraction
from typing import Any

from minkref.fuzz.geometry.polyhedron import Polyhedron
from minkref.fuzz.geometry.space import Point, Whole, area_vector, dot
from minkref.fuzz.space.hull import sum_of_convex

Value = dict[str, Any]
RINGS = [[0, 1, 3, 2], [0, 2, 6, 4], [0, 4, 5, 1], [1, 5, 7, 3], [2, 3, 7, 6], [4, 6, 7, 5]]


def cube_of(side: str) -> Value:
    """[0, side]^3: vertex 4x + 2y + z is at side (x, y, z)."""
    return {"vertices": [list(v) for v in itertools.product(("0", side), repeat=3)], "faces": RINGS}


CUBE = cube_of("1")
CASE: Value = {"dimension": 3, "P": CUBE, "Q": CUBE}


def digest_of(value: Any) -> str:
    text = json.dumps(value, sort_keys=True, separators=(",", ":"))
    return hashlib.sha256(text.encode()).hexdigest()


def digest_of_case(case: Value) -> str:
    return digest_of({name: in_lowest_terms(case[name]) for name in "PQ"})


def in_lowest_terms(body: Value) -> Value:
    """The hashed part of an operand or of a sum: faces, and vertices in lowest terms."""
    vertices = [[str(Fraction(c)) for c in vertex] for vertex in body["vertices"]]
    return {"faces": body["faces"], "vertices": vertices}


SUM: Value = {
    "scaling": ["1", "1", "1"],
    "vertices": [[i, i] for i in range(8)],
    "facets": [[ring, sorted(ring), sorted(ring)] for ring in RINGS],
}
CLAIM: Value = {
    "claim": "sum",
    "sum": 0,
    "scaling": ["1", "1", "1"],
    "vertices": 8,
    "facets": 6,
    "volume": "8",
    "digest": digest_of(cube_of("2")),
}


def certificate() -> Value:
    """[0, 1]^3 + [0, 1]^3 = [0, 2]^3. A fresh copy, to be spoilt."""
    value = {
        "certificate": "convex-certificate-v1",
        "case": {"path": "case.json", "sha256": digest_of_case(CASE)},
        "sums": [SUM],
        "claims": [CLAIM],
    }
    return copy.deepcopy(value)


def case_of(P: Polyhedron, Q: Polyhedron) -> Value:
    return {"dimension": 3, "P": P.document(), "Q": Q.document()}


def polyhedron(body: Value) -> Polyhedron:
    """Its numbers as JSON has them, or as texts."""
    return Polyhedron.from_document(in_lowest_terms(body))


def certificate_of(P: Polyhedron, Q: Polyhedron, scalings: list[Point]) -> Value:
    """The only certificate of these sums there is, apart from how numbers are written."""
    sums, claims = [], []
    for scaling in scalings:
        body = sum_of_convex(P, Q, scaling)
        sums.append(proof_of(P, Q, scaling, body))
        claims.append(claim_of(len(claims), scaling, body))
    return {
        "certificate": "convex-certificate-v1",
        "case": {"path": "case.json", "sha256": digest_of_case(case_of(P, Q))},
        "sums": sums,
        "claims": claims,
    }


def claim_of(number: int, scaling: Point, body: Polyhedron) -> Value:
    return {
        "claim": "sum",
        "sum": number,
        "scaling": [str(s) for s in scaling],
        "vertices": len(body.vertices),
        "facets": len(body.faces),
        "volume": str(body.volume),
        "digest": digest_of(body.document()),
    }


def proof_of(P: Polyhedron, Q: Polyhedron, scaling: Point, body: Polyhedron) -> Value:
    scaled = P.scaled(scaling)
    made = {
        tuple(a + b for a, b in zip(p, q, strict=True)): [i, j]
        for i, p in enumerate(scaled.vertices)
        for j, q in enumerate(Q.vertices)
    }
    facets = []
    for face in body.faces:
        normal = area_vector([body.wholes[i] for i in face])
        facets.append([list(face), farthest(normal, scaled), farthest(normal, Q)])
    return {
        "scaling": [str(s) for s in scaling],
        "vertices": [made[vertex] for vertex in body.vertices],
        "facets": facets,
    }


def claim_about(number: int, one: Value, case: Value) -> Value:
    """The claim of a false sum: its own vertices, rings and volume, whatever they are."""
    scaling = whole_scaling(*one["scaling"])
    P, Q = polyhedron(case["P"]).scaled(scaling), polyhedron(case["Q"])
    made = (zip(P.vertices[p], Q.vertices[q], strict=True) for p, q in one["vertices"])
    vertices = [[str(a + b) for a, b in pair] for pair in made]
    rings = [ring for ring, _, _ in one["facets"]]
    body = polyhedron({"vertices": vertices, "faces": rings})
    sextuple = sum(dot(area_vector([body.wholes[i] for i in f]), body.wholes[f[0]]) for f in rings)
    return {
        "claim": "sum",
        "sum": number,
        "scaling": one["scaling"],
        "vertices": len(vertices),
        "facets": len(rings),
        "volume": str(Fraction(sextuple, 6 * body.denominator**3)),
        "digest": digest_of(body.document()),
    }


def farthest(normal: Whole, body: Polyhedron) -> list[int]:
    heights = [dot(normal, point) for point in body.wholes]
    return [i for i, height in enumerate(heights) if height == max(heights)]


def whole_scaling(*factors: int | str) -> Point:
    x, y, z = (Fraction(factor) for factor in factors)
    return x, y, z
