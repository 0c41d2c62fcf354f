"""Lies about paths and traps."""

from __future__ import annotations

from collections.abc import Sequence
from fractions import Fraction

from minkref.reports.evidence.certificates.forged.ideas import (
    FALSE,
    PATH,
    UNPROVED,
    Forgery,
    Maker,
    Unfit,
    case_digest,
    idea,
    tight,
)
from minkref.reports.evidence.certificates.forged.raw import Json, Raw

GOOD = ("free", "trapped")  # with a step `clear`


def claim_of(certificate: Json, *kinds: str) -> Json:
    claim = next((c for c in certificate["claims"] if c["claim"] in kinds), None)
    if claim is None:
        raise Unfit
    return claim


def with_step(certificate: Json) -> tuple[Json, Json]:
    claim = claim_of(certificate, *GOOD)
    return claim, certificate["steps"][claim["step"]]


def alone(certificate: Json, claim: Json) -> Json:
    """Only this claim, and the steps it needs."""
    step = claim.get("step")
    certificate["claims"] = [claim]
    keep = certificate["steps"][:2]
    if step is not None:
        keep = [*keep, certificate["steps"][step]]
        claim["step"] = 2
    certificate["steps"] = keep
    return certificate


@idea(FALSE, *PATH, raws=("path", "trap"))
def free_beyond_contact(raw: Raw, maker: Maker) -> Json:
    """Scales at which the part passes, or stays trapped, go on beyond contact, both claim and
    step, much or very little, or without end."""
    certificate = raw.copy()
    claim, step = with_step(certificate)
    end = Fraction(claim["scales"]["to"])
    e = Fraction(1, 10 ** maker.dice.randint(0, 60))
    scales = {**claim["scales"], "to": str(end + e), "to_in": maker.dice.random() < 0.5}
    if maker.dice.random() < 0.2:
        scales.update(to=None, to_in=False)
    claim["scales"], step["scales"] = scales, dict(scales)
    return alone(certificate, claim)


@idea(FALSE, *PATH, raws=("path", "trap"))
def whole_answer_beyond_contact(raw: Raw, maker: Maker) -> Json:
    """Scales grow for step, claim and summary, and shrink for the claim that follows: the whole
    answer stays coherent."""
    certificate = raw.copy()
    claim, step = with_step(certificate)
    old = Fraction(claim["scales"]["to"])
    new = str(old * Fraction(maker.dice.randint(1001, 5000), 1000))
    for c in [*certificate["claims"], step]:
        for scales in [c["scales"], *(c.get("valid") or []), *(c.get("trapped") or [])]:
            for name in ("from", "to"):
                if scales[name] is not None and Fraction(scales[name]) == old:
                    scales[name] = new
    hit = next((c for c in certificate["claims"] if c["claim"] == "hit"), None)
    if hit is not None and maker.dice.random() < 0.5:
        hit["hits"][0]["points"][0][1] = new
    return certificate


@idea(FALSE, *PATH, raws=("path", "trap", "door"))
def contact_exchanged(raw: Raw, maker: Maker) -> Json:
    """Contact allowed becomes forbidden, or reversed, everywhere: at the scale of contact the
    answer differs."""
    certificate = raw.copy()
    rule = certificate["claims"][0]["contact"]
    new = "forbidden" if rule == "allowed" else "allowed"
    for each in [*certificate["claims"], *certificate["steps"]]:
        if "contact" in each:
            each["contact"] = new
    return certificate


@idea(FALSE, *PATH, raws=("path", "trap", "door"))
def end_taken_in(raw: Raw, maker: Maker) -> Json:
    """The end of the scales, at contact, changes sides: to the claim that does not hold there."""
    certificate = raw.copy()
    for each in [*certificate["claims"], *certificate["steps"]]:
        for scales in [
            each.get("scales"),
            *(each.get("valid") or []),
            *(each.get("trapped") or []),
        ]:
            if scales and scales["to"] is not None:
                scales["to_in"] = not scales["to_in"]
            if scales and scales["from"] != "0":
                scales["from_in"] = not scales["from_in"]
    return certificate


@idea(FALSE, *PATH, raws=("path", "trap"))
def summary_that_says_more(raw: Raw, maker: Maker) -> Json:
    """`valid` or `trapped` lists scales that no claim proves: none, all, the collisions' own, or
    with an end more or less."""
    certificate = raw.copy()
    claim = claim_of(certificate, "valid", "trap")
    name = "valid" if claim["claim"] == "valid" else "trapped"
    whole, hit = dict(claim["scales"]), dict(claim_of(certificate, "hit")["scales"])
    first = dict(claim[name][0])
    half = str(Fraction(first["to"]) / 2)
    ways = [
        [], [whole], [hit], [first, hit], [first, first],
        [{**first, "to": half}], [{**first, "to_in": not first["to_in"]}],
        [{**first, "from": half}],
        [{**first, "to": half, "to_in": False}, {**first, "from": half, "from_in": True}],
    ]  # fmt: skip
    claim[name] = maker.dice.choice(ways)
    return certificate


@idea(FALSE, *PATH, raws=("path", "trap", "door"))
def summary_with_a_gap(raw: Raw, maker: Maker) -> Json:
    """The summary names a claim less, or a claim twice, or itself, or none: the scales have a
    gap."""
    certificate = raw.copy()
    claim = claim_of(certificate, "valid", "trap")
    n = len(claim["claims"])
    way = maker.dice.randrange(5)
    if way == 0:
        claim["claims"] = claim["claims"][:-1]
    elif way == 1:
        claim["claims"] = claim["claims"] + [maker.dice.randrange(n)]
    elif way == 2:
        claim["claims"] = [*claim["claims"][:-1], n]
    elif way == 3:
        claim["claims"] = []
    else:
        claim["claims"] = claim["claims"][::-1]
    return certificate


@idea(FALSE, *PATH, raws=("away", "path", "trap"))
def code_of_nothing(raw: Raw, maker: Maker) -> Json:
    """`free` at all scales of a path that collides: codes end early, take apart pieces, cut for
    ever, or hold apart with (0, 0), which with contact allowed takes the whole cell."""
    certificate = raw.copy()
    case = raw.case
    rule = certificate["claims"][0]["contact"]
    claim = claim_of(certificate, "hit")
    scales = claim["scales"]
    ways = [[], [-1], [-1, -1], [-2], [-3] * 9, [0], [0, 0], [-2, -2, -2, -2], [-2, -2, 0, 0, 0, 0]]
    code = maker.dice.choice(ways)
    normals = [maker.dice.choice([[0, 0], [1, 0], [0, -1]])] if 0 in code else []
    segments = max(1, len(case["path"]) - 1)
    step = {"rule": "clear", "by": [0, 1], "contact": rule, "path": None, "scales": scales,
            "normals": normals, "codes": [code] * segments}  # fmt: skip
    certificate["steps"] = [*certificate["steps"][:2], step]
    certificate["claims"] = [{"claim": "free", "contact": rule, "scales": scales, "step": 2}]
    return certificate


@idea(FALSE, *PATH, raws=("away", "path"))
def another_path(raw: Raw, maker: Maker) -> Json:
    """The step concerns the path's first place, or a path far away; the claim `free` concerns
    the case's path."""
    certificate = raw.copy()
    rule = certificate["claims"][0]["contact"]
    x, y = maker.dice.randint(100, 999), maker.dice.randint(-99, 99)
    path = maker.dice.choice([[[str(x), str(y)]], [[str(x), str(y)], [str(x + 2), str(y)]],
                              [[str(x), "0", str(y), "0"]], []])  # fmt: skip
    scales = {"from": "4", "to": "5", "from_in": True, "to_in": True}
    step = {"rule": "clear", "by": [0, 1], "contact": rule, "path": path, "scales": scales,
            "normals": [[1, 0]], "codes": [[0]] * max(1, len(path) - 1)}  # fmt: skip
    certificate["steps"] = [*certificate["steps"][:2], step]
    certificate["claims"] = [{"claim": "free", "contact": rule, "scales": scales, "step": 2}]
    return certificate


@idea(UNPROVED, *PATH, raws=("path", "trap", "away"))
def window_of_no_scale(raw: Raw, maker: Maker) -> Json:
    """No scale belongs to the window, or 0 or infinity does, or the ends change places."""
    certificate = raw.copy()
    ways: Sequence[Json] = [
        {"from": "1", "to": "1", "from_in": False, "to_in": True},
        {"from": "1", "to": "1", "from_in": True, "to_in": False},
        {"from": "2", "to": "1", "from_in": True, "to_in": True},
        {"from": "0", "to": "0", "from_in": True, "to_in": True},
        {"from": "0", "to": "1/9", "from_in": True, "to_in": True},
        {"from": "9", "to": None, "from_in": True, "to_in": True},
        {"from": None, "to": None, "from_in": False, "to_in": False},
        {"from": "-1", "to": "1/9", "from_in": False, "to_in": True},
        {"from": "0", "to": "1/9", "from_in": 0, "to_in": 1},
    ]
    scales = maker.dice.choice(ways)
    claim = claim_of(certificate, *GOOD, "hit")
    claim["scales"] = scales
    if "step" in claim:
        certificate["steps"][claim["step"]]["scales"] = dict(scales)
    return alone(certificate, claim)


@idea(FALSE, *PATH, raws=("trap",))
def ring_elsewhere(raw: Raw, maker: Maker) -> Json:
    """A ring that does not lead around the place: moved away, with two corners, with a single
    corner, or walked there and back."""
    certificate = raw.copy()
    claim = claim_of(certificate, "trapped")
    ring, pairs = claim["ring"], claim["pairs"]
    way = maker.dice.randrange(4)
    if way == 0:
        far = maker.dice.randint(20, 10**6)
        claim["ring"] = [[str(Fraction(a) + far), b, c, d] for a, b, c, d in ring]
    elif way == 1:
        claim.update(ring=ring[:2], pairs=[pairs[0], pairs[0]])
    elif way == 2:
        claim.update(ring=ring[:1], pairs=pairs[:1])
    else:
        claim.update(
            ring=ring + ring[::-1], pairs=[*pairs[:-1], pairs[0], *pairs[:-1][::-1], pairs[0]]
        )
    return alone(certificate, claim)


@idea(FALSE, *PATH, raws=("door",))
def trapped_behind_an_open_door(raw: Raw, maker: Maker) -> Json:
    """Scales with a way out claimed as trapped, with the ring for greater scales, or a ring
    whose edge across the door lies inside the hull of all obstacles."""
    certificate = raw.copy()
    claim = claim_of(certificate, "trapped")
    low = claim["scales"]["from"]
    if Fraction(low) == 0:
        raise Unfit
    step = certificate["steps"][claim["step"]]
    new = {**claim["scales"], "from": str(Fraction(low) / maker.dice.randint(2, 99)),
           "from_in": True}  # fmt: skip
    claim["scales"], step["scales"] = new, dict(new)
    if maker.dice.random() < 0.5:
        obstacles = certificate["steps"][1]
        last = len(obstacles["pieces"]) + len(obstacles["groups"]) - 1
        claim["pairs"] = [[pair[0], last] for pair in claim["pairs"]]
    return alone(certificate, claim)


@idea(FALSE, *PATH, raws=("door", "trap"))
def way_that_leads_nowhere(raw: Raw, maker: Maker) -> Json:
    """`escapes` of a trapped part: the way stays inside, or begins elsewhere, or jumps; the
    normal is (0, 0), or points into the obstacles."""
    certificate = raw.copy()
    claim, step = claim_of(certificate, "trapped"), None
    step = certificate["steps"][claim["step"]]
    place = raw.case["path"][0]
    far = [str(maker.dice.randint(100, 900)), place[1]]
    ways: Sequence[Json] = [
        (None, [1, 0]), ([place], [0, 0]), ([far], [1, 0]), ([place], [-1, 0]),
        ([place, far], [1, 0]),
    ]  # fmt: skip
    path, normal = maker.dice.choice(ways)
    step["path"] = path
    if path is not None and len(path) > 1:
        step["codes"] = step["codes"] * (len(path) - 1)
    new = {"claim": "escapes", "contact": claim["contact"], "scales": claim["scales"], "step": 2,
           "normal": normal}  # fmt: skip
    alone(certificate, claim)
    certificate["claims"] = [new]
    return certificate


@idea(FALSE, *PATH, raws=("door",))
def way_that_turns(raw: Raw, maker: Maker) -> Json:
    """A true way out, claimed for more scales than fit: a place moves otherwise, so that a
    segment turns or meets the door's sides."""
    certificate = raw.copy()
    claim = claim_of(certificate, "escapes")
    step = certificate["steps"][claim["step"]]
    new = {**claim["scales"], "to": str(Fraction(claim["scales"]["to"]) * 3)}
    claim["scales"], step["scales"] = new, dict(new)
    if maker.dice.random() < 0.6:
        spot = maker.dice.randrange(1, max(2, len(step["path"])))
        place = step["path"][min(spot, len(step["path"]) - 1)]
        x, y = (place[0], place[2]) if len(place) == 4 else place
        step["path"][-1] = [x, str(maker.dice.randint(-9, 9)), y, str(maker.dice.randint(-9, 9))]
    return alone(certificate, claim)


@idea(FALSE, *PATH, raws=("path", "trap", "away", "door"))
def part_and_obstacles_exchanged(raw: Raw, maker: Maker) -> Forgery:
    """R and O exchanged, with the new digest; `of` follows, or not. Now the obstacles scale."""
    certificate, case = raw.copy(), raw.copied_case()
    case["R"], case["O"] = case["O"], case["R"]
    certificate["case"]["sha256"] = case_digest(case, raw.form)
    if maker.dice.random() < 0.7:
        for step in certificate["steps"][:2]:
            step["of"] = "O" if step["of"] == "R" else "R"
        certificate["steps"][:2] = certificate["steps"][1::-1]
        way = maker.dice.randrange(2)
        for each in [*certificate["steps"][2:], *certificate["claims"]]:
            if "by" in each and way:
                each["by"] = [1, 0]
    return Forgery(tight(certificate), tight(case))


@idea(FALSE, *PATH, raws=("path", "trap"))
def path_with_a_detour(raw: Raw, maker: Maker) -> Forgery:
    """The case's path has a further place, inside the obstacles or far away, and the new digest;
    steps and claims match the shorter path."""
    certificate, case = raw.copy(), raw.copied_case()
    corner = maker.dice.choice(case["O"]["polygons"][0]["outer"])
    places = maker.dice.choice([[corner], [corner, corner], [["99", "99"]]])
    case["path"] = case["path"] + places if maker.dice.random() < 0.5 else places + case["path"]
    certificate["case"]["sha256"] = case_digest(case, raw.form)
    if maker.dice.random() < 0.5:
        for step in certificate["steps"]:
            if step["rule"] == "clear" and step["codes"]:
                step["codes"] = step["codes"] + [step["codes"][-1]] * len(places)
    return Forgery(tight(certificate), tight(case))
