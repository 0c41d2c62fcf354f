"""Coordinates that are no numbers, or whose number does not end."""

from __future__ import annotations

import json
from random import Random

from minkref.degeneracies.invalid.json_text import MARK
from minkref.degeneracies.invalid.member import Families, Invalid
from minkref.degeneracies.invalid.operands import region, thin
from minkref.degeneracies.invalid.sheet import FORMS, JSON_FORMS, Sheet, sheet
from minkref.degeneracies.invalid.writing import refused

FAMILIES = Families()

NO_NUMBERS = (
    "NaN", "nan", "-nan", "Infinity", "-Infinity", "inf", "+inf", "1e", "1e+", "--1", "+-1", "0x1F",
    "1_000", "1.2.3.4", ".", "-", "+.e1", "1e5.5", "3/-4", "/4", "3/", "1/2/3", "½", "٣", "1\u00a0",
    "1.#INF", "-1.#IND", "1,5", "1'000", "0b11", "one", "NULL", "1/2.5", "１", "1f", "5.0d0", "∞",
)  # fmt: skip
QUOTED = (*NO_NUMBERS, "", " 1", "1 ", "1 2")  # also in strings, where white space counts
BARE = ("NaN", "-Infinity", "Infinity", "01", "1.", "-", "1e", "0x1", "nan", "1e5.5")
OTHER = ("null", "true", "[]", "{}")
ZERO = ("0", "00", "000000000000000000000")


def spoilt(dice: Random, page: Sheet, text: str) -> tuple[str, ...]:
    """Puts the text in place of a coordinate; returns the words that name the place."""
    rings = [ring for rings in page.polygons for ring in rings]
    number = dice.randrange(len(rings))
    vertex = dice.randrange(len(rings[number]))
    rings[number][vertex][dice.randrange(2)] = text
    corner = rings[number][vertex]
    corner[0] = MARK + corner[0]
    return f"ring {number}", f"vertex {vertex}"


def drawn(dice: Random, forms: tuple[str, ...] = FORMS) -> Sheet:
    return sheet(dice, region(dice) if dice.random() < 0.85 else thin(dice), forms)


@FAMILIES.add("a coordinate that is no finite number")
def not_a_number(dice: Random) -> Invalid:
    page = drawn(dice)
    if page.form == "geojson" or (page.form in JSON_FORMS and dice.random() < 0.3):
        if dice.random() < 0.3:  # a value of another type
            value = dice.choice((*OTHER, '"1"') if page.form == "geojson" else OTHER)
            return refused(dice, page, "not-a-number", *spoilt(dice, page, value))
        text = dice.choice(BARE)
        spoilt(dice, page, text)  # the JSON parser refuses it, before any rings exist
        return refused(dice, page, "not-a-number", text)
    if page.form in JSON_FORMS:
        text = dice.choice(QUOTED)
        written = json.dumps(text, ensure_ascii=dice.random() < 0.5)
        place = spoilt(dice, page, written)
        return refused(dice, page, "not-a-number", *place, *ascii_only(text))
    # A comma ends a number of WKT; in .poly two points make two numbers, and # begins a comment.
    texts = [t for t in NO_NUMBERS if not set(t).intersection(",#") and t.count(".") != 2]
    text = dice.choice(texts)
    return refused(dice, page, "not-a-number", *spoilt(dice, page, text), *ascii_only(text))


def ascii_only(text: str) -> list[str]:
    """Messages show other letters as question marks."""
    return [text] if text.isascii() else []


@FAMILIES.add("a coordinate with a denominator of zero")
def zero_denominator(dice: Random) -> Invalid:
    page = drawn(dice, ("wkt", "poly", "json", "case"))
    text = f"{dice.choice(('', '-', '+'))}{dice.randint(0, 10**9)}/{dice.choice(ZERO)}"
    written = json.dumps(text) if page.form in JSON_FORMS else text
    return refused(dice, page, "zero-denominator", *spoilt(dice, page, written), text)
