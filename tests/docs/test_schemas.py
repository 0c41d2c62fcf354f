"""The published schemas stand alone: they refer only to their own definitions."""

from __future__ import annotations

from collections.abc import Iterator
from typing import Any

import pytest
from minkref.schemas import names, result_schema


def references(value: Any) -> Iterator[str]:
    if isinstance(value, dict):
        if isinstance(value.get("$ref"), str):
            yield value["$ref"]
        value = list(value.values())
    if isinstance(value, list):
        for each in value:
            yield from references(each)


@pytest.mark.parametrize("name", names())
def test_each_reference_is_a_definition_by_its_name(name: str) -> None:
    schema = result_schema(name)
    known = {f"#/$defs/{each}" for each in schema["$defs"]}
    assert set(references(schema)) == known  # the generator of the site knows no other form
