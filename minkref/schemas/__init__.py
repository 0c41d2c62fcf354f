"""The published JSON schemas of what `--json` prints. Each is made of the type of its document."""

from __future__ import annotations

import json
from typing import Any

KINDS = (
    "at_scale",
    "in_space",
    "of_features",
    "of_scene",
    "with_ball",
    "with_bracket",
    "with_clearance",
    "with_disc",
    "with_disc_pairs",
    "with_path",
)


def schema(command: str) -> dict[str, Any]:
    """The schema of all that `--json` prints: the document of the command, in the plane, with a
    disc, with a path, in space or for a scene, or a refusal."""
    result, error = result_schema(command), error_schema()
    top = {"$schema": result.pop("$schema"), "title": result.pop("title")}
    kinds = {"result": result, "error": error}
    for where in KINDS:
        if f"{command}_{where}" in names():
            kinds[f"result_{where}"] = result_schema(f"{command}_{where}")
            del kinds[f"result_{where}"]["title"]
    shared: dict[str, Any] = {}
    for kind in kinds.values():
        kind.pop("$schema", None)
        shared |= kind.pop("$defs", {})
    ordered = ("result", *(f"result_{where}" for where in KINDS), "error")
    return {
        **top,
        "oneOf": [{"$ref": f"#/$defs/{name}"} for name in ordered if name in kinds],
        "$defs": {**kinds, **shared},
    }


def schema_text(command: str) -> str:
    return json.dumps(schema(command), indent=2) + "\n"


def result_schema(name: str) -> dict[str, Any]:
    """The schema of the document of a command that did its work."""
    from minkref.schemas.documents import DOCUMENTS
    from minkref.schemas.make import made

    return made(DOCUMENTS[name])


def error_schema() -> dict[str, Any]:
    """The schema of a refusal."""
    return result_schema("error")


def names() -> tuple[str, ...]:
    """All documents, by the command and the kind of its operands."""
    from minkref.schemas.documents import DOCUMENTS

    return tuple(DOCUMENTS)
