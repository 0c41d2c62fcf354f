"""Lies about cells and nodes of sums in the plane; all figures agree."""

from __future__ import annotations

from fractions import Fraction

from minkref.reports.evidence.certificates.forged.figures import (
    Figure,
    area,
    classes,
    edges,
    elements,
    told,
)
from minkref.reports.evidence.certificates.forged.ideas import (
    FALSE,
    PLANE,
    UNPROVED,
    Maker,
    Unfit,
    idea,
    sha,
)
from minkref.reports.evidence.certificates.forged.raw import Json, Raw

SUMS = ("filled", "ell", "hull", "two", "tight", "axes", "middle", "islands")
EMPTY = sha('{"polygons":[]}')


def sum_step(certificate: Json) -> tuple[Json, Json]:
    """The first claim `sum`, and the step."""
    claim = next((c for c in certificate["claims"] if c["claim"] == "sum"), None)
    if claim is None:
        raise Unfit
    return claim, certificate["steps"][claim["step"]]


def only_sum(certificate: Json) -> None:
    certificate["claims"] = [c for c in certificate["claims"] if c["claim"] == "sum"]
    for step in certificate["steps"]:
        if "contacts" in step:
            step["contacts"] = []


def told_again(raw: Raw, certificate: Json) -> Figure:
    """Gives claim and step the figures from the changed cells. Raises Unfit if they are true."""
    claim, step = sum_step(certificate)
    truth = claim["digest"]
    figure = told(step, raw.case, certificate.get("axes", ("1", "1")), claim["scale"])
    step["polygons"] = figure.polygons
    claim.update(components=figure.components, holes=figure.holes, digest=figure.digest)
    claim.pop("polygons", None)
    if figure.digest == truth:
        raise Unfit
    return figure


def flipped(raw: Raw, maker: Maker, was: str, proof: Json, least: int = 1) -> Json:
    """Some cells that are `was` get a proof of the other kind."""
    certificate = raw.copy()
    only_sum(certificate)
    _, step = sum_step(certificate)
    if was == "sep":
        parted(raw, certificate)
    found = [c for c, each in enumerate(step["proofs"]) if each[0] == was]
    if was == "sep":
        found = [c for c in found if not on_a_wall(step, c)]
    for c in maker.dice.sample(found, min(len(found), maker.dice.randint(least, least + 1))):
        step["proofs"][c] = proof(step, c)
    told_again(raw, certificate)
    return certificate


def on_a_wall(step: Json, c: int) -> bool:
    owned = {edge for cell in step["cells"] for edge in edges(cell)}
    return any(edge[::-1] not in owned for edge in edges(step["cells"][c]))


def parted(raw: Raw, certificate: Json) -> None:
    """Cuts corners off the cells apart from the sum, so that some have no edge on a wall."""
    claim, step = sum_step(certificate)
    axes = certificate.get("axes", ("1", "1"))
    points: list[Json] = elements(step, raw.case, axes, Fraction(claim["scale"]))
    owned = {edge for cell in step["cells"] for edge in edges(cell)}
    for c, cell in enumerate(list(step["cells"])):
        for k in range(len(cell)):
            a, b, d = cell[k - 2], cell[k - 1], cell[k]
            if step["proofs"][c][0] == "cov" or len(cell) < 4 or not {(b, a), (d, b)} <= owned:
                continue
            if area([points[i] for i in (a, b, d)]) > 0:
                step["cells"][c] = [i for i in cell if i != b]
                step["cells"].append([a, b, d])
                step["proofs"].append(step["proofs"][c])
                break


def last(certificate: Json, which: int) -> int:
    """The last node of P (0) or Q (1)."""
    _, step = sum_step(certificate)
    pieces = certificate["steps"][step["by"][which]]
    return len(pieces["pieces"]) + len(pieces["groups"]) - 1


@idea(FALSE, *PLANE, raws=SUMS)
def cells_outside_called_covered(raw: Raw, maker: Maker) -> Json:
    """A cell apart from the sum gets the proof of a cell within the sum: the claimed set has an
    area more than the sum."""

    def stolen(step: Json, _: int) -> Json:
        return maker.pick([proof for proof in step["proofs"] if proof[0] == "cov"])

    return flipped(raw, maker, "sep", stolen)


@idea(FALSE, *PLANE, raws=SUMS)
def cells_covered_by_last_nodes(raw: Raw, maker: Maker) -> Json:
    """The hulls of P and Q taken as solid: outside cells within the sum of both hulls called
    covered."""
    nodes = [last(raw.certificate, 0), last(raw.certificate, 1)]
    return flipped(raw, maker, "sep", lambda step, _: ["cov", *nodes])


@idea(FALSE, *PLANE, raws=("filled", "middle"))
def hole_filled(raw: Raw, maker: Maker) -> Json:
    """All the hole's cells covered, says the certificate, with the hull of a whole operand;
    digest, components and holes match the filled sum."""
    certificate = raw.copy()
    only_sum(certificate)
    _, step = sum_step(certificate)
    owner = {edge: c for c, cell in enumerate(step["cells"]) for edge in edges(cell)}
    covered = [proof[0] == "cov" for proof in step["proofs"]]
    gaps = classes(step["cells"], owner, covered, False)
    open_ = {gaps[c] for edge, c in owner.items() if edge[::-1] not in owner and c in gaps}
    inner = [c for c, gap in gaps.items() if gap not in open_]
    if not inner:
        raise Unfit
    nodes = [last(certificate, 0), last(certificate, 1)]
    for c in inner:
        step["proofs"][c] = ["cov", *(nodes if maker.dice.random() < 0.5 else [0, 0])]
    told_again(raw, certificate)
    return certificate


@idea(FALSE, *PLANE, raws=SUMS)
def cells_in_the_sum_carved_out(raw: Raw, maker: Maker) -> Json:
    """A cell within the sum gets the code of a cell apart from it: the claimed set lacks an
    area."""

    def stolen(step: Json, _: int) -> Json:
        return maker.pick([proof for proof in step["proofs"] if proof[0] == "sep"])

    return flipped(raw, maker, "cov", stolen)


@idea(FALSE, *PLANE, raws=SUMS)
def members_of_pieces_that_are_none(raw: Raw, maker: Maker) -> Json:
    """A cell within the sum called apart, with a code that takes each piece apart into members.
    A piece has none, so a careless stack would stand empty with nothing shown."""
    certificate = raw.copy()
    only_sum(certificate)
    _, step = sum_step(certificate)
    P = certificate["steps"][step["by"][0]]
    number = len(P["pieces"]) + len(P["groups"])
    found = [c for c, proof in enumerate(step["proofs"]) if proof[0] == "cov"]
    for c in maker.dice.sample(found, maker.dice.randint(1, 2)):
        step["proofs"][c] = ["sep", *[-1] * number]
    told_again(raw, certificate)
    return certificate


@idea(FALSE, *PLANE, raws=SUMS)
def code_that_ends_early(raw: Raw, maker: Maker) -> Json:
    """A cell within the sum called apart with an empty code, or with one that leaves pairs over."""
    code = maker.dice.choice([[], [-1], [-2], [-1, -2]])
    return flipped(raw, maker, "cov", lambda step, _: ["sep", *code])


@idea(FALSE, *PLANE, raws=SUMS)
def normal_of_no_direction(raw: Raw, maker: Maker) -> Json:
    """The normal (0, 0) would separate anything weakly: 0 >= 0. It carves cells out of the sum."""
    certificate = raw.copy()
    only_sum(certificate)
    _, step = sum_step(certificate)
    step["normals"].append(maker.dice.choice([[0, 0], ["0", "0"], [0, "-0"], [False, False]]))
    found = [c for c, proof in enumerate(step["proofs"]) if proof[0] == "cov"]
    step["proofs"][maker.dice.choice(found)] = ["sep", len(step["normals"]) - 1]
    told_again(raw, certificate)
    return certificate


@idea(FALSE, *PLANE, raws=SUMS)
def cell_twice_and_another_missing(raw: Raw, maker: Maker) -> Json:
    """A cell within the sum listed twice instead of a cell apart: areas may agree, the plane is
    not tiled."""
    certificate = raw.copy()
    only_sum(certificate)
    claim, step = sum_step(certificate)
    inside = [c for c, proof in enumerate(step["proofs"]) if proof[0] == "cov"]
    outside = [c for c, proof in enumerate(step["proofs"]) if proof[0] == "sep"]
    c, d = maker.dice.choice(inside), maker.dice.choice(outside)
    turn = maker.dice.randrange(len(step["cells"][c]))
    step["cells"][d] = step["cells"][c][turn:] + step["cells"][c][:turn]
    step["proofs"][d] = step["proofs"][c]
    claim.update(digest=sha(str(maker.dice.random())))
    return certificate


@idea(UNPROVED, *PLANE, raws=SUMS)
def cell_left_out(raw: Raw, maker: Maker) -> Json:
    """A cell missing, with the proof: part of the box has no verdict. The claim stays true."""
    certificate = raw.copy()
    _, step = sum_step(certificate)
    c = maker.dice.randrange(len(step["cells"]))
    del step["cells"][c], step["proofs"][c]
    return certificate


@idea(FALSE, *PLANE, raws=SUMS)
def covered_cell_left_out(raw: Raw, maker: Maker) -> Json:
    """A cell within the sum lacks, and the rings run along the gap: so the claimed set lacks the
    cell."""
    certificate = raw.copy()
    only_sum(certificate)
    _, step = sum_step(certificate)
    c = maker.pick([c for c, proof in enumerate(step["proofs"]) if proof[0] == "cov"])
    step["proofs"][c] = ["sep"]
    told_again(raw, certificate)
    del step["cells"][c], step["proofs"][c]
    return certificate


@idea(UNPROVED, *PLANE, raws=SUMS)
def cell_and_its_mirror(raw: Raw, maker: Maker) -> Json:
    """A cell added twice, once each way round: the edges cancel, and neither may be there."""
    certificate = raw.copy()
    _, step = sum_step(certificate)
    c = maker.dice.randrange(len(step["cells"]))
    step["cells"] += [step["cells"][c], step["cells"][c][::-1]]
    step["proofs"] += [step["proofs"][c], step["proofs"][c]]
    return certificate


@idea(UNPROVED, *PLANE, raws=SUMS)
def cell_walked_twice(raw: Raw, maker: Maker) -> Json:
    """A cell's ring is walked twice, and so turns twice around."""
    certificate = raw.copy()
    _, step = sum_step(certificate)
    c = maker.dice.randrange(len(step["cells"]))
    step["cells"][c] = step["cells"][c] * 2
    return certificate


@idea(FALSE, *PLANE, raws=SUMS)
def cell_grown_over_its_neighbour(raw: Raw, maker: Maker) -> Json:
    """A covered cell takes a corner of a cell beside it, and that cell loses the corner: what
    one gains is just what the other lacks, if the new corner makes both convex at all."""
    certificate = raw.copy()
    only_sum(certificate)
    claim, step = sum_step(certificate)
    cells = step["cells"]
    pairs = [(c, d, e) for c in range(len(cells)) for d in range(len(cells)) if c != d
             for e in edges(cells[d])[:1] if len(cells[d]) > 3
             and step["proofs"][c][0] == "cov" and step["proofs"][d][0] == "sep"]  # fmt: skip
    c, d, edge = maker.pick(pairs)
    spot = maker.dice.randrange(len(cells[c]))
    cells[c] = [*cells[c][:spot], edge[0], *cells[c][spot:]]
    cells[d] = [i for i in cells[d] if i != edge[0]]
    claim.update(digest=sha(str(maker.dice.random())))
    return certificate


@idea(FALSE, *PLANE, raws=SUMS)
def area_of_doubled_cells(raw: Raw, maker: Maker) -> Json:
    """Two neighbours become a single cell, though only one belongs to the sum."""
    certificate = raw.copy()
    only_sum(certificate)
    _, step = sum_step(certificate)
    parted(raw, certificate)
    cells, proofs = step["cells"], step["proofs"]
    owner = {edge: c for c, cell in enumerate(cells) for edge in edges(cell)}
    shared = [(e, c, owner[e[::-1]]) for e, c in owner.items() if e[::-1] in owner
              and proofs[c][0] == "cov" and proofs[owner[e[::-1]]][0] == "sep"
              and not on_a_wall(step, owner[e[::-1]])]  # fmt: skip
    (a, b), c, d = maker.pick(shared)
    here, there = cells[c].index(b), cells[d].index(a)
    around = cells[c][here:] + cells[c][:here], cells[d][there:] + cells[d][:there]
    cells[c] = around[0] + around[1][1:-1]
    del cells[d], proofs[d]
    told_again(raw, certificate)
    return certificate
