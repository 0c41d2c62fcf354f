"""Lies about sums of polyhedra, and about points of such sums."""

from __future__ import annotations

from fractions import Fraction

from minkref.reports.evidence.certificates.forged.ideas import (
    CONVEX,
    FALSE,
    POINTS,
    SOLID,
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


def told_again(raw: Raw, certificate: Json) -> Json:
    """Claims the counts, volume and digest from the changed vertices and facets of the first
    sum. Raises Unfit where they are the true ones."""
    total = certificate["sums"][0]
    factors = [Fraction(value) for value in total["scaling"]]
    P, Q = (raw.case[name]["vertices"] for name in "PQ")
    points = [
        [f * Fraction(a) + Fraction(b) for f, a, b in zip(factors, P[p], Q[q], strict=True)]
        for p, q in total["vertices"]
    ]
    rings = [facet[0] for facet in total["facets"]]
    volume = Fraction(0)
    for ring in rings:
        n = [Fraction(0)] * 3
        for i in range(len(ring)):
            a, b = points[ring[i - 1]], points[ring[i]]
            for k in range(3):
                n[k] += a[k - 2] * b[k - 1] - a[k - 1] * b[k - 2]
        volume += sum(x * y for x, y in zip(n, points[ring[0]], strict=True)) / 6
    form = {"faces": rings, "vertices": [[str(v) for v in point] for point in points]}
    claim = certificate["claims"][0]
    new = {"vertices": len(points), "facets": len(rings), "volume": str(volume),
           "digest": sha(tight(form))}  # fmt: skip
    if new["digest"] == claim["digest"]:
        raise Unfit
    claim.update(new)
    return certificate


def drop_unused(total: Json) -> None:
    used = sorted({i for facet in total["facets"] for i in facet[0]})
    number = {old: new for new, old in enumerate(used)}
    total["vertices"] = [total["vertices"][i] for i in used]
    for facet in total["facets"]:
        ring = [number[i] for i in facet[0]]
        start = ring.index(min(ring))
        facet[0] = ring[start:] + ring[:start]
    total["facets"].sort()


@idea(FALSE, *CONVEX)
def facet_missing(raw: Raw, maker: Maker) -> Json:
    """A facet lacks, and all figures match the rest."""
    certificate = raw.copy()
    total = certificate["sums"][0]
    total["facets"].pop(maker.dice.randrange(len(total["facets"])))
    drop_unused(total)
    return told_again(raw, certificate)


@idea(FALSE, *CONVEX)
def facet_in_triangles(raw: Raw, maker: Maker) -> Json:
    """A diagonal parts a facet: the same set, a facet more, and a digest from no canonical form."""
    certificate = raw.copy()
    facets = certificate["sums"][0]["facets"]
    ring, of_p, of_q = maker.pick([facet for facet in facets if len(facet[0]) > 3])
    facets.remove([ring, of_p, of_q])
    cut = maker.dice.randrange(2, len(ring) - 1)
    facets += [[ring[: cut + 1], of_p, of_q], [[ring[0], *ring[cut:]], of_p, of_q]]
    facets.sort()
    return told_again(raw, certificate)


@idea(FALSE, *CONVEX)
def corner_cut_off(raw: Raw, maker: Maker) -> Json:
    """A corner cut off: the facets lose it, and a new facet closes the gap. A closed polyhedron
    within the sum, with true figures for itself."""
    certificate = raw.copy()
    total = certificate["sums"][0]
    corner = maker.dice.randrange(len(total["vertices"]))
    after = {}
    kept = []
    for ring, of_p, of_q in total["facets"]:
        if corner in ring:
            spot = ring.index(corner)
            after[ring[(spot + 1) % len(ring)]] = ring[spot - 1]
            ring = [i for i in ring if i != corner]
        if len(ring) > 2:
            kept.append([ring, of_p, of_q])
    start = min(after)
    lid = [start]
    back = {b: a for a, b in after.items()}
    while back[lid[-1]] != start:
        lid.append(back[lid[-1]])
    kept.append([lid, *maker.dice.choice(kept)[1:]])
    total["facets"] = kept
    drop_unused(total)
    return told_again(raw, certificate)


@idea(FALSE, *CONVEX)
def inside_out(raw: Raw, maker: Maker) -> Json:
    """All facets, or a single facet, turned: a set with negative volume."""
    certificate = raw.copy()
    facets = certificate["sums"][0]["facets"]
    chosen = facets if maker.dice.random() < 0.5 else [maker.dice.choice(facets)]
    for facet in chosen:
        facet[0] = [facet[0][0], *facet[0][:0:-1]]
    facets.sort()
    return told_again(raw, certificate)


@idea(FALSE, *CONVEX)
def vertex_of_other_parents(raw: Raw, maker: Maker) -> Json:
    """A vertex gets another parent, so that it lies inside the sum, and the figures follow."""
    certificate = raw.copy()
    total = certificate["sums"][0]
    spot = maker.dice.randrange(len(total["vertices"]))
    which = maker.dice.randrange(2)
    number = len(raw.case["PQ"[which]]["vertices"])
    total["vertices"][spot][which] = maker.dice.randrange(number)
    return told_again(raw, certificate)


@idea(UNPROVED, *CONVEX)
def parents_of_a_facet(raw: Raw, maker: Maker) -> Json:
    """A facet's list of parents lacks a vertex, has a further one, descends, or repeats a
    vertex."""
    certificate = raw.copy()
    facet = maker.dice.choice(certificate["sums"][0]["facets"])
    which = maker.dice.choice([1, 2])
    number = len(raw.case["PQ"[which - 1]]["vertices"])
    old = facet[which]
    others = [i for i in range(number) if i not in old]
    ways = [old[:-1], old * 2, [*old, number], old[::-1], sorted([*old, *others[:1]])]
    facet[which] = maker.pick([new for new in ways if new != old])
    return certificate


@idea(FALSE, *CONVEX, *SOLID)
def figures_of_a_solid(raw: Raw, maker: Maker) -> Json:
    """A false figure: a count, the volume, the digest or the scaling."""
    certificate = raw.copy()
    claim = certificate["claims"][0]
    name = maker.dice.choice([n for n in claim if n not in ("claim", "sum")])
    old = claim[name]
    if name == "scaling":
        claim[name] = [str(Fraction(old[0]) * 2), *old[1:]]
    elif name == "digest":
        claim[name] = sha(old)
    elif name == "volume":
        claim[name] = str(Fraction(old) * maker.pick([2, -1, 1 + Fraction(1, 10**50), 0]))
    else:
        claim[name] = maker.dice.choice([old + 1, old - 1, -old, 0, old + 2**64])
    return certificate


@idea(FALSE, *CONVEX, *SOLID)
def another_scaling(raw: Raw, maker: Maker) -> Json:
    """Another scaling for sum and claim: a factor a little more, negative, or zero. Volume and
    digest stay."""
    certificate = raw.copy()
    total = (certificate.get("sums") or certificate["proof"]["sums"])[0]
    old = total["scaling"]
    axis = maker.dice.randrange(3)
    new = list(old)
    new[axis] = str(Fraction(old[axis]) * maker.pick(
        [1 + Fraction(1, 10 ** maker.dice.randint(1, 40)), -1, 0, 3]))  # fmt: skip
    total["scaling"] = certificate["claims"][0]["scaling"] = new
    return certificate


@idea(FALSE, *CONVEX)
def operand_not_convex(raw: Raw, maker: Maker) -> Forgery:
    """Another operand: a dent, a facet's layer twice, a vertex nowhere, a face missing or
    turned. The case's digest is right, and all claims stay."""
    certificate, case = raw.copy(), raw.copied_case()
    body = case[maker.dice.choice("PQ")]
    way = maker.dice.randrange(6)
    if way == 0:
        body["faces"] *= 2
    elif way == 1:
        body["vertices"].append(["0", "0", "50"])
    elif way == 2:
        body["faces"].pop()
    elif way == 3:
        body["faces"][0].reverse()
    elif way == 4:
        body["vertices"][0] = [str(Fraction(v) + Fraction(1, 3)) for v in body["vertices"][1]]
    else:
        body["faces"] += [face[::-1] for face in body["faces"]]
    certificate["case"]["sha256"] = case_digest(case, raw.form)
    return Forgery(tight(certificate), tight(case))


@idea(FALSE, *CONVEX, *SOLID, *POINTS)
def body_of_another_case(raw: Raw, maker: Maker) -> Forgery:
    """Proof and claims from another case below this case's path and digest."""
    certificate = raw.copy()
    other = maker.another(raw)
    if other.case == raw.case:
        raise Unfit
    for name in ("sums", "proof", "claims"):
        if name in certificate:
            certificate[name] = other.copy()[name]
    if certificate["claims"] == raw.certificate["claims"]:
        raise Unfit
    return Forgery(tight(certificate), tight(raw.case))


@idea(FALSE, *SOLID)
def part_called_otherwise(raw: Raw, maker: Maker) -> Json:
    """A face called no face, or covered; any other part called a face: the sum's boundary has a
    gap or a wall too many."""
    certificate = raw.copy()
    planes = certificate["proof"]["sums"][0]["planes"]
    spots = [(plane[2], k) for plane in planes for k, entry in enumerate(plane[2])
             if entry[0] != "cut"]  # fmt: skip
    tree, k = maker.dice.choice(spots)
    old = tree[k]
    pair = maker.pick([e[1:] for plane in planes for e in plane[2] if e[0] == "face"])
    if old[0] == "face":
        tree[k] = maker.dice.choice([["none"], ["above", *pair], ["above", *old[1:]]])
    else:
        tree[k] = ["face", *pair]
    if maker.dice.random() < 0.5:
        certificate["claims"][0]["digest"] = sha(str(maker.dice.random()))
    return certificate


@idea(FALSE, *SOLID)
def plane_missing(raw: Raw, maker: Maker) -> Json:
    """A plane missing or named twice, moved, or not primitive; the claim's counts follow."""
    certificate = raw.copy()
    planes = certificate["proof"]["sums"][0]["planes"]
    claim = certificate["claims"][0]
    k = maker.dice.randrange(len(planes))
    faces = sum(entry[0] == "face" for entry in planes[k][2])
    way = maker.dice.randrange(4)
    if way == 0 and faces:
        planes.pop(k)
        claim.update(planes=claim["planes"] - 1, polygons=claim["polygons"] - 1)
    elif way == 1:
        planes.insert(k, planes[k])
    elif way == 2:
        planes[k][1] = str(Fraction(planes[k][1]) + Fraction(1, maker.dice.randint(2, 10**9)))
    else:
        planes[k][0] = [2 * n for n in planes[k][0]]
        planes[k][1] = str(2 * Fraction(planes[k][1]))
    if way == 0 and not faces:
        raise Unfit
    return certificate


@idea(FALSE, *SOLID)
def tree_that_leaves_parts(raw: Raw, maker: Maker) -> Json:
    """A tree ends early, goes on after the end, cuts beside the polygon, or along no plane: a
    part of the plate has no verdict, or two."""
    certificate = raw.copy()
    planes = certificate["proof"]["sums"][0]["planes"]
    tree = maker.dice.choice(planes)[2]
    way = maker.dice.randrange(4)
    if way == 0:
        tree.pop()
    elif way == 1:
        tree.append(tree[-1])
    elif way == 2:
        tree.insert(0, ["cut", *maker.dice.choice([(0, 0, 0, 0), (1, 0, 0, 10**9), (0, 0, 0, -1)])])
        tree.append(["none"])
    else:
        tree.clear()
    certificate["claims"][0]["digest"] = sha(str(maker.dice.random()))
    return certificate


@idea(FALSE, *SOLID, *POINTS)
def pieces_that_tile_no_operand(raw: Raw, maker: Maker) -> Json:
    """A piece missing, or there twice, or the hull over all corners: pieces and faces do not
    cancel, whatever else holds. A sum's claim has another digest."""
    certificate = raw.copy()
    names = [name for name in "PQ" if len(certificate["proof"][name]["hulls"]) > 1]
    name = maker.pick(names)
    pieces = certificate["proof"][name]
    number = len(raw.case[name]["vertices"])
    way = maker.dice.randrange(3)
    if way == 0:
        pieces["hulls"].pop()
    elif way == 1:
        pieces["hulls"].append(pieces["hulls"][0])
    else:
        pieces.update(points=[], hulls=[list(range(number))])
    claim = certificate["claims"][0]
    if claim["claim"] == "outside":
        claim["code"] = [0] * (len(certificate["proof"]["P"]["hulls"])
                               * len(certificate["proof"]["Q"]["hulls"]))  # fmt: skip
    elif "pieces" in claim:
        claim["pieces"] = [0, 0]
    else:
        claim["digest"] = sha(claim["digest"])
    return certificate


@idea(FALSE, *POINTS, raws=("within",))
def solid_parents_outside(raw: Raw, maker: Maker) -> Json:
    """A far point equals `S p + q`, with p or q far outside the piece."""
    certificate = raw.copy()
    claim = certificate["claims"][0]
    axis, name = maker.dice.randrange(3), maker.dice.choice("pq")
    far = Fraction(maker.dice.randint(30, 10**9), maker.dice.choice([1, 3]))
    claim[name][axis] = str(Fraction(claim[name][axis]) + far)
    factor = Fraction(claim["scaling"][axis]) if name == "p" else 1
    claim["point"][axis] = str(Fraction(claim["point"][axis]) + far * factor)
    return certificate


@idea(FALSE, *POINTS, raws=("beside", "distant"))
def solid_point_called_outside(raw: Raw, maker: Maker) -> Json:
    """A sum of two corners called outside: with another point's normals, with (0, 0, 0), with
    normals not whole, or with a code that knows fewer pairs."""
    certificate = raw.copy()
    claim = certificate["claims"][0]
    p, q = (maker.dice.choice(raw.case[name]["vertices"]) for name in "PQ")
    claim["point"] = [str(Fraction(f) * Fraction(a) + Fraction(b)) for f, a, b in
                      zip(claim["scaling"], p, q, strict=True)]  # fmt: skip
    way = maker.dice.randrange(5)
    if way == 1:
        claim["normals"] = [[0, 0, 0] for _ in claim["normals"]]
    elif way == 2:
        claim["code"] = []
        claim["normals"] = []
    elif way == 3:
        claim["normals"] = [[str(n) for n in normal] for normal in claim["normals"]]
    elif way == 4:
        claim["code"] = [entry - len(claim["normals"]) for entry in claim["code"]]
    return certificate


@idea(FALSE, *POINTS, raws=("beside", "distant"))
def solid_boundary_called_outside(raw: Raw, maker: Maker) -> Json:
    """The corners farthest along a normal, added: on the boundary, and weakly apart everywhere."""
    certificate = raw.copy()
    claim = certificate["claims"][0]
    normal = claim["normals"][0]
    factors = [Fraction(f) for f in claim["scaling"]]

    def farthest(name: str, by: list[Fraction]) -> list[Fraction]:
        corners = [[f * Fraction(v) for f, v in zip(by, corner, strict=True)]
                   for corner in raw.case[name]["vertices"]]  # fmt: skip
        return max(corners, key=lambda c: sum(n * v for n, v in zip(normal, c, strict=True)))

    both = zip(farthest("P", factors), farthest("Q", [Fraction(1)] * 3), strict=True)
    claim["point"] = [str(a + b) for a, b in both]
    size = maker.dice.choice([1, maker.dice.randint(2, 10**30)])
    claim["normals"] = [[size * n for n in normal]]
    claim["code"] = [0] * len(claim["code"])
    return certificate
