"""The page as one HTML file that needs nothing else."""

from __future__ import annotations

from typing import Any

from minkref.output.terminal import escaped
from minkref.page.template import json_for_script, page_template

SCRIPTS = (
    "numbers", "timeline", "canonical", "svg", "axis", "texts", "colours", "canvas", "drawing",
    "inputs", "marks", "strip", "paper", "barcode", "events", "pointer", "controls", "main",
)  # fmt: skip


def page(P: str, Q: str, data: dict[str, Any]) -> str:
    """The text of the file. `data` is what `picture` gives; P and Q are the operands' names."""
    template, usual = page_template("minkref.plane.page", SCRIPTS)
    return template.render(P=escaped(P), Q=escaped(Q), data=json_for_script(data), **usual)
