"""The published JSON schemas of what `--json` prints."""

from __future__ import annotations

import json
from importlib import resources
from typing import Any

KINDS = ("in_space", "with_disc", "with_disc_pairs", "with_path")


def schema(command: str) -> dict[str, Any]:
    """The schema of all that `--json` prints: the document of the command, in the plane, with a
    disc, with a path or in space, or a refusal."""
    result, error = result_schema(command), error_schema()
    top = {"$schema": result.pop("$schema"), "title": result.pop("title")}
    kinds = {"result": result, "error": error}
    for where in KINDS:
        if _file(f"{command}_{where}").is_file():
            kinds[f"result_{where}"] = result_schema(f"{command}_{where}")
            del kinds[f"result_{where}"]["title"]
    shared: dict[str, Any] = {}
    for kind in kinds.values():
        kind.pop("$schema", None)
        shared |= kind.pop("$defs", {})
    names = ("result", *(f"result_{where}" for where in KINDS), "error")
    return {
        **top,
        "oneOf": [{"$ref": f"#/$defs/{name}"} for name in names if name in kinds],
        "$defs": {**kinds, **shared},
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
    value: dict[str, Any] = json.loads(_file(name).read_text(encoding="utf-8"))
    return value


def _file(name: str) -> Any:
    return resources.files(__name__).joinpath(f"{name}.json")
