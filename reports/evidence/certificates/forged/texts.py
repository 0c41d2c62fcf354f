"""Forgeries in a certificate's text, any form: JSON that two readers read differently, numbers
that only some languages take, values of another type, indices from the end."""

from __future__ import annotations

import gzip
import json
import re
from collections.abc import Callable
from fractions import Fraction
from typing import Any

from minkref.reports.evidence.certificates.forged.ideas import (
    ALL,
    FALSE,
    PATH,
    PLANE,
    POINTS,
    SOLID,
    UNPROVED,
    Forgery,
    Maker,
    Unfit,
    at,
    idea,
    places,
    put,
    sha,
    tight,
)
from minkref.reports.evidence.certificates.forged.raw import Json, Raw

NUMBER = re.compile(r"-?\d+(/\d+)?")
TEXTS = ("title", "comment", "producer", "sha256", "path")


def spots(value: Json, wanted: Callable[[Any], bool]) -> list[tuple[str | int, ...]]:
    """Paths of wanted values, except texts without effect."""
    return [path for path in places(value) if path[-1] not in TEXTS and wanted(at(value, path))]


def is_number(value: Json) -> bool:
    return isinstance(value, str) and bool(NUMBER.fullmatch(value))


def is_index(value: Json) -> bool:
    return type(value) is int and value >= 0


def changed(
    raw: Raw, maker: Maker, wanted: Callable[[Any], bool], new: Callable[[Any], Any]
) -> Json:
    certificate = raw.copy()
    path = maker.pick(spots(certificate, wanted))
    put(certificate, path, new(at(certificate, path)))
    return certificate


@idea(UNPROVED, *ALL)
def numbers_of_other_languages(raw: Raw, maker: Maker) -> Json:
    """A number with the same value, as Python's int or Fraction would read it and the page does
    not: other digits, underscores, spaces, a fraction of decimals."""

    def new(old: str) -> str:
        ways = [
            old.translate({ord("0") + k: 0x660 + k for k in range(10)}),
            old.translate({ord("0") + k: 0xFF10 + k for k in range(10)}),
            f" {old}", f"{old} ", f"{old}\n", f"{old}\u00a0", f"\t{old}", f"{old}\u0000",
            old.replace("-", "\u2212") if "-" in old else f"{old}_0", f"0_{old.lstrip('-')}",
            f"0x{old}", f"{old}.0/1", f"{old}/1/1", f"({old})", f"{old}j", f"--{old}", f"{old}e",
            f"{old}/0", f"{old}/-1", f"{old}/+1", f"{old}e1001", f"{old}e-9999", f"{old}e2.0", "",
            "nan", "inf", "-inf", "NaN", "1e", ".", "-", "+", "/", f"{old}d0", f"{old}L", f"{old}n",
        ]  # fmt: skip
        return str(maker.dice.choice(ways))

    return changed(raw, maker, is_number, new)


@idea(UNPROVED, *ALL)
def numbers_of_json(raw: Raw, maker: Maker) -> Json:
    """A number of another type: a float, a boolean, null, a list, an object."""

    def new(old: str) -> Any:
        value = float(Fraction(old))
        return maker.dice.choice([value, [old], {"n": old}, None, True, [], {}, value + 0.5])

    return changed(raw, maker, is_number, new)


@idea(UNPROVED, *ALL)
def zero_denominators(raw: Raw, maker: Maker) -> Json:
    """A number over zero: with it, a reader of fractions may find every comparison true."""
    ways = ["1/0", "0/0", "-1/0", "1/00", "1/-0", "0/000"]
    return changed(raw, maker, is_number, lambda _: maker.dice.choice(ways))


@idea(UNPROVED, *ALL)
def indices_that_are_none(raw: Raw, maker: Maker) -> Json:
    """An index or a count as a float, a text, a boolean, huge, or null. Normals and planes have
    no such limits, and null is a point of a sign: they are left alone."""

    def new(old: int) -> Any:
        ways: list[Any] = [float(old), str(old), None, [old], old + 2**32, old + 2**64, 10**400]
        ways += [bool(old)] if old < 2 else []
        return maker.dice.choice(ways)

    certificate = raw.copy()
    free = {"normals", "planes", "of", "normal"}
    path = maker.pick([path for path in spots(certificate, is_index) if not free & set(path)])
    put(certificate, path, new(at(certificate, path)))
    return certificate


@idea(UNPROVED, *PLANE, *PATH, *SOLID, *POINTS)
def indices_from_the_end(raw: Raw, maker: Maker) -> Json:
    """An index counted from the end, as lists of Python allow: it names the same item."""
    certificate = raw.copy()
    steps = certificate.get("steps", [])
    found: list[tuple[Json, int | str, int]] = []
    for step in steps:
        if "by" in step:
            here = steps.index(step)
            found += [(step["by"], k, here) for k in (0, 1)]
            found += [(step["by"], k, len(steps)) for k in (0, 1)]
        if step["rule"] in ("eq", "move"):
            size = len(step["elements"]) + 4
            found += [(cell, k, size) for cell in step["cells"] for k in range(len(cell))]
            found += [(ring, k, size) for rings in step["polygons"] for ring in rings
                      for k in range(len(ring))]  # fmt: skip
            nodes = [len(steps[n]["pieces"]) + len(steps[n]["groups"]) for n in step["by"]]
            found += [(proof, k + 1, nodes[k]) for proof in step["proofs"] if proof[0] == "cov"
                      for k in (0, 1)]  # fmt: skip
            found += [(element, 1, 4 + n) for n, element in enumerate(step["elements"])
                      if element[0] in ("meet", "up")]  # fmt: skip
    found += [(claim, "step", len(steps)) for claim in certificate["claims"] if "step" in claim]
    found += [(claim, name, len(certificate["claims"])) for claim in certificate["claims"]
              for name in ("before", "at", "after") if name in claim]  # fmt: skip
    proof = certificate.get("proof", {})
    for name in proof and "PQ":
        size = len(raw.case[name]["vertices"]) + len(proof[name]["points"])
        found += [(hull, k, size) for hull in proof[name]["hulls"] for k in range(len(hull))]
    items, key, size = maker.pick(found)
    items[key] -= size
    return certificate


@idea(UNPROVED, *PLANE, *PATH)
def steps_of_the_future(raw: Raw, maker: Maker) -> Json:
    """A step refers to itself or a later step; or all steps come reversed, and numbers follow."""
    certificate = raw.copy()
    steps = certificate["steps"]
    users = [step for step in steps if "by" in step]
    way = maker.dice.randrange(2)
    if way and users:
        step = maker.pick(users)
        step["by"][maker.dice.randrange(2)] = maker.dice.randrange(
            steps.index(step), len(steps) + 2
        )
        return certificate
    if len(steps) < 2:
        raise Unfit
    last = len(steps) - 1
    steps.reverse()
    for each in [*steps, *certificate["claims"]]:
        if "by" in each:
            each["by"] = [last - n for n in each["by"]]
        if "step" in each:
            each["step"] = last - each["step"]
        if each.get("claim") == "interval":
            each["steps"] = [last - n for n in each["steps"]]
    if not users:
        raise Unfit
    return certificate


@idea(UNPROVED, *ALL)
def members_of_no_page(raw: Raw, maker: Maker) -> Json:
    """A member that no page names, somewhere; or a member missing, or spelt otherwise."""
    certificate = raw.copy()
    found = [path for path in places(certificate) if isinstance(at(certificate, path), dict)]
    target = at(certificate, maker.dice.choice([(), *found]))
    names = [name for name in target if name not in TEXTS[:3]]
    name = maker.pick(names)
    way = maker.dice.randrange(4)
    if way == 0:
        target[maker.dice.choice(["", "verified", "Comment", "commеnt", "claims ", "\u0000"])] = 1
    elif way == 1:
        if name in ("polygons", "holes"):
            raise Unfit
        del target[name]
    elif way == 2:
        target[name.capitalize()] = target.pop(name)
    else:
        target[name + "\u200b"] = target.pop(name)
    return certificate


@idea(UNPROVED, *ALL)
def claims_twice_or_none(raw: Raw, maker: Maker) -> Json:
    """A claim twice, perhaps with the members reversed; or no claim at all; or claims as no
    list."""
    certificate = raw.copy()
    claims = certificate["claims"]
    claim = maker.dice.choice(claims)
    again = dict(reversed(claim.items()))
    ways: list[Json] = [
        [*claims, claim], [*claims, again], [], {}, None, [None], [[]], {"0": claim}, "claims",
        [*claims, {}], True, [*claims, {"claim": "true"}],
    ]  # fmt: skip
    certificate["claims"] = maker.dice.choice(ways)
    return certificate


@idea(UNPROVED, *ALL)
def form_of_another_name(raw: Raw, maker: Maker) -> Json:
    """The file names another form, or none, or the right form in capitals."""
    certificate = raw.copy()
    names = [*(form for form in ALL if form != raw.form), raw.form.upper(), raw.form + " ", "",
             None, 1, [raw.form], "certificate-v2", raw.form + "\u0000",
             raw.form.replace("v1", "v\uff11")]  # fmt: skip
    certificate["certificate"] = maker.dice.choice(names)
    return certificate


def false_claims(raw: Raw) -> Json:
    """A copy with a claim that is false: another digest, sign, scale or point, or of no case."""
    certificate = raw.copy()
    claim = certificate["claims"][0]
    if claim["claim"] == "outside":
        certificate["case"]["sha256"] = sha(certificate["case"]["sha256"])
    elif "digest" in claim:
        claim["digest"] = sha(claim["digest"])
    elif "sign" in claim:
        claim["sign"] = -claim["sign"] or 1
    elif "point" in claim:
        claim["point"] = [*claim["point"][:-1], "12345"]
    elif "scales" in claim:
        claim["scales"] = {"from": "0", "to": None, "from_in": False, "to_in": False}
    elif "polygons" in claim:
        claim["polygons"] = []
    else:
        claim["box"] = [["9", "9"], ["1", "0"], ["0", "1"]]
    return certificate


@idea(FALSE, *ALL)
def members_twice(raw: Raw, maker: Maker) -> Forgery:
    """A member twice, once with true claims and once with false ones, plain or escaped: readers
    differ about which they take."""
    true, false = tight(raw.certificate["claims"]), tight(false_claims(raw)["claims"])
    if true == false:
        raise Unfit
    pair = [true, false] if maker.dice.random() < 0.5 else [false, true]
    name = maker.dice.choice(['"claims"', '"cl\\u0061ims"', '"\\u0063laims"'])
    rest = {key: value for key, value in raw.certificate.items() if key != "claims"}
    if maker.dice.random() < 0.3:
        text = tight({**rest, "claims": raw.certificate["claims"]})
        case = raw.certificate["case"]
        other = tight({**case, "sha256": sha("")})
        return Forgery(f'{text[:-1]},"case":{other if pair[0] == true else tight(case)}}}')
    return Forgery(f'{tight(rest)[:-1]},"claims":{pair[0]},{name}:{pair[1]}}}')


@idea(FALSE, *ALL)
def two_certificates_in_a_file(raw: Raw, maker: Maker) -> Forgery:
    """A true certificate and a false one in a single file: in sequence, in a list, or behind a
    comment, a null character or another mark."""
    true, false = tight(raw.certificate), tight(false_claims(raw))
    first, second = (true, false) if maker.dice.random() < 0.5 else (false, true)
    between = maker.dice.choice(["", "\n", ",", "\u0000", "\x1a", " // ", "\u2028", "\x0c", "\x1e"])
    text = first + between + second
    return Forgery(f"[{text}]" if between == "," else text)


@idea(UNPROVED, *ALL)
def bytes_that_are_no_json(raw: Raw, maker: Maker) -> Forgery:
    """A byte order mark, UTF-16, Latin-1, broken or overlong UTF-8, comments, single quotes,
    NaN, leading zeros, raw control characters, commas at ends, other white space."""
    certificate = raw.copy()
    certificate["comment"] = "here"
    text = tight(certificate)
    plain = text.encode()

    def comment(new: bytes) -> bytes:
        return plain.replace(b'"here"', b'"' + new + b'"')

    ways: list[bytes] = [
        b"\xef\xbb\xbf" + plain, text.encode("utf-16"), text.encode("utf-32"), plain + b"\x00",
        comment(b"\xff"), comment(b"\xc0\xaf"), comment(b"\xed\xa0\xbd"),
        comment(b"\xf4\x90\x80\x80"),
        comment(b"\\ud83d"), comment(b"\\ud83d\\ude00"), comment(b"\\udc00"), comment(b"\n"),
        comment(b"\x00"), comment(b"\x1f"), comment(b"\\x41"), comment(b"\\'"), comment(b"\\u00"),
        comment(b"\\u00e"), comment(b"\\U0041"), plain.replace(b'"here"', b"'here'"),
        plain.replace(b'"here"', b"NaN"), plain.replace(b'"here"', b"Infinity"),
        plain.replace(b'"here"', b"007"), plain[:-1] + b",}", plain[:-1], b"\x0b" + plain,
        plain + b"\xc2\xa0", b"\xe2\x80\xaf" + plain, plain.replace(b":", b"=", 1),
        b"/**/" + plain, plain + b" #", plain[:-1] + b"}}", b"", b" ", b"null", b"[]", b"{}", b"0",
    ]  # fmt: skip
    return Forgery(maker.dice.choice(ways))


@idea(UNPROVED, *ALL)
def lists_too_long(raw: Raw, maker: Maker) -> Json:
    """A point with a coordinate more or less, a box with five numbers, a third axis: a reader
    that walks two lists side by side would not see it."""
    certificate = raw.copy()
    found = [path for path in places(certificate) if isinstance(at(certificate, path), list)
             and at(certificate, path) and all(map(is_number, at(certificate, path)))]  # fmt: skip
    target = at(certificate, maker.pick(found))
    if maker.dice.random() < 0.5:
        target.append(maker.dice.choice(["0", target[0], None]))
    else:
        target.pop()
    return certificate


@idea(UNPROVED, *ALL)
def texts_that_are_none(raw: Raw, maker: Maker) -> Json:
    """A title, comment or producer that is no text; a claim's name of another type."""
    certificate = raw.copy()
    value = maker.dice.choice([5, [], {}, True, ["title"], 0.5, {"title": "x"}])
    if maker.dice.random() < 0.8:
        certificate[maker.dice.choice(TEXTS[:3])] = value
    else:
        maker.dice.choice(certificate["claims"])["claim"] = value
    return certificate


@idea(UNPROVED, *ALL)
def nested_deep(raw: Raw, maker: Maker) -> Forgery:
    """Levels of lists or objects, more than a reader's stack has, where a comment or claim is."""
    depth = maker.dice.choice([501, 1000, 5000, 10**5, 10**6])
    left, right = maker.dice.choice([("[", "]"), ('{"a":', "}")])
    deep = left * depth + ("1" if left != "[" else "") + right * depth
    certificate = {**raw.copy(), maker.dice.choice(["comment", "claims", "case"]): "DEEP"}
    return Forgery(tight(certificate).replace('"DEEP"', deep))


@idea(UNPROVED, *ALL)
def packed(raw: Raw, maker: Maker) -> Forgery:
    """A file that gzip has compressed, malformed for a checker alone. The command unpacks a
    single member; here the claims fail, or two members come, or bytes follow or lack, or a bomb
    does."""
    good, false = tight(raw.certificate).encode(), tight(false_claims(raw)).encode()
    if good == false:
        raise Unfit
    ways = [gzip.compress(false), gzip.compress(good) + gzip.compress(b" "),
            gzip.compress(good) + b"\n", gzip.compress(good)[:-4],
            gzip.compress(good)[:-9] + b"123456789",
            gzip.compress(gzip.compress(good)), b"\x1f\x8b", b"\x1f\x8b\x08" + good,
            gzip.compress(b" " * 10**7), gzip.compress(false) + gzip.compress(good)]  # fmt: skip
    return Forgery(maker.dice.choice(ways))


@idea(FALSE, *ALL)
def lines_like_a_verdict(raw: Raw, maker: Maker) -> Forgery:
    """False claims, and line breaks with a line that says `verified`, as a title, or as the name
    of a member, a form or a claim: no reader of the output may see that line."""
    certificate = false_claims(raw)
    if certificate == raw.certificate:
        raise Unfit
    line = "\nFILE: verified\n" + maker.dice.choice(["", "\x1b[2K", "\r", "\x1b[1A\x1b[2K"])
    way = maker.dice.randrange(5)
    if way == 0:
        certificate["title"] = line
    elif way == 1:
        certificate[line] = 1
    elif way == 2:
        certificate["claims"][0]["claim"] = line
    elif way == 3:
        certificate["certificate"] = line
    else:
        certificate["case"]["path"] = line
    if maker.dice.random() < 0.5:
        return Forgery(json.dumps(certificate, ensure_ascii=False))
    return Forgery(tight(certificate))


@idea(FALSE, *ALL)
def enormous_numbers(raw: Raw, maker: Maker) -> Json:
    """A false claim, and elsewhere a number with up to 100,000 digits and more, or the greatest
    exponents: no checker may take long, or more memory than allowed."""
    certificate = false_claims(raw)
    found = [path for path in spots(certificate, is_number) if path[:2] != ("claims", 0)]
    n = maker.dice.choice([10**3, 10**4, 99_999, 100_001, 10**6])
    ways = ["9" * n, "1/" + "9" * n, "-" + "8" * n, "1e1000", "1e-1000", "0." + "0" * (n - 2) + "1",
            "7" * (n // 2) + "/" + "3" * (n // 2)]  # fmt: skip
    put(certificate, maker.pick(found), maker.dice.choice(ways))
    return certificate
