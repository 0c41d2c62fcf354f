"""Arguments of public functions: refuses other types with words that name the expected type
(TypeError), and takes Python's exact numbers."""

from __future__ import annotations

import inspect
import math
from collections.abc import Callable, Sequence
from fractions import Fraction
from functools import wraps
from numbers import Rational
from typing import Any

from minkref import _core
from minkref.errors import Refusal
from minkref.scaling import joined

SET = "a PolygonSet; minkref.PolygonSet(...) makes one"
TEXT = "a str"
NUMBERS = "exact numbers: strs as '7/5' or '0.1', ints or Fractions"
NUMBER = "an exact number: a str as '7/5' or '0.1', an int or a Fraction"
BODY = "a ConvexPolyhedron; minkref.ConvexPolyhedron(minkref.read_mesh(...)) makes one"
SURFACE = "a Polyhedron, as minkref.read_mesh gives"
SUMMAND = "a Polyhedron, as minkref.read_mesh gives, or a ConvexPolyhedron"


def expect_sets(**given: Any) -> None:
    _expect(_core.PolygonSet, SET, given)


def expect_bodies(**given: Any) -> None:
    _expect(_core.ConvexPolyhedron, BODY, given)


def expect_surfaces(**given: Any) -> None:
    _expect(_core.Polyhedron, SURFACE, given)


def surface_of(name: str, value: Any) -> _core.Polyhedron:
    if isinstance(value, _core.ConvexPolyhedron):
        return value.surface()
    if not isinstance(value, _core.Polyhedron):
        raise _wrong(name, SUMMAND, value)
    return value


def _expect(kind: type, expected: str, given: dict[str, Any]) -> None:
    for name, value in given.items():
        if not isinstance(value, kind):
            raise _wrong(name, expected, value)


def text_of(name: str, value: Any) -> str:
    if not isinstance(value, str):
        raise _wrong(name, TEXT, value)
    return value


def number(name: str, value: Any) -> str:
    """Write an exact number as text. Refuses floats: 0.1 differs from the number that it shows."""
    if isinstance(value, str):
        return value
    if isinstance(value, bool) or not isinstance(value, Rational):
        raise _wrong(name, NUMBER, value)
    return f"{int(value.numerator)}/{int(value.denominator)}"


def scale_text(name: str, value: Any) -> str:
    """Write a scale in the plane as text: one number, or a list of two, a factor for each axis."""
    if isinstance(value, tuple | list) and len(value) == 2:
        return joined([number(name, factor) for factor in value])
    return number(name, value)


def factors(name: str, value: Any) -> tuple[str, str, str]:
    """Read the three axes' factors, from one number for all axes or from three."""
    axes = value if isinstance(value, tuple | list) and len(value) == 3 else [value] * 3
    x, y, z = (number(name, factor) for factor in axes)
    return x, y, z


def coordinates(name: str, value: Any, count: int) -> list[str]:
    """Write the coordinates of a place as texts. Refuses a text, whose characters are none."""
    if isinstance(value, str) or not isinstance(value, Sequence) or len(value) != count:
        told = f"{'a pair of' if count == 2 else 'three'} {NUMBERS}"
        raise _wrong(name, told, value)
    return [number(name, one) for one in value]


def place(name: str, value: Any) -> tuple[str, str, str]:
    x, y, z = coordinates(name, value, 3)
    return x, y, z


def three_exact(name: str, value: Any) -> tuple[str, str, str]:
    """Write three numbers in lowest terms."""
    x, y, z = (str(Fraction(axis)) for axis in place(name, value))
    return x, y, z


def two_exact(name: str, value: Any) -> tuple[Fraction, Fraction]:
    """Read a point of the plane."""
    x, y = map(Fraction, coordinates(name, value, 2))
    return x, y


def whole(name: str, value: Any) -> int:
    if isinstance(value, bool) or not isinstance(value, int):
        raise _wrong(name, "an int", value)
    return value


def double(name: str, value: Any) -> float:
    """Read a double above 0 and below infinity."""
    if isinstance(value, bool) or not isinstance(value, (int, float)):
        raise _wrong(name, "a float", value)
    if not 0 < value < math.inf:
        mend = "give a float above 0 and below infinity"
        raise Refusal(f"the {name} is {value}", name, mend, f"bad-{name}")
    return float(value)


def truth(name: str, value: Any) -> bool:
    if not isinstance(value, bool):
        raise _wrong(name, "True or False", value)
    return value


def _wrong(name: str, expected: str, value: Any) -> TypeError:
    return TypeError(f"{name} has to be {expected}, and is of type {type(value).__name__}")


Reader = Callable[[str, Any], Any]
_AT_A_SCALE: dict[str, Reader] = {"scale": number}
_METHODS: dict[type, dict[str, dict[str, Reader]]] = {
    _core.PolygonSet: {
        "from_json": {"text": text_of},
        "validate": {"source": text_of},
        "scaled": {"factor": scale_text},
        "translated": {"x": number, "y": number},
    },
    _core.Polyhedron: {"scaled": {"by": factors}, "translated": {"by": place}},
    _core.ScaleIndex: {
        "rings": {"scale": number, "form": text_of},
        "sum": {"scale": number, "passages": truth},
        "area": _AT_A_SCALE,
        "area_polynomial": _AT_A_SCALE,
        "components_and_holes": _AT_A_SCALE,
        "neighbours": _AT_A_SCALE,
        "lives": {"kind": text_of},
    },
}
_DEFAULTS: dict[str, Any] = {"source": "", "form": "double", "passages": False}


def _checked(
    owner: type, name: str, original: Callable[..., Any], readers: dict[str, Reader]
) -> Any:
    """Wrap a method so that `readers` convert arguments that the method itself does not take."""
    is_static = name == "from_json"
    takes_triples = not {factors, place}.isdisjoint(readers.values())
    names = [*([] if is_static else ["self"]), *readers]
    either = inspect.Parameter.POSITIONAL_OR_KEYWORD
    none = inspect.Parameter.empty
    signature = inspect.Signature(
        [inspect.Parameter(n, either, default=_DEFAULTS.get(n, none)) for n in names]
    )

    @wraps(original)
    def method(*given: Any, **named: Any) -> Any:
        try:
            if not takes_triples:  # to the method a text is a sequence of its characters
                return original(*given, **named)
        except TypeError as error:
            if "incompatible function arguments" not in str(error):
                raise
        try:
            bound = signature.bind(*given, **named)
        except TypeError as error:
            raise TypeError(f"{owner.__name__}.{name}: {error}") from None
        bound.apply_defaults()
        return original(
            *(readers[n](n, v) if n in readers else v for n, v in bound.arguments.items())
        )

    return staticmethod(method) if is_static else method


def check_methods() -> None:
    """Make the methods of users' classes check their arguments from now on."""
    for owner, methods in _METHODS.items():
        for name, readers in methods.items():
            original = getattr(owner, name)
            if not hasattr(original, "__wrapped__"):
                setattr(owner, name, _checked(owner, name, original, readers))
