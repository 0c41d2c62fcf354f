"""Lies about claims in the plane: scales and cases, events without a change, passages. All
steps hold wherever a lie leaves them so."""

from __future__ import annotations

from fractions import Fraction

from minkref.reports.evidence.certificates.forged.figures import elements, told
from minkref.reports.evidence.certificates.forged.ideas import (
    FALSE,
    PLANE,
    Forgery,
    Maker,
    Unfit,
    case_digest,
    idea,
    sha,
    tight,
)
from minkref.reports.evidence.certificates.forged.plane_steps import SUMS, only_sum, sum_step
from minkref.reports.evidence.certificates.forged.raw import Json, Raw

INTERVALS = ("still", "later", "topology")


@idea(FALSE, *PLANE, raws=SUMS)
def digest_of_another_case(raw: Raw, maker: Maker) -> Json:
    """The digest, and perhaps the counts, true of another sum."""
    certificate = raw.copy()
    claim, _ = sum_step(certificate)
    other, _ = sum_step(maker.another(raw, *SUMS).certificate)
    if other["digest"] == claim["digest"]:
        raise Unfit
    claim["digest"] = other["digest"]
    if maker.dice.random() < 0.5:
        claim.update(components=other["components"], holes=other["holes"])
    return certificate


@idea(FALSE, *PLANE, raws=SUMS)
def derivation_of_another_case(raw: Raw, maker: Maker) -> Forgery:
    """Steps and claims from another case below this case's path and digest. Where both sums
    differ the claim fails."""
    certificate = raw.copy()
    other = maker.another(raw, *SUMS)
    mine, _ = sum_step(certificate)
    theirs, _ = sum_step(other.certificate)
    same_case = certificate["case"]["sha256"] == other.certificate["case"]["sha256"]
    if same_case or mine["digest"] == theirs["digest"]:  # of one case at two scales both are true
        raise Unfit
    certificate.update(steps=other.copy()["steps"], claims=other.copy()["claims"])
    ways = [(raw.case, certificate["case"]["sha256"]),
            (other.case, certificate["case"]["sha256"]),
            (raw.case, other.certificate["case"]["sha256"])]  # fmt: skip
    case, certificate["case"]["sha256"] = maker.dice.choice(ways)
    return Forgery(tight(certificate), tight(case))


@idea(FALSE, *PLANE, raws=SUMS)
def claims_of_another_case(raw: Raw, maker: Maker) -> Json:
    """Claims from another case, with this case's steps."""
    certificate = raw.copy()
    other = maker.another(raw, *SUMS, "topology", "signs", "inside")
    certificate["claims"] = other.copy()["claims"]
    if sum_step(raw.copy())[0]["digest"] in [c.get("digest") for c in certificate["claims"]]:
        raise Unfit
    return certificate


@idea(FALSE, *PLANE, raws=("ell", "filled", "axes", "tight"))
def operands_exchanged(raw: Raw, maker: Maker) -> Forgery:
    """The case with P and Q exchanged, and the digest for that case: another sum unless s is 1."""
    certificate, case = raw.copy(), raw.copied_case()
    claim, _ = sum_step(certificate)
    if claim["scale"] == "1" and raw.form == PLANE[0]:
        raise Unfit
    case["P"], case["Q"] = case["Q"], case["P"]
    certificate["case"]["sha256"] = case_digest(case, raw.form)
    for step in certificate["steps"]:
        if maker.dice.random() < 0.5 and step["rule"] == "pieces":
            step["of"] = "Q" if step["of"] == "P" else "P"
    return Forgery(tight(certificate), tight(case))


@idea(FALSE, *PLANE, raws=SUMS)
def another_scale(raw: Raw, maker: Maker) -> Json:
    """The claim's scale changed, or the scale of claim and step: the digest belongs to a single
    scale."""
    certificate = raw.copy()
    only_sum(certificate)
    claim, step = sum_step(certificate)
    change = Fraction(maker.dice.randint(1, 10**6), 10**9) * maker.dice.choice([-1, 1])
    new = str(Fraction(claim["scale"]) * (1 + change))
    claim["scale"] = new
    if maker.dice.random() < 0.7:
        step["scales"] = [new]
    return certificate


@idea(FALSE, *PLANE, raws=SUMS)
def counts_changed(raw: Raw, maker: Maker) -> Json:
    """Components and holes exchanged, or a further component and a hole less; the digest stays."""
    certificate = raw.copy()
    claim, _ = sum_step(certificate)
    was = claim["components"], claim["holes"]
    new = maker.dice.choice([was[::-1], (was[0] + 1, was[1] - 1), (was[0], was[1] + 1),
                             (was[0] - 1, was[1] + 1), (was[0] + 2**64, was[1])])  # fmt: skip
    if new == was:
        raise Unfit
    claim["components"], claim["holes"] = new
    return certificate


@idea(FALSE, *PLANE, raws=(*SUMS, "line", "place"))
def digest_of_another_writing(raw: Raw, maker: Maker) -> Json:
    """The SHA-256 of the right set, not in canonical form: rings turned or begun elsewhere,
    fractions not in lowest terms, spaces, a straight vertex."""
    certificate = raw.copy()
    claim, step = sum_step(certificate)
    form = told(step, raw.case, raw.certificate.get("axes", ("1", "1")), claim["scale"]).form
    first = form["polygons"][0]["outer"]
    way = maker.dice.randrange(6)
    if way == 0:
        first.append(first.pop(0))
    elif way == 1:
        first.reverse()
    elif way == 2:
        x = Fraction(first[0][0])
        first[0][0] = f"{2 * x.numerator}/{2 * x.denominator}"
    elif way == 3:
        middle = [(Fraction(a) + Fraction(b)) / 2 for a, b in zip(first[0], first[1], strict=True)]
        first.insert(1, [str(value) for value in middle])
    text = str(form).replace("'", '"') if way == 4 else tight(form)
    if way == 5:
        text += "\n"
    claim["digest"] = sha(text)
    if maker.dice.random() < 0.3 and way < 4:
        claim["polygons"] = form["polygons"]
    return certificate


@idea(FALSE, *PLANE, raws=SUMS)
def polygons_beside_a_true_digest(raw: Raw, maker: Maker) -> Json:
    """The claim's `polygons` do not match the digest: a vertex elsewhere, a ring missing, or
    nothing at all."""
    certificate = raw.copy()
    claim, step = sum_step(certificate)
    form = told(step, raw.case, raw.certificate.get("axes", ("1", "1")), claim["scale"]).form
    polygons = form["polygons"]
    way = maker.dice.randrange(4)
    if way == 0:
        polygons = []
    elif way == 1:
        vertex = maker.dice.choice(polygons[0]["outer"])
        vertex[0] = str(Fraction(vertex[0]) + Fraction(1, 10 ** maker.dice.randint(0, 30)))
    elif way == 2:
        polygons.append(polygons[0])
    else:
        polygons[0]["outer"].pop()
    claim["polygons"] = polygons
    return certificate


@idea(FALSE, PLANE[0], raws=("still", "later", "topology"))
def interval_beyond_an_event(raw: Raw, maker: Maker) -> Json:
    """A move, and the claim, go on beyond the scale at which the hole shuts, or begin before.
    The box grows with them."""
    certificate = raw.copy()
    claim = next(c for c in certificate["claims"] if c["claim"] == "interval")
    step = certificate["steps"][claim["steps"][0]]
    end = Fraction(claim["to"]) * maker.pick([3, 5, 10**6, Fraction(9, 4)])
    claim["to"] = step["scales"][1] = str(end)
    room = str(10 * end + 1000)
    step["box"] = [f"-{room}", f"-{room}", room, room]
    certificate["claims"] = [claim]
    certificate["steps"] = [certificate["steps"][n] for n in (0, 1)] + [step]
    claim["steps"] = [2]
    return certificate


@idea(FALSE, PLANE[0], raws=("topology",))
def interval_through_an_event(raw: Raw, maker: Maker) -> Json:
    """Both intervals of an event as a single claim: moves and sum between hold, but the figures
    differ. The claim has either digest and counts."""
    certificate = raw.copy()
    first, _, second, _ = certificate["claims"]
    chosen = maker.dice.choice([first, second])
    steps = maker.dice.choice([[2, 3, 4], [2, 4], [2, 3], [3, 4], [4, 3, 2]])
    claim = {**chosen, "from": first["from"], "to": second["to"], "steps": steps}
    certificate["claims"] = [claim]
    if 3 not in steps:
        del certificate["steps"][3]
        claim["steps"] = [2, 3]
    return certificate


@idea(FALSE, PLANE[0], raws=("still",))
def event_where_nothing_happens(raw: Raw, maker: Maker) -> Json:
    """Two true intervals without an event, with the true sum between, and the false claim that
    the boundary, or the topology, changes there."""
    names = {"middle": None, "later": None}
    turn = raw.name.removeprefix("still")
    for other in maker.raws:
        for name in names:
            if other.name == name + turn:
                names[name] = other.copy()
    middle, later = names["middle"], names["later"]
    if middle is None or later is None:
        raise Unfit
    certificate = raw.copy()
    for more in (middle, later):
        base = len(certificate["steps"])
        for step in more["steps"]:
            if "by" in step:
                step["by"] = [base + n for n in step["by"]]
        certificate["steps"] += more["steps"]
        for claim in more["claims"]:
            if "step" in claim:
                claim["step"] += base
            else:
                claim["steps"] = [base + n for n in claim["steps"]]
        certificate["claims"] += more["claims"]
    certificate["claims"].append({
        "claim": "event", "scale": middle["claims"][0]["scale"],
        "kind": maker.dice.choice(["boundary", "topology"]), "before": 0, "at": 1, "after": 2,
    })  # fmt: skip
    if maker.dice.random() < 0.3:
        certificate["claims"][-1].update(kind="topology", before=0, at=1, after=0)
    return certificate


@idea(FALSE, PLANE[0], raws=("topology",))
def event_with_other_parts(raw: Raw, maker: Maker) -> Json:
    """The event's parts exchanged, a part twice, from another kind, later, or itself; or the
    scale differs from the one between."""
    certificate = raw.copy()
    event = certificate["claims"][3]
    way = maker.dice.randrange(3)
    if way == 0:
        event["scale"] = str(Fraction(event["scale"]) * Fraction(maker.dice.randint(2, 99), 100))
    elif way == 1:
        event.update(zip(("before", "at", "after"), maker.dice.choice(
            [(2, 1, 0), (0, 1, 0), (2, 1, 2), (0, 0, 2), (1, 1, 1), (0, 1, 3), (0, 2, 1)]),
            strict=True))  # fmt: skip
    else:
        event[maker.dice.choice(["before", "at", "after"])] = maker.dice.choice(
            [3, 4, -1, -3, True]
        )
    return certificate


@idea(FALSE, PLANE[0], raws=INTERVALS)
def window_turned(raw: Raw, maker: Maker) -> Json:
    """A move's scales, and the claim's, from the greater to the smaller, or both the same, or
    from zero or below."""
    certificate = raw.copy()
    claim = next(c for c in certificate["claims"] if c["claim"] == "interval")
    step = certificate["steps"][claim["steps"][0]]
    low, high = claim["from"], claim["to"]
    new = maker.dice.choice([(high, low), (high, high), (low, low), ("0", high), (f"-{high}", high),
                             (f"-{high}", f"-{low}"), ("0", "0")])  # fmt: skip
    claim["from"], claim["to"] = step["scales"] = list(new)
    certificate["claims"] = [claim]
    certificate["steps"] = [*certificate["steps"][:2], step]
    claim["steps"] = [2]
    return certificate


@idea(FALSE, *PLANE, raws=("tight",))
def passage_elsewhere(raw: Raw, maker: Maker) -> Json:
    """A contact, with the old code, at another point: on the boundary, outside, or well inside
    the sum of the interiors. The claim names that point."""
    certificate = raw.copy()
    claim = next((c for c in certificate["claims"] if c["claim"] == "passage"), None)
    if claim is None:
        raise Unfit
    step = certificate["steps"][claim["step"]]
    points = elements(step, raw.case, ("1", "1"), Fraction(step["scales"][0]))
    used = {i for cell in step["cells"] for i in cell} - set(claim["path"])
    new = maker.dice.choice(sorted(used))
    step["contacts"] = [[[new], *step["contacts"][0][1:]]]
    claim.update(path=[new], points=[[str(value) for value in points[new]]])
    return certificate


@idea(FALSE, *PLANE, raws=("tight",))
def passage_as_a_segment(raw: Raw, maker: Maker) -> Json:
    """A tight point becomes a segment to another point, without a contact, or with the contact's
    code."""
    certificate = raw.copy()
    claim = next((c for c in certificate["claims"] if c["claim"] == "passage"), None)
    if claim is None or len(claim["path"]) > 1:
        raise Unfit
    step = certificate["steps"][claim["step"]]
    points = elements(step, raw.case, ("1", "1"), Fraction(step["scales"][0]))
    here = claim["path"][0]
    beside = {i for cell in step["cells"] if here in cell for i in cell}
    path = [here, maker.dice.choice(sorted(beside))]
    if maker.dice.random() < 0.5:
        step["contacts"].append([sorted(set(path)), *step["contacts"][0][1:]])
    claim.update(path=path, points=[[str(value) for value in points[i]] for i in path])
    return certificate


@idea(FALSE, *PLANE, raws=("tight",))
def passage_by_empty_code(raw: Raw, maker: Maker) -> Json:
    """Contacts along a path with codes that show nothing: members of pieces, or none."""
    certificate = raw.copy()
    claim = next((c for c in certificate["claims"] if c["claim"] == "passage"), None)
    if claim is None:
        raise Unfit
    step = certificate["steps"][claim["step"]]
    inner = sorted({i for cell in step["cells"] for i in cell} - set(claim["path"]))
    new = maker.dice.choice(inner)
    point = elements(step, raw.case, ("1", "1"), Fraction(step["scales"][0]))[new]
    step["contacts"] = [[[new], *maker.dice.choice([[], [-1], [-1, -1], [-2], [-2, -2, -1]])]]
    claim.update(path=[new], points=[[str(value) for value in point]])
    return certificate
