"""A certificate of a sum with a disc, written by hand: two unit squares, 1 apart, and a disc of
radius 1. Arcs about (1, 1) and (2, 1) meet, and about (1, 0) and (2, 0)."""

from __future__ import annotations

import copy

from bridges import digest_of_case
from walls import Value, polygons

CASE: Value = {
    "P": polygons(
        [["0", "0"], ["1", "0"], ["1", "1"], ["0", "1"]],
        [["2", "0"], ["3", "0"], ["3", "1"], ["2", "1"]],
    )
}
FREE = [None, "free", None]
HIGH = ["3/4", ["1", "0"], ["3/2", "0", "0", "0"], ["1", "1", "0", "0"]]
LOW = ["3/4", ["1", "0"], ["3/2", "0", "0", "0"], ["0", "-1", "0", "0"]]
RING = [6, 0, 7, 10, 3, 11, 4, 12, 5, 13, 8, 1, 9, 2]
DIGEST = "9f409f045cbab2a70dd32bd56515bcaa426dd1b62cca87d7dd62c5661e3e817d"


def certificate() -> Value:
    total = {
        "claim": "sum",
        "joints": [HIGH, LOW],
        "edges": [FREE, [None, 7, None], FREE, FREE, FREE, FREE, FREE, [None, 1, None]],
        "arcs": [FREE, [None, "free", 1, 7, None], [None, 7, 0, "free", None], FREE,
                 [None, 1, 1, "free", None], FREE, FREE, [None, "free", 0, 1, None]],
        "components": [[RING]],
        "holes": 0,
        "digest": DIGEST,
    }  # fmt: skip
    points = [
        {"claim": "point", "point": point, "distance": distance}
        for point, distance in ((["3/2", "1/2"], -1), (["2", "2"], 0), (["5", "5"], 1))
    ]
    return copy.deepcopy({
        "certificate": "disc-sum-certificate-v1",
        "case": {"path": "case.json", "sha256": digest_of_case(CASE)},
        "square": "1",
        "claims": [total, *points],
    })  # fmt: skip
