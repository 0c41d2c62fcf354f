

# Part 3: the other claims in the plane. Needs part 2.


def seen(proof: Proof, value: Json, kind: type[Kind]) -> Kind:
    found = proof.shown[index(value, len(proof.shown))]
    require(isinstance(found, kind), f"claim {value} is of another kind")
    return found  # type: ignore[no-any-return]


def form_of(region: Region, s: Fraction | None = None) -> tuple[list[Rings], list[Vertex]]:
    """The form, and the points that rings pass more than once, as often as they come again. At a
    scale between: if the boundary has the same vertices there."""
    again = sorted((Counter(region.passed) - Counter(set(region.passed))).elements())
    if s is None:
        return region.polygons, again
    moved = [[[at_scale(v, s) for v in r] for r in p] for p in region.polygons]
    return canonical_order(moved), sorted(at_scale(v, s) for v in again)


def is_within(region: Region, contact: tuple[int, ...]) -> bool:
    """Whether all cells around a point, or on both sides of an edge, are covered."""
    sides = [e for e in region.owner if contact[0] in e and contact[-1] in e]
    sides += [e[::-1] for e in sides]
    return bool(sides) and all(region.owner.get(e) in region.inside for e in sides)


def add_interval(proof: Proof, claim: Json) -> tuple[str, list[Region]]:
    """No event of the boundary between two scales: its vertices are linear in s."""
    names = "claim from to steps components holes digest"
    a, b, steps, *counts, digest = members(claim, names)[1:]
    regions = [proof.step(step, Region) for step in items(steps)]
    lengths = [len(region.scales) for region in regions]
    require(lengths == [2, *[1, 2] * (len(regions) // 2)], "moves, and scales between")
    joints = [s for region in regions[1::2] for s in region.scales * 3]
    ends = [scale_of(a), *joints, scale_of(b)]
    demand(ends == [s for r in regions for s in r.scales], "the steps do not reach end to end")
    for region in regions:
        demand(region.counts == [*map(integer, counts)], "components or holes are others")
        wanted = form_of(regions[0], None if region.scales[1:] else region.scales[0])
        demand(form_of(region) == wanted, f"the boundary changes at {region.scales[0]}")
    demand(digest_of(plain(regions[0].polygons)) == digest, "the digest is another")
    return f"from {a} to {b}, {counts[0]} components, {counts[1]} holes, {digest}", regions


def add_event(proof: Proof, claim: Json) -> tuple[str, tuple[Fraction, str]]:
    """At a scale, and just below and above it, the boundary or the topology is not the same."""
    scale, kind, before, at, after = members(claim, "claim scale kind before at after")[1:]
    require(kind in ("boundary", "topology"), f"there is no event {kind!r}")
    low, here, high = seen(proof, before, list), seen(proof, at, Region), seen(proof, after, list)
    s = scale_of(scale)
    demand(low[-1].scales[1] == here.scales[0] == high[0].scales[0] == s, "not at one scale")
    same = form_of(low[0]) == form_of(high[0]) and form_of(low[0], s) == form_of(here)
    as_many = low[0].counts == here.counts == high[0].counts
    demand(not (as_many if kind == "topology" else same), "nothing changes")
    said = f"{kind} at {scale}, no event of the boundary from {low[0].scales[0]} to it"
    return said, (s, "boundary" if as_many else "topology")


def add_point(proof: Proof, claim: Json) -> tuple[str, None]:
    """A point of the sum: s p + q, p in a piece of P and q in one of Q."""
    scale, point, p, q, steps, nodes = members(claim, "claim scale point p q by pieces")[1:]
    parts = vector(p), vector(q)
    made = tuple(scale_of(scale) * x + y for x, y in zip(*parts, strict=True))
    demand(made == vector(point), "s p + q is another point")
    at = zip("PQ", parts, items(steps, 2), items(nodes, 2), strict=True)
    for name, part, step, node in at:
        pieces = proof.step(step, Pieces)
        require(pieces.operand.name == name, f"no pieces of {name}")
        ring = pieces.hulls[index(node, pieces.children.count([]))]
        p = part[0] * proof.unit, part[1] * proof.unit, 1
        turns = (cross(direction(a, b), direction(a, p)) for a, b in edges_of(ring))
        # A piece may be a segment, or a point: the box bounds it.
        good = all(min(c) <= x <= max(c) for x, *c in zip(p, *ring, strict=True))
        demand(good and min(turns) >= 0, f"{part} is not in piece {node} of {name}")
    return f"{point} at {scale}", None


class Outside(Region):
    """A point at a scale that normals hold strictly apart from all pairs of pieces."""

    def __init__(self, proof: Proof, scale: Json, at: Json, steps: Json, normals: Json) -> None:
        self.proof, self.scales = proof, [scale_of(scale)]
        self.P, self.Q = (proof.step(value, Pieces) for value in items(steps, 2))
        require((self.P.operand.name, self.Q.operand.name) == ("P", "Q"), "`by` is not of P and Q")
        self.roots = list(itertools.product(self.P.root, self.Q.root))
        self.at = [c * proof.unit for c in vector(at)]
        self.normals = [whole_normal(vector(normal)) for normal in items(normals)]

    def least(self, end: int, corners: list[int], normal: Vector, side: int) -> int:
        """The largest integer less than the value at the point: a normal may not touch."""
        return int(-(-self.scales[end].denominator * dot(normal, self.at) // 1)) - 1


def add_outside(proof: Proof, claim: Json) -> tuple[str, None]:
    """A point that is not in the sum."""
    scale, point, steps, normals, code = members(claim, "claim scale point by normals code")[1:]
    Outside(proof, scale, point, steps, normals).check_apart([], items(code))
    return f"{point} at {scale}", None


def add_passage(proof: Proof, claim: Json) -> tuple[str, dict[tuple[int, ...], Region]]:
    """Points inside the sum, along edges of cells, that the sum of the interiors misses."""
    scale, step, points, path = members(claim, "claim scale step points path")[1:]
    region = proof.region(step, scale)
    thin = region.P.operand.thin or region.Q.operand.thin
    require(not thin, "passages of a point or a segment are not proven by contacts")
    ids = [region.point(i) for i in items(path)]
    demand([region.vertex(i) for i in ids] == list(map(vector, items(points))), "other points")
    contacts = [(ids[0],)] if len(ids) == 1 else list(itertools.pairwise(ids))
    require(bool(contacts), "a passage has no point")
    for contact in contacts:
        demand(contact in region.contacts, f"{contact} is no contact")
        demand(is_within(region, contact), f"{contact} is not inside the sum")
    return f"{points} at {scale}", dict.fromkeys(contacts, region)


def add_sign(proof: Proof, claim: Json) -> tuple[str, None]:
    """The sign of a predicate between two scales, or at one; zero at one means a root there."""
    of, a, b, sign = members(claim, "claim of from to sign")[1:]
    require(scale_of(a) <= scale_of(b), "the scales do not ascend")
    require(integer(sign) in (-1, 0, 1), "this is no sign")
    signs = signs_of(proof, of, [number(a), number(b)])
    good = signs == {0} if sign == 0 else {sign} <= signs <= {0, sign}
    demand(good, f"{of} has the signs {sorted(signs)} from {a} to {b}")
    return f"{of} has the sign {sign} from {a} to {b}", None


def signs_of(proof: Proof, predicate: Json, ends: list[Fraction]) -> set[int]:
    """Those of the Bernstein coefficients, from one scale to another, of `orientation` of three
    points s p + q (positive: they turn left), or of `concurrent`, three lines, each through two
    such points (zero: they meet in a point or are parallel). Both are linear in each point, and
    a coefficient adds up the values with so many points at the second scale."""
    name, entries = items(predicate, 2)
    require(name in ("orientation", "concurrent"), f"there is no predicate {name!r}")
    points = items(entries, 3)
    if name == "concurrent":
        points = [point for line in points for point in items(line, 2)]
    moving = [[moved(proof, point, s) for s in ends] for point in points]
    apart = len(moving) == 3 or all(moving[k] != moving[k + 1] for k in (0, 2, 4))
    require(apart, "a line has one point given twice")
    sums = [Fraction(0)] * (len(points) + 1)
    for choice in itertools.product((0, 1), repeat=len(points)):
        u, v, w, *more = (point[end] for point, end in zip(moving, choice, strict=True))
        if more:
            u, v, w = across(u, v), across(w, more[0]), across(more[1], more[2])
        sums[sum(choice)] += sum(x * y for x, y in zip(u, across(v, w), strict=True))
    return {(c > 0) - (c < 0) for c in sums}


def moved(proof: Proof, value: Json, s: Fraction) -> Triple:
    """Vertex i of sP plus vertex j of Q, null for none of it."""
    x, y = Fraction(0), Fraction(0)
    for i, name in zip(items(value, 2), "PQ", strict=True):
        if i is not None:
            at = proof.operands[name].exact[index(i, len(proof.operands[name].exact))]
            x, y = (c + (s if name == "P" else 1) * d for c, d in zip((x, y), at, strict=True))
    return x, y, Fraction(1)


def of_scaled_axes(
    case: Json, digest: Json, axes: Json, steps: Json, claims: Json, budget: Budget
) -> list[str]:
    """All that part 2 says, with P scaled by a factor for each axis first."""
    P, Q = (Operand(case.get(operand), operand) for operand in "PQ")
    demand(digest_of({"P": P.plain, "Q": Q.plain}) == digest, "not the case that is certified")
    x, y = map(scale_of, items(axes, 2))
    P.exact = [(x * a, y * b) for a, b in P.exact]
    return [f"P by {x},{y}: {line}" for line in Proof(P, Q, budget).follow(steps, claims)]


FORMS["axes-certificate-v1"] = "axes steps", of_scaled_axes
Proof.claims.update(interval=add_interval, event=add_event, point=add_point)
Proof.claims.update(outside=add_outside, passage=add_passage, sign=add_sign)
