"""The parts of a scene as a program gives them: shapes by name or number, copies, columns."""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass
from fractions import Fraction
from typing import Any

from minkref import _core
from minkref.argument_types import expect_sets, number, whole
from minkref.errors import Refusal, choice
from minkref.exact import exact_scale
from minkref.plane.shapes import number_text
from minkref.scene.copies_text import CopyRow

Number = str | int | Fraction
Place = tuple[Fraction, Fraction]
Sets = Mapping[str, _core.PolygonSet] | Sequence[_core.PolygonSet]


@dataclass(frozen=True, init=False)
class Copy:
    """A copy of a shape, scaled about the origin by `scale` > 0, then moved by `place`. `shape`:
    its name or number in the scene. The scale is an exact number, as everywhere; coordinates may
    also be floats, which count by their bits. Raises BadInput, TypeError."""

    shape: str | int
    scale: Fraction
    place: Place

    def __init__(self, shape: str | int, scale: Number = 1, place: Sequence[Any] = (0, 0)) -> None:
        if isinstance(shape, bool) or not isinstance(shape, (str, int)):
            told = "the name of a shape (a str) or its number (an int)"
            raise TypeError(f"shape has to be {told}, and is of type {type(shape).__name__}")
        x, y = place_of("place", place)
        object.__setattr__(self, "shape", shape)
        object.__setattr__(self, "scale", exact_scale(number("scale", scale), "scale"))
        object.__setattr__(self, "place", (Fraction(x), Fraction(y)))


@dataclass(frozen=True)
class Shapes:
    """The shapes of a scene; `names` is None if numbers name them."""

    sets: list[_core.PolygonSet]
    names: dict[str, int] | None

    def number(self, shape: Any, where: str) -> int:
        """The number of the shape that a copy names. Refuses other names and numbers."""
        if isinstance(shape, str):
            if self.names is not None and shape in self.names:
                return self.names[shape]
            mend = choice(shape, self.names) if self.names else "give the number of a shape"
            raise Refusal(f"there is no shape {shape!r}", where, mend, "no-such-shape")
        count = len(self.sets)
        if not 0 <= whole(f"{where}, shape", shape) < count:
            mend = f"choose a number from 0 to {count - 1}" if count else "give the scene a shape"
            raise Refusal(f"there is no shape {shape}", where, mend, "no-such-shape")
        return int(shape)


def shapes_of(shapes: Any) -> Shapes:
    """Read and validate the shapes of a scene."""
    names = list(shapes) if isinstance(shapes, Mapping) else None
    sets = list_of("shapes", shapes) if names is None else list(shapes.values())
    for k, shape in enumerate(sets):
        where = f"shapes, number {k}" if names is None else f"shapes, {names[k]!r}"
        expect_sets(**{where: shape})
        shape.validate(where)
    return Shapes(sets, None if names is None else {name: k for k, name in enumerate(names)})


def rows_of(copies: Any, shapes: Shapes) -> list[CopyRow]:
    """Read the copies of a scene. Linear."""
    rows = []
    for k, copy in enumerate(list_of("copies", copies)):
        if not isinstance(copy, Copy):
            told = "a Copy; minkref.Copy('box', 2, (0, 0)) makes one"
            raise TypeError(f"copies, number {k}, has to be {told}, and is of type {_kind(copy)}")
        rows.append(row_of(copy, shapes, f"copy {k}"))
    return rows


def row_of(copy: Copy, shapes: Shapes, where: str) -> CopyRow:
    x, y = copy.place
    return CopyRow(shapes.number(copy.shape, where), str(copy.scale), str(x), str(y))


def rows_of_columns(numbers: Any, scales: Any, places: Any, shapes: Shapes) -> list[CopyRow]:
    """Read copies column by column. Linear."""
    given = {"numbers": numbers, "scales": scales, "places": places}
    columns = [list_of(name, value) for name, value in given.items()]
    lengths = [len(column) for column in columns]
    if len(set(lengths)) > 1:
        what = "there are {} numbers, {} scales and {} places".format(*lengths)
        raise Refusal(what, "of_arrays", "give one of each for every copy", "bad-scene")
    rows = []
    for k, (shape, scale, place) in enumerate(zip(*columns, strict=True)):
        where = f"copy {k}, scale"
        factor = str(exact_scale(number_text(scale, where), where))
        x, y = place_of(f"copy {k}, place", place)
        rows.append(CopyRow(shapes.number(shape, f"copy {k}"), factor, x, y))
    return rows


def place_of(name: str, place: Any) -> tuple[str, str]:
    """Write the two coordinates of a place as exact texts."""
    pair = place.tolist() if hasattr(place, "tolist") else place
    if not isinstance(pair, (tuple, list)):
        raise TypeError(f"{name} has to be a pair of numbers, and is of type {_kind(place)}")
    if len(pair) != 2:
        what = f"a place has two coordinates, not {len(pair)}"
        raise Refusal(what, name, "give x and y", "bad-scene")
    x, y = (number_text(one, f"{name}, {axis}") for one, axis in zip(pair, "xy", strict=True))
    return x, y


def list_of(name: str, value: Any) -> list[Any]:
    """The members of a sequence or an array."""
    given = value.tolist() if hasattr(value, "tolist") else value
    if isinstance(given, (str, bytes, Mapping)) or not isinstance(given, Iterable):
        raise TypeError(f"{name} has to be a sequence, and is of type {_kind(value)}")
    return list(given)


def _kind(value: Any) -> str:
    return type(value).__name__
