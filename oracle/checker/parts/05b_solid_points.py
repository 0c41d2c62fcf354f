

# Part 5b: single points and sums of solids, piece by piece. Needs part 5.

Solids = list[list[Hull]]  # the pieces of P and of Q


def scaling_of(value: Json) -> SpacePoint:
    require(min(space_vector(value)) > 0, "a factor of the scaling is not positive")
    return space_vector(value)


def product(factors: Sequence[Any], point: Sequence[Any]) -> Any:
    return tuple(a * b for a, b in zip(factors, point, strict=True))


def check_point(claim: Json, solids: Solids, unit: int, budget: Budget) -> str:
    """A point of the sum: S p + q, p in a piece of P and q in one of Q."""
    scaling, point, p, q, nodes = members(claim, "claim scaling point p q pieces")[1:]
    parts = space_vector(p), space_vector(q)
    made = zip(product(scaling_of(scaling), parts[0]), parts[1], strict=True)
    demand(space_vector(point) == tuple(a + b for a, b in made), "S p + q is another point")
    for name, part, node, pieces in zip("PQ", parts, items(nodes, 2), solids, strict=True):
        piece = pieces[index(node, len(pieces))]
        budget.spend(len(piece.facets))
        demand(piece.holds(product((unit,) * 3, part)), f"{part} is not in piece {node} of {name}")
    return f"point: {point} at {scaling}"


def check_outside(claim: Json, solids: Solids, unit: int, budget: Budget) -> str:
    """A point outside the sum: a normal for each pair of pieces holds the point apart."""
    scaling, point, normals, code = members(claim, "claim scaling point normals code")[1:]
    factors, x = scaling_of(scaling), product((unit,) * 3, space_vector(point))
    ways: Any = [tuple(map(integer, items(normal, 3))) for normal in items(normals)]
    pairs = list(itertools.product(*solids))
    numbers = indices(items(code, len(pairs)), len(ways))
    require(all(map(any, ways)) and len({*numbers}) == len(ways), "a normal is 0, or not used")
    for (A, B), n in zip(pairs, (ways[k] for k in numbers), strict=True):
        budget.spend(len(A.points) + len(B.points))
        most = A.support(product(factors, n)) + B.support(n)
        demand(dot_in_space(n, x) > most, f"normal {n} does not hold the point apart")
    return f"outside: {point} at {scaling}"


def of_points(case: Json, digest: Json, proof: Json, claims: Json, budget: Budget) -> list[str]:
    unit, _, _, solids = tiled(case, digest, members(proof, "P Q"), budget)
    kinds = {"point": check_point, "outside": check_outside}
    require(len(set(map(digest_of, items(claims)))) == len(claims) > 0, "a claim is made twice")
    said: list[str] = []
    for claim in claims:
        with within(f"claim {len(said)}"):
            budget.spend(64)
            kind = str(claim.get("claim") if isinstance(claim, dict) else None)
            require(kind in kinds, f"there is no claim {kind!r}")
            said.append(kinds[kind](claim, solids, unit, budget))
    return said


FORMS["solid-point-certificate-v1"] = "proof", of_points
