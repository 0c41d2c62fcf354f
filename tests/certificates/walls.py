"""Certificates of a path and of a trap, written by hand. The part [2, 3] x [0, 1], its origin at
(0, 0), and the walls [1, 4] x [0, 1] and [6, 9] x [0, 1]: it is between them at the scale 2 alone.
A square in a room with a door: it is trapped at the scales in (1, 4]."""

from __future__ import annotations

import copy
import hashlib
import json
from typing import Any

Value = dict[str, Any]


def box(x: int, y: int, X: int, Y: int) -> list[list[str]]:
    return [[str(a), str(b)] for a, b in ((x, y), (X, y), (X, Y), (x, Y))]


def polygons(*outers: list[list[str]]) -> Value:
    return {"polygons": [{"outer": outer} for outer in outers]}


def scales(low: str, high: str | None, is_in: str) -> Value:
    """`is_in`: as "(]"."""
    return {"from": low, "to": high, "from_in": is_in[0] == "[", "to_in": is_in[1] == "]"}


def _plain(operand: Any) -> Any:
    return [{"holes": p.get("holes", []), "outer": p["outer"]} for p in operand["polygons"]]


def digest_of_case(case: Value) -> str:
    value = {"O": _plain(case["O"]), "R": _plain(case["R"]), "path": case["path"]}
    text = json.dumps(value, sort_keys=True, separators=(",", ":"))
    return hashlib.sha256(text.encode()).hexdigest()


CASE: Value = {
    "R": polygons(box(2, 0, 3, 1)),
    "O": polygons(box(1, 0, 4, 1), box(6, 0, 9, 1)),
    "path": [["0", "0"]],
}
PIECES: list[Value] = [
    {"rule": "pieces", "of": "R", "pieces": [[0, 1, 2, 3]], "groups": []},
    {"rule": "pieces", "of": "O", "pieces": [[0, 1, 2, 3], [4, 5, 6, 7]], "groups": [[0, 1]]},
]


def clear(told: Value, normals: Any, *codes: list[int], contact: str = "allowed") -> Value:
    return {
        "rule": "clear", "by": [0, 1], "contact": contact, "path": None, "scales": told,
        "normals": normals, "codes": list(codes),
    }  # fmt: skip


def hit(told: Value, node: int, points: Any, contact: str = "allowed") -> Value:
    one = {"segment": 0, "nodes": [0, node], "points": points}
    return {"claim": "hit", "contact": contact, "scales": told, "by": [0, 1], "hits": [one]}


def free(told: Value, step: int, contact: str = "allowed") -> Value:
    return {"claim": "free", "contact": contact, "scales": told, "step": step}


LOW, ALONE, HIGH = scales("0", "1/3", "(]"), scales("2", "2", "[]"), scales("9/2", None, "[)")
CLAIMS: list[Value] = [
    free(LOW, 2),
    hit(scales("1/3", "2", "()"), 0, [["0", "1/3", ["1", "1/6"]], ["0", "1", ["5/2", "1/2"]],
                                      ["0", "2", ["4", "1/2"]]]),
    free(ALONE, 3),
    hit(scales("2", "9/2", "()"), 1, [["0", "2", ["6", "1/2"]], ["0", "3", ["7", "1/2"]],
                                      ["0", "9/2", ["9", "1/2"]]]),
    free(HIGH, 4),
    {"claim": "valid", "contact": "allowed", "scales": scales("0", None, "()"),
     "valid": [LOW, ALONE, HIGH], "claims": [0, 1, 2, 3, 4]},
]  # fmt: skip


def certificate() -> Value:
    """A fresh copy, to be spoilt."""
    value = {
        "certificate": "path-certificate-v1",
        "case": {"path": "case.json", "sha256": digest_of_case(CASE)},
        "steps": [
            *PIECES,
            clear(LOW, [[-1, 0]], [0]),
            clear(ALONE, [[1, 0], [-1, 0]], [-2, 0, 1]),
            clear(HIGH, [[1, 0]], [0]),
        ],
        "claims": CLAIMS,
    }
    return copy.deepcopy(value)


ROOM_CASE: Value = {
    "R": polygons(
        [["-1/2", "-1/2"], ["1/2", "-1/2"], ["1/2", "1/2"], ["-1/2", "1/2"]],
    ),
    "O": polygons(  # [0, 4] x [0, 4] is free, with a door on the right
        [["-1", "-1"], ["5", "-1"], ["5", "0"], ["5", "3/2"], ["4", "3/2"], ["4", "0"], ["0", "0"],
         ["0", "4"], ["4", "4"], ["4", "5/2"], ["5", "5/2"], ["5", "4"], ["5", "5"], ["-1", "5"],
         ["-1", "4"], ["-1", "0"]],
    ),
    "path": [["2", "2"]],
}  # fmt: skip
ROOM_PIECES: list[Value] = [  # the walls below, on the left, above, and on both sides of the door
    PIECES[0],
    {"rule": "pieces", "of": "O", "pieces": [[0, 1, 2, 5, 6, 15], [15, 6, 7, 14],
     [14, 7, 8, 11, 12, 13], [5, 2, 3, 4], [9, 10, 11, 8]], "groups": [[0, 1, 2, 3, 4]]},
]  # fmt: skip
OUT, HELD, OVER = scales("0", "1", "(]"), scales("1", "4", "(]"), scales("4", None, "()")
AXES = [[1, 0], [-1, 0], [0, 1], [0, -1]]
#: Where one wall, moved, meets the next; it does not move.
RING = [["9/2", "0", "0", "0"], ["9/2", "0", "2", "0"], ["9/2", "0", "4", "0"],
        ["-1/4", "0", "4", "0"], ["-1/4", "0", "0", "0"]]  # fmt: skip


def room() -> Value:
    """A fresh copy: the part escapes up to the scale 1 through the door, is trapped up to 4, and
    collides above."""
    way = [["2", "2"], ["6", "2"]]
    value = {
        "certificate": "path-certificate-v1",
        "case": {"path": "case.json", "sha256": digest_of_case(ROOM_CASE)},
        "steps": [
            *ROOM_PIECES,
            {**clear(OUT, AXES, [-2, 2, 0, 3, 2, 3]), "path": way},
            clear(HELD, AXES, [-2, 2, 0, 3, 1, 1]),
        ],
        "claims": [
            {"claim": "escapes", "contact": "allowed", "scales": OUT, "step": 2, "normal": [1, 0]},
            {"claim": "trapped", "contact": "allowed", "scales": HELD, "step": 3, "by": [0, 1],
             "ring": RING, "pairs": [[0, 3], [0, 4], [0, 2], [0, 1], [0, 0]]},
            hit(OVER, 0, [["0", "4", ["2", "0"]], ["0", "5", ["2", "-1/4"]], "up"]),
            {"claim": "trap", "contact": "allowed", "scales": scales("0", None, "()"),
             "trapped": [HELD], "claims": [0, 1, 2]},
        ],
    }  # fmt: skip
    return copy.deepcopy(value)


#: A square of side 1, its corner the origin, left of a door of its width.
DOOR_CASE: Value = {
    "R": polygons(box(0, 0, 1, 1)),
    "O": polygons(box(0, -1, 1, 0), box(0, 1, 1, 2)),
    "path": [["-2", "0"]],
}
SHUTS = scales("0", "1", "()")


def door() -> Value:
    """A fresh copy: up to where the door shuts the part gets out through its middle, which moves
    with the scale."""
    middle = "1/2", "-1/2"
    way = [["-2", "0"], ["-2", "0", *middle], ["2", "0", *middle]]
    codes = [[0], [-2, 1, 2]]
    step = clear(SHUTS, [[-1, 0], [0, 1], [0, -1]], *codes, contact="forbidden")
    escapes = {
        "claim": "escapes", "contact": "forbidden", "scales": SHUTS, "step": 2, "normal": [1, 0],
    }  # fmt: skip
    value = {
        "certificate": "path-certificate-v1",
        "case": {"path": "case.json", "sha256": digest_of_case(DOOR_CASE)},
        "steps": [*PIECES, {**step, "path": way}],
        "claims": [escapes],
    }
    return copy.deepcopy(value)
