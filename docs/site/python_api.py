"""The Python interface, by static analysis: which names `import minkref` offers, and where each is
defined."""

from __future__ import annotations

from pathlib import Path

import griffe

PAGE = Path("api/python.md")
OPTIONS = "    options:\n      heading: minkref.{name}\n      toc_label: {name}\n"


def page(package: Path) -> str:
    """For mkdocstrings. `package` holds the checkout as the package `minkref`."""
    minkref = griffe.load("minkref", search_paths=[package], allow_inspection=False)
    text = (
        "# The Python package\n\n`import minkref` offers these names. Numbers are texts `n` or "
        "`n/d`, or `int` and `Fraction` of Python. [The tutorial](../docs/tutorials/python.md) "
        "shows them at work; strategies for Hypothesis have "
        "[a page of their own](../docs/strategies.md).\n"
    )
    for name in minkref.exports or []:
        where = _defined(minkref, str(name))
        text += f"\n::: {where}\n{OPTIONS.format(name=name)}"
    return text


def _defined(package: griffe.Module, name: str) -> str:
    """The path of the class or function that a name of the package stands for:
    `PolygonSet = _core.PolygonSet` is documented where `_core` has it."""
    target = package[name]
    if target.is_alias:
        target = target.final_target
    if target.is_module:  # `from minkref.version import version`
        target = target[name]
    if target.is_attribute and str(target.value).startswith("_core."):
        target = package[str(target.value)]
    return str(target.canonical_path)
