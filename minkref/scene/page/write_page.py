"""The page as one HTML file that needs nothing else."""

from __future__ import annotations

from typing import Any

from minkref.output.terminal import escaped
from minkref.page.template import json_for_script, page_template


def page(scene: str, robot: str, data: dict[str, Any]) -> str:
    """Render the file's text. `data`: from `picture`; `scene`, `robot`: names."""
    template, usual = page_template("scene", "sum")
    return template.render(
        scene=escaped(scene), robot=escaped(robot), data=json_for_script(data), **usual
    )
