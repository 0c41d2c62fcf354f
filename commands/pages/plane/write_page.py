"""The page as one HTML file that needs nothing else."""

from __future__ import annotations

from typing import Any

from minkref.commands.pages.template import json_for_script, page_template
from minkref.terminal import escaped

SCRIPTS = (
    "numbers", "timeline", "canonical", "svg", "axis", "texts", "colours", "canvas", "drawing",
    "inputs", "marks", "strip", "paper", "barcode", "events", "pointer", "controls", "main",
)  # fmt: skip


def page(P: str, Q: str, data: dict[str, Any]) -> str:
    """The text of the file. `data` is what `picture` gives; P and Q are the operands' names."""
    template, usual = page_template("minkref.commands.pages.plane", SCRIPTS)
    return template.render(P=escaped(P), Q=escaped(Q), data=json_for_script(data), **usual)
