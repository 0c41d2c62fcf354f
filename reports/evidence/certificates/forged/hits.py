"""Lies about collisions along paths."""

from __future__ import annotations

from fractions import Fraction

from minkref.reports.evidence.certificates.forged.ideas import (
    FALSE,
    PATH,
    UNPROVED,
    Maker,
    Unfit,
    idea,
)
from minkref.reports.evidence.certificates.forged.motions import alone, claim_of
from minkref.reports.evidence.certificates.forged.raw import Json, Raw


@idea(FALSE, *PATH, raws=("path", "away", "trap"))
def hit_below_contact(raw: Raw, maker: Maker) -> Json:
    """A collision claimed at smaller scales than true; the first entry follows, or a further
    entry comes before."""
    certificate = raw.copy()
    claim = claim_of(certificate, "hit")
    low = Fraction(claim["scales"]["from"])
    if not low:
        raise Unfit
    new = str(low * Fraction(maker.dice.randint(1, 999), 1000))
    claim["scales"]["from"] = new
    points = claim["hits"][0]["points"]
    if maker.dice.random() < 0.5:
        points[0][1] = new
    else:
        points.insert(0, [points[0][0], new, points[0][2]])
    return alone(certificate, claim)


@idea(FALSE, *PATH, raws=("path", "trap", "away"))
def hit_in_a_hull(raw: Raw, maker: Maker) -> Json:
    """A collision at small scales claimed inside the hull of all obstacles, whose node is not
    solid: the place remains free."""
    certificate = raw.copy()
    claim = claim_of(certificate, "hit")
    obstacles = certificate["steps"][1]
    last = len(obstacles["pieces"]) + len(obstacles["groups"]) - 1
    x, y = map(Fraction, raw.case["path"][0])
    p = Fraction(1, 10)
    scales = {"from": "1/9", "to": "1/5", "from_in": False, "to_in": False}
    points = [
        ["0", s, [str(x + p * Fraction(s)), str(y + p * Fraction(s))]]
        for s in ("1/9", "1/7", "1/5")
    ]
    claim.update(scales=scales, hits=[{"segment": 0, "nodes": [0, last], "points": points}])
    return alone(certificate, claim)


@idea(FALSE, *PATH, raws=("path", "trap", "away"))
def hit_off_the_path(raw: Raw, maker: Maker) -> Json:
    """A collision beyond the path's ends (t below 0 or above 1), at a negative scale, on a
    segment that does not exist, or with entries out of order."""
    certificate = raw.copy()
    claim = claim_of(certificate, "hit")
    hit = claim["hits"][0]
    way = maker.dice.randrange(6)
    points = hit["points"]
    if way == 0:
        for point in points:
            if point != "up":
                point[0] = str(Fraction(point[0]) + maker.dice.choice([-1, 2, 7]))
    elif way == 1:
        points[0][1] = f"-{maker.dice.randint(1, 9)}"
    elif way == 2:
        hit["segment"] = maker.dice.choice([len(raw.case["path"]), -1, 10**20, True, "0"])
    elif way == 3:
        hit["points"] = points[::-1]
    elif way == 4:
        hit["points"] = ["up"]
    else:
        hit["points"] = [points[0], "up", *points[1:]]
    return alone(certificate, claim)


@idea(UNPROVED, *PATH, raws=("path", "trap", "away"))
def hits_with_a_gap(raw: Raw, maker: Maker) -> Json:
    """A collision parted into two, with scales missing between; or the second begins before the
    first, or the first comes twice. The claim holds, and lacks a proof at some scales."""
    certificate = raw.copy()
    claim = claim_of(certificate, "hit")
    hit = claim["hits"][0]
    first, second, *rest = hit["points"]
    if second == "up":
        raise Unfit

    def between(part: Fraction) -> Json:
        (t, s, y), (u, r, z) = first, second
        pairs = [(t, u), (s, r), *zip(y, z, strict=True)]
        a, b, *c = [str(Fraction(v) + part * (Fraction(w) - Fraction(v))) for v, w in pairs]
        return [a, b, c]

    low = Fraction(maker.dice.randint(1, 400), 1000)
    high = low + Fraction(1, 10 ** maker.dice.randint(1, 40))
    one = {**hit, "points": [first, between(low)]}
    other = {**hit, "points": [between(high), second, *rest]}
    claim["hits"] = maker.dice.choice([[one, other], [other, one], [one, one, other], [one]])
    return alone(certificate, claim)
