

# Part 3b: lists in the plane that are complete. Needs parts 2 and 3.


def add_events(proof: Proof, claim: Json) -> tuple[str, None]:
    """All events of the boundary between two scales: intervals without any, and events where they
    meet."""
    names = "claim from to intervals events scales kinds components holes"
    a, b, through, claims, scales, kinds, *counts = members(claim, names)[1:]
    intervals = [seen(proof, i, list) for i in items(through)]
    events = [seen(proof, i, tuple) for i in items(claims)]
    require(len(intervals) == len(events) + 1, "intervals, and events between")
    joints = [s for s, _ in events]
    starts, ends = zip(*((x[0].scales[0], x[-1].scales[1]) for x in intervals), strict=True)
    meet = [scale_of(a), *joints] == [*starts] and [*joints, scale_of(b)] == [*ends]
    demand(meet, "the intervals do not reach end to end, with events between")
    listed = [*map(scale_of, items(scales, len(events)))]
    demand(listed == joints, "the events are at other scales")
    same = items(kinds, len(events)) == [kind for _, kind in events]
    demand(same, "an event is of the other kind")
    for n, given in enumerate(counts):
        found = [interval[0].counts[n] for interval in intervals]
        demand([*map(integer, items(given, len(found)))] == found, "components or holes are others")
    told = ", ".join(f"{kind} at {s}" for s, kind in events) or "none"
    return f"from {a} to {b}, without both, all of the boundary: {told}", None


def places_between(region: Region) -> dict[tuple[int, ...], list[list[Json]]]:
    """The sides between two covered cells, without their ends, and the points around which all
    cells are covered; each with the nodes that cover these cells."""
    nodes: dict[tuple[int, ...], list[list[Json]]] = defaultdict(list)
    outer = set()
    for (u, v), cell in region.owner.items():
        other = region.owner.get((v, u))
        if cell in region.inside and other in region.inside:
            for place in ((min(u, v), max(u, v)), (u,), (v,)):
                nodes[place].append(region.inside[cell])
        else:
            outer |= {(min(u, v), max(u, v)), (u,), (v,)}
    return {place: nodes[place] for place in sorted(nodes.keys() - outer)}


def is_in_open_sums(region: Region, place: tuple[int, ...], nodes: list[list[Json]]) -> bool:
    """Whether the insides of these sums of two solids hold a point, or together a segment without
    its ends. A part of it in one of them is open: t from 0 to 1, between two values."""
    ends = [region.points[place[0]][0], region.points[place[-1]][0]]
    parts = []
    for A, B in sorted({(A, B) for A, B in nodes}):
        low, high = Fraction(0), Fraction(1)
        for a, b in [*edges_of(region.P.hulls[A]), *edges_of(region.Q.hulls[B])]:
            region.proof.spend(len(place))
            normal = b[1] - a[1], a[0] - b[0]
            most, unit = region.most(0, A, B, normal), region.scales[0].denominator
            s, t = (most - Fraction(unit * dot(normal, end), end[2]) for end in ends)
            if s <= 0 and t <= 0:
                low = high
            elif s < 0:
                low = max(low, s / (s - t))
            elif t < 0:
                high = min(high, s / (s - t))
        if low < high:
            parts.append((low, high))
    reach = Fraction(0)
    for low, high in sorted(parts):
        reach = max(reach, high) if low < reach or low == 0 else reach
    return reach == 1


def add_passages(proof: Proof, claim: Json) -> tuple[str, None]:
    """All points inside the sum that the sum of the interiors misses are on these passages."""
    scale, step, passages, inner = members(claim, "claim scale step passages inner")[1:]
    region = proof.region(step, scale)
    thin = region.P.operand.thin or region.Q.operand.thin
    require(not thin, "passages of a point or a segment are not proven by contacts")
    listed = [seen(proof, i, dict) for i in items(passages)]
    require(all(of is region for found in listed for of in found.values()), "of another step")
    require(len(set(passages)) == len(listed), "a passage is listed twice")
    contacts = {tuple(sorted(contact)) for found in listed for contact in found}
    contacts |= {(point,) for contact in contacts for point in contact}
    places = places_between(region)
    left = {p for p in places.keys() - contacts if not is_in_open_sums(region, p, places[p])}
    for ids, nodes in (items(entry, 2) for entry in items(inner)):
        place = tuple(sorted(region.point(i) for i in items(ids)))
        require(place in left, f"{ids} is between no cells, or shown already")
        left.remove(place)
        for pair in items(nodes):
            A, B = items(pair, 2)
            A, B = index(A, len(region.P.hulls)), index(B, len(region.Q.hulls))
            demand(region.P.solid[A] and region.Q.solid[B], f"{A} or {B} is not convex")
        demand(is_in_open_sums(region, place, nodes), f"{ids} is not inside these sums")
    demand(not left, f"{sorted(left)[:3]} are on no passage that is listed")
    return f"{len(listed)} at {scale}, and no others", None


Proof.claims.update(events=add_events, passages=add_passages)
