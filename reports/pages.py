"""Parts that all pages share: escaping templates, a frame, a style."""

from __future__ import annotations

from importlib import resources

from jinja2 import Environment, FunctionLoader, StrictUndefined
from markupsafe import Markup
from minkref.output.terminal import escaped

ROOM = "minkref.reports"


def environment(room: str) -> Environment:
    """Templates from a room of `reports/`, and shared templates: `base.html.j2`, `style.css`.
    Filters: `drawn`, an SVG element unchanged; `number`, with commas; `line`, without control
    characters."""
    folders = [resources.files(f"{ROOM}.{room}") / "templates", resources.files(ROOM) / "templates"]

    def load(name: str) -> str | None:
        files = [folder / name for folder in folders]
        return next((f.read_text(encoding="utf-8") for f in files if f.is_file()), None)

    found = Environment(
        loader=FunctionLoader(load),
        autoescape=True,
        undefined=StrictUndefined,
        trim_blocks=True,
        lstrip_blocks=True,
    )
    found.filters["drawn"] = lambda picture: Markup(picture)
    found.filters["number"] = lambda number: f"{number:,}"
    found.filters["line"] = lambda text: escaped(str(text))
    return found
