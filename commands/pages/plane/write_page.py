"""The page as one HTML file that needs nothing else."""

from __future__ import annotations

import json
from importlib import resources
from typing import Any

from jinja2 import Environment, StrictUndefined
from minkref.terminal import escaped
from minkref.version import version

SCRIPTS = (
    "timeline", "canonical", "axis", "texts", "colours", "canvas", "drawing", "inputs", "strip",
    "barcode", "events", "main",
)  # fmt: skip


def page(P: str, Q: str, data: dict[str, Any]) -> str:
    """The text of the file. `data` is what `picture` gives; P and Q are the operands' names."""
    folder = resources.files("minkref.commands.pages.plane") / "page"

    def text(name: str) -> str:
        return (folder / name).read_text(encoding="utf-8")

    environment = Environment(
        autoescape=True, undefined=StrictUndefined, trim_blocks=True, lstrip_blocks=True
    )
    return environment.from_string(text("page.html.j2")).render(
        P=escaped(P),
        Q=escaped(Q),
        version=version(),
        style=text("style.css"),
        script="\n".join(text(f"{name}.js") for name in SCRIPTS),
        data=_for_script(data),
    )


def _for_script(data: dict[str, Any]) -> str:
    """JSON that cannot end the element that it stands in."""
    return json.dumps(data, separators=(",", ":"), allow_nan=False).replace("<", "\\u003c")
