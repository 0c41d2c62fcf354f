"""Lies about single points and signs in the plane."""

from __future__ import annotations

from collections.abc import Sequence
from fractions import Fraction

from minkref.reports.evidence.certificates.forged.figures import vertices
from minkref.reports.evidence.certificates.forged.ideas import (
    FALSE,
    PLANE,
    UNPROVED,
    Maker,
    Unfit,
    idea,
)
from minkref.reports.evidence.certificates.forged.raw import Json, Raw

INTERVALS = ("still", "later", "topology")


@idea(FALSE, *PLANE, raws=("inside",))
def parents_outside(raw: Raw, maker: Maker) -> Json:
    """A far point equals `s p + q`, with p or q far outside the piece: only this fails."""
    certificate = raw.copy()
    claim = certificate["claims"][0]
    far = Fraction(maker.dice.randint(50, 10**6), maker.dice.choice([1, 7]))
    axis = maker.dice.randrange(2)
    name = maker.dice.choice("pq")
    claim[name][axis] = str(Fraction(claim[name][axis]) + far)
    s = Fraction(claim["scale"]) if name == "p" else 1
    claim["point"][axis] = str(Fraction(claim["point"][axis]) + far * s)
    return certificate


@idea(FALSE, *PLANE, raws=("inside",))
def parents_in_a_group(raw: Raw, maker: Maker) -> Json:
    """p lies within the hull of the L, not within the L: `pieces` names a group, or a piece
    without p."""
    certificate = raw.copy()
    claim = certificate["claims"][0]
    corners = vertices(raw.case["P"])
    (a, _), (_, b) = corners[1], corners[-1]
    p = [(a + 1) / 2 - Fraction(1, 8), (b + 1) / 2 - Fraction(1, 8)]
    if p[0] <= 1 or p[1] <= 1:
        raise Unfit
    pieces = certificate["steps"][claim["by"][0]]
    claim["p"] = [str(value) for value in p]
    s = Fraction(claim["scale"])
    claim["point"] = [str(s * u + Fraction(v)) for u, v in zip(p, claim["q"], strict=True)]
    claim["pieces"][0] = maker.dice.randrange(len(pieces["pieces"]) + len(pieces["groups"]))
    return certificate


@idea(FALSE, *PLANE, raws=("apart",))
def inside_called_outside(raw: Raw, maker: Maker) -> Json:
    """A point `s p + q` of vertices belongs to the sum, and the claim says outside, with another
    point's code, with normals of any size, or with codes that show nothing."""
    certificate = raw.copy()
    claim = certificate["claims"][0]
    s = Fraction(claim["scale"])
    p, q = maker.dice.choice(vertices(raw.case["P"])), maker.dice.choice(vertices(raw.case["Q"]))
    claim["point"] = [str(s * p[0] + q[0]), str(s * p[1] + q[1])]
    way = maker.dice.randrange(5)
    if way == 1:
        claim["normals"] = [[n[0] * 10**40, n[1] * 10**40] for n in claim["normals"]]
    elif way == 2:
        claim["code"] = maker.dice.choice([[], [-1], [-1, -1, -1], [-2], [-2, -1, -1]])
    elif way == 3:
        claim["normals"] = [[0, 0] for _ in claim["normals"]]
    elif way == 4:
        claim["normals"] = [[str(n[0]), f"{n[1]}.0"] for n in claim["normals"]]
    return certificate


@idea(FALSE, *PLANE, raws=("apart",))
def boundary_called_outside(raw: Raw, maker: Maker) -> Json:
    """The point farthest along the normal that held another point apart: on the boundary, so
    within the sum, and weakly apart from each pair of pieces."""
    certificate = raw.copy()
    claim = certificate["claims"][0]
    s, normal = Fraction(claim["scale"]), claim["normals"][0]
    axes = raw.certificate.get("axes", ("1", "1"))

    def farthest(points: Sequence[tuple[Fraction, Fraction]]) -> tuple[Fraction, Fraction]:
        return max(points, key=lambda point: normal[0] * point[0] + normal[1] * point[1])

    p, q = farthest(vertices(raw.case["P"], axes)), farthest(vertices(raw.case["Q"]))
    claim["point"] = [str(s * p[0] + q[0]), str(s * p[1] + q[1])]
    size = maker.dice.choice([1, maker.dice.randint(2, 10**30)])
    claim["normals"] = [[size * n for n in normal]]
    claim["code"] = [0 if entry >= 0 else entry for entry in claim["code"]]
    return certificate


@idea(FALSE, PLANE[0], raws=("signs",))
def another_sign(raw: Raw, maker: Maker) -> Json:
    """A sign turned, a zero made a sign or a sign a zero; all else stays."""
    certificate = raw.copy()
    claim = maker.claim(certificate, "sign")
    claim["sign"] = maker.pick([sign for sign in (-1, 0, 1) if sign != claim["sign"]])
    return certificate


@idea(FALSE, PLANE[0], raws=("signs",))
def sign_beyond_its_root(raw: Raw, maker: Maker) -> Json:
    """A window with a single sign goes on beyond the root, or a zero at a single scale claimed
    over a window."""
    certificate = raw.copy()
    claim = maker.claim(certificate, "sign")
    zero = next(c["from"] for c in certificate["claims"] if not c["sign"])
    if claim["sign"] == 0:
        claim["to"] = str(Fraction(zero) * 2)
    elif claim["to"] == zero:
        claim["to"] = str(Fraction(zero) * Fraction(maker.dice.randint(3, 9), 2))
    else:
        claim["from"] = str(Fraction(zero) / maker.dice.randint(2, 10**6))
    return certificate


@idea(UNPROVED, PLANE[0], raws=("signs",))
def sign_of_a_line_through_one_point(raw: Raw, maker: Maker) -> Json:
    """Three lines, one through one point given twice, are concurrent in any case."""
    certificate = raw.copy()
    point, other, third = [0, 0], [1, 0], [2, 0]
    lines = [[point, point], [other, third], [point, third]]
    maker.dice.shuffle(lines)
    claim = {"claim": "sign", "of": ["concurrent", lines], "from": "1", "to": "2", "sign": 0}
    certificate["claims"].append(claim)
    return certificate
