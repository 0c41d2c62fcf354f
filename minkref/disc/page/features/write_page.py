"""The page as one HTML file that needs nothing else."""

from __future__ import annotations

from typing import Any

from minkref.output.terminal import escaped
from minkref.page.template import json_for_script, page_template


def page(P: str, data: dict[str, Any]) -> str:
    """The text of the file. `data` is what `picture` gives; P is the operand's name."""
    template, usual = page_template("disc", "sum", room="page/features")
    return template.render(P=escaped(P), data=json_for_script(data), **usual)
