"""Texts of convex sums."""

from __future__ import annotations

from typing import Any

from minkref import _core


def show_values() -> None:
    """Give the class of the extension module its text."""
    owner: Any = _core.ConvexSum
    owner.__repr__ = _text_of_sum


def _text_of_sum(value: _core.ConvexSum) -> str:
    return repr(_core.ConvexPolyhedron(value.surface)).replace("ConvexPolyhedron", "ConvexSum")
