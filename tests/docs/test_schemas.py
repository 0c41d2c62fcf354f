"""The published schemas stand alone: they refer only to their own definitions."""

from __future__ import annotations

import json
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import pytest

SCHEMAS = sorted((Path(__file__).resolve().parents[2] / "minkref/schemas").glob("*.json"))


def references(value: Any) -> Iterator[str]:
    if isinstance(value, dict):
        if isinstance(value.get("$ref"), str):
            yield value["$ref"]
        value = list(value.values())
    if isinstance(value, list):
        for each in value:
            yield from references(each)


@pytest.mark.parametrize("path", SCHEMAS, ids=lambda path: path.stem)
def test_each_reference_is_a_definition_by_its_name(path: Path) -> None:
    schema = json.loads(path.read_text(encoding="utf-8"))
    known = {f"#/$defs/{name}" for name in schema.get("$defs", {})}
    assert set(references(schema)) <= known  # the generator of the site knows no other form
