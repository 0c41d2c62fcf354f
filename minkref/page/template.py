"""Fills a page: a template, styles and scripts of one folder, and the script that all pages share,
in one file that needs nothing else."""

from __future__ import annotations

import json
from collections.abc import Iterable
from importlib import resources
from typing import Any

from jinja2 import Environment, StrictUndefined, Template
from minkref.version import version


def page_template(
    package: str, scripts: Iterable[str], styles: Iterable[str] = ("style",)
) -> tuple[Template, dict[str, str]]:
    """The template in the folder `web` of the package, and what it says of every page: the
    version, the styles, and the scripts in their order. A name with a slash is of another page:
    `plane/axis` is the script axis.js of the page in the plane."""
    folder = resources.files(package) / "web"

    def text(name: str) -> str:
        setting, _, file = name.rpartition("/")
        where = resources.files(f"minkref.{setting}.page") / "web" if setting else folder
        return (where / file).read_text(encoding="utf-8")

    environment = Environment(
        autoescape=True, undefined=StrictUndefined, trim_blocks=True, lstrip_blocks=True
    )
    shared = (resources.files(__package__) / "web" / "shared.js").read_text(encoding="utf-8")
    script = "\n".join([shared, *(text(f"{name}.js") for name in scripts)])
    style = "\n".join(text(f"{name}.css") for name in styles)
    usual = {"version": version(), "style": style, "script": script}
    return environment.from_string(text("page.html.j2")), usual


def json_for_script(value: dict[str, Any]) -> str:
    """JSON that cannot end the element that it stands in."""
    return json.dumps(value, separators=(",", ":"), allow_nan=False).replace("<", "\\u003c")
