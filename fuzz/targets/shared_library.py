"""A C function as a target: `so:./library.so:function` (fuzz/adapters/minkref_adapter.h)."""

from __future__ import annotations

import ctypes
import json
import os
from ctypes import POINTER, Structure, c_char_p, c_double, c_int, c_ubyte, c_void_p
from typing import Any

from minkref.errors import message_of
from minkref.fuzz.cases.case import Case
from minkref.fuzz.cases.invalid_case import InvalidCase
from minkref.fuzz.cases.space_case import SpaceCase
from minkref.fuzz.targets.answer import Answer, Target, lacking, skipped
from minkref.fuzz.targets.declaration import Declaration, DeclarationError, read_declaration
from minkref.fuzz.targets.numbers import Unreadable, plane_answer, sent_set
from minkref.fuzz.targets.python_callable import UnloadableTarget
from minkref.fuzz.verdicts.verdict import Verdict

RESULT, SKIPPED, REJECTED = 0, 1, 2
MOST_VERTICES = 50_000_000
ADD_ON = {
    "arithmetic": "float64",
    "tolerance": {"absolute": "0", "relative": "1e-9"},
    "capabilities": ["plane", "non-convex", "holes", "components"],
}


class _Set(Structure):
    _fields_ = (
        ("rings", c_int),
        ("sizes", POINTER(c_int)),
        ("is_hole", POINTER(c_ubyte)),
        ("xy", POINTER(c_double)),
    )


class LibraryTarget:
    def __init__(self, name: str) -> None:
        self.name = name
        self._function, self._declaration = load_library(name)
        self._free = ctypes.CDLL(None).free
        self._free.argtypes = [c_void_p]

    def sum(self, case: Case | SpaceCase | InvalidCase) -> Answer:
        declaration = self._declaration
        lack = lacking(declaration, case)
        if lack or isinstance(case, SpaceCase):
            return skipped(lack or "in the plane only", declaration)
        try:
            P = _packed(sent_set(case.scaled_P_json, declaration))
            Q = _packed(sent_set(case.Q_json, declaration))
        except OverflowError:
            return skipped("numbers beyond the range of doubles", declaration)
        result = _Set()
        status = self._function(ctypes.byref(P), ctypes.byref(Q), ctypes.byref(result))
        if status == RESULT:
            return self._read(result)
        if status == REJECTED:
            return Answer(verdict=Verdict.WRONG, message="rejected", declaration=declaration)
        what = "skipped what it declares to take" if status == SKIPPED else f"returned {status}"
        return Answer(verdict=Verdict.ERRORED, message=what, declaration=declaration)

    def close(self) -> None:
        pass

    def _read(self, result: _Set) -> Answer:
        try:
            return plane_answer(_unpacked(result), self._declaration, 0.0)
        except Unreadable as error:
            message = f"the answer is not a set: {message_of(error)}"
            declaration = self._declaration
            return Answer(verdict=Verdict.ERRORED, message=message, declaration=declaration)
        finally:
            for pointer in (result.sizes, result.is_hole, result.xy):
                self._free(ctypes.cast(pointer, c_void_p))


def library_target(name: str) -> Target:
    try:
        return LibraryTarget(name)
    except (OSError, AttributeError, ValueError) as error:
        return UnloadableTarget(name, message_of(error))


def load_library(name: str) -> tuple[Any, Declaration]:
    """The function of `so:path:function` and its declaration. Raises OSError, AttributeError, or
    ValueError."""
    _, path, function = name.split(":", 2)
    library = ctypes.CDLL(os.path.abspath(path) if os.path.exists(path) else path)
    found = getattr(library, function)
    found.restype = c_int
    found.argtypes = [POINTER(_Set), POINTER(_Set), POINTER(_Set)]
    hello: dict[str, Any] = {}
    if hasattr(library, "minkref_hello"):
        library.minkref_hello.restype = c_char_p
        text = library.minkref_hello()
        hello = json.loads(text.decode()) if text else {}
        if not isinstance(hello, dict):
            raise DeclarationError("minkref_hello gives no JSON object")
    declaration = read_declaration({"name": name, **ADD_ON, **hello, "numbers": "double"}, name)
    if "space" in declaration.capabilities:
        raise DeclarationError("capabilities has space, and a C function is for the plane")
    return found, declaration


def _packed(value: dict[str, Any]) -> _Set:
    rings, holes = [], []
    for polygon in value["polygons"]:
        rings += [polygon["outer"], *polygon["holes"]]
        holes += [0] + [1] * len(polygon["holes"])
    numbers = [number for ring in rings for point in ring for number in point]
    return _Set(
        len(rings),
        (c_int * len(rings))(*(len(ring) for ring in rings)),
        (c_ubyte * len(rings))(*holes),
        (c_double * len(numbers))(*numbers),
    )


def _unpacked(result: _Set) -> dict[str, Any]:
    if result.rings < 0:
        raise Unreadable("a negative number of rings")
    if result.rings == 0:
        return {"polygons": []}
    if not result.sizes or not result.xy:
        raise Unreadable("rings, and no sizes or no coordinates")
    sizes = [result.sizes[k] for k in range(result.rings)]
    if min(sizes) < 1 or sum(sizes) > MOST_VERTICES:
        raise Unreadable("a ring of no vertices, or far too many")
    rings, start = [], 0
    for size in sizes:
        numbers = result.xy[2 * start : 2 * (start + size)]
        rings.append([[numbers[2 * k], numbers[2 * k + 1]] for k in range(size)])
        start += size
    if not result.is_hole:
        return {"rings": rings}
    polygons: list[dict[str, Any]] = []
    for k, ring in enumerate(rings):
        if result.is_hole[k] and polygons:
            polygons[-1]["holes"].append(ring)
        elif result.is_hole[k]:
            raise Unreadable("a hole before any outer ring")
        else:
            polygons.append({"outer": ring, "holes": []})
    return {"polygons": polygons}
