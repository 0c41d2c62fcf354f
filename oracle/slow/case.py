"""Cases (`case-v1`, docs/formats.md): required and allowed members, and the operands."""

from __future__ import annotations

import re
from collections.abc import Iterator, Mapping
from fractions import Fraction

from .exact import InputError, positive
from .json_text import JsonNumber, parts
from .operand import Operand, check_members, coordinate, operand_from_json

MEMBERS = {
    "schema", "id", "title", "comment", "dimension", "P", "Q", "scales", "interval", "tags",
    "flags", "expected", "source", "licence", "certificate", "degeneracy",
}  # fmt: skip
TEXTS = ("title", "comment", "source", "licence", "certificate")
COUNTS = ("components", "holes", "vertices")
EXPECTED = {"scale", "digest", "area", "result", *COUNTS}


def is_case(value: object) -> bool:
    return isinstance(value, dict) and any(name in value for name in ("schema", "P", "Q"))


def operand_of_case(value: object, role: str) -> Operand:
    """Read an operand from a case, and check all other members too, except `degeneracy`."""
    case = members(value, "a case", MEMBERS, {"schema", "id", "dimension", "P", "Q"})
    if text(case["schema"], "schema") != "case-v1":
        raise InputError(f"{case['schema']!r} is not a version of a case")
    if not isinstance(case["dimension"], JsonNumber) or case["dimension"] != "2":
        raise InputError("the dimension of a case in the plane is 2")
    if not text(case["id"], "id"):
        raise InputError("the id is empty")
    for name in TEXTS:
        text(case.get(name, ""), name)
    if not isinstance(case.get("degeneracy", {}), dict):
        raise InputError("degeneracy is an object")
    for number in numbers([case[name] for name in case if name != "degeneracy"]):
        if not re.fullmatch("-?[0-9]+", number):
            raise InputError(f"the number {number} of a case is written as a string")
    operands = {name: operand_from_json(case[name], as_given=True) for name in "PQ"}
    check_scales(case)
    for name in ("tags", "flags"):
        for word in listed(case.get(name, []), name):
            text(word, f"each of the {name}")
    for claim in listed(case.get("expected", []), "expected"):
        check_claim(members(claim, "an expected result", EXPECTED, {"scale"}))
    return operands[role]


def check_scales(case: Mapping[str, object]) -> None:
    if ("scales" in case) == ("interval" in case):
        raise InputError("a case has either scales or an interval")
    if "scales" in case:
        scales = [factors(one) for one in listed(case["scales"], "scales")]
        if not scales:
            raise InputError("scales is empty")
        return
    ends = members(case["interval"], "an interval", {"from", "to"}, set())
    found = {name: scale(end) for name, end in ends.items()}
    if len(found) == 2 and found["from"] > found["to"]:
        raise InputError("the interval of scales ends before it begins")


def check_claim(claim: Mapping[str, object]) -> None:
    factors(claim["scale"])
    if not re.fullmatch("[0-9a-f]{64}", text(claim.get("digest", "0" * 64), "digest")):
        raise InputError("a digest is 64 hexadecimal digits in lower case")
    for name in COUNTS:
        count = claim.get(name, JsonNumber("0"))
        if not isinstance(count, JsonNumber) or not 0 <= coordinate(count) < 2**63:
            raise InputError(f"{name} is an integer, zero or more")
    coordinate(claim.get("area", "0"))
    if "result" in claim:
        operand_from_json(claim["result"], as_given=True)


def members(value: object, what: str, known: set[str], needed: set[str]) -> Mapping[str, object]:
    if not isinstance(value, dict):
        raise InputError(f"{what} is an object")
    check_members(value, known)
    for name in sorted(needed):
        if name not in value:
            raise InputError(f"{what} lacks the member {name!r}")
    return value


def listed(value: object, what: str) -> list[object]:
    if not isinstance(value, list):
        raise InputError(f"{what} is a list")
    return value


def text(value: object, what: str) -> str:
    if not isinstance(value, str) or isinstance(value, JsonNumber):
        raise InputError(f"{what} is a text")
    return value


def scale(value: object) -> Fraction:
    return positive(str(coordinate(value)))


def factors(value: object) -> tuple[Fraction, ...]:
    """Read one factor, or a list of two, one for each axis."""
    given = value if isinstance(value, list) else [value]
    if isinstance(value, list) and len(value) != 2:
        raise InputError("a scale is one factor, or a list of two")
    return tuple(scale(one) for one in given)


def numbers(values: list[object]) -> Iterator[JsonNumber]:
    for value in values:
        if isinstance(value, JsonNumber):
            yield value
        yield from numbers(parts(value))
