"""SVG: paths and basic shapes as a set, by their fill rules, all united."""

from __future__ import annotations

import re
from collections.abc import Iterator
from dataclasses import dataclass
from fractions import Fraction
from xml.etree import ElementTree

from minkref import _core
from minkref.drawings.affine import Affine, transform
from minkref.drawings.curves import Point, TooFine, circle
from minkref.drawings.reading import Reading
from minkref.drawings.svg_path import PathReader, arc
from minkref.errors import Refusal
from minkref.exact import set_json

INKSCAPE = "{http://www.inkscape.org/namespaces/inkscape}"
SHAPES = ("path", "polygon", "polyline", "rect", "circle", "ellipse")
NOT_DRAWN = frozenset({"defs", "clipPath", "mask", "marker", "pattern", "symbol", "linearGradient",
                       "radialGradient", "filter", "title", "desc", "metadata", "style", "script",
                       "namedview"})  # fmt: skip
TEXTS = frozenset({"text", "image", "line", "foreignObject"})
_LENGTH = re.compile(r"\s*([+-]?[\d.]+(?:[eE][+-]?\d+)?)\s*(?:px)?\s*")
_RULE = re.compile(r"fill-rule\s*:\s*(\w+)")
_HIDDEN = re.compile(r"display\s*:\s*none|visibility\s*:\s*hidden")
DEEPEST = 200


@dataclass(frozen=True)
class Context:
    """Properties inherited from parent elements."""

    map: Affine = Affine()  # noqa: RUF009 a value
    rule: str = "nonzero"
    layer: str = ""


def read_svg(data: bytes, reading: Reading) -> _core.PolygonSet:
    """Return the union of all filled shapes, in user units, y as written. Refuses other text and
    unknown geometry."""
    try:
        root = ElementTree.fromstring(data)
    except ElementTree.ParseError as error:
        mend = "give a well-formed SVG file"
        raise reading.refusal(f"this is no XML: {error}", mend, "syntax") from error
    if _name(root) != "svg":
        raise reading.refusal(
            f"this is <{_name(root)[:40]}>, not <svg>", "give an SVG file", "syntax"
        )
    _tell_units(root, reading)
    sets = [_filled(*each) for each in _shapes(root, Context(), reading, 0)]
    reading.check_layer()
    return _core.combined("union", sets)[0]


def _name(element: ElementTree.Element) -> str:
    return element.tag.rpartition("}")[2] if isinstance(element.tag, str) else ""


def _tell_units(root: ElementTree.Element, reading: Reading) -> None:
    width = root.get("width", "").strip()
    if re.fullmatch(r"[\d.]+(mm|cm|in|pt|pc|Q)", width):
        reading.note(f"the width is {width}: coordinates are user units, as they are written")


def _shapes(
    element: ElementTree.Element, around: Context, reading: Reading, depth: int
) -> Iterator[tuple[list[list[Point]], str]]:
    """Yield subpaths and fill rule for each shape."""
    name = _name(element)
    if not name or name in NOT_DRAWN or element.get("display") == "none":
        return
    style = element.get("style", "")
    if _HIDDEN.search(style):
        return
    where = f"<{name}{' id=' + element.get('id', '') if element.get('id') else ''}>"
    if depth > DEEPEST:
        raise reading.refusal("elements are nested too deep", "flatten them", "too-deep", where)
    if name in TEXTS:
        reading.left_out[name] += 1
        return
    inner = _inside(element, style, around, reading, where)
    if name in SHAPES:
        if (inner.layer and not reading.takes(inner.layer)) or (reading.layer and not inner.layer):
            return
        subpaths = _Shape(element, name, inner.map, reading, where).subpaths()
        yield [[inner.map(point) for point in points] for points in subpaths], inner.rule
    elif name in ("svg", "g", "a", "switch") and (depth == 0 or name != "svg"):
        for child in element:
            yield from _shapes(child, inner, reading, depth + 1)
    else:
        mend = "make paths of it in the program that drew it (clones: unlink them)"
        raise reading.refusal("it is not read", mend, "unsupported-geometry", where)


def _inside(
    element: ElementTree.Element, style: str, around: Context, reading: Reading, where: str
) -> Context:
    own = Affine()
    if (text := element.get("transform")) is not None:
        try:
            own = transform(text, reading.number, reading.note)
        except ValueError as error:
            raise _fault(error, reading, where, "write transforms as SVG has them") from error
    found = _RULE.search(style)
    rule = found[1] if found else element.get("fill-rule", around.rule)
    layer = around.layer
    if element.get(f"{INKSCAPE}groupmode") == "layer":
        layer = element.get(f"{INKSCAPE}label", "") or element.get("id", "")
        reading.layers[layer] = None
    return Context(around.map @ own, "evenodd" if rule == "evenodd" else "nonzero", layer)


def _fault(error: ValueError, reading: Reading, where: str, mend: str) -> Refusal:
    if isinstance(error, Refusal):
        return error
    return reading.refusal(str(error), mend, "syntax", where)


def _filled(subpaths: list[list[Point]], rule: str) -> _core.PolygonSet:
    """Fill closed subpaths by a rule."""
    text = set_json((points, ()) for points in subpaths if len(points) > 2)
    return _core.filled(_core.PolygonSet.from_json(text), rule)[0]


class _Shape:
    def __init__(
        self, element: ElementTree.Element, name: str, to_user: Affine, reading: Reading, where: str
    ) -> None:
        self._element, self._name = element, name
        self._map, self._reading, self._where = to_user, reading, where

    def subpaths(self) -> list[list[Point]]:
        """Return corners for each subpath, before the transform."""
        try:
            if self._name == "path":
                text = self._element.get("d", "")
                return PathReader(text, self._reading.number, self._tolerance).subpaths()
            if self._name in ("polygon", "polyline"):
                return [self._corners()]
            return [self._rect() if self._name == "rect" else self._ellipse()]
        except TooFine as error:
            raise self._reading.too_fine(error, self._where) from error
        except ValueError as error:
            mend = "write the shape as SVG has it"
            raise _fault(error, self._reading, self._where, mend) from error

    def _tolerance(self) -> Fraction:
        """The tolerance before the transform stretches lengths."""
        return self._reading.curve_tolerance() / self._map.stretch

    def _corners(self) -> list[Point]:
        words = re.split(r"[\s,]+", self._element.get("points", "").strip())
        numbers = [self._reading.number(word) for word in words if word]
        if len(numbers) % 2:
            raise ValueError("the points have an odd number of coordinates")
        return list(zip(numbers[::2], numbers[1::2], strict=True))

    def _length(self, name: str, default: str = "0") -> Fraction:
        text = self._element.get(name, default)
        found = _LENGTH.fullmatch(text)
        if found is None:
            raise ValueError(f"{name} is {text[:40]!r}: only numbers of user units are read")
        return self._reading.number(found[1])

    def _rect(self) -> list[Point]:
        x, y = self._length("x"), self._length("y")
        width, height = self._length("width"), self._length("height")
        if width <= 0 or height <= 0:
            return []
        rx = self._length("rx", self._element.get("ry", "0"))
        ry = self._length("ry", self._element.get("rx", "0"))
        rx, ry = min(rx, width / 2), min(ry, height / 2)
        if rx <= 0 or ry <= 0:
            return [(x, y), (x + width, y), (x + width, y + height), (x, y + height)]
        points = [(x + rx, y)]
        right, bottom = x + width, y + height
        for corner, end in (
            ((right - rx, y), (right, y + ry)),
            ((right, bottom - ry), (right - rx, bottom)),
            ((x + rx, bottom), (x, bottom - ry)),
            ((x, y + ry), (x + rx, y)),
        ):
            radii = [rx, ry, Fraction(0), Fraction(0), Fraction(1)]
            points += [corner, *arc(corner, end, radii, self._tolerance())]
        return points

    def _ellipse(self) -> list[Point]:
        center = self._length("cx"), self._length("cy")
        if self._name == "circle":
            rx = ry = self._length("r")
        else:
            rx, ry = self._length("rx"), self._length("ry")
        if rx <= 0 or ry <= 0:
            return []
        most = max(rx, ry)
        zero = (Fraction(0), Fraction(0))
        unit = Affine(a=rx / most, d=ry / most, e=center[0], f=center[1])
        return [unit(point) for point in circle(zero, most, self._tolerance())]
