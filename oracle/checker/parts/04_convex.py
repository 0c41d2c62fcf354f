

# Part 4: space, surfaces whose vertices are whole numbers, and sums of convex polyhedra.

SpaceVector = tuple[int, int, int]
SpacePoint = tuple[Fraction, Fraction, Fraction]


def indices(value: Json, end: int) -> list[int]:
    numbers = [integer(entry) for entry in items(value)]
    require(all(0 <= i < end for i in numbers), f"one of {numbers[:9]}... is no number here")
    return numbers


def space_vector(value: Json) -> SpacePoint:
    x, y, z = map(number, items(value, 3))
    return x, y, z


def dot_in_space(u: SpaceVector, v: SpaceVector) -> int:
    return u[0] * v[0] + u[1] * v[1] + u[2] * v[2]


def cross_in_space(u: SpaceVector, v: SpaceVector) -> SpaceVector:
    return u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]


def times(factors: Sequence[Any], point: Sequence[Any]) -> SpaceVector:
    """The products, which are whole numbers."""
    return int(factors[0] * point[0]), int(factors[1] * point[1]), int(factors[2] * point[2])


def heights(normal: SpaceVector, points: Sequence[SpaceVector]) -> list[int]:
    a, b, c = normal
    return [a * x + b * y + c * z for x, y, z in points]


def turn(a: SpaceVector, b: SpaceVector, c: SpaceVector, normal: SpaceVector) -> int:
    """Positive if the way a b c turns left, seen against the normal."""
    u, v = ((q[0] - p[0], q[1] - p[1], q[2] - p[2]) for p, q in ((a, b), (b, c)))
    return dot_in_space(cross_in_space(u, v), normal)


def is_ring(ring: Sequence[int]) -> bool:
    return len(set(ring)) == len(ring) >= 3


def area_and_normal(ring: Sequence[SpaceVector]) -> tuple[SpaceVector, SpaceVector]:
    """Twice the area, as a vector to the side from which the ring runs counter-clockwise; the
    shortest whole vector along it."""
    x, y, z = map(sum, zip(*(cross_in_space(*edge) for edge in edges_of(ring)), strict=True))
    divisor = gcd(x, y, z) or 1
    return (x, y, z), (x // divisor, y // divisor, z // divisor)


def is_closed(rings: Sequence[list[int]]) -> bool:
    """Whether each directed edge is in one ring only, and its reverse in one."""
    edges = [edge for ring in rings for edge in edges_of(ring)]
    there = set(edges)
    return len(there) == len(edges) and all((b, a) in there for a, b in edges)


def hull_in_plane(points: Sequence[SpaceVector], normal: SpaceVector) -> list[SpaceVector]:
    """The corners of the hull of points in a plane, in which lexicographic order is a sweep."""
    both: list[SpaceVector] = []
    for run in (sorted(points), sorted(points, reverse=True)):
        chain: list[SpaceVector] = []
        for p in run:
            while len(chain) > 1 and turn(chain[-2], chain[-1], p, normal) <= 0:
                chain.pop()
            chain.append(p)
        both += chain[:-1]
    return both


class Body:
    """A polyhedron, its vertices and faces in the order of the file."""

    def __init__(self, value: Json, name: str) -> None:
        self.name, (vertices, faces) = name, members(value, "vertices faces")
        self.exact = [space_vector(vertex) for vertex in items(vertices)]
        self.faces = [indices(face, len(self.exact)) for face in items(faces)]
        rings = bool(self.faces) and all(map(is_ring, self.faces))
        require(rings, f"{name} has a face that is no ring, or none")
        used = len(set(itertools.chain(*self.faces))) == len(self.exact)
        require(used, f"{name} has a vertex in no face")

    def plain(self) -> Json:
        """The value that is hashed, with numbers in lowest terms."""
        return {"faces": self.faces, "vertices": [[str(c) for c in point] for point in self.exact]}

    def check(self, unit: int, budget: Budget) -> None:
        """Whether the faces go once around the convex hull of the vertices."""
        self.points = [times((unit, unit, unit), point) for point in self.exact]
        require(len(set(self.points)) == len(self.points), f"{self.name} has a point twice")
        require(is_closed(self.faces), f"{self.name} is not closed")
        first, covered, at_top = (0, 0, 0), 0, self.points
        for i, face in enumerate(self.faces):
            with within(f"{self.name}, face {i}"):
                area, normal = area_and_normal([self.points[k] for k in face])
                require(any(area), "it has no area")
                budget.spend(len(self.points))
                levels = heights(normal, self.points)
                require(len({levels[k] for k in face}) == 1, "it is not planar")
                require(levels[face[0]] == max(levels), "a vertex lies above its plane")
                if i == 0:
                    require(min(levels) < max(levels), "all vertices lie in its plane")
                    first, at_top = normal, [self.points[k] for k in greatest(levels)]
                covered += dot_in_space(area, first) if normal == first else 0
        once = dot_in_space(area_and_normal(hull_in_plane(at_top, first))[0], first)
        require(covered == once, f"{self.name} goes around its hull more than once")


def greatest(levels: list[int]) -> list[int]:
    """Where the greatest ones are."""
    most = max(levels)
    return [i for i, level in enumerate(levels) if level == most]


class ConvexSum:
    """The sum at a scaling: a closed surface, each vertex S p + q, each facet in a plane that P and
    Q, where they are farthest along its normal, reach together."""

    def __init__(self, value: Json, P: Body, Q: Body, unit: int, budget: Budget) -> None:
        scaling, vertices, facets = members(value, "scaling vertices facets")
        self.scaling = space_vector(scaling)
        require(min(self.scaling) > 0, "a factor of the scaling is not positive")
        pairs = [items(pair, 2) for pair in items(vertices)]
        for p, q in pairs:
            indices([p], len(P.exact)), indices([q], len(Q.exact))
        ends = len(pairs), len(P.exact), len(Q.exact)
        parts = [list(map(indices, items(facet, 3), ends)) for facet in items(facets)]
        self.rings = [ring for ring, _, _ in parts]
        rings = bool(parts) and all(map(is_ring, self.rings))
        require(rings, "a facet is no ring, or there is none")
        begin = all(ring[0] == min(ring) for ring in self.rings)
        require(begin, "a facet does not begin with its least vertex")
        require(self.rings == sorted(self.rings), "the facets do not ascend")
        require(len(set(itertools.chain(*self.rings))) == len(pairs), "a vertex is in no facet")
        budget.spend(sum(ends))
        common = lcm(*(factor.denominator for factor in self.scaling))
        self.unit = unit * common
        self.P = [times([common * factor for factor in self.scaling], p) for p in P.points]
        self.Q = [times((common, common, common), q) for q in Q.points]
        sums = (zip(self.P[p], self.Q[q], strict=True) for p, q in pairs)
        self.points = [(a + d, b + e, c + f) for (a, d), (b, e), (c, f) in sums]
        demand(self.points == sorted(set(self.points)), "the vertices do not ascend")
        demand(is_closed(self.rings), "the facets are not closed")
        self.normals: set[SpaceVector] = set()
        self.sextuple = 0  # of the volume
        for i, part in enumerate(parts):
            with within(f"facet {i}"):
                budget.spend(len(P.points) + len(Q.points))
                self.check_facet(*part)

    def check_facet(self, ring: list[int], of_P: list[int], of_Q: list[int]) -> None:
        corners = [self.points[i] for i in ring]
        area, normal = area_and_normal(corners)
        demand(any(area), "it has no area")
        demand(normal not in self.normals, "another facet has its normal")
        self.normals.add(normal)
        level = dot_in_space(normal, corners[0])
        demand(set(heights(normal, corners)) == {level}, "it is not planar")
        ways = zip(corners, corners[1:] + corners[:1], corners[2:] + corners[:2], strict=True)
        demand(all(turn(*way, normal) > 0 for way in ways), "it does not turn left")
        levels = heights(normal, self.P), heights(normal, self.Q)
        demand(sum(map(max, levels)) == level, "the sum reaches beyond its plane")
        demand([of_P, of_Q] == [*map(greatest, levels)], "other vertices of P or Q are farthest")
        self.sextuple += dot_in_space(area, corners[0])

    def check_claim(self, claim: list[Json]) -> str:
        """Checks a claim and returns its text."""
        scaling, vertices, facets, volume, digest = claim
        demand(space_vector(scaling) == self.scaling, "the sum is at another scaling")
        counts = [integer(vertices), integer(facets)] == [len(self.points), len(self.rings)]
        demand(counts, "vertices or facets are not so many")
        found = Fraction(self.sextuple, 6 * self.unit**3)
        demand(number(volume) == found, "the volume is another")
        plain = [[str(Fraction(c, self.unit)) for c in point] for point in self.points]
        same = digest_of({"faces": self.rings, "vertices": plain}) == digest
        demand(same, "the digest is another")
        at = ", ".join(map(str, self.scaling))
        return f"sum: at ({at}), {vertices} vertices, {facets} facets, volume {found}, {digest}"


def bodies_of(case: Json, digest: Json) -> list[Body]:
    require(case.get("dimension") == 3, "this is no case in space")
    bodies = [Body(case.get(operand), operand) for operand in "PQ"]
    plain = {body.name: body.plain() for body in bodies}
    demand(digest_of(plain) == digest, "not the case that is certified")
    return bodies


def of_convex_bodies(
    case: Json, digest: Json, entries: Json, claims: Json, budget: Budget
) -> list[str]:
    P, Q = bodies_of(case, digest)
    unit = budget.common(P.exact + Q.exact)
    for operand in (P, Q):
        operand.check(unit, budget)
    sums: list[ConvexSum] = []
    for entry in items(entries):
        with within(f"sum {len(sums)}"):
            sums.append(ConvexSum(entry, P, Q, unit, budget))
    return said_of(sums, claims, "vertices facets volume digest", budget)


def said_of(sums: Sequence[Any], claims: Json, names: str, budget: Budget) -> list[str]:
    """Checks claims about sums in space; returns them as texts."""
    require(len({one.scaling for one in sums}) == len(sums), "two sums are at one scaling")
    require(len(set(map(digest_of, items(claims)))) == len(claims), "a claim is made twice")
    said: list[str] = []
    used: set[int] = set()
    for claim in claims:
        with within(f"claim {len(said)}"):
            budget.spend(64)
            kind, i, *more = members(claim, f"claim sum scaling {names}")
            require(kind == "sum", f"there is no claim {kind!r}")
            used |= {*indices([i], len(sums))}
            said.append(sums[i].check_claim(more))
    require(bool(said) and len(used) == len(sums), "nothing is claimed, or a sum is not used")
    return said


FORMS["convex-certificate-v1"] = "sums", of_convex_bodies
