"""Input beyond a limit (formats/limits.hpp): refused before any work. The files are valid
otherwise, and as small as the limit allows."""

from __future__ import annotations

import json
from random import Random

from minkref.degeneracies.invalid.json_text import MARK, Marked, Object, Raw, json_text
from minkref.degeneracies.invalid.member import Families, Invalid
from minkref.degeneracies.invalid.operands import region
from minkref.degeneracies.invalid.sheet import CLOSED, JSON_FORMS, Sheet, sheet
from minkref.degeneracies.invalid.writing import of_bytes, refused, text_of, tree_of

FAMILIES = Families()

DIGITS = 10_000
EXPONENT = 10_000
DEPTH = 128
VERTICES = 1_000_000
NUMBER_BYTES = 256 << 20
SHOWN = 30  # most letters of a number that a message shows


def spoilt(dice: Random, text: str, bare: bool) -> tuple[Sheet, tuple[str, ...]]:
    """An operand with the number at one vertex; `bare`: JSON allows the number without quotes,
    too."""
    forms = ("wkt", "poly", "json", "case", "geojson") if bare else ("wkt", "poly", "json", "case")
    page = sheet(dice, region(dice), forms)
    rings = [ring for part in page.polygons for ring in part]
    number = dice.randrange(len(rings))
    vertex = dice.randrange(len(rings[number]))
    quoted = page.form == "case" or (page.form == "json" and (not bare or dice.random() < 0.5))
    rings[number][vertex][dice.randrange(2)] = json.dumps(text) if quoted else text
    rings[number][vertex][0] = MARK + rings[number][vertex][0]
    return page, (f"ring {number}", f"vertex {vertex}")


@FAMILIES.add("a number of more than ten thousand digits")
def number_too_long(dice: Random) -> Invalid:
    """Digits before the point, behind it, or of a fraction: a few too many, or a million."""
    count = dice.choice((DIGITS + 1, DIGITS + 7, 20_000, 100_000, 1_000_000))
    block = "".join(dice.choice("123456789") for _ in range(97))
    digits = (block * (count // 97 + 1))[:count]
    kind = dice.choice(("whole", "whole", "decimal", "zeros", "numerator", "denominator"))
    text = {
        "whole": digits,
        "decimal": f"{digits[0]}.{digits[1:]}",
        "zeros": f"0.{'0' * count}",
        "numerator": f"{digits}/7",
        "denominator": f"7/{digits}",
    }[kind]
    page, place = spoilt(dice, text, kind not in ("numerator", "denominator"))
    return refused(dice, page, "number-too-long", *place)


@FAMILIES.add("an exponent beyond ten thousand")
def exponent_too_large(dice: Random) -> Invalid:
    exponent = dice.choice((EXPONENT + 1, 99_999, 10**6, 10**9, 2**31, 2**63, 2**64 + 1, 10**40))
    mantissa = dice.choice(("1", "0", "3.25", "0.001", "-7"))
    text = f"{mantissa}{dice.choice('eE')}{dice.choice(('', '+', '-'))}{exponent}"
    page, place = spoilt(dice, text, True)
    return refused(dice, page, "exponent-too-large", *place, text[:SHOWN])


@FAMILIES.add("values nested deeper than 128")
def too_deep(dice: Random) -> Invalid:
    """Nested collections, arrays instead of a coordinate, or a member that nobody reads."""
    depth = dice.choice((DEPTH + 1, DEPTH + 2, 200, 1000, 5000, 100_000))
    page = sheet(dice, region(dice), (*CLOSED, *JSON_FORMS))
    if page.form == "wkt":
        inner = text_of(dice, page).strip()
        inner = inner.removeprefix("GEOMETRYCOLLECTION (")[:-1] if inner[0] == "G" else inner
        step = "GEOMETRYCOLLECTION ("
        return refused(
            dice,
            page,
            "too-deep",
            text=step * DEPTH + MARK + step * (depth - DEPTH) + inner + ")" * depth,
        )
    nested = Raw("[" * depth + "]" * depth)
    if page.form == "case":
        tree = tree_of(dice, page)
        tree.append(("degeneracy", Object([("why", Marked(nested))])))
        return refused(dice, page, "too-deep", text=json_text(tree, page.tall))
    if page.form == "geojson":
        text = text_of(dice, page).strip()
        return refused(dice, page, "too-deep", text=f'{{"properties": {MARK}{nested}, {text[1:]}')
    rings = [ring for part in page.polygons for ring in part]
    corner = dice.choice(dice.choice(rings))
    corner[0] = MARK + nested
    return refused(dice, page, "too-deep")


@FAMILIES.add("more than a million vertices")
def too_many_vertices(dice: Random) -> Invalid:
    """A box whose sides have a vertex at each whole number."""
    form = dice.choice(("wkt", "poly", "json"))
    page = sheet(dice, [[[(0, 0), (1, 0), (0, 1)]]], (form,))
    more = dice.choice((1, 10, 1000))
    length = (VERTICES + more + 1) // 2
    y = dice.randint(1, 9)
    sides = [(str(x), "0") for x in range(length)] + [
        (str(x), str(y)) for x in reversed(range(length))
    ]
    if form == "wkt":
        corners = ",".join(f"{a} {b}" for a, b in sides)
        text = f"POLYGON(({corners},0 0))"
    elif form == "poly":
        text = f"1\n{len(sides)} out\n" + "\n".join(f"{a} {b}" for a, b in sides) + "\n"
    else:
        corners = ",".join(f"[{a},{b}]" for a, b in sides)
        text = f'{{"polygons":[{{"outer":[{corners}]}}]}}'
    line = VERTICES + 3 if form == "poly" else 1
    place = ("ring 0", f"vertex {VERTICES}", f"line {line}")
    return of_bytes(page, "too-many-vertices", text.encode(), *place)


@FAMILIES.add("numbers that would fill the memory")
def too_many_digits(dice: Random) -> Invalid:
    """Short texts for long numbers, which together would fill the memory."""
    form = dice.choice(("wkt", "json"))
    page = sheet(dice, [[[(0, 0), (1, 0), (0, 1)]]], (form,))
    bytes_each = 8 * (33_219 // 64 + 1)
    count = NUMBER_BYTES // bytes_each // 2 + 1000
    sign = dice.choice(("", "-"))
    far = f"{sign}1e{EXPONENT}"
    ring = [("0", "0"), *((far, f"{k}e{EXPONENT - 6}") for k in range(1, count))]
    if form == "wkt":
        text = "POLYGON((" + ",\n".join(f"{a} {b}" for a, b in ring) + ",0 0))"
    else:
        corners = ",\n".join(f"[{a},{b}]" for a, b in ring)
        text = f'{{"polygons":[{{"outer":[{corners}]}}]}}'
    return of_bytes(page, "too-many-digits", text.encode(), "ring 0", "vertex ", "line ")


@FAMILIES.add("holes whose outer ring is too costly to find")
def too_much_work(dice: Random) -> Invalid:
    """A .poly with two outer rings: a hole and an outer ring have a vertex at each whole number of
    two sides. The slow engine has no such limit."""
    size = dice.randint(1200, 1600)
    page = sheet(dice, [[[(0, 0), (1, 0), (0, 1)]]], ("poly",))
    hole = [f"{x} 1" for x in range(1, size)] + [f"{x} 2" for x in range(size - 1, 0, -1)]
    outer = [f"{x} 0" for x in range(size + 1)] + [f"{x} 3" for x in range(size, -1, -1)]
    lines = ["3", "3 out", "0 -9", "1 -9", "1 -8", f"{len(outer)} out", *outer]
    line = len(lines) + 2
    lines += [f"{len(hole)} in", *hole]
    content = "\n".join(lines).encode()
    place = ("ring 2", "vertex 0", "(1, 1)", f"line {line}")
    return of_bytes(page, "too-much-work", content, *place, slow=False)
