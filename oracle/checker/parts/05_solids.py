

# Part 5: solids of any shape, as unions of convex pieces. Needs parts 2 and 4.

MOST_PAIRS = 20_000  # of pieces of solids
AXES = ((1, 0, 0), (-1, 0, 0), (0, 1, 0), (0, -1, 0), (0, 0, 1), (0, 0, -1))
Homogeneous = tuple[int, int, int, int]  # the point (x / w, y / w, z / w), w > 0
HalfSpace = tuple[SpaceVector, int]  # normal * x <= height
Feature = tuple[SpaceVector, ...]  # the corners of a corner, an edge or a facet of a piece
Tiles = dict[HalfSpace, list[list[Homogeneous]]]  # convex parts of faces, by oriented planes
MORE: dict[str, Callable[[Tiles, list[Json], Budget], str]] = {}  # checks of members in part 5c


def minus(a: SpaceVector, b: SpaceVector) -> SpaceVector:
    return a[0] - b[0], a[1] - b[1], a[2] - b[2]


def plus(a: SpaceVector, b: SpaceVector) -> SpaceVector:
    return a[0] + b[0], a[1] + b[1], a[2] + b[2]


def negative(a: SpaceVector) -> SpaceVector:
    return -a[0], -a[1], -a[2]


def shortest(a: SpaceVector) -> SpaceVector:
    divisor = gcd(*a) or 1
    return a[0] // divisor, a[1] // divisor, a[2] // divisor


def below(polygon: list[Homogeneous], half: HalfSpace, budget: Budget) -> list[Homogeneous]:
    """The part below a plane of a convex polygon with an area: nothing if the part has no area; all
    of the polygon where it lies in the plane."""
    budget.spend(len(polygon))
    (a, b, c), height = half
    levels = [a * x + b * y + c * z - height * w for x, y, z, w in polygon]
    if max(levels) <= 0:
        return polygon
    if min(levels) >= 0:
        return []
    kept: list[Homogeneous] = []
    for k, end in enumerate(polygon):
        s, e = levels[k - 1], levels[k]
        if (s < 0 < e) or (e < 0 < s):
            x, y, z, w = (abs(e) * p + abs(s) * q for p, q in zip(polygon[k - 1], end, strict=True))
            divisor = gcd(x, y, z, w)
            kept.append((x // divisor, y // divisor, z // divisor, w // divisor))
        if e <= 0:
            kept.append(end)
    return kept


class Hull:
    """The convex hull of points, each of which is one of its corners."""

    def __init__(self, points: list[SpaceVector], budget: Budget) -> None:
        self.points = points
        require(len(set(points)) == len(points) > 3, "a point is there twice, or there are under 4")
        self.facets: dict[SpaceVector, list[SpaceVector]] = {}  # counter-clockwise, by the normal
        for a, b, c in itertools.combinations(points, 3):
            budget.spend(len(points))
            n = shortest(cross_in_space(minus(b, a), minus(c, a)))
            if not any(n):
                continue
            levels, level = heights(n, points), dot_in_space(n, a)
            require(min(levels) < max(levels), "its points lie in a plane")
            if level not in (min(levels), max(levels)):
                continue
            n = n if level == max(levels) else negative(n)
            if n not in self.facets:
                at = [p for p, height in zip(points, levels, strict=True) if height == level]
                self.facets[n] = hull_in_plane(at, n)
        corners = {p for ring in self.facets.values() for p in ring}
        require(len(corners) == len(points), "one of its points is no corner")
        self.edges = {tuple(sorted(e)) for ring in self.facets.values() for e in edges_of(ring)}
        self.ways = sorted({shortest(minus(q, p)) for p, q in self.edges})

    def support(self, n: SpaceVector) -> int:
        return max(heights(n, self.points))

    def holds(self, p: SpaceVector) -> bool:
        return all(dot_in_space(n, p) <= dot_in_space(n, r[0]) for n, r in self.facets.items())


class PiecesInSpace:
    """Convex pieces of an operand, scaled: hulls, and their corners, edges and facets, each with
    the hulls that hold it."""

    def __init__(self, corners: list[list[SpaceVector]], budget: Budget) -> None:
        self.hulls = [Hull(points, budget) for points in corners]
        holders: dict[SpaceVector, frozenset[int]] = {}
        for p in itertools.chain(*corners):
            if p not in holders:
                budget.spend(len(self.hulls))
                holders[p] = frozenset(k for k, hull in enumerate(self.hulls) if hull.holds(p))
        self.features: dict[Feature, frozenset[int]] = {}
        for hull in self.hulls:
            rings = [tuple(sorted(ring)) for ring in hull.facets.values()]
            for feature in (*((p,) for p in hull.points), *hull.edges, *rings):
                self.features[feature] = frozenset.intersection(*(holders[p] for p in feature))
        self.normals = {n for hull in self.hulls for n in hull.facets}
        self.edges = [
            (feature, {p for k in held for p in self.hulls[k].points})
            for feature, held in self.features.items()
            if len(feature) == 2
        ]

    def supports(self, n: SpaceVector) -> list[int]:
        return [hull.support(n) for hull in self.hulls]

    def tops(self, n: SpaceVector, budget: Budget) -> list[tuple[Feature, int]]:
        """The features that are level along a normal, with their heights, such that no hull that
        holds one reaches above it."""
        budget.spend(len(self.features))
        supports, found = self.supports(n), []
        for feature, holders in self.features.items():
            level = dot_in_space(n, feature[0])
            if all(dot_in_space(n, p) == level for p in feature[1:]):
                if all(supports[k] <= level for k in holders):
                    found.append((feature, level))
        return found


def read_pieces(value: Json, body: Body) -> tuple[list[SpacePoint], list[list[int]]]:
    """The vertices of the operand and what is added to them; the corners of each piece."""
    points, hulls = members(value, "points hulls")
    exact = [*body.exact, *map(space_vector, items(points))]
    found = [indices(entry, len(exact)) for entry in items(hulls)]
    require(bool(found), f"{body.name} has no pieces")
    require(all(one == sorted(set(one)) for one in found), "the points of a piece do not ascend")
    added = set(itertools.chain(*found)) >= set(range(len(body.exact), len(exact)))
    require(added, "a point is in no piece")
    return exact, found


def check_pieces(body: Body, pieces: list[Hull], budget: Budget) -> None:
    """Demands that the facets of the pieces, less the faces of the operand, cancel: in each plane,
    on each of its lines, each point is the start of as many edges as it is the end of."""
    ends: Counter[Any] = Counter()

    def count(normal: SpaceVector, ring: Sequence[SpaceVector], times_: int) -> None:
        budget.spend(len(ring))
        plane = max(normal, negative(normal))
        for a, b in edges_of(ring):
            way = shortest(minus(b, a))
            way = max(way, negative(way))
            line = plane, dot_in_space(plane, a), way, cross_in_space(way, a)
            ends[line, b] += times_
            ends[line, a] -= times_

    for piece in pieces:
        for normal, ring in piece.facets.items():
            count(normal, ring, 1)
    for i, face in enumerate(body.faces):
        with within(f"{body.name}, face {i}"):
            ring = [body.points[k] for k in face]
            area, normal = area_and_normal(ring)
            require(any(area), "it has no area")
            require(len(set(heights(normal, ring))) == 1, "it is not planar")
            count(normal, ring, -1)
    demand(not any(ends.values()), f"the pieces of {body.name} do not tile it")


class SolidSum:
    """The sum at a scaling, plane by plane: in each plane that may have a part of the boundary, a
    polygon that holds it is cut, and each part is said to be a face or not."""

    def __init__(
        self, value: Json, unit: int, points: list[list[SpaceVector]],
        hulls: list[list[list[int]]], budget: Budget,
    ) -> None:  # fmt: skip
        scaling, planes = members(value, "scaling planes")
        self.scaling, self.budget = space_vector(scaling), budget
        require(min(self.scaling) > 0, "a factor of the scaling is not positive")
        common = lcm(*(factor.denominator for factor in self.scaling))
        self.unit = unit * common
        factors = [common * factor for factor in self.scaling], (common, common, common)
        scaled = [[times(by, p) for p in of] for by, of in zip(factors, points, strict=True)]
        self.P, self.Q = (
            PiecesInSpace([[at[i] for i in one] for one in of], budget)
            for at, of in zip(scaled, hulls, strict=True)
        )
        self._bounds: dict[tuple[int, int], list[HalfSpace]] = {}
        self.faces: Tiles = {}
        found = self.find_planes()
        entries = [items(entry, 3) for entry in items(planes)]
        demand(len(entries) == len(found), "there are more planes, or fewer")
        for n, (plane, corners) in enumerate(sorted(found.items())):
            with within(f"plane {n}"):
                normal, offset, tree = entries[n]
                here = [integer(c) for c in items(normal, 3)] == [*plane[0]]
                demand(here and number(offset) * self.unit == plane[1], "another is expected")
                ring = hull_in_plane(list(corners), plane[0])
                self.follow(plane, [(x, y, z, 1) for x, y, z in ring], items(tree))

    def find_planes(self) -> dict[tuple[SpaceVector, int], set[SpaceVector]]:
        """The oriented planes in which the boundary may have an area, and the corners of what it
        has there at most: sums of two features, each a top along the normal."""
        planes: dict[tuple[SpaceVector, int], set[SpaceVector]] = defaultdict(set)
        P, Q, budget = self.P, self.Q, self.budget
        for n in P.normals | Q.normals:
            tops = Q.tops(n, budget)
            for one, height in P.tops(n, budget):
                budget.spend(len(tops))
                for other, level in tops:
                    if len(one) > 2 or len(other) > 2:
                        budget.spend(len(one) * len(other))
                        sums = (plus(p, q) for p in one for q in other)
                        planes[n, height + level].update(sums)
        for e, near_e in P.edges:
            for f, near_f in Q.edges:
                budget.spend(1)
                way = shortest(cross_in_space(minus(e[1], e[0]), minus(f[1], f[0])))
                for n in (way, negative(way)) if any(way) else ():
                    height, level = dot_in_space(n, e[0]), dot_in_space(n, f[0])
                    if all(dot_in_space(n, p) <= height for p in near_e):
                        if all(dot_in_space(n, p) <= level for p in near_f):
                            planes[n, height + level].update(plus(p, q) for p in e for q in f)
        return planes

    def bounds(self, pair: tuple[int, int]) -> list[HalfSpace]:
        """The half-spaces whose intersection the sum of two pieces is; those of its box first."""
        if pair not in self._bounds:
            A, B = self.P.hulls[pair[0]], self.Q.hulls[pair[1]]
            others = {*A.facets, *B.facets}
            ways = (shortest(cross_in_space(e, f)) for e in A.ways for f in B.ways)
            others |= {n for way in ways if any(way) for n in (way, negative(way))}
            normals = [*AXES, *sorted(others - {*AXES})]
            self.budget.spend(len(normals) * (len(A.points) + len(B.points)))
            self._bounds[pair] = [(n, A.support(n) + B.support(n)) for n in normals]
        return self._bounds[pair]

    def follow(
        self, plane: tuple[SpaceVector, int], whole: list[Homogeneous], tree: list[Json]
    ) -> None:
        normal, level = plane
        top_of_P, top_of_Q = self.P.supports(normal), self.Q.supports(normal)
        low_of_P, low_of_Q = (of.supports(negative(normal)) for of in (self.P, self.Q))
        pairs = list(itertools.product(range(len(top_of_P)), range(len(top_of_Q))))
        self.budget.spend(len(pairs))
        tops = {(i, j): top_of_P[i] + top_of_Q[j] for i, j in pairs}
        lows = {(i, j): -low_of_P[i] - low_of_Q[j] for i, j in pairs}
        above = [pair for pair in pairs if lows[pair] <= level < tops[pair]]
        beneath = [pair for pair in pairs if lows[pair] < level <= tops[pair]]

        def is_free(polygon: list[Homogeneous], of: list[tuple[int, int]]) -> bool:
            return not any(self.meets(polygon, pair) for pair in of)

        stack = [whole]
        for k, entry in enumerate(tree):
            with within(f"entry {k}"):
                kind, rest = headed(entry)
                require(bool(stack), "nothing is left to be cut")
                polygon = stack.pop()
                if kind == "cut":
                    a, b, c, d = map(integer, items(rest, 4))
                    height = d * self.unit
                    other = below(polygon, ((-a, -b, -c), -height), self.budget)
                    part = below(polygon, ((a, b, c), height), self.budget)
                    demand(bool(part) and bool(other) and part is not polygon, "it does not cut")
                    stack += [other, part]
                elif kind == "none":
                    items(rest, 0)
                    demand(is_free(polygon, beneath), "a sum of two pieces is below it")
                else:
                    require(kind in ("above", "face"), f"there is no entry {str(kind)[:60]!r}")
                    i, j = items(rest, 2)
                    pair = index(i, len(self.P.hulls)), index(j, len(self.Q.hulls))
                    inside = all(below(polygon, half, self.budget) is polygon
                                 for half in self.bounds(pair))  # fmt: skip
                    demand(inside, "it does not lie in the sum of these pieces")
                    if kind == "above":
                        demand(tops[pair] > level, "the sum of these pieces is not above it")
                        continue
                    demand(lows[pair] < level, "the sum of these pieces is not below it")
                    demand(is_free(polygon, above), "a sum of two pieces is above it")
                    self.faces.setdefault(plane, []).append(polygon)
        require(not stack, "entries are missing")

    def meets(self, polygon: list[Homogeneous], pair: tuple[int, int]) -> bool:
        """Whether they have an area in common."""
        for half in self.bounds(pair):
            if not (polygon := below(polygon, half, self.budget)):
                return False
        return True

    def check_claim(self, claim: list[Json]) -> str:
        """Checks a claim and returns its text."""
        scaling, planes, polygons, volume, digest, *numbers = claim
        demand(space_vector(scaling) == self.scaling, "the sum is at another scaling")
        form = CanonicalForm(self.faces, self.unit, self.budget)
        counts = [integer(planes), integer(polygons)] == [len(form.planes), form.polygons]
        demand(counts, "planes or polygons are not so many")
        demand(number(volume) == form.volume, "the volume is another")
        demand(digest_of(form.value()) == digest, "the digest is another")
        told = "".join(checked(self.faces, numbers, self.budget) for checked in MORE.values())
        at = ", ".join(map(str, self.scaling))
        return f"sum: at ({at}), {planes} planes, {told}volume {form.volume}, {digest}"


class CanonicalForm:
    """The form of a set whose boundary is tiled by convex polygons, by their oriented planes."""

    def __init__(self, faces: Tiles, unit: int, budget: Budget) -> None:
        self.budget = budget
        self.planes: list[tuple[SpaceVector, Fraction, list[Rings]]] = []
        triple = Fraction(0)
        for (normal, level), polygons in sorted(faces.items()):
            axis, offset = seen_along(normal), Fraction(level, unit)
            u, v = (k for k in range(3) if k != axis)
            mirrored = (normal[axis] > 0) == (axis == 1)
            tiles: Rings = []
            for polygon in polygons:
                ring = [(Fraction(p[u], p[3] * unit), Fraction(p[v], p[3] * unit)) for p in polygon]
                tiles.append([*ring[:: -1 if mirrored else 1]])
            region = united(tiles, budget)
            self.planes.append((normal, offset, region))
            triple += offset * sum(map(doubled_area, tiles)) / 2 / abs(normal[axis])
        self.volume = triple / 3
        self.polygons = sum(len(region) for _, _, region in self.planes)

    def is_convex(self, corners: list[SpacePoint]) -> bool:
        for (a, b, c), offset, _ in self.planes:
            self.budget.spend(len(corners))
            if any(a * x + b * y + c * z > offset for x, y, z in corners):
                return False
        return True

    def value(self) -> Json:
        """The form as JSON; for a convex polyhedron, faces and vertices."""
        corners = [
            [[lifted(p, normal, offset) for p in ring] for rings in region for ring in rings]
            for normal, offset, region in self.planes
        ]
        points = sorted({p for rings in corners for ring in rings for p in ring})
        if not self.is_convex(points):
            rows = [
                {"normal": [*map(str, normal)], "offset": str(offset), "region": plain(region)}
                for normal, offset, region in self.planes
            ]
            return {"planes": rows}
        place = {point: i for i, point in enumerate(points)}
        faces = []
        for (normal, _, _), (ring,) in zip(self.planes, corners, strict=True):
            axis = seen_along(normal)
            back = (normal[axis] > 0) == (axis == 1)
            face = [place[p] for p in ring[:: -1 if back else 1]]
            least = face.index(min(face))
            faces.append(face[least:] + face[:least])
        return {"faces": sorted(faces), "vertices": [[*map(str, point)] for point in points]}


def seen_along(normal: SpaceVector) -> int:
    return next(k for k in range(3) if normal[k])


def lifted(point: Vertex, normal: SpaceVector, offset: Fraction) -> SpacePoint:
    """The point of a plane that is seen there along the first axis in which it has a normal."""
    axis = seen_along(normal)
    u, v = (k for k in range(3) if k != axis)
    rest = (offset - normal[u] * point[0] - normal[v] * point[1]) / normal[axis]
    place = [*point[:axis], rest, *point[axis:]]
    return place[0], place[1], place[2]


def united(tiles: Rings, budget: Budget) -> list[Rings]:
    """The canonical form of the union of convex polygons, counter-clockwise, that do not overlap:
    for each component of its interior the outer ring and the holes."""
    lines: dict[Any, list[tuple[Vertex, Vertex, int]]] = defaultdict(list)
    for n, tile in enumerate(tiles):
        for a, b in edges_of(tile):
            lines[line_of(a, b)].append((a, b, n))
    root, sides = list(range(len(tiles))), []
    for edges in lines.values():
        stops = sorted({p for a, b, _ in edges for p in (a, b)})
        budget.spend(len(stops) * len(edges))
        for low, high in itertools.pairwise(stops):
            left = [n for a, b, n in edges if a <= low and high <= b]
            right = [n for a, b, n in edges if b <= low and high <= a]
            if left and right:
                root[find(root, left[0])] = find(root, right[0])
            elif left or right:
                sides.append((low, high, left[0]) if left else (high, low, right[0]))
    sides = cut_at_ends(sides, budget)
    leaving: dict[Vertex, list[tuple[Vertex, Vertex, int]]] = defaultdict(list)
    for side in sides:
        leaving[side[0]].append(side)
    found: dict[int, Rings] = defaultdict(list)
    done: set[tuple[Vertex, Vertex]] = set()
    for first in sides:
        walk: list[Vertex] = []
        side = first
        while side[:2] not in done:
            done.add(side[:2])
            walk.append(side[0])
            budget.spend(len(leaving[side[1]]))
            side = next_side(side, leaving[side[1]])
        for ring in simple_rings(walk):
            found[find(root, side[2])].append(ring)
    polygons = []
    for rings in found.values():
        outer = [ring for ring in rings if doubled_area(ring) > 0]
        demand(len(outer) == 1, "a component has not one outer ring")
        polygons.append([*outer, *sorted(ring for ring in rings if doubled_area(ring) < 0)])
    return sorted(polygons)


def line_of(a: Vertex, b: Vertex) -> tuple[Any, ...]:
    if a[0] == b[0]:
        return (a[0],)
    slope = (b[1] - a[1]) / (b[0] - a[0])
    return slope, a[1] - slope * a[0]


def cut_at_ends(
    sides: list[tuple[Vertex, Vertex, int]], budget: Budget
) -> list[tuple[Vertex, Vertex, int]]:
    """Sides cut where others begin in their insides: the boundary touches itself there."""
    ends: dict[Any, list[Vertex]] = defaultdict(list)
    starts = sorted({a for a, _, _ in sides})
    for line in {line_of(a, b) for a, b, _ in sides}:
        budget.spend(len(starts))
        ends[line] = [p for p in starts if (
            p[0] == line[0] if len(line) == 1 else p[1] == line[0] * p[0] + line[1]
        )]  # fmt: skip
    cut = []
    for a, b, n in sides:
        inside = [p for p in ends[line_of(a, b)] if min(a, b) < p < max(a, b)]
        stops = [a, *(inside if a < b else inside[::-1]), b]
        cut += [(p, q, n) for p, q in itertools.pairwise(stops)]
    return cut


def next_side(
    side: tuple[Vertex, Vertex, int], leaving: list[tuple[Vertex, Vertex, int]]
) -> tuple[Vertex, Vertex, int]:
    """The first clockwise from where a side came: both bound one wedge of the interior."""
    back = side[0][0] - side[1][0], side[0][1] - side[1][1]
    best, at_best, half_best = side, back, 9
    for other in leaving:
        way = other[1][0] - other[0][0], other[1][1] - other[0][1]
        turned = cross(back, way)
        half = 0 if turned < 0 else 1 if turned == 0 else 2
        if half < half_best or (half == half_best and cross(at_best, way) > 0):
            best, at_best, half_best = other, way, half
    return best


def simple_rings(walk: list[Vertex]) -> Iterator[list[Vertex]]:
    """A closed walk, split where it comes to a point again; without the points where it goes
    straight on."""
    ring: list[Vertex] = []
    place: dict[Vertex, int] = {}
    for point in [*walk, *walk[:1]]:
        if point in place:
            at = place[point]
            yield in_order(ring[at:])
            for passed in ring[at:]:
                del place[passed]
            del ring[at:]
        place[point] = len(ring)
        ring.append(point)


def in_order(ring: list[Vertex]) -> list[Vertex]:
    """From its least corner."""
    n = len(ring)
    ways = [(b[0] - a[0], b[1] - a[1]) for a, b in edges_of(ring)]
    corners = [ring[k] for k in range(n) if cross(ways[k - 1], ways[k]) != 0]
    least = corners.index(min(corners))
    return corners[least:] + corners[:least]


def tiled(case: Json, digest: Json, parts: list[Json], budget: Budget) -> tuple[Any, ...]:
    """The unit that makes coordinates whole, and for both operands: the points, the numbers of the
    corners of each piece, and the pieces."""
    bodies = bodies_of(case, digest)
    exact, hulls = zip(*map(read_pieces, parts, bodies), strict=True)
    demand(len(hulls[0]) * len(hulls[1]) <= MOST_PAIRS, "too many pairs of pieces", OUT_OF_BUDGET)
    unit, found = budget.common([*itertools.chain(*exact)]), []
    points = [[times((unit, unit, unit), p) for p in of] for of in exact]
    for body, at, pieces in zip(bodies, points, hulls, strict=True):
        body.points = at[: len(body.exact)]
        with within(f"the pieces of {body.name}"):
            found.append([Hull([at[i] for i in one], budget) for one in pieces])
            check_pieces(body, found[-1], budget)
    return unit, points, list(hulls), found


def of_solids(case: Json, digest: Json, proof: Json, claims: Json, budget: Budget) -> list[str]:
    *parts, entries = members(proof, "P Q sums")
    unit, points, hulls, _ = tiled(case, digest, parts, budget)
    sums: list[SolidSum] = []
    for entry in items(entries):
        with within(f"sum {len(sums)}"):
            sums.append(SolidSum(entry, unit, points, hulls, budget))
    return said_of(sums, claims, " ".join(["planes polygons volume digest", *MORE]), budget)


FORMS["solid-certificate-v1"] = "proof", of_solids
