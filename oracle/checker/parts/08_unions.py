

# Part 8: unions of sets in the plane. Needs part 2.

Side = tuple[Triple, Triple, Triple]  # from a point to a point; the line, positive on the left


def triple(p: Vertex) -> Triple:
    """In lowest terms."""
    w = lcm(p[0].denominator, p[1].denominator)
    return int(p[0] * w), int(p[1] * w), w


def exact(p: Triple) -> Vertex:
    return Fraction(p[0], p[2]), Fraction(p[1], p[2])


def at_point(line: Triple, p: Triple) -> int:
    """Positive left of the line, negative right of it."""
    return int(line[0] * p[0] + line[1] * p[1] + line[2] * p[2])


def winding(sides: Iterable[Side], p: Triple, beside: Vector) -> int:
    """How often edges wind around the point p + e `beside`, which lies on none, for small e > 0."""
    turns = 0
    for a, b, line in sides:
        above = [(v[1] * p[2] - p[1] * v[2], -beside[1]) > (0, 0) for v in (a, b)]
        if above[0] != above[1]:
            left = (at_point(line, p), dot(line, beside)) > (0, 0)
            turns += (above[1] and left) - (above[0] and not left)
    return turns


def span(side: Side) -> list[Vertex]:
    return sorted(map(exact, side[:2]))


def is_inside(side: Side, p: Triple) -> bool:
    """Whether a point lies on an edge, and is neither end."""
    low, high = span(side)
    return at_point(side[2], p) == 0 and low < exact(p) < high


def cuts(side: Side, other: Side) -> list[Triple]:
    """Where another edge meets an edge; of a common stretch the other's ends."""
    (a, b, line), (c, d, across_it) = side, other
    if (ends := (at_point(line, c), at_point(line, d))) == (0, 0):
        return [p for p in (c, d) if p in (a, b) or is_inside(side, p)]
    apart = ends[0] * ends[1] > 0 or at_point(across_it, a) * at_point(across_it, b) > 0
    return [] if apart else [meet(line, across_it)]


class Union(Proof):
    """Sets, and claims about them. A vertex is [set, vertex]; so is the edge that begins there."""

    claims: ClassVar[dict[Any, Any]] = {}

    def __init__(self, sets: list[Operand], budget: Budget) -> None:
        self.spend, self.vertices = budget.spend, [list(map(triple, one.exact)) for one in sets]
        self.ends = [dict(e for ring in one.rings for e in edges_of(ring)) for one in sets]
        self.sides = [sides_of(one) for one in sets]

    def at(self, value: Json) -> Triple:
        k, i = items(value, 2)
        vertices = self.vertices[index(k, len(self.vertices))]
        return vertices[index(i, len(vertices))]

    def side(self, value: Json) -> Side:
        first = self.at(value)
        last = self.vertices[value[0]][self.ends[value[0]][value[1]]]
        return first, last, across(first, last)


def sides_of(one: Operand) -> list[Side]:
    require(not one.thin, f"{one.name} is a point or a segment")
    points = list(map(triple, one.exact))
    found = [(points[i], points[j]) for ring in one.rings for i, j in edges_of(ring)]
    require(all(a != b for a, b in found), f"{one.name} has an edge of length zero")
    return [(a, b, across(a, b)) for a, b in found]


def claim_union(union: Union, claim: Json) -> tuple[str, None]:
    """The union is the set that polygons bound. All edges, cut where they meet, part the plane into
    faces; each has a piece of an edge at its boundary, and both sides of all pieces are right."""
    region = Operand({"polygons": members(claim, "claim polygons")[1]}, "the union")
    bounds = sides_of(region)
    every = sorted(set(itertools.chain(bounds, *union.sides)))
    for side in every:
        union.spend(len(every))
        at = sorted({exact(p) for other in every for p in cuts(side, other)})
        for (x, y), (z, w) in itertools.pairwise(at):
            p = triple(((x + z) / 2, (y + w) / 2))
            union.spend(2 * len(every))
            for beside in (side[2][:2], (-side[2][0], -side[2][1])):
                held = any(winding(sides, p, beside) > 0 for sides in union.sides)
                demand(winding(bounds, p, beside) == held, f"the sides differ at {plain_point(p)}")
    return f"{len(bounds)} edges, {digest_of({'polygons': region.plain})}", None


def plain_point(p: Triple) -> str:
    return f"({', '.join(map(str, exact(p)))})"


def claim_point(union: Union, claim: Json) -> tuple[str, None]:
    """The sets that have a point inside, and those with an edge through it; it is outside of all
    others."""
    point, inside, on = members(claim, "claim point inside on")[1:]
    p = triple(vector(point))
    union.spend(2 * sum(map(len, union.sides)))
    through = [any(p == side[0] or is_inside(side, p) for side in one) for one in union.sides]
    edges = [k for k, is_on in enumerate(through) if is_on]
    demand(list(map(integer, items(on))) == edges, f"edges of the sets {edges} pass the point")
    around = (k for k, one in enumerate(union.sides) if winding(one, p, (0, 0)) > 0)
    held = [k for k in around if not through[k]]
    demand(list(map(integer, items(inside))) == held, f"the sets {held} have it inside")
    return f"{plain_point(p)} inside {held}, on edges of {edges}", None


def claim_meet(union: Union, claim: Json) -> tuple[str, None]:
    """A point is each of some vertices, and inside each of some edges; several sets have these."""
    point, vertices, edges = members(claim, "claim point vertices edges")[1:]
    p = triple(vector(point))
    demand(all(union.at(v) == p for v in items(vertices)), "a vertex is elsewhere")
    demand(all(is_inside(union.side(e), p) for e in items(edges)), "an edge does not pass there")
    named = [*vertices, *edges]
    require(len({k for k, _ in named}) > 1, "one set, or none, is named")
    require(len(set(map(tuple, named))) == len(named), "one is named twice")
    return f"at {plain_point(p)} the vertices {vertices}, and inside the edges {edges}", None


def claim_overlap(union: Union, claim: Json) -> tuple[str, None]:
    """Edges of two sets have a stretch in common, and run the same way (1) or not (-1)."""
    edges, way = members(claim, "claim edges way")[1:]
    one, other = map(union.side, items(edges, 2))
    require(edges[0][0] != edges[1][0], "one set is named")
    demand(at_point(one[2], other[0]) == at_point(one[2], other[1]) == 0, "they are on two lines")
    (a, b), (c, d) = span(one), span(other)
    demand(max(a, c) < min(b, d), "they have no stretch in common")
    same = (exact(one[0]) == a) == (exact(other[0]) == c)
    demand(integer(way) == (1 if same else -1), "they run the other way")
    return f"the edges {edges}, {'the same way' if same else 'opposite ways'}", None


def claim_sign(union: Union, claim: Json) -> tuple[str, None]:
    """The sign of `orientation` of three vertices (positive: they turn left), or of `concurrent`,
    three lines, each through two vertices (zero: they meet in a point or are parallel)."""
    of, sign = members(claim, "claim of sign")[1:]
    kind, rows = items(of, 2)
    require(kind in ("orientation", "concurrent"), f"there is no predicate {kind!r}")
    lines = [[r] if kind == "orientation" else items(r, 2) for r in items(rows, 3)]
    points = [list(map(union.at, line)) for line in lines]
    u, v, w = (row[0] if len(row) == 1 else across(row[0], row[1]) for row in points)
    require(all(map(any, (u, v, w))), "a line has one point given twice")
    value = at_point(across(v, w), u)
    demand(integer(sign) == (value > 0) - (value < 0), "it has another sign")
    return f"{of} has the sign {sign}", None


def of_unions(case: Json, digest: Json, claims: Json, budget: Budget) -> list[str]:
    sets = [Operand(one, f"set {k}") for k, one in enumerate(items(case.get("sets")))]
    demand(digest_of({"sets": [one.plain for one in sets]}) == digest, "another case is certified")
    return Union(sets, budget).follow([], claims)


FORMS["union-certificate-v1"] = "", of_unions
Union.claims.update(union=claim_union, point=claim_point, meet=claim_meet)
Union.claims.update(overlap=claim_overlap, sign=claim_sign)
