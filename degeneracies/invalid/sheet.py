"""An operand on its way to a file: its tokens may still be changed, and one place marked."""

from __future__ import annotations

import json
from collections.abc import Sequence
from dataclasses import dataclass
from fractions import Fraction
from random import Random

from minkref.degeneracies.invalid.json_text import MARK
from minkref.degeneracies.invalid.operands import coordinates, region
from minkref.fuzz.geometry.plane import Point, Shape, mapped

Corner = list[str]  # the texts of both coordinates
ENDINGS = {"wkt": ".wkt", "geojson": ".geojson", "poly": ".poly", "json": ".json", "case": ".json"}
FORMS = tuple(ENDINGS)
JSON_FORMS = ("json", "case")
CLOSED = ("wkt", "geojson")  # a ring repeats its first vertex


class Tokens(list[Corner]):
    """The corners of a ring, or if `thin` the ends of a point or a segment. `mark`: the mark stands
    before the beginning."""

    mark = False
    thin = False


def decimal(value: Fraction | int) -> str | None:
    """Returns a number's finite decimal, or None."""
    value = Fraction(value)
    places = 0
    while value.denominator != 1 and places < 400:
        value, places = value * 10, places + 1
    if value.denominator != 1:
        return None
    if not places:
        return str(value)
    digits = str(abs(value.numerator)).rjust(places + 1, "0")
    return ("-" if value < 0 else "") + digits[:-places] + "." + digits[-places:]


def token(dice: Random, form: str, value: Fraction | int) -> str:
    """Draws a number's text in a format."""
    plain = decimal(value)
    kind = dice.random()
    if form == "geojson" and plain is None:
        raise ValueError(f"{value} is no decimal")
    if plain is not None and "." not in plain and kind < 0.2:
        plain = dice.choice((f"{plain}.0", f"{plain}e0", f"{plain}.00E+0"))
    if form == "geojson":
        return str(plain)
    text = plain if plain is not None and kind < 0.7 else str(value)
    if form == "json" and plain is not None and kind < 0.4:
        return plain
    if form == "case" and Fraction(value).denominator == 1 and kind < 0.4:
        return str(value)
    return json.dumps(text) if form in JSON_FORMS else text


@dataclass
class Sheet:
    """`shape` holds the numbers, `polygons` their texts. `backwards`: rings run the wrong way, so
    messages list two vertex numbers in another order."""

    form: str
    shape: Shape
    polygons: list[list[Tokens]]
    operand: str
    tall: bool
    backwards: bool
    other: Shape | None = None  # a case's other operand

    def number(self, polygon: int, ring: int) -> int:
        """The ring's number in the file."""
        return sum(len(rings) for rings in self.polygons[:polygon]) + ring

    def mark(self, polygon: int, ring: int, vertex: int) -> None:
        """Marks this vertex, for messages that name its line."""
        corner = self.polygons[polygon][ring][vertex]
        corner[0] = MARK + corner[0]

    def name(self) -> str:
        return ("case" if self.form == "case" else self.operand) + ENDINGS[self.form]


def sheet(
    dice: Random, shape: Shape, forms: Sequence[str] = FORMS, backwards: bool | None = None
) -> Sheet:
    """Writes the shape in a random format, in other coordinates, with rings starting at their first
    vertex."""
    thin = any(len(rings[0]) < 3 for rings in shape)
    form = dice.choice([form for form in forms if not (thin and form == "poly")])
    change = coordinates(dice, form == "geojson")
    placed = mapped(shape, change)
    turn = dice.random() < 0.25 if backwards is None else backwards
    turn = turn and form != "case" and not thin
    if turn:
        placed = [[ring[::-1] for ring in rings] for rings in placed]
    polygons = tokens(dice, form, placed)
    if form in CLOSED and not thin:
        for ring in (ring for rings in polygons for ring in rings):
            ring.append(list(ring[0]))
    made = Sheet(form, placed, polygons, dice.choice("PQ"), dice.random() < 0.5, turn)
    if form == "case":
        made.other = mapped(region(dice), coordinates(dice, False))
    return made


def tokens(dice: Random, form: str, shape: Shape) -> list[list[Tokens]]:
    """Texts for a shape's numbers, without repeating any vertex."""
    found = [
        [Tokens([token(dice, form, n) for n in p] for p in ring) for ring in rings]
        for rings in shape
    ]
    for rings in found:
        rings[0].thin = len(rings[0]) < 3
    return found


def place_of(*points: Point) -> tuple[str, ...]:
    """Writes points as messages do."""
    return tuple(f"({told(x)}, {told(y)})" for x, y in points)


def told(number: Fraction | int | str) -> str:
    """A number as messages write it: a decimal if short."""
    value = Fraction(number)
    plain = decimal(value)
    return plain if plain is not None and len(plain) <= 60 else str(value)
