"""Whole derivations for an operand, true step by step, under another operand's case: the hull,
a part, the filled set, a ring that winds twice."""

from __future__ import annotations

from collections.abc import Sequence
from fractions import Fraction

from minkref.reports.evidence.certificates.forged.ideas import (
    FALSE,
    PLANE,
    SOLID,
    Forgery,
    Maker,
    Unfit,
    case_digest,
    idea,
    tight,
)
from minkref.reports.evidence.certificates.forged.plane_steps import only_sum, sum_step
from minkref.reports.evidence.certificates.forged.raw import Json, Raw

SIMPLE = ("ell", "hull", "two", "filled", "tight", "axes")
Corner = Sequence[str]


def rings(operand: Json) -> list[list[Corner]]:
    return [ring for polygon in operand["polygons"]
            for ring in [polygon["outer"], *polygon["holes"]]]  # fmt: skip


def outer_only(corners: Sequence[Sequence[Corner]]) -> Json:
    return {"polygons": [{"holes": [], "outer": ring} for ring in corners]}


def under(raw: Raw, certificate: Json, P: Json) -> Forgery:
    """The derivation with P's vertices numbered as in the new P, whose vertices hold all of
    them. Claims and digests stay."""
    old = [corner for ring in rings(raw.case["P"]) for corner in ring]
    new = [tuple(corner) for ring in rings(P) for corner in ring]
    number = {i: new.index(tuple(corner)) for i, corner in enumerate(old)}
    for step in certificate["steps"]:
        if step["rule"] == "pieces":
            if step["of"] == "P":
                step["pieces"] = [[number[i] for i in piece] for piece in step["pieces"]]
            continue
        for element in step["elements"]:
            if element[0] == "P":
                element[1:3] = [number[i] for i in element[1:3]]
            elif element[0] == "Q":
                element[3] = number[element[3]]
    case = {**raw.copied_case(), "P": P}
    certificate["case"] = {"path": "it.case.json", "sha256": case_digest(case, raw.form)}
    return Forgery(tight(certificate), tight(case))


def extra(dice: Json) -> list[Corner]:
    """A triangle far away, or near the origin."""
    x, y = dice.randint(30, 90), dice.randint(-9, 9)
    return [[str(x), str(y)], [str(x + 2), str(y)], [str(x), str(y + 1)]]


@idea(FALSE, *PLANE, raws=SIMPLE)
def sum_of_a_part(raw: Raw, maker: Maker) -> Forgery:
    """P has a polygon that the derivation does not know: the claimed sum lacks this polygon's.
    The piece may be there, and belong to no group, or not to the last."""
    certificate = raw.copy()
    only_sum(certificate)
    corners = rings(raw.case["P"])
    base = sum(map(len, corners))
    P = {
        "polygons": [
            *raw.copied_case()["P"]["polygons"],
            *outer_only([extra(maker.dice)])["polygons"],
        ]
    }
    pieces = next(s for s in certificate["steps"] if s.get("of") == "P")
    way = maker.dice.randrange(3)
    made = under(raw, certificate, P)
    if way:
        n = len(pieces["pieces"])
        pieces["pieces"].insert(n if way == 1 else 0, [base, base + 1, base + 2])

        def shift(m: int) -> int:
            return m + (m >= n) if way == 1 else m + 1

        pieces["groups"] = [[shift(m) for m in group] for group in pieces["groups"]]
        _, step = sum_step(certificate)
        for proof in step["proofs"]:
            if proof[0] == "cov":
                proof[1] = shift(proof[1])
        if not pieces["groups"]:
            pieces["groups"] = [[shift(0)]]
        made = Forgery(tight(certificate), made.case)
    return made


@idea(FALSE, PLANE[0], raws=("plate",))
def hole_unknown(raw: Raw, maker: Maker) -> Forgery:
    """P has a hole, much wider than Q, that the pieces do not know, or know as a piece that runs
    clockwise, so that all edges cancel: the claimed sum matches the filled set."""
    certificate = raw.copy()
    only_sum(certificate)
    P = raw.copied_case()["P"]
    base = len(P["polygons"][0]["outer"])
    e, f = (str(Fraction(maker.dice.randint(n, n + 9), 10)) for n in (1, 30))
    P["polygons"][0]["holes"] = [[[e, e], [e, f], [f, e]]]
    way = maker.dice.randrange(4)
    made = under(raw, certificate, P)
    pieces = next(s for s in certificate["steps"] if s.get("of") == "P")
    if way:
        pieces["pieces"].append([[base, base + 1, base + 2], [base, base + 2, base + 1],
                                 [base, base + 1]][way - 1])  # fmt: skip
        pieces["groups"] = [[0, 1]]
        made = Forgery(tight(certificate), made.case)
    return made


@idea(FALSE, PLANE[0], raws=("ell",))
def hull_taken_as_solid(raw: Raw, maker: Maker) -> Forgery:
    """The derivation for the hull of an L, with the L's own true pieces, and their group in
    place of the hull: everything holds, but the group is not solid."""
    turn = raw.name.removeprefix("ell")
    hull = next((r for r in maker.raws if r.name == f"hull{turn}"), None)
    if hull is None:
        raise Unfit
    certificate = hull.copy()
    only_sum(certificate)
    made = under(hull, certificate, raw.copied_case()["P"])
    spot = next(n for n, s in enumerate(certificate["steps"]) if s.get("of") == "P")
    true = next(s for s in raw.copy()["steps"] if s.get("of") == "P")
    certificate["steps"][spot] = true
    last = len(true["pieces"]) + len(true["groups"]) - 1
    _, step = sum_step(certificate)
    for proof in step["proofs"]:
        if proof[0] == "cov":
            proof[1] = last
    way = maker.dice.randrange(3)
    if way == 1:
        true["groups"].append([last])
        for proof in step["proofs"]:
            if proof[0] == "cov":
                proof[1] = last + 1
    elif way == 2:
        old = certificate["steps"][spot]
        old["pieces"].append([0, 1, 2, 4, 5])
        old["groups"][-1].append(len(old["pieces"]) - 1)
    return Forgery(tight(certificate), made.case)


@idea(FALSE, PLANE[0], raws=("hull",))
def star_as_its_hull(raw: Raw, maker: Maker) -> Forgery:
    """P as a pentagram, a ring that winds twice, with the hull's corners. This very ring serves
    as piece, so all edges cancel; but it turns twice around, and the set is not the hull."""
    corners = rings(raw.case["P"])[0]
    if len(corners) != 5:
        raise Unfit
    certificate = raw.copy()
    only_sum(certificate)
    star = [corners[0], corners[2], corners[4], corners[1], corners[3]]
    made = under(raw, certificate, outer_only([star]))
    pieces = next(s for s in certificate["steps"] if s.get("of") == "P")
    pieces["pieces"] = [maker.dice.choice([[0, 1, 2, 3, 4], [0, 3, 1, 4, 2], [2, 3, 4, 0, 1]])]
    return Forgery(tight(certificate), made.case)


@idea(FALSE, PLANE[0], raws=("gap",))
def overlap_for_a_gap(raw: Raw, maker: Maker) -> Forgery:
    """Two rectangles of P overlap just as much as their hull has more than both: areas add up to
    the hull's, here taken as solid. The derivation matches the hull."""
    certificate = raw.copy()
    only_sum(certificate)
    corners = rings(raw.case["P"])[0]
    far = corners[2]
    one = [["0", "0"], ["4", "0"], ["4", "4"], ["0", "4"]]
    other = [["3", "0"], ["7", "0"], ["7", far[1]], ["3", far[1]]]
    pair = [one, other] if maker.dice.random() < 0.5 else [other, one]
    made = under(raw, certificate, outer_only(pair))
    pieces = next(s for s in certificate["steps"] if s.get("of") == "P")
    pieces.update(pieces=[[0, 1, 2, 3], [4, 5, 6, 7]], groups=[maker.dice.choice([[0, 1], [1, 0]])])
    _, step = sum_step(certificate)
    for proof in step["proofs"]:
        if proof[0] == "cov":
            proof[1] = 2
    return Forgery(tight(certificate), made.case)


@idea(FALSE, *SOLID, raws=("solid", "wide", "whole"))
def solid_of_another_shape(raw: Raw, maker: Maker) -> Forgery:
    """The derivation for another solid, whose corners become `points` under this case: each
    piece, plane and tree is true of that solid, and so are volume and digest."""
    other = maker.another(raw)
    certificate = other.copy()
    same = certificate["claims"][0]["digest"] == raw.certificate["claims"][0]["digest"]
    if same or other.case == raw.case:
        raise Unfit
    for name in "PQ":
        mine, theirs = raw.case[name], other.case[name]
        if mine == theirs:
            continue
        n = len(mine["vertices"])
        pieces = certificate["proof"][name]
        pieces["points"] = theirs["vertices"] + pieces["points"]
        pieces["hulls"] = [[n + i for i in hull] for hull in pieces["hulls"]]
        used = sorted({i for hull in pieces["hulls"] for i in hull})
        number = {old: n + k for k, old in enumerate(used)}
        pieces["points"] = [pieces["points"][i - n] for i in used]
        pieces["hulls"] = [[number[i] for i in hull] for hull in pieces["hulls"]]
    certificate["case"] = raw.copy()["case"]
    return Forgery(tight(certificate), tight(raw.case))
