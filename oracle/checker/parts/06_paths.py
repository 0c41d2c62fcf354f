

# Part 6: a part R, scaled, that moves along a path in the plane among obstacles O. Needs part 2.

# t, s, w: the part t / w of a segment, the scale s / w; w = 0: far up
Corner = tuple[int, int, int]
Cut = tuple[Any, bool]  # just below a scale; True: just above it


def places(value: Json, place: Callable[[Json], Vertex] = vector) -> list[Vertex]:
    require(bool(items(value)), "a path has no place")
    return list(map(place, value))


def stays(place: Vertex) -> Vertex:
    """A place as one that moves with the scale."""
    return (place[0], Fraction(0), place[1], Fraction(0))


def moving(value: Json) -> Vertex:
    """`["x0", "x1", "y0", "y1"]`; a place that stays has two numbers."""
    return stays(vector(value)) if len(items(value)) == 2 else tuple(map(number, items(value, 4)))


def segments(path: list[Vertex]) -> list[tuple[Vertex, Vertex]]:
    """From each place to the next; a single place gives a segment from it to itself."""
    return list(itertools.pairwise(path)) or [(path[0], path[0])]


def at_corners(f: Triple, cell: list[Corner]) -> list[int]:
    return [f[0] * t + f[1] * s + f[2] * w for t, s, w in cell]


def not_above(f: Triple, cell: list[Corner]) -> list[Corner]:
    """The part of a convex polygon where f <= 0."""
    levels = at_corners(f, cell)
    kept: list[Corner] = []
    for i, (c, level) in enumerate(zip(cell, levels, strict=True)):
        if level * levels[i - 1] < 0:
            u, v = abs(level), abs(levels[i - 1])
            t, s, w = (v * x + u * y for x, y in zip(c, cell[i - 1], strict=True))
            kept.append((t // gcd(t, s, w), s // gcd(t, s, w), w // gcd(t, s, w)))
        kept += [c] if level <= 0 else []
    return list(dict.fromkeys(kept))


def sides(ring: list[Triple]) -> list[Vector]:
    """Normals of half-planes that have in common a convex polygon, a segment or a point (also as a
    segment without length)."""
    if len(ring) > 2:
        return [(b[1] - a[1], a[0] - b[0]) for a, b in edges_of(ring)]
    x, y = direction(ring[0], ring[1]) if len(set(ring)) == 2 else (1, 0)
    return [(x, y), (-x, -y), (y, -x), (-y, x)]


def winds_around(ring: list[Vertex], x: Vertex) -> bool:
    """Whether a closed polyline that misses a point leads around it."""
    times = 0
    for a, b in edges_of(ring):
        if (a[1] <= x[1]) != (b[1] <= x[1]):
            side = cross((b[0] - a[0], b[1] - a[1]), (x[0] - a[0], x[1] - a[1]))
            times += (side > 0 and b[1] > a[1]) - (side < 0 and b[1] < a[1])
    return times != 0


class ScaleRange:
    """All scales from one to another, each of which belongs to them or does not."""

    def __init__(self, value: Json) -> None:
        low, high, *self.is_in = members(value, "from to from_in to_in")
        require(all(isinstance(told, bool) for told in self.is_in), "this is not true or false")
        a, b = number(low), None if high is None else number(high)
        self.ends = [(a.numerator, a.denominator), b.as_integer_ratio() if b else (1, 0)]
        self.low: Cut = (a, not self.is_in[0])
        self.high: Cut = (inf if b is None else b, self.is_in[1])
        proper = a >= 0 and (a > 0 or not self.is_in[0]) and (b is not None or not self.is_in[1])
        require(proper and self.low < self.high, f"{value} are no scales")

    def middle(self) -> Fraction:
        """One of the scales."""
        low, high = self.low[0], self.high[0]
        return Fraction(low + 1 if high == inf else (low + high) / 2)

    def meet(self, corners: list[Corner]) -> bool:
        """Whether the hull of corners has a point at one of the scales, and not only at an end that
        does not belong to them."""
        out = [end for end, is_in in zip(self.ends, self.is_in, strict=True) if not is_in]
        return bool(corners) and not any(all(s * W == S * w for _, s, w in corners) for S, W in out)

    def __eq__(self, other: object) -> bool:
        return isinstance(other, ScaleRange) and (self.low, self.high) == (other.low, other.high)

    def __str__(self) -> str:
        ends = f"{self.low[0]}, {self.high[0]}"
        return f"{'[' if self.is_in[0] else '('}{ends}{']' if self.is_in[1] else ')'}"


class Way:
    """A segment of places of R, in whole numbers. Its ends may move with the scale s, from p(s) to
    q(s), as long as its direction stays: the places p(s) + t d, with 0 <= t <= (q(s) - p(s)) / d,
    which is linear in s. Its cell holds all such t and s."""

    def __init__(self, clear: Clear, ends: Sequence[Vertex]) -> None:
        self.by, self.parts = clear.by, lcm(*(c.denominator for end in ends for c in end))
        unit, ((s, w), (S, W)) = clear.proof.unit * self.parts, clear.scales.ends
        first, last = ([int(c * unit) for c in end] for end in ends)
        self.start, self.slope = (first[0], first[2]), (first[1], first[3])
        off = [b - a for a, b in zip(first, last, strict=True)]
        u, v = ((c * off[0] + a * off[1], c * off[2] + a * off[3]) for a, c in clear.scales.ends)
        demand(cross(u, v) == 0 and dot(u, v) >= 0, "a segment turns as the scale changes")
        self.along = (u[0] + v[0], u[1] + v[1])
        self.square, t, T = dot(self.along, self.along) or 1, dot(u, self.along), dot(v, self.along)
        self.cell = list(dict.fromkeys([(0, s, w), (t, s, w), (T, S, W), (0, S, W)]))

    def gap(self, normal: Vector, A: int, B: int) -> Triple:
        """f, linear: positive at (t, s, w) where n (x + s a) > n b for all a in A, b in B."""
        part, others = self.by
        least, most = -part.most(A, (-normal[0], -normal[1])), others.most(B, normal)
        far = dot(normal, self.start)
        grows = self.square * (dot(normal, self.slope) + self.parts * least)
        return dot(normal, self.along), grows, self.square * (far - self.parts * most)


class Clear:
    """`clear`: at no scale of a range a place of a path collides. For each segment a code follows
    all pairs of pieces over the convex cell of all t and s: n takes away where normal n holds the
    pair apart, until nothing is left; -1 and -2 split a node; -3 cuts the cell in the middle."""

    def __init__(self, step: Json, proof: PathProof) -> None:
        names = "rule by contact path scales normals codes"
        by, contact, path, scales, normals, codes = members(step, names)[1:]
        self.by, self.contact, self.proof = proof.pair(by), proof.contact(contact), proof
        self.path = list(map(stays, proof.path)) if path is None else places(path, moving)
        self.scales = ScaleRange(scales)
        self.normals = [whole_normal(vector(normal)) for normal in items(normals)]
        self.roots = list(itertools.product(*(of.root for of in self.by)))
        ways = segments(self.path)
        for i, (ends, code) in enumerate(zip(ways, items(codes, len(ways)), strict=True)):
            with within(f"segment {i}"):
                self.follow(Way(self, ends), items(code))

    def left(self, cell: list[Corner], f: Triple) -> list[Corner]:
        """The part of a cell that f does not hold apart."""
        self.proof.spend(len(cell))
        rest = not_above(f, cell)
        overlap = self.contact == "forbidden" or min(at_corners(f, cell)) < 0
        return rest if overlap and self.scales.meet(rest) else []

    def follow(self, way: Way, code: list[Json]) -> None:
        stack = [(way.cell, A, B) for A, B in self.roots]
        for token in map(integer, code):
            self.proof.spend(1)
            demand(bool(stack), "a code goes on after its end")
            cell, A, B = stack.pop()
            if token in (-1, -2):
                children = self.by[token + 2 == 0].children[A if token == -1 else B]
                demand(bool(children), "a code splits a piece")
                pairs = [(c, B) if token == -1 else (A, c) for c in reversed(children)]
                stack += [(cell, *pair) for pair in pairs]
            elif token == -3:
                at = [Fraction(t, w) for t, _, w in cell if w]
                u, v = ((min(at) + max(at)) / 2).as_integer_ratio()
                stack += [(not_above(f, cell), A, B) for f in ((-v, 0, u), (v, 0, -u))]
            else:
                normal = self.normals[index(token, len(self.normals))]
                rest = self.left(cell, way.gap(normal, A, B))
                stack += [(rest, A, B)] if rest else []
        demand(not stack, "a code ends too early")


class PathProof(Proof):
    """The proof for a case of R, O and a path."""

    rules: ClassVar[dict[str, Any]] = {"pieces": Pieces, "clear": Clear}

    def __init__(self, path: list[Vertex], sets: Sequence[Operand], budget: Budget) -> None:
        super().__init__(sets[0], sets[1], budget)
        self.path, self.ways = path, segments(path)

    def claim(self, value: Json) -> tuple[Any, ...]:
        shown = self.shown[index(value, len(self.shown))]
        require(isinstance(shown, tuple), f"claim {value} is of another kind")
        return shown  # type: ignore[no-any-return]

    def pair(self, by: Json) -> tuple[Pieces, Pieces]:
        pair = [self.step(value, Pieces) for value in items(by, 2)]
        require([of.operand.name for of in pair] == ["R", "O"], "`by` is not of R and O")
        return pair[0], pair[1]

    def nodes(self, by: tuple[Pieces, Pieces], value: Json) -> Edge:
        A, B = (index(i, len(of.hulls)) for i, of in zip(items(value, 2), by, strict=True))
        demand(by[0].solid[A] and by[1].solid[B], f"{A} or {B} is not convex")
        return A, B

    def contact(self, value: Json) -> str:
        """With contact allowed both have an area: else seams of pieces would be let through."""
        require(value in ("allowed", "forbidden"), f"there is no contact {value!r}")
        thin = value == "allowed" and any(o.thin for o in self.operands.values())
        require(not thin, "with contact allowed neither may be a point or a segment")
        return str(value)

    def clear(self, step: Json, contact: Json, scales: Json) -> Clear:
        clear = self.step(step, Clear)
        same = (clear.contact, clear.scales) == (self.contact(contact), ScaleRange(scales))
        demand(same, "the step is about another contact, or other scales")
        return clear

    def add_free(self, claim: Json) -> tuple[str, Any]:
        """At each scale of a range no place of the path collides."""
        contact, scales, step = members(claim, "claim contact scales step")[1:]
        clear = self.clear(step, contact, scales)
        demand(clear.path == list(map(stays, self.path)), "the step is about another path")
        return f"at {clear.scales}, contact {contact}", ("free", contact, clear.scales)

    def add_hit(self, claim: Json) -> tuple[str, Any]:
        """At each scale of a range some place of the path collides."""
        contact, scales, by, hits = members(claim, "claim contact scales by hits")[1:]
        contact, told, pair = self.contact(contact), ScaleRange(scales), self.pair(by)
        reach = told.low
        for i, hit in enumerate(items(hits)):
            with within(f"hit {i}"):
                low, high = self.hit(hit, contact == "allowed", pair)
                demand(low <= reach < high, "it leaves out scales before it, or adds none")
                reach = high
        demand(reach >= told.high, "the hits do not reach to the last scale")
        return f"at {told}, contact {contact}", ("hit", contact, told)

    def hit(self, value: Json, strict: bool, by: tuple[Pieces, Pieces]) -> tuple[Cut, Cut]:
        """Where its scales begin and end. A place, and a point that the part and the obstacles have
        in common there, move linearly from each scale to the next; `up`: they stay for ever."""
        segment, nodes, entries = members(value, "segment nodes points")
        start, end = self.ways[index(segment, len(self.ways))]
        A, B = self.nodes(by, nodes)
        of_A, of_B = sides(by[0].hulls[A]), sides(by[1].hulls[B])
        up = items(entries)[-1:] == ["up"]
        scales: list[Any] = []
        levels: list[list[Any]] = []  # of the point across the sides of both pieces; positive: out
        for entry in entries[: len(entries) - up]:
            self.spend(len(of_A) + len(of_B))
            t, s, point = items(entry, 3)
            t, s, (x, y) = number(t), number(s), vector(point)
            require(0 <= t <= 1 and s >= 0, "this is no place of a segment, or no scale")
            off = tuple(p - (1 - t) * c - t * d for p, c, d in zip((x, y), start, end, strict=True))
            outs = [self.unit * dot(n, off) - s * by[0].most(A, n) for n in of_A]
            levels.append(outs + [self.unit * dot(n, (x, y)) - by[1].most(B, n) for n in of_B])
            scales.append(s)
        require(bool(scales), "a hit has no point")
        require(scales == sorted(set(scales)), "the scales do not ascend")
        if up:
            levels.append([-by[0].most(A, n) for n in of_A] + [0 for _ in of_B])
            scales.append(inf)
        demand(all(max(level) <= 0 for level in levels), "a point is not in its piece")
        if strict:
            inner = all(max(level) < 0 for level in levels[1:-1])
            pairs = itertools.pairwise(levels)
            between = all(u < 0 or v < 0 for p in pairs for u, v in zip(*p, strict=True))
            demand(inner and between, "a point is not in the interior of its piece")
        ends = [not strict or max(level) < 0 for level in (levels[0], levels[-1])]
        return (scales[0], not (ends[0] and scales[0] > 0)), (scales[-1], ends[1] and not up)

    def add_valid(self, claim: Json) -> tuple[str, None]:
        """Which of some scales are valid for the path: claims follow each other, free or hit."""
        return self.answer(claim, "valid", ("free", "hit"))

    def add_trap(self, claim: Json) -> tuple[str, None]:
        """At which of some scales the part is trapped at the place."""
        self.place()
        return self.answer(claim, "trapped", ("trapped", "escapes", "hit"))

    def answer(self, claim: Json, name: str, kinds: Sequence[str]) -> tuple[str, None]:
        """`name`: the member with the scales of the claims of the first kind."""
        contact, scales, told, claims = members(claim, f"claim contact scales {name} claims")[1:]
        contact, window = self.contact(contact), ScaleRange(scales)
        parts = [self.claim(value) for value in items(claims)]
        require(all(part[0] in kinds for part in parts), "a claim is of another kind")
        demand(all(part[1] == contact for part in parts), "a claim is about another contact")
        ends = [window.low, *(part[2].high for part in parts)]
        good = [part[2].low for part in parts] + [window.high] == ends
        demand(good, "the claims do not follow each other from end to end")
        groups = itertools.groupby(parts, key=lambda part: part[0] == kinds[0])
        found = [
            (g[0][2].low, g[-1][2].high) for has, g in ((h, list(g)) for h, g in groups) if has
        ]
        ranges = [*map(ScaleRange, items(told))]
        demand([(one.low, one.high) for one in ranges] == found, "the scales are others")
        return f"of {window}, contact {contact}: {', '.join(map(str, ranges)) or 'none'}", None

    def place(self) -> Vertex:
        require(len(self.path) == 1, "the path of the case is not one place")
        return self.path[0]

    def add_escapes(self, claim: Json) -> tuple[str, Any]:
        """A way from the place to one from which the part may go on along the normal. Its places
        may move with the scale."""
        contact, scales, step, normal = members(claim, "claim contact scales step normal")[1:]
        clear = self.clear(step, contact, scales)
        demand(clear.path[0] == stays(self.place()), "the way begins elsewhere")
        last, out = Way(clear, [clear.path[-1]] * 2), whole_normal(vector(normal))
        left = [clear.left(last.cell, last.gap(out, *pair)) for pair in clear.roots]
        demand(not any(left), "its end is not beyond all collisions")
        return f"at {clear.scales}, contact {contact}", ("escapes", contact, clear.scales)

    def add_trapped(self, claim: Json) -> tuple[str, Any]:
        """The place is free, and a ring of places that collide leads around it. Its vertices move
        linearly with the scale."""
        names = "claim contact scales step by ring pairs"
        contact, scales, step, by, ring, pairs = members(claim, names)[1:]
        clear, by = self.clear(step, contact, scales), self.pair(by)
        demand(clear.path == [stays(self.place())], "the step is about another place")
        corners = [tuple(map(number, items(corner, 4))) for corner in items(ring)]
        ends = [(0, s, w) for s, w in clear.scales.ends]
        for edge, nodes in zip(edges_of(corners), items(pairs, len(corners)), strict=True):
            A, B = self.nodes(by, nodes)
            of_A = [(-x, -y) for x, y in sides(by[0].hulls[A])]  # the sum is of B and -sA
            for n, (x, X, y, Y) in itertools.product(of_A + sides(by[1].hulls[B]), edge):
                self.spend(2)
                far = self.unit * dot(n, (x, y)) - by[1].most(B, n)
                grows = self.unit * dot(n, (X, Y)) - by[0].most(A, (-n[0], -n[1]))
                levels = [grows * s + far * w for _, s, w in ends]
                touch = [end for end, level in zip(ends, levels, strict=True) if level == 0]
                inside = contact == "forbidden" or not clear.scales.meet(touch)
                demand(max(levels) <= 0 and inside, f"an edge is not in the sum of {A} and {B}")
        s = clear.scales.middle()
        around = winds_around([at_scale(corner, s) for corner in corners], self.path[0])
        demand(around, "the ring does not lead around the place")
        return f"at {clear.scales}, contact {contact}", ("trapped", contact, clear.scales)

    claims: ClassVar[dict[Any, Any]] = {
        "free": add_free, "hit": add_hit, "valid": add_valid,
        "escapes": add_escapes, "trapped": add_trapped, "trap": add_trap,
    }  # fmt: skip


def of_paths(case: Json, digest: Json, steps: Json, claims: Json, budget: Budget) -> list[str]:
    sets = [Operand(case.get(operand), operand) for operand in "RO"]
    path = places(case.get("path"))
    plain = {one.name: one.plain for one in sets} | {"path": [[str(x), str(y)] for x, y in path]}
    demand(digest_of(plain) == digest, "not the case that is certified")
    return PathProof(path, sets, budget).follow(steps, claims)


FORMS["path-certificate-v1"] = "steps", of_paths
