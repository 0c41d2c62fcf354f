"""A C function of a shared library (minkref_adapter.h), called with sets and lines in the plane."""

from __future__ import annotations

import ctypes
import json
import os
from collections.abc import Callable
from ctypes import POINTER, Structure, c_char_p, c_double, c_int, c_ubyte, c_void_p
from typing import Any

from adapter_protocol import Errored, Rejected, Set, Sum  # type: ignore[import-not-found,unused-ignore]

RESULT, SKIPPED, REJECTED = 0, 1, 2
MOST_VERTICES = 50_000_000
WITH_MANNER = {
    "line-offset", "join-mitre", "join-bevel", "join-square", "join-sharp", "cap-flat",
    "cap-square",
}  # fmt: skip
WORDS = ("round", "mitre", "bevel", "square", "sharp", "flat")  # MINKREF_ROUND and so on
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


class _Manner(Structure):
    _fields_ = (("are_lines", c_int), ("join", c_int), ("limit", c_double), ("cap", c_int))


def load(path: str, name: str) -> tuple[dict[str, Any], Sum]:
    """Returns the declaration from `minkref_hello`, completed, and a function that answers by the C
    function. Raises OSError, AttributeError, ValueError or Errored."""
    library = ctypes.CDLL(os.path.abspath(path) if os.path.exists(path) else path)
    found = getattr(library, name)
    found.restype = c_int
    hello: dict[str, Any] = {}
    if hasattr(library, "minkref_hello"):
        library.minkref_hello.restype = c_char_p
        text = library.minkref_hello()
        hello = json.loads(text.decode()) if text else {}
        if not isinstance(hello, dict):
            raise Errored("its declaration: minkref_hello does not give a JSON object")
    declared = {**ADD_ON, **hello, "numbers": "double"}
    able = declared["capabilities"]
    if isinstance(able, list) and "space" in able:
        raise Errored("its declaration: capabilities has space, and a C function is for the plane")
    if isinstance(able, list) and "features" in able:
        raise Errored("its declaration: capabilities has features, and a C function gives sets")
    joins = isinstance(able, list) and not WITH_MANNER.isdisjoint(map(str, able))
    return declared, _answering(found, joins)


def _answering(function: Callable[..., int], joins: bool) -> Sum:
    """Answers sums; its attribute `answered` offsets and unions. `joins`: whether the function
    takes a manner of offsets."""
    free = ctypes.CDLL(None).free
    free.argtypes = [c_void_p]

    def sum_of(sP: Set, Q: Set) -> dict[str, Any]:
        return called(ctypes.byref(_packed(sP)), ctypes.byref(_packed(Q)))

    def answered(*given: Any) -> dict[str, Any]:
        if len(given) > 1:
            manner = _manner("lines" in given[0], *given[2:])
            how = (ctypes.byref(manner),) if joins else ()
            return called(ctypes.byref(_packed(given[0])), c_double(given[1]), *how)
        sets = [_packed(each) for each in given[0]]
        return called((_Set * len(sets))(*sets), c_int(len(sets)))

    def called(*arguments: Any) -> dict[str, Any]:
        result = _Set()
        status = function(*arguments, ctypes.byref(result))
        if status == RESULT:
            try:
                return _unpacked(result)
            finally:
                for pointer in (result.sizes, result.is_hole, result.xy):
                    free(ctypes.cast(pointer, c_void_p))
        if status == REJECTED:
            raise Rejected("rejected")
        what = "skipped what it declares to take" if status == SKIPPED else f"returned {status}"
        raise Errored(what)

    sum_of.answered = answered  # type: ignore[attr-defined]
    return sum_of


def _no_set(what: str) -> Exception:
    error: Exception = Errored(f"the answer is not a set: {what}")
    return error


def _manner(are_lines: bool, how: Set | None = None) -> _Manner:
    join, cap = ((how or {}).get(word, "round") for word in ("join", "cap"))
    limit = (how or {}).get("limit", 0.0)
    return _Manner(are_lines, WORDS.index(join), limit, WORDS.index(cap))


def _packed(value: Set) -> _Set:
    rings, holes = list(value.get("lines", ())), [0] * len(value.get("lines", ()))
    for polygon in value.get("polygons", ()):
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
        raise _no_set("a negative number of rings")
    if result.rings == 0:
        return {"polygons": []}
    if not result.sizes or not result.xy:
        raise _no_set("rings, and no sizes or no coordinates")
    sizes = [result.sizes[k] for k in range(result.rings)]
    if min(sizes) < 1 or sum(sizes) > MOST_VERTICES:
        raise _no_set("a ring of no vertices, or far too many")
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
            raise _no_set("a hole before any outer ring")
        else:
            polygons.append({"outer": ring, "holes": []})
    return {"polygons": polygons}
