

# Part 8b: sums of a set in the plane with a disc. Needs parts 2 and 7.


class Root:
    """p + q √d, with p, q and d > 0 from the field below, at last fractions."""

    def __init__(self, p: Any, q: Any, d: Any) -> None:
        self.p, self.q, self.d = p, q, d

    def shares(self, other: Any) -> bool:
        return isinstance(other, Root) and other.d is self.d

    def __add__(self, other: Any) -> Any:
        p, q = (other.p, other.q) if self.shares(other) else (other, 0)
        return Root(self.p + p, self.q + q, self.d)

    def __mul__(self, other: Any) -> Any:
        if not self.shares(other):
            return Root(self.p * other, self.q * other, self.d)
        p = self.p * other.p + self.q * other.q * self.d
        return Root(p, self.p * other.q + self.q * other.p, self.d)

    def __sub__(self, other: Any) -> Any:
        return self + other * -1

    def __rsub__(self, other: Any) -> Any:
        return self * -1 + other

    __radd__, __rmul__ = __add__, __mul__


def sign(x: Any) -> int:
    if not isinstance(x, Root):
        return int(x > 0) - int(x < 0)
    p, q = sign(x.p), sign(x.q)
    return p or q if p * q >= 0 else p * sign(x.p * x.p - x.q * x.q * x.d)


class Place(NamedTuple):
    """On a curve. `mark`: how far along an edge, or the direction from a vertex. `key`: a joint's
    number, or the curve that goes on at this end."""

    at: Any
    mark: Any
    key: Any = None


class Curve:
    """Edge n, moved to its right by the radius; or the arc about the vertex where edge n begins,
    after edge `before`. P is on the left."""

    def __init__(self, proof: DiscSum, n: int, before: int | None = None) -> None:
        self.proof, self.n, self.is_arc = proof, n, before is not None
        self.v, self.along = proof.at[n], proof.along(n)
        self.square, self.own = dot(self.along, self.along), {n}
        ends: list[Any] = [Fraction(0), Fraction(1)]
        self.tips, last = proof.edge(n), proof.key_after(n)
        if before is not None:
            self.own = {m for m in proof.next if self.v in proof.edge(m)}
            ends = [right(proof.along(before)), right(self.along)]
            self.tips, last = (self.v, self.v), (n, False)
        self.ends = self.place(ends[0], (n, self.is_arc)), self.place(ends[1], last)

    def place(self, t: Any, key: Any = None) -> Place:
        """At a part of the edge, or in a direction."""
        way = t if self.is_arc else right(self.along)
        root = Root(Fraction(0), Fraction(1), self.proof.square / dot(way, way))
        over = (0, 0) if self.is_arc else (t * self.along[0], t * self.along[1])
        at = tuple(root * way[k] + (self.v[k] + over[k]) for k in (0, 1))
        return Place(at, t if self.is_arc else t * self.square, key)

    def joint(self, value: Json) -> Place:
        at = self.proof.joints[index(value, len(self.proof.joints))]
        way, height = less(at, self.v), self.proof.height(self.n, at)
        if self.is_arc:
            demand(sign(dot(way, way) - self.proof.square) == 0, "a joint is off its arc")
            return Place(at, way, value)
        off = sign(height * height - self.proof.square * self.square)
        demand(off == 0 and sign(height) > 0, "a joint is off its line")
        return Place(at, dot(self.along, way), value)

    def order(self, x: Any, y: Any) -> int:
        """1 if mark y comes after mark x, on an arc within half a turn."""
        return sign(cross(x, y) if self.is_arc else y - x)

    def end(self, value: Json, end: Place) -> Place:
        found = end if value is None else self.joint(value)
        same = self.order(end.mark, found.mark) == 0
        same = same and (not self.is_arc or sign(dot(end.mark, found.mark)) > 0)
        demand(same, "a joint is not at the end of its curve")
        went = self.proof.ends.setdefault(end.key, found.key)
        demand(went == found.key, "two curves meet at a joint of one of them")
        return found

    def between(self, value: Json) -> Place:
        if isinstance(value, int):
            found = self.joint(value)
        else:
            t: Any = vector(value) if self.is_arc else number(value)
            require(not self.is_arc or any(t), "a direction is zero")
            found = self.place(t)
        inside = self.order(self.ends[0].mark, found.mark) > 0
        demand(inside and self.order(found.mark, self.ends[1].mark) > 0, "a place is off its curve")
        return found

    def over(self, f: int) -> list[Any]:
        """The heights of an edge's ends, the lower one first, and how far along they are."""
        ends = [(self.proof.height(self.n, p), less(p, self.v)) for p in self.proof.edge(f)]
        return sorted((height, dot(self.along, way)) for height, way in ends)

    def is_nearest(self, f: int, x: Place, y: Place) -> bool:
        """Whether a point nearest to edge f lies between, not farther than the radius."""
        if self.is_arc:
            way = less(nearest(self.v, *self.proof.edge(f)), self.v)
            inside = self.order(x.mark, way) > 0 and self.order(way, y.mark) > 0
            return inside and dot(way, way) <= 4 * self.proof.square
        (h, s), (k, t) = self.over(f)
        square = self.proof.square * self.square
        above = [-1 if each <= 0 else sign(each * each - square) for each in (h, k)]
        if above == [-1, 1]:  # the edge crosses the line
            part = (t - s) / (k - h)
            at = [(self.proof.height(self.n, z.at) - h) * part + s - z.mark for z in (x, y)]
            return sign(at[0]) > 0 > sign(at[1])
        level = k if above[1] <= 0 else h
        there = [along for height, along in ((h, s), (k, t)) if height == level]
        inside = self.order(x.mark, max(there)) > 0 and self.order(min(there), y.mark) > 0
        return inside and level >= 0 and level * level <= 4 * square

    def free(self, x: Place, y: Place) -> None:
        """All points between are farther than the radius from all edges but their own."""
        for f in self.proof.beside[self.n] - self.own:
            self.proof.spend(1)
            far = [self.proof.far(z.at, f) for z in (x, y)]
            good = min(far) >= 0 and not self.is_nearest(f, x, y)
            demand(good, f"edge {f} is near to a free part")
            for z, each in zip((x, y), far, strict=True):
                if each == 0 and isinstance(z.key, int):
                    self.proof.touched.add((z.key, f))
                    continue
                tip = self.tips[z.key != self.ends[0].key]
                own = z.key is not None and tip in self.proof.edge(f)
                demand(each > 0 or own, f"edge {f} touches a curve where no joint is")

    def blocked(self, x: Place, y: Place, f: int) -> None:
        """All points between are nearer to edge f than the radius."""
        self.proof.spend(1)
        good = sorted(self.proof.far(z.at, f) for z in (x, y)) in ([-1, -1], [-1, 0])
        if self.is_arc and good:
            way = less(self.v, nearest(self.v, *self.proof.edge(f)))
            past = self.order(x.mark, way) > 0 and self.order(way, y.mark) > 0
            good = any(way) and not past
        demand(good, f"edge {f} is not near to a blocked part")

    def facing(self, x: Place, y: Place, f: int) -> None:
        """All points between are right between this edge and edge f."""
        (h, s), (k, t) = self.over(f)
        good = not self.is_arc and h == k > 0 and h * h == 4 * self.proof.square * self.square
        good = good and self.order(s, x.mark) >= 0 and self.order(y.mark, t) >= 0
        demand(good, f"edge {f} does not face edge {self.n}")

    def follow(self, value: Json) -> None:
        entries = items(value)
        require(len(entries) > 2 and len(entries) % 2 == 1, "a curve is not places and links")
        places = [self.end(entries[0], self.ends[0]), *map(self.between, entries[2:-1:2])]
        places.append(self.end(entries[-1], self.ends[1]))
        self.proof.on |= {(z.key, self.n, self.is_arc) for z in places if isinstance(z.key, int)}
        start: Any = None
        for (x, y), link in zip(itertools.pairwise(places), entries[1::2], strict=True):
            two = isinstance(x.key, int) and isinstance(y.key, int)
            require(not two, "two joints have no place between")
            demand(self.order(x.mark, y.mark) > 0, "places are out of order")
            if link != "free":
                require(start is None, "a free part ends nowhere")
                name = index(
                    items(link, 1)[0] if isinstance(link, list) else link, len(self.proof.at)
                )
                (self.facing if isinstance(link, list) else self.blocked)(x, y, name)
                continue
            self.free(x, y)
            start = x.key if start is None else start
            require(start is not None, "a free part begins nowhere")
            self.proof.parts.append((self, x, y, len(self.proof.pieces)))
            if y.key is not None:
                self.proof.pieces.append((start, y.key, self))
                start = None

    def name(self) -> tuple[Fraction, ...]:
        """As in the canonical form: an arc before a line, then numbers."""
        if self.is_arc:
            return Fraction(0), *self.v
        unit = lcm(*(c.denominator for c in self.along))
        x, y = (int(c * unit) for c in self.along)
        x, y = x // gcd(x, y), y // gcd(x, y)
        return Fraction(1), Fraction(x), Fraction(y), y * self.v[0] - x * self.v[1]


def right(d: Vertex) -> Vertex:
    return d[1], -d[0]


def roots(links: Iterable[tuple[Any, Any]]) -> Callable[[Any], Any]:
    """Finds the representative of a class, by pairs of members."""
    above: dict[Any, Any] = {}

    def root(x: Any) -> Any:
        while x in above:
            x = above[x]
        return x

    for x, y in links:
        if root(x) != root(y):
            above[root(x)] = root(y)
    return root


class DiscSum(DiscProof):
    """The sum of P with a disc. Valid sets only: rings meet at vertices, P is on their left."""

    kinds = ("sum", "point")

    def __init__(self, P: Operand, square: Fraction, budget: Budget) -> None:
        super().__init__(P, square, budget)
        self.rings, self.ring = P.rings, {n: k for k, r in enumerate(P.rings) for n in r}
        simple = all(len({self.at[n] for n in ring}) == len(ring) for ring in P.rings)
        demand(simple, "a ring passes a vertex twice")
        reach = Fraction(isqrt(4 * square.numerator * square.denominator) + 1, square.denominator)
        boxes = {n: [*map(min, *self.edge(n)), *map(max, *self.edge(n))] for n in self.next}
        self.beside: dict[int, set[int]] = {n: set() for n in self.next}
        links = []
        for n, f in itertools.product(self.next, repeat=2):
            budget.spend(1)
            apart = max(
                max(boxes[n][k] - boxes[f][k + 2], boxes[f][k] - boxes[n][k + 2]) for k in (0, 1)
            )
            if apart <= reach:
                self.beside[n].add(f)
                if n < f and self.joins(n, f):
                    links.append((self.ring[n], self.ring[f]))
        for n in self.next:
            budget.spend(len(self.next))
            (a, b), way = self.edge(n), right(self.along(n))
            winds = self.winds(((a[0] + b[0]) / 2, (a[1] + b[1]) / 2), way, n)
            demand(winds == 0, f"P is not on the left of edge {n} alone")
        holes = (
            k for k, ring in enumerate(P.rings) if doubled_area([self.at[n] for n in ring]) < 0
        )
        self.root = roots([*links, *((k, self.around(k)) for k in holes)])
        arriving: dict[Vertex, list[int]] = defaultdict(list)
        for m in self.next:
            arriving[self.edge(m)[1]].append(m)
        self.before = {n: self.first_right(n, arriving[self.at[n]]) for n in self.next}
        self.after = {m: n for n, m in self.before.items()}
        demand(len(self.after) == len(self.next), "rings cross at a vertex")

    def joins(self, n: int, f: int) -> bool:
        """Whether the sums of two edges have interior points in common, or face each other. The
        edges have nothing else in common than an end."""
        (a, b), (c, d) = self.edge(n), self.edge(f)
        if common := {a, b} & {c, d}:
            ways = [
                less(p, q) for p, q in itertools.product((a, b, c, d), common) if p not in common
            ]
            apart = len(ways) == 2 and (cross(*ways) != 0 or dot(*ways) < 0)
            demand(apart, f"edges {n} and {f} overlap")
            return True
        sides = [self.height(n, c), self.height(n, d), self.height(f, a), self.height(f, b)]
        ends = ((a, c, d), (b, c, d), (c, a, b), (d, a, b))
        gap = min(squared_distance(*each) for each in ends)
        crossing = sides[0] * sides[1] < 0 and sides[2] * sides[3] < 0
        demand(gap > 0 and not crossing, f"edges {n} and {f} meet")
        (u, v), square = (self.along(n), self.along(f)), 4 * self.square
        along = sorted(dot(u, less(p, a)) for p in (c, d))
        facing = cross(u, v) == 0 > dot(u, v) and sides[0] > 0
        return gap < square or (gap == square and facing and along[0] < dot(u, u) and along[1] > 0)

    def around(self, k: int) -> int:
        """The ring to the left of a hole."""
        x, y = min(self.at[n] for n in self.rings[k])
        found = []
        for n in self.next.keys() - set(self.rings[k]):
            (a, b), (c, d) = self.edge(n)
            if (b <= y) != (d <= y) and (at := a + (y - b) * (c - a) / (d - b)) <= x:
                found.append((at, self.ring[n]))
        demand(bool(found), "a hole is in nothing")
        return max(found)[1]

    def first_right(self, n: int, arriving: list[int]) -> int:
        """The first edge clockwise of edge n, seen from where n begins."""

        def turn(m: int) -> int:
            return sign(cross(self.along(n), less(self.at[m], self.at[n])))

        first = arriving[0]
        for m in arriving[1:]:
            ways = [less(self.at[k], self.at[n]) for k in (m, first)]
            if turn(m) < turn(first) or (turn(m) == turn(first) and cross(*ways) < 0):
                first = m
        return first

    def key_after(self, m: int) -> tuple[int, bool]:
        """Where the curve of edge m ends, the arc or the edge that begins."""
        return self.after[m], self.turns_left(self.after[m])

    def turns_left(self, n: int) -> bool:
        return bool(cross(self.along(self.before[n]), self.along(n)) > 0)

    def far(self, p: Any, f: int) -> int:
        """The sign of the distance of a point from an edge less the radius."""
        a, b = self.edge(f)
        along = self.along(f)
        over = dot(along, less(p, a))
        if sign(over) > 0 and sign(over - dot(along, along)) < 0:
            height = self.height(f, p)
            return sign(height * height - self.square * dot(along, along))
        way = less(p, a if sign(over) <= 0 else b)
        return sign(dot(way, way) - self.square)

    def read_joint(self, value: Json) -> Any:
        root, more, *place = items(value, 4)
        low, (base, part) = number(root), vector(more)
        field = Root(base, part, low)
        demand(low > 0 and sign(field) > 0, "a root is not of a positive number")
        numbers = [[number(c) for c in items(each, 4)] for each in place]
        return tuple(Root(Root(p, q, low), Root(r, s, low), field) for p, q, r, s in numbers)

    def sum(self, claim: Json) -> str:
        names = "claim joints edges arcs components holes digest"
        joints, edges, arcs, components, holes, digest = members(claim, names)[1:]
        self.joints = [self.read_joint(each) for each in items(joints)]
        self.ends: dict[Any, Any] = {}
        self.on: set[tuple[int, int, bool]] = set()
        self.touched: set[tuple[int, int]] = set()
        self.parts: list[tuple[Curve, Place, Place, int]] = []
        self.pieces: list[tuple[Any, Any, Curve]] = []
        self.found: set[int] = set()
        curves = [Curve(self, n) for n in self.next]
        curves += [Curve(self, n, self.before[n]) for n in self.next if self.turns_left(n)]
        walks = [*items(edges, len(self.next)), *items(arcs, len(curves) - len(self.next))]
        for curve, walk in zip(curves, walks, strict=True):
            with within(f"the {'arc' if curve.is_arc else 'curve'} of edge {curve.n}"):
                curve.follow(walk)
        require({j for j, _, _ in self.on} == set(range(len(self.joints))), "a joint is not used")
        for joint, f in self.touched:
            arc = any((joint, n, True) in self.on for n in self.next if self.at[n] in self.edge(f))
            demand(arc or (joint, f, False) in self.on, f"edge {f} has no joint where it touches")
        form = [self.component([items(ring) for ring in items(one)]) for one in items(components)]
        used = [piece for one in components for ring in one for piece in ring]
        require(sorted(used) == list(range(len(self.pieces))), "pieces are not in one ring each")
        classes = {self.root(k) for k in range(len(self.rings))}
        demand(len(form) == len(classes), f"there are {len(classes)} components")
        keys = {key for piece in self.pieces for key in piece[:2]}
        root = roots((a, b) for a, b, _ in self.pieces)
        count = len(self.pieces) - len(keys) + len({root(key) for key in keys}) - len(form)
        demand(integer(holes) == count, f"there are {count} holes")
        made = [{"outer": told(one[0]), "holes": list(map(told, one[1:]))} for one in sorted(form)]
        text = {"components": made, "squared_radius": str(self.square)}
        demand(digest_of(text) == digest, "the sum has another digest")
        return f"sum: {len(form)} components, {count} holes, {digest}"

    def component(self, rings: list[list[Json]]) -> list[Any]:
        """The outer ring and the holes, in the canonical form."""
        pieces = [[self.pieces[index(k, len(self.pieces))] for k in ring] for ring in rings]
        require(bool(pieces) and all(pieces), "a ring is missing or empty")
        for ring in pieces:
            closed = all(a[1] == b[0] for a, b in edges_of(ring))
            demand(closed, "a ring's pieces do not follow each other")
            demand(len({a[0] for a in ring}) == len(ring), "a ring passes a joint twice")
        own = {self.root(self.ring[piece[2].n]) for ring in pieces for piece in ring}
        require(len(own) == 1 and own.isdisjoint(self.found), "rings of several components")
        self.found |= own
        top = max(self.at[n][::-1] for n in self.next if self.root(self.ring[n]) in own)[::-1]
        at = {k for curve, x, y, k in self.parts if curve.is_arc and curve.v == top
              and curve.order(x.mark, (0, 1)) > 0 and curve.order((0, 1), y.mark) >= 0}  # fmt: skip
        demand(bool(at) and at <= set(rings[0]), "the outer ring does not come first")
        outer, *holes = ([piece[2].name() for piece in ring] for ring in pieces)
        return [least(outer), *sorted(map(least, holes))]

    def point(self, claim: Json) -> str:
        """Whether a point is nearer than the radius (-1), or farther (1)."""
        at, distance = members(claim, "claim point distance")[1:]
        p = vector(at)
        self.spend(len(self.next))
        far = min(squared_distance(p, *self.edge(n)) for n in self.next)
        found = -1 if far > 0 and self.winds(p) > 0 else sign(far - self.square)
        demand(integer(distance) == found, "the point is not as far from P")
        return f"point: ({p[0]}, {p[1]}) is {('inside', 'at the radius', 'outside')[found + 1]}"


def least(ring: list[Any]) -> list[Any]:
    """Curves that go on count once; the ring begins so as to be least."""
    names = [
        name for last, name in zip([ring[-1], *ring[:-1]], ring, strict=True) if name != last
    ] or ring[:1]
    return min(names[k:] + names[:k] for k in range(len(names)))


def told(ring: list[Any]) -> Json:
    return [["line" if name[0] else "arc", *map(str, name[1:])] for name in ring]


def of_disc_sums(case: Json, digest: Json, square: Json, claims: Json, budget: Budget) -> list[str]:
    return of_discs(case, digest, square, claims, budget, DiscSum)


FORMS["disc-sum-certificate-v1"] = "square", of_disc_sums
