"""An operand of the command line: a file, or the name of a model, read exactly and validated."""

from __future__ import annotations

import difflib
from dataclasses import dataclass, field
from pathlib import Path

from minkref import _core
from minkref.errors import Refusal, refusing
from minkref.model_catalogue import PAPER_MODELS, VARIABLE, all_models

FORMATS = (".wkt", ".geojson", ".poly", ".json")


@dataclass(frozen=True)
class Operand:
    name: str
    source: str
    set: _core.PolygonSet
    warnings: list[str] = field(default_factory=list)


def read_operand(name: str) -> Operand:
    """A file wins over a model of the same name. Refuses what does not exist or is not valid."""
    path = Path(name)
    if path.is_file():
        return _read(name, path)
    models = all_models()
    if name in models:
        return _read(name, models[name].path)
    if path.is_dir():
        raise Refusal("this is a folder", name, "name a file or a model", "not-a-file")
    if path.suffix in FORMATS or len(path.parts) > 1:
        raise Refusal("there is no such file", name, "check the path", "no-such-file")
    if name in {paper for paper, *_ in PAPER_MODELS}:
        alike = next(look for paper, _, look, _ in PAPER_MODELS if paper == name)
        raise Refusal(
            "this model of the paper does not ship with minkref",
            name,
            f"set {VARIABLE} to the folder that holds it, or take our look-alike {alike}",
            "no-such-model",
        )
    near = difflib.get_close_matches(name, list(models), n=1)
    hint = f"did you mean {near[0]}? " if near else ""
    raise Refusal(
        "there is neither a file nor a model of this name",
        name,
        f"{hint}`minkref models` lists the models",
        "no-such-model",
    )


def _read(name: str, path: Path) -> Operand:
    operand = refusing(str(path), lambda: _core.read_file(str(path)))
    warnings = list(_core.warnings())
    refusing(str(path), lambda: operand.validate(str(path)))
    return Operand(name, str(path), operand, warnings)
