"""Texts of indexes, and pictures of sums for notebooks."""

from __future__ import annotations

from typing import Any

from minkref import _core
from minkref.plane.small_picture import places_picture


def show_values() -> None:
    """Give the classes of the extension module their texts and pictures."""
    owner: Any = _core.Sum
    owner._repr_svg_ = _picture_of_sum
    owner = _core.ScaleIndex
    owner.__repr__ = _text_of_index


def _picture_of_sum(value: _core.Sum) -> str:
    try:
        passages = value.tight_passages
    except _core.BadInput:  # an answer of the paper's own program has none
        passages = []
    return places_picture(value, "sum", passages)


def _text_of_index(value: _core.ScaleIndex) -> str:
    low, high = value.window
    return f"<ScaleIndex: scales {low or 0} to {high or 'infinity'}>"
