"""The general solutions as functions of numbers, from the file that the derivation leaves.

`solutions.json` holds polynomials with integer coefficients as texts, a version, and the SHA-256 of
the deriving code. It is no source: `python3 -m symbolic derive` makes it again.
"""

from __future__ import annotations

import ast
import hashlib
import json
from collections.abc import Callable, Sequence
from functools import cache
from importlib import import_module
from pathlib import Path
from typing import Any

from .rational import Rational

VERSION = "symbolic-solutions-v1"
FOLDER = Path(__file__).resolve().parent
FILE = FOLDER / "solutions.json"
DERIVATIONS = ("derive_plane", "space.derive_space", "disc.derive_disc", "disc.derive_diagram")

Solution = Callable[..., tuple[Rational, Rational]]
ALLOWED = (ast.Expression, ast.BinOp, ast.UnaryOp, ast.Name, ast.Load, ast.Constant, ast.Add)
ALLOWED += (ast.Sub, ast.Mult, ast.Pow, ast.USub, ast.UAdd)  # type: ignore[assignment]


class SolutionsError(RuntimeError):
    """The file of general solutions is absent, stale or holds something else."""


def code_digest() -> str:
    """SHA-256 of the code that derives the solutions."""
    sources = (FOLDER / f"{name.replace('.', '/')}.py" for name in DERIVATIONS)
    return hashlib.sha256(b"\0".join(source.read_bytes() for source in sources)).hexdigest()


def derive() -> dict[str, Any]:
    """The document of all general solutions, derived afresh by sympy. Exact; half a minute."""
    found: dict[str, Any] = {}
    for name in DERIVATIONS:
        found |= import_module(f".{name}", __package__).solutions()
    return {"version": VERSION, "code": code_digest(), "solutions": found}


def write(document: dict[str, Any], path: Path = FILE) -> None:
    """Writes the document whole or not at all."""
    part = path.with_suffix(".part")
    part.write_text(json.dumps(document, indent=1) + "\n", encoding="utf-8")
    part.replace(path)


def read(path: Path = FILE) -> dict[str, Any]:
    """The solutions by name. Raises SolutionsError if they are not those of the code beside."""
    try:
        document = json.loads(path.read_text(encoding="utf-8"))
    except (OSError, ValueError) as error:
        raise SolutionsError(
            f"{path.name}: {error}; make it by `python3 -m symbolic derive`"
        ) from (error)
    if document.get("version") != VERSION or document.get("code") != code_digest():
        raise SolutionsError(
            f"{path.name} is of another version of the derivation; make it again by"
            " `python3 -m symbolic derive`"
        )
    found: dict[str, Any] = document["solutions"]
    return found


@cache
def all_solutions() -> dict[str, Any]:
    return read()


def compiled(polynomials: Sequence[str], arguments: Sequence[str]) -> Callable[..., Any]:
    """A function of `arguments` that gives the values of polynomials with integer coefficients,
    exact for exact numbers. Raises SolutionsError for a text that is no such polynomial."""
    for polynomial in polynomials:
        for node in ast.walk(ast.parse(polynomial, mode="eval")):
            known = isinstance(node, ALLOWED)
            if isinstance(node, ast.Constant):
                known = type(node.value) is int
            elif isinstance(node, ast.Name):
                known = node.id in arguments
            if not known:
                raise SolutionsError(f"{polynomial[:60]!r} is no polynomial in {arguments}")
    code = f"lambda {', '.join(arguments)}: ({', '.join(polynomials)},)"
    function: Callable[..., Any] = eval(code, {"__builtins__": {}})
    return function


@cache
def solution(name: str, letters: str) -> Solution:
    """Numerator and denominator of the scale of that name, as a function of six numbers for each
    letter, in the order of MovingSegment."""
    found = all_solutions()[name]
    arguments = [f"{letter}{i}" for letter in letters for i in range(6)]
    return compiled((found["numerator"], found["denominator"]), arguments)


def branch(numerator: Rational, denominator: Rational) -> tuple[str, Rational | None]:
    """The solutions s > 0 of denominator s = numerator: once, and where; always; or never."""
    if denominator == 0:
        return ("always" if numerator == 0 else "never"), None
    s = numerator / denominator
    return ("once", s) if s > 0 else ("never", None)


def root(numerator: Rational, denominator: Rational) -> list[Rational]:
    """The isolated solutions of denominator s = numerator: none if the denominator is zero,
    whether no scale solves it (numerator not zero) or all do."""
    return [] if denominator == 0 else [numerator / denominator]
