"""Lies about unions, sums with a disc, and bridges."""

from __future__ import annotations

from fractions import Fraction

from minkref.reports.evidence.certificates.forged.ideas import (
    DISC,
    FALSE,
    FEATURE,
    UNION,
    UNPROVED,
    Forgery,
    Maker,
    Unfit,
    case_digest,
    idea,
    sha,
    tight,
)
from minkref.reports.evidence.certificates.forged.raw import Json, Raw


def only(certificate: Json, claim: Json) -> Json:
    certificate["claims"] = [claim]
    return certificate


@idea(FALSE, *UNION)
def union_that_is_another_set(raw: Raw, maker: Maker) -> Json:
    """The polygons lack a set, or have one far away, or a hole that is none, or a vertex a
    little off."""
    certificate = raw.copy()
    claim = maker.claim(certificate, "union")
    polygons = claim["polygons"]
    way = maker.dice.randrange(5)
    e = Fraction(1, 10 ** maker.dice.randint(1, 80))
    if way == 0:
        polygons.pop()
    elif way == 1:
        polygons.append({"holes": [], "outer": [["500", "0"], ["501", "0"], ["500", str(e)]]})
    elif way == 2:
        x, y = (sum(Fraction(v[k]) for v in polygons[0]["outer"][:3]) / 3 for k in (0, 1))
        polygons[0]["holes"].append([[str(a), str(b)] for a, b in
                                     ((x, y), (x, y + e), (x + e, y))])  # fmt: skip
    elif way == 3:
        vertex = maker.dice.choice(maker.dice.choice(polygons)["outer"])
        vertex[maker.dice.randrange(2)] = str(Fraction(vertex[0]) + e + 1)
    else:
        ring = raw.case["sets"][0]["polygons"][0]["outer"]
        claim["polygons"] = [{"holes": [], "outer": ring}]
    return only(certificate, claim)


@idea(FALSE, *UNION)
def union_wound_otherwise(raw: Raw, maker: Maker) -> Json:
    """The right set, wound around twice, or the wrong way round, or all sets side by side though
    they overlap: not wound around once."""
    certificate = raw.copy()
    claim = maker.claim(certificate, "union")
    polygons = claim["polygons"]
    way = maker.dice.randrange(4)
    if way == 0:
        polygons.append(polygons[0])
    elif way == 1:
        polygons[0]["outer"].reverse()
    elif way == 2:
        claim["polygons"] = [polygon for each in raw.case["sets"] for polygon in each["polygons"]]
        if raw.name.startswith("disjoint"):
            claim["polygons"] *= 2
    else:
        polygons[0]["outer"] = polygons[0]["outer"] * 2
    return only(certificate, claim)


@idea(FALSE, *UNION)
def sets_of_a_point(raw: Raw, maker: Maker) -> Json:
    """A point's sets, inside and on: exchanged, lacking a set, with a further set, or told about
    a point elsewhere."""
    certificate = raw.copy()
    sets = raw.case["sets"]
    k = maker.dice.randrange(len(sets))
    corner = sets[k]["polygons"][0]["outer"][0]
    far = [str(maker.dice.randint(600, 900)), "0"]
    n = len(sets)
    ways = [
        {"point": corner, "inside": [k], "on": []}, {"point": far, "inside": [k], "on": []},
        {"point": far, "inside": [], "on": [k]}, {"point": corner, "inside": [], "on": []},
        {"point": corner, "inside": [k], "on": [k]}, {"point": corner, "inside": [], "on": [k, k]},
        {"point": corner, "inside": [], "on": [k - n]}, {"point": corner, "inside": [], "on": [n]},
        {"point": far, "inside": [True], "on": []},
    ]  # fmt: skip
    return only(certificate, {"claim": "point", **maker.dice.choice(ways)})


@idea(FALSE, *UNION)
def meeting_elsewhere(raw: Raw, maker: Maker) -> Json:
    """Vertices and edges said to meet where they do not: a corner of a single set, an edge's end
    called inside, vertices named twice, or with negative numbers."""
    certificate = raw.copy()
    sets = raw.case["sets"]
    corner = sets[0]["polygons"][0]["outer"][0]
    far = len(sets) - 1
    ways = [
        {"point": corner, "vertices": [[0, 0], [far, 1]], "edges": []},
        {"point": corner, "vertices": [[0, 0]], "edges": [[0, 0]]},
        {"point": corner, "vertices": [[0, 0], [0, 0]], "edges": []},
        {"point": corner, "vertices": [[0, 0]], "edges": []},
        {"point": corner, "vertices": [[0, 0]], "edges": [[far, 0]]},
        {"point": corner, "vertices": [], "edges": [[0, 0], [far, 0]]},
        {"point": corner, "vertices": [[0, 0], [far - len(sets), 0]], "edges": []},
        {"point": corner, "vertices": [], "edges": []},
    ]
    return only(certificate, {"claim": "meet", **maker.dice.choice(ways)})


@idea(FALSE, *UNION)
def overlap_that_is_none(raw: Raw, maker: Maker) -> Json:
    """Edges of a single set, edges that only cross or touch or lie far apart, an edge twice, or
    a way reversed, 0 or true."""
    certificate = raw.copy()
    true = [c for c in certificate["claims"] if c["claim"] == "overlap"]
    if true and maker.dice.random() < 0.5:
        claim = maker.dice.choice(true)
        claim["way"] = -claim["way"]
        return only(certificate, claim)
    far = len(raw.case["sets"]) - 1
    ways = [[[0, 0], [0, 1]], [[0, 0], [0, 0]], [[0, 0], [far, 1]], [[0, 0], [far, 0]]]
    claim = {"claim": "overlap", "edges": maker.dice.choice(ways),
             "way": maker.dice.choice([1, -1, 0, True, 2])}  # fmt: skip
    return only(certificate, claim)


@idea(FALSE, *UNION)
def sign_of_vertices(raw: Raw, maker: Maker) -> Json:
    """The wrong sign of a ring's three vertices, which turn left or not; or a line through a
    point given twice."""
    certificate = raw.copy()
    ring = raw.case["sets"][0]["polygons"][0]["outer"]
    (a, b), (c, d), (e, f) = (map(Fraction, ring[i]) for i in range(3))
    value = (c - a) * (f - b) - (d - b) * (e - a)
    true = (value > 0) - (value < 0)
    vertices = [[0, 0], [0, 1], [0, 2]]
    if maker.dice.random() < 0.6:
        sign = maker.pick([s for s in (-1, 0, 1) if s != true])
        claim = {"claim": "sign", "of": ["orientation", vertices], "sign": sign}
    else:
        lines = [[vertices[0], vertices[0]], vertices[:2], vertices[1:]]
        claim = {"claim": "sign", "of": ["concurrent", lines], "sign": 0}
    return only(certificate, claim)


@idea(FALSE, *UNION)
def union_of_other_sets(raw: Raw, maker: Maker) -> Forgery:
    """The case has a further set, or too few, with the new digest; the union stays."""
    certificate, case = raw.copy(), raw.copied_case()
    claim = maker.claim(certificate, "union")
    if maker.dice.random() < 0.5:
        case["sets"].append(
            {"polygons": [{"holes": [], "outer": [["70", "0"], ["71", "0"], ["70", "1"]]}]}
        )
    else:
        case["sets"].pop()
    certificate["case"]["sha256"] = case_digest(case, raw.form)
    return Forgery(tight(only(certificate, claim)), tight(case))


@idea(FALSE, *DISC)
def disc_counts(raw: Raw, maker: Maker) -> Json:
    """Holes more or less, components joined or parted, a ring missing, perhaps with the holes
    that the formula gives then."""
    certificate = raw.copy()
    claim = maker.claim(certificate, "sum")
    components = claim["components"]
    way = maker.dice.randrange(5)
    if way == 0:
        claim["holes"] += maker.dice.choice([1, -1, 2**32])
    elif way == 1 and len(components[0]) > 1:
        components.append([components[0].pop()])
    elif way == 2 and len(components[0]) > 1:
        components[0].pop()
        claim["holes"] -= 1
    elif way == 3 and len(components[0][0]) > 2:
        components[0][0] = components[0][0][::-1]
    else:
        components.append(components[0])
    return certificate


@idea(FALSE, *DISC)
def disc_of_another_radius(raw: Raw, maker: Maker) -> Json:
    """The squared radius changed, a little or much, or the sign: the digest stays."""
    certificate = raw.copy()
    old = Fraction(certificate["square"])
    new = maker.dice.choice([
        old * (1 + Fraction(1, 10 ** maker.dice.randint(1, 60))), -old, Fraction(0), old * 4,
        1 / old,
    ])  # fmt: skip
    if new == old:
        raise Unfit
    certificate["square"] = str(new)
    return only(certificate, maker.claim(certificate, "sum"))


@idea(FALSE, *DISC)
def disc_links_exchanged(raw: Raw, maker: Maker) -> Json:
    """A blocked part called free, or a free part blocked or facing: the boundary has more, or
    lacks a curve."""
    certificate = raw.copy()
    claim = maker.claim(certificate, "sum")
    walks = [w for w in claim["edges"] + claim["arcs"] if w]
    walk = maker.dice.choice(walks)
    spots = range(1, len(walk), 2)
    spot = maker.dice.choice(list(spots))
    edges = len(claim["edges"])
    old = walk[spot]
    edge = maker.dice.randrange(edges)
    walk[spot] = maker.pick([new for new in ("free", edge, [edge]) if new != old])
    claim["digest"] = sha(claim["digest"]) if maker.dice.random() < 0.5 else claim["digest"]
    if isinstance(walk[spot], int) and isinstance(old, int):
        raise Unfit
    return certificate


@idea(FALSE, *DISC)
def joint_elsewhere(raw: Raw, maker: Maker) -> Json:
    """A joint's root with the opposite sign, a negative number's root, a root more, or a
    rational point very near: not where two curves meet."""
    certificate = raw.copy()
    claim = maker.claim(certificate, "sum")
    joint = maker.pick(claim["joints"])
    way = maker.dice.randrange(4)
    if way == 0:
        joint[2][1:] = [str(-Fraction(value)) for value in joint[2][1:]]
        joint[3][1:] = [str(-Fraction(value)) for value in joint[3][1:]]
    elif way == 1:
        joint[maker.dice.randrange(2)] = maker.dice.choice(["-1", "0", ["-1", "0"], ["0", "0"]])
    elif way == 2:
        axis = maker.dice.choice(joint[2:])
        axis[1] = str(Fraction(axis[1]) + maker.dice.choice([-1, 1, 7]))
    else:
        spot = maker.dice.choice(joint[2:])
        spot[0] = str(Fraction(spot[0]) + Fraction(1, 10 ** maker.dice.randint(1, 90)))
    if certificate == raw.certificate:
        raise Unfit
    if way == 0 and not any(Fraction(v) for k in (2, 3) for v in joint[k][1:]):
        raise Unfit
    return certificate


@idea(FALSE, *DISC)
def distance_of_a_point(raw: Raw, maker: Maker) -> Json:
    """Another distance of a point, or the true one about a point that has another."""
    certificate = raw.copy()
    claim = maker.claim(certificate, "point")
    true = claim["distance"]
    if maker.dice.random() < 0.6:
        claim["distance"] = maker.pick([d for d in (-1, 0, 1) if d != true])
    else:
        corner = maker.dice.choice(raw.case["P"]["polygons"][0]["outer"])
        claim.update(point=corner, distance=maker.pick([0, 1]))
    return only(certificate, claim)


@idea(FALSE, *DISC, *FEATURE)
def case_that_is_no_region(raw: Raw, maker: Maker) -> Forgery:
    """A ring twice, reversed, across itself, with a spike, or across another: the case's digest
    is right, the claims concern another set, or no region."""
    certificate, case = raw.copy(), raw.copied_case()
    polygons = case["P"]["polygons"]
    ring = polygons[0]["outer"]
    way = maker.dice.randrange(5 if raw.form in DISC else 2)
    if way == 0:
        polygons.append(polygons[0])
    elif way == 1:
        ring.reverse()
    elif way == 2:
        ring[0], ring[1] = ring[1], ring[0]
    elif way == 3:
        ring += [["-90", "-90"], ring[-1]]
    else:
        polygons.append({"holes": [], "outer": [["-1", "1/2"], ["99", "1/2"], ["99", "3/4"]]})
    certificate["case"]["sha256"] = case_digest(case, raw.form)
    return Forgery(tight(certificate), tight(case))


@idea(UNPROVED, *FEATURE)
def bridge_elsewhere(raw: Raw, maker: Maker) -> Json:
    """A box moved, made huge or flat, or turned inside out: it does not hold the centre."""
    certificate = raw.copy()
    claim = maker.claim(certificate, "bridge")
    p, u, w = claim["box"]
    way = maker.dice.randrange(5)
    if way == 0:
        p[0] = str(Fraction(p[0]) + maker.pick([Fraction(1, 4), -3, 10**9]))
    elif way == 1:
        claim["box"] = [p, [str(1000 * Fraction(v)) for v in u], w]
    elif way == 2:
        claim["box"] = [p, u, u]
    elif way == 3:
        claim["box"] = [p, [str(-Fraction(v)) for v in u], [str(-Fraction(v)) for v in w]]
    else:
        claim["box"] = [p, ["0", "0"], w]
    return only(certificate, claim)


@idea(FALSE, *FEATURE)
def bridge_of_other_features(raw: Raw, maker: Maker) -> Json:
    """Left and right exchanged without the box, a feature twice, a vertex for the edge, or edges
    far from the box."""
    certificate = raw.copy()
    claim = maker.claim(certificate, "bridge")
    left, right = claim["left"], claim["right"]
    vertex = ["vertex" if left[0] == "edge" else "edge", left[1]]
    ways = [(right, left), (left, left), (vertex, right), (["edge", 0], right),
            (left, ["vertex", 0]), (["edge", left[1] - 10**3], right),
            (["edge", True], right)]  # fmt: skip
    claim["left"], claim["right"] = maker.dice.choice(ways)
    if [claim["left"], claim["right"]] == [left, right]:
        raise Unfit
    return only(certificate, claim)


@idea(FALSE, *FEATURE)
def touch_that_is_none(raw: Raw, maker: Maker) -> Json:
    """A disc about a corner of the box, about a point of P, or far away, said to touch."""
    certificate = raw.copy()
    bridge = maker.claim(certificate, "bridge")
    corner = maker.dice.choice(raw.case["P"]["polygons"][0]["outer"])
    centre = maker.dice.choice([bridge["box"][0], corner, ["900", "0"]])
    features = maker.dice.choice([[bridge["left"], bridge["right"]], [bridge["left"]], [],
                                  [bridge["left"], bridge["left"]]])  # fmt: skip
    return only(certificate, {"claim": "touch", "centre": centre, "features": features})


@idea(FALSE, *FEATURE)
def bridge_of_another_disc(raw: Raw, maker: Maker) -> Json:
    """The squared radius changed far beyond what the boxes hold, or to zero and below."""
    certificate = raw.copy()
    old = Fraction(certificate["square"])
    new = maker.dice.choice([old * 4, old / 4, -old, Fraction(0), old * 10**12, old / 10**12])
    certificate["square"] = str(new)
    return certificate


@idea(UNPROVED, *UNION, *DISC, *FEATURE)
def steps_where_none_are(raw: Raw, maker: Maker) -> Json:
    """A member `steps`, `proof` or `axes`, which this form does not have."""
    certificate = raw.copy()
    name, value = maker.dice.choice([("steps", []), ("proof", {}), ("axes", ["1", "1"]),
                                     ("sums", []), ("square", None)])  # fmt: skip
    certificate[name] = value
    return certificate


@idea(FALSE, *FEATURE, raws=("three",))
def touch_with_a_feature_less(raw: Raw, maker: Maker) -> Json:
    """A disc that touches three features said to touch two, and nowhere else; or the centre a
    little off."""
    certificate = raw.copy()
    touches = [c for c in certificate["claims"] if c["claim"] == "touch"]
    edges_only = [c for c in touches if all(f[0] == "edge" for f in c["features"])]
    claim = maker.pick(edges_only)  # beside a vertex that is named its edges need not be
    way = maker.dice.randrange(3)
    if way == 0:
        claim["features"].pop(maker.dice.randrange(len(claim["features"])))
    elif way == 1:
        axis = maker.dice.randrange(2)
        off = Fraction(1, 10 ** maker.dice.randint(0, 60)) * maker.dice.choice([1, -1])
        claim["centre"][axis] = str(Fraction(claim["centre"][axis]) + off)
    else:
        claim["features"][0] = maker.dice.choice([["vertex", 0], ["edge", 0], ["vertex", 2]])
    return only(certificate, claim)
