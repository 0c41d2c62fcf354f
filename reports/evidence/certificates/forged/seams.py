"""Passages along seams: where an operand is a point or a segment, contacts prove nothing, and
every condition but that one holds."""

from __future__ import annotations

from collections.abc import Sequence
from fractions import Fraction

from minkref.reports.evidence.certificates.forged.figures import Point, edges, elements, vertices
from minkref.reports.evidence.certificates.forged.ideas import FALSE, PLANE, Maker, Unfit, idea
from minkref.reports.evidence.certificates.forged.plane_steps import sum_step
from minkref.reports.evidence.certificates.forged.raw import Json, Raw


def members(pieces: Json, points: Sequence[Point]) -> tuple[list[list[Point]], list[list[int]]]:
    """The corners of each node's pieces, and each node's members."""
    corners = [[points[i] for i in piece] for piece in pieces["pieces"]]
    below: list[list[int]] = [[] for _ in corners]
    for group in pieces["groups"]:
        corners.append([corner for m in group for corner in corners[m]])
        below.append(group)
    return corners, below


def most(n: tuple[int, int], points: Sequence[Point]) -> Fraction:
    return max(n[0] * x + n[1] * y for x, y in points)


def code_of(ends: Sequence[Point], P: Json, Q: Json, normals: list[tuple[int, int]]) -> list[int]:
    """A code that holds the ends weakly apart from all pairs of pieces, with a grid's normals.
    Raises Unfit where no code does."""
    (cornersP, belowP), (cornersQ, belowQ) = P, Q
    ways = [(a, b) for a in range(-6, 7) for b in range(-6, 7) if a or b]
    code: list[int] = []
    stack = [(len(cornersP) - 1, len(cornersQ) - 1)]
    while stack:
        a, b = stack.pop()
        found = next((n for n in ways if min(n[0] * x + n[1] * y for x, y in ends)
                      >= most(n, cornersP[a]) + most(n, cornersQ[b])), None)  # fmt: skip
        if found is not None:
            if found not in normals:
                normals.append(found)
            code.append(normals.index(found))
        elif belowQ[b]:
            code.append(-2)
            stack += [(a, m) for m in reversed(belowQ[b])]
        elif belowP[a]:
            code.append(-1)
            stack += [(m, b) for m in reversed(belowP[a])]
        else:
            raise Unfit
    return code


@idea(FALSE, PLANE[0], raws=("place", "line"))
def passage_along_a_seam(raw: Raw, maker: Maker) -> Json:
    """A passage along a seam between two pieces of Q, with a point or a segment as P: normals
    hold each pair of pieces weakly apart, cells on both sides are covered, and the sum of the
    interiors has all of the seam."""
    certificate = raw.copy()
    claim, step = sum_step(certificate)
    s = Fraction(claim["scale"])
    points = elements(step, raw.case, ("1", "1"), s)
    P = members(certificate["steps"][step["by"][0]],
                [(s * x, s * y) for x, y in vertices(raw.case["P"])])  # fmt: skip
    Q = members(certificate["steps"][step["by"][1]], vertices(raw.case["Q"]))
    owner = {edge: c for c, cell in enumerate(step["cells"]) for edge in edges(cell)}
    shared = [edge for edge, c in owner.items() if edge[::-1] in owner
              and step["proofs"][c][0] == "cov"
              and step["proofs"][owner[edge[::-1]]][0] == "cov"]  # fmt: skip
    path = list(maker.pick(shared))
    normals = [(n[0], n[1]) for n in step["normals"]]
    ends = [points[i] for i in path]
    code = code_of(ends, P, Q, normals)
    size = maker.dice.randint(1, 99)
    step["normals"] = [[size * a, size * b] for a, b in normals]
    step["contacts"] = [[path, *code]]
    shown = [[str(v) for v in end] for end in ends]
    claim = {"claim": "passage", "scale": claim["scale"], "step": claim["step"], "points": shown}
    certificate["claims"].append({**claim, "path": path})
    return certificate
