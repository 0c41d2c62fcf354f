"""Pairs of operands for indexing; builds, questions and refusals through the command line."""

from __future__ import annotations

from collections.abc import Callable
from fractions import Fraction
from pathlib import Path
from typing import Any

import jsonschema
import pytest
from minkref import _core
from minkref.plane.operand import read_operand
from minkref.schemas import error_schema, result_schema
from pairs_of_texts import ISLANDS, RING_OF_SQUARES, SEVERAL_COMPONENTS, TRIANGLE

Minkref = Callable[..., Any]
Window = tuple[str | None, str | None]

U = "POLYGON((0 0,3 0,3 2,2 2,2 1,1 1,1 2,0 2,0 0))"

# Models, or sets as text.
PAIRS = {
    "letters": ("g1", "g2"),
    "right angles": ("g3", "g1"),
    "convex": ("disc1", "g1"),
    # A hole dies at 541/186, without a pair event.
    "dying hole": (
        "POLYGON((-3 -2,4 -1,1 3,-3 -2))",
        "POLYGON((-40 -40,40 -40,40 40,-40 40,-40 -40),(0 20,-19 -9,17 -11,0 20))",
    ),
    "islands": ISLANDS,
    "several components": SEVERAL_COMPONENTS,
    "touching components": (RING_OF_SQUARES, TRIANGLE),
    "touching components second": (TRIANGLE, RING_OF_SQUARES),
    "hole that touches its outer ring": (
        "POLYGON((0 0,2 0,2 1,1 1,1 2,0 2,0 0))",
        "POLYGON((0 0,12 0,12 12,0 12,0 0),(0 0,3 8,8 3,0 0))",
    ),
}
SEVERAL = pytest.mark.parametrize("name", PAIRS)
SUM = ("digest", "area", "area_approximate", "components", "holes", "vertices")
THIN = {"empty": "POLYGON EMPTY", "point": "POINT(1 2)", "segment": "LINESTRING(0 0,3 1)"}


def written(folder: Path, name: str, operand: str) -> str:
    """The operand as the command line names it."""
    if operand.isalnum():
        return operand
    path = folder / f"{name}.wkt"
    path.write_text(operand, encoding="utf-8")
    return str(path)


def operands(folder: Path, name: str) -> tuple[str, str]:
    P, Q = PAIRS[name]
    return written(folder, "P", P), written(folder, "Q", Q)


def window_options(window: Window) -> list[str]:
    options = zip(("--from", "--to"), window, strict=True)
    return [text for option, scale in options if scale is not None for text in (option, scale)]


def build(minkref: Minkref, path: Path, P: str, Q: str, *options: str) -> Any:
    """The document of a successful build."""
    ran = minkref("index", P, Q, "-o", path, "--json", *options)
    assert (ran.code, ran.err) == (0, "")
    jsonschema.validate(ran.json, result_schema("index"))
    return ran.json


def ask(minkref: Minkref, command: str, *arguments: str | Path) -> Any:
    """The document of a successful command."""
    ran = minkref(command, *arguments, "--json")
    assert (ran.code, ran.err) == (0, ""), ran.err or ran.out
    return ran.json


def event_scales(P: str, Q: str, kind: str = "boundary") -> list[str]:
    """The distinct event scales by dynamic update."""
    dynamic = _core.DynamicSum(read_operand(P).set, read_operand(Q).set)
    rows: list[Any] = list(
        dynamic.boundary_events() if kind == "boundary" else dynamic.topology_events()
    )
    return list(dict.fromkeys(row[0] for row in rows))


def between(a: str, b: str) -> str:
    return str((Fraction(a) + Fraction(b)) / 2)


def told(minkref: Minkref, *arguments: str | Path) -> dict[str, Any]:
    value = ask(minkref, "sum", *arguments)
    return {name: value[name] for name in (*SUM, "scale", "tight_passages", "result")}


def account(value: Any, names: bool = True) -> Any:
    """The part of an answer that two routes must share. Feature names belong to a window: for
    another window lives are told without `names`."""
    of_topology = ("feature", "before", "after", "parts") if names else ("feature", "parts")
    fields = ("s", "rank", "kind", "change")
    if value["kind"] == "topology":
        fields += of_topology
    lives = [
        sorted(
            ([life["id"]] if names else []) + [str(life["birth"]), str(life["death"])]
            for life in value[kind] or []
        )
        for kind in ("holes", "components")
    ]
    return (
        value["from"],
        value["to"],
        value["count"],
        value["distinct"],
        value["segments"],
        [[event[field] for field in fields] for event in value["events"]],
        lives,
    )


def refused(minkref: Minkref, folder: Path, *arguments: str | Path) -> Any:
    """The text and the document of a refusal that writes nothing."""
    before = {path: path.read_bytes() for path in folder.rglob("*") if path.is_file()}
    ran = minkref(*arguments)
    assert (ran.code, ran.out) == (2, ""), ran.out
    assert "fix:" in ran.err
    document = minkref(*arguments, "--json")
    assert document.code == 2
    jsonschema.validate(document.json, error_schema())
    assert {path: path.read_bytes() for path in folder.rglob("*") if path.is_file()} == before
    return ran.err, document.json["error"]
