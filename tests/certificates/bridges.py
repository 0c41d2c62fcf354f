"""A certificate of a bridge and of a disc, written by hand. A slot of width 6 and depth 5, a disc
of radius 5: it touches the mouth's corners (0, 0) and (6, 0) about (3, 4)."""

from __future__ import annotations

import copy
import hashlib
import json

from walls import Value, polygons

SLOT = [["-2", "0"], ["-2", "-9"], ["8", "-9"], ["8", "0"], ["6", "0"], ["6", "-5"], ["0", "-5"],
        ["0", "0"]]  # fmt: skip
CASE: Value = {"P": polygons(SLOT)}
LEFT, RIGHT = ["vertex", 7], ["vertex", 4]
#: Along u the distance from (0, 0) grows, along w that from (6, 0).
BOX = [["3", "127/32"], ["1/24", "1/32"], ["-1/24", "1/32"]]


def digest_of_case(case: Value) -> str:
    plain = [{"holes": p.get("holes", []), "outer": p["outer"]} for p in case["P"]["polygons"]]
    text = json.dumps({"P": plain}, sort_keys=True, separators=(",", ":"))
    return hashlib.sha256(text.encode()).hexdigest()


def certificate() -> Value:
    touch = {"claim": "touch", "centre": ["3", "4"], "features": [LEFT, RIGHT]}
    bridge = {"claim": "bridge", "left": LEFT, "right": RIGHT, "box": BOX}
    return copy.deepcopy({
        "certificate": "feature-certificate-v1",
        "case": {"path": "case.json", "sha256": digest_of_case(CASE)},
        "square": "25",
        "claims": [bridge, touch],
    })  # fmt: skip
