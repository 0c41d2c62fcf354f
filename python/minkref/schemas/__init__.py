"""The published JSON schemas of what `--json` prints."""

from __future__ import annotations

import json
from importlib import resources
from typing import Any


def schema_text(command: str) -> str:
    return resources.files(__name__).joinpath(f"{command}.json").read_text(encoding="utf-8")


def schema(command: str) -> dict[str, Any]:
    value: dict[str, Any] = json.loads(schema_text(command))
    return value
