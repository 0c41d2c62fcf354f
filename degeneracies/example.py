"""Checks an implementation of the Minkowski sum with the corpus. Plain Python, none of our code.

python3 example.py [FOLDER]
"""

import json
import sys
from fractions import Fraction
from itertools import pairwise
from pathlib import Path


def area_of_sum(P, Q, s):
    """Put yours here. This one takes the hull of sums of vertices: right for convex operands."""
    corners = [
        [tuple(map(Fraction, v)) for polygon in operand["polygons"] for v in polygon["outer"]]
        for operand in (P, Q)
    ]
    points = sorted({(s * a + c, s * b + d) for a, b in corners[0] for c, d in corners[1]})
    area = Fraction(0)
    for run in (points, points[::-1]):
        chain = []
        for x, y in run:
            while len(chain) > 1 and (chain[-1][0] - chain[-2][0]) * (y - chain[-1][1]) <= (
                chain[-1][1] - chain[-2][1]
            ) * (x - chain[-1][0]):
                chain.pop()
            chain.append((x, y))
        area += sum(a * d - b * c for (a, b), (c, d) in pairwise(chain)) / 2
    return area


corpus = Path(sys.argv[1] if len(sys.argv) > 1 else Path(__file__).parent / "corpus")
cases = [json.loads(path.read_text()) for path in sorted(corpus.glob("*/*.json"))]
cases = [case for case in cases if case.get("schema") == "case-v1"]
wrong = {}
for case in cases:
    for expected in case["expected"]:
        answer = area_of_sum(case["P"], case["Q"], Fraction(expected["scale"]))
        if answer != Fraction(expected["area"]):
            wrong.setdefault(case["id"], f"{answer} at {expected['scale']}")
for name, answer in wrong.items():
    print(f"wrong: {name}: area {answer[:60]}")
print(f"{len(cases)} cases, {len(wrong)} wrong")
