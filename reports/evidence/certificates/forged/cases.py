"""Forgeries about the case: another file, new operands, digests of other forms."""

from __future__ import annotations

from fractions import Fraction

from minkref.reports.evidence.certificates.forged.ideas import (
    ALL,
    FALSE,
    PATH,
    PLANE,
    UNION,
    UNPROVED,
    Forgery,
    Maker,
    Unfit,
    at,
    case_digest,
    idea,
    put,
    sha,
    tight,
)
from minkref.reports.evidence.certificates.forged.raw import Json, Raw
from minkref.reports.evidence.certificates.forged.texts import false_claims, is_number, spots

FLAT = (*PLANE, *PATH)


@idea(UNPROVED, *ALL)
def case_that_is_elsewhere(raw: Raw, maker: Maker) -> Json:
    """A path that leaves the folder, or is no file: above, from the root, empty, a folder, a
    device, the certificate itself, or a name with a null character."""
    certificate = raw.copy()
    name = certificate["case"]["path"]
    ways = [
        f"../{name}", f"./../x/{name}", f"/{name}", "", ".", "..", "/", f"{name}/", f"{name}/.",
        "/dev/zero", "/dev/stdin", "/proc/self/environ", "it.cert.json", f"{name}\u0000",
        "none.json", f"x/../{name}", f"file://{name}", None, 1, [name], f"{name}\n", "~", "-",
        f"sub//..//{name}", "\\..\\x", "a" * 5000,
    ]  # fmt: skip
    certificate["case"]["path"] = maker.dice.choice(ways)
    return certificate


@idea(UNPROVED, *ALL)
def digest_of_no_case(raw: Raw, maker: Maker) -> Json:
    """Another text's digest: in capitals, shortened, from the file's bytes, from the empty text,
    or no text at all."""
    certificate = raw.copy()
    old = certificate["case"]["sha256"]
    ways = [old.upper(), old[:-1], old + "0", old[:12], "", None, 0, [old], sha(""), f" {old}",
            sha(tight(raw.case)), f"sha256:{old}", old[::-1]]  # fmt: skip
    certificate["case"]["sha256"] = maker.pick([new for new in ways if new != old])
    return certificate


@idea(FALSE, *ALL)
def case_that_was_changed(raw: Raw, maker: Maker) -> Forgery:
    """A little change to a coordinate, below the old digest: about this case nothing stands
    claimed."""
    case = raw.copied_case()
    case.pop("id", None)
    number = maker.pick(spots(case, is_number))
    new = Fraction(at(case, number)) + Fraction(1, 10 ** maker.dice.randint(0, 200))
    put(case, number, str(new))
    return Forgery(tight(raw.certificate), tight(case))


@idea(FALSE, *ALL)
def case_read_twice(raw: Raw, maker: Maker) -> Forgery:
    """The case has a member twice, the true operand and another, or two cases follow each other,
    or it is no JSON: readers differ about the sets."""
    case = raw.copied_case()
    text = tight(case)
    name = "sets" if raw.form in UNION else "R" if raw.form in PATH else "P"
    other = tight({"polygons": []}) if "polygons" in text else "{}"
    ways = [
        f'{text[:-1]},"{name}":{other}}}', f'{{"{name}":{other},{text[1:]}', text + text,
        "\ufeff" + text, text[:-1], text + "\u0000", f"[{text}]", text.replace('"', "'"),
        f'{text[:-1]},"\\u00{ord(name[0]):x}{name[1:]}":{other}}}', "", "null",
        f'{text[:-1]},"{name}":NaN}}',
    ]  # fmt: skip
    return Forgery(tight(raw.certificate), maker.dice.choice(ways))


def flat_operand(case: Json) -> Json:
    if "sets" in case:
        return case["sets"][0]
    return case.get("P") or case.get("R")


@idea(FALSE, *FLAT, raws=("ell", "tight", "axes", "topology", "path", "trap", "apart", "inside"))
def operand_of_another_kind(raw: Raw, maker: Maker) -> Forgery:
    """P now empty, a point, a segment, a ring without area or running clockwise, or a point
    beside a region. The digest matches the new case; steps and claims stay."""
    certificate, case = raw.copy(), raw.copied_case()
    operand = flat_operand(case)
    first = operand["polygons"][0]
    outer = first["outer"]
    way = maker.dice.randrange(8)
    if way == 0:
        operand["polygons"] = []
    elif way < 4:
        operand["polygons"] = [{"holes": [], "outer": outer[:way]}]
    elif way == 4:
        outer.reverse()
    elif way == 5:
        first["outer"] = [outer[0], outer[1], outer[0], outer[1]]
    elif way == 6:
        operand["polygons"].append({"holes": [], "outer": outer[:1]})
    else:
        first["outer"] = []
    if way == 3 and len(outer) == 3:
        raise Unfit
    certificate["case"]["sha256"] = case_digest(case, raw.form)
    return Forgery(tight(certificate), tight(case))


@idea(FALSE, *PLANE, raws=("ell", "tight", "axes", "inside", "apart"))
def sum_of_nothing(raw: Raw, maker: Maker) -> Forgery:
    """An operand or both empty, or both points: claims match the old sum, which was not empty."""
    certificate, case = raw.copy(), raw.copied_case()
    thin = maker.dice.choice([[], [{"holes": [], "outer": [["1", "2"]]}]])
    names = maker.dice.choice([["P", "Q"], ["P"], ["Q"]])
    for name in names:
        case[name]["polygons"] = thin
        pieces = next(s for s in certificate["steps"] if s.get("of") == name)
        pieces.update(pieces=[[0]] if thin else [], groups=[])
    certificate["case"]["sha256"] = case_digest(case, raw.form)
    if thin and len(names) == 1:
        raise Unfit
    return Forgery(tight(certificate), tight(case))


@idea(UNPROVED, *FLAT, raws=("ell", "tight", "topology"))
def vertices_in_another_order(raw: Raw, maker: Maker) -> Forgery:
    """The same sets, their rings begun elsewhere, with that case's digest: the steps' numbers
    name other vertices. Claims may be true, and are not proved."""
    certificate, case = raw.copy(), raw.copied_case()
    operand = flat_operand(case)
    ring = maker.dice.choice(operand["polygons"])["outer"]
    by = maker.dice.randrange(1, len(ring))
    ring[:] = ring[by:] + ring[:by]
    certificate["case"]["sha256"] = case_digest(case, raw.form)
    return Forgery(tight(certificate), tight(case))


@idea(FALSE, *PLANE, raws=("axes",))
def axes_left_out(raw: Raw, maker: Maker) -> Json:
    """No factors for the axes and no form's name, or factors 1, 0, negative, exchanged, three,
    or another pair: another sum, below the old digest."""
    certificate = raw.copy()
    x, y = certificate["axes"]
    way = maker.dice.randrange(9)
    if way == 0:
        del certificate["axes"]
        certificate["certificate"] = "certificate-v1"
    elif way == 1:
        certificate["certificate"] = "certificate-v1"
    elif way == 2:
        del certificate["axes"]
    else:
        more = str(Fraction(x) + Fraction(1, 10 ** maker.dice.randint(1, 60)))
        ways = [["1", "1"], [y, x], [f"-{x}", f"-{y}"], ["0", y], [x, y, "1"], [more, y]]
        certificate["axes"] = ways[way - 3]
    return certificate


@idea(FALSE, PLANE[0], raws=("ell", "hull", "two", "middle", "inside", "still"))
def axes_brought_in(raw: Raw, maker: Maker) -> Json:
    """A sum at a single scale called a sum with factors for the axes, other than 1; the digest
    stays."""
    certificate = raw.copy()
    certificate["certificate"] = PLANE[1]
    more = str(1 + Fraction(1, 10 ** maker.dice.randint(0, 60)))
    certificate["axes"] = maker.dice.choice([[more, "1"], ["1", more], [more, more]])
    if raw.name.startswith("inside"):
        certificate["claims"][0]["point"] = ["777", "777"]
    return certificate


@idea(FALSE, *ALL)
def enormous_case(raw: Raw, maker: Maker) -> Forgery:
    """An enormous or tiny coordinate, with up to 100,000 digits, below the new case's digest: a
    claim fails, or a rule of the form."""
    certificate, case = false_claims(raw), raw.copied_case()
    number = maker.pick(spots(case, is_number))
    n = maker.dice.choice([10**2, 10**3, 10**4, 99_990])
    put(case, number, maker.dice.choice(["9" * n, "1/" + "9" * n, "-" + "8" * n]))
    certificate["case"]["sha256"] = case_digest(case, raw.form)
    return Forgery(tight(certificate), tight(case))
