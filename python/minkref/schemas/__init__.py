"""The published JSON schemas of what `--json` prints."""

from __future__ import annotations

import json
from importlib import resources
from typing import Any


def schema(command: str) -> dict[str, Any]:
    """The schema of all that `--json` prints: the document of the command, or a refusal."""
    result, error = result_schema(command), error_schema()
    shared = result.pop("$defs", {})
    top = {"$schema": result.pop("$schema"), "title": result.pop("title")}
    del error["$schema"]
    return {
        **top,
        "oneOf": [{"$ref": "#/$defs/result"}, {"$ref": "#/$defs/error"}],
        "$defs": {"result": result, "error": error, **shared},
    }


def schema_text(command: str) -> str:
    return json.dumps(schema(command), indent=2) + "\n"


def result_schema(command: str) -> dict[str, Any]:
    """The schema of the document of a command that did its work."""
    return _read(command)


def error_schema() -> dict[str, Any]:
    """The schema of a refusal."""
    return _read("error")


def _read(name: str) -> dict[str, Any]:
    text = resources.files(__name__).joinpath(f"{name}.json").read_text(encoding="utf-8")
    value: dict[str, Any] = json.loads(text)
    return value
