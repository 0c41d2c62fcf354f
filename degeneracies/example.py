"""Checks an implementation of the Minkowski sum with the corpus. Plain Python, none of our code.

python3 example.py [FOLDER]: exit code 0 if all is right, 1 if something is wrong, 2 without cases
"""

import json
import sys
from fractions import Fraction
from itertools import pairwise
from pathlib import Path


def minkowski_sum(P, Q, s):
    """Put yours here: returns area, components and holes of sP + Q, None for unknown values. This
    function takes the hull of vertex sums: right for convex operands."""
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
    return area, 1, 0


corpus = Path(sys.argv[1] if len(sys.argv) > 1 else Path(__file__).parent / "corpus")
cases = [json.loads(path.read_text()) for path in sorted(corpus.glob("*/*.json"))]
cases = [case for case in cases if case.get("schema") == "case-v1"]
in_space = sum(case["dimension"] == 3 for case in cases)
cases = [case for case in cases if case["dimension"] == 2]
wrong = {}
for case in cases:
    for expected in case["expected"]:
        truth = Fraction(expected["area"]), expected["components"], expected["holes"]
        try:
            answer = minkowski_sum(case["P"], case["Q"], Fraction(expected["scale"]))
            right = all(a is None or a == t for a, t in zip(answer, truth, strict=True))
        except Exception as error:  # noqa: BLE001 yours may raise anything
            answer, right = [repr(error)], False
        if not right:
            wrong.setdefault(case["id"], f"{', '.join(map(str, answer))} at {expected['scale']}")
for name, answer in wrong.items():
    print(f"wrong: {name}: {answer[:70]}")
print(f"{len(cases)} cases, {len(wrong)} wrong; {in_space} in space are left out")
sys.exit(1 if wrong else 0 if cases else 2)
