"""Paths by convex pieces: with an exact test of two convex polygons they are right."""

from __future__ import annotations

from fractions import Fraction
from itertools import pairwise

import pytest
from minkref.fuzz.cases.case_name import CaseName
from minkref.fuzz.motion.asked_path import AskedPath
from minkref.fuzz.motion.path_claim import PathClaim
from minkref.fuzz.motion.path_judgement import judge_path
from minkref.fuzz.plane.protocol import sent_set
from minkref.fuzz.run import naming
from minkref.fuzz.targets.declaration import Declaration
from minkref.fuzz.verdicts.verdict import GOOD
from thoroughness import draws

pytest.importorskip("shapely", "2.1")
from minkref.fuzz.adapters.convex_pieces import Ring, path_of, pieces_of, prism_of

SEED = 5
NEAR = Declaration("t", arithmetic="float64", numbers="double", absolute=Fraction(1, 10**9))
L = [[0, 0], [3, 0], [3, 1], [1, 1], [1, 3], [0, 3]]
HOLE = [[1, 1], [1, 2], [2, 2], [2, 1]]


def meets(one: Ring, other: Ring) -> bool:
    """Whether no side of either has the other on its right."""
    for ring, far in ((one, other), (other, one)):
        for (a, b), (c, d) in zip(ring[-1:] + ring, ring, strict=False):
            if all((c - a) * (y - b) - (d - b) * (x - a) < 0 for x, y in far):
                return False
    return True


def area(ring: Ring) -> float:
    return sum(a * d - b * c for (a, b), (c, d) in zip(ring[-1:] + ring, ring, strict=False)) / 2


def test_paths_by_pieces_are_right() -> None:
    print("seed", SEED)
    answer = path_of(lambda ring: ring, meets)
    for k in range(draws(30, 300)):
        case = naming.load(CaseName(f"path-grid:{SEED}:{k}", "test"))
        assert isinstance(case, AskedPath)
        if "segment" in case.needs:
            continue
        P, Q = (sent_set(text, NEAR) for text in (case.P_json, case.Q_json))
        path = [[float(x) for x in place] for place in case.path]
        said = answer(P, Q, {"path": path, "scales": case.scales})["valid"]
        (outcome,) = judge_path(case, "t", PathClaim(valid=tuple(said)), NEAR)
        assert outcome.verdict in GOOD, (case.literal, outcome)


def test_pieces_cover_a_set_once() -> None:
    frame = {"outer": [[0, 0], [3, 0], [3, 3], [0, 3]], "holes": [HOLE]}
    for polygons, expected in (([{"outer": L, "holes": []}], 5), ([frame], 8)):
        pieces = list(pieces_of({"polygons": polygons}))
        assert sum(map(area, pieces)) == pytest.approx(expected)
        assert all(area(piece) > 0 for piece in pieces)


def test_a_prism_is_closed_and_faces_outwards() -> None:
    vertices, faces = prism_of([(0.0, 0.0), (2.0, 0.0), (0.0, 3.0)])
    sides = [(face[k - 1], face[k]) for face in faces for k in range(len(face))]
    assert sorted(sides) == sorted((b, a) for a, b in sides)
    volume = 0.0
    for face in faces:
        for j, k in pairwise(face[1:]):
            (a, b, c), (d, e, f), (g, h, m) = (vertices[i] for i in (face[0], j, k))
            volume += a * (e * m - f * h) - b * (d * m - f * g) + c * (d * h - e * g)
    assert volume / 6 == 6
