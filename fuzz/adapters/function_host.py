"""A function as a program that speaks the adapter protocol: `function_host.py py MODULE FUNCTION`
or `function_host.py so LIBRARY FUNCTION`.

The program runs in minkref's own interpreter and imports nothing of minkref. After reading its own
modules it moves them out of the way, also for processes that the function starts: the function's
modules may have any names.
"""

from __future__ import annotations

import importlib
import json
import os
import sys
from collections.abc import Callable
from typing import Any

HERE = os.path.dirname(os.path.realpath(__file__))
if __name__ == "__main__" and not sys.flags.safe_path:
    del sys.path[0]  # the folder of this program
sys.path.insert(0, HERE)

from adapter_protocol import Errored, Rejected, Set, Skipped, Sum, serve, streams, told  # type: ignore[import-not-found,unused-ignore] # noqa: E402

sys.path.remove(HERE)
PROTOCOL = sys.modules.pop("adapter_protocol")
MEMBERS = (
    "polygons",
    "rings",
    "components",
    "vertices",
    "faces",
    "bars",
    "bridges",
    "holes",
)  # of a result


def python_function(module: str, name: str) -> tuple[dict[str, Any], Sum]:
    """Returns the function's declaration, from its attribute `minkref`, and a function that answers
    by it. Finds modules in the current folder. Raises Errored, and exceptions from the import."""
    here = os.getcwd()
    sys.path.insert(0, here)
    try:
        function = getattr(importlib.import_module(module), name)
    finally:
        sys.path.remove(here)
        if here not in sys.path:
            sys.path.append(here)  # for later imports by the module; shadows nothing
    if not callable(function):
        raise TypeError(f"{name} is not a function")
    declared = getattr(function, "minkref", {})
    if not isinstance(declared, dict):
        raise Errored("its declaration: the attribute minkref is not a dictionary")
    try:
        json.dumps(declared)
    except (TypeError, ValueError) as error:
        raise Errored(f"its declaration: {told(error)}") from error
    return declared, answering(function)


def other_verbs(declared: dict[str, Any], sum_of: Any) -> dict[str, Any]:
    """A function that declares no sums answers what it declares instead: `offset` or `features`,
    from P and the radius, or `union`, from the sets. Keywords of `serve`."""
    able = declared.get("capabilities", [])
    if declared.get("sum") != "none":
        return {}
    for word, verb in (("offset",) * 2, ("join-sharp", "offset"), ("features",) * 2):
        if word in able:
            return {f"{verb}_of": lambda P, radius, *how: sum_of.answered(P, radius, *how)}
    return {"union_of": lambda sets: sum_of.answered(sets)} if "union" in able else {}


def answering(function: Callable[..., Any]) -> Sum:
    """Answers sums by the Python function, which may change its operands: each call gets new
    copies."""
    kept: list[Any] = [None, "null"]  # the last Q, and its text

    def sum_of(sP: Set, Q: Set) -> dict[str, Any]:
        if kept[0] is not Q:
            kept[:] = Q, json.dumps(Q)
        return answered(sP, json.loads(kept[1]))

    def answered(*given: Any) -> dict[str, Any]:
        try:
            found = function(*given)
        except ValueError as error:
            raise Rejected(told(error)) from error
        if found is None:
            raise Skipped("the function returned None")
        if not isinstance(found, dict):
            raise TypeError(f"it returned {type(found).__name__}, not a dictionary")
        return {word: found[word] for word in MEMBERS if word in found}

    sum_of.answered = answered  # type: ignore[attr-defined]
    return sum_of


def c_function(library: str, name: str) -> tuple[dict[str, Any], Sum]:
    """Returns a C function's declaration, and a function that answers by it."""
    sys.path.insert(0, HERE)
    sys.modules["adapter_protocol"] = PROTOCOL
    from c_function import load  # type: ignore[import-not-found,unused-ignore]

    declared, sum_of = load(library, name)
    return declared, sum_of


def loaded(kind: str, place: str, name: str) -> tuple[dict[str, Any], Sum]:
    """Returns the answer to `hello`, which says why no function exists, and the answering
    function."""
    try:
        if kind == "so":
            return c_function(place, name)
        return python_function(place, name)
    except BaseException as error:  # noqa: BLE001 a module may do anything on import
        why = str(error) if isinstance(error, Errored) else told(error)

    def nothing(sP: Set, Q: Set) -> dict[str, Any]:
        raise Errored(why)

    return {"status": "errored", "reason": why}, nothing


def main(kind: str, place: str, name: str) -> None:
    sys.set_int_max_str_digits(0)
    wires = streams()
    declared, sum_of = loaded(kind, place, name)
    serve(declared, sum_of, wires, **other_verbs(declared, sum_of))


if __name__ == "__main__":
    main(*sys.argv[1:4])
