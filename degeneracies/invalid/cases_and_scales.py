"""Invalid cases, scales inside them, and the scale of a command."""

from __future__ import annotations

from dataclasses import replace
from fractions import Fraction
from random import Random

from minkref.degeneracies.invalid.json_text import Marked, Object, Raw, json_text
from minkref.degeneracies.invalid.member import Families, Invalid
from minkref.degeneracies.invalid.operands import region
from minkref.degeneracies.invalid.sheet import Sheet, place_of, sheet
from minkref.degeneracies.invalid.writing import of_bytes, refused, text_of, tree_of

FAMILIES = Families()

VERSIONS = ("case-v2", "case-v0", "case", "", "CASE-V1", "case-v1 ", "case-v1.1", "case-v10")
DIMENSIONS = ('"2"', "3", "1", "0", "-2", "2.0", "2e0", "null", "[2]", "true")
NOT_POSITIVE = ('"0"', "0", '"-1"', "-7", '"-1/3"', '"0/5"', '"-0"', '"0.000"', '"0e9"', '"-1e-99"')
SHOWN = 40  # most letters of an option that a message shows

NOT_FINITE = ("NaN", "nan", "inf", "-inf", "Infinity", "-Infinity", "+inf", "INF", " nan ")
NOT_A_NUMBER = (
    "", "x", "1/0", "1/-2", "1/2/3", "0x2", "1e", "--1", "1.2.3", "²", "٣", "1_0", "2 3", "1/2.5",
    "one", ".", "2s", "50%", "1;5", "0b1", "1/", "/3", "(1)", "=1",
)  # fmt: skip
NOT_UNIFORM = ("1,2,3", "2,2,2", "1/2,3,1", "1,2,", ",1,", "1,2,3,4", "1.5,2,1", "2, 2, 2", "0,0,0")
ZEROS = ("0", "0.0", "-0", "+0", "0/7", "0e99", ".0", "00", "0.", "-0.000")


@FAMILIES.add("a ring of a case that runs the wrong way")
def wrong_orientation(dice: Random) -> Invalid:
    shape = region(dice)
    page = sheet(dice, shape, ("case",))
    wrong = [
        (p, r) for p, rings in enumerate(shape) for r in range(len(rings)) if dice.random() < 0.3
    ]
    p, r = min(wrong, default=(0, 0))
    for i, k in wrong or [(p, r)]:
        page.shape[i][k].reverse()
        page.polygons[i][k].reverse()
    page.mark(p, r, 0)
    named = ["vertices 0, 1, 2", *place_of(*page.shape[p][r][:3])]
    return refused(dice, page, "wrong-orientation", f"ring {page.number(p, r)}", *named)


def case(dice: Random) -> tuple[Sheet, Object]:
    page = sheet(dice, region(dice), ("case",))
    return page, tree_of(dice, page)


@FAMILIES.add("a case of another version")
def unsupported_version(dice: Random) -> Invalid:
    page, tree = case(dice)
    version = dice.choice(VERSIONS)
    tree.put("schema", Marked(version))
    return refused(dice, page, "unsupported-version", version, text=json_text(tree, page.tall))


@FAMILIES.add("a case of another dimension than 2")
def unsupported_dimension(dice: Random) -> Invalid:
    page, tree = case(dice)
    tree.put("dimension", Marked(Raw(dice.choice(DIMENSIONS))))
    return refused(dice, page, "unsupported-dimension", text=json_text(tree, page.tall))


@FAMILIES.add("an operand of a case asked of what is none")
def not_a_case(dice: Random) -> Invalid:
    """#P or #Q behind the name of a file with only one operand."""
    page = sheet(dice, region(dice), ("wkt", "poly", "geojson", "json"))
    made = of_bytes(page, "not-a-case", text_of(dice, page).encode())
    return replace(made, part=f"#{page.operand}", place=(f"{made.file_name}#{page.operand}",))


@FAMILIES.add("a case with a scale that is not positive")
def scale_not_positive(dice: Random) -> Invalid:
    """Among the scales, at an end of the interval, or in an expected result."""
    page, tree = case(dice)
    tree.drop("scales")
    tree.drop("interval")
    bad, good = Marked(Raw(dice.choice(NOT_POSITIVE))), str(dice.randint(1, 9))
    where = dice.choice(("scales", "interval", "expected"))
    if where == "interval":
        ends = [("from", bad), ("to", good)] if dice.random() < 0.7 else [("to", bad)]
        tree.append(("interval", Object(ends)))
    else:
        scales: list[object] = [*(good, "7/5", "3")[: dice.randint(1, 3)]]
        if where == "scales":
            scales.insert(dice.randint(0, len(scales)), bad)
        else:
            tree.append(("expected", [Object([("components", Raw("1")), ("scale", bad)])]))
        tree.append(("scales", scales))
    return refused(dice, page, "scale-not-positive", text=json_text(tree, page.tall))


@FAMILIES.add("a case whose interval ends before it begins")
def empty_interval(dice: Random) -> Invalid:
    page, tree = case(dice)
    tree.drop("scales")
    tree.drop("interval")
    to = Fraction(dice.randint(1, 9), dice.randint(1, 9))
    begin = to + Fraction(1, dice.choice((1, 7, 10**30)))
    ends = Object([("from", str(begin)), ("to", str(to))])
    if dice.random() < 0.3:
        ends.reverse()
    ends.mark = True
    tree.append(("interval", ends))
    return refused(dice, page, "empty-interval", text=json_text(tree, page.tall))


def with_scale(dice: Random, code: str, text: str) -> Invalid:
    """A valid operand and a refused scale."""
    page = sheet(dice, region(dice), ("wkt", "poly", "json"))
    shown = text[:SHOWN].strip() or f'"{text}"'
    made = of_bytes(page, code, text_of(dice, page).encode(), shown)
    return replace(made, operand="scale", scale=text)


@FAMILIES.add("a scale that is not finite")
def scale_not_finite(dice: Random) -> Invalid:
    return with_scale(dice, "scale-not-finite", dice.choice(NOT_FINITE))


@FAMILIES.add("a scale that is no number")
def scale_not_a_number(dice: Random) -> Invalid:
    return with_scale(dice, "scale-not-a-number", dice.choice(NOT_A_NUMBER))


@FAMILIES.add("a scale of three factors or more")
def scale_not_uniform(dice: Random) -> Invalid:
    return with_scale(dice, "scale-not-uniform", dice.choice(NOT_UNIFORM))


@FAMILIES.add("a scale of zero")
def scale_zero(dice: Random) -> Invalid:
    return with_scale(dice, "scale-zero", dice.choice(ZEROS))


@FAMILIES.add("a negative scale")
def scale_negative(dice: Random) -> Invalid:
    n, d = dice.randint(1, 10**6), dice.randint(1, 99)
    texts = (f"-{n}", f"-{n}/{d}", f"-0.{n}", f"-{n}e-9", f"-1e-{dice.randint(1, 999)}")
    return with_scale(dice, "scale-negative", dice.choice(texts))


@FAMILIES.add("a scale of too many digits, or with too large an exponent")
def limit(dice: Random) -> Invalid:
    """Too many digits, or too large an exponent."""
    digits = "".join(dice.choice("123456789") for _ in range(40))
    long = digits * dice.randint(101, 600)
    exponent = dice.choice((5000, 99999, 10**9, 10**18, 10**100))
    texts = (long, f"{long}/7", f"7/{long}", f"0.{long}", f"1e{exponent}", f"1e-{exponent}")
    return with_scale(dice, "limit", dice.choice(texts))
