# Part 7: bridges of a disc that touches a set in the plane from outside. Needs part 2.

Named = tuple[str, int]


def less(p: Vertex, q: Vertex) -> Vertex:
    return p[0] - q[0], p[1] - q[1]


def nearest(p: Vertex, a: Vertex, b: Vertex) -> Vertex:
    """The point of a segment that is nearest to a point."""
    along, way = less(b, a), less(p, a)
    part = max(Fraction(0), min(Fraction(1), Fraction(dot(along, way)) / dot(along, along)))
    return a[0] + part * along[0], a[1] + part * along[1]


def squared_distance(p: Vertex, a: Vertex, b: Vertex) -> Fraction:
    """From a point to a segment."""
    off = less(p, nearest(p, a, b))
    return Fraction(dot(off, off))


class DiscProof:
    """Discs of one squared radius outside of P; edge n goes from vertex n to the next of its
    ring."""

    kinds: tuple[str, ...] = ("bridge", "touch")

    def __init__(self, P: Operand, square: Fraction, budget: Budget) -> None:
        require(not P.thin and bool(P.rings), "P is no region")
        self.at, self.square, self.spend = P.exact, square, budget.spend
        self.next = {i: j for ring in P.rings for i, j in edges_of(ring)}
        self.last = {j: i for i, j in self.next.items()}
        require(all(self.at[i] != self.at[j] for i, j in self.next.items()), "an edge is zero")
        self.times = Counter(self.at)

    def edge(self, n: int) -> tuple[Vertex, Vertex]:
        return self.at[n], self.at[self.next[n]]

    def along(self, n: int) -> Vertex:
        return less(*self.edge(n)[::-1])

    def height(self, n: int, p: Vertex) -> Any:
        """How far a point is right of an edge, times the edge's length."""
        return cross(less(p, self.at[n]), self.along(n))

    def feature(self, value: Json) -> Named:
        kind, n = items(value, 2)
        require(kind in ("vertex", "edge"), "a feature is a vertex or an edge")
        return str(kind), index(n, len(self.at))

    def touches(self, feature: Named, centres: Sequence[Vertex], closed: bool) -> set[int]:
        """The feature is in P, in front of it lie all centres: their nearest point of these edges
        is inside the edge (`closed`: or one of its ends), or the vertex."""
        kind, n = feature
        if kind == "edge":
            length = dot(self.along(n), self.along(n))
            over = [dot(less(p, self.at[n]), self.along(n)) for p in centres]
            inside = 0 < min(over) and max(over) < length
            inside = inside or (closed and 0 <= min(over) and max(over) <= length)
            demand(inside, "a centre is not in front of its edge")
            demand(all(self.height(n, p) > 0 for p in centres), "a centre is not right of its edge")
            return {n}
        before, v = self.last[n], self.at[n]
        demand(self.times[v] == 1, "rings touch at a vertex")
        turn = cross(self.along(before), self.along(n))
        on = turn == 0 and dot(self.along(before), self.along(n)) > 0
        right = turn > 0 or (on and all(self.height(n, p) > 0 for p in centres))
        demand(right, "P is not convex at a vertex")
        for p in centres:
            way = less(p, v)
            ahead = dot(way, self.along(n)) > 0 or dot(way, self.along(before)) < 0
            demand(not ahead, "a centre is nearer to an edge than to its vertex")
        return {before, n}

    def near(self, feature: Named, a: Vertex, b: Vertex, sign: int) -> bool:
        """Whether all points between two are nearer than the radius (-1), or farther (1)."""
        kind, n = feature
        if kind == "edge":
            square = self.square * dot(self.along(n), self.along(n))
            return all(sign * (self.height(n, p) ** 2 - square) > 0 for p in (a, b))
        v = self.at[n]
        if sign < 0:
            return all(dot(less(p, v), less(p, v)) < self.square for p in (a, b))
        return squared_distance(v, a, b) > self.square

    def winds(self, p: Vertex, way: Sequence[Any] = (1, 0), but: int | None = None) -> int:
        """How often rings wind around a point off all edges; right of one edge, if it is on it, and
        `way` leads there."""
        winds = 0
        for n in self.next:
            low, high = (cross(way, less(q, p)) for q in self.edge(n))
            if n != but and (low <= 0) != (high <= 0):
                height = self.height(n, p)
                winds += (high > low and height < 0) - (high < low and height > 0)
        return winds

    def bridge(self, claim: Json) -> str:
        left, right, box = members(claim, "claim left right box")[1:]
        one, other = self.feature(left), self.feature(right)
        require(one != other, "a bridge has one feature twice")
        p, u, w = (vector(each) for each in items(box, 3))
        q, s, t = ((p[0] + x, p[1] + y) for x, y in (u, w, (u[0] + w[0], u[1] + w[1])))
        corners = [p, q, t, s]
        require(all(dot(d, d) for d in (u, w)) and cross(u, w) != 0, "a box is flat")
        small = all(dot(d, d) < self.square for d in (less(t, p), less(s, q)))
        demand(small, "a box is wider than the radius")
        own = self.touches(one, corners, False) | self.touches(other, corners, False)
        good = self.near(one, p, s, -1) and self.near(one, q, t, 1)
        good = good and self.near(other, p, q, -1) and self.near(other, s, t, 1)
        demand(good, "no centre in the box is as far from both features as the radius")
        for n in self.next.keys() - own:
            self.spend(8)
            a, b = self.edge(n)
            far = [squared_distance(c, a, b) for c in corners]
            far += [squared_distance(e, *side) for side in edges_of(corners) for e in (a, b)]
            demand(min(far) > self.square, f"edge {n} may be in the disc")
        demand(self.winds(p) == 0, "a centre is not outside of P")
        return f"bridge from {one[0]} {one[1]} to {other[0]} {other[1]}"

    def touch(self, claim: Json) -> str:
        """A disc that touches P at these features, and no other."""
        centre, told = members(claim, "claim centre features")[1:]
        c, named = vector(centre), [self.feature(value) for value in items(told)]
        require(len(set(named)) == len(named) >= 2, "a disc touches two features or more")
        own: set[int] = set().union(*(self.touches(feature, [c], True) for feature in named))
        for n in self.next:
            self.spend(1)
            far = squared_distance(c, *self.edge(n))
            good = far == self.square if n in own else far > self.square
            demand(good, f"edge {n} is not as far from the centre as it should be")
        demand(self.winds(c) == 0, "a centre is not outside of P")
        return f"disc about ({c[0]}, {c[1]}) that touches {len(named)} features"


def of_discs(
    case: Json, digest: Json, square: Json, claims: Json, budget: Budget,
    proofs: type[DiscProof] = DiscProof,
) -> list[str]:  # fmt: skip
    P = Operand(case.get("P"), "P")
    demand(digest_of({"P": P.plain}) == digest, "not the case that is certified")
    require(number(square) > 0, "the squared radius is not positive")
    proof, said = proofs(P, number(square), budget), []
    require(bool(items(claims)), "nothing is claimed")
    require(len(set(map(digest_of, claims))) == len(claims), "a claim is made twice")
    for k, claim in enumerate(claims):
        with within(f"claim {k}"):
            budget.spend(64)
            kind: Json = claim.get("claim") if isinstance(claim, dict) else None
            require(kind in proof.kinds, f"there is no claim {kind!r}")
            said.append(f"{getattr(proof, kind)(claim)}, squared radius {number(square)}")
    return said


FORMS["feature-certificate-v1"] = "square", of_discs
