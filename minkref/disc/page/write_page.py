"""The page as one HTML file that needs nothing else."""

from __future__ import annotations

from typing import Any

from minkref.output.terminal import escaped
from minkref.page.template import json_for_script, page_template

SCRIPTS = (
    "plane/numbers", "plane/colours", "plane/canvas", "data", "plane/svg", "plane/axis", "rings",
    "history", "skeleton", "texts", "drawing", "marks", "plane/strip", "plane/barcode", "events",
    "plane/pointer", "plane/controls", "main",
)  # fmt: skip
STYLES = ("plane/style", "style")


def page(P: str, data: dict[str, Any]) -> str:
    """The text of the file. `data` is what `picture` gives; P is the operand's name."""
    template, usual = page_template("minkref.disc.page", SCRIPTS, STYLES)
    return template.render(P=escaped(P), data=json_for_script(data), **usual)
