"""Lies about boxes, rings, groups and steps of sums in the plane."""

from __future__ import annotations

from fractions import Fraction

from minkref.reports.evidence.certificates.forged.figures import elements, told
from minkref.reports.evidence.certificates.forged.ideas import (
    FALSE,
    PLANE,
    UNPROVED,
    Maker,
    Unfit,
    idea,
    sha,
    tight,
)
from minkref.reports.evidence.certificates.forged.plane_steps import SUMS, only_sum, sum_step
from minkref.reports.evidence.certificates.forged.raw import Json, Raw

EMPTY = sha('{"polygons":[]}')


@idea(FALSE, *PLANE, raws=SUMS)
def box_within_the_sum(raw: Raw, maker: Maker) -> Json:
    """The box lies within the sum, a single covered cell: no boundary edge, and the claim says
    the empty set, with some number of components."""
    certificate = raw.copy()
    only_sum(certificate)
    claim, step = sum_step(certificate)
    points = elements(step, raw.case, certificate.get("axes", ("1", "1")), Fraction(claim["scale"]))
    c = maker.pick([c for c, proof in enumerate(step["proofs"]) if proof[0] == "cov"])
    corners = [points[i] for i in step["cells"][c]]
    x, y = (sum((p[k] for p in corners), Fraction(0)) / len(corners) for k in (0, 1))
    e = Fraction(1, maker.dice.randint(10**3, 10**6))
    one_cell(step, [x - e, y - e, x + e, y + e], step["proofs"][c])
    number = maker.dice.randint(0, 2)
    claim.update(components=number, holes=maker.dice.randint(0, 1), digest=EMPTY)
    return certificate


def one_cell(step: Json, box: list[Fraction], proof: Json) -> None:
    meets = [["meet", 0, 1], ["meet", 2, 1], ["meet", 2, 3], ["meet", 0, 3]]
    step.update(box=[str(value) for value in box], elements=meets, cells=[[4, 5, 6, 7]],
                proofs=[proof], contacts=[], polygons=[])  # fmt: skip


@idea(FALSE, *PLANE, raws=SUMS)
def box_beside_the_sum(raw: Raw, maker: Maker) -> Json:
    """The box lies far from the sum, a single cell that one normal holds apart: the claim is
    that the sum is empty. All conditions hold but that the box holds the sum."""
    certificate = raw.copy()
    only_sum(certificate)
    claim, step = sum_step(certificate)
    far, (a, b) = maker.dice.choice([10**3, 10**9]), maker.dice.choice([(1, 0), (0, 1), (-1, 0)])
    one_cell(step, [Fraction(far * a), Fraction(far * b), Fraction(far * a + 1),
                    Fraction(far * b + 1)], ["sep", 0])  # fmt: skip
    step["normals"] = [[a, b]]
    claim.update(components=0, holes=0, digest=EMPTY)
    return certificate


@idea(FALSE, *PLANE, raws=SUMS)
def box_cut_short(raw: Raw, maker: Maker) -> Json:
    """A wall moved into the sum, or to touch it. All cells keep their points on the wall."""
    certificate = raw.copy()
    claim, step = sum_step(certificate)
    points = elements(step, raw.case, certificate.get("axes", ("1", "1")), Fraction(claim["scale"]))
    rim = [points[i] for rings in step["polygons"] for ring in rings for i in ring]
    wall = maker.dice.randrange(4)
    values = [point[wall % 2] for point in rim]
    low, high = min(values), max(values)
    part = Fraction(maker.dice.choice([0, 1, 5]), 10)
    new = (high - (high - low) * part) if wall > 1 else (low + (high - low) * part)
    step["box"][wall] = str(new)
    claim.update(digest=sha(claim["digest"]))
    return certificate


@idea(UNPROVED, *PLANE, raws=SUMS)
def wall_that_touches(raw: Raw, maker: Maker) -> Json:
    """A wall goes to the sum's very end, where the page asks for more: cells there have no area."""
    certificate = raw.copy()
    claim, step = sum_step(certificate)
    points = elements(step, raw.case, certificate.get("axes", ("1", "1")), Fraction(claim["scale"]))
    rim = [points[i] for rings in step["polygons"] for ring in rings for i in ring]
    wall = maker.dice.randrange(4)
    values = [point[wall % 2] for point in rim]
    step["box"][wall] = str(max(values) if wall > 1 else min(values))
    return certificate


@idea(FALSE, *PLANE, raws=SUMS)
def ring_left_out(raw: Raw, maker: Maker) -> Json:
    """The step's polygons lack a ring or a polygon, and the claim's counts and digest follow."""
    certificate = raw.copy()
    only_sum(certificate)
    claim, step = sum_step(certificate)
    figure = told(step, raw.case, certificate.get("axes", ("1", "1")), claim["scale"])
    if figure.holes:
        spot = next(n for n, rings in enumerate(step["polygons"]) if len(rings) > 1)
        step["polygons"][spot].pop()
        figure.form["polygons"][spot]["holes"].pop()
        claim["holes"] -= 1
    else:
        step["polygons"].pop()
        figure.form["polygons"].pop()
        claim["components"] -= 1
    claim["digest"] = sha(tight(figure.form))
    return certificate


@idea(FALSE, *PLANE, raws=("filled", "middle", "islands"))
def hole_as_a_polygon(raw: Raw, maker: Maker) -> Json:
    """A hole's ring, perhaps turned, becomes a polygon: a component more, a hole less."""
    certificate = raw.copy()
    only_sum(certificate)
    claim, step = sum_step(certificate)
    rings = maker.pick([rings for rings in step["polygons"] if len(rings) > 1])
    hole = rings.pop()
    step["polygons"].append([hole if maker.dice.random() < 0.5 else hole[::-1]])
    claim.update(components=claim["components"] + 1, holes=claim["holes"] - 1,
                 digest=sha(tight(step["polygons"])))  # fmt: skip
    return certificate


@idea(UNPROVED, *PLANE, raws=SUMS)
def group_without_a_piece(raw: Raw, maker: Maker) -> Json:
    """The last node lacks a piece, and everything that is shown concerns the rest only."""
    certificate = raw.copy()
    pieces = maker.pick([s for s in certificate["steps"] if s.get("groups")])
    group = maker.dice.choice(pieces["groups"])
    group.remove(maker.dice.choice(group))
    return certificate


@idea(UNPROVED, *PLANE, raws=SUMS)
def group_of_nothing(raw: Raw, maker: Maker) -> Json:
    """The last node is a group without members: nothing to separate, if it is believed."""
    certificate = raw.copy()
    _, step = sum_step(certificate)
    pieces = certificate["steps"][maker.dice.choice(step["by"])]
    pieces["groups"].append([])
    return certificate


@idea(UNPROVED, *PLANE, raws=SUMS)
def group_with_itself_or_later(raw: Raw, maker: Maker) -> Json:
    """A group has itself as a member, or a later group, or a piece twice."""
    certificate = raw.copy()
    pieces = maker.pick([s for s in certificate["steps"] if s.get("groups")])
    first, n = len(pieces["pieces"]), len(pieces["groups"])
    number = maker.dice.randrange(n)
    new = maker.dice.choice([first + number, first + n, pieces["groups"][number][0]])
    pieces["groups"][number].append(new)
    return certificate


@idea(FALSE, *PLANE, raws=("touch",))
def rings_joined_at_a_touch(raw: Raw, maker: Maker) -> Json:
    """Two components that touch at a vertex become a single polygon, whose ring passes the
    vertex twice, or the second ring becomes a hole: counts and digest follow."""
    certificate = raw.copy()
    claim, step = sum_step(certificate)
    figure = told(step, raw.case, ("1", "1"), claim["scale"])
    (one,), (other,) = figure.polygons
    shared = sorted(set(one) & set(other))
    if not shared:
        raise Unfit
    v = shared[0]
    here, there = one.index(v), other.index(v)
    ring = one[here:] + one[:here] + other[there:] + other[:there]
    start = maker.dice.randrange(len(ring))
    rings = [ring[start:] + ring[:start]] if maker.dice.random() < 0.6 else [one, other]
    step["polygons"] = [rings]
    outers = [polygon["outer"] for polygon in figure.form["polygons"]]
    claim.update(components=1, holes=maker.dice.choice([0, 0, len(rings) - 1]), digest=sha(tight(
        {"polygons": [{"holes": outers[1:], "outer": outers[0]}]})))  # fmt: skip
    if maker.dice.random() < 0.5:
        step["polygons"] = [rings, []] if maker.dice.random() < 0.3 else [[r] for r in rings]
        claim["components"] = len(step["polygons"])
    if len(step["polygons"]) == 2 and len(step["polygons"][1]) == 1:
        raise Unfit
    return certificate


@idea(FALSE, *PLANE, raws=("islands",))
def hole_of_another_polygon(raw: Raw, maker: Maker) -> Json:
    """A component's hole listed with another component's polygon, and the digest matches this
    list."""
    certificate = raw.copy()
    claim, step = sum_step(certificate)
    form = told(step, raw.case, ("1", "1"), claim["scale"]).form
    polygons = step["polygons"]
    mine = maker.pick([n for n, rings in enumerate(polygons) if len(rings) > 1])
    polygons[1 - mine].append(polygons[mine].pop())
    from_ = next(p for p in form["polygons"] if p["holes"])
    to = next(p for p in form["polygons"] if not p["holes"])
    to["holes"].append(from_["holes"].pop())
    claim["digest"] = sha(tight(form))
    if maker.dice.random() < 0.5:
        polygons.reverse()
    if maker.dice.random() < 0.5:
        claim["polygons"] = form["polygons"]
    return certificate


@idea(UNPROVED, *PLANE, raws=SUMS)
def step_without_use(raw: Raw, maker: Maker) -> Json:
    """A step once more, to which nothing refers; or a claim's step follows another rule."""
    certificate = raw.copy()
    steps = certificate["steps"]
    steps.append(maker.dice.choice(steps))
    if maker.dice.random() < 0.5:
        claim, _ = sum_step(certificate)
        claim["step"] = maker.dice.choice([0, 1])
    return certificate


@idea(UNPROVED, *PLANE, raws=(*SUMS, "inside", "apart"))
def both_operands_the_same(raw: Raw, maker: Maker) -> Json:
    """`by` names an operand's pieces twice, or both operands in the wrong order."""
    certificate = raw.copy()
    found = [each for each in [*certificate["steps"], *certificate["claims"]] if "by" in each]
    each = maker.pick(found)
    each["by"] = maker.dice.choice([[0, 0], [1, 1], each["by"][::-1], [*each["by"], 0]])
    return certificate
