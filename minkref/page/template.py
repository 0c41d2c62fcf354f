"""Fills a page: a template, styles and scripts in one file that needs nothing else."""

from __future__ import annotations

import json
from importlib import resources
from typing import Any

from jinja2 import Environment, FunctionLoader, StrictUndefined, Template
from minkref.page.modules import Script
from minkref.version import version


def page_template(
    setting: str, *shared: str, room: str = "page"
) -> tuple[Template, dict[str, str]]:
    """The template of the page in a room of a setting, and what it says of every page: the version,
    the styles, and the script, which is its module `main`. `shared` names styles that are not those
    of all pages, nor of this one alone."""
    environment = Environment(
        loader=FunctionLoader(_text),
        autoescape=True,
        undefined=StrictUndefined,
        trim_blocks=True,
        lstrip_blocks=True,
    )
    folder = f"{setting}/{room}/web"
    styles = [*(f"page/web/{name}.css" for name in ("style", *shared)), f"{folder}/style.css"]
    usual = {
        "version": version(),
        "style": "\n".join(map(_text, styles)),
        "script": Script(_text).text(f"{folder}/main.js"),
    }
    return environment.get_template(f"{folder}/page.html.j2"), usual


def _text(path: str) -> str:
    """The text of a file of the package."""
    return (resources.files("minkref") / path).read_text(encoding="utf-8")


def json_for_script(value: dict[str, Any]) -> str:
    """JSON that cannot end the element that it stands in."""
    return json.dumps(value, separators=(",", ":"), allow_nan=False).replace("<", "\\u003c")
