#!/usr/bin/env python3
"""An adapter for `minkref verify` in Python without dependencies: sums of convex polygons.

Put your own call into `minkowski_sum`, and say in HELLO what it can do
(docs/adapter-protocol.md has the words). Try it: minkref verify ./NAME_adapter.py
"""

import json
import math
import sys
from typing import Any

HELLO: dict[str, Any] = {
    "protocol": "adapter-v1",
    "name": "NAME",
    "version": "1",
    "language": "Python",
    "arithmetic": "float64",
    "numbers": "double",
    "tolerance": {"absolute": "0", "relative": "1e-9"},
    "sum": "region",
    "capabilities": ["plane"],
}


def minkowski_sum(P: list[Any], Q: list[Any]) -> list[Any]:
    """PUT YOUR OWN CALL HERE. P and Q are lists of polygons, each with the ring "outer", a list of
    [x, y] counter-clockwise, and "holes", rings clockwise. The sum is a list of rings: the points
    that they wind around. To be asked for more than convex polygons, declare "non-convex", "holes"
    and "components"."""
    return [convex_sum(P[0]["outer"], Q[0]["outer"])]


def offset(P: list[Any], radius: float) -> list[Any]:
    """P grown by a disc, likewise: here the sum with a polygon of 128 corners. To be asked for it,
    declare "offset", and in the tolerance "radius": "0.0004"."""
    angles = [math.tau * k / 128 for k in range(128)]
    disc = [[radius * math.cos(a), radius * math.sin(a)] for a in angles]
    return [convex_sum(P[0]["outer"], disc)]


def convex_sum(P: list[Any], Q: list[Any]) -> list[Any]:
    """The edges of both rings in the order of their directions, from the leftmost vertices."""
    P, Q = (ring[(k := ring.index(min(ring))) :] + ring[: k + 1] for ring in (P, Q))
    ring, i, j = [], 0, 0
    while i < len(P) - 1 or j < len(Q) - 1:
        ring.append([P[i][0] + Q[j][0], P[i][1] + Q[j][1]])
        turn = 1 if j == len(Q) - 1 else -1
        if i < len(P) - 1 and j < len(Q) - 1:
            (a, b), (c, d), (e, f), (g, h) = P[i], P[i + 1], Q[j], Q[j + 1]
            turn = (c - a) * (h - f) - (d - b) * (g - e)
        i, j = i + (turn >= 0), j + (turn <= 0)
    return ring


loaded: list[Any] = []
for line in sys.stdin:
    seq, verb = None, None
    try:
        request = json.loads(line)
        seq, verb = request.get("seq"), request.get("verb")
        answer: dict[str, Any] = {"status": "result"}
        if verb == "hello":
            answer.update(HELLO)
        elif verb == "load":
            loaded = request["Q"]["polygons"]
        elif verb == "at":
            answer["rings"] = minkowski_sum(request["sP"]["polygons"], loaded)
        elif verb == "offset":
            answer["rings"] = offset(request["P"]["polygons"], request["radius"])
        elif verb != "stop":
            answer = {"status": "skipped", "reason": "no such verb here"}
    except Exception as error:  # noqa: BLE001 the answer says what went wrong
        answer = {"status": "errored", "reason": repr(error)}
    print(json.dumps({"seq": seq, **answer}), flush=True)
    if verb == "stop":
        break
