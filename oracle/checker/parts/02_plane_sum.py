

# Part 2: sums in the plane. An object of the class of a step exists only if the step holds.

Kind = TypeVar("Kind")
Vector = tuple[int, int]
Triple = tuple[Any, Any, Any]  # the point (x / w, y / w), w > 0; the line a x + b y + c = 0
Rings = list[list[Vertex]]  # the outer one, and the holes
Edge = tuple[int, int]


class Operand:
    """Its vertices in the order of the file, and its rings as their indices."""

    def __init__(self, value: Json, name: str) -> None:
        self.name = name
        self.exact: list[Vertex] = []
        self.points: list[Triple] = []  # the vertices in units that make them integers
        self.rings: list[list[int]] = []
        self.outer: set[int] = set()  # which rings are
        self.plain: list[Json] = []  # what is hashed: numbers in lowest terms
        for polygon in items(members(value, "polygons")[0]):
            outer, holes = members(polygon, "outer holes?")
            self.outer.add(len(self.rings))
            rings = [self.read_ring(r) for r in [outer, *items([] if holes is None else holes)]]
            self.plain.append({"holes": rings[1:], "outer": rings[0]})
        self.thin = any(len(ring) < 3 for ring in self.rings)  # a point or a segment
        require(not self.thin or len(self.rings) == 1, f"{name} has a ring of too few vertices")

    def read_ring(self, value: Json) -> Json:
        ring = [vector(point) for point in items(value)]
        require(bool(ring), f"{self.name} has an empty ring")
        self.rings.append(list(range(len(self.exact), len(self.exact) + len(ring))))
        self.exact += ring
        return [[str(x), str(y)] for x, y in ring]


def cross(u: Sequence[Any], v: Sequence[Any]) -> Any:
    return u[0] * v[1] - u[1] * v[0]


def dot(u: Sequence[Any], v: Sequence[Any]) -> Any:
    return u[0] * v[0] + u[1] * v[1]


def across(u: Triple, v: Triple) -> Triple:
    """The line through two points; up to a factor the point on two lines."""
    return u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]


def meet(first: Triple, second: Triple) -> Triple:
    x, y, w = across(first, second)
    demand(w != 0, "parallel lines do not meet")
    divisor = gcd(x, y, w) if w > 0 else -gcd(x, y, w)
    return x // divisor, y // divisor, w // divisor


def direction(p: Triple, q: Triple) -> Vector:
    return q[0] * p[2] - p[0] * q[2], q[1] * p[2] - p[1] * q[2]


def doubled_area(ring: Sequence[Any]) -> Any:
    return sum(cross(a, b) for a, b in edges_of(ring))


def is_convex(directions: Sequence[Vector]) -> bool:
    """Whether edges of these directions turn left, or go straight on, once around in all."""
    upwards = [d[1] > 0 or (d[1] == 0 and d[0] > 0) for d in directions]
    pairs = list(edges_of(directions))
    turns = all(cross(d, e) > 0 or (cross(d, e) == 0 and dot(d, e) > 0) for d, e in pairs)
    return turns and sum(not before and now for before, now in edges_of(upwards)) == 1


def hull(points: Iterable[Triple]) -> list[Triple]:
    """The vertices of the convex hull, counter-clockwise."""
    ordered = sorted(set(points))
    both: list[Triple] = []
    for run in (ordered, ordered[::-1]):
        chain: list[Triple] = []
        for p in run:
            while len(chain) > 1 and cross(direction(*chain[-2:]), direction(chain[-1], p)) <= 0:
                chain.pop()
            chain.append(p)
        both += chain[:-1]
    return both or ordered


def divides(A: list[Triple], B: list[Triple]) -> bool:
    """Whether the line of an edge of A has all of B on its other side."""
    sides = ([cross(direction(a, b), direction(a, p)) for p in B] for a, b in edges_of(A))
    return any(max(side) <= 0 for side in sides)


def whole_normal(value: Vertex) -> Vector:
    require(all(c.denominator == 1 for c in value), "a normal is not of whole numbers")
    require(any(value), "a normal is zero")
    return int(value[0]), int(value[1])


def add_up_to_nothing(edges: Iterable[tuple[Any, Any, int]]) -> bool:
    """Whether directed edges, each so many times, cancel: on each line their ends do."""
    ends: dict[Any, int] = defaultdict(int)
    for (x, y, *_), (X, Y, *_), times in edges:
        slope = Fraction(Y - y) / (X - x) if X != x else None
        line = x if slope is None else (slope, y - slope * x)
        ends[line, x, y] += times
        ends[line, X, Y] -= times
    return not any(ends.values())


class Pieces:
    """`pieces`: convex pieces that tile an operand, and groups of them. Node n is piece n, or group
    n - (number of pieces); the last one holds all. A node is solid if it is known to be convex."""

    def __init__(self, step: Json, proof: Proof) -> None:
        of, pieces, groups = members(step, "rule of pieces groups")[1:]
        self.operand, self.proof = proof.operand(of), proof
        points = self.operand.points
        pieces = [[index(i, len(points)) for i in items(piece)] for piece in items(pieces)]
        self.hulls = [[points[i] for i in piece] for piece in pieces]
        self.check_tiling(pieces)
        self.children: list[list[int]] = [[] for _ in pieces]
        self.leaves = [{i} for i in range(len(pieces))]
        self.solid = [True for _ in pieces]
        for group in items(groups):
            self.add_group([index(child, len(self.hulls)) for child in items(group)])
        whole = not pieces or len(self.leaves[-1]) == len(pieces)
        demand(whole, "the last node does not hold all pieces")
        self.root = [len(self.hulls) - 1] if pieces else []
        self.support: dict[tuple[int, Vector], int] = {}

    def check_tiling(self, pieces: list[list[int]]) -> None:
        points, rings, name = self.operand.points, self.operand.rings, self.operand.name
        if self.operand.thin:
            return demand(pieces == rings, f"{name} is no region: it is its own only piece")
        self.proof.spend(sum(map(len, [*rings, *pieces])))
        given = [(points[i], points[j], -1) for ring in rings for i, j in edges_of(ring)]
        made = [(a, b, 1) for piece in self.hulls for a, b in edges_of(piece)]
        demand(add_up_to_nothing(given + made), f"the pieces do not add up to {name}")
        for piece in self.hulls:
            demand(is_convex([direction(*e) for e in edges_of(piece)]), "a piece is not convex")

    def add_group(self, children: list[int]) -> None:
        require(0 < len(children) == len(set(children)), "a group has no member, or one twice")
        parts = [self.hulls[child] for child in children]
        self.proof.spend(sum(map(len, parts)) + sum(len(self.leaves[child]) for child in children))
        self.children.append(children)
        self.leaves.append(set().union(*(self.leaves[child] for child in children)))
        self.hulls.append(hull(corner for part in parts for corner in part))
        solid = len(parts) == 2 and all(self.solid[child] for child in children)
        solid = solid and doubled_area(self.hulls[-1]) == sum(map(doubled_area, parts))
        self.solid.append(solid and (divides(*parts) or divides(*parts[::-1])))

    def most(self, node: int, normal: Vector) -> int:
        """The largest value of normal * x on the hull of a node."""
        if (node, normal) not in self.support:
            self.proof.spend(len(self.hulls[node]))
            self.support[node, normal] = max(dot(normal, corner) for corner in self.hulls[node])
        return self.support[node, normal]


class Region:
    """`eq` at one scale, `move` from one to another: convex cells that tile a box, each covered by
    the sum of two solid nodes or apart from it, which is thus the union of those covered. Corners
    are linear in s: what is linear and holds at both ends holds between."""

    def __init__(self, step: Json, proof: Proof) -> None:
        names = "rule scales by box elements cells normals proofs contacts polygons"
        rule, scales, by, *lists = members(step, names)
        box, elements, cells, normals, proofs, contacts, rings = map(items, lists)
        self.proof = proof
        self.scales = [scale_of(scale) for scale in items(scales, 1 if rule == "eq" else 2)]
        require(self.scales == sorted(set(self.scales)), "the scales do not ascend")
        self.P, self.Q = (proof.step(value, Pieces) for value in items(by, 2))
        require((self.P.operand.name, self.Q.operand.name) == ("P", "Q"), "`by` is not of P and Q")
        self.roots = list(itertools.product(self.P.root, self.Q.root))  # none: the sum is empty
        self.box = [number(value) * proof.unit for value in items(box, 4)]
        demand(self.box[0] < self.box[2] and self.box[1] < self.box[3], "the box is empty")
        self.lines: dict[int, list[Triple]] = {}
        for wall, at in enumerate(self.box):
            normal = (at.denominator, 0) if wall % 2 == 0 else (0, at.denominator)
            self.lines[wall] = [(*normal, -at.numerator) for _ in self.scales]
        self.points: dict[int, list[Triple]] = {}
        for entry in elements:
            self.add_element(*headed(entry))
        self.cells = [[self.point(i) for i in items(cell)] for cell in cells]
        self.owner: dict[Edge, int] = {}
        self.directions: dict[Edge, Vector] = {}
        for cell in range(len(self.cells)):
            self.check_cell(cell)
        self.check_box()
        self.normals = [whole_normal(vector(normal)) for normal in normals]
        self.inside: dict[int, list[Json]] = {}  # the covered cells, with their nodes
        for cell, (how, code) in enumerate(map(headed, items(proofs, len(self.cells)))):
            require(how in ("cov", "sep"), f"cell {cell} has no proof")
            (self.check_cover if how == "cov" else self.check_apart)(self.cells[cell], code)
            self.inside.update({cell: code} if how == "cov" else {})
        self.contacts = set()
        for ids, code in map(headed, contacts):
            contact = [self.point(i) for i in items(ids)]
            require(1 <= len(contact) == len(set(contact)) <= 2, "this is no point or segment")
            self.check_apart(contact, code)
            self.contacts.add(tuple(contact))
        self.count()
        self.passed: list[Vertex] = []  # the points of the rings
        self.polygons = self.canonical([[items(r) for r in items(p)] for p in rings])

    def point(self, value: Json) -> int:
        require(integer(value) in self.points, f"element {value} is no point before this")
        return int(value)

    def add_element(self, kind: Json, entry: list[Json]) -> None:
        self.proof.spend(1)
        own = len(self.lines) + len(self.points)
        if kind == "meet":
            require(all(integer(i) in self.lines for i in items(entry, 2)), "no lines to meet")
            self.points[own] = list(map(meet, *(self.lines[i] for i in entry)))
        elif kind == "up":
            at = self.points[self.point(items(entry, 1)[0])]
            self.lines[own] = [(w, 0, -x) for x, _, w in at]
        else:
            self.lines[own] = self.moving_line(self.proof.operand(kind), items(entry, 3))

    def moving_line(self, mover: Operand, entry: list[Json]) -> list[Triple]:
        """Through vertices i and k of one operand, moved by vertex j of the other."""
        other = self.proof.operands["Q" if mover.name == "P" else "P"]
        i, k = (mover.points[index(value, len(mover.points))] for value in entry[:2])
        j = other.points[index(entry[2], len(other.points))]
        demand(i != k, "a line has no direction")
        dx, dy = direction(i, k)
        p, q = (i, j) if mover.name == "P" else (j, i)
        p, q = dot((-dy, dx), p), dot((-dy, dx), q)
        fractions = ((s.numerator, s.denominator) for s in self.scales)
        return [(-dy * v, dx * v, -u * p - v * q) for u, v in fractions]

    def check_cell(self, cell: int) -> None:
        self.proof.spend(len(self.cells[cell]))
        turns = []
        for edge in edges_of(self.cells[cell]):
            pairs = zip(*(self.points[end] for end in edge), strict=True)
            moves = [d for d in (direction(a, b) for a, b in pairs) if d != (0, 0)]
            demand(bool(moves), f"cell {cell} has an edge without length")
            straight = len(moves) == 1 or (cross(*moves) == 0 and dot(*moves) > 0)
            demand(straight, f"cell {cell} has an edge that turns")
            demand(edge not in self.owner, f"two cells have the edge {edge}")
            self.owner[edge], self.directions[edge] = cell, moves[0]
            turns.append(moves[0])
        demand(len(turns) > 2 and is_convex(turns), f"cell {cell} is not convex")

    def check_box(self) -> None:
        """Edges with a cell on one side only are the rim of the box, which holds the sum."""
        rim = [edge for edge in self.owner if edge[::-1] not in self.owner]
        for u, v in rim:
            ends = [*self.points[u], *self.points[v]]
            on_wall = any(all(self.box[w] * p[2] == p[w % 2] for p in ends) for w in range(4))
            demand(on_wall, f"the edge {u}, {v} of a cell has no cell on its other side")
        at = {i: [Fraction(c, p[0][2]) for c in p[0][:2]] for i, p in self.points.items()}
        x, y, X, Y = self.box
        frame = [(a, b, -1) for a, b in edges_of([(x, y), (X, y), (X, Y), (x, Y)])]
        made = [(at[u], at[v], 1) for u, v in rim]
        demand(add_up_to_nothing(frame + made), "the cells do not add up to the box")
        for normal, c in zip([(-1, 0), (0, -1), (1, 0), (0, 1)], self.box, strict=True):
            for (end, s), (A, B) in itertools.product(enumerate(self.scales), self.roots):
                most = Fraction(self.most(end, A, B, normal), s.denominator)
                demand(most < sum(normal) * c, "the box does not hold the sum")

    def most(self, end: int, A: int, B: int, normal: Vector) -> int:
        """The largest value of normal * x on sA + B, times the denominator of s."""
        s = self.scales[end]
        return s.numerator * self.P.most(A, normal) + s.denominator * self.Q.most(B, normal)

    def least(self, end: int, corners: list[int], normal: Vector, side: int) -> int:
        """The least value (side 1) of normal * x on points, rounded down, or the largest (-1),
        rounded up, in the unit of `most`."""
        factor = side * self.scales[end].denominator
        points = (self.points[i][end] for i in corners)
        return side * int(min(factor * dot(normal, p) // p[2] for p in points))

    def check_cover(self, corners: list[int], nodes: list[Json]) -> None:
        """`cov`: the hull of the corners lies in sA + B, both nodes solid."""
        A, B = items(nodes, 2)
        A, B = index(A, len(self.P.hulls)), index(B, len(self.Q.hulls))
        demand(self.P.solid[A] and self.Q.solid[B], f"{A} or {B} is not convex")
        for a, b in [*edges_of(self.P.hulls[A]), *edges_of(self.Q.hulls[B])]:
            self.proof.spend(len(corners))
            normal = b[1] - a[1], a[0] - b[0]
            for end in range(len(self.scales)):
                inside = self.least(end, corners, normal, -1) <= self.most(end, A, B, normal)
                demand(inside, f"{corners} is not in the sum of {A} and {B}")

    def check_apart(self, corners: list[int], code: list[Json]) -> None:
        """`sep`, for all pairs of pieces: -1 splits the first node of the pair in hand, -2 the
        second; n says that normal n separates the pair from the corners (they may touch)."""
        self.proof.spend(len(code))
        known: dict[Edge, int] = {}
        pairs = list(self.roots)
        for token in code:
            demand(bool(pairs), "a code goes on after its end")
            A, B = pairs.pop()
            if token in (-1, -2):
                children = self.P.children[A] if token == -1 else self.Q.children[B]
                demand(bool(children), "a code splits a piece")
                pairs += [(c, B) if token == -1 else (A, c) for c in reversed(children)]
                continue
            normal = self.normals[index(token, len(self.normals))]
            for end in range(len(self.scales)):
                if (end, token) not in known:
                    known[end, token] = self.least(end, corners, normal, 1)
                apart = known[end, token] >= self.most(end, A, B, normal)
                demand(apart, f"normal {normal} does not separate {corners} from {A} and {B}")
        demand(not pairs, "a code ends too early")

    def count(self) -> None:
        """Components of the interior, and holes: cells that share an edge, joined."""
        root = list(range(len(self.cells)))
        for edge, cell in self.owner.items():
            other = self.owner.get(edge[::-1], cell)
            if (cell in self.inside) == (other in self.inside):
                root[find(root, cell)] = find(root, other)
        self.root = [find(root, cell) for cell in range(len(root))]
        components = len({self.root[cell] for cell in self.inside})
        self.counts = [components, len(set(self.root)) - components - 1]

    def canonical(self, polygons: list[list[list[Json]]]) -> list[Rings]:
        owner, d = self.owner, self.directions
        left = {e for e in owner if owner[e] in self.inside and owner[e[::-1]] not in self.inside}
        middle = sum(self.scales, Fraction(0)) / len(self.scales)
        made, roots = [], []
        for polygon in polygons:
            require(bool(polygon), "a polygon has no ring")
            rings: Rings = []
            roots.append(set[int]())
            for ring in polygon:
                edges = list(edges_of([self.point(v) for v in ring]))
                simple = len(set(ring)) == len(ring) > 2 and left.issuperset(edges)
                demand(simple, "a ring is not simple, or not on the boundary")
                left.difference_update(edges)
                roots[-1] |= {self.root[owner[e]] for e in edges}
                self.passed += [self.vertex(point) for point, _ in edges]
                rings.append([self.vertex(f[0]) for e, f in edges_of(edges) if cross(d[e], d[f])])
                outer = doubled_area([at_scale(v, middle) for v in rings[-1]]) > 0
                demand(outer == (len(rings) == 1), "a ring runs the wrong way")
            made.append(rings)
        one_each = len(roots) == self.counts[0] and all(len(root) == 1 for root in roots)
        demand(not left and one_each, "the rings are not the boundary, a polygon a component")
        return canonical_order(made)

    def vertex(self, point: int) -> Vertex:
        ends = [[Fraction(c, p[2] * self.proof.unit) for c in p[:2]] for p in self.points[point]]
        if len(ends) == 1:
            return tuple(ends[0])
        a, b = self.scales
        u, v = ((q - p) / (b - a) for p, q in zip(*ends, strict=True))
        return ends[0][0] - a * u, u, ends[0][1] - a * v, v


def find(root: list[int], cell: int) -> int:
    while root[cell] != cell:
        root[cell] = cell = root[root[cell]]
    return cell


def at_scale(vertex: Vertex, s: Fraction) -> Vertex:
    return vertex if len(vertex) == 2 else (vertex[0] + s * vertex[1], vertex[2] + s * vertex[3])


def canonical_order(polygons: list[Rings]) -> list[Rings]:
    def turned(ring: list[Vertex]) -> list[Vertex]:
        return ring[ring.index(min(ring)) :] + ring[: ring.index(min(ring))]

    return sorted([turned(rings[0]), *sorted(map(turned, rings[1:]))] for rings in polygons)


def plain(polygons: list[Rings]) -> Json:
    rings = [[[[str(c) for c in v] for v in ring] for ring in polygon] for polygon in polygons]
    return {"polygons": [{"holes": polygon[1:], "outer": polygon[0]} for polygon in rings]}


class Proof:
    """The operands, and the steps and claims that hold so far."""

    rules: ClassVar[dict[Any, Any]] = {"pieces": Pieces, "eq": Region, "move": Region}
    claims: ClassVar[dict[Any, Any]] = {}  # what checks one; returns its text and what it shows

    def __init__(self, P: Operand, Q: Operand, budget: Budget) -> None:
        require(not (P.thin and Q.thin), "both operands are points or segments")
        self.operands = {P.name: P, Q.name: Q}
        self.spend = budget.spend
        self.unit = budget.common(P.exact + Q.exact)
        for o in (P, Q):
            o.points = [(int(x * self.unit), int(y * self.unit), 1) for x, y in o.exact]
            areas = [doubled_area([o.points[i] for i in ring]) for ring in o.rings]
            right = o.thin or all(a and (a > 0) == (i in o.outer) for i, a in enumerate(areas))
            require(right, f"{o.name} has a ring that runs the wrong way")

    def operand(self, name: Json) -> Operand:
        require(name in tuple(self.operands), f"{name!r} is no operand")
        return self.operands[name]

    def step(self, value: Json, kind: type[Kind]) -> Kind:
        step = self.steps[index(value, len(self.steps))]
        require(isinstance(step, kind), f"step {value} is no {kind.__name__.lower()}")
        self.used.add(value)
        return step  # type: ignore[no-any-return]

    def region(self, step: Json, scale: Json) -> Region:
        region = self.step(step, Region)
        demand(region.scales == [scale_of(scale)], "the step is about another scale")
        return region

    def follow(self, steps: Json, claims: Json) -> list[str]:
        """Checks steps and claims; returns the claims as texts."""
        self.steps: list[Any] = []
        self.used: set[int] = set()
        self.shown: list[Any] = []  # the region, or the regions, that a claim is about
        self.said: list[str] = []
        for i, step in enumerate(items(steps)):
            with within(f"step {i}"):
                rule = step.get("rule") if isinstance(step, dict) else None
                require(rule in tuple(self.rules), f"there is no rule {rule!r}")
                self.steps.append(self.rules[rule](step, self))
        require(len(set(map(digest_of, items(claims)))) == len(claims), "a claim is made twice")
        for i, claim in enumerate(claims):
            with within(f"claim {i}"):
                self.spend(64)
                kind = claim.get("claim") if isinstance(claim, dict) else None
                require(kind in tuple(self.claims), f"there is no claim {kind!r}")
                said, shown = self.claims[kind](self, claim)
                self.said.append(f"{kind}: {said}")
                self.shown.append(shown)
        require(bool(claims), "nothing is claimed")
        require(len(self.used) == len(self.steps), "a step is not used")
        return self.said


def add_sum(proof: Proof, claim: Json) -> tuple[str, Region]:
    """The sum at a scale, by its digest, and by its canonical form if that is given."""
    names = "claim scale step components holes digest polygons?"
    scale, step, *counts, digest, polygons = members(claim, names)[1:]
    region = proof.region(step, scale)
    demand(region.counts == [*map(integer, counts)], "components or holes are others")
    form = plain(region.polygons)
    demand(digest_of(form) == digest, "the digest is another")
    demand(polygons in (None, form["polygons"]), "the polygons are others")
    return f"at {scale}, {counts[0]} components, {counts[1]} holes, {digest}", region


def of_the_plane(case: Json, digest: Json, steps: Json, claims: Json, budget: Budget) -> list[str]:
    P, Q = (Operand(case.get(operand), operand) for operand in "PQ")
    demand(digest_of({"P": P.plain, "Q": Q.plain}) == digest, "not the case that is certified")
    return Proof(P, Q, budget).follow(steps, claims)


Proof.claims["sum"] = add_sum
FORMS["certificate-v1"] = "steps", of_the_plane
