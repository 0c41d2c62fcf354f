"""A certificate written by hand: two unit squares at scale 1, whose sum is [0, 2] x [0, 2]."""

from __future__ import annotations

import copy
import hashlib
import json
from typing import Any

SQUARE = {"polygons": [{"outer": [["0", "0"], ["1", "0"], ["1", "1"], ["0", "1"]]}]}
CASE = {"P": SQUARE, "Q": SQUARE}


def _digest(value: Any) -> str:
    text = json.dumps(value, sort_keys=True, separators=(",", ":"))
    return hashlib.sha256(text.encode()).hexdigest()


def _plain(operand: Any) -> Any:
    return [{"holes": p.get("holes", []), "outer": p["outer"]} for p in operand["polygons"]]


def digest_of_case(case: Any) -> str:
    return _digest({name: _plain(case[name]) for name in "PQ"})


def digest_of_polygons(polygons: Any) -> str:
    return _digest({"polygons": polygons})


SUM = [{"holes": [], "outer": [["0", "0"], ["2", "0"], ["2", "2"], ["0", "2"]]}]
PIECES: dict[str, Any] = {"rule": "pieces", "of": "P", "pieces": [[0, 1, 2, 3]], "groups": []}
EQ: dict[str, Any] = {
    "rule": "eq",
    "scales": ["1"],
    "by": [0, 1],
    "box": ["-1", "-1", "3", "3"],
    "elements": [
        ["P", 0, 1, 0],  # 4: y = 0
        ["P", 1, 2, 1],  # 5: x = 2
        ["P", 2, 3, 2],  # 6: y = 2
        ["Q", 3, 0, 0],  # 7: x = 0
        *(["meet", a, b] for a, b in ((7, 4), (4, 5), (5, 6), (6, 7))),  # 8 to 11, the sum's
        *(["meet", a, b] for a, b in ((0, 1), (1, 2), (2, 3), (3, 0))),  # 12 to 15, the box's
    ],
    "cells": [[8, 9, 10, 11], [12, 13, 9, 8], [13, 14, 10, 9], [14, 15, 11, 10], [15, 12, 8, 11]],
    "normals": [[0, -1], [1, 0], [0, 1], [-1, 0]],
    "proofs": [["cov", 0, 0], ["sep", 0], ["sep", 1], ["sep", 2], ["sep", 3]],
    "contacts": [],
    "polygons": [[[8, 9, 10, 11]]],
}
CLAIM: dict[str, Any] = {
    "claim": "sum",
    "scale": "1",
    "step": 2,
    "components": 1,
    "holes": 0,
    "digest": _digest({"polygons": SUM}),
}


def certificate() -> dict[str, Any]:
    """A fresh copy, to be spoilt."""
    value = {
        "certificate": "certificate-v1",
        "case": {
            "path": "case.json",
            "sha256": _digest({"P": _plain(SQUARE), "Q": _plain(SQUARE)}),
        },
        "steps": [PIECES, {**PIECES, "of": "Q"}, EQ],
        "claims": [CLAIM],
    }
    return copy.deepcopy(value)


MOVING = [
    {
        "holes": [],
        "outer": [
            ["0", "0", "0", "0"],
            ["1", "1", "0", "0"],
            ["1", "1", "1", "1"],
            ["0", "0", "1", "1"],
        ],
    }
]
_VERTICAL, _HORIZONTAL = (0, 7, 5, 2), (1, 4, 6, 3)  # lines of EQ, from left to right and upwards


def _corner(i: int, j: int) -> int:
    return 8 + 4 * i + j


# Nine cells, as all edges must keep their directions; the one in the middle is the sum.
MOVE: dict[str, Any] = {
    **EQ,
    "rule": "move",
    "scales": ["1", "2"],
    "box": ["-1", "-1", "4", "4"],
    "elements": [*EQ["elements"][:4], *(["meet", a, b] for a in _VERTICAL for b in _HORIZONTAL)],
    "cells": [
        [_corner(i, j), _corner(i + 1, j), _corner(i + 1, j + 1), _corner(i, j + 1)]
        for i in range(3)
        for j in range(3)
    ],
    "proofs": [*(["sep", 3],) * 3, *(["sep", 0], ["cov", 0, 0], ["sep", 2]), *(["sep", 1],) * 3],
    "polygons": [[[_corner(1, 1), _corner(2, 1), _corner(2, 2), _corner(1, 2)]]],
}
BEFORE = {**MOVE, "scales": ["1/2", "1"]}
INTERVAL: dict[str, Any] = {
    "claim": "interval",
    "from": "1",
    "to": "2",
    "steps": [3],
    "components": 1,
    "holes": 0,
    "digest": _digest({"polygons": MOVING}),
}


def moving_certificate() -> dict[str, Any]:
    """No event from 1 to 2: the sum is [0, s + 1] x [0, s + 1]."""
    value = certificate()
    value["steps"].append(copy.deepcopy(MOVE))
    value["claims"].append(copy.deepcopy(INTERVAL))
    return value
