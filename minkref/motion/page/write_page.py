"""The page as one HTML file that needs nothing else."""

from __future__ import annotations

from typing import Any

from minkref.output.terminal import escaped
from minkref.page.template import json_for_script, page_template


def page(part: str, obstacles: str, path: str, valid: str, data: dict[str, Any]) -> str:
    """The text of the file. `data` is what `picture` gives, `valid` the valid scales in words; the
    others are names."""
    template, usual = page_template("motion", "sum")
    names = {"part": escaped(part), "obstacles": escaped(obstacles), "path": escaped(path)}
    return template.render(**names, valid=valid, data=json_for_script(data), **usual)
