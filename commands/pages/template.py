"""What a page is filled into: a template, styles and scripts of one folder, and the script that all
pages share, in one file that needs nothing else."""

from __future__ import annotations

import json
from collections.abc import Iterable
from importlib import resources
from typing import Any

from jinja2 import Environment, StrictUndefined, Template
from minkref.version import version


def page_template(package: str, scripts: Iterable[str]) -> tuple[Template, dict[str, str]]:
    """The template in the folder `page` of the package, and what it says of every page: the
    version, the style, and the scripts in their order."""
    folder = resources.files(package) / "page"
    shared = resources.files("minkref.commands.pages") / "page" / "shared.js"

    def text(name: str) -> str:
        return (folder / name).read_text(encoding="utf-8")

    environment = Environment(
        autoescape=True, undefined=StrictUndefined, trim_blocks=True, lstrip_blocks=True
    )
    own = (text(f"{name}.js") for name in scripts)
    script = "\n".join([shared.read_text(encoding="utf-8"), *own])
    usual = {"version": version(), "style": text("style.css"), "script": script}
    return environment.from_string(text("page.html.j2")), usual


def json_for_script(value: dict[str, Any]) -> str:
    """JSON that cannot end the element that it stands in."""
    return json.dumps(value, separators=(",", ":"), allow_nan=False).replace("<", "\\u003c")
