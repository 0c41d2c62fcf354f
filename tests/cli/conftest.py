"""The command line, run in this process."""

from __future__ import annotations

import io
import json
import shutil
from collections.abc import Callable, Iterator
from contextlib import redirect_stdout
from dataclasses import dataclass
from functools import cache
from pathlib import Path
from typing import Any

import jsonschema
import pytest
from minkref.cli.cli import run
from minkref.schemas import error_schema, schema

pytest.register_assert_rewrite("index_runs")


@dataclass
class Ran:
    code: int
    out: str
    err: str

    @property
    def json(self) -> Any:
        return json.loads(self.out)


Minkref = Callable[..., Ran]


@pytest.fixture(scope="session", autouse=True)
def schemas_checked_once() -> Iterator[None]:
    """To check a schema takes longer than to validate a document by it."""
    kind = jsonschema.Draft202012Validator
    check, checked = kind.check_schema, set[str]()

    def once(schema: Any, *words: Any, **options: Any) -> None:
        text = json.dumps(schema)
        if text not in checked:
            check(schema, *words, **options)
            checked.add(text)

    with pytest.MonkeyPatch.context() as patch:
        patch.setattr(kind, "check_schema", once)
        yield


@pytest.fixture
def minkref(capsys: pytest.CaptureFixture[str]) -> Minkref:
    def call(*arguments: str | Path) -> Ran:
        code = run([str(argument) for argument in arguments])
        captured = capsys.readouterr()
        if "--json" in arguments and captured.out.startswith("{"):
            follow_schema(json.loads(captured.out))
        return Ran(code, captured.out, captured.err)

    return call


def follow_schema(document: dict[str, Any]) -> None:
    """Raises where a document does not follow the published schema of its command."""
    _validator("error" if "error" in document else document["command"]).validate(document)


@cache
def _validator(name: str) -> Any:
    return jsonschema.Draft202012Validator(error_schema() if name == "error" else schema(name))


def wkt_square(x: int, y: int, side: int) -> str:
    return f"POLYGON(({x} {y},{x + side} {y},{x + side} {y + side},{x} {y + side},{x} {y}))"


@pytest.fixture
def squares(tmp_path: Path) -> tuple[Path, Path]:
    """Two squares, with sides 2 and 1."""
    first, second = tmp_path / "two.wkt", tmp_path / "one.wkt"
    first.write_text(wkt_square(0, 0, 2), encoding="utf-8")
    second.write_text(wkt_square(0, 0, 1), encoding="utf-8")
    return first, second


@pytest.fixture(scope="session")
def kept_letters(tmp_path_factory: pytest.TempPathFactory) -> Path:
    path = tmp_path_factory.mktemp("kept") / "letters.index"
    with redirect_stdout(io.StringIO()):
        assert run(["index", "g1", "g2", "--from", "1/4", "--to", "4", "-o", str(path)]) == 0
    return path


@pytest.fixture
def letters(kept_letters: Path, tmp_path: Path) -> Path:
    """The index of g1 and g2 at the scales from 1/4 to 4."""
    return Path(shutil.copy(kept_letters, tmp_path))
