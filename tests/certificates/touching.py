"""A union certificate, written by hand: boxes [0, 2] x [0, 2], [2, 4] x [1, 3] abut partly; a
triangle's tip touches another edge."""

from __future__ import annotations

import copy
import hashlib
import json
from typing import Any

Value = dict[str, Any]


def points(*places: str) -> list[list[str]]:
    return [place.split() for place in places]


def polygons(*outers: list[list[str]]) -> Value:
    return {"polygons": [{"outer": outer, "holes": []} for outer in outers]}


SETS = [
    polygons(points("0 0", "2 0", "2 2", "0 2")),
    polygons(points("2 1", "4 1", "4 3", "2 3")),
    polygons(points("1/2 0", "0 -1", "1 -1")),
]
CASE: Value = {"sets": SETS}
WHOLE = points("0 0", "2 0", "2 1", "4 1", "4 3", "2 3", "2 2", "0 2")
CLAIMS: list[Value] = [
    {"claim": "union", "polygons": polygons(WHOLE, SETS[2]["polygons"][0]["outer"])["polygons"]},
    {"claim": "meet", "point": ["2", "1"], "vertices": [[1, 0]], "edges": [[0, 1]]},
    {"claim": "meet", "point": ["1/2", "0"], "vertices": [[2, 0]], "edges": [[0, 0]]},
    {"claim": "overlap", "edges": [[0, 1], [1, 3]], "way": -1},
    {"claim": "point", "point": ["3", "2"], "inside": [1], "on": []},
    {"claim": "point", "point": ["2", "3/2"], "inside": [], "on": [0, 1]},
    {"claim": "point", "point": ["3", "0"], "inside": [], "on": []},
    {"claim": "sign", "of": ["orientation", [[0, 0], [0, 1], [1, 0]]], "sign": 1},
    {"claim": "sign", "of": ["concurrent", [[[0, 1], [0, 2]], [[1, 0], [1, 1]], [[1, 0], [0, 3]]]],
     "sign": 0},
]  # fmt: skip


def digest_of_case(case: Value) -> str:
    sets = [
        [{"holes": p.get("holes", []), "outer": p["outer"]} for p in one["polygons"]]
        for one in case["sets"]
    ]
    text = json.dumps({"sets": sets}, sort_keys=True, separators=(",", ":"))
    return hashlib.sha256(text.encode()).hexdigest()


def certificate() -> Value:
    """A fresh copy, to be spoilt."""
    value = {
        "certificate": "union-certificate-v1",
        "case": {"path": "case.json", "sha256": digest_of_case(CASE)},
        "claims": CLAIMS,
    }
    return copy.deepcopy(value)
