"""The command line, run in this process, as in tests/cli."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import jsonschema
import pytest
from minkref.cli.cli import run
from minkref.schemas import schema


@dataclass
class Ran:
    code: int
    out: str
    err: str


@pytest.fixture
def minkref(capsys: pytest.CaptureFixture[str]) -> Callable[..., Ran]:
    def call(*arguments: str | Path) -> Ran:
        code = run([str(argument) for argument in arguments])
        captured = capsys.readouterr()
        return Ran(code, captured.out, captured.err)

    return call


@pytest.fixture
def repaired(minkref: Callable[..., Ran]) -> Callable[..., dict[str, Any]]:
    """Returns a repair's document; checks the schema."""
    import json

    published = schema("repair")

    def call(*arguments: str | Path) -> dict[str, Any]:
        ran = minkref("repair", *arguments, "--json")
        value: dict[str, Any] = json.loads(ran.out)
        jsonschema.validate(value, published)
        assert ran.code == 0, value
        return value

    return call
